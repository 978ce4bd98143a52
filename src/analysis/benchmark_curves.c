/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the tolerance of the curves costs. */
#include "analysis/benchmark.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** What a scan of millions of harmonics would be summed again for at every tolerance: what that costs shows in fewer
 * too. */
enum { HARMONICS_MOST = 100000 };

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
    return tolerances(cost, task, &longest, status);
}
