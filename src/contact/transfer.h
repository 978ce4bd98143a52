/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Direct solutions of a map's squares carried over to all of the map and to any load, as a strip's are: their ratio to
 * corrected-persson of the same spectrum, at equal area (equations: direct transfer). */
#ifndef CONTACT_TRANSFER_H
#define CONTACT_TRANSFER_H

#include "contact/persson.h"
#include "contact/strip.h"

enum {
    TRANSFER_LADDER = STRIP_LOADS, /* loads to begin with */
    TRANSFER_LOADS = STRIP_KNOTS,  /* at most, where contact grows fast */
    TRANSFER_ERRORS = 5,           /* loads at which errors are known */
    TRANSFER_BEARING = 64,         /* areas of a bearing curve */
    TRANSFER_GRID = 640            /* at most, of an answer */
};

/** p/(E' g) of the ladder, g the root mean square gradient; ascending. */
extern const double transfer_ladder[TRANSFER_LADDER];
/** Loads p/E' below the hardness h = H/E' (INFINITY: none) for solutions with it: those of the ladder, and shares of
 * the hardness where it has none. Returns how many. */
size_t transfer_capped_loads(double load[TRANSFER_LOADS], double gradient, double hardness);

/** A contact. */
struct transfer_point {
    double load; /* p/E' */
    double area_ratio, separation_m, constriction_m;
};

/** Of a square: elastic, and with the hardness, at ascending loads; NaN where that tells nothing. */
struct transfer_square {
    struct spectrum spectrum; /* of its rows and columns */
    struct transfer_point elastic[TRANSFER_LOADS], capped[TRANSFER_LOADS];
    size_t elastic_count, capped_count;
    double bearing[TRANSFER_BEARING]; /* by transfer_bearing() */
};

/** Bearing curve: ln of the mean gap below the height that a share of the heights exceeds, at even steps of its logit.
 * Puts the heights in order. */
void transfer_bearing(double out[TRANSFER_BEARING], double *height_m, size_t count);

/** ln of area, gap and constriction length at rising loads. */
struct transfer_curve {
    size_t count;
    double ln_load[TRANSFER_GRID], value[TRANSFER_GRID][3];
};

/** What they amount to. Owned: transfer_free(). */
struct transfer {
    struct spectrum spectrum;       /* of the whole surface */
    struct transfer_curve curve[2]; /* elastic, with the hardness; count 0: none */
    struct transfer_errors {
        size_t count; /* loads, ascending */
        double ln_load[TRANSFER_ERRORS], value[TRANSFER_ERRORS][3];
    } error[2]; /* standard errors of the curves' values; NaN: not known */
};

/** Carries squares, of the same loads, over to the surface of out->spectrum: the means of ln ratios over the squares.
 * ln A never falls with load, ln l and ln gap never rise. Errors: STATUS_MODEL: nothing is common to the squares;
 * STATUS_MEMORY. */
MUST_CHECK enum status_code transfer_make(struct transfer *out, const struct transfer_square *squares, size_t count,
                                          double hardness, struct status *status);
void transfer_free(struct transfer *transfer);

/** The answer at p/E': straight in ln between the grid's loads, and below the first; false beyond the largest area. */
bool transfer_at(struct transfer_point *out, const struct transfer *transfer, bool plastic, double load);

/** Standard error of ln area (0), gap (1) or constriction (2) at a load, straight in ln p between those at which it is
 * known; NaN: it is not. */
double transfer_error(const struct transfer *transfer, bool plastic, int which, double load);

#endif
