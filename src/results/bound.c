#include "results/bound.h"

#include "contact/gaussian.h"
#include "contact/multiscale.h"
#include "contact/statistical.h"
#include "results/spool.h"
#include <assert.h>
#include <math.h>
#include <stdio.h>

/** Keeps the lowest p_c/p* of the scales of largest slope Delta f. */
static void steepest_yield(struct surface_bound *bound, double amplitude_m, double frequency_per_m,
                           const struct material_pair *pair)
{
    struct sinusoid_scale scale = sinusoid_scale(amplitude_m, frequency_per_m, pair, true);
    bound->yield = fmin(bound->yield, scale.critical_pressure_Pa / scale.full_pressure_Pa);
}

static void steepest_harmonic(struct surface_bound *bound, const struct spectrum *spectrum,
                              const struct material_pair *pair)
{
    size_t steepest = 0;
    for (size_t i = 1; i < spectrum->count; i++)
        if (spectrum->amplitude_m[i] * spectrum_frequency(spectrum, i) >
            spectrum->amplitude_m[steepest] * spectrum_frequency(spectrum, steepest))
            steepest = i;
    if (spectrum->count > 0)
        steepest_yield(bound, spectrum->amplitude_m[steepest], spectrum_frequency(spectrum, steepest), pair);
}

/** p_c/p* falls with the slope Delta f alone, so that the steepest harmonic answers for all: the measured ones, those
 * of the scans run alone, and those of the fitted law where that is carried on below the sampling limit. */
static void bound_yield(struct surface_record *record, const struct scene *scene, const struct plan *plan)
{
    const struct surface_summary *summary = &record->summary;
    struct surface_bound *bound = &record->summary.bound;
    steepest_harmonic(bound, &record->spectrum, &plan->pair);
    for (size_t p = 0; p < record->part_count; p++)
        steepest_harmonic(bound, &record->parts[p].spectrum, &plan->pair);
    if (plan_runs(plan, EFFECT_CONVERGENCE) && surface_extends(summary, scene)) {
        double ends_m[2] = {summary->length_m, convergence_atom_m};
        for (int i = 0; i < 2; i++)
            if (i == 0 || summary->law.gamma < 1)
                steepest_yield(bound, powerlaw_amplitude(&summary->law, ends_m[i]), 1 / ends_m[i], &plan->pair);
    }
}

/** What bounding the scale dependence of one stack takes along. */
struct stack_study {
    struct multiscale stack;
    struct spot spot;
    const double *loads;
    double tolerance;
    uint64_t visits;
};

static double raise(const struct contact_point *point)
{
    return point->tcr_K_m2_per_W > 0 ? point->tcr_sd_K_m2_per_W / point->tcr_K_m2_per_W - 1 : 0;
}

