/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Standard error of the answer of one scan, from records simulated from its spectrum and from how its quarters differ.
 */
#ifndef STATISTICS_SINGLE_SCAN_H
#define STATISTICS_SINGLE_SCAN_H

#include <stddef.h>

enum {
    SINGLE_SCAN_RECORDS = 8, /* simulated; more would add little beside the scatter of four quarters */
    SINGLE_SCAN_QUARTERS = 4,
    SINGLE_SCAN_DEGREES = 4 /* of freedom, of its standard error: measured (docs/validation.md) */
};

/** Standard error of the ln answer of one scan: s² = s_r² + s_Q²/2, with the standard deviations s_r over simulated
 * Gaussian records (scatter of the spectrum) and s_Q over the quarters, each levelled and solved alone (scatter of the
 * heights). Answers that are not finite are left out; s_Q is 0.5 if fewer than three quarters have one. NaN: fewer than
 * half of the records have one. */
double single_scan_s(const double *record, size_t records, const double *quarter, size_t quarters);

/** s at a load, linear in ln load between ascending nodes, constant beyond the ends. */
double single_scan_s_at(double ln_load, const double *node_ln_load, const double *node_s, size_t nodes);

#endif
