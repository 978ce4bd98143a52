/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Missing points of a profile. */
#ifndef PROFILE_GAPS_H
#define PROFILE_GAPS_H

#include "profile/profile.h"

/** Cuts missing points (NaN) off the ends of profile->height_m, bridges those between by straight lines over x_m (NULL:
 * uniform), sets points, trimmed and bridged, and notes it. *first is the index the profile now starts at.
 * Errors: STATUS_SCAN: more than the share `most` of all points missing, or fewer than 3 left. */
MUST_CHECK enum status_code gaps_close(struct profile *profile, size_t *first, const double *x_m, double most,
                                       struct status *status);

#endif
