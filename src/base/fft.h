/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fourier transforms by FFTW, whose planner only one thread may use at a time. */
#ifndef BASE_FFT_H
#define BASE_FFT_H

#include "base/status.h"

#include <fftw3.h>
#include <stddef.h>

/** Does work(context), which makes plans, while no other thread does. */
void fft_plan(void (*work)(void *context), void *context);
/** NULL does nothing. */
void fft_plan_free(fftw_plan plan);

/** A record and its transform, which share their memory: only one is valid at a time. */
struct fft_room {
    double *record;          /* n heights */
    fftw_complex *transform; /* n/2 + 1 */
};

/** Room for records of n; false: out of memory. Owned: fft_room_free(). */
MUST_CHECK bool fft_room_make(struct fft_room *out, size_t n);
void fft_room_free(struct fft_room *room);

/** The largest number up to `most` without prime factors above `factor`: other sizes take several times as long. */
size_t fft_quick(size_t most, size_t factor);

/** out[k] = sum in[j] exp(-2 pi i jk/n), k = 0 ... n/2. Both arrays from fftw_alloc or fft_room_make(), perhaps the
 * same; `in` is overwritten. False: out of memory. */
MUST_CHECK bool fft_forward(fftw_complex *out, double *in, size_t n);
/** The inverse times n, of even n also where in[0] and in[n/2] are complex: of their real parts. False: out of memory.
 */
MUST_CHECK bool fft_backward(double *out, fftw_complex *in, size_t n);

#endif
