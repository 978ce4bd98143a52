/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Warnings about a profile: what makes its numbers doubtful where contact is concerned. */
#ifndef PROFILE_SANITY_H
#define PROFILE_SANITY_H

#include "profile/profile.h"

/** The step [m] of the digitiser, 0 where none is seen, in at least 2 heights, from the differences of neighbours with
 * the tilt off: less the one that is nearest to their mean, which is rounded as they are, so that it does not matter
 * whether the instrument levelled after it had digitised. The step is the smallest that is left, when at least 95 % of
 * the small ones (below 3.5 of it) are whole multiples of it to 15 % (instruments round once more when they print), and
 * there are enough of them (1 % of the points, 30 or more). */
double sanity_digitising(const double *height_m, size_t points);

/** Notes what is doubtful about a levelled profile that is not filtered yet:
 *  an Rq above the length, a slope above 10: units;
 *  rounding noise of the digitiser, variance q²/12 a point, so m4 = 6 (q²/12)/h^4, above 20 % of m4 (no lambda_s);
 *  noise: m4 falls by over 8 when every other point is left out (white noise: 16, a resolved profile: 1);
 *  a tip radius above the RMS radius of curvature, or above the shortest wavelength where that matters to m4;
 *  ends that differ by over 3 Rq; under 64 points. */
void sanity_check(struct profile *profile, double digit_m, const struct profile_options *options);

#endif
