/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What accuracy costs in time: every model's curve at several tolerances, timed and held against the finest. */
#ifndef PLAN_BENCHMARK_H
#define PLAN_BENCHMARK_H

#include "members/surface.h"

/** A model's curve at a tolerance. */
struct benchmark_row {
    size_t model;
    double tolerance;
    uint64_t evaluations; /* of the law or of scales; the same on every machine */
    double seconds; /* of one core, least of several runs; without the strips or squares that it takes ratios of */
    double error;   /* largest relative error over the quantities and loads, against the finest */
};

enum { BENCHMARK_STEPS = 4, BENCHMARK_ROWS = 64 * BENCHMARK_STEPS };

/** All rows; a model's follow each other in the order of falling tolerance. */
struct benchmark {
    struct benchmark_row rows[BENCHMARK_ROWS];
    size_t count;
};

/** Runs the studies on a surface that has been through the models `asked`. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code benchmark_measure(struct benchmark *out, const struct surface_record *surface,
                                              const struct surface_task *asked, struct status *status);

#endif
