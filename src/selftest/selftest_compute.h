/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What computes the groups of selftest.csv; selftest_plain those that have no function of their own. Private to
 * src/selftest. */
#ifndef SELFTEST_SELFTEST_COMPUTE_H
#define SELFTEST_SELFTEST_COMPUTE_H

#include "selftest/selftest.h"

/** Computes the number of one reference. Errors: those of what it tests; selftest_unknown(). */
typedef enum status_code selftest_compute(double *value, const struct selftest_reference *reference,
                                          const struct selftest_table *table, struct status *status);

selftest_compute selftest_softgauge, selftest_spectrum, selftest_plain, selftest_model, selftest_direct;

/** STATUS_IO: the table asks for something that is not computed here. */
enum status_code selftest_unknown(const struct selftest_reference *reference, struct status *status);

#endif
