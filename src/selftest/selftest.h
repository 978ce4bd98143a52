/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Does this build compute correctly here? Numbers whose values are known from elsewhere (closed forms, printed figures
 * of other programs, evaluations of the same equations in 30 digits or by other methods) stand in selftest.csv, which
 * is installed with the program; here they are computed again. */
#ifndef SELFTEST_SELFTEST_H
#define SELFTEST_SELFTEST_H

#include "selftest/selftest_table.h"

/** Computes the number of one reference; NaN: nothing here computes it. Errors: those of what it tests. */
MUST_CHECK enum status_code selftest_value(double *value, const struct selftest_reference *reference,
                                           const struct selftest_table *table, struct status *status);

/** Error of one number as a share of its tolerance; infinite for one that is not finite. */
double selftest_error(const struct selftest_reference *reference, double value);

#endif
