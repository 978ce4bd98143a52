/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A measured areal map made ready for the direct solution, which needs a periodic surface without noise at the spacing.
 */
#ifndef DIRECT_MAP_H
#define DIRECT_MAP_H

#include "base/status.h"
#include <stddef.h>

/** A square of heights that continues periodically. Owned: direct_map_free(). */
struct direct_map {
    double *height_m; /* n x n */
    size_t n;         /* twice the square taken from the map */
    double spacing_m;
    double rms_m;  /* about its mean */
    size_t filled; /* missing points that took their nearest neighbour's height */
};

/** From `ny` rows of `nx` heights (NaN: missing): the square of at most `most` points at the first corner; missing
 * points take the height of the nearest one (the first in reading order of several); the least-squares plane off;
 * mirrored to 2N x 2N, so that it continues without a step; Gaussian low-pass of ISO 16610-61 with the cut-off `cutoff`
 * spacings (0: none). Errors: STATUS_SCAN: fewer than 8 points a side, spacings that differ by more than 1 %, or more
 * than half the points missing; STATUS_MEMORY. */
MUST_CHECK enum status_code direct_map_make(struct direct_map *out, const double *height_m, size_t nx, size_t ny,
                                            double dx_m, double dy_m, size_t most, double cutoff,
                                            struct status *status);
void direct_map_free(struct direct_map *map);

#endif
