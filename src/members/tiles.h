/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The direct solution of a map, in squares, with its errors (transfer.h). */
#ifndef MEMBERS_TILES_H
#define MEMBERS_TILES_H

#include "base/threads.h"
#include "contact/transfer.h"
#include "direct/direct_map.h"
#include "scan/scan.h"

enum { TILES_SIDE = 512, TILES_MOST = 4 };

/** Owned: tiles_free(). */
struct tiles {
    double *height_m;           /* conditioned, row after row; NULL: no map */
    struct direct_map_def def;  /* of the whole map */
    size_t side, columns, rows; /* of a square, in points; squares that are solved, across and down */
    struct transfer *transfer;  /* NULL: not solved */
    struct status problem;      /* why not */
    uint64_t transforms[2];     /* cost of solving, elastic and with the hardness: pairs of transforms times points */
    double capped;              /* share of the solutions' time that those with the hardness took */
};
void tiles_free(struct tiles *tiles);

/** Takes over the heights of a conditioned map with equal spacings (within 1 %) and at least 32 points a side; leaves
 * other scans as they are. */
void tiles_take(struct tiles *out, struct scan *scan, const struct direct_map_def *def);

/** Two rough bodies: adds the heights of another map of the same spacing, beginning at a place drawn by hash; beyond
 * its ends the other map goes on around if it is periodic, else as its mirror image. Without such a map there are no
 * tiles. */
void tiles_pair(struct tiles *tiles, const struct tiles *other);

/** The largest share of missing points in a square that is solved. */
double tiles_missing(const struct tiles *tiles);
/** The squares' share of the map. */
double tiles_share(const struct tiles *tiles);

/** Approximate cost of the squares, in pairs of transforms times points; 0: no map. */
double tiles_cost(const struct tiles *tiles, bool capped);
/** The most that a report spends on maps, in these units, unless its scene names the models: about ten minutes of one
 * core. */
extern const double tiles_budget;
/** Reduces the squares to be solved until they cost at most `most`; false: even one costs more. */
bool tiles_fit(struct tiles *tiles, bool capped, double most);

/** Mean power of all these lines of a map of one spacing, its heights over their mean, each continued as its mirror
 * image where wanted (as of maps that are not periodic). Error: STATUS_MEMORY. */
MUST_CHECK enum status_code tiles_spectrum_along(struct spectrum *out, const struct scan *map,
                                                 struct direct_map_lines lines, bool mirrored, struct status *status);

/** Solves the squares, elastic and with hardness H/E' (INFINITY: elastic only), and the parts from which their error is
 * found. Without a solution `transfer` is NULL and `problem` says why. The result does not depend on the number of
 * threads. Errors: STATUS_INTERRUPTED, STATUS_MEMORY. */
MUST_CHECK enum status_code tiles_solve(struct tiles *tiles, double hardness, const struct threads *threads,
                                        struct status *status);

#endif
