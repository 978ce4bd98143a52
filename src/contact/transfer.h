/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Direct solutions of squares of a map applied to the whole map and to any load, as those of strips are: by their ratio
 * to corrected-persson of the same spectrum at equal area (equations: direct transfer). */
#ifndef CONTACT_TRANSFER_H
#define CONTACT_TRANSFER_H

#include "contact/persson.h"
#include "contact/strip.h"

enum {
    TRANSFER_LADDER = STRIP_LOADS, /* loads to begin with */
    TRANSFER_LOADS = STRIP_KNOTS,  /* at most, with those added where contact grows fast */
    TRANSFER_ERRORS = 5,           /* loads with known errors */
    TRANSFER_BEARING = 64,         /* points of a bearing curve */
    TRANSFER_GRID = 640            /* points of a curve, at most */
};

/** p/(E' g) of the first loads, ascending; g is the rms gradient. */
extern const double transfer_ladder[TRANSFER_LADDER];
/** Loads p/E' below the hardness H/E' (INFINITY: none) for solutions with it: the first loads, and shares of the
 * hardness above them. Returns how many. */
size_t transfer_capped_loads(double load[TRANSFER_LOADS], double gradient, double hardness);

/** A contact. */
struct transfer_point {
    double load; /* p/E' */
    double area_ratio, separation_m, constriction_m;
};

/** Solutions of a square, elastic and with the hardness, at ascending loads; NaN where not usable. */
struct transfer_square {
    struct spectrum spectrum; /* of its rows and columns */
    struct transfer_point point[2][TRANSFER_LOADS];
    double bearing[TRANSFER_BEARING]; /* by transfer_bearing() */
};

struct transfer_squares {
    const struct transfer_square *square;
    size_t count, loads[2]; /* loads: of every square, elastic and with the hardness */
};

/** Bearing curve: ln of the mean gap below the height that a share of the heights exceeds, at even steps of logit of
 * the share. Sorts the heights. */
void transfer_bearing(double out[TRANSFER_BEARING], double *height_m, size_t count);

/** ln of area, gap and constriction length at rising loads. */
struct transfer_curve {
    size_t count;
    double ln_load[TRANSFER_GRID], value[TRANSFER_GRID][3];
};

/** The answer for the map. Owned: transfer_free(). */
struct transfer {
    struct spectrum spectrum;       /* of the whole surface */
    struct transfer_curve curve[2]; /* elastic, with the hardness; count 0: none */
    struct transfer_errors {
        size_t count; /* loads, ascending */
        double ln_load[TRANSFER_ERRORS], value[TRANSFER_ERRORS][3];
    } error[2]; /* standard errors of the curves' values; NaN: not known */
};

/** Applies the mean ln ratio of the squares to the surface of out->spectrum. ln A never
 * falls with load, ln l and ln gap never rise. Errors: STATUS_MODEL: a square has no usable load; STATUS_MEMORY. */
MUST_CHECK enum status_code transfer_make(struct transfer *out, const struct transfer_squares *squares, double hardness,
                                          struct status *status);
void transfer_free(struct transfer *transfer);

/** The answer at p/E', interpolated in ln, also below the first load; false beyond the largest area. */
bool transfer_at(struct transfer_point *out, const struct transfer *transfer, bool plastic, double load);

/** Standard error of ln area (0), gap (1) or constriction (2) at a load, interpolated in ln p; NaN: not known. */
double transfer_error(const struct transfer *transfer, bool plastic, int which, double load);

#endif
