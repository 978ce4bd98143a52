/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How sure the answer of one scan is: what scans of the same length at other places of the surface would answer, by
 * records simulated from its spectrum, and whether its own quarters differ more than such records' do. */
#ifndef STATISTICS_SINGLE_SCAN_H
#define STATISTICS_SINGLE_SCAN_H

#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>

enum {
    SINGLE_SCAN_RECORDS = 32, /* B: simulated records */
    SINGLE_SCAN_QUARTERS = 4
};

/** All of ln answer, or of the answer itself where it may be negative. */
struct single_scan {
    double s;            /* SD over the simulated records: the 68 % half-width */
    double half_width;   /* for 95 % */
    double quarters_sd;  /* of the scan's own quarters; 0 where they were not given */
    double simulated_sd; /* the largest of a simulated record's quarters */
    bool heterogeneous;  /* not the same along the scan: none of the simulated records' quarters differ as much */
};

/** s = SD of simulated[0 ... records-1]; half_width = 2.3 s (95 %: 2.3 for 1.96, as the spectrum itself is uncertain).
 * Quarters of the scan and of each simulated record, [record * 4 + quarter], each levelled and through the same
 * calculation: where the SD over the scan's four exceeds that of every simulated record, half_width = max(2.3 s,
 * 3.18 SD), 3.18 being Student's 97.5 % quantile at 3 degrees of freedom. quarter NULL: not looked at. records >= 2.
 * Error: STATUS_SCAN for a value that is not finite. */
MUST_CHECK enum status_code single_scan_uncertainty(struct single_scan *out, const double *simulated, size_t records,
                                                    const double quarter[SINGLE_SCAN_QUARTERS],
                                                    const double *simulated_quarter, struct status *status);

/** Half-width of 95 % of what deviates by s: 2.3 s. */
double single_scan_half_width(double s);

/** s at a load between those it was found at: straight in ln load, constant beyond the ends. ln_load ascends. */
double single_scan_s_at(double ln_load, const double *node_ln_load, const double *node_s, size_t nodes);

#endif