static double raise_at(struct contact_point *point, struct stack_study *study, size_t load)
{
    multiscale_solve(point, &study->stack, &study->spot, CONTACT_THERMAL | CONTACT_SCALE_DEPENDENT, study->loads[load],
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
    if (high - low < 2 || !(at_low->tcr_K_m2_per_W > 0))
        return 0;
    double added = at_low->tcr_sd_K_m2_per_W - at_low->tcr_K_m2_per_W;
    if (slack * added <= study->tolerance * at_high->tcr_K_m2_per_W)
        return slack * added / at_high->tcr_K_m2_per_W;
    struct contact_point at_middle;
    size_t middle = low + (high - low) / 2;
    double most = raise_at(&at_middle, study, middle);
    if (most <= study->tolerance)
        most = fmax(most, bound_between(study, low, at_low, middle, &at_middle));
    if (most <= study->tolerance)
        most = fmax(most, bound_between(study, middle, &at_middle, high, at_high));
    return most;
}

static enum status_code bound_stack(struct surface_record *record, const struct scene *scene, const struct plan *plan,
                                    bool plastic, const double *loads, size_t load_count, struct status *status)
{
    struct surface_bound *bound = &record->summary.bound;
    struct stack_study study = {.spot = spot_make(&plan->pair), .loads = loads, .tolerance = scene->tolerance};
    if (multiscale_make(&study.stack, &record->spectrum, &plan->pair, plastic, scene->closure, status) != STATUS_OK)
        return status->code;
    struct contact_point first, last;
    double most = raise_at(&first, &study, 0);
    if (most <= study.tolerance && load_count > 1)
        most = fmax(most, raise_at(&last, &study, load_count - 1));
    if (most <= study.tolerance)
        most = fmax(most, bound_between(&study, 0, &first, load_count - 1, &last));
    bound->scale_dependent = fmax(bound->scale_dependent, most);
    bound->visits += study.visits;
    multiscale_free(&study.stack);
    return STATUS_OK;
}

/** The largest relative change of a number of the statistical models (of a separation: over sigma) that JG can make,
 * from the asperities beyond its yield at GW's full contact, where they are most.
 *  - load: JG's is between 0 and 1.08 times Hertz's. u^(3/2) <= sqrt2 (v^(3/2) + y^(3/2)) for u = y + v, y the yield.
 *  - area and radius: JG's grow by at most (u/y)^B <= exp(B v/y), which only shifts the Gaussian.
 * At a given load, or at full contact, d moves by the change over the slope of its logarithm; the resistance takes the
 * slope of Psi at `area`, the largest A/A_n short of full contact. */
static double jg_excess(const struct asperities *surface, const struct plan *plan, double full_d, double area)
{
    static const double highest_d = 40; /* exp(-d²/2) is below the smallest double */
    struct asperity asperity = asperity_make(surface->radius_m, &plan->pair, ASPERITY_JG);
    double yield = asperity_yield_onset * asperity.critical_interference_m / surface->sigma_s_m;
    if (full_d + yield > highest_d)
        return 0;
    double shift = asperity.area_exponent / yield;
    struct gaussian_integrals all = gaussian_integrals(full_d), beyond = gaussian_integrals(full_d + yield),
                              grown = gaussian_integrals(full_d + yield - shift);
    double load = M_SQRT2 * (beyond.three_halves + yield * sqrt(yield) * beyond.zero) / all.three_halves *
                  exp(beyond.log_factor - all.log_factor);
    double more = (grown.one + yield * grown.zero) / all.one *
                  exp(shift * (shift / 2 - full_d - yield) + grown.log_factor - all.log_factor);
    double change = isnan(more) ? INFINITY : 1.5 * more + load;
    double sigma_s = surface->sigma_s_m / surface->sigma_m;
    if (plan_runs(plan, EFFECT_SEPARATION)) /* beta is twice a separation */
        change =
            fmax(change, 2 * sigma_s * fmax(more * all.one / all.zero, load * all.three_halves / (1.5 * all.half)));
    if (plan->wanted & (CONTACT_ELECTRICAL | CONTACT_THERMAL)) /* d ln Psi/d ln A = -(3/4) sqrt(A)/(1 - sqrt(A)) */
        change = fmax(change, more + 2 * load + 0.75 * sqrt(area) / (1 - sqrt(area)) * (more + load));
    return change;
}

/** K F_0 over sqrt(R sigma_s) F_1/2 at the lowest load: K over the mean radius of GW. TCR_sd/TCR - 1 is
 * K E[g]/E[a g] with g = a/(a + K), which rises with a, so at most that; as does the mean of g with the load, since a
 * lower d weights larger spots. JG's spots are no smaller than GW's where they carry the same load or less. */
static double statistical_raise(const struct asperities *surface, const struct plan *plan, double d)
{
    struct gaussian_integrals f = gaussian_integrals(d);
    return spot_make(&plan->pair).knudsen_length_m * f.zero / (sqrt(surface->radius_m * surface->sigma_s_m) * f.half);
}

/** GW, in closed forms. */
static struct statistical closed_gw(const struct asperities *surface, const struct plan *plan)
{
    struct statistical model;
    struct status status = {0};
    uint64_t none = 0;
    enum status_code rc =
        statistical_make(&model, surface, &plan->pair, ASPERITY_HERTZ, 0, 1, INFINITY, &none, &status);
    assert(rc == STATUS_OK && none == 0); /* no quadrature, so nothing is allocated */
    (void)rc;
    return model;
}

static void bound_statistical_size(struct surface_record *record, const struct plan *plan, double lowest_load)
{
    static const double jg_load_most = 1.08; /* JG's load over Hertz's, at 1.9 omega_c for nu = 0 */
    struct statistical model = closed_gw(&record->summary.asperities, plan);
    struct contact_point point;
    double d = 3, load = plan_runs(plan, EFFECT_PLASTICITY) ? lowest_load / jg_load_most : lowest_load;
    if (statistical_solve(&point, &model, load, &d))
        record->summary.bound.scale_dependent =
            fmax(record->summary.bound.scale_dependent, statistical_raise(&model.surface, plan, d));
}

static void bound_jg(struct surface_bound *bound, const struct asperities *surface, const struct plan *plan,
                     const double *loads, size_t load_count)
{
    struct statistical model = closed_gw(surface, plan);
    struct contact_point point = {0};
    double d = 3;
    while (load_count > 0 && !statistical_solve(&point, &model, loads[load_count - 1], &d))
        load_count--;
    bound->jg_excess = fmax(bound->jg_excess, jg_excess(surface, plan, model.full_d, point.area_ratio));
}

static void bound_statistical(struct surface_record *record, const struct plan *plan, const double *loads,
                              size_t load_count)
{
    struct surface_summary *summary = &record->summary;
    struct asperities asperities;
    struct status none = {0};
    if (plan_runs(plan, EFFECT_SCALE_DEPENDENT) && summary->has_asperities)
        bound_statistical_size(record, plan, loads[0]);
    if (!plan_runs(plan, EFFECT_PLASTICITY))
        return;
    if (summary->has_asperities)
        bound_jg(&summary->bound, &summary->asperities, plan, loads, load_count);
    for (size_t p = 0; p < record->part_count; p++)
        if (roughness_asperities(&asperities, &record->parts[p].roughness, &none) == STATUS_OK)
            bound_jg(&summary->bound, &asperities, plan, loads, load_count);
}

static bool is_settled(const struct surface_summary *summary, const struct scene *scene, const struct plan *plan)
{
    const struct powerlaw *law = &summary->law;
    if (!(law->gamma >= 1))
        return false;
    double limit_m = 2 * summary->spacing_m, modulus = plan->pair.effective_modulus_Pa;
    double full_Pa = sinusoid_full_pressure(powerlaw_amplitude(law, limit_m), 1 / limit_m, modulus);
    return scene->convergence.load * modulus >= full_Pa;
}

/** What the scans run alone will take in the statistical models. */
static void count_parts(struct surface_record *record, const struct scene *scene, const struct plan *plan)
{
    struct surface_summary *summary = &record->summary;
    for (size_t p = 0; p < record->part_count; p++) {
        struct asperities asperities;
        struct status none = {0};
        if (roughness_asperities(&asperities, &record->parts[p].roughness, &none) != STATUS_OK)
            continue;
        summary->part_asperities++;
        for (int plastic = 0; plastic < 2; plastic++)
            for (int scale_dependent = 0; scale_dependent < 2; scale_dependent++)
                if (plastic ? plan_runs(plan, EFFECT_PLASTICITY) : true)
                    summary->part_laws[plastic][scale_dependent] += statistical_law_count(
                        &asperities, &plan->pair, plastic ? ASPERITY_JG : ASPERITY_HERTZ,
                        scale_dependent ? plan->wanted : plan->wanted & ~(unsigned)CONTACT_SCALE_DEPENDENT,
                        scene->tolerance);
    }
}

/** Bounds of what `auto` has to decide. */
static enum status_code bound_effects(struct surface_record *record, const struct scene *scene, const struct plan *plan,
                                      const double *loads, size_t load_count, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    enum status_code rc = STATUS_OK;
    summary->bound = (struct surface_bound){.yield = INFINITY, .settled = is_settled(summary, scene, plan)};
    if (plan->families & SCENE_MODEL_MULTISCALE) {
        if (plan_runs(plan, EFFECT_PLASTICITY))
            bound_yield(record, scene, plan);
        /* where nothing yields, the elastic-plastic stack is the elastic one */
        int stacks = summary->bound.yield < 1 ? 2 : 1;
        for (int plastic = 0; plastic < stacks && rc == STATUS_OK; plastic++)
            if (plan_runs(plan, EFFECT_SCALE_DEPENDENT) && summary->bound.scale_dependent <= scene->tolerance)
                rc = bound_stack(record, scene, plan, plastic, loads, load_count, status);
    }
    if (plan->families & SCENE_MODEL_STATISTICAL)
        bound_statistical(record, plan, loads, load_count);
    return rc;
}

enum status_code bound_surface(struct surface_record *record, const struct scene *scene, const struct plan *plan,
                               const double *loads, size_t load_count, struct status *status)
{
    if (plan->families & SCENE_MODEL_STATISTICAL)
        count_parts(record, scene, plan);
    return scene->effects_auto ? bound_effects(record, scene, plan, loads, load_count, status) : STATUS_OK;
}

static void switch_off(struct plan *plan, enum effect effect)
{
    plan->effects[effect].runs = false;
    plan->running &= ~EFFECT_BIT(effect);
    if (effect == EFFECT_SCALE_DEPENDENT)
        plan->wanted &= ~(unsigned)CONTACT_SCALE_DEPENDENT;
}

static void decide_plasticity(struct plan *plan, double yield, double excess, double tolerance)
{
    char *reason = plan->effects[EFFECT_PLASTICITY].reason;
    size_t size = sizeof plan->effects[EFFECT_PLASTICITY].reason;
    if (yield < 1) {
        snprintf(reason, size, "the steepest scale yields at %.3g p*, so that full contact comes sooner", yield);
    } else if (excess > tolerance) {
        snprintf(reason, size, "asperities beyond 1.9 ωc can change a number by %s%.2g, up to full contact",
                 excess > 1 ? "over " : "up to ", fmin(excess, 1));
    } else {
        bool multiscale = plan->families & SCENE_MODEL_MULTISCALE,
             statistical = plan->families & SCENE_MODEL_STATISTICAL;
        int used = snprintf(reason, size, "%s%s", multiscale ? "every scale is complete before it yields" : "",
                            multiscale && statistical ? ", and " : "");
        if (statistical)
            snprintf(reason + used, size - (size_t)used, "JG stays within %.2g of GW up to full contact", excess);
        switch_off(plan, EFFECT_PLASTICITY);
    }
}

static void decide_scale_dependence(struct plan *plan, double most, double tolerance)
{
    char *reason = plan->effects[EFFECT_SCALE_DEPENDENT].reason;
    size_t size = sizeof plan->effects[EFFECT_SCALE_DEPENDENT].reason;
    if (most > tolerance) {
        snprintf(reason, size, "(8/3π) λmfp/a can raise TCR by %.2g", most);
    } else {
        snprintf(reason, size, "(8/3π) λmfp/a raises TCR by at most %.2g, below the tolerance", most);
        switch_off(plan, EFFECT_SCALE_DEPENDENT);
    }
}

static void decide_convergence(struct plan *plan, size_t settled, size_t usable)
{
    char *reason = plan->effects[EFFECT_CONVERGENCE].reason;
    size_t size = sizeof plan->effects[EFFECT_CONVERGENCE].reason;
    if (settled == usable)
        snprintf(reason, size, "sweeps only: no scale below the sampling limit can take area from any surface");
    else
        snprintf(reason, size, "%zu of %zu surfaces may lose area below their sampling limit", usable - settled,
                 usable);
}

void bound_plan(struct plan *plan, const struct scene *scene, const struct spool *spool)
{
    double yield = INFINITY, excess = 0, scale_dependent = 0;
    size_t settled = 0, usable = 0;
    if (!scene->effects_auto)
        return;
    for (size_t i = 0; i < spool->count; i++) {
        const struct surface_bound *bound = &spool->summaries[i].bound;
        if (!spool->summaries[i].usable)
            continue;
        usable++;
        yield = fmin(yield, bound->yield);
        excess = fmax(excess, bound->jg_excess);
        scale_dependent = fmax(scale_dependent, bound->scale_dependent);
        settled += bound->settled;
    }
    if (plan_runs(plan, EFFECT_PLASTICITY))
        decide_plasticity(plan, yield, excess, scene->tolerance);
    if (plan_runs(plan, EFFECT_SCALE_DEPENDENT))
        decide_scale_dependence(plan, scale_dependent, scene->tolerance);
    if (plan_runs(plan, EFFECT_CONVERGENCE))
        decide_convergence(plan, settled, usable);
}
