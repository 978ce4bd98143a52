/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How sure the answer of one scan is: what scans of the same length at other places of the surface would answer, by
 * records simulated from its spectrum and by how its own quarters differ. */
#ifndef STATISTICS_SINGLE_SCAN_H
#define STATISTICS_SINGLE_SCAN_H

#include <stddef.h>

enum {
    SINGLE_SCAN_RECORDS = 8, /* simulated records; the quarters' scatter is known from four, so that more tell little */
    SINGLE_SCAN_QUARTERS = 4,
    SINGLE_SCAN_DEGREES = 4 /* of freedom, of its standard error: measured (docs/validation.md) */
};

/** Standard error of the ln answer of one scan: s² = s_r² + s_Q²/2, s_r the standard deviation over simulated Gaussian
 * records, which know the scatter of the spectrum, and s_Q that over the scan's quarters, each levelled and through the
 * same calculation alone, which know that of the heights. Answers that are not finite are left out; s_Q is 0.5 where
 * fewer than three quarters have one. NaN: fewer than half of the records have one. */
double single_scan_s(const double *record, size_t records, const double *quarter, size_t quarters);

/** s at a load between those it was found at: straight in ln load, constant beyond the ends. ln_load ascends. */
double single_scan_s_at(double ln_load, const double *node_ln_load, const double *node_s, size_t nodes);

#endif
