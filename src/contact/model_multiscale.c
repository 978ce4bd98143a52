/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The thesis's multiscale models: every harmonic of the spectrum is a scale of the stack (thesis 4.1, 4.2, 4.11). */
#include "contact/multiscale.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/** The first drop of |d ln R/d ln P| behind point `from`, as two points it lies between; false: none. The other curves
 * get ever steeper. */
static bool find_kink(size_t *low, size_t *high, const struct model_curve *curve, size_t from, enum quantity resistance)
{
    static const double fall = 1.25; /* by at least this factor, before it rises again */
    double steepest = 0, before = 0;
    size_t at = from;
    for (size_t i = from; i + 1 < curve->count; i++) {
        double r = curve->points[i].value[resistance];
        double next = (curve->points[i + 1]).value[resistance];
        if (!(r > 0) || !(next > 0))
            return false;
        double slope =
            -log(next / r) / log(curve->points[i + 1].value[QUANTITY_LOAD] / curve->points[i].value[QUANTITY_LOAD]);
        if (slope >= before) { /* rising: where it fell enough before, that was a kink */
            if (steepest > fall * before && before > 0) {
                *low = at;
                *high = i + 1;
                return true;
            }
            steepest = slope;
            at = i;
        }
        before = slope;
    }
    return false;
}

static void keep_kinks(struct model_curve *curve, struct multiscale *stack, unsigned wanted)
{
    enum quantity resistance = wanted & QUANTITY_BIT(QUANTITY_ECR) ? QUANTITY_ECR : QUANTITY_TCR;
    size_t low, high;
    for (size_t from = 0; find_kink(&low, &high, curve, from, resistance) && curve->kink_count < MODEL_KINKS_MOST;
         from = high)
        curve->kink_count +=
            multiscale_closing(&curve->kinks[curve->kink_count], stack, curve->points[low].value[QUANTITY_LOAD],
                               curve->points[high].value[QUANTITY_LOAD]);
}

static enum status_code run(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                            struct status *status)
{
    struct multiscale stack;
    struct constriction constriction = constriction_make(task->pair);
    if (multiscale_make(&stack, task->spectrum, task->pair, row->plastic, task->sinusoid_fit, status) != STATUS_OK)
        return status->code;
    for (size_t i = 0; i < task->load_count; i++)
        curve->clamped += multiscale_solve(&curve->points[i], &stack, &constriction, task->wanted, task->loads[i],
                                           &curve->evaluations);
    multiscale_solve(&curve->full, &stack, &constriction, task->wanted, stack.full_load, &curve->evaluations);
    curve->count = task->load_count;
    curve->full_load = stack.full_load;
    curve->closed_load = stack.closed_load;
    curve->yielding_scales = stack.critical_scales;
    curve->exists = true;
    if (task->wanted & (QUANTITY_BIT(QUANTITY_ECR) | QUANTITY_BIT(QUANTITY_TCR)))
        keep_kinks(curve, &stack, task->wanted);
    multiscale_free(&stack);
    return STATUS_OK;
}

enum {
    COMPUTES = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_SEPARATION) |
               QUANTITY_BIT(QUANTITY_STIFFNESS) | QUANTITY_RESISTANCES
};

const struct model_row model_multiscale_elastic = {
    .name = "multiscale-elastic",
    .label = "multiscale elastic",
    .short_label = "MS el.",
    .family = "multiscale",
    .by_default = true,
    .stacks_scales = true,
    .quantities = COMPUTES,
    .stiffness_step = MODEL_STIFFNESS_STEP,
    .precedence = 3,
    .thesis_place = 2,
    .in_findings = true,
    .style = "me",
    .colour = "#3F9BE0",
    .marker = 6,
    .equations = "4.1-4.11, 4.40-4.42",
    .source = "Jackson and Streator, Wear 261 (2006) 1337; Johnson, Greenwood and Higginson, Int. "
              "J. Mech. Sci. 27 (1985) 383; "
              "Wilson, Auburn University (2008)",
    .assumes = "every harmonic is a scale of sinusoids on top of the longer ones; all asperities of "
               "a scale carry the same load; "
               "no yield",
    .valid = "any area ratio; needs a spectrum that converges (gamma >= 1)",
    .method = "direct sum over scales",
    .run = run,
};

const struct model_row model_multiscale_plastic = {
    .name = "multiscale-plastic",
    .label = "multiscale elastic-plastic",
    .short_label = "MS pl.",
    .family = "multiscale",
    .by_default = true,
    .plastic = true,
    .elastic = &model_multiscale_elastic,
    .stacks_scales = true,
    .quantities = COMPUTES,
    .stiffness_step = MODEL_STIFFNESS_STEP,
    .precedence = 4,
    .thesis_place = 1,
    .in_findings = true,
    .style = "mp",
    .colour = "#1560B4",
    .marker = 7,
    .equations = "4.12-4.18, 4.40-4.42",
    .source =
        "Krithivasan and Jackson, Tribol. Lett. 27 (2007) 31; Jackson, Krithivasan and Wilson, Proc. IMechE J 222 "
        "(2008) 1; Wilson, Auburn University (2008)",
    .assumes = "as multiscale elastic, with yield of every scale above its critical amplitude; no hardening",
    .valid = "any area ratio; the area steps up by up to 8 % where a scale begins to yield",
    .method = "direct sum over scales",
    .run = run,
};
