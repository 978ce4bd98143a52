#include "analysis/effect_bounds.h"

#include "contact/gaussian.h"
#include "contact/multiscale.h"
#include "contact/statistical.h"
#include <math.h>
#include <stdio.h>

static void bound_yield(struct surface_record *record, const struct plan *plan, double highest_load)
{
    struct effect_bounds *bound = &record->summary.bound;
    double modulus = plan->pair.effective_modulus_Pa, pressure_Pa = highest_load * modulus;
    for (size_t i = 0; i < record->spectrum.count; i++) {
        struct sinusoid_scale scale = sinusoid_scale(record->spectrum.amplitude_m[i],
                                                     spectrum_frequency(&record->spectrum, i), &plan->pair, true);
        if (isfinite(scale.critical_pressure_Pa)) {
            bound->above_critical++;
            bound->yield = fmax(bound->yield, fmin(pressure_Pa, scale.full_pressure_Pa) / scale.critical_pressure_Pa);
        }
        pressure_Pa = fmax(pressure_Pa, scale.full_pressure_Pa);
    }
}

/** Smallest mean contact radius of any scale at the lowest load, from p >= P and the area's rising with p. */
static void bound_multiscale_size(struct surface_record *record, const struct plan *plan, const struct scene *scene,
                                  double lowest_load)
{
    struct effect_bounds *bound = &record->summary.bound;
    double knudsen_m = constriction_make(&plan->pair).knudsen_length_m;
    double pressure_Pa = lowest_load * plan->pair.effective_modulus_Pa;
    for (size_t i = 0; i < record->spectrum.count; i++) {
        double frequency = spectrum_frequency(&record->spectrum, i);
        struct sinusoid_scale scale =
            sinusoid_scale(record->spectrum.amplitude_m[i], frequency, &plan->pair, plan_runs(plan, EFFECT_PLASTICITY));
        struct sinusoid_cell cell;
        sinusoid_press(&cell, &scale, &sinusoid_fits[scene->closure], pressure_Pa, false);
        if (cell.area_complement > 0)
            bound->scale_dependent =
                fmax(bound->scale_dependent, knudsen_m * frequency / sqrt(cell.area_ratio / (2 * M_PI)));
    }
}

/** d/sigma_s of the elastic statistical model at a load, or its full contact beyond it. */
static double elastic_d(const struct surface_record *record, const struct plan *plan, double tolerance, double load)
{
    struct statistical model;
    struct status status = {0};
    uint64_t none = 0;
    double d = 3;
    if (statistical_make(&model, &record->summary.asperities, &plan->pair, ASPERITY_HERTZ, 0, tolerance, INFINITY,
                         &none, &status) != STATUS_OK)
        return NAN; /* closed forms allocate nothing, so this does not happen */
    struct contact_point point;
    if (!statistical_solve(&point, &model, load, &d))
        d = model.full_d;
    statistical_free(&model);
    return d;
}

static void bound_statistical(struct surface_record *record, const struct scene *scene, const struct plan *plan,
                              double lowest_load, double highest_load)
{
    struct effect_bounds *bound = &record->summary.bound;
    const struct asperities *surface = &record->summary.asperities;
    double sigma_s_m = surface->sigma_s_m;
    if (plan_runs(plan, EFFECT_PLASTICITY)) {
        struct asperity asperity = asperity_make(surface->radius_m, &plan->pair, ASPERITY_JG);
        double d = elastic_d(record, plan, scene->tolerance, highest_load);
        double onset = asperity_yield_onset * asperity.critical_interference_m / sigma_s_m;
        struct gaussian_integrals all = gaussian_integrals(d), beyond = gaussian_integrals(d + onset);
        /* int_onset u phi(u + d) du over the whole; asperities ten standard deviations up could gain (10/onset)^B */
        double share = (beyond.one + onset * beyond.zero) / all.one * exp(beyond.log_factor - all.log_factor);
        bound->jg_excess = share * pow(fmax(1, (10 + fmax(0, -d)) / onset), asperity.area_exponent);
    }
    if (plan_runs(plan, EFFECT_SCALE_DEPENDENT)) {
        /* int a K/(a + K) phi <= K F_0, over int a phi = sqrt(R sigma_s) F_1/2 */
        struct gaussian_integrals f = gaussian_integrals(elastic_d(record, plan, scene->tolerance, lowest_load));
        double least =
            constriction_make(&plan->pair).knudsen_length_m * f.zero / (sqrt(surface->radius_m * sigma_s_m) * f.half);
        bound->scale_dependent = fmax(bound->scale_dependent, least);
    }
}

