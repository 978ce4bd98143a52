/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/simulated_record.h"

#include "base/fft.h"
#include "spectrum/multitaper.h"
#include <assert.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdlib.h>

/** Squared amplitude at frequency n/L, n any number up to N/2, in a record of length L. */
static double square_at(double n, const double *square_m2, size_t count)
{
    if (n <= 1)
        return square_m2[0];
    if (n >= (double)count)
        return square_m2[count - 1];
    size_t before = (size_t)n;
    double low = square_m2[before - 1], high = square_m2[before];
    double share = n - (double)before;
    if (share == 0 || !(low > 0 && high > 0))
        return (1 - share) * low + share * high;
    return low * pow(high / low, log(n / (double)before) / log1p(1 / (double)before));
}

bool simulated_record_possible(const double *square_m2, size_t points)
{
    double most = 0;
    for (size_t n = 1; n <= multitaper_count(points); n++)
        most = fmax(most, square_m2[n - 1]);
    return points >= SIMULATED_RECORD_LEAST_POINTS && most > 0;
}

enum status_code simulated_record_prepare(struct simulated_record *out, const double *square_m2, size_t points,
                                          struct status *status)
{
    assert(points >= SIMULATED_RECORD_LEAST_POINTS);
    size_t count = multitaper_count(points), waves = points * SIMULATED_RECORD_LONGER / 2;
    *out = (struct simulated_record){.points = points};
    if (!simulated_record_possible(square_m2, points))
        return status_fail(status, STATUS_SCAN, "the record has no power to simulate others of it");
    out->deviation_m = calloc(waves + 1, sizeof *out->deviation_m);
    if (!out->deviation_m || !fft_room_make(&out->room, 2 * waves)) {
        simulated_record_free(out);
        return status_memory(status);
    }
    for (size_t k = 1; k <= waves; k++) {
        double square = square_at((double)k / SIMULATED_RECORD_LONGER, square_m2, count);
        /* cosine and sine share the square; density is square L/2, so that the square falls as 1/L */
        out->deviation_m[k] = sqrt(square / (2 * SIMULATED_RECORD_LONGER));
    }
    return STATUS_OK;
}

enum status_code simulated_record_draw(double *height_m, const struct simulated_record *spectrum, unsigned long seed,
                                       struct status *status)
{
    size_t longer = spectrum->points * SIMULATED_RECORD_LONGER, waves = longer / 2;
    fftw_complex *wave = spectrum->room.transform;
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
    if (!fft_backward(spectrum->room.record, wave, longer))
        return status_memory(status);
    for (size_t i = 0; i < spectrum->points; i++)
        height_m[i] = spectrum->room.record[i];
    return STATUS_OK;
}

void simulated_record_free(struct simulated_record *spectrum)
{
    free(spectrum->deviation_m);
    fft_room_free(&spectrum->room);
    *spectrum = (struct simulated_record){0};
}
