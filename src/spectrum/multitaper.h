/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Squared amplitudes of harmonics by sine tapers of the first differences of a record: the spectrum to which a power
 * law is fitted. Differences whiten it and the tapers have small side lobes, so that long waves of a record that does
 * not close do not leak into short ones; the mean over five tapers scatters less than a periodogram. */
#ifndef SPECTRUM_MULTITAPER_H
#define SPECTRUM_MULTITAPER_H

#include "base/status.h"
#include <stddef.h>

enum {
    MULTITAPER_TAPERS = 5,      /* K: each harmonic's square is a mean of K independent ones */
    MULTITAPER_FIRST = 5,       /* first harmonic without the bias of the tapers at the longest waves */
    MULTITAPER_CORRELATED = 8,  /* harmonics further apart than this are independent */
    MULTITAPER_LEAST_POINTS = 3 /* which give one harmonic */
};

/** Harmonics below the Nyquist one: ceil(N/2) - 1. */
size_t multitaper_count(size_t points);

/** square_m2[n-1] = Delta_n² = 4 S_n/(N 4 sin²(pi n/N)), n = 1 ... multitaper_count(points), with
 *  S_n = (1/K) sum_k |sum_t sqrt(2/N) sin(pi k t/N) d_t exp(-2 pi i n t/N)|², k = 1 ... K, t = 1 ... N-1,
 *  d_t = z_t - z_{t-1} minus the mean of these differences, so that a line in the heights does not matter.
 * As sin is a difference of two exponentials, one transform of 2N points serves all tapers. Delta_n² is the mean over
 * records of the squared amplitude of harmonic n, f_n = n/(N h).
 * Riedel & Sidorenko 1995, doi:10.1109/78.365298 (sine tapers); Percival & Walden 1993, section 6.5 (prewhitening).
 * points >= 3. Errors: STATUS_SCAN for a height that is not finite or too large to square; STATUS_MEMORY. */
MUST_CHECK enum status_code multitaper_square(double *square_m2, const double *height_m, size_t points,
                                              struct status *status);

/** Correlation of the squares of two harmonics `apart` from each other in a white Gaussian record of many points:
 *  (1/K) sum_{k,l} |integral_0^1 2 sin(pi k t) sin(pi l t) exp(2 pi i m t) dt|², 0 beyond MULTITAPER_CORRELATED. */
double multitaper_correlation(size_t apart);

#endif
