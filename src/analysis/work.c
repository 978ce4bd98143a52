/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/work.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/** Typical times of one evaluation on one core [s], from the benchmark (cmake --workflow --preset bench). They are for
 * planning only; a report prints what it took. */
static const double scale_seconds = 40e-9, gap_seconds = 20e-9, constriction_seconds = 10e-9, node_seconds = 120e-9,
                    separation_seconds = 0.4e-6, search_seconds = 25e-6, extension_seconds = 0.2e-3;

static struct model_work *share_of(struct work *work, size_t m)
{
    return model_rows[m]->plastic ? &work->plastic : &work->elastic;
}

static void add_simulated(struct uncertainty_work *sum, const struct uncertainty_work *more)
{
    sum->heights += more->heights;
    model_work_add(&sum->models, &more->models);
}

struct uncertainty_work work_simulated(const struct surface_summary *surfaces, size_t count, const struct plan *plan)
{
    struct uncertainty_work sum = {0};
    for (size_t i = 0; i < count; i++) {
        if (!surfaces[i].usable || surfaces[i].single_points == 0)
            continue;
        struct uncertainty_work more = uncertainty_predict(surfaces[i].single_points, plan, surfaces[i].bounds);
        add_simulated(&sum, &more);
    }
    return sum;
}

void work_add(struct work *work, size_t m, const struct model_work *more)
{
    model_work_add(share_of(work, m), more);
}

struct model_work work_of_model(const struct surface_summary *surface, size_t m, const struct scene *scene,
                                const struct plan *plan)
{
    struct model_work work = {.searches = (surface_seeks_beta(plan, m) ? 2 : 1) + scene->target_count};
    model_work_add(&work, &surface_bounds(surface, m)->work[plan_runs(plan, EFFECT_SCALE_DEPENDENT)]);
    model_work_add(&work, &surface_bounds(surface, m)->sensitivity_work);
    return work;
}

struct work work_predict(const struct surface_summary *surfaces, size_t count, const struct scene *scene,
                         const struct plan *plan)
{
    struct work work = {0};
    for (size_t i = 0; i < count; i++) {
        if (!surfaces[i].usable)
            continue;
        work.bounds += surfaces[i].bound.visits;
        for (size_t m = 0; m < model_count; m++) {
            if (!plan_runs_model(plan, m))
                continue;
            struct model_work of_model = work_of_model(&surfaces[i], m, scene, plan);
            model_work_add(share_of(&work, m), &of_model);
            work.extensions += model_rows[m]->stacks_scales && plan_runs(plan, EFFECT_CONVERGENCE) &&
                               surface_extends(&surfaces[i], scene);
        }
    }
    for (size_t m = 0; m < model_count && plan_runs(plan, EFFECT_CONVERGENCE); m++)
        for (int s = 0; s < CONVERGENCE_SWEEP_COUNT && plan_runs_model(plan, m) && model_rows[m]->stacks_scales; s++)
            work.sweep_scales += convergence_sweeps[s].count * scene->convergence.scales;
    if (plan_runs(plan, EFFECT_UNCERTAINTY))
        work.simulated = work_simulated(surfaces, count, plan);
    return work;
}

struct work work_done(const struct work *models, const struct surface_summary *surfaces, size_t count,
                      uint64_t sweep_scales)
{
    struct work work = *models;
    work.sweep_scales = sweep_scales;
    for (size_t i = 0; i < count; i++) {
        work.bounds += surfaces[i].bound.visits;
        if (surfaces[i].simulated)
            add_simulated(&work.simulated, surfaces[i].simulated);
        for (size_t m = 0; m < model_count; m++)
            work.extensions += surface_model(&surfaces[i], m)->extended;
    }
    return work;
}

/** Without what scale dependence alone needs. */
static double model_seconds(const struct model_work *work)
{
    return (double)work->scales * scale_seconds + (double)work->nodes * node_seconds +
           (double)work->separations * separation_seconds + (double)work->searches * search_seconds;
}

double work_seconds(const struct model_work *work)
{
    return model_seconds(work) + (double)work->gaps * gap_seconds + (double)work->constrictions * constriction_seconds +
           (double)work->scale_dependent_nodes * node_seconds;
}

uint64_t work_uncertainty(const struct uncertainty_work *work, double *seconds)
{
    *seconds = (double)work->heights * uncertainty_height_seconds + work_seconds(&work->models);
    return work->heights + model_evaluations(&work->models);
}