static bool is_converged(const struct surface_summary *summary, const struct scene *scene, const struct plan *plan)
{
    const struct power_law *law = &summary->power_law;
    if (!(law->gamma >= 1))
        return false;
    double limit_m = 2 * summary->spacing_m, modulus = plan->pair.effective_modulus_Pa;
    double full_Pa = sinusoid_full_pressure(power_law_amplitude(law, limit_m), 1 / limit_m, modulus);
    return scene->convergence.load * modulus >= full_Pa;
}

/** What the scans run alone will take in each model, without and with scale dependence. */
static void count_repeats(struct surface_record *record, const struct scene *scene, const struct plan *plan,
                          const double *loads, size_t load_count)
{
    struct model_task task = surface_task(record, scene, plan, loads, load_count);
    for (size_t m = 0; m < model_count && record->repeat_count > 0; m++)
        for (int scale_dependent = 0; scale_dependent < 2 && plan_runs_model(plan, m); scale_dependent++) {
            const unsigned bit = QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT);
            task.wanted = scale_dependent ? plan->wanted : plan->wanted & ~bit;
            record->summary.models[m].repeats_work[scale_dependent] =
                repeats_work(record->repeats, record->repeat_count, model_rows[m], &task);
        }
}

void effect_bounds_surface(struct surface_record *record, const struct scene *scene, const struct plan *plan,
                           const double *loads, size_t load_count)
{
    struct surface_summary *summary = &record->summary;
    double lowest = loads[0], highest = loads[load_count - 1];
    if (plan_stacks_scales(plan) && plan_runs(plan, EFFECT_PLASTICITY))
        bound_yield(record, plan, highest);
    if (plan_stacks_scales(plan) && plan_runs(plan, EFFECT_SCALE_DEPENDENT))
        bound_multiscale_size(record, plan, scene, lowest);
    if (plan_uses_asperities(plan) && summary->has_asperities)
        bound_statistical(record, scene, plan, lowest, highest);
    count_repeats(record, scene, plan, loads, load_count);
    summary->bound.converged = is_converged(summary, scene, plan);
}

static void decide_plasticity(struct plan *plan, double yield, double excess, size_t above, double tolerance)
{
    char *reason = plan->effects[EFFECT_PLASTICITY].reason;
    size_t size = sizeof plan->effects[EFFECT_PLASTICITY].reason;
    if (yield > 1) {
        snprintf(reason, size, "%zu scales have Δ > Δc, and pressure can reach %.3g pc", above, yield);
    } else if (excess > tolerance) {
        snprintf(reason, size, "asperities beyond 1.9 ωc can change the area by up to %.2g", excess);
    } else if (above > 0) {
        snprintf(reason, size, "no load reaches pc of a scale (at most %.2g of it) or moves JG from GW by over %.1g",
                 yield, tolerance);
        plan_switch_off(plan, EFFECT_PLASTICITY);
    } else {
        snprintf(reason, size, "Δ ≤ Δc at every scale, and JG stays within %.2g of GW", excess);
        plan_switch_off(plan, EFFECT_PLASTICITY);
    }
}

static void decide_scale_dependence(struct plan *plan, double most, double tolerance)
{
    char *reason = plan->effects[EFFECT_SCALE_DEPENDENT].reason;
    size_t size = sizeof plan->effects[EFFECT_SCALE_DEPENDENT].reason;
    if (most > tolerance) {
        snprintf(reason, size, "(8/3π) λmfp/a can raise TCR by up to %.2g", most);
    } else {
        snprintf(reason, size, "(8/3π) λmfp/a raises TCR by at most %.2g, below the tolerance", most);
        plan_switch_off(plan, EFFECT_SCALE_DEPENDENT);
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

void effect_bounds_plan(struct plan *plan, const struct scene *scene, const struct surface_summary *surfaces,
                        size_t count)
{
    double yield = 0, excess = 0, scale_dependent = 0;
    size_t above = 0, settled = 0, usable = 0;
    if (!scene->effects_auto)
        return;
    for (size_t i = 0; i < count; i++) {
        const struct effect_bounds *bound = &surfaces[i].bound;
        if (!surfaces[i].usable)
            continue;
        usable++;
        yield = fmax(yield, bound->yield);
        excess = fmax(excess, bound->jg_excess);
        above += bound->above_critical;
        scale_dependent = fmax(scale_dependent, bound->scale_dependent);
        settled += bound->converged;
    }
    if (plan_runs(plan, EFFECT_PLASTICITY))
        decide_plasticity(plan, yield, excess, above, scene->tolerance);
    if (plan_runs(plan, EFFECT_SCALE_DEPENDENT))
        decide_scale_dependence(plan, scale_dependent, scene->tolerance);
    if (plan_runs(plan, EFFECT_CONVERGENCE))
        decide_convergence(plan, settled, usable);
}
