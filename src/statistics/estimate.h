/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A number of a surface and how far it may be from what more scans would give: by the scans' own scatter, or, of one
 * scan, by simulated records. */
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
    double sd, s, degrees; /* of a single scan; standard error of the mean; its degrees of freedom */
    double
        half_width; /* by s, of the 95 % interval of the surface's mean; NaN: not known, or its ends are no doubles */
    double next_half_width; /* of that in which another scan lies; NaN: not known */
    double model_sd;        /* as mean: what the model itself may be off by, beside the scatter; 0: not counted in */
    double effective;       /* sum of the scans' weights */
    bool logarithmic;
    double bound[2]; /* no end lies below the first nor above the second: what physics allows; 0: anything */
};

/** Not known. */
#define ESTIMATE_NONE                                                                                                  \
    {                                                                                                                  \
        .mean = NAN, .sd = NAN, .s = NAN, .degrees = NAN, .half_width = NAN, .next_half_width = NAN, .effective = NAN  \
    }
extern const struct estimate estimate_none;

/** Of `count` scans in any order, of the weights given (NULL: 1 each). Values as they are, not their logarithms; one
 * that is not finite (or not positive, of a logarithmic one): not known; one value: its mean alone.
 * Error: STATUS_MEMORY. */
MUST_CHECK enum status_code estimate_make(struct estimate *out, const double *value, const double *weight, size_t count,
                                          bool logarithmic, struct status *status);

/** Of a positive value whose logarithm has the standard error s (NaN: not known) of so many degrees of freedom. */
struct estimate estimate_of_error(double value, double s, double degrees);

/** The number itself: exp(mean) where logarithmic. */
double estimate_value(const struct estimate *estimate);
/** Is a half-width one: known, and more than rounding leaves of values that are the same in all scans? */
bool estimate_has_width(const struct estimate *estimate, double half_width);
/** Ends of the interval of the surface's value, low (0) and high (1), the model's own error counted in: variances add,
 * v = s² + m², and have v²/(s^4/f) degrees of freedom, as m is known (Satterthwaite 1946, doi:10.2307/3002019). NaN
 * where not known, and where the scatter has no width. */
double estimate_end(const struct estimate *estimate, int side);
/** The same of another scan. */
double estimate_next_end(const struct estimate *estimate, int side);

#endif
