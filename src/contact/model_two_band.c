/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The two-band models: the multiscale stack with two scales of equal elastic energy, elastic and with yield limited by
 * the hardness. What the direct solutions do not bear out is left empty. */
#include "contact/two_band.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum {
    COMPUTES = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_SEPARATION) |
               QUANTITY_RESISTANCES
};

/** The stack of the task's surface, empty where that has no amplitude; multiscale_free() it. Error: STATUS_MEMORY. */
static enum status_code make_stack(struct multiscale *out, const struct model_row *row, const struct model_task *task,
                                   struct status *status)
{
    struct two_band bands;
    *out = (struct multiscale){0};
    if (!two_band_split(&bands, task->spectrum))
        return STATUS_OK;
    return two_band_stack(out, &bands, task->pair, row->plastic, row->plastic ? task->hardness_Pa : INFINITY,
                          task->sinusoid_fit, status);
}

/** Takes out what should not be trusted at this point. */
static void blank(struct contact_point *point, const struct model_row *row, const struct model_task *task)
{
    double pressure_Pa = point->value[QUANTITY_LOAD] * task->pair->effective_modulus_Pa;
    if (!two_band_trusted(point->value[QUANTITY_AREA]))
        point->value[QUANTITY_SEPARATION] = point->value[QUANTITY_ECR] = point->value[QUANTITY_TCR] =
            point->value[QUANTITY_TCR_SCALE_DEPENDENT] = NAN;
    if (row->plastic && !two_band_plastic_gap_trusted(point->value[QUANTITY_AREA], pressure_Pa, task->hardness_Pa))
        point->value[QUANTITY_SEPARATION] = NAN;
}

/** Barber's integral in place of the elastic gaps, which light loads know less well. */
static enum status_code elastic_separation(struct model_curve *curve, struct multiscale *stack,
                                           const struct model_task *task, struct status *status)
{
    double *separation_m = malloc(task->load_count * sizeof *separation_m);
    if (!separation_m)
        return status_memory(status);
    two_band_separation(separation_m, task->loads, task->load_count, stack, task->tolerance, &curve->evaluations);
    for (size_t i = 0; i < task->load_count; i++)
        curve->points[i].value[QUANTITY_SEPARATION] = separation_m[i];
    free(separation_m);
    return STATUS_OK;
}

static enum status_code run(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                            struct status *status)
{
    struct multiscale stack;
    struct constriction constriction = constriction_make(task->pair);
    unsigned gap = task->wanted & QUANTITY_BIT(QUANTITY_SEPARATION),
             wanted = row->plastic ? task->wanted : task->wanted & ~gap;
    if (make_stack(&stack, row, task, status) != STATUS_OK || stack.count == 0)
        return status->code;
    for (size_t i = 0; i < task->load_count; i++)
        curve->clamped +=
            multiscale_solve(&curve->points[i], &stack, &constriction, wanted, task->loads[i], &curve->evaluations);
    multiscale_solve(&curve->full, &stack, &constriction, wanted, stack.full_load, &curve->evaluations);
    enum status_code rc = STATUS_OK;
    if (!row->plastic && gap)
        rc = elastic_separation(curve, &stack, task, status);
    for (size_t i = 0; i < task->load_count; i++)
        blank(&curve->points[i], row, task);
    blank(&curve->full, row, task);
    curve->count = task->load_count;
    curve->full_load = stack.full_load;
    curve->yielding_scales = stack.critical_scales;
    curve->exists = true;
    multiscale_free(&stack);
    return rc;
}

/** p_c over p* of the steeper band, inverted, where it yields before it is complete; else 0. */
static double yield_bound(const struct model_row *row, const struct model_task *task)
{
    struct two_band bands;
    double most = 0;
    (void)row;
    bool splits = two_band_split(&bands, task->spectrum);
    for (int b = 0; splits && b < TWO_BAND_COUNT; b++) {
        struct sinusoid_scale scale = sinusoid_scale(bands.amplitude_m[b], bands.frequency_per_m[b], task->pair, true);
        most = fmax(most, scale.full_pressure_Pa / scale.critical_pressure_Pa);
    }
    return most > 1 ? most : 0;
}

static void yield_reason(char *out, size_t size, double bound, bool runs)
{
    if (runs)
        snprintf(out, size, "a band yields at %.3g p*", 1 / bound);
    else
        snprintf(out, size, "neither band yields before it is complete");
}

/** Two scales are quick: every load. */
static enum status_code scale_dependence_bound(double *most, const struct model_row *row, const struct model_task *task,
                                               struct status *status)
{
    struct multiscale stack;
    struct constriction constriction = constriction_make(task->pair);
    uint64_t visits = 0;
    *most = 0;
    if (make_stack(&stack, row, task, status) != STATUS_OK)
        return status->code;
    for (size_t i = 0; stack.count > 0 && i < task->load_count; i++) {
        struct contact_point point;
        multiscale_solve(&point, &stack, &constriction, QUANTITY_RESISTANCES, task->loads[i], &visits);
        if (point.value[QUANTITY_TCR] > 0)
            *most = fmax(*most, point.value[QUANTITY_TCR_SCALE_DEPENDENT] / point.value[QUANTITY_TCR] - 1);
    }
    multiscale_free(&stack);
    return STATUS_OK;
}

const struct model_row model_two_band_elastic = {
    .name = "two-band-elastic",
    .label = "two-band elastic",
    .short_label = "2B el.",
    .family = "two-band",
    .family_title = "Two bands",
    .by_default = true,
    .quantities = COMPUTES,
    .may_be_empty = COMPUTES & ~(QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA)),
    .precedence = 5,
    .style = "te",
    .colour = "#35A27B",
    .marker = 8,
    .equations = "two bands; 4.3-4.11, 4.40-4.42",
    .source =
        "Jackson and Streator, Wear 261 (2006) 1337, with two scales of equal elastic energy; separation: Barber, "
        "Proc. R. Soc. A 459 (2003) 53",
    .assumes = "isotropic Gaussian surface; two scales, each with half of the energy of flattening it; no yield",
    .valid = "area at A/A_n from 0.001 on within a factor 0.5 to 1.3 of direct solutions, separation and resistance up "
             "to A/A_n = 0.75 (empty beyond); not for a single wave",
    .method = "direct sum over two scales; separation by adaptive quadrature",
    .run = run,
    .scale_dependence_bound = scale_dependence_bound,
};

const struct model_row model_two_band_plastic = {
    .name = "two-band-plastic",
    .label = "two-band elastic-plastic",
    .short_label = "2B pl.",
    .family = "two-band",
    .family_title = "Two bands",
    .by_default = true,
    .plastic = true,
    .elastic = &model_two_band_elastic,
    .quantities = COMPUTES,
    .may_be_empty = COMPUTES & ~(QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA)),
    .precedence = 6,
    .style = "tp",
    .colour = "#137A56",
    .marker = 9,
    .equations = "two bands; 4.12-4.18, 4.40-4.42",
    .source = "Krithivasan and Jackson, Tribol. Lett. 27 (2007) 31, with two scales of equal elastic energy and the "
              "contact pressure limited by the hardness",
    .assumes = "as two-band elastic, with yield; a yielding scale carries at most the hardness; no hardening",
    .valid = "area and resistance within a factor 0.56 to 1.31 of direct solutions with the same hardness; separation "
             "up to a quarter of the hardness, both up to A/A_n = 0.75 (empty beyond)",
    .method = "direct sum over two scales",
    .run = run,
    .yield_bound = yield_bound,
    .yield_reason = yield_reason,
    .scale_dependence_bound = scale_dependence_bound,
};
