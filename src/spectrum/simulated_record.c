/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/simulated_record.h"

#include "base/fft.h"
#include "spectrum/log_bin.h"
#include "spectrum/multitaper.h"
#include <assert.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>

static const double least_slope = 0, most_slope = 2;
enum { SLOPE_BINS = 6, SLOPE_HARMONICS = 20 /* as many hold those bins: the next begins at 5 x 10^0.6 */ };

/** log10 amplitude = middle + slope (log10 wavelength - x), wavelengths in units of L. */
struct continuation {
    double x, middle, slope;
};

static enum status_code continue_line(struct continuation *out, const double *square_m2, size_t count,
                                      struct status *status)
{
    struct log_bin bin[LOG_BIN_MOST];
    double x[SLOPE_BINS], y[SLOPE_BINS], middle, slope, covariance[3], residual;
    size_t held = count < SLOPE_HARMONICS ? count : SLOPE_HARMONICS;
    size_t bins = log_bin_fill(bin, square_m2, held, 1, 1, NULL), used = 0;
    for (size_t j = 0; j < bins && j < SLOPE_BINS; j++)
        if (isfinite(bin[j].y)) {
            x[used] = bin[j].x;
            y[used++] = bin[j].y;
        }
    if (used < 2)
        return status_fail(status, STATUS_SCAN,
                           "the record has too few harmonics of any power to simulate others of it");
    gsl_fit_linear(x, 1, y, 1, used, &middle, &slope, &covariance[0], &covariance[1], &covariance[2], &residual);
    *out = (struct continuation){gsl_stats_mean(x, 1, used), gsl_stats_mean(y, 1, used),
                                 fmin(fmax(slope, least_slope), most_slope)};
    return STATUS_OK;
}

/** Squared amplitude at frequency n/L, n any number up to N/2: in a record of length L. */
static double square_at(double n, const double *square_m2, size_t count, const struct continuation *below)
{
    if (n < MULTITAPER_FIRST)
        return pow(10, 2 * (below->middle + below->slope * (-log10(n) - below->x)));
    if (n >= (double)count)
        return square_m2[count - 1];
    size_t before = (size_t)n;
    double low = square_m2[before - 1], high = square_m2[before];
    double share = n - (double)before;
    if (share == 0 || !(low > 0 && high > 0))
        return (1 - share) * low + share * high;
    return low * pow(high / low, log(n / (double)before) / log1p(1 / (double)before));
}

/** Checks the squares, and finds how they go on below the first harmonics. */
static enum status_code begin(struct continuation *below, const double *square_m2, size_t count, struct status *status)
{
    if (log_bin_check(square_m2, count, status) != STATUS_OK)
        return status->code;
    return continue_line(below, square_m2, count, status);
}

bool simulated_record_possible(const double *square_m2, size_t points)
{
    struct continuation below;
    struct status none = {0};
    return points >= SIMULATED_RECORD_LEAST_POINTS &&
           begin(&below, square_m2, multitaper_count(points), &none) == STATUS_OK;
}

enum status_code simulated_record_prepare(struct simulated_record *out, const double *square_m2, size_t points,
                                          struct status *status)
{
    assert(points >= SIMULATED_RECORD_LEAST_POINTS);
    size_t count = multitaper_count(points), waves = points * SIMULATED_RECORD_LONGER / 2;
    struct continuation below;
    *out = (struct simulated_record){.points = points};
    if (begin(&below, square_m2, count, status) != STATUS_OK)
        return status->code;
    out->deviation_m = calloc(waves + 1, sizeof *out->deviation_m);
    out->record = fftw_alloc_real(2 * waves);
    out->wave = fftw_alloc_complex(waves + 1);
    if (!out->deviation_m || !out->record || !out->wave) {
        simulated_record_free(out);
        return status_memory(status);
    }
    for (size_t k = 1; k <= waves; k++) {
        double square = square_at((double)k / SIMULATED_RECORD_LONGER, square_m2, count, &below);
        /* a square is the sum of the cosine's and the sine's; density is square L/2, so squares go as 1/L */
        out->deviation_m[k] = sqrt(square / (2 * SIMULATED_RECORD_LONGER));
    }
    return STATUS_OK;
}

enum status_code simulated_record_draw(double *height_m, const struct simulated_record *spectrum, unsigned long seed,
                                       struct status *status)
{
    size_t longer = spectrum->points * SIMULATED_RECORD_LONGER, waves = longer / 2;
    fftw_complex *wave = spectrum->wave;
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    if (!random)
        return status_memory(status);
    gsl_rng_set(random, seed);
    for (size_t k = 1; k <= waves; k++)
        for (int part = 0; part < 2; part++)
            wave[k][part] = gsl_ran_gaussian_ziggurat(random, spectrum->deviation_m[k]) / 2;
    gsl_rng_free(random);
    wave[0][0] = wave[0][1] = 0;
    wave[waves][0] *= M_SQRT2; /* the Nyquist wave has half a band, no sine and no mirror image */
    wave[waves][1] = 0;
    fft_backward(spectrum->record, wave, longer);
    for (size_t i = 0; i < spectrum->points; i++)
        height_m[i] = spectrum->record[i];
    return STATUS_OK;
}

void simulated_record_free(struct simulated_record *spectrum)
{
    free(spectrum->deviation_m);
    fftw_free(spectrum->record);
    fftw_free(spectrum->wave);
    *spectrum = (struct simulated_record){0};
}
