/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The textbook model of Cooper, Mikic and Yovanovich: plastic contact by truncation. */
#include "contact/cmy.h"
#include "contact/model.h"

#include <math.h>

/** Sigma and slope of a task; false: no slope, or no hardness. */
static bool surface_of(struct cmy *out, const struct model_task *task)
{
    *out = task->rough;
    if (out->sigma_m == 0)
        *out = (struct cmy){sqrt(spectrum_moment(task->spectrum, 0)), cmy_slope(spectrum_moment(task->spectrum, 1))};
    return out->sigma_m > 0 && out->slope > 0 && task->hardness_Pa > 0;
}

/* With the one hardness given, or with that of the size of the spots. If the task raises the hardness (sensitivity),
 * both rise. */
static double pressure_over_hardness(const struct cmy *surface, const struct model_task *task, size_t i)
{
    const struct material_pair *pair = task->pair;
    double hardness_Pa = task->hardness_Pa;
    if (pair->vickers_Pa > 0)
        hardness_Pa = cmy_microhardness(surface, material_pair_pressure(pair, task->loads[i]),
                                        pair->vickers_Pa * (hardness_Pa / pair->hardness_Pa), pair->vickers_exponent);
    return task->loads[i] * (pair->effective_modulus_Pa / hardness_Pa);
}

/* The curve ends at P = H, without a point of full contact. Where the flat lies below the mean plane there is no gap:
 * the separation is NaN. */
static enum status_code run(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                            struct status *status)
{
    struct cmy surface;
    struct cmy_contact contact;
    (void)status;
    curve->evaluations = task->load_count;
    bool has_law = surface_of(&surface, task);
    for (size_t i = 0; i < task->load_count && has_law; i++) {
        double area_ratio = pressure_over_hardness(&surface, task, i);
        if (!cmy_press(&contact, &surface, area_ratio))
            break;
        double l = contact.separation_over_sigma, spread_m = surface.sigma_m / surface.slope / contact.conductance;
        const struct transfer_point point = {task->loads[i], area_ratio, l >= 0 ? l * surface.sigma_m : NAN,
                                             spread_m / 2};
        curve->points[curve->count++] = model_point(&point, row, task);
    }
    curve->exists = curve->count > 0;
    return STATUS_OK;
}

static enum status_code spots_of(struct contact_spots *spots, const struct model_row *row,
                                 const struct model_task *task, struct status *status)
{
    struct cmy surface;
    struct cmy_contact contact;
    bool exists = surface_of(&surface, task);
    (void)row;
    (void)status;
    for (size_t i = 0; i < task->load_count; i++) {
        bool pressed = exists && cmy_press(&contact, &surface, pressure_over_hardness(&surface, task, i));
        spots[i].density_per_m2 = pressed ? contact.spot_density_per_m2 : NAN;
        spots[i].radius_m = pressed ? contact.spot_radius_m : NAN;
    }
    return STATUS_OK;
}

const struct model_row model_cmy = {
    .name = "cmy",
    .label = "CMY",
    .family = "cmy",
    .plastic = true,
    .quantities = QUANTITY_USUAL,
    .stiffness_step = MODEL_STIFFNESS_STEP,
    .textbook = true,
    .may_be_empty = QUANTITY_BIT(QUANTITY_SEPARATION),
    .largest_area = CMY_VALID_AREA,
    .colour = "#8C6D31",
    .marker = 15,
    .does = "cuts the heights off at a plane and lets every spot bear the hardness",
    .equations = "p/H = A/Aₙ = ½ erfc(l/√2), ECR·Aₙ = 2√(2π) (ρσ/m) exp(l²/2) (1−√(A/Aₙ))^(3/2), gap = σl (truncation)",
    .source = "Cooper, Mikic and Yovanovich, Int. J. Heat Mass Transf. 12 (1969) 279",
    .assumes = "isotropic Gaussian surface, of which all that is truncated touches; every spot bears the hardness (the "
               "scene's, by Vickers's c1 and c2 that of its own size, else 2.84 S_y); round spots",
    .valid = "Gaussian heights, first loading, P/H up to 0.1: beyond, islands run together; it ends at P = H. From ten "
             "spots on, resistance 0.6 to 1.1 of direct solutions of the same islands, which are neither round nor "
             "evenly spread",
    .method = "closed form",
    .run = run,
    .spots = spots_of,
};
