/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "plan/benchmark.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

enum {
    HARMONICS_MOST = 100000, /* enough to show the cost of a longer scan too */
    LOADS_MOST = 400         /* of more only every second, third, ... */
};

/** CPU time of this thread [s]. */
static double own_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/** A model's curve, computed anew. */
struct curve_attempt {
    const struct surface_record *surface;
    const struct surface_task *asked;
    size_t m;
    struct spectrum spectrum; /* of the surface, at most HARMONICS_MOST of it */
    double tolerance;
    double loads[LOADS_MOST];
    size_t load_count;
    struct contact_point *points; /* of the model */
    uint64_t evaluations;
    bool failed;
};

static void solve_curve(struct curve_attempt *attempt)
{
    struct model_task task = surface_model_task(attempt->surface, attempt->asked);
    struct model_curve curve = {.points = attempt->points};
    struct status status = {0};
    task.spectrum = &attempt->spectrum;
    task.tolerance = attempt->tolerance;
    task = model_task_at(&task, attempt->loads, attempt->load_count);
    attempt->failed = model_run(&curve, model_rows[attempt->m], &task, &status) != STATUS_OK;
    attempt->evaluations = curve.evaluations;
}

/** Times it: the least of several runs if they are short. */
static double time_of(struct curve_attempt *attempt)
{
    enum { RUNS_MOST = 12 };
    const double enough_seconds = 2e-3;
    double least = INFINITY, total = 0;
    for (int run = 0; run < RUNS_MOST && total < enough_seconds; run++) {
        double started = own_seconds();
        solve_curve(attempt);
        double passed = own_seconds() - started;
        least = fmin(least, passed);
        total += passed;
    }
    return least;
}

/** The largest relative error over the quantities shown in charts. */
static double largest_error(const struct contact_point *points, const struct contact_point *better, size_t count)
{
    double error = 0;
    for (size_t i = 0; i < count; i++)
        for (int q = 0; q < QUANTITY_COUNT; q++) {
            double exact = better[i].value[q], ratio = points[i].value[q] / exact;
            if ((quantity_rows[q].is & QUANTITY_BANDED) && exact > 0 && isfinite(ratio))
                error = fmax(error, fabs(ratio - 1));
        }
    return error;
}

/** Times a model on the report's loads at rising tolerances; the rows are stored in falling order. */
static enum status_code measure_model(struct benchmark *out, const struct surface_record *surface,
                                      const struct surface_task *asked, size_t m, struct status *status)
{
    static const double tolerance[BENCHMARK_STEPS] = {1e-13, 1e-10, 1e-6, 1e-2};
    const size_t step = (asked->load_count + LOADS_MOST - 1) / LOADS_MOST;
    struct contact_point *best = calloc(2 * (LOADS_MOST + 1), sizeof *best);
    if (!best)
        return status_memory(status);
    struct curve_attempt attempt = {.surface = surface, .asked = asked, .m = m, .spectrum = surface->spectrum};
    if (attempt.spectrum.count > HARMONICS_MOST) {
        attempt.spectrum.count = HARMONICS_MOST;
        attempt.spectrum.has_nyquist = false;
    }
    for (size_t i = 0; i < asked->load_count; i += step)
        attempt.loads[attempt.load_count++] = asked->loads[i];
    out->count += BENCHMARK_STEPS;
    for (int t = 0; t < BENCHMARK_STEPS && !attempt.failed; t++) {
        struct benchmark_row *row = &out->rows[out->count - 1 - (size_t)t];
        attempt.tolerance = tolerance[t];
        attempt.points = t == 0 ? best : best + LOADS_MOST + 1;
        *row = (struct benchmark_row){.model = m, .tolerance = tolerance[t], .seconds = time_of(&attempt)};
        row->evaluations = attempt.evaluations;
        row->error = largest_error(attempt.points, best, LOADS_MOST + 1);
    }
    free(best);
    return attempt.failed ? status_memory(status) : STATUS_OK;
}

enum status_code benchmark_measure(struct benchmark *out, const struct surface_record *surface,
                                   const struct surface_task *asked, struct status *status)
{
    enum status_code rc = STATUS_OK;
    *out = (struct benchmark){0};
    for (size_t m = 0; m < model_count && rc == STATUS_OK; m++)
        if (surface->curves[m].exists)
            rc = measure_model(out, surface, asked, m, status);
    return rc;
}
