/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A measured areal map prepared for the direct solution, which needs a periodic surface without noise at the spacing.
 */
#ifndef DIRECT_MAP_H
#define DIRECT_MAP_H

#include "direct/direct_kernel.h"

/** Share of a square's points that may be missing. */
#define DIRECT_MAP_HOLES 0.5

/** Rows and columns of heights, and what is known of them. */
struct direct_map_def {
    size_t nx, ny;
    double dx_m, dy_m;
    bool periodic; /* the map closes on itself in both directions */
    double cutoff; /* of its low-pass, in spacings; 0: none */
    bool single;   /* solved in single precision (struct direct_grid) */
    bool noisy; /* short waves were found to be noise; else a low-pass was asked for, or no line is complete to tell */
};

/** Rows or columns of a map: `count` lines of `points` heights, `step` apart in a line and `next` from line to line. */
struct direct_map_lines {
    size_t count, next, points, step;
};
/** Those of ny rows of nx heights. */
struct direct_map_lines direct_map_lines(size_t nx, size_t ny, bool columns);

/** Conditions ny rows of nx heights (NaN: missing, and stays so) in place. The map is periodic if, over its rows and
 * over its columns, the mean square second difference across the join of their ends is at most 3 times that inside (as
 * in record_window_is_periodic() of one record). Where waves shorter than 6 spacings have more than 2 % of the mean
 * square slope, or this cannot be told, a Gaussian low-pass of ISO 16610-61 with that cut-off removes them; beyond its
 * edges the map is continued by its mirror image. A cut-off in `def` takes the place of that one; `as_measured`: else
 * no low-pass. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code direct_map_condition(double *height_m, struct direct_map_def *def, bool as_measured,
                                                 struct status *status);

enum { DIRECT_MAP_FACTOR = 5 }; /* the largest prime factor of the side of a square: fft_quick() */

/** Is a square of at most `most` points continued by its mirror image? Only a whole periodic map with an even number of
 * points a side is not. */
bool direct_map_mirrored(const struct direct_map_def *def, size_t most);

/** A square of heights that continues periodically, or beyond its edges as its mirror image. Owned: direct_map_free().
 */
struct direct_map {
    double *height_m; /* of ny rows of nx, as many */
    struct direct_grid grid;
    double cutoff; /* as in the definition */
};

/** Of a conditioned map the square of at most `most` points at the first corner: can it be solved? Error: STATUS_SCAN:
 * fewer than 8 points a side, spacings that differ by more than 1 %, more than half of the points missing. */
MUST_CHECK enum status_code direct_map_check(const double *height_m, const struct direct_map_def *def, size_t most,
                                             struct status *status);

/** Makes that square. Missing points take the height of the nearest one (of several the first in reading order),
 * smoothed like the map. A whole periodic map only loses its mean; any other square loses its least-squares plane and
 * is mirrored, so that it continues without a step. Errors: those of direct_map_check(), STATUS_MEMORY. */
MUST_CHECK enum status_code direct_map_make(struct direct_map *out, const double *height_m,
                                            const struct direct_map_def *def, size_t most, struct status *status);
void direct_map_free(struct direct_map *map);

/** Solutions that show the error of that of a map: of every second point; of a low-passed map of these after the same
 * low-pass again, which removes about as much; of the quarters of a mirrored map, each as a map of its own. */
enum direct_map_part {
    DIRECT_MAP_WHOLE,
    DIRECT_MAP_SECOND,
    DIRECT_MAP_WIDER,
    DIRECT_MAP_QUARTER,
    DIRECT_MAP_PARTS = DIRECT_MAP_QUARTER + 4
};
bool direct_map_has(const struct direct_map *map, enum direct_map_part part);
/** That part; also a quarter of a periodic map. Owned: direct_map_free(). Error: STATUS_MEMORY. */
MUST_CHECK enum status_code direct_map_take(struct direct_map *out, const struct direct_map *map,
                                            enum direct_map_part part, struct status *status);

#endif
