/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A number of a surface and how far it may be from what more scans would give: by the scans' own scatter, by blocks of
 * a map's rows, or, of one scan, by simulated records. */
#ifndef ANALYSIS_ESTIMATE_H
#define ANALYSIS_ESTIMATE_H

#include "statistics/single_scan.h"

/** Coverage of every interval of the report. */
extern const double estimate_level;

/** Of ln value where `logarithmic` (all positive answers), else of the value itself (gamma). */
struct estimate {
    size_t count; /* scans, or blocks of a map's rows; 1: one scan; 0: not known, and the rest is NaN */
    double mean;
    double sd, s,
        degrees;       /* of a single scan; standard error of the mean; 0 degrees of freedom: by simulated records */
    double half_width; /* of the 95 % interval of the surface's mean; NaN: not known, or its ends are no doubles */
    double next_half_width; /* of that in which another scan lies; NaN: not known */
    double model_sd;        /* as mean: what the model itself may be off by, beside the scatter; 0: not counted in */
    double effective;       /* independent rows that the blocks are worth; else the scans' weights */
    bool logarithmic;
    bool share;         /* of a whole, as A/A_n is: no end lies above 1 */
    bool heterogeneous; /* one scan that is not the same along its length */
};

/** Not known. */
#define ESTIMATE_NONE                                                                                                  \
    {                                                                                                                  \
        .mean = NAN, .sd = NAN, .s = NAN, .degrees = NAN, .half_width = NAN, .next_half_width = NAN, .effective = NAN  \
    }
extern const struct estimate estimate_none;

enum {
    ESTIMATE_BLOCKS = 16,
    ESTIMATE_LEAST_EFFECTIVE = 4 /* fewer independent rows: the map is too small for its longest waves */
};
/** Of `count` scans in any order, of the weights given (NULL: 1 each), or of a map's `rows` in their order: of the
 * means over ESTIMATE_BLOCKS blocks of them (of the rows where there are fewer). Values as they are, not their
 * logarithms; one that is not finite (or not positive, of a logarithmic one): not known; one value: its mean alone.
 * Error: STATUS_MEMORY. */
MUST_CHECK enum status_code estimate_make(struct estimate *out, const double *value, const double *weight, size_t count,
                                          bool rows, bool logarithmic, struct status *status);

/** Of one scan that answers `value`. */
struct estimate estimate_single(double value, const struct single_scan *single, bool logarithmic);

/** The number itself: exp(mean) where logarithmic. */
double estimate_value(const struct estimate *estimate);
/** Is a half-width one: known, and more than rounding leaves of values that are the same in all scans? */
bool estimate_has_width(const struct estimate *estimate, double half_width);
/** Ends of the interval of the surface's value, low (0) and high (1), the model's own error counted in; NaN where not
 * known, and where it has no width. */
double estimate_end(const struct estimate *estimate, int side);
/** The same of another scan. */
double estimate_next_end(const struct estimate *estimate, int side);

#endif
