/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "library/library.h"

#include <stdlib.h>

static const struct roughcontact_surface_options defaults = {.size = sizeof defaults, .row = ROUGHCONTACT_NO_ROW};

static const int laws[] = {[POWER_LAW_BAND_NONE] = ROUGHCONTACT_LAW_NONE,
                           [POWER_LAW_BAND_NARROW] = ROUGHCONTACT_LAW_NARROW,
                           [POWER_LAW_BAND_LAW] = ROUGHCONTACT_LAW_FOUND};

void roughcontact_surface_options_init(struct roughcontact_surface_options *options, size_t size)
{
    library_init(options, size, &defaults, sizeof defaults);
}

static enum status_code check_wavelength(double value, const char *what, struct status *status)
{
    return value == 0 || (value >= 1e-12 && value <= 1e3)
               ? STATUS_OK
               : status_fail(status, STATUS_USAGE, "%s is %g; allowed is 1e-12 to 1000, or 0", what, value);
}

/** The same ranges as those of the scene's keys. */
static enum status_code check_options(const struct roughcontact_surface_options *o, struct status *status)
{
    if (check_wavelength(o->lambda_s_m, "lambda_s_m", status) != STATUS_OK ||
        check_wavelength(o->lambda_c_m, "lambda_c_m", status) != STATUS_OK)
        return status->code;
    if (o->lambda_c_m > 0 && !(o->lambda_s_m < o->lambda_c_m))
        return status_fail(status, STATUS_USAGE,
                           "lambda_c_m is %g, not above lambda_s_m, %g; nothing would be left between them",
                           o->lambda_c_m, o->lambda_s_m);
    return STATUS_OK;
}

/** Which row is the profile. */
static enum status_code find_row(size_t *row, const struct scan *scan, size_t asked, struct status *status)
{
    *row = asked == ROUGHCONTACT_NO_ROW ? 0 : asked;
    if (asked == ROUGHCONTACT_NO_ROW && scan->kind == SCAN_AREAL)
        return status_fail(status, STATUS_USAGE, "a map of %zu x %zu points; say by `row` which of its rows to take",
                           scan->nx, scan->ny);
    return *row < scan->ny ? STATUS_OK
                           : status_fail(status, STATUS_USAGE, "there is no row %zu; the scan has %zu", *row, scan->ny);
}

/** The law as a report fits it to a surface with one scan. */
static enum status_code fit_law(struct roughcontact_power_law *out, const struct profile *profile, double lambda_s_m,
                                struct status *status)
{
    const struct power_law_scans_def def = {.lambda_s_m = lambda_s_m};
    struct power_law_scans scans = {0};
    struct power_law_band band;
    enum status_code code =
        power_law_scans_add(&scans, profile->height_m, profile->points, profile->spacing_m, profile->digit_m, status);
    if (code == STATUS_OK)
        code = power_law_scans_fit(&band, &scans, &def, status);
    if (code == STATUS_OK) {
        struct power_law law = power_law_of_band(&band);
        *out = (struct roughcontact_power_law){.law = laws[law.found],
                                               .alpha = law.alpha,
                                               .gamma = law.gamma,
                                               .gamma_error = law.gamma_error,
                                               .amplitude_m = law.amplitude_m,
                                               .amplitude_error_decades = law.amplitude_error_decades,
                                               .wavelength_m = law.wavelength_m,
                                               .low_m = law.band_m[0],
                                               .high_m = law.band_m[1],
                                               .misfit_decades = law.misfit_decades};
    }
    power_law_scans_free(&scans);
    return code;
}

static enum status_code describe(struct roughcontact_surface *out, double lambda_s_m, struct status *status)
{
    const struct profile *profile = &out->profile;
    struct roughness r = profile->measured_x_m
                             ? roughness_of_points(profile->measured_x_m, profile->measured_z_m, profile->points)
                             : roughness_of_heights(profile->height_m, profile->points, profile->spacing_m);
    out->has_asperities = roughness_asperities(&out->asperities, &r, &out->problem) == STATUS_OK;
    out->roughness = (struct roughcontact_roughness){.rq_m = r.rq_m,
                                                     .ra_m = r.ra_m,
                                                     .pv_m = r.pv_m,
                                                     .rsk = roughness_skewness(&r),
                                                     .rku = roughness_kurtosis(&r),
                                                     .m0_m2 = r.m0_m2,
                                                     .m2 = r.m2,
                                                     .m4_per_m2 = r.m4_per_m2};
    if (spectrum_compute(&out->spectrum, profile->height_m, profile->points, profile->spacing_m,
                         spectrum_window_for(SPECTRUM_WINDOW_AUTO, profile->periodic), status) != STATUS_OK)
        return status->code;
    out->shown_spectrum = (struct roughcontact_spectrum){out->spectrum.count, out->spectrum.length_m,
                                                         out->spectrum.amplitude_m, out->spectrum.has_nyquist};
    return fit_law(&out->power_law, profile, lambda_s_m, status);
}

static enum status_code make(struct roughcontact_surface **out, const struct roughcontact_scan *scan,
                             const struct roughcontact_surface_options *options, struct status *status)
{
    struct roughcontact_surface_options own = defaults;
    size_t row;
    if (!scan)
        return status_fail(status, STATUS_USAGE, "no scan is given");
    if (library_take(&own, sizeof own, options, "roughcontact_surface_options_init", status) != STATUS_OK ||
        check_options(&own, status) != STATUS_OK || find_row(&row, &scan->scan, own.row, status) != STATUS_OK)
        return status->code;
    const struct profile_options how = {.level = LEVEL_LINE,
                                        .max_missing = 0.1,
                                        .lambda_s_m = own.lambda_s_m,
                                        .lambda_c_m = own.lambda_c_m,
                                        .periodic_mean = true};
    struct roughcontact_surface *made = calloc(1, sizeof *made);
    if (!made)
        return status_memory(status);
    if (profile_make(&made->profile, &scan->scan, row, &how, status) != STATUS_OK ||
        describe(made, own.lambda_s_m, status) != STATUS_OK) {
        roughcontact_surface_free(made);
        return status->code;
    }
    *out = made;
    return STATUS_OK;
}

int roughcontact_surface_make(struct roughcontact_surface **out, const struct roughcontact_scan *scan,
                              const struct roughcontact_surface_options *options, struct roughcontact_status *status)
{
    struct host host;
    struct status problem = {0};
    host_put_aside(&host);
    *out = NULL;
    (void)make(out, scan, options, &problem);
    return library_end(&host, &problem, status);
}

const char *roughcontact_surface_note(const struct roughcontact_surface *surface, size_t i)
{
    return i < surface->profile.note_count ? surface->profile.notes[i] : NULL;
}

const struct roughcontact_roughness *roughcontact_surface_roughness(const struct roughcontact_surface *surface)
{
    return &surface->roughness;
}

const struct roughcontact_spectrum *roughcontact_surface_spectrum(const struct roughcontact_surface *surface)
{
    return &surface->shown_spectrum;
}

const struct roughcontact_power_law *roughcontact_surface_power_law(const struct roughcontact_surface *surface)
{
    return &surface->power_law;
}

void roughcontact_surface_free(struct roughcontact_surface *surface)
{
    if (surface) {
        profile_free(&surface->profile);
        spectrum_free(&surface->spectrum);
    }
    free(surface);
}
