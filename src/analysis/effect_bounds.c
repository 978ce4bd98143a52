/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/effect_bounds.h"

#include "analysis/work.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/** The shortest wavelength of the spectrum that is known. */
static double shortest_m(const struct surface_record *record)
{
    return record->spectrum.length_m / (double)record->summary.tail.count;
}

/** What yielding can change in plastic model `m`: on the surface, on each of its scans run alone, and on the tail of
 * the spectrum where that is carried on below the sampling limit (its slope is largest at one of its ends). */
static double bound_yield(const struct surface_record *record, const struct scene *scene, const struct plan *plan,
                          size_t m, const struct model_task *task)
{
    const struct model_row *row = model_rows[m];
    const struct surface_summary *summary = &record->summary;
    if (!row->yield_bound)
        return INFINITY;
    double most = row->yield_bound(row, task);
    for (size_t r = 0; r < record->repeats.count; r++) {
        struct asperities asperities;
        struct model_task alone = repeats_task(&asperities, &record->repeats.parts[r], task);
        most = fmax(most, row->yield_bound(row, &alone));
    }
    if (!row->stacks_scales || !plan_runs(plan, EFFECT_CONVERGENCE) || !surface_extends(summary, scene))
        return most;
    double ends_m[2] = {shortest_m(record), convergence_atom_m};
    for (int i = 0; i < (summary->tail.gamma < 1 ? 2 : 1); i++) {
        double amplitude_m = convergence_tail_amplitude(&summary->tail, ends_m[i]);
        struct spectrum end = {.amplitude_m = &amplitude_m, .count = 1, .length_m = ends_m[i]};
        struct model_task extension = *task;
        extension.spectrum = &end;
        most = fmax(most, row->yield_bound(row, &extension));
    }
    return most;
}

static bool is_converged(const struct surface_record *record, const struct scene *scene)
{
    const struct convergence_tail *tail = &record->summary.tail;
    if (!(tail->gamma >= 1))
        return false;
    double limit_m = shortest_m(record), modulus = record->summary.pair.effective_modulus_Pa;
    double full_Pa = sinusoid_full_pressure(convergence_tail_amplitude(tail, limit_m), 1 / limit_m, modulus);
    return scene->convergence.load * modulus >= full_Pa;
}

static struct model_work scans_work(const struct surface_record *record, const struct model_row *row,
                                    const struct model_task *task)
{
    return repeats_several(&record->repeats, row) ? repeats_work(&record->repeats, row, task) : row->work(row, task);
}

/** What the scans will take in each model, without and with scale dependence, which a stack of scales has in the same
 * pass as the rest. */
static void count_work(struct surface_record *record, const struct plan *plan, const struct model_task *task)
{
    struct model_task without = *task;
    without.wanted &= ~QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT);
    for (size_t m = 0; m < model_count; m++) {
        if (!plan_runs_model(plan, m))
            continue;
        struct model_work *work = record->summary.bounds[m]->work;
        work[0] = scans_work(record, model_rows[m], &without);
        work[1] = model_rows[m]->stacks_scales ? work[0] : scans_work(record, model_rows[m], task);
    }
}

/** What the changed scans will take at the middle load. */
static void count_sensitivity(struct surface_record *record, const struct plan *plan, const struct model_task *task)
{
    struct model_task one = surface_middle_task(task);
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(plan, m))
            record->summary.bounds[m]->sensitivity_work =
                sensitivity_work(&record->sensitivity, model_rows[m], &one, record->repeats.count == 0);
}

/** What simulated records will take. */
static enum status_code count_records(struct surface_record *record, const struct plan *plan,
                                      const struct model_task *task, struct status *status)
{
    enum status_code rc = STATUS_OK;
    for (size_t m = 0; m < model_count && rc == STATUS_OK; m++)
        if (plan_runs_model(plan, m) && !model_rows[m]->uses_heights)
            rc = uncertainty_outline(record->summary.bounds[m], model_rows[m], task, status);
    return rc;
}

/** Scale dependence of every scan in one model, until one exceeds the tolerance. */
static enum status_code bound_scans(struct curve_bounds *bounds, struct surface_record *record,
                                    const struct model_row *row, const struct model_task *task, double tolerance,
                                    struct status *status)
{
    uint64_t *visits = &record->summary.bound.visits;
    if (record->repeats.count == 0)
        return row->scale_dependence_bound(&bounds->scale_dependence, visits, row, task, status);
    for (size_t r = 0; r < record->repeats.count && !(bounds->scale_dependence > tolerance); r++) {
        struct asperities asperities;
        struct model_task alone = repeats_task(&asperities, &record->repeats.parts[r], task);
        double most = 0;
        if (row->scale_dependence_bound(&most, visits, row, &alone, status) != STATUS_OK)
            return status->code;
        bounds->scale_dependence = fmax(bounds->scale_dependence, most);
    }
    return STATUS_OK;
}

