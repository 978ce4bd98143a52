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

void benchmark_free(struct benchmark *cost)
{
    free(cost->rows);
    *cost = (struct benchmark){0};
}
