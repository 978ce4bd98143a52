/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The thesis's multiscale models: every harmonic of the spectrum is a scale of the stack (thesis 4.1, 4.2, 4.11). */
#include "contact/multiscale.h"

#include <math.h>

/** Finds the first drop of |d ln R/d ln P| by at least a quarter; curves without a kink only get steeper. */
static void find_kink(struct model_curve *curve, struct multiscale *stack, enum quantity resistance)
{
    static const double fall = 1.25;
    double steepest = 0, before = 0, from = 0;
    for (size_t i = 0; i + 1 < curve->count; i++) {
        const double *here = curve->points[i].value, *next = curve->points[i + 1].value;
        if (!(here[resistance] > 0 && next[resistance] > 0))
            return;
        double slope = -log(next[resistance] / here[resistance]) / log(next[QUANTITY_LOAD] / here[QUANTITY_LOAD]);
        if (slope >= before) { /* rises again: was the drop before it large enough? */
            if (steepest > fall * before && before > 0 &&
                multiscale_closing(&curve->kink, stack, from, next[QUANTITY_LOAD]))
                return;
            steepest = slope;
            from = here[QUANTITY_LOAD];
        }
        before = slope;
    }
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
    curve->exists = true;
    if (task->wanted & (QUANTITY_BIT(QUANTITY_ECR) | QUANTITY_BIT(QUANTITY_TCR)))
        find_kink(curve, &stack, task->wanted & QUANTITY_BIT(QUANTITY_ECR) ? QUANTITY_ECR : QUANTITY_TCR);
    multiscale_free(&stack);
    return STATUS_OK;
}

enum { COMPUTES = QUANTITY_USUAL | QUANTITY_RESISTANCES | QUANTITY_BIT(QUANTITY_ECR_LAST_SCALE) };

const struct model_row model_multiscale_elastic = {
    .name = "multiscale-elastic",
    .label = "multiscale elastic",
    .family = "multiscale",
    .stacks_scales = true,
    .quantities = COMPUTES,
    .stiffness_step = MODEL_STIFFNESS_STEP,
    .precedence = 3,
    .thesis_place = 2,
    .in_findings = true,
    .colour = "#3F9BE0",
    .marker = 6,
    .does = "stacks all waves of the spectrum as sinusoids, the short on the long, without yield",
    .equations = "A/Aₙ = Π aᵢ, aᵢ of one sinusoid under the pressure P/Aᵢ₋₁; gap = Σ ΔᵢGᵢ; ECR = Σ Ψᵢρ/(2rᵢnᵢ), nᵢ = "
                 "2fᵢ²Aᵢ₋₁ (4.1-4.11, 4.40-4.42)",
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
    .family = "multiscale",
    .plastic = true,
    .elastic = &model_multiscale_elastic,
    .stacks_scales = true,
    .quantities = COMPUTES,
    .stiffness_step = MODEL_STIFFNESS_STEP,
    .precedence = 4,
    .thesis_place = 1,
    .in_findings = true,
    .colour = "#1560B4",
    .marker = 7,
    .does = "stacks all waves of the spectrum as sinusoids, the short on the long, and lets them yield",
    .equations = "as multiscale elastic, where waves of Δ above √2 S_y exp(2ν/3)/(3πE′f) yield (4.12-4.18, 4.40-4.42)",
    .source =
        "Krithivasan and Jackson, Tribol. Lett. 27 (2007) 31; Jackson, Krithivasan and Wilson, Proc. IMechE J 222 "
        "(2008) 1; Wilson, Auburn University (2008)",
    .assumes = "as multiscale elastic, with yield of every scale above its critical amplitude; no hardening",
    .valid = "P below H; the area steps up by up to 8 % where a scale begins to yield",
    .method = "direct sum over scales",
    .run = run,
};
