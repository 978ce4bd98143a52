/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Direct solutions of several surfaces with one spectrum: what one random surface scatters by, averaged out; or of one
 * map, with the solutions that tell its error.
 *
 * Q = mean over seeds on the coarse grid x Q_fine/Q_coarse of the first seed: seeds scatter by 5 to 20 %, the grid by 1
 * to 3 %, so many coarse surfaces and one fine one are worth more than a few fine ones.
 */
#ifndef DIRECT_ENSEMBLE_H
#define DIRECT_ENSEMBLE_H

#include "direct/direct_ladder.h"
#include "direct/direct_map.h"
#include "direct/direct_surface.h"

/** Contact points of what repeats below which a grid gives no number (112: A off by 1.5 %, 59: 2.8 %). */
enum { DIRECT_ENSEMBLE_POINTS = 100 };

struct direct_ensemble_def {
    struct direct_ladder_def ladder;
    const struct direct_map *map; /* this alone is solved; NULL: the surfaces that follow are made */
    double length_m;              /* L */
    size_t n;                     /* points a side, even; lambda_s/dx >= 6 and n >= 256 keep the errors below 1 % */
    size_t fine_times;            /* the first seed also on fine_times n points a side; 0 or 1: not */
    struct direct_recipe recipe;
    size_t seeds;     /* 1 ... seeds */
    unsigned threads; /* 0: one a processor. The result does not depend on it */
    void (*solved)(void *context,
                   double work); /* told of each surface made and each load solved, on its thread; NULL: nobody is */
    void *solved_context;
};

/** How many loads take as long to solve as a surface with given heights to make (6 to 9 on 64 to 1024 points a side).
 */
extern const double direct_ensemble_making;

/** What `solved` is told in all: points times loads, and of surfaces with given heights what they take to make. */
double direct_ensemble_work(const struct direct_ensemble_def *def);

/** A mean over seeds, corrected for the grid. */
struct direct_mean {
    double value; /* NaN: none */
    double
        standard_error; /* of the mean; NaN from one seed. Of a map: root of the sum of squares of what every second
                           point alone changes, what a wider low-pass changes, and the standard error over quarters */
    double fine_ratio;  /* by which the grid has been corrected, 1 without a fine one */
};

/** At one load; without numbers where some seed, or the map, has fewer than DIRECT_ENSEMBLE_POINTS points in contact,
 * or p̄ >= H. */
struct direct_ensemble_point {
    struct direct_mean mean[DIRECT_QUANTITIES];
};

/** Owned: direct_ensemble_free(). */
struct direct_ensemble {
    struct direct_ensemble_point *point; /* one a load */
    struct direct_point *seed_point;     /* seeds x loads, as solved on the coarse grid; of a map its parts' */
    size_t loads, seeds, ladders;        /* done; ladders with the finer grid, or the parts of a map */
};

/** Solves the ensemble. Errors: those of surfaces and solutions, of the first task that failed; STATUS_INTERRUPTED. */
MUST_CHECK enum status_code direct_ensemble_run(struct direct_ensemble *out, const struct direct_ensemble_def *def,
                                                struct status *status);
void direct_ensemble_free(struct direct_ensemble *ensemble);

#endif
