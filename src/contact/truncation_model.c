/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/truncation_model.h"

#include "contact/cmy.h"
#include <math.h>

double truncation_model_sigma(const struct model_task *task)
{
    return sqrt(spectrum_moment(task->spectrum, 0));
}

double truncation_model_slope(const struct model_task *task)
{
    return truncation_slope(spectrum_moment(task->spectrum, 1));
}

double truncation_model_ratio(const struct truncation *law, const struct model_task *task, double load)
{
    return load * (task->pair->effective_modulus_Pa / law->hardness_Pa);
}

bool truncation_model_tested(const struct truncation_model *model, double pressure_over_hardness)
{
    return pressure_over_hardness >= model->least && pressure_over_hardness <= model->most;
}

/** The law of a surface that has one: with a slope, and a hardness that is known. */
static bool law_of(struct truncation *out, const struct model_row *row, const struct model_task *task)
{
    *out = row->truncation_model->law(task);
    return out->sigma_m > 0 && out->slope > 0 && out->hardness_Pa > 0 && out->fraction > 0;
}

enum status_code truncation_model_run(struct model_curve *curve, const struct model_row *row,
                                      const struct model_task *task, struct status *status)
{
    struct truncation law;
    struct truncation_contact contact;
    (void)status;
    curve->evaluations = task->load_count;
    bool has_law = law_of(&law, row, task), gap = task->wanted & QUANTITY_BIT(QUANTITY_SEPARATION);
    for (size_t i = 0; i < task->load_count && has_law; i++) {
        if (!truncation_press(&contact, &law, truncation_model_ratio(&law, task, task->loads[i])))
            break; /* all of the surface is truncated, there and beyond */
        double spread_m = truncation_resistance(&law, &contact, 1);
        struct contact_point *point = &curve->points[curve->count++];
        *point = quantity_nothing();
        point->value[QUANTITY_LOAD] = task->loads[i];
        point->value[QUANTITY_AREA] = contact.area_ratio;
        if (gap && contact.separation_over_sigma >= 0)
            point->value[QUANTITY_SEPARATION] = contact.separation_over_sigma * law.sigma_m;
        if (task->wanted & QUANTITY_BIT(QUANTITY_ECR))
            point->value[QUANTITY_ECR] = task->pair->resistivity_ohm_m * spread_m;
        if (task->wanted & QUANTITY_BIT(QUANTITY_TCR))
            point->value[QUANTITY_TCR] = spread_m / task->pair->conductivity_W_per_mK;
    }
    curve->exists = curve->count > 0;
    return STATUS_OK;
}

enum status_code truncation_model_spots(struct contact_spots *spots, const struct model_row *row,
                                        const struct model_task *task, struct status *status)
{
    struct truncation law;
    struct truncation_contact contact;
    bool exists = law_of(&law, row, task);
    (void)status;
    for (size_t i = 0; i < task->load_count; i++) {
        bool pressed = exists && truncation_press(&contact, &law, truncation_model_ratio(&law, task, task->loads[i]));
        spots[i].density_per_m2 = pressed ? contact.spot_density_per_m2 : NAN;
        spots[i].radius_m = pressed ? contact.spot_radius_m : NAN;
    }
    return STATUS_OK;
}

static struct truncation elastic_law(const struct model_task *task)
{
    return cmy_elastic(truncation_model_sigma(task), truncation_model_slope(task), task->pair->effective_modulus_Pa);
}

static double elastic_correlation(double pressure_over_hardness, const struct model_task *task)
{
    (void)task;
    return cmy_elastic_correlation(pressure_over_hardness);
}

const struct truncation_model truncation_model_elastic = {
    .label = "Mikic, elastic",
    .hardness = "E′m/√2",
    .law = elastic_law,
    .formula = "1.55 (√2 P/(E′m))^0.94",
    .correlation = elastic_correlation,
    .least = 3.5e-6,
    .most = 0.2,
    .agreement = "within 2.7 %",
};
