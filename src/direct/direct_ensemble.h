/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Direct solutions of several random surfaces with one spectrum, averaged; or of one map, with the solutions that show
 * its error. Q = mean over seeds on the coarse grid x Q_fine/Q_coarse of the first seed: seeds scatter by 5 to 20 %,
 * the error of the grid is 1 to 3 %, so that many coarse surfaces and one fine one tell more than a few fine ones. */
#ifndef DIRECT_ENSEMBLE_H
#define DIRECT_ENSEMBLE_H

#include "direct/direct_map.h"
#include "direct/direct_quantities.h"
#include "direct/direct_surface.h"

/** Least contact points, mirror images included, for a number (error of A with 112: 1.5 %, with 59: 2.8 %). */
enum { DIRECT_ENSEMBLE_POINTS = 100 };

struct direct_ensemble_def {
    struct direct_ladder_def ladder;
    const struct direct_map *map; /* only this map is solved; NULL: the surfaces below are made */
    double length_m;              /* L */
    size_t n;                     /* points a side, even; lambda_s/dx >= 6 and n >= 256 keep the errors below 1 % */
    size_t fine_times;            /* the first seed also on fine_times n points a side; 0 or 1: not */
    struct direct_recipe recipe;
    size_t seeds;     /* 1 ... seeds */
    unsigned threads; /* 0: one a processor. The result does not depend on it */
    void (*solved)(void *context,
                   double work); /* called after each surface made and each load solved, on its thread; NULL: not */
    void *solved_context;
};

/** Making a surface with given heights takes as long as solving so many loads (6 to 9 on 64 to 1024 points a side). */
extern const double direct_ensemble_making;

/** Sum of the work that `solved` is told: points times loads, and the making of surfaces with given heights. */
double direct_ensemble_work(const struct direct_ensemble_def *def);

/** A mean over seeds, corrected for the grid. */
struct direct_mean {
    double value; /* NaN: none */
    double
        standard_error; /* of the mean; NaN from one seed. Of a map: root of the sum of squares of what every second
                           point alone changes, what a wider low-pass changes, and the standard error over quarters */
    double fine_ratio;  /* correction for the grid; 1 without a fine grid */
};

/** At one load; no numbers where a seed or the map has fewer than DIRECT_ENSEMBLE_POINTS points in contact, or p̄ >= H.
 */
struct direct_ensemble_point {
    struct direct_mean mean[DIRECT_QUANTITIES];
};

/** Owned: direct_ensemble_free(). */
struct direct_ensemble {
    struct direct_ensemble_point *point; /* one a load */
    struct direct_point *seed_point;     /* seeds x loads, as solved on the coarse grid; of a map its parts' */
    size_t loads, seeds, ladders;        /* done; ladders: seeds and the finer grid, or parts of the map */
};

/** Solves the ensemble. Errors: those of surfaces and solutions, of the first task that failed; STATUS_INTERRUPTED. */
MUST_CHECK enum status_code direct_ensemble_run(struct direct_ensemble *out, const struct direct_ensemble_def *def,
                                                struct status *status);
void direct_ensemble_free(struct direct_ensemble *ensemble);

#endif
