/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/spectrum.h"

#include "profile/profile.h"
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double resolved = 1e-4; /* of a root mean square height: finer steps no instrument or file resolves */

const char *const spectrum_window_names[SPECTRUM_WINDOW_COUNT] = {"auto", "none", "hann"};

enum spectrum_window spectrum_window_for(enum spectrum_window asked, bool periodic)
{
    if (asked != SPECTRUM_WINDOW_AUTO)
        return asked;
    return periodic ? SPECTRUM_WINDOW_NONE : SPECTRUM_WINDOW_HANN;
}

enum status_code spectrum_of_record(struct spectrum *out, struct fft_room *room, size_t points, double spacing_m,
                                    enum spectrum_window window, struct status *status)
{
    assert(window != SPECTRUM_WINDOW_AUTO);
    size_t count = points / 2;
    *out = (struct spectrum){.count = count, .length_m = (double)points * spacing_m, .has_nyquist = points % 2 == 0};
    out->amplitude_m = reallocarray(NULL, count, sizeof *out->amplitude_m);
    if (!out->amplitude_m)
        return status_memory(status);
    double sum = 0;
    for (size_t i = 0; i < points; i++)
        sum += room->record[i];
    for (size_t i = 0; i < points; i++)
        room->record[i] -= sum / (double)points;
    if (window == SPECTRUM_WINDOW_HANN)
        record_window_hann(room->record, points);
    if (!fft_forward(room->transform, room->record, points))
        return status_memory(status);
    for (size_t n = 1; n <= count; n++) {
        const double *harmonic = room->transform[n];
        out->amplitude_m[n - 1] = 2 * sqrt(harmonic[0] * harmonic[0] + harmonic[1] * harmonic[1]) / (double)points;
    }
    if (out->has_nyquist)
        out->amplitude_m[count - 1] /= 2;
    return STATUS_OK;
}

enum status_code spectrum_compute(struct spectrum *out, const double *height_m, size_t points, double spacing_m,
                                  enum spectrum_window window, struct status *status)
{
    OWNED(fft_room_free) struct fft_room room = {0};
    *out = (struct spectrum){0};
    if (!fft_room_make(&room, points))
        return status_memory(status);
    memcpy(room.record, height_m, points * sizeof *height_m);
    return spectrum_of_record(out, &room, points, spacing_m, window, status);
}

enum status_code spectrum_add_record(struct spectrum *mean, size_t so_far, const double *height_m, size_t points,
                                     double spacing_m, struct status *status)
{
    OWNED(spectrum_free) struct spectrum one = {0};
    enum status_code rc = spectrum_compute(&one, height_m, points, spacing_m, SPECTRUM_WINDOW_NONE, status);
    if (rc == STATUS_OK)
        rc = grid_average(mean, &one, so_far, status);
    return rc;
}

enum status_code spectrum_copy(struct spectrum *out, const struct spectrum *in, struct status *status)
{
    *out = *in;
    out->amplitude_m = reallocarray(NULL, in->count, sizeof *out->amplitude_m);
    if (!out->amplitude_m)
        return status_memory(status);
    memcpy(out->amplitude_m, in->amplitude_m, in->count * sizeof *in->amplitude_m);
    return STATUS_OK;
}

void spectrum_free(struct spectrum *spectrum)
{
    free(spectrum->amplitude_m);
    *spectrum = (struct spectrum){0};
}

double spectrum_frequency(const struct spectrum *spectrum, size_t i)
{
    return (double)(i + 1) / spectrum->length_m;
}

struct spectrum_bin spectrum_bin_of(const struct spectrum *spectrum, size_t i)
{
    return (struct spectrum_bin){1, 1 / spectrum_frequency(spectrum, i), spectrum->amplitude_m[i]};
}

static double tenth_of_decade(size_t i)
{
    return floor(10 * log10((double)(i + 1)) + 1e-9);
}

struct spectrum_bin spectrum_bin_from(const struct spectrum *spectrum, size_t i)
{
    struct spectrum_bin bin = {0, 0, 0};
    double tenth = tenth_of_decade(i), power_m2 = 0, logarithms = 0, longest_m = 1 / spectrum_frequency(spectrum, i);
    for (; i < spectrum->count && tenth_of_decade(i) == tenth; i++, bin.count++) {
        power_m2 += spectrum_power(spectrum, i);
        logarithms -= log(spectrum_frequency(spectrum, i));
    }
    bin.wavelength_m = bin.count == 1 ? longest_m : exp(logarithms / (double)bin.count);
    bin.amplitude_m = sqrt(2 * power_m2 / (double)bin.count);
    return bin;
}

double spectrum_power(const struct spectrum *spectrum, size_t i)
{
    double square = spectrum->amplitude_m[i] * spectrum->amplitude_m[i];
    return spectrum->has_nyquist && i + 1 == spectrum->count ? square : square / 2;
}

double spectrum_longest_waves(const struct spectrum *spectrum)
{
    double half = spectrum_moment(spectrum, 0) / 2, sum = 0;
    for (size_t i = 0; i < spectrum->count; i++) {
        double power = spectrum_power(spectrum, i);
        if (power > 0 && sum + power >= half)
            return (double)i + (half - sum) / power + 0.5;
        sum += power;
    }
    return 0;
}

size_t spectrum_known(const struct spectrum *spectrum, double shortest_m, double step_m)
{
    double all = 0, shorter = 0;
    for (size_t i = 0; i < spectrum->count; i++)
        all += spectrum_power(spectrum, i);
    double limit = fmax(step_m * step_m, resolved * resolved * all) / 6;
    size_t count = spectrum->count;
    while (count > 0 && (shorter += spectrum_power(spectrum, count - 1)) < limit)
        count--;
    while (count > 0 && spectrum->length_m / (double)count < shortest_m * (1 - 1e-12))
        count--;
    return count;
}

double spectrum_moment(const struct spectrum *spectrum, int k)
{
    double moment = 0;
    for (size_t i = 0; i < spectrum->count; i++) {
        double wave_number = 2 * M_PI * spectrum_frequency(spectrum, i), weight = 1;
        for (int j = 0; j < k; j++)
            weight *= wave_number * wave_number;
        moment += weight * spectrum_power(spectrum, i);
    }
    return moment;
}
