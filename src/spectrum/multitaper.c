/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/multitaper.h"

#include "base/fft.h"
#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

size_t multitaper_count(size_t points)
{
    return (points + 1) / 2 - 1;
}

/** Differences less their mean at t = 1 ... N-1 of 2N values, else 0. */
static void whiten(double *out, const double *height_m, size_t points)
{
    double tilt = (height_m[points - 1] - height_m[0]) / (double)(points - 1);
    out[0] = 0;
    for (size_t t = 1; t < points; t++)
        out[t] = height_m[t] - height_m[t - 1] - tilt;
    for (size_t t = points; t < 2 * points; t++)
        out[t] = 0;
}

/** Y[m] of a real record's transform of 2N values, of which Y[0] ... Y[N] are held, for -2N < m < 4N: Y[-m] is the
 * conjugate of Y[m], and Y has the period 2N. */
static void transform_at(double out[2], const fftw_complex *transform, size_t points, long m)
{
    bool conjugate = m < 0;
    m = labs(m);
    if (m > (long)points) {
        m = 2 * (long)points - m;
        conjugate = (m < 0) == conjugate;
        m = labs(m);
    }
    out[0] = transform[m][0];
    out[1] = conjugate ? -transform[m][1] : transform[m][1];
}

/** S_n = sum_k |Y[2n-k] - Y[2n+k]|²/(2N)/K */
static double tapers_mean(const fftw_complex *transform, size_t points, size_t n)
{
    double sum = 0, below[2], above[2];
    for (long k = 1; k <= MULTITAPER_TAPERS; k++) {
        transform_at(below, transform, points, 2 * (long)n - k);
        transform_at(above, transform, points, 2 * (long)n + k);
        double real = below[0] - above[0], imaginary = below[1] - above[1];
        sum += real * real + imaginary * imaginary;
    }
    return sum / MULTITAPER_TAPERS / (2 * (double)points);
}

enum status_code multitaper_square(double *square_m2, const double *height_m, size_t points, struct status *status)
{
    assert(points >= MULTITAPER_LEAST_POINTS);
    for (size_t i = 0; i < points; i++)
        if (!isfinite(height_m[i]))
            return status_fail(status, STATUS_SCAN, "height %zu of %zu is not a finite number", i + 1, points);
    OWNED(fft_room_free) struct fft_room room = {0};
    if (!fft_room_make(&room, 2 * points))
        return status_memory(status);
    whiten(room.record, height_m, points);
    bool done = fft_forward(room.transform, room.record, 2 * points), finite = true;
    for (size_t n = 1; done && n <= multitaper_count(points); n++) {
        double whitening = 2 * sin(M_PI * (double)n / (double)points);
        square_m2[n - 1] = 4 * tapers_mean(room.transform, points, n) / ((double)points * whitening * whitening);
        finite = finite && isfinite(square_m2[n - 1]);
    }
    if (!done)
        return status_memory(status);
    if (!finite)
        return status_fail(status, STATUS_SCAN, "the heights are too large for a spectrum; check their unit");
    return STATUS_OK;
}

double multitaper_correlation(size_t apart)
{
    /* the formula for K = 5, which test_multitaper evaluates; the next is 9e-5 */
    static const double correlation[MULTITAPER_CORRELATED + 1] = {
        1,
        0.8238599422357856,
        0.6339629486143197,
        0.445835255958981,
        0.2606704473199282,
        0.08226464857234903,
        0.0024329340569576997,
        0.000586700376090461,
        0.0002039188844811861,
    };
    return apart <= MULTITAPER_CORRELATED ? correlation[apart] : 0;
}
