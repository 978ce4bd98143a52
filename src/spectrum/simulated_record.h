/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gaussian random records with the spectrum of a measured one: how much an answer would change had the scan been taken
 * at another place of the same surface. */
#ifndef SPECTRUM_SIMULATED_RECORD_H
#define SPECTRUM_SIMULATED_RECORD_H

#include "base/status.h"
#include <fftw3.h>
#include <stdbool.h>
#include <stddef.h>

enum {
    SIMULATED_RECORD_LONGER = 4,       /* records are cut from ones this much longer, of 1/(4L) as lowest frequency */
    SIMULATED_RECORD_LEAST_POINTS = 16 /* of which seven harmonics come */
};

/** A spectrum ready to draw from. Owned: simulated_record_free(). */
struct simulated_record {
    double *deviation_m; /* of the cosine and of the sine part of frequency k/(4L), index k = 0 ... 2N */
    size_t points;       /* N, of the measured and of each simulated record */
    double *record;      /* where records are drawn, one at a time */
    fftw_complex *wave;
};

/** Takes the spectral density of a record of `points` N >= 16 heights from its multitaper spectrum square_m2[n-1], n =
 * 1 ... ceil(N/2)-1, straight between harmonics in log-log, as it is at the first one down to 1/(4L): a law carried on
 * below the fit would put waves there that a scan with a roll-off does not have.
 * Errors: STATUS_SCAN when no square has power; STATUS_MEMORY. */
MUST_CHECK enum status_code simulated_record_prepare(struct simulated_record *out, const double *square_m2,
                                                     size_t points, struct status *status);
/** Will it find what it needs? Amplitudes in place of their squares answer the same; fewer than 16 heights never do. */
bool simulated_record_possible(const double *square_m2, size_t points);

/** Draws a record: cosine and sine parts of independent Gaussian size at the frequencies k/(4L), k = 1 ... 2N, summed
 * by an inverse transform of 4N, of which the first N heights are kept, their mean not taken out. The same seed gives
 * the same record whatever was drawn before (MT19937 of GSL). One thread at a time. Timmer & Koenig 1995, Astron.
 * Astrophys. 300, 707. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code simulated_record_draw(double *height_m, const struct simulated_record *spectrum,
                                                  unsigned long seed, struct status *status);

void simulated_record_free(struct simulated_record *spectrum);

#endif
