/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Levelling: takes the form out of the heights, by least squares of heights (not of distances). */
#ifndef PROFILE_LEVEL_H
#define PROFILE_LEVEL_H

#include "base/status.h"
#include <stddef.h>

/** What is taken out of the heights. */
enum level {
    LEVEL_NONE,
    LEVEL_MEAN,
    LEVEL_LINE,
    LEVEL_PARABOLA,
    LEVEL_CIRCLE, /* an arc */
    LEVEL_ROBUST, /* a line that outliers do not move */
    LEVEL_COUNT
};
extern const char *const level_names[LEVEL_COUNT]; /* as a scene spells them */

/** What a levelling took out. */
struct levelling {
    double tilt;     /* slope of the line, or of the parabola or arc at the middle of the record; 0 for none and mean */
    double radius_m; /* of the arc, signed: positive for a hollow, negative for a crown; INFINITY: it is a line */
    size_t outliers; /* robust line: points that got no weight */
};

/** Takes mean, line, parabola, arc or robust line out of `points` heights at x_m, which ascends (NULL: spacing_m
 * apart). circle: the arc of curvature k, z = c + x (2 s + k x)/(cos a + cos b), sin a = s, sin b = s + k x, by GSL's
 *          Levenberg-Marquardt; the record must span less than half a circle.
 *  robust: iterated least squares with Tukey's biweight (tuning 4.685, scale 1.4826 MAD; Holland & Welsch 1977,
 *          doi:10.1080/03610927708827533). Points of weight 0 are outliers.
 * Errors: STATUS_SCAN (no arc fits), STATUS_MEMORY. */
MUST_CHECK enum status_code level_remove(struct levelling *out, double *height_m, const double *x_m, size_t points,
                                         double spacing_m, enum level level, struct status *status);

#endif