/** Scale dependence, model by model, until one that runs whatever is decided on plasticity exceeds the tolerance. A
 * plastic model that nothing makes yield is its elastic partner. */
static enum status_code bound_scale_dependence(struct surface_record *record, const struct scene *scene,
                                               const struct plan *plan, const struct model_task *task,
                                               struct status *status)
{
    bool decided = false;
    for (size_t m = 0; m < model_count; m++) {
        const struct model_row *row = model_rows[m];
        struct curve_bounds *bounds = record->summary.bounds[m];
        if (decided || !plan_runs_model(plan, m) || !(row->quantities & QUANTITY_BIT(QUANTITY_TCR_SCALE_DEPENDENT)) ||
            (row->plastic && bounds->yield == 0))
            continue;
        if (!row->scale_dependence_bound)
            bounds->scale_dependence = INFINITY;
        else if (bound_scans(bounds, record, row, task, scene->tolerance, status) != STATUS_OK)
            return status->code;
        decided = !row->plastic && bounds->scale_dependence > scene->tolerance;
    }
    return STATUS_OK;
}

static enum status_code fill_bounds(struct surface_record *record, const struct scene *scene, const struct plan *plan,
                                    const struct model_task *task, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    count_work(record, plan, task);
    count_sensitivity(record, plan, task);
    if (plan_runs(plan, EFFECT_UNCERTAINTY) && summary->single_points > 0 &&
        count_records(record, plan, task, status) != STATUS_OK)
        return status->code;
    if (!scene->effects_auto)
        return STATUS_OK;
    summary->bound = (struct effect_bounds){.converged = is_converged(record, scene)};
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(plan, m) && model_rows[m]->plastic)
            summary->bounds[m]->yield = bound_yield(record, scene, plan, m, task);
    return plan_runs(plan, EFFECT_SCALE_DEPENDENT) ? bound_scale_dependence(record, scene, plan, task, status)
                                                   : STATUS_OK;
}

enum status_code effect_bounds_surface(struct surface_record *record, const struct scene *scene,
                                       const struct plan *plan, const double *loads, size_t load_count,
                                       struct status *status)
{
    struct surface_summary *summary = &record->summary;
    struct model_task task = surface_task(record, scene, plan, loads, load_count);
    struct model_kept kept = {.spectrum = task.spectrum, .pair = task.pair};
    task.kept = &kept;
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(plan, m) && !surface_bounds_room(summary, m))
            return status_memory(status);
    if (!summary->bounds) /* no model runs */
        return STATUS_OK;
    enum status_code rc = fill_bounds(record, scene, plan, &task, status);
    model_kept_free(&kept);
    return rc;
}

/** The largest bound of model `m` over the usable surfaces. */
static double largest(const struct surface_summary *surfaces, size_t count, size_t m,
                      double (*bound)(const struct curve_bounds *))
{
    double most = 0;
    for (size_t i = 0; i < count; i++)
        if (surfaces[i].usable)
            most = fmax(most, bound(surface_bounds(&surfaces[i], m)));
    return most;
}

static double yield_of(const struct curve_bounds *bounds)
{
    return bounds->yield;
}

static double scale_dependence_of(const struct curve_bounds *bounds)
{
    return bounds->scale_dependence;
}

/** Runs where one plastic model calls for it, for that model's reason; else is skipped for the reasons of all. */
static void decide_plasticity(struct plan *plan, const struct surface_summary *surfaces, size_t count, double tolerance)
{
    char *reason = plan->effects[EFFECT_PLASTICITY].reason;
    size_t size = sizeof plan->effects[EFFECT_PLASTICITY].reason, used = 0;
    for (int needed = 1; needed >= 0; needed--)
        for (size_t m = 0; m < model_count && used < size; m++) {
            const struct model_row *row = model_rows[m];
            if (!plan_runs_model(plan, m) || !row->plastic)
                continue;
            double bound = largest(surfaces, count, m, yield_of);
            if (needed && !(bound > tolerance))
                continue;
            if (!needed && used > 0)
                used += (size_t)snprintf(reason + used, size - used, ", and ");
            if (row->yield_reason)
                row->yield_reason(reason + used, size - used, bound, needed);
            else
                snprintf(reason + used, size - used, "%s yields", row->label);
            if (needed)
                return;
            used += strlen(reason + used);
        }
    plan_switch_off(plan, EFFECT_PLASTICITY);
}

