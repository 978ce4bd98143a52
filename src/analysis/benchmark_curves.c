/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the curves cost: leaving out the shortest wavelengths, the number of loads, the tolerance. */
#include "analysis/benchmark.h"
#include "contact/multiscale.h"
#include "contact/statistical.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** The multiscale curve of the baseline from its longest scales alone. */
struct cut_attempt {
    struct spectrum spectrum; /* count is what is kept; the amplitudes are the surface's */
    const struct model_row *row;
    const struct benchmark_task *task;
    double *area;
    uint64_t evaluations;
    bool failed;
};

static void solve_cut(void *context)
{
    struct cut_attempt *attempt = context;
    struct constriction none = {0};
    struct multiscale stack;
    struct status status = {0};
    attempt->evaluations = 0;
    attempt->failed = multiscale_make(&stack, &attempt->spectrum, &attempt->task->surface->summary.pair,
                                      attempt->row->plastic, attempt->task->scene->closure, &status) != STATUS_OK;
    if (attempt->failed)
        return;
    for (size_t i = 0; i < attempt->task->load_count; i++) {
        struct contact_point point;
        multiscale_solve(&point, &stack, &none, 0, attempt->task->loads[i], &attempt->evaluations);
        attempt->area[i] = point.value[QUANTITY_AREA];
    }
    multiscale_free(&stack);
}

static enum status_code cut_off(struct benchmark *cost, const struct benchmark_task *task, size_t model,
                                struct status *status)
{
    enum { STEPS = 7 };
    size_t loads = task->load_count;
    struct cut_attempt attempt = {.spectrum = task->surface->spectrum,
                                  .row = model_rows[model],
                                  .task = task,
                                  .area = malloc(2 * loads * sizeof *attempt.area)};
    double *full = attempt.area ? attempt.area + loads : NULL;
    enum status_code rc = full ? STATUS_OK : status_memory(status);
    size_t all = attempt.spectrum.count;
    if (rc == STATUS_OK) {
        solve_cut(&attempt);
        rc = attempt.failed ? status_memory(status) : STATUS_OK;
        memcpy(full, attempt.area, loads * sizeof *full);
    }
    for (int step = STEPS; rc == STATUS_OK && step >= 1; step--) {
        attempt.spectrum.count = all >> step;
        if (attempt.spectrum.count == 0)
            continue;
        struct benchmark_row row = {.study = "cut-off",
                                    .model = model_rows[model],
                                    .method = model_rows[model]->name,
                                    .chart = BENCHMARK_CURVES};
        snprintf(row.setting, sizeof row.setting, "%.3gum",
                 1e6 / spectrum_frequency(&attempt.spectrum, attempt.spectrum.count - 1));
        row.seconds = benchmark_time(solve_cut, &attempt);
        row.evaluations = attempt.evaluations;
        for (size_t i = 0; i < loads; i++)
            row.error = fmax(row.error, fabs(attempt.area[i] / full[i] - 1));
        if (row.error == 0)
            snprintf(row.note, sizeof row.note, "waves left out are flat at every load");
        rc = attempt.failed ? status_memory(status) : benchmark_add(cost, &row, status);
    }
    free(attempt.area);
    return rc;
}

/** What a scan of millions of harmonics would be summed again for at every number of loads: what that costs shows in
 * fewer too. */
enum { HARMONICS_MOST = 100000 };

/** A curve of n loads, log spaced over the scene's range, by one model, from what it has made of the surface once: as
 * the report's own curves and landmarks. */
struct grid_attempt {
    const struct model_row *row;
    struct model_task task;
    struct model_curve curve;
    bool failed;
};

static void solve_grid(void *context)
{
    struct grid_attempt *attempt = context;
    struct status status = {0};
    struct contact_point *points = attempt->curve.points;
    attempt->curve = (struct model_curve){.points = points};
    attempt->failed = attempt->row->run(&attempt->curve, attempt->row, &attempt->task, &status) != STATUS_OK;
}

/** Largest relative error of the area interpolated in log-log between every second of the curve's points, at the points
 * left out. */
static double interpolation_error(const struct model_curve *curve)
{
    double error = 0;
    for (size_t i = 1; i + 1 < curve->count; i += 2) {
        const struct contact_point *p = &curve->points[i - 1], *q = p + 1, *r = p + 2;
        if (!(p->value[QUANTITY_AREA] > 0))
            continue;
        double share = log(q->value[QUANTITY_LOAD] / p->value[QUANTITY_LOAD]) /
                       log(r->value[QUANTITY_LOAD] / p->value[QUANTITY_LOAD]);
        double between = p->value[QUANTITY_AREA] * pow(r->value[QUANTITY_AREA] / p->value[QUANTITY_AREA], share);
        error = fmax(error, fabs(between / q->value[QUANTITY_AREA] - 1));
    }
    return error;
}

