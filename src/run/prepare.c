/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/prepare.h"

#include "analysis/direct_study.h"
#include "analysis/effect_bounds.h"
#include "run/workers.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SHOWN_MOST = 8 };

/** Reads the rough counterface, if the scene has one. It must be readable: no result would mean anything without it. */
static enum status_code read_counterface(struct prepared *out, const struct scene *scene, struct status *status)
{
    if (scene->counterface_surface.file_count == 0)
        return STATUS_OK;
    out->counterface = calloc(1, sizeof *out->counterface);
    if (!out->counterface)
        return status_memory(status);
    if (surface_describe(out->counterface, scene, &scene->counterface_surface, NULL, NULL, status) != STATUS_OK)
        return status->code;
    if (!out->counterface->summary.usable)
        return status_fail(status, STATUS_SCENE, "the counterface cannot be read: %s",
                           out->counterface->summary.refusal);
    out->results.counterface = out->counterface;
    return STATUS_OK;
}

static int compare_roughness(const void *a, const void *b, void *context)
{
    const struct surface_summary *summaries = context;
    size_t i = *(const size_t *)a, j = *(const size_t *)b;
    double x = summaries[i].roughness.rq_m, y = summaries[j].roughness.rq_m;
    return x < y ? -1 : x > y ? 1 : i < j ? -1 : 1;
}

/** Ranks the usable surfaces and chooses which the charts show and which is the baseline. */
static enum status_code rank_surfaces(struct results *results, struct status *status)
{
    const struct surface_store *store = results->store;
    const char *baseline = results->scene->baseline;
    size_t usable = 0, *order = malloc((store->count + SHOWN_MOST) * sizeof *order);
    if (!order)
        return status_memory(status);
    for (size_t i = 0; i < store->count; i++)
        if (store->summaries[i].usable)
            order[usable++] = i;
    results->by_roughness = order;
    results->usable_count = usable;
    if (usable == 0)
        return STATUS_OK;
    results->shown = order + store->count;
    results->shown_count = usable < SHOWN_MOST ? usable : SHOWN_MOST;
    memcpy(results->shown, order, results->shown_count * sizeof *order);
    qsort_r(order, usable, sizeof *order, compare_roughness, store->summaries);
    for (size_t k = 0; usable > SHOWN_MOST && k < SHOWN_MOST; k++) /* from smoothest to roughest, evenly */
        results->shown[k] = order[k * (usable - 1) / (SHOWN_MOST - 1)];
    results->baseline = order[usable > 1 ? 1 : 0];
    if (baseline)
        for (size_t i = 0; i < usable; i++)
            if (strcmp(store->summaries[order[i]].scene->name, baseline) == 0)
                results->baseline = order[i];
    return STATUS_OK;
}

bool prepare_solves(const struct results *results, size_t index)
{
    const struct surface_summary *summary = &results->store->summaries[index];
    bool called = results->scene->direct.surfaces == SCENE_DIRECT_ALL || index == results->baseline;
    return called && summary->usable && summary->direct && summary->direct->possible;
}

/** "256 x 256 points, 12 surfaces, 13 loads, about 9e3 convolutions, 5 s of one core". */
static void describe_direct(char *out, size_t size, const struct direct_plan *plan)
{
    int used = snprintf(out, size, "%zu x %zu points, ", plan->grid, plan->grid);
    if (plan->side > 0)
        used += snprintf(out + used, size - (size_t)used, "the map mirrored, ");
    else
        used += snprintf(out + used, size - (size_t)used, "%zu surface%s%s, ", plan->seeds, plan->seeds == 1 ? "" : "s",
                         plan->fine_times > 1 ? " and a finer grid" : "");
    used += snprintf(out + used, size - (size_t)used, "%zu load%s: about %.2g convolutions, %.2g s of one core",
                     plan->loads, plan->loads == 1 ? "" : "s", plan->convolutions, plan->seconds);
    if (plan->of_spacing) /* else the scene says what the surface is */
        snprintf(out + used, size - (size_t)used,
                 ", down to waves of four spacings, for want of a lambda_s: true at this resolution%s",
                 plan->law.gamma > 0 && plan->law.gamma < 1.5 ? ", its area falling with lambda_s" : "");
}

