/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A profile made of the 255 waves of a power law gives them back; the band of a law is found in a rough spectrum. */
#include "selftest/selftest_compute.h"
#include "spectrum/power_law.h"
#include "spectrum/power_law_band.h"
#include "spectrum/spectrum.h"

#include <math.h>
#include <string.h>

enum { POINTS = 512, WAVES = POINTS / 2 - 1 };
static const double length_m = 3e-4, alpha = 0.085, gamma_given = 1.5;

/** The profile's amplitudes; the Nyquist one is empty. */
static enum status_code make_spectrum(struct spectrum *out, struct status *status)
{
    double height_m[POINTS] = {0};
    for (int n = 1; n <= WAVES; n++) {
        double amplitude_m = alpha * pow(length_m / n, gamma_given), phase = 0.381966 * n * n; /* no two alike */
        for (int i = 0; i < POINTS; i++)
            height_m[i] += amplitude_m * cos(2 * M_PI * ((double)(n * i % POINTS) / POINTS + phase));
    }
    enum status_code rc = spectrum_compute(out, height_m, POINTS, length_m / POINTS, SPECTRUM_WINDOW_NONE, status);
    out->count = WAVES;
    out->has_nyquist = false;
    return rc;
}

static enum status_code law_number(double *value, const struct selftest_reference *r, struct status *status)
{
    static const double everything[2] = {0, INFINITY};
    struct spectrum spectrum;
    if (make_spectrum(&spectrum, status) != STATUS_OK)
        return status->code;
    struct power_law law = power_law_fit(&spectrum, everything);
    size_t harmonic = (size_t)fmax(1, fmin(r->at[0], WAVES));
    *value = strcmp(r->of, "wave") == 0          ? spectrum.amplitude_m[harmonic - 1]
             : strcmp(r->of, "moment") == 0      ? spectrum_moment(&spectrum, (int)r->at[0])
             : strcmp(r->quantity, "alpha") == 0 ? law.alpha
                                                 : law.gamma;
    spectrum_free(&spectrum);
    return STATUS_OK;
}

static enum status_code band_number(double *value, const struct selftest_reference *r,
                                    const struct selftest_table *table, struct status *status)
{
    const struct power_law_band_spectrum spectrum = {table->law_m2, SELFTEST_LAW, 1e-3, 1, 0};
    struct power_law_band band;
    if (power_law_band_find(&band, &spectrum, status) != STATUS_OK)
        return status->code;
    const struct {
        const char *name;
        double value;
    } numbers[] = {{"gamma", band.fit.gamma},
                   {"standard error of gamma", band.fit.gamma_s},
                   {"log10 amplitude", band.fit.log10_amplitude},
                   {"shortest wave", band.fit.band_m[0]},
                   {"longest wave", band.fit.band_m[1]}};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++)
        if (strcmp(numbers[i].name, r->quantity) == 0) {
            *value = numbers[i].value;
            return STATUS_OK;
        }
    return selftest_unknown(r, status);
}

enum status_code selftest_spectrum(double *value, const struct selftest_reference *r,
                                   const struct selftest_table *table, struct status *status)
{
    return strcmp(r->of, "band") == 0 ? band_number(value, r, table, status) : law_number(value, r, status);
}
