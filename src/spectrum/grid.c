/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/spectrum.h"

#include <math.h>
#include <stdlib.h>

enum status_code grid_spectrum(struct spectrum *out, const struct spectrum *in, double length_m, size_t count,
                               struct status *status)
{
    *out =
        (struct spectrum){.amplitude_m = calloc(count, sizeof *out->amplitude_m), .count = count, .length_m = length_m};
    if (!out->amplitude_m)
        return status_memory(status);
    for (size_t i = 0; i < in->count; i++) {
        /* band of harmonic i + 1 in steps of the new grid; the Nyquist harmonic has only its lower half */
        double scale = length_m / in->length_m, low = ((double)i + 0.5) * scale, high = ((double)i + 1.5) * scale;
        if (in->has_nyquist && i + 1 == in->count)
            high = ((double)i + 1) * scale;
        double density = spectrum_power(in, i) / (high - low);
        for (size_t n = (size_t)fmax(1, floor(low + 0.5)); n <= count && (double)n - 0.5 < high; n++) {
            double from = fmax(low, (double)n - 0.5), to = fmin(high, (double)n + 0.5);
            if (to > from)
                out->amplitude_m[n - 1] += density * (to - from); /* power so far */
        }
    }
    for (size_t n = 0; n < count; n++)
        out->amplitude_m[n] = sqrt(2 * out->amplitude_m[n]);
    return STATUS_OK;
}

/** Sets the amplitude of index i to that of a mean square height. */
static void put_power(struct spectrum *spectrum, size_t i, double power_m2)
{
    bool nyquist = spectrum->has_nyquist && i + 1 == spectrum->count;
    spectrum->amplitude_m[i] = sqrt(nyquist ? power_m2 : 2 * power_m2);
}

enum status_code grid_add(struct spectrum *sum, const struct spectrum *other, struct status *status)
{
    OWNED(spectrum_free) struct spectrum same = {0};
    if (grid_spectrum(&same, other, sum->length_m, sum->count, status) != STATUS_OK)
        return status->code;
    for (size_t i = 0; i < sum->count; i++)
        put_power(sum, i, spectrum_power(sum, i) + spectrum_power(&same, i));
    return STATUS_OK;
}

/** A mean over spectra of the same harmonics: of powers, or of logarithms. */
typedef void average_of(struct spectrum *mean, const struct spectrum *other, size_t so_far);

static void average_powers(struct spectrum *mean, const struct spectrum *other, size_t so_far)
{
    double weight = 1 / (double)(so_far + 1);
    for (size_t i = 0; i < mean->count; i++)
        put_power(mean, i, (1 - weight) * spectrum_power(mean, i) + weight * spectrum_power(other, i));
}

static void average_logs(struct spectrum *mean, const struct spectrum *other, size_t so_far)
{
    for (size_t i = 0; i < mean->count; i++)
        if (mean->amplitude_m[i] > 0)
            mean->amplitude_m[i] *= pow(other->amplitude_m[i] / mean->amplitude_m[i], 1 / (double)(so_far + 1));
}

static enum status_code average(struct spectrum *mean, const struct spectrum *other, size_t so_far, average_of *take,
                                struct status *status)
{
    if (so_far == 0)
        return spectrum_copy(mean, other, status);
    if (other->count == mean->count && other->has_nyquist == mean->has_nyquist &&
        fabs(other->length_m / mean->length_m - 1) < 1e-6) {
        take(mean, other, so_far);
        return STATUS_OK;
    }
    struct spectrum same;
    double length_m = fmin(mean->length_m, other->length_m);
    double highest = fmin(spectrum_frequency(mean, mean->count - 1), spectrum_frequency(other, other->count - 1));
    size_t count = (size_t)fmax(1, floor(length_m * highest * (1 + 1e-9)));
    if (grid_spectrum(&same, mean, length_m, count, status) != STATUS_OK)
        return status->code;
    spectrum_free(mean);
    *mean = same;
    if (grid_spectrum(&same, other, length_m, count, status) != STATUS_OK)
        return status->code;
    take(mean, &same, so_far);
    spectrum_free(&same);
    return STATUS_OK;
}

enum status_code grid_average(struct spectrum *mean, const struct spectrum *other, size_t so_far, struct status *status)
{
    return average(mean, other, so_far, average_powers, status);
}

enum status_code grid_average_logs(struct spectrum *mean, const struct spectrum *other, size_t so_far,
                                   struct status *status)
{
    return average(mean, other, so_far, average_logs, status);
}
