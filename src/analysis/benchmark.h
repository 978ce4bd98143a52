/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What accuracy costs in time: the methods that could compute the report's numbers, each at several settings, timed and
 * held against an independent better result. */
#ifndef ANALYSIS_BENCHMARK_H
#define ANALYSIS_BENCHMARK_H

#include "analysis/surface.h"

struct direct_study;

enum benchmark_chart {
    BENCHMARK_INTEGRALS,
    BENCHMARK_DIRECT_AREA, /* against the direct solution, by quantity */
    BENCHMARK_DIRECT_GAP,
    BENCHMARK_DIRECT_ECR,
    BENCHMARK_CHARTS
};

/** One method at one setting. */
struct benchmark_row {
    char study[48];                /* what is computed, as in cost.csv */
    const struct model_row *model; /* whose integrals or curve; NULL: of no single model */
    const char *method;
    char setting[32];
    uint64_t evaluations; /* of the law or of scales; the same on every machine */
    double seconds;       /* least of several runs; of integrals, for 100 separations */
    double error;         /* largest relative error over the study's quantities and points */
    bool chosen;          /* the report's own numbers come from here */
    enum benchmark_chart chart;
    double mean;   /* against the direct solution: exp(mean |ln ratio|) - 1 over the loads, which is charted */
    char note[48]; /* what the row is besides; "": nothing */
};

/** All rows; a method's rows follow each other in the order of rising effort. Owned: benchmark_free(). */
struct benchmark {
    struct benchmark_row *rows;
    size_t count, capacity;
    double seconds; /* that the studies took together */
    double before;  /* that the run had taken when they began; 0: not known */
};

/** What is studied: one surface that has been through its models. */
struct benchmark_task {
    const struct surface_record *surface;
    const struct scene *scene;
    const struct plan *plan;
    const double *loads;
    size_t load_count;
    const struct direct_study *direct; /* of that surface; NULL: not solved directly */
};

/** Runs the studies for what the plan computes. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code benchmark_measure(struct benchmark *out, const struct benchmark_task *task,
                                              struct status *status);
void benchmark_free(struct benchmark *cost);

/** For the studies: adds a row (text of `setting` by format). Error: STATUS_MEMORY. */
MUST_CHECK enum status_code benchmark_add(struct benchmark *cost, const struct benchmark_row *row,
                                          struct status *status);

/** The studies: integrals of the statistical models; the tolerance of the curves. */
MUST_CHECK enum status_code benchmark_integrals(struct benchmark *cost, const struct benchmark_task *task,
                                                struct status *status);
MUST_CHECK enum status_code benchmark_curves(struct benchmark *cost, const struct benchmark_task *task,
                                             struct status *status);

/** What each model is off by on a surface solved directly, and the direct solution itself at less expense. */
MUST_CHECK enum status_code benchmark_direct(struct benchmark *cost, const struct benchmark_task *task,
                                             struct status *status);

/** Times `work(context)`: the least of at least two runs, more while they are short. */
double benchmark_time(void (*work)(void *context), void *context);

#endif