static enum status_code load_grid(struct benchmark *cost, const struct benchmark_task *task, size_t model,
                                  const struct spectrum *spectrum, struct status *status)
{
    static const size_t counts[] = {5, 9, 17, 33, 65, 129};
    enum { MOST = 2 * 129 };
    double loads[MOST], first = task->loads[0], last = task->loads[task->load_count - 1];
    struct contact_point points[MOST + 1];
    enum status_code rc = STATUS_OK;
    for (size_t c = 0; c < sizeof counts / sizeof counts[0] && rc == STATUS_OK && last > first; c++) {
        /* n loads and the points halfway between them, where the interpolation is tested */
        size_t n = counts[c], both = 2 * n - 1;
        for (size_t i = 0; i < both; i++)
            loads[i] = first * pow(last / first, (double)i / (double)(both - 1));
        struct grid_attempt attempt = {.row = model_rows[model], .curve = {.points = points}};
        attempt.task = surface_model_task(task->surface, task->scene, task->plan, loads, both);
        attempt.task.wanted = 0;
        attempt.task.spectrum = spectrum;
        solve_grid(&attempt);
        struct benchmark_row row = {.study = "loads",
                                    .model = model_rows[model],
                                    .method = model_rows[model]->name,
                                    .chart = BENCHMARK_CURVES,
                                    .error = interpolation_error(&attempt.curve)};
        for (size_t i = 0; i < n; i++)
            loads[i] = first * pow(last / first, (double)i / (double)(n - 1));
        attempt.task.load_count = n;
        row.seconds = benchmark_time(solve_grid, &attempt);
        row.evaluations = attempt.curve.evaluations;
        snprintf(row.setting, sizeof row.setting, "%zu", n);
        rc = attempt.failed ? status_memory(status) : benchmark_add(cost, &row, status);
    }
    return rc;
}

/** The curves of all models that run, from the surface on. */
struct curves_attempt {
    const struct benchmark_task *task;
    const struct spectrum *spectrum; /* of the surface, no more of it than HARMONICS_MOST */
    double tolerance;
    struct contact_point *points; /* of every model */
    uint64_t evaluations;
    bool failed;
};

static void solve_curves(void *context)
{
    struct curves_attempt *attempt = context;
    const struct benchmark_task *of = attempt->task;
    const struct surface_record *surface = of->surface;
    struct model_task task = surface_model_task(surface, of->scene, of->plan, of->loads, of->load_count);
    struct status status = {0};
    attempt->evaluations = 0;
    task.spectrum = attempt->spectrum;
    task.tolerance = attempt->tolerance;
    for (size_t m = 0; m < model_count; m++) {
        struct model_curve curve = {.points = attempt->points + m * (of->load_count + 1)};
        if (!surface->curves[m].exists)
            continue;
        attempt->failed = attempt->failed || model_run(&curve, model_rows[m], &task, &status) != STATUS_OK;
        attempt->evaluations += curve.evaluations;
    }
}

/** What the tolerance costs: the curves of the report's own loads. Errors against the last, of every quantity that a
 * chart shows. */
static enum status_code tolerances(struct benchmark *cost, const struct benchmark_task *task,
                                   const struct spectrum *spectrum, struct status *status)
{
    static const double tolerance[] = {1e-13, 1e-10, 1e-6, 1e-2};
    size_t count = model_count * (task->load_count + 1);
    struct contact_point *best = calloc(2 * count, sizeof *best);
    if (!best)
        return status_memory(status);
    struct curves_attempt attempt = {.task = task, .spectrum = spectrum, .points = best};
    struct benchmark_row rows[sizeof tolerance / sizeof *tolerance];
    size_t steps = sizeof tolerance / sizeof *tolerance;
    for (size_t t = 0; t < steps && !attempt.failed; t++) {
        struct benchmark_row *row = &rows[steps - 1 - t];
        attempt.tolerance = tolerance[t];
        attempt.points = t == 0 ? best : best + count;
        *row = (struct benchmark_row){
            .method = "all models", .chosen = tolerance[t] == task->scene->tolerance, .chart = BENCHMARK_CHARTS};
        snprintf(row->study, sizeof row->study, "tolerance");
        snprintf(row->setting, sizeof row->setting, "%g", tolerance[t]);
        row->seconds = benchmark_time(solve_curves, &attempt);
        row->evaluations = attempt.evaluations;
        for (size_t i = 0; i < count; i++)
            for (int q = QUANTITY_AREA; q <= QUANTITY_ECR; q++) {
                double better = best[i].value[q], ratio = attempt.points[i].value[q] / better;
                if (better > 0 && isfinite(ratio))
                    row->error = fmax(row->error, fabs(ratio - 1));
            }
    }
    enum status_code rc = attempt.failed ? status_memory(status) : STATUS_OK;
    snprintf(rows[steps - 1].note, sizeof rows->note, "the others are held against it");
    for (size_t t = 0; t < steps && rc == STATUS_OK; t++)
        rc = benchmark_add(cost, &rows[t], status);
    free(best);
    return rc;
}

enum status_code benchmark_curves(struct benchmark *cost, const struct benchmark_task *task, struct status *status)
{
    const struct surface_record *surface = task->surface;
    struct spectrum longest = surface->spectrum;
    if (longest.count > HARMONICS_MOST) {
        longest.count = HARMONICS_MOST;
        longest.has_nyquist = false;
    }
    enum status_code rc = STATUS_OK;
    for (size_t m = 0; m < model_count && rc == STATUS_OK; m++)
        if (model_rows[m]->stacks_scales && surface->curves[m].exists)
            rc = cut_off(cost, task, m, status);
    for (size_t m = 0; m < model_count && rc == STATUS_OK; m++)
        if (surface->curves[m].exists)
            rc = load_grid(cost, task, m, &longest, status);
    return rc == STATUS_OK ? tolerances(cost, task, &longest, status) : rc;
}
