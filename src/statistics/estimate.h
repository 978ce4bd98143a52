/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An estimate of a surface's number with its interval: from the scatter of its scans or, for one scan, from simulated
 * records. */
#ifndef STATISTICS_ESTIMATE_H
#define STATISTICS_ESTIMATE_H

#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>

/** Coverage of every interval of the report. */
extern const double estimate_level;

/** Of ln value where `logarithmic` (all positive answers), else of the value itself (gamma). */
struct estimate {
    size_t count; /* scans; 1: one scan, or a map; 0: not known, and the rest is NaN */
    double mean;
    double sd, s, degrees;  /* standard deviation of one scan; standard error of the mean; degrees of freedom */
    double half_width;      /* of the 95 % interval of the mean, from s; NaN: not known, or out of range */
    double next_half_width; /* of the interval that holds one more scan; NaN: not known */
    double model_sd;        /* standard error of the model, on the scale of the mean; 0: not counted */
    double effective;       /* sum of the weights */
    bool logarithmic;
    double bound[2]; /* physical limits of the ends; 0: none */
};

/** Not known. */
extern const struct estimate estimate_none;

/** From `count` scans in any order, with weights (NULL: 1 each). Values, not logarithms; if one is not finite (or not
 * positive, where logarithmic) the estimate is not known; a single value gives its mean alone. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code estimate_make(struct estimate *out, const double *value, const double *weight, size_t count,
                                          bool logarithmic, struct status *status);

/** From a positive value whose logarithm has the standard error s (NaN: not known) with these degrees of freedom. */
struct estimate estimate_of_error(double value, double s, double degrees);

/** A value within {least, most}; 0: no such limit. NaN stays. */
double estimate_within(double value, const double bound[2]);
/** The number itself: exp(mean) where logarithmic. */
double estimate_value(const struct estimate *estimate);
/** Low (0) or high (1) end of the interval of the surface's value, with the error of the model: v = s² + m², with
 * v²/(s^4/f) degrees of freedom, as m is known (Satterthwaite 1946, doi:10.2307/3002019). NaN: not known, or no
 * scatter. */
double estimate_end(const struct estimate *estimate, int side);
/** The same for one more scan. */
double estimate_next_end(const struct estimate *estimate, int side);

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

/** s at a load, linear in ln load between the ascending nodes where it is not NaN, constant beyond the ends. */
double single_scan_s_at(double ln_load, const double *node_ln_load, const double *node_s, size_t nodes);

#endif
