/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Does this build compute correctly here? Numbers whose values are known from elsewhere (closed forms, printed figures
 * of other programs, evaluations of the same equations in 30 digits or by other methods) stand in selftest.csv, which
 * is installed with the program; here they are computed again. */
#ifndef SELFTEST_SELFTEST_H
#define SELFTEST_SELFTEST_H

#include "base/text.h"

/** One number: of what, at which arguments, and what it has to be. A line of selftest.csv. */
struct selftest_reference {
    const char *group;
    const char *of;       /* a model, a gas, a wave, ... */
    const char *quantity; /* which of its numbers */
    double at[3];         /* arguments, as the table says */
    double expected;
    double tolerance;   /* relative */
    const char *source; /* where the group's numbers are from: in its first line */
};

/** Inputs that take a list: how many numbers each has. */
enum { SELFTEST_PLATEAU = 512, SELFTEST_LAW = 60, SELFTEST_SCANS = 5 };

/** The table. Owned: selftest_table_free(). */
struct selftest_table {
    struct text text; /* of the file, which the references point into */
    struct selftest_reference *references;
    size_t count;
    double plateau_m[SELFTEST_PLATEAU]; /* heights of a profile worn flat on top, 1 um apart */
    double law_m2[SELFTEST_LAW];        /* squared amplitudes of a multitaper spectrum of 1 mm */
    double scans[SELFTEST_SCANS];
};

/** Reads the table. Errors: STATUS_IO with path and line: not there, damaged, cut off; STATUS_MEMORY. */
MUST_CHECK enum status_code selftest_table_read(struct selftest_table *out, const char *path, struct status *status);
void selftest_table_free(struct selftest_table *table);

/** Computes the number of one reference; NaN: nothing here computes it. Errors: those of what it tests. */
MUST_CHECK enum status_code selftest_value(double *value, const struct selftest_reference *reference,
                                           const struct selftest_table *table, struct status *status);

/** Error of one number as a share of its tolerance; infinite for one that is not finite. */
double selftest_error(const struct selftest_reference *reference, double value);

/* What computes the groups of selftest.csv; selftest_plain those that have no function of their own. */

/** As selftest_value(); leaves NaN what nothing here computes. */
typedef enum status_code selftest_compute(double *value, const struct selftest_reference *reference,
                                          const struct selftest_table *table, struct status *status);

selftest_compute selftest_softgauge, selftest_spectrum, selftest_plain, selftest_model, selftest_direct;

#endif