/** The direct solution's part of the plan: its work, and what it says of itself, or would cost. */
static void plan_direct(struct plan *plan, struct results *results)
{
    struct plan_effect *effect = &plan->effects[EFFECT_DIRECT];
    struct surface_store *store = results->store;
    const struct direct_plan *first = NULL;
    struct work *work = &results->predicted;
    size_t surfaces = 0;
    char cost[320];
    if (results->usable_count == 0)
        return;
    for (size_t i = 0; i < store->count && effect->runs; i++) {
        struct surface_summary *summary = &store->summaries[i];
        if (summary->direct && !plan_runs(plan, EFFECT_PLASTICITY))
            direct_plan_elastic(summary->direct);
        if (!prepare_solves(results, i))
            continue;
        work->contacts += summary->direct->solutions;
        work->contact_seconds += summary->direct->seconds;
        work->contact_bytes = fmax(work->contact_bytes, summary->direct->bytes);
        first = first && i != results->baseline ? first : summary->direct;
        surfaces++;
    }
    if (!effect->runs) {
        struct direct_plan outline;
        direct_study_outline(&outline, &store->summaries[results->baseline], results->scene, plan,
                             results_loads(results, results->baseline), results->load_count);
        describe_direct(cost, sizeof cost, &outline);
        if (outline.possible)
            snprintf(effect->reason, sizeof effect->reason,
                     "not called for; it would say how far each model is off: %s", cost);
        else
            snprintf(effect->reason, sizeof effect->reason, "not called for; %s", outline.problem);
    } else if (!first) {
        const struct direct_plan *none = store->summaries[results->baseline].direct;
        snprintf(effect->reason, sizeof effect->reason, "called for, but %s",
                 none ? none->problem : "no surface can be solved");
    } else {
        describe_direct(cost, sizeof cost, first);
        int used = snprintf(effect->reason, sizeof effect->reason, "called for on %zu surface%s: %s", surfaces,
                            surfaces == 1 ? "" : "s", cost);
        if (first->over_budget)
            snprintf(effect->reason + used, sizeof effect->reason - (size_t)used,
                     ", more than the budget of %g s, which nothing fits", results->scene->direct.budget_s);
        else if (first->more_seconds > 0)
            snprintf(effect->reason + used, sizeof effect->reason - (size_t)used,
                     " of the budget of %g s; the next better (%zu x %zu points, %zu surfaces) would take %.2g s",
                     results->scene->direct.budget_s, first->more_grid, first->more_grid, first->more_seeds,
                     first->more_seconds);
    }
}

/** Adds what the models take at the measured loads, on the baseline surface. */
static enum status_code predict_answers(struct results *results, struct status *status)
{
    struct surface_record record = {0};
    if (results->usable_count == 0)
        return STATUS_OK;
    enum status_code rc = surface_store_get(&record, results->store, results->baseline, status);
    struct model_task task = surface_task(&record, results->scene, results->plan,
                                          results_loads(results, results->baseline), results->load_count);
    for (size_t m = 0; m < model_count && rc == STATUS_OK; m++) {
        struct model_work more;
        if (!plan_runs_model(results->plan, m))
            continue;
        rc = measured_work(&more, results->measured, m, &task, &record.repeats, status);
        if (rc == STATUS_OK)
            work_add(&results->predicted, m, &more);
    }
    surface_record_free(&record, false);
    return rc;
}

/** The loads of every surface: the same list, or each its own of as many. */
static enum status_code make_loads(struct prepared *out, const struct scene *scene, struct status *status)
{
    struct results *results = &out->results;
    struct material_pair first = scene_pair(scene->surfaces[0].bodies);
    size_t operating, count, surfaces = scene->surface_count;
    for (size_t i = 1; i < surfaces && scene->load.kind != UNIT_NUMBER; i++)
        results->loads_apart = results->loads_apart ||
                               scene_pair(scene->surfaces[i].bodies).effective_modulus_Pa != first.effective_modulus_Pa;
    if (scene_loads(&out->loads, &results->load_count, &operating, scene, &first, status) != STATUS_OK)
        return status->code;
    out->plan.operating_place = operating + 1;
    if (results->loads_apart) {
        double *all = reallocarray(out->loads, surfaces * results->load_count, sizeof *all);
        if (!all)
            return status_memory(status);
        out->loads = all;
    }
    for (size_t i = 1; i < surfaces && results->loads_apart; i++) {
        struct material_pair pair = scene_pair(scene->surfaces[i].bodies);
        double *own;
        if (scene_loads(&own, &count, &operating, scene, &pair, status) != STATUS_OK)
            return status->code;
        memcpy(out->loads + i * results->load_count, own, results->load_count * sizeof *own);
        free(own);
    }
    results->loads = out->loads;
    return STATUS_OK;
}

