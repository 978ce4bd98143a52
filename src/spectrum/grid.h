/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Spectra of records of different lengths and spacings on one grid of wavelengths. */
#ifndef SPECTRUM_GRID_H
#define SPECTRUM_GRID_H

#include "spectrum/spectrum.h"

/** Puts `in` on the harmonics n = 1 ... count of a record of length_m: its power, spread evenly over the frequency band
 * of each of its harmonics (half a step to either side), is collected in the bands of the new ones, so that none is
 * lost or counted twice between them. `out` is owned: spectrum_free(). Error: STATUS_MEMORY. */
MUST_CHECK enum status_code grid_spectrum(struct spectrum *out, const struct spectrum *in, double length_m,
                                          size_t count, struct status *status);

/** Amplitudes add as squares: two rough surfaces in contact. `other` is put on the grid of `sum` first; where it has no
 * harmonics (above its Nyquist frequency, below its first) nothing is added. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code grid_add(struct spectrum *sum, const struct spectrum *other, struct status *status);

/** Averages `other` into `mean` of `so_far` spectra as powers. Records that are not alike are both put on the grid of
 * the shorter record and of the lower Nyquist frequency first. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code grid_average(struct spectrum *mean, const struct spectrum *other, size_t so_far,
                                         struct status *status);

#endif
