/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The linear Gaussian profile filter (ISO 16610-21). */
#ifndef PROFILE_FILTER_H
#define PROFILE_FILTER_H

#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>

/** Smooths `points` heights into smooth_m, which does not overlap them: weights exp(-pi (x/(a lambda))²), a = sqrt(ln
 * 2/pi), which let half of the amplitude of wavelength lambda = cutoff_m through, cut off where they fall below 1e-9 of
 * the largest (1.21 cutoff_m). Near the ends only the weights that lie within the record count, renormalised to the sum
 * 1: no point is cut off, and a constant passes unchanged up to both ends. By FFT, n log n, where more than a few
 * neighbours have a weight. Of a periodic record the end goes on at the beginning, with all weights. Errors:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code filter_gaussian(double *smooth_m, const double *height_m, size_t points, double spacing_m,
                                            double cutoff_m, bool periodic, struct status *status);

#endif
