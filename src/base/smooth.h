/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Values on an even grid, smoothed. */
#ifndef BASE_SMOOTH_H
#define BASE_SMOOTH_H

#include <stdbool.h>
#include <stddef.h>

/** Replaces `count` values, `stride` apart, by local lines: at each the least-squares line through all of them,
 * weighted by a Gaussian of standard deviation `width` steps of the grid; a line stays as it is (Cleveland, J. Am.
 * Stat. Assoc. 74 (1979) 829, with his weights' shape changed). width 0: as they are. False: out of memory. */
bool smooth_lines(double *value, size_t count, size_t stride, double width);

#endif
