/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What accuracy costs in time: the tolerance of the report's curves, and the rules for the integrals of the statistical
 * models (thesis 4.25, 4.26, 4.43) at several settings, timed and held against the finest. */
#ifndef PLAN_BENCHMARK_H
#define PLAN_BENCHMARK_H

#include "members/surface.h"

/** One method at one setting. */
struct benchmark_row {
    char study[48];                /* what is computed, as in cost.csv */
    const struct model_row *model; /* whose integrals; NULL: the curves of all models */
    const char *method;
    double setting;       /* sub-intervals, or a relative tolerance */
    uint64_t evaluations; /* of the law or of scales; the same on every machine */
    double seconds;       /* of one core, least of several runs; of integrals, for 100 separations */
    double error;         /* largest relative error over the study's quantities and points */
};

enum { BENCHMARK_ROWS = 64 };

/** All rows; a method's rows follow each other in the order of rising effort. */
struct benchmark {
    struct benchmark_row rows[BENCHMARK_ROWS];
    size_t count;
    double before; /* that the run had taken to its curves; 0: not known */
};

/** Runs the studies on a surface that has been through the models `asked`. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code benchmark_measure(struct benchmark *out, const struct surface_record *surface,
                                              const struct surface_task *asked, struct status *status);

#endif
