/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A measured areal map made ready for the direct solution, which needs a periodic surface without noise at the spacing.
 */
#ifndef DIRECT_MAP_H
#define DIRECT_MAP_H

#include "direct/direct_kernel.h"

/** Rows and columns of heights, and what they were found to be. */
struct direct_map_def {
    size_t nx, ny;
    double dx_m, dy_m;
    bool periodic; /* the map closes on itself in both directions */
    double cutoff; /* of the low-pass that it has had, in spacings; 0: none */
    bool single;   /* solved in single precision (struct direct_grid) */
};

/** Rows or columns of a map: `count` lines of `points` heights that are `step` apart, the first ones `next`. */
struct direct_map_lines {
    size_t count, next, points, step;
};
/** Those of ny rows of nx heights. */
struct direct_map_lines direct_map_lines(size_t nx, size_t ny, bool columns);

/** Conditions ny rows of nx heights (NaN: missing, and stays so) in place. The map is periodic if over
 * its rows, and over its columns, the mean square second difference across the join of their ends is at most 3 times
 * that inside: record_window_is_periodic() asks the same of one record. Where more than 2 % of their mean square slope
 * is shorter than 6 spacings, or nothing tells, a Gaussian low-pass of ISO 16610-61 with that cut-off takes it out;
 * beyond its edges a map goes on as its mirror image. `as_measured`: none does. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code direct_map_condition(double *height_m, struct direct_map_def *def, bool as_measured,
                                                 struct status *status);

enum { DIRECT_MAP_FACTOR = 5 }; /* the largest prime factor of the side of a square: fft_quick() */

/** Whether a square of at most `most` points goes on as its mirror image: all but the whole of a periodic map of which
 * every second point closes too. */
bool direct_map_mirrored(const struct direct_map_def *def, size_t most);

/** A square of heights that continues periodically, or beyond its edges as its mirror image. Owned: direct_map_free().
 */
struct direct_map {
    double *height_m; /* of ny rows of nx, as many */
    struct direct_grid grid;
    double cutoff; /* as in the definition */
};

/** From a conditioned map: the square of at most `most` points at the first corner; missing points take the height of
 * the nearest one (the first in reading order of several), smoothed like the map. The whole of a periodic map stays as
 * it is, its mean off; of any other the least-squares plane comes off, and it is mirrored, so that it continues
 * without a step. Errors: STATUS_SCAN: fewer than 8 points a side, spacings that differ by more than 1 %, or
 * more than half the points missing; STATUS_MEMORY. */
MUST_CHECK enum status_code direct_map_make(struct direct_map *out, const double *height_m,
                                            const struct direct_map_def *def, size_t most, struct status *status);
void direct_map_free(struct direct_map *map);

/** What tells the error of a map's solution: every second point; these after the same low-pass once more, which takes
 * about as much as it did, of a map that has had one; and the quarters of a mirrored map, each a map of its own. */
enum direct_map_part {
    DIRECT_MAP_WHOLE,
    DIRECT_MAP_SECOND,
    DIRECT_MAP_WIDER,
    DIRECT_MAP_QUARTER,
    DIRECT_MAP_PARTS = DIRECT_MAP_QUARTER + 4
};
bool direct_map_has(const struct direct_map *map, enum direct_map_part part);
/** Takes that part, or a quarter of a periodic map. Owned: direct_map_free(). Error: STATUS_MEMORY. */
MUST_CHECK enum status_code direct_map_take(struct direct_map *out, const struct direct_map *map,
                                            enum direct_map_part part, struct status *status);

#endif
