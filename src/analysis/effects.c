/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/effects.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
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
    if (!row->yield_bound) /* all yield: it runs where others call for it, or where it is named */
        return scene->models_named ? INFINITY : 0;
    double most = row->yield_bound(row, task);
    for (size_t r = 0; r < record->ensemble.count; r++) {
        struct asperities asperities;
        struct model_task alone = member_task(&asperities, &record->ensemble.members[r], task);
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

/** Scale dependence of every scan in one model, until one exceeds the tolerance. */
static enum status_code bound_scans(struct curve_bounds *bounds, struct surface_record *record,
                                    const struct model_row *row, const struct model_task *task, double tolerance,
                                    struct status *status)
{
    if (record->ensemble.count == 0)
        return row->scale_dependence_bound(&bounds->scale_dependence, row, task, status);
    for (size_t r = 0; r < record->ensemble.count && !(bounds->scale_dependence > tolerance); r++) {
        struct asperities asperities;
        struct model_task alone = member_task(&asperities, &record->ensemble.members[r], task);
        double most = 0;
        if (row->scale_dependence_bound(&most, row, &alone, status) != STATUS_OK)
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
        struct curve_bounds *bounds = &record->summary.bounds[m];
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

enum status_code effects_bound(struct surface_record *record, const struct scene *scene, const struct plan *plan,
                               const double *loads, size_t load_count, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    struct model_task task = surface_model_task(record, scene, plan, loads, load_count);
    if (!scene->effects_auto)
        return STATUS_OK;
    summary->bounds = calloc(model_count, sizeof *summary->bounds);
    if (!summary->bounds)
        return status_memory(status);
    summary->converged = is_converged(record, scene);
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(plan, m) && model_rows[m]->plastic)
            summary->bounds[m].yield = bound_yield(record, scene, plan, m, &task);
    return plan_runs(plan, EFFECT_SCALE_DEPENDENT) ? bound_scale_dependence(record, scene, plan, &task, status)
                                                   : STATUS_OK;
}

/** The largest bound of model `m` over the usable surfaces. */
static double largest(const struct surface_record *surfaces, size_t count, size_t m,
                      double (*bound)(const struct curve_bounds *))
{
    double most = 0;
    for (size_t i = 0; i < count; i++)
        if (surfaces[i].summary.usable)
            most = fmax(most, bound(&surfaces[i].summary.bounds[m]));
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
static void decide_plasticity(struct plan *plan, const struct surface_record *surfaces, size_t count, double tolerance)
{
    char *reason = plan->effects[EFFECT_PLASTICITY].reason;
    size_t size = sizeof plan->effects[EFFECT_PLASTICITY].reason, used = 0;
    for (int needed = 1; needed >= 0; needed--)
        for (size_t m = 0; m < model_count && used < size; m++) {
            const struct model_row *row = model_rows[m];
            if (!plan_runs_model(plan, m) || !row->plastic)
                continue;
            double bound = largest(surfaces, count, m, yield_of);
            if (needed ? !(bound > tolerance) : !row->yield_reason)
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

static void decide_scale_dependence(struct plan *plan, const struct surface_record *surfaces, size_t count,
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

static void decide_convergence(struct plan *plan, const struct surface_record *surfaces, size_t count)
{
    char *reason = plan->effects[EFFECT_CONVERGENCE].reason;
    size_t size = sizeof plan->effects[EFFECT_CONVERGENCE].reason, converged = 0, tailless = 0, usable = 0;
    for (size_t i = 0; i < count; i++) {
        const struct surface_summary *summary = &surfaces[i].summary;
        usable += summary->usable;
        converged += summary->usable && summary->converged;
        tailless += summary->usable && isnan(summary->tail.gamma);
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

/** Runs where a surface has one scan, and records like it take little. */
static void decide_uncertainty(struct plan *plan, const struct surface_record *surfaces, size_t count)
{
    char *reason = plan->effects[EFFECT_UNCERTAINTY].reason;
    size_t size = sizeof plan->effects[EFFECT_UNCERTAINTY].reason, single = 0, simulated = 0;
    for (size_t i = 0; i < count; i++) {
        single += surfaces[i].summary.usable && surfaces[i].summary.single_points > 0;
        simulated += surfaces[i].summary.usable && surfaces[i].summary.simulates;
    }
    if (single == 0)
        snprintf(reason, size, "no surface has one scan alone that records can be simulated of");
    else if (simulated == 0)
        snprintf(reason, size,
                 "%zu surface%s one scan; records like it would take over ten seconds: list the effect to "
                 "have them",
                 single, single == 1 ? " has" : "s have");
    else
        snprintf(reason, size, "%zu surface%s one scan that records are simulated of, in under ten seconds", simulated,
                 simulated == 1 ? " has" : "s have");
    if (simulated == 0)
        plan_switch_off(plan, EFFECT_UNCERTAINTY);
}

/** Of a point of a transform there and back, on one core of 2020. */
static const double strip_seconds = 12e-9;

/** Strips run where none of the surfaces that can have them is beyond its share of their budget. */
static void decide_strips(struct plan *plan, const struct surface_record *surfaces, size_t count)
{
    double cost = 0;
    size_t lacking = 0, dear = 0;
    uint64_t users = 0;
    for (size_t m = 0; m < model_count; m++)
        users |= model_rows[m]->uses_strip ? MODEL_BIT(m) : 0;
    for (size_t i = 0; i < count; i++) {
        const struct surface_summary *summary = &surfaces[i].summary;
        bool lacks = summary->usable && !summary->has_strips;
        cost += summary->usable ? summary->strip_cost : 0;
        dear += lacks && summary->strip_cost > 0;
        lacking += lacks;
    }
    if ((dear == 0 && lacking < count) || !(plan->models & users))
        return;
    plan->models &= ~users;
    if (dear > 0)
        snprintf(plan->area_reason, sizeof plan->area_reason,
                 "every report has it; strips of the scans would take about %.2g s: name the model strip to have them",
                 cost * strip_seconds);
    else
        snprintf(plan->area_reason, sizeof plan->area_reason,
                 "every report has it; no strip transfer, as no surface has strips");
}

void effects_decide(struct plan *plan, const struct scene *scene, const struct surface_record *surfaces, size_t count)
{
    decide_strips(plan, surfaces, count);
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

/** "LABEL: METHOD" of the running models of one material law; of the ones with a method of their own for scale
 * dependence when `scale_dependent`. */
static void add_methods(char *out, size_t size, const struct plan *plan, bool plastic, bool scale_dependent)
{
    size_t used = 0;
    for (size_t m = 0; m < model_count && used < size; m++) {
        const char *method = scale_dependent ? model_rows[m]->scale_dependent_method : model_rows[m]->method;
        if (method && plan_runs_model(plan, m) && model_rows[m]->plastic == plastic)
            used += (size_t)snprintf(out + used, size - used, "%s%s: %s", used > 0 ? "; " : "", model_rows[m]->label,
                                     method);
    }
    if (used == 0)
        snprintf(out, size, "in the same pass as the area");
}

static void add_method(struct effects_row *row, enum effect effect, const struct plan *plan)
{
    static const char *const methods[EFFECT_COUNT] = {
        [EFFECT_SEPARATION] = "in the same pass as the area",
        [EFFECT_ELECTRICAL] = "in the same pass as the area",
        [EFFECT_THERMAL] = "in the same pass as the area",
        [EFFECT_STIFFNESS] = "the slope of each model's separation",
        [EFFECT_CONVERGENCE] = "direct sum over scales",
        [EFFECT_UNLOADING] = "direct solution of strips with the hardness",
        [EFFECT_DIRECT] = "boundary elements; evaluations are contacts solved",
        [EFFECT_GAP] = "an integral over the gaps at every point of the curves",
        [EFFECT_FILM] = "a formula at every point of the curves",
        [EFFECT_PLATING] = "a formula at every point of the curves",
        [EFFECT_HEATING] = "a formula at every point of the curves",
    };
    size_t size = sizeof row->method;
    if (effect == EFFECT_PLASTICITY)
        add_methods(row->method, size, plan, true, false);
    else if (effect == EFFECT_SCALE_DEPENDENT)
        add_methods(row->method, size, plan, false, true);
    else if (effect == EFFECT_UNCERTAINTY)
        snprintf(row->method, size, "%d simulated records of each, through %s at %d loads", SINGLE_SCAN_RECORDS,
                 plan->all_uncertain ? "all models" : model_rows[plan_leading_model(plan)]->label, UNCERTAINTY_LOADS);
    else
        snprintf(row->method, size, "%s", methods[effect]);
}

/** What a surface's models took, by material law. */
static void add_models(struct effects_row *elastic, struct effects_row *plastic, const struct surface_summary *summary)
{
    for (size_t m = 0; m < model_count; m++) {
        const struct curve_summary *model = surface_model(summary, m);
        struct effects_row *row = model_rows[m]->plastic ? plastic : elastic;
        row->evaluations += model->evaluations;
        row->seconds += model->seconds;
    }
}

void effects_account(struct effects_row rows[EFFECTS_ROWS], const struct plan *plan,
                     const struct surface_record *surfaces, size_t count, const struct effects_studies *studies)
{
    rows[0] = (struct effects_row){.name = "area", .runs = true, .reason = plan->area_reason};
    add_methods(rows[0].method, sizeof rows[0].method, plan, false, false);
    for (int e = 0; e < EFFECT_COUNT; e++) {
        rows[e + 1] = (struct effects_row){
            .name = effect_rows[e].name, .runs = plan->effects[e].runs, .reason = plan->effects[e].reason};
        if (plan->effects[e].runs)
            add_method(&rows[e + 1], (enum effect)e, plan);
    }
    struct effects_row *convergence = &rows[1 + EFFECT_CONVERGENCE], *direct = &rows[1 + EFFECT_DIRECT],
                       *uncertainty = &rows[1 + EFFECT_UNCERTAINTY], *unloading = &rows[1 + EFFECT_UNLOADING];
    convergence->evaluations = studies->sweep_scales;
    convergence->seconds = studies->sweep_seconds;
    direct->evaluations = studies->contacts;
    direct->seconds = studies->contact_seconds;
    for (size_t i = 0; i < count; i++) {
        const struct surface_summary *summary = &surfaces[i].summary;
        add_models(&rows[0], &rows[1 + EFFECT_PLASTICITY], summary);
        rows[0].evaluations += summary->strip_transforms;
        rows[0].seconds += summary->times.strips;
        convergence->seconds += summary->times.convergence;
        uncertainty->evaluations += summary->simulated_evaluations;
        uncertainty->seconds += summary->times.uncertainty;
        unloading->evaluations += summary->unloading ? summary->unloading->ratio.transforms : 0;
        unloading->seconds += summary->times.unloading;
    }
}

/* What a report takes, roughly, on one core of 2020; for planning only: a report prints what it took. */
static const double report_seconds = 0.25, surface_seconds = 1e-3, point_seconds = 0.4e-6, load_seconds = 3e-6;

double effects_rough_seconds(const struct plan *plan, const struct surface_record *surfaces, size_t count,
                             size_t load_count, double direct_seconds, size_t threads)
{
    double sum = direct_seconds, longest = 0; /* a surface's strips are solved one after the other */
    size_t models = 0;
    for (size_t m = 0; m < model_count; m++)
        models += plan_runs_model(plan, m);
    for (size_t i = 0; i < count; i++) {
        const struct surface_summary *summary = &surfaces[i].summary;
        double points = (double)summary->points * (double)summary->scans;
        sum += surface_seconds + points * point_seconds +
               (double)(models * load_count) * fmax(1, (double)summary->scans) * load_seconds;
        double strips = summary->has_strips ? summary->strip_cost * strip_seconds : 0;
        sum += strips;
        if (plan_runs(plan, EFFECT_UNLOADING)) /* two branches of its shares in one strip */
            sum += summary->strip_cost * strip_seconds * 2 * UNLOADING_SHARES / (STRIP_LOADS * (1 + STRIP_SURROGATES));
        longest = fmax(longest, strips);
        if (summary->simulates)
            sum += uncertainty_seconds(summary->points);
    }
    return report_seconds + fmax(sum / (double)threads, longest);
}
