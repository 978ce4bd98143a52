/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surfaces solved by a team, each rank holding a slab of the grid and no more. */
#ifndef DIRECT_SHARED_H
#define DIRECT_SHARED_H

#include "direct/direct_ensemble.h"

/** One of an ensemble's surfaces on `times` n points a side: loads points and Sq, on every rank. A Gaussian surface is
 * made in slabs, each rank filling the modes of its own columns; heights with a given distribution have to be ranked
 * all at once and are made on the first rank, which holds some 60 bytes for each of its n x n points meanwhile. Errors:
 * those of surfaces and solutions, the same on every rank. */
MUST_CHECK enum status_code direct_shared_surface(struct direct_point *out, double *rms_m,
                                                  const struct direct_team *team, const struct direct_ensemble_def *def,
                                                  size_t seed, size_t times, struct status *status);

/** direct_ladder_of_heights(); height_m and touching are the first rank's (NULL on the others). */
MUST_CHECK enum status_code direct_shared_heights(struct direct_point *out, uint8_t *touching,
                                                  const struct direct_team *team, const double *height_m, size_t n,
                                                  double spacing_m, const struct direct_ladder_def *def,
                                                  struct status *status);

#endif
