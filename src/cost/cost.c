#include "cost/cost.h"

#include "base/clock.h"
#include "results/cell.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum status_code cost_add(struct cost *cost, const struct cost_row *row, struct status *status)
{
    if (cost->count == cost->capacity) {
        size_t capacity = cost->capacity ? 2 * cost->capacity : 64;
        struct cost_row *rows = realloc(cost->rows, capacity * sizeof *rows);
        if (!rows)
            return status_memory(status);
        cost->rows = rows;
        cost->capacity = capacity;
    }
    cost->rows[cost->count++] = *row;
    return STATUS_OK;
}

double cost_time(void (*work)(void *context), void *context)
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

enum status_code cost_measure(struct cost *out, const struct results *results, struct status *status)
{
    struct surface_record baseline = {0};
    double started = clock_seconds();
    *out = (struct cost){0};
    enum status_code rc = spool_get(&baseline, results->spool, results->baseline, status);
    if (rc == STATUS_OK)
        rc = cost_integrals(out, results, &baseline, status);
    if (rc == STATUS_OK)
        rc = cost_curves(out, results, &baseline, status);
    surface_record_free(&baseline, false);
    out->seconds = clock_seconds() - started;
    return rc;
}

void cost_free(struct cost *cost)
{
    free(cost->rows);
    *cost = (struct cost){0};
}

const struct cost_row *cost_find(const struct cost *cost, const char *study, const char *method, const char *setting)
{
    for (size_t i = 0; i < cost->count; i++) {
        const struct cost_row *row = &cost->rows[i];
        if (strcmp(row->study, study) == 0 && strcmp(row->method, method) == 0 &&
            (setting ? strcmp(row->setting, setting) == 0 : row->chosen))
            return row;
    }
    return NULL;
}

enum status_code cost_write(const struct cost *cost, const char *directory, struct status *status)
{
    const struct cell_guard guard = {NULL, status};
    struct text csv = {0}, path = {0};
    text_add(&csv, "study,method,setting,evaluations,seconds,max_relative_error\n");
    for (size_t i = 0; i < cost->count; i++) {
        const struct cost_row *row = &cost->rows[i];
        text_add(&csv, "%s,%s,%s,%llu", row->study, row->method, row->setting, (unsigned long long)row->evaluations);
        cell_number(&csv, &guard, "seconds", row->seconds);
        cell_number(&csv, &guard, "max_relative_error", row->error);
        text_add_bytes(&csv, "\n", 1);
    }
    text_add(&path, "%s/data/cost.csv", directory);
    enum status_code rc = csv.failed || path.failed ? status_memory(status)
                                                    : text_write_file(text_string(&path), csv.data, csv.length, status);
    text_free(&csv);
    text_free(&path);
    return rc == STATUS_OK ? status->code : rc;
}
