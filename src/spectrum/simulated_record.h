/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gaussian random records with the spectrum of a measured one, to see how much an answer would change with a scan from
 * another place of the surface. */
#ifndef SPECTRUM_SIMULATED_RECORD_H
#define SPECTRUM_SIMULATED_RECORD_H

#include "base/fft.h"
#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>

enum {
    SIMULATED_RECORD_LONGER = 4,       /* records are cut from ones so many times as long; lowest frequency 1/(4L) */
    SIMULATED_RECORD_LEAST_POINTS = 16 /* which give seven harmonics */
};

/** A spectrum ready to draw from. Owned: simulated_record_free(). */
struct simulated_record {
    double *deviation_m;  /* standard deviation of cosine and sine part of frequency k/(4L), index k = 0 ... 2N */
    size_t points;        /* N, of the measured and of each simulated record */
    struct fft_room room; /* for one of the longer records */
};

/** Takes the spectral density of a record of `points` N >= 16 heights from its multitaper spectrum square_m2[n-1], n =
 * 1 ... ceil(N/2)-1, straight between harmonics in log-log and constant from the first down to 1/(4L): a law continued
 * there would add waves that a scan with a roll-off does not have.
 * Errors: STATUS_SCAN when no square has power; STATUS_MEMORY. */
MUST_CHECK enum status_code simulated_record_prepare(struct simulated_record *out, const double *square_m2,
                                                     size_t points, struct status *status);
/** Can simulated_record_prepare() succeed? Amplitudes will do in place of squares. Fewer than 16 heights never. */
bool simulated_record_possible(const double *square_m2, size_t points);

/** Draws a record: independent Gaussian cosine and sine parts at the frequencies k/(4L), k = 1 ... 2N, summed by an
 * inverse transform of 4N points, of which the first N heights are kept, with their mean. A seed gives the same record
 * whatever was drawn before (MT19937 of GSL). One thread at a time. Timmer & Koenig 1995, Astron. Astrophys. 300, 707.
 * Error: STATUS_MEMORY. */
MUST_CHECK enum status_code simulated_record_draw(double *height_m, const struct simulated_record *spectrum,
                                                  unsigned long seed, struct status *status);

void simulated_record_free(struct simulated_record *spectrum);

#endif
