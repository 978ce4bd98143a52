/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/simulated_record.h"

#include "base/fft.h"
#include "spectrum/log_bin.h"
#include "spectrum/multitaper.h"
#include <assert.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <math.h>
#include <pthread.h>
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
    size_t held = count < SLOPE_HARMONICS ? count : SLOPE_HARMONICS;
    size_t bins = log_bin_fill(bin, square_m2, held, 1, 1, NULL), used = 0;
    double x = 0, y = 0, xx = 0, xy = 0;
    for (size_t j = 0; j < bins && j < SLOPE_BINS; j++)
        if (isfinite(bin[j].y)) {
            bin[used++] = bin[j];
            x += bin[j].x;
            y += bin[j].y;
        }
    if (used < 2)
        return status_fail(status, STATUS_SCAN,
                           "the record has too few harmonics of any power to simulate others of it");
    x /= (double)used;
    y /= (double)used;
    for (size_t j = 0; j < used; j++) {
        xx += (bin[j].x - x) * (bin[j].x - x);
        xy += (bin[j].x - x) * (bin[j].y - y);
    }
    *out = (struct continuation){x, y, fmin(fmax(xy / xx, least_slope), most_slope)};
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

/** What is not as it has to be to draw from. */
static enum status_code check(struct continuation *below, const double *square_m2, size_t count, struct status *status)
{
    for (size_t i = 0; i < count; i++)
        if (!(square_m2[i] >= 0) || !isfinite(square_m2[i]))
            return status_fail(status, STATUS_SCAN,
                               "the squared amplitude of harmonic %zu is %g; it must be finite and "
                               "not negative",
                               i + 1, square_m2[i]);
    return continue_line(below, square_m2, count, status);
}

bool simulated_record_possible(const double *square_m2, size_t points)
{
    struct continuation below;
    struct status none = {0};
    return points >= SIMULATED_RECORD_LEAST_POINTS &&
           check(&below, square_m2, multitaper_count(points), &none) == STATUS_OK;
}

enum status_code simulated_record_prepare(struct simulated_record *out, const double *square_m2, size_t points,
                                          struct status *status)
{
    assert(points >= SIMULATED_RECORD_LEAST_POINTS);
    size_t count = multitaper_count(points), waves = points * SIMULATED_RECORD_LONGER / 2;
    struct continuation below;
    *out = (struct simulated_record){.points = points};
    if (check(&below, square_m2, count, status) != STATUS_OK)
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

enum { STREAMS = 512, STREAM_LEAST = 256, KEPT_MOST = 1 << 20 /* numbers: 8 MB */ };

/** Standard normal numbers of a seed, from its first on. Every surface's records take the same seeds, and drawing
 * costs more than all else that is done with a short record. */
static struct stream {
    double *deviate;
    size_t count;
} streams[STREAMS];
static size_t kept_count;                                    /* of all of them */
static pthread_rwlock_t keeper = PTHREAD_RWLOCK_INITIALIZER; /* many draw, one lengthens */

/** Makes a stream at least `count` long, if it is not and there is room. */
static void lengthen(struct stream *stream, unsigned long seed, size_t count)
{
    size_t size = STREAM_LEAST;
    if (stream->count >= count)
        return;
    while (size < count)
        size *= 2;
    if (kept_count - stream->count + size > KEPT_MOST)
        return;
    double *deviate = malloc(size * sizeof *deviate);
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    if (deviate && random) {
        gsl_rng_set(random, seed);
        for (size_t i = 0; i < size; i++)
            deviate[i] = gsl_ran_gaussian_ziggurat(random, 1);
        kept_count += size - stream->count;
        free(stream->deviate);
        *stream = (struct stream){deviate, size};
    } else {
        free(deviate);
    }
    gsl_rng_free(random);
}

/** Sizes of the waves by the stream; false: it is too short. */
static bool draw_from(const struct stream *stream, fftw_complex *wave, const struct simulated_record *spectrum,
                      size_t waves)
{
    pthread_rwlock_rdlock(&keeper);
    bool kept = stream->count >= 2 * waves;
    for (size_t k = 1; k <= waves && kept; k++)
        for (size_t part = 0; part < 2; part++)
            wave[k][part] = spectrum->deviation_m[k] * stream->deviate[2 * (k - 1) + part] / 2;
    pthread_rwlock_unlock(&keeper);
    return kept;
}

/** Sizes of the waves by a stream that is kept; false: it is not. */
static bool draw_kept(fftw_complex *wave, const struct simulated_record *spectrum, size_t waves, unsigned long seed)
{
    if (seed >= STREAMS || waves > KEPT_MOST / 2)
        return false;
    if (draw_from(&streams[seed], wave, spectrum, waves))
        return true;
    pthread_rwlock_wrlock(&keeper);
    lengthen(&streams[seed], seed, 2 * waves);
    pthread_rwlock_unlock(&keeper);
    return draw_from(&streams[seed], wave, spectrum, waves);
}

/** The same of any other. Error: STATUS_MEMORY. */
static enum status_code draw_anew(fftw_complex *wave, const struct simulated_record *spectrum, size_t waves,
                                  unsigned long seed, struct status *status)
{
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    if (!random)
        return status_memory(status);
    gsl_rng_set(random, seed);
    for (size_t k = 1; k <= waves; k++)
        for (int part = 0; part < 2; part++)
            wave[k][part] = gsl_ran_gaussian_ziggurat(random, spectrum->deviation_m[k]) / 2;
    gsl_rng_free(random);
    return STATUS_OK;
}

enum status_code simulated_record_draw(double *height_m, const struct simulated_record *spectrum, unsigned long seed,
                                       struct status *status)
{
    size_t longer = spectrum->points * SIMULATED_RECORD_LONGER, waves = longer / 2;
    fftw_complex *wave = spectrum->wave;
    if (!draw_kept(wave, spectrum, waves, seed) && draw_anew(wave, spectrum, waves, seed, status) != STATUS_OK)
        return status->code;
    wave[0][0] = wave[0][1] = 0;
    wave[waves][0] *= M_SQRT2; /* the Nyquist wave has half a band, no sine and no mirror image */
    wave[waves][1] = 0;
    fft_backward_often(spectrum->record, wave, longer);
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
