/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Does this build compute correctly here? Numbers whose values are known from elsewhere (closed forms, printed figures
 * of other programs, evaluations of the same equations in 30 digits or by other methods), computed again from nothing
 * but what is compiled in: no file is read, and none written. */
#ifndef SELFTEST_SELFTEST_H
#define SELFTEST_SELFTEST_H

#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>

/** One number: of what, at which arguments, and what it has to be. */
struct selftest_reference {
    const char *what; /* a model, a gas, a parameter, ...: the group knows */
    const char *of;   /* which of its numbers */
    double at[3];     /* arguments; SI, or as `of` says */
    double expected;
    double tolerance; /* relative */
};

/** Numbers that one function computes together. */
struct selftest_group {
    const char *name;
    const char *source; /* where the expected values are from */
    const struct selftest_reference *references;
    size_t count;
    /** Computes all of them, values[i] of references[i]. Errors: those of what it tests. */
    enum status_code (*compute)(double *values, const struct selftest_reference *references, size_t count,
                                struct status *status);
};
extern const struct selftest_group *const selftest_groups[];
extern const size_t selftest_group_count;

/** How a group came out. Owned: selftest_result_free(). */
struct selftest_result {
    double *values; /* as many as the group has references */
    size_t wrong;   /* how many are off by more than their tolerance, or are no numbers; all where `problem` says why */
    double worst;   /* the largest error as a share of its tolerance; infinite where a number is none */
    size_t worst_place;
    struct status problem; /* STATUS_OK: it could be computed */
};

/** Runs a group. Error: STATUS_MEMORY; what else went wrong is in out->problem. */
MUST_CHECK enum status_code selftest_run(struct selftest_result *out, const struct selftest_group *group,
                                         struct status *status);
void selftest_result_free(struct selftest_result *result);

/** Error of one number as a share of its tolerance; infinite for one that is not finite. */
double selftest_error(const struct selftest_reference *reference, double value);

/** Has the model at this place of the table references here? */
bool selftest_covers_model(size_t model);

#endif
