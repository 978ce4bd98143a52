/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/benchmark.h"

#include "base/clock.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum status_code benchmark_add(struct benchmark *cost, const struct benchmark_row *row, struct status *status)
{
    if (cost->count == cost->capacity) {
        size_t capacity = cost->capacity ? 2 * cost->capacity : 64;
        struct benchmark_row *rows = realloc(cost->rows, capacity * sizeof *rows);
        if (!rows)
            return status_memory(status);
        cost->rows = rows;
        cost->capacity = capacity;
    }
    cost->rows[cost->count++] = *row;
    return STATUS_OK;
}

double benchmark_time(void (*work)(void *context), void *context)
{
    enum { RUNS_MOST = 12 };
    const double enough_seconds = 2e-3;
    double least = INFINITY, total = 0;
    for (int run = 0; run < 2 || (run < RUNS_MOST && total < enough_seconds); run++) {
        double started = clock_seconds();
        work(context);
        double passed = clock_seconds() - started;
        least = fmin(least, passed);
        total += passed;
    }
    return least;
}

enum status_code benchmark_measure(struct benchmark *out, const struct benchmark_task *task, struct status *status)
{
    double started = clock_seconds();
    *out = (struct benchmark){0};
    enum status_code rc = benchmark_direct(out, task, status);
    if (rc == STATUS_OK)
        rc = benchmark_integrals(out, task, status);
    if (rc == STATUS_OK)
        rc = benchmark_curves(out, task, status);
    out->seconds = clock_seconds() - started;
    return rc;
}

void benchmark_free(struct benchmark *cost)
{
    free(cost->rows);
    *cost = (struct benchmark){0};
}

const struct benchmark_row *benchmark_find(const struct benchmark *cost, const char *study, const char *method,
                                           const char *setting)
{
    for (size_t i = 0; i < cost->count; i++) {
        const struct benchmark_row *row = &cost->rows[i];
        if (strcmp(row->study, study) == 0 && strcmp(row->method, method) == 0 &&
            (setting ? strcmp(row->setting, setting) == 0 : row->chosen))
            return row;
    }
    return NULL;
}
