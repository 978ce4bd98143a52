/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random surfaces by Hurst exponent and band of wavelengths. */
#ifndef TEST_RANDOM_SURFACE_H
#define TEST_RANDOM_SURFACE_H

#include "spectrum/spectrum.h"
#include <stdbool.h>

/** Row spectrum of a random surface: on a grid of side L = 1 its modes (i, j) have mean squares
 * v ~ r^(-2-2H) between r = `longest` and `shortest` and, with a plateau, as at `longest` down to r = 1; rms
 * gradient 1. A row's harmonic m has the sum over j. Returns the areal variance. */
double random_surface(struct spectrum *out, double hurst, double longest, double shortest, bool plateau);

#endif
