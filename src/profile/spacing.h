/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Positions: uniform, rounded or uneven. */
#ifndef PROFILE_SPACING_H
#define PROFILE_SPACING_H

#include "profile/profile.h"

struct spacing {
    enum profile_spacing grid;
    double step_m;
    bool nominal; /* step_m is the header's */
};

/** How the positions deviate from a uniform grid, and the step of that grid. Rounded means: steps of few kinds, and no
 * point further off its place than the digit they are rounded to. */
struct spacing spacing_judge(const struct scan *scan);

/** Steffen's monotone interpolation of z over x to `points` positions x[0] + i spacing. Errors: STATUS_MEMORY. */
MUST_CHECK enum status_code spacing_resample(double *out_m, const double *x_m, const double *z_m, size_t points,
                                             double spacing_m, struct status *status);

#endif
