/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Student's intervals for the mean over scans, also over scans cut to subrecords. Values are logarithms of positive
 * answers (area, resistance), or answers that may be zero or negative (separation). */
#ifndef STATISTICS_INTERVAL_H
#define STATISTICS_INTERVAL_H

#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>

struct interval {
    size_t count; /* values it came from */
    double mean;
    double sd;        /* of values of weight 1 */
    double s;         /* standard error of the mean */
    double degrees;   /* of freedom */
    double t;         /* Student's quantile at (1 + level)/2 */
    double low, high; /* mean -+ t s */
    double effective; /* sum of the weights */
};

/** One value per scan, in any order (they are summed in ascending order).
 *  mean = sum w y/sum w, sd² = sum w (y - mean)²/(M-1), s = sd/sqrt(sum w), M-1 degrees of freedom.
 * A scan of w subrecords weighs w: its value is the mean over them; weight NULL: 1 each. Student 1908,
 * doi:10.1093/biomet/6.1.1. 0 < level < 1, at least 2 values, all finite, and weights above 0. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code interval_scans(struct interval *out, const double *value, const double *weight,
                                           size_t count, double level, struct status *status);

/** Half-width of the interval about the mean that holds one more scan of weight 1: t sqrt(sd² + s²). */
double interval_next_half_width(const struct interval *interval);

/** (1 + level)/2 quantile of Student's t. degrees > 0, not always whole. */
double interval_quantile(double level, double degrees);

/** Number of subrecords of a scan, as long as the shortest scan: floor(points/shortest), spread evenly. */
size_t interval_subrecords(size_t points, size_t shortest);
/** First point of subrecord 0 ... subrecords-1, of `shortest` points. */
size_t interval_subrecord_first(size_t points, size_t shortest, size_t subrecord);

#endif
