/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "plan/benchmark.h"

#include "base/clock.h"
#include <math.h>
#include <stdlib.h>

enum {
    HARMONICS_MOST = 100000, /* enough to show the cost of a longer scan too */
    LOADS_MOST = 400         /* of more only every second, third, ... */
};

/** Times a model's curve: the least of several runs if they are short. */
static enum status_code time_model(struct benchmark_row *row, struct contact_point *points,
                                   const struct model_task *task, struct status *status)
{
    enum { RUNS_MOST = 12 };
    const double enough_seconds = 5e-4;
    double total = 0;
    row->seconds = INFINITY;
    for (int run = 0; run < RUNS_MOST && total < enough_seconds; run++) {
        struct model_curve curve = {.points = points};
        const double started = clock_own_seconds();
        if (model_run(&curve, model_rows[row->model], task, status) != STATUS_OK)
            return status->code;
        const double passed = clock_own_seconds() - started;
        row->seconds = fmin(row->seconds, passed);
        row->evaluations = curve.evaluations;
        total += passed;
    }
    return STATUS_OK;
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
    struct spectrum spectrum = surface->spectrum;
    struct model_task task = surface_model_task(surface, asked);
    double loads[LOADS_MOST];
    size_t count = 0;
    OWNED(memory_free) struct contact_point *best = calloc(2 * (LOADS_MOST + 1), sizeof *best);
    struct contact_point *points = best;
    enum status_code rc = best ? STATUS_OK : status_memory(status);
    if (spectrum.count > HARMONICS_MOST) {
        spectrum.count = HARMONICS_MOST;
        spectrum.has_nyquist = false;
    }
    for (size_t i = 0; i < asked->load_count; i += step)
        loads[count++] = asked->loads[i];
    task.spectrum = &spectrum;
    task = model_task_at(&task, loads, count);
    out->count += BENCHMARK_STEPS;
    for (int t = 0; t < BENCHMARK_STEPS && rc == STATUS_OK; t++, points = best + LOADS_MOST + 1) {
        struct benchmark_row *row = &out->rows[out->count - 1 - (size_t)t];
        *row = (struct benchmark_row){.model = m, .tolerance = tolerance[t]};
        task.tolerance = tolerance[t];
        rc = time_model(row, points, &task, status);
        row->error = largest_error(points, best, LOADS_MOST + 1);
    }
    return rc;
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