static void decide_scale_dependence(struct plan *plan, const struct surface_summary *surfaces, size_t count,
                                    double tolerance)
{
    char *reason = plan->effects[EFFECT_SCALE_DEPENDENT].reason;
    size_t size = sizeof plan->effects[EFFECT_SCALE_DEPENDENT].reason;
    double most = 0;
    size_t at = 0;
    for (size_t m = 0; m < model_count; m++) {
        double bound = plan_runs_model(plan, m) ? largest(surfaces, count, m, scale_dependence_of) : 0;
        at = bound > most ? m : at;
        most = fmax(most, bound);
    }
    if (isinf(most)) {
        snprintf(reason, size, "%s has no bound on it", model_rows[at]->label);
    } else if (most > tolerance) {
        snprintf(reason, size, "(8/3π) λmfp/a can raise TCR by %.2g", most);
    } else {
        snprintf(reason, size, "(8/3π) λmfp/a raises TCR by at most %.2g, below the tolerance", most);
        plan_switch_off(plan, EFFECT_SCALE_DEPENDENT);
    }
}

static void decide_convergence(struct plan *plan, const struct surface_summary *surfaces, size_t count)
{
    char *reason = plan->effects[EFFECT_CONVERGENCE].reason;
    size_t size = sizeof plan->effects[EFFECT_CONVERGENCE].reason, converged = 0, tailless = 0, usable = 0;
    for (size_t i = 0; i < count; i++) {
        usable += surfaces[i].usable;
        converged += surfaces[i].usable && surfaces[i].bound.converged;
        tailless += surfaces[i].usable && isnan(surfaces[i].tail.gamma);
    }
    if (converged == usable)
        snprintf(reason, size, "sweeps only: no scale below the sampling limit can take area from any surface");
    else if (converged + tailless == usable)
        snprintf(reason, size,
                 "sweeps only: of %zu of %zu surfaces the spectrum does not tell how it goes on below what is known",
                 tailless, usable);
    else
        snprintf(reason, size, "%zu of %zu surfaces may lose area below their sampling limit",
                 usable - converged - tailless, usable);
}

/** Runs where a surface has one scan and all of them together take less than a second, by the count of what they take.
 */
static void decide_uncertainty(struct plan *plan, const struct surface_summary *surfaces, size_t count)
{
    char *reason = plan->effects[EFFECT_UNCERTAINTY].reason;
    size_t size = sizeof plan->effects[EFFECT_UNCERTAINTY].reason, single = 0;
    double seconds;
    for (size_t i = 0; i < count; i++)
        single += surfaces[i].usable && surfaces[i].single_points > 0;
    struct uncertainty_work work = work_simulated(surfaces, count, plan);
    uint64_t evaluations = work_uncertainty(&work, &seconds);
    bool affordable = seconds < uncertainty_most_seconds;
    if (single > 0)
        snprintf(reason, size, "%zu surface%s one scan; records like it would take %.2g evaluations, %s", single,
                 single == 1 ? " has" : "s have", (double)evaluations,
                 affordable ? "under a second" : "over a second: list the effect to have them");
    else
        snprintf(reason, size, "no surface has one scan alone that records can be simulated of");
    if (single == 0 || !affordable)
        plan_switch_off(plan, EFFECT_UNCERTAINTY);
}

void effect_bounds_plan(struct plan *plan, const struct scene *scene, const struct surface_summary *surfaces,
                        size_t count)
{
    if (!scene->effects_auto)
        return;
    if (plan_runs(plan, EFFECT_PLASTICITY))
        decide_plasticity(plan, surfaces, count, scene->tolerance);
    if (plan_runs(plan, EFFECT_SCALE_DEPENDENT))
        decide_scale_dependence(plan, surfaces, count, scene->tolerance);
    if (plan_runs(plan, EFFECT_CONVERGENCE))
        decide_convergence(plan, surfaces, count);
    if (plan_runs(plan, EFFECT_UNCERTAINTY))
        decide_uncertainty(plan, surfaces, count);
}

void effect_bounds_heights(struct plan *plan, const struct scene *scene, const struct surface_summary *surfaces,
                           size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (surfaces[i].usable && surfaces[i].height_law.verdict != HEIGHTS_GAUSSIAN)
            return;
    for (size_t m = 0; m < model_count && !scene->models_named; m++)
        if (model_rows[m]->uses_heights)
            plan->models &= ~MODEL_BIT(m);
}
