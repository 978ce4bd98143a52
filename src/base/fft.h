/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fourier transforms of real records by FFTW, whose planner is the one part of it that threads have to take turns at.
 * Small sizes are planned once. */
#ifndef BASE_FFT_H
#define BASE_FFT_H

#include <fftw3.h>
#include <stdbool.h>
#include <stddef.h>

/** A record and its transform. */
struct fft_room {
    double *record;          /* n heights */
    fftw_complex *transform; /* n/2 + 1 */
    size_t most;             /* n there is room for */
};

/** From the first of these to the last fft_release(), of whatever threads, what large transforms of no more than `most`
 * points leave is kept for the next ones: rooms, which the system need not clear again, and plans, whose sines need not
 * be computed again. */
void fft_hold(size_t most);
void fft_release(void);

/** Room for records of n; false: out of memory. Owned: fft_room_free(). */
bool fft_room_make(struct fft_room *out, size_t n);
void fft_room_free(struct fft_room *room);

/** out[k] = sum in[j] exp(-2 pi i jk/n), k = 0 ... n/2. Both arrays from fftw_alloc or fft_room_make();
 * `in` may be overwritten. */
void fft_forward(fftw_complex *out, double *in, size_t n);
/** The inverse times n. `in` may be overwritten. */
void fft_backward(double *out, fftw_complex *in, size_t n);
/** The same, to be run many times for a size: it takes longer to plan, and a third of the time to run. */
void fft_backward_often(double *out, fftw_complex *in, size_t n);

#endif
