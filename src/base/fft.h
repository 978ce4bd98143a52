/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fourier transforms of real records by FFTW, whose planner is the one part of it that threads have to take turns at.
 * Small sizes are planned once. */
#ifndef BASE_FFT_H
#define BASE_FFT_H

#include <fftw3.h>
#include <stddef.h>

/** out[k] = sum in[j] exp(-2 pi i jk/n), k = 0 ... n/2. Both arrays from fftw_alloc; `in` may be overwritten. */
void fft_forward(fftw_complex *out, double *in, size_t n);
/** The inverse times n. `in` may be overwritten. */
void fft_backward(double *out, fftw_complex *in, size_t n);
/** The same, to be run many times for a size: it takes longer to plan, and a third of the time to run. */
void fft_backward_often(double *out, fftw_complex *in, size_t n);

#endif
