/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cost of accuracy: every model's curve at several tolerances, timed and compared with the finest. */
#ifndef PLAN_BENCHMARK_H
#define PLAN_BENCHMARK_H

#include "members/surface.h"

/** A model's curve at one tolerance. */
struct benchmark_row {
    size_t model;
    double tolerance;
    uint64_t evaluations; /* of the law or of scales */
    double seconds;       /* of one core, least of several runs; without solving strips or maps */
    double error;         /* largest relative error over quantities and loads, against the finest tolerance */
};

enum { BENCHMARK_STEPS = 4, BENCHMARK_ROWS = 64 * BENCHMARK_STEPS };

/** All rows; those of a model are adjacent, in the order of falling tolerance. */
struct benchmark {
    struct benchmark_row rows[BENCHMARK_ROWS];
    size_t count;
};

/** Times the models that have run on a surface. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code benchmark_measure(struct benchmark *out, const struct surface_record *surface,
                                              const struct surface_task *asked, struct status *status);

#endif
