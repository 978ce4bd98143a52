/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The thesis's multiscale models: every harmonic of the spectrum is a scale of the stack (thesis 4.1, 4.2, 4.11). */
#include "contact/multiscale.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static enum status_code stack_of(struct multiscale *out, const struct model_row *row, const struct model_task *task,
                                 struct status *status)
{
    return multiscale_make(out, task->spectrum, task->pair, row->plastic, task->sinusoid_fit, status);
}

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
    if (stack_of(&stack, row, task, status) != STATUS_OK)
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

/** p_c over p* falls with the slope Delta f alone, so that the steepest harmonic answers for all. Returns the inverse
 * of it for a harmonic that yields before it is complete, which then brings full contact forward; else 0. */
static double yield_bound(const struct model_row *row, const struct model_task *task)
{
    const struct spectrum *spectrum = task->spectrum;
    size_t steepest = 0;
    (void)row;
    for (size_t i = 1; i < spectrum->count; i++)
        if (spectrum->amplitude_m[i] * spectrum_frequency(spectrum, i) >
            spectrum->amplitude_m[steepest] * spectrum_frequency(spectrum, steepest))
            steepest = i;
    if (spectrum->count == 0)
        return 0;
    struct sinusoid_scale scale =
        sinusoid_scale(spectrum->amplitude_m[steepest], spectrum_frequency(spectrum, steepest), task->pair, true);
    double sooner = scale.full_pressure_Pa / scale.critical_pressure_Pa;
    return sooner > 1 ? sooner : 0;
}

static void yield_reason(char *out, size_t size, double bound, bool runs)
{
    if (runs)
        snprintf(out, size, "the steepest scale yields at %.3g p*, so that full contact comes sooner", 1 / bound);
    else
        snprintf(out, size, "every scale is complete before it yields");
}

/** What bounding the scale dependence of one stack takes along. */
struct stack_study {
    struct multiscale stack;
    struct constriction constriction;
    const double *loads;
    double tolerance;
    uint64_t visits;
};

static double raise(const struct contact_point *point)
{
    return point->value[QUANTITY_TCR] > 0 ? point->value[QUANTITY_TCR_SCALE_DEPENDENT] / point->value[QUANTITY_TCR] - 1
                                          : 0;
}

static double raise_at(struct contact_point *point, struct stack_study *study, size_t load)
{
    multiscale_solve(point, &study->stack, &study->constriction,
                     QUANTITY_BIT(QUANTITY_TCR) | QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT), study->loads[load],
                     &study->visits);
    return raise(point);
}

/** Bound on TCR_sd/TCR - 1 at the loads between two solved ones. TCR and what scale dependence adds both fall with the
 * load, so that the added part at the lower over TCR at the upper load bounds it; halved until that is within the
 * tolerance, or one load exceeds it. */
static double bound_between(struct stack_study *study, size_t low, const struct contact_point *at_low, size_t high,
                            const struct contact_point *at_high)
{
    /* yield of a long scale unloads the shorter ones: TCR then rises, by 3 % in the worst of random stacks */
    static const double slack = 1.1;
    if (high - low < 2 || !(at_low->value[QUANTITY_TCR] > 0))
        return 0;
    double added = at_low->value[QUANTITY_TCR_SCALE_DEPENDENT] - at_low->value[QUANTITY_TCR];
    if (slack * added <= study->tolerance * at_high->value[QUANTITY_TCR])
        return slack * added / at_high->value[QUANTITY_TCR];
    struct contact_point at_middle;
    size_t middle = low + (high - low) / 2;
    double most = raise_at(&at_middle, study, middle);
    if (most <= study->tolerance)
        most = fmax(most, bound_between(study, low, at_low, middle, &at_middle));
    if (most <= study->tolerance)
        most = fmax(most, bound_between(study, middle, &at_middle, high, at_high));
    return most;
}

static enum status_code scale_dependence_bound(double *most, const struct model_row *row, const struct model_task *task,
                                               struct status *status)
{
    struct stack_study study = {
        .constriction = constriction_make(task->pair), .loads = task->loads, .tolerance = task->tolerance};
    struct contact_point first, last;
    if (stack_of(&study.stack, row, task, status) != STATUS_OK)
        return status->code;
    *most = raise_at(&first, &study, 0);
    if (*most <= study.tolerance && task->load_count > 1)
        *most = fmax(*most, raise_at(&last, &study, task->load_count - 1));
    if (*most <= study.tolerance)
        *most = fmax(*most, bound_between(&study, 0, &first, task->load_count - 1, &last));
    multiscale_free(&study.stack);
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
    .scale_dependence_bound = scale_dependence_bound,
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
    .yield_bound = yield_bound,
    .yield_reason = yield_reason,
    .scale_dependence_bound = scale_dependence_bound,
};