/** Evaluations that are there because of `effect`, and their likely seconds. */
static uint64_t share(const struct work *work, const struct plan *plan, enum effect effect, double *seconds)
{
    bool first_conductor =
        effect == EFFECT_ELECTRICAL || (effect == EFFECT_THERMAL && !plan_runs(plan, EFFECT_ELECTRICAL));
    uint64_t count = 0;
    *seconds = 0;
    switch (effect) {
    case EFFECT_PLASTICITY:
        count = work->plastic.scale_dependent_nodes;
        *seconds = model_seconds(&work->plastic) + (double)count * node_seconds;
        return model_evaluations(&work->plastic);
    case EFFECT_SEPARATION:
        count = work->elastic.gaps + work->plastic.gaps;
        *seconds = (double)count * gap_seconds;
        return count;
    case EFFECT_ELECTRICAL:
    case EFFECT_THERMAL:
        count = first_conductor ? work->elastic.constrictions + work->plastic.constrictions : 0;
        *seconds = (double)count * constriction_seconds;
        return count;
    case EFFECT_SCALE_DEPENDENT: /* the decision, and laws at nodes where closed forms would do without it */
        count = work->elastic.scale_dependent_nodes;
        *seconds = (double)work->bounds * (scale_seconds + constriction_seconds) + (double)count * node_seconds;
        return work->bounds + count;
    case EFFECT_CONVERGENCE:
        *seconds = (double)work->sweep_scales * scale_seconds + (double)work->extensions * extension_seconds;
        return work->sweep_scales + work->extensions;
    case EFFECT_UNCERTAINTY:
        return work_uncertainty(&work->simulated, seconds);
    case EFFECT_DIRECT:
        *seconds = work->contact_seconds;
        return work->contacts;
    case EFFECT_GAP: /* a formula a point of the curves */
    case EFFECT_FILM:
    case EFFECT_PLATING:
    case EFFECT_HEATING:
    case EFFECT_COUNT:
        break;
    }
    return 0;
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

static void add_method(struct work_row *row, enum effect effect, const struct plan *plan)
{
    size_t size = sizeof row->method;
    switch (effect) {
    case EFFECT_PLASTICITY:
        add_methods(row->method, size, plan, true, false);
        break;
    case EFFECT_SCALE_DEPENDENT:
        add_methods(row->method, size, plan, false, true);
        break;
    case EFFECT_CONVERGENCE:
        snprintf(row->method, size, "direct sum over scales");
        break;
    case EFFECT_UNCERTAINTY:
        snprintf(row->method, size, "%d simulated records of each, through %s at %d loads", SINGLE_SCAN_RECORDS,
                 plan->all_uncertain ? "all models" : model_rows[plan_leading_model(plan)]->label, UNCERTAINTY_LOADS);
        break;
    case EFFECT_THERMAL:
        snprintf(row->method, size, "%s",
                 plan_runs(plan, EFFECT_ELECTRICAL) ? "the sums of electrical in other units, so nothing of its own"
                                                    : "in the same pass as the area");
        break;
    case EFFECT_DIRECT:
        snprintf(row->method, size, "boundary elements; evaluations are contacts solved");
        break;
    case EFFECT_GAP:
        snprintf(row->method, size, "an integral over the gaps at every point of the curves");
        break;
    case EFFECT_FILM:
    case EFFECT_PLATING:
    case EFFECT_HEATING:
        snprintf(row->method, size, "a formula at every point of the curves");
        break;
    case EFFECT_SEPARATION:
    case EFFECT_ELECTRICAL:
        snprintf(row->method, size, "in the same pass as the area");
        break;
    case EFFECT_COUNT:
        add_methods(row->method, size, plan, false, false);
        break;
    }
}

void work_table(struct work_row rows[WORK_ROWS], const struct work *work, const struct plan *plan)
{
    rows[0] = (struct work_row){
        .name = "area",
        .runs = true,
        .reason = "every report has it",
        .evaluations = model_evaluations(&work->elastic) - work->elastic.scale_dependent_nodes,
        .seconds = model_seconds(&work->elastic),
    };
    add_method(&rows[0], EFFECT_COUNT, plan);
    for (int e = 0; e < EFFECT_COUNT; e++) {
        struct work_row *row = &rows[e + 1];
        *row = (struct work_row){
            .name = effect_rows[e].name,
            .runs = plan->effects[e].runs,
            .reason = plan->effects[e].reason,
        };
        if (e == EFFECT_CONVERGENCE)
            row->bytes = (double)work->sweep_scales * sizeof(double);
        if (e == EFFECT_DIRECT)
            row->bytes = work->contact_bytes;
        if (row->runs)
            add_method(row, (enum effect)e, plan);
        if (row->runs || e == EFFECT_SCALE_DEPENDENT) /* deciding against it takes some too */
            row->evaluations = share(work, plan, (enum effect)e, &row->seconds);
    }
}

uint64_t work_total(const struct work *work, const struct plan *plan, double *seconds)
{
    struct work_row rows[WORK_ROWS];
    uint64_t total = 0;
    *seconds = 0;
    work_table(rows, work, plan);
    for (int r = 0; r < WORK_ROWS; r++) {
        total += rows[r].evaluations;
        *seconds += rows[r].seconds;
    }
    return total;
}

double work_memory(const struct surface_summary *surfaces, size_t count, unsigned jobs)
{
    size_t most = 0;
    for (size_t i = 0; i < count; i++)
        most = surfaces[i].points > most ? surfaces[i].points : most;
    double program = 11e6, a_point = 108; /* text and numbers of a scan, its profile, transform and spectrum [bytes] */
    double threads = fmin(jobs, (double)count);
    double a_summary = (double)(sizeof *surfaces + model_count * sizeof(struct curve_summary));
    return program + threads * ((double)most * a_point + 2 * sizeof(struct surface_record)) + (double)count * a_summary;
}
