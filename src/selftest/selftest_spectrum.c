/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A profile made of the 255 waves of a power law gives them back; the band of a law is found in a rough spectrum. */
#include "profile/profile.h"
#include "selftest/selftest.h"
#include "spectrum/parameters.h"
#include "spectrum/power_law.h"

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
    return STATUS_OK;
}

enum status_code selftest_spectrum(double *value, const struct selftest_reference *r,
                                   const struct selftest_table *table, struct status *status)
{
    return strcmp(r->of, "band") == 0 ? band_number(value, r, table, status) : law_number(value, r, status);
}

/* Software gauges (ISO 5436-2, type F2): profiles that are formulas, read as a file would be, and their parameters. */
/** NIST's sine of ASME B46: to four decimals, with a pi of 3.14155. All 8000 points are those of its file. */
static double sine_um(size_t i)
{
    return round(sin(2 * 3.14155 * 0.5 / 400 * (double)i) * 1e4) / 1e4;
}

/** A triangle (ISO 5436-1, type C2) of 1 um and 100 um, 200 points a wave, half a step from its corners. */
static double triangle_um(size_t i)
{
    double phase = ((double)(i % 200) + 0.5) / 50; /* 0 to 4 */
    return phase < 1 ? phase : phase < 3 ? 2 - phase : phase - 4;
}

static const struct gauge {
    const char *name;
    size_t points;
    double (*height_um)(size_t i);
} gauges[] = {{"sine", 8000, sine_um}, {"triangle", 4000, triangle_um}};

static enum status_code measure(struct parameters *out, const struct gauge *gauge, struct status *status)
{
    static const struct scan_options options = {0};
    struct text file = {0};
    struct scan scan = {0};
    struct profile profile = {0};
    text_add(&file, "x [um],z [um]\n");
    for (size_t i = 0; i < gauge->points; i++)
        text_add(&file, "%.1f,%.17g\n", 0.5 * (double)i, gauge->height_um(i));
    enum status_code rc = file.failed ? status_memory(status) : STATUS_OK;
    if (rc == STATUS_OK)
        rc = scan_read_bytes(&scan, &(struct scan_bytes){text_string(&file), file.length, gauge->name}, &options,
                             status);
    if (rc == STATUS_OK)
        rc = profile_make(&profile, &scan, 0, &(struct profile_options){.level = LEVEL_MEAN}, status);
    if (rc == STATUS_OK)
        *out = parameters_compute('P', profile.height_m, profile.points, profile.spacing_m, 1);
    profile_free(&profile);
    scan_free(&scan);
    text_free(&file);
    return rc;
}

enum status_code selftest_softgauge(double *value, const struct selftest_reference *r,
                                    const struct selftest_table *table, struct status *status)
{
    struct parameters parameters;
    size_t g = 0;
    (void)table;
    while (g < 2 && strcmp(gauges[g].name, r->of) != 0)
        g++;
    if (g == 2)
        return STATUS_OK;
    if (measure(&parameters, &gauges[g], status) != STATUS_OK)
        return status->code;
    *value = parameters_value(&parameters, r->quantity);
    return STATUS_OK;
}