/** Makes room for the surfaces of the scene and reads the rough counterface, if there is one. */
static enum status_code begin(struct prepared *out, const struct scene *scene, const char *directory,
                              struct status *status)
{
    *out = (struct prepared){0};
    plan_make(&out->plan, scene);
    out->results = (struct results){.scene = scene, .plan = &out->plan, .store = &out->store};
    if (scene->surface_count == 0)
        return status_fail(status, STATUS_SCAN, "no scan in '%s': put the profilometer's files there",
                           scene->directory);
    if (make_loads(out, scene, status) != STATUS_OK)
        return status->code;
    if (read_counterface(out, scene, status) != STATUS_OK)
        return status->code;
    /* measured loads are answered on every scan of the baseline, so a plan too has to keep the scans */
    const char *place = directory ? directory : scene->measured.file ? "" : NULL;
    return surface_store_open(&out->store, place, scene->surface_count, status);
}

enum status_code prepare(struct prepared *out, const struct scene *scene, const struct run_options *options,
                         const char *directory, struct status *status)
{
    if (begin(out, scene, directory, status) != STATUS_OK ||
        workers_run(&out->results, WORKERS_DESCRIBE, options, status) != STATUS_OK)
        return status->code;
    effect_bounds_heights(&out->plan, scene, out->store.summaries, out->store.count);
    effect_bounds_plan(&out->plan, scene, out->store.summaries, out->store.count);
    if (rank_surfaces(&out->results, status) != STATUS_OK)
        return status->code;
    out->results.predicted = work_predict(out->store.summaries, out->store.count, scene, &out->plan);
    plan_direct(&out->plan, &out->results);
    if (!scene->measured.file)
        return STATUS_OK;
    if (measured_read(&out->measured, scene, &out->plan, results_pair(&out->results, out->results.baseline), status) !=
        STATUS_OK)
        return status->code;
    out->results.measured = &out->measured;
    return predict_answers(&out->results, status);
}

void prepared_free(struct prepared *prepared)
{
    surface_store_close(&prepared->store);
    measured_free(&prepared->measured);
    if (prepared->counterface)
        surface_record_free(prepared->counterface, true);
    free(prepared->counterface);
    free(prepared->loads);
    free(prepared->results.by_roughness);
    *prepared = (struct prepared){0};
}

void prepare_table(struct text *out, const struct prepared *prepared, const struct work *done)
{
    struct work_row predicted[WORK_ROWS], actual[WORK_ROWS];
    double seconds, unused;
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    double memory =
        work_memory(prepared->store.summaries, prepared->store.count, processors > 0 ? (unsigned)processors : 1);
    uint64_t total = work_total(&prepared->results.predicted, &prepared->plan, &seconds);
    uint64_t total_done = work_total(done ? done : &prepared->results.predicted, &prepared->plan, &unused);
    work_table(predicted, &prepared->results.predicted, &prepared->plan);
    work_table(actual, done ? done : &prepared->results.predicted, &prepared->plan);
    text_add(out, "%-16s %-8s %14s%s %10s %8s  %s\n", "effect", "", "evaluations", done ? "           done" : "",
             "seconds", "memory", "why; how");
    for (int r = 0; r < WORK_ROWS; r++) {
        const struct work_row *row = &predicted[r];
        text_add(out, "%-16s %-8s %14llu", row->name, row->runs ? "run" : "skipped",
                 (unsigned long long)row->evaluations);
        if (done)
            text_add(out, " %14llu", (unsigned long long)actual[r].evaluations);
        double bytes = r == 0 ? memory : row->bytes; /* the area's arrays serve the others too */
        text_add(out, " %10.4f %5.1f MB  ", row->seconds, bytes / 1e6);
        text_add_shown(out, row->reason); /* may name a surface */
        text_add(out, "%s%s\n", row->runs ? "; " : "", row->method);
    }
    text_add(out, "%-16s %-8s %14llu", "all", "", (unsigned long long)total);
    if (done)
        text_add(out, " %14llu", (unsigned long long)total_done);
    text_add(out, " %10.4f %5.1f MB\n", seconds,
             (memory + predicted[EFFECT_CONVERGENCE + 1].bytes + predicted[EFFECT_DIRECT + 1].bytes) / 1e6);
}
