/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "library/library.h"

#include "spectrum/parameters.h"
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct roughcontact_surface_options defaults = {
    .size = sizeof defaults, .max_missing = 0.1, .row = ROUGHCONTACT_NO_ROW};

/** The public names of what the rooms below count in orders of their own. */
static const enum level levels[] = {
    [ROUGHCONTACT_LEVEL_AUTO] = LEVEL_LINE,         [ROUGHCONTACT_LEVEL_NONE] = LEVEL_NONE,
    [ROUGHCONTACT_LEVEL_MEAN] = LEVEL_MEAN,         [ROUGHCONTACT_LEVEL_LINE] = LEVEL_LINE,
    [ROUGHCONTACT_LEVEL_PARABOLA] = LEVEL_PARABOLA, [ROUGHCONTACT_LEVEL_CIRCLE] = LEVEL_CIRCLE,
    [ROUGHCONTACT_LEVEL_ROBUST] = LEVEL_ROBUST};
static const enum spectrum_window windows[] = {[ROUGHCONTACT_WINDOW_AUTO] = SPECTRUM_WINDOW_AUTO,
                                               [ROUGHCONTACT_WINDOW_NONE] = SPECTRUM_WINDOW_NONE,
                                               [ROUGHCONTACT_WINDOW_HANN] = SPECTRUM_WINDOW_HANN};
static const enum power_law_method fits[] = {
    [ROUGHCONTACT_FIT_AUTO] = POWER_LAW_AUTO, [ROUGHCONTACT_FIT_THESIS] = POWER_LAW_THESIS};
static const int laws[] = {[POWER_LAW_BAND_NONE] = ROUGHCONTACT_LAW_NONE,
                           [POWER_LAW_BAND_NARROW] = ROUGHCONTACT_LAW_NARROW,
                           [POWER_LAW_BAND_LAW] = ROUGHCONTACT_LAW_FOUND};

void roughcontact_surface_options_init(struct roughcontact_surface_options *options, size_t size)
{
    library_init(options, size, &defaults, sizeof defaults);
}

static enum status_code check_choice(int value, size_t count, const char *what, struct status *status)
{
    return value >= 0 && (size_t)value < count
               ? STATUS_OK
               : status_fail(status, STATUS_USAGE, "%s %d is not known; give one of roughcontact_%s", what, value,
                             what);
}

static enum status_code check_number(double value, double least, double most, const char *what, struct status *status)
{
    return value == 0 || (value >= least && value <= most)
               ? STATUS_OK
               : status_fail(status, STATUS_USAGE, "%s is %g; allowed is %g to %g, or 0", what, value, least, most);
}

/** The same ranges as those of the scene's keys. */
static enum status_code check_options(const struct roughcontact_surface_options *options, struct status *status)
{
    const struct roughcontact_surface_options *o = options;
    if (check_choice(o->level, sizeof levels / sizeof *levels, "level", status) != STATUS_OK ||
        check_choice(o->window, sizeof windows / sizeof *windows, "window", status) != STATUS_OK ||
        check_choice(o->fit, sizeof fits / sizeof *fits, "fit", status) != STATUS_OK ||
        check_number(o->max_missing, 0, 0.9, "max_missing", status) != STATUS_OK ||
        check_number(o->lambda_s_m, 1e-12, 1e3, "lambda_s_m", status) != STATUS_OK ||
        check_number(o->lambda_c_m, 1e-12, 1e3, "lambda_c_m", status) != STATUS_OK ||
        check_number(o->tip_radius_m, 1e-12, 1, "tip_radius_m", status) != STATUS_OK ||
        check_number(o->fit_low_m, 1e-12, 1e3, "fit_low_m", status) != STATUS_OK ||
        check_number(o->fit_high_m, 1e-12, 1e3, "fit_high_m", status) != STATUS_OK)
        return status->code;
    if (o->lambda_c_m > 0 && !(o->lambda_s_m < o->lambda_c_m))
        return status_fail(status, STATUS_USAGE,
                           "lambda_c_m is %g, not above lambda_s_m, %g; nothing would be left between them",
                           o->lambda_c_m, o->lambda_s_m);
    if ((o->fit_low_m > 0 || o->fit_high_m > 0) && !(o->fit_low_m < o->fit_high_m && o->fit_low_m > 0))
        return status_fail(status, STATUS_USAGE, "the fit's band is %g to %g m; give both, the shorter one first",
                           o->fit_low_m, o->fit_high_m);
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

static void fill_roughness(struct roughcontact_surface *out, const struct roughness *r)
{
    const struct asperities *a = &out->asperities;
    bool has = out->has_asperities;
    out->roughness = (struct roughcontact_roughness){.rq_m = r->rq_m,
                                                     .ra_m = r->ra_m,
                                                     .pv_m = r->pv_m,
                                                     .rsk = roughness_skewness(r),
                                                     .rku = roughness_kurtosis(r),
                                                     .m0_m2 = r->m0_m2,
                                                     .m2 = r->m2,
                                                     .m4_per_m2 = r->m4_per_m2,
                                                     .nayak = roughness_nayak(r),
                                                     .asperity_density_per_m2 = has ? a->density_per_m2 : NAN,
                                                     .asperity_radius_m = has ? a->radius_m : NAN,
                                                     .asperity_sigma_m = has ? a->sigma_s_m : NAN,
                                                     .asperity_offset_m = has ? a->offset_m : NAN};
}

static void fill_power_law(struct roughcontact_power_law *out, const struct power_law *law)
{
    *out = (struct roughcontact_power_law){.law = laws[law->found],
                                           .alpha = law->alpha,
                                           .gamma = law->gamma,
                                           .gamma_error = law->gamma_error,
                                           .amplitude_m = law->amplitude_m,
                                           .amplitude_error_decades = law->amplitude_error_decades,
                                           .wavelength_m = law->wavelength_m,
                                           .low_m = law->band_m[0],
                                           .high_m = law->band_m[1],
                                           .misfit_decades = law->misfit_decades};
}

/** The law as a report fits it to a surface with one scan. */
static enum status_code fit_law(struct roughcontact_surface *out, const struct roughcontact_surface_options *options,
                                struct status *status)
{
    const struct profile *profile = &out->profile;
    const double given[2] = {options->fit_low_m, options->fit_high_m};
    const double left[2] = {options->lambda_s_m, options->lambda_c_m > 0 ? options->lambda_c_m : INFINITY};
    bool is_given = options->fit_high_m > 0;
    struct power_law_scans scans = {0};
    struct power_law_band band;
    if (fits[options->fit] == POWER_LAW_THESIS) {
        struct power_law law = power_law_fit(&out->spectrum, is_given ? given : left);
        fill_power_law(&out->power_law, &law);
        return STATUS_OK;
    }
    const struct power_law_scans_def def = {options->lambda_s_m, is_given ? given : NULL};
    enum status_code code =
        power_law_scans_add(&scans, profile->height_m, profile->points, profile->spacing_m, profile->digit_m, status);
    if (code == STATUS_OK)
        code = power_law_scans_fit(&band, &scans, &def, status);
    if (code == STATUS_OK) {
        struct power_law law = power_law_of_band(&band);
        fill_power_law(&out->power_law, &law);
    }
    power_law_scans_free(&scans);
    return code;
}

static enum status_code describe(struct roughcontact_surface *out, const struct roughcontact_surface_options *options,
                                 struct status *status)
{
    const struct profile *profile = &out->profile;
    struct status none = {0};
    struct roughness roughness =
        profile->measured_x_m ? roughness_of_points(profile->measured_x_m, profile->measured_z_m, profile->points)
                              : roughness_of_heights(profile->height_m, profile->points, profile->spacing_m);
    out->has_asperities = roughness_asperities(&out->asperities, &roughness, &none) == STATUS_OK;
    snprintf(out->problem, sizeof out->problem, "%.*s", (int)sizeof out->problem - 1, none.message);
    fill_roughness(out, &roughness);
    if (spectrum_compute(&out->spectrum, profile->height_m, profile->points, profile->spacing_m,
                         spectrum_window_for(windows[options->window], profile->periodic), status) != STATUS_OK)
        return status->code;
    out->shown_spectrum = (struct roughcontact_spectrum){out->spectrum.count, out->spectrum.length_m,
                                                         out->spectrum.amplitude_m, out->spectrum.has_nyquist};
    out->lambda_c_m = options->lambda_c_m;
    out->info = (struct roughcontact_surface_info){.points = profile->points,
                                                   .spacing_m = profile->spacing_m,
                                                   .length_m = (double)profile->points * profile->spacing_m,
                                                   .height_m = profile->height_m,
                                                   .periodic = profile->periodic,
                                                   .tilt = profile->tilt,
                                                   .bridged = profile->bridged,
                                                   .trimmed = profile->trimmed};
    return fit_law(out, options, status);
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
    const struct profile_options how = {.level = levels[own.level],
                                        .max_missing = own.max_missing,
                                        .lambda_s_m = own.lambda_s_m,
                                        .lambda_c_m = own.lambda_c_m,
                                        .tip_radius_m = own.tip_radius_m,
                                        .periodic_mean = own.level == ROUGHCONTACT_LEVEL_AUTO};
    struct roughcontact_surface *made = calloc(1, sizeof *made);
    if (!made)
        return status_memory(status);
    if (profile_make(&made->profile, &scan->scan, row, &how, status) != STATUS_OK ||
        describe(made, &own, status) != STATUS_OK) {
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

const struct roughcontact_surface_info *roughcontact_surface_info(const struct roughcontact_surface *surface)
{
    return &surface->info;
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

static struct roughcontact_parameter shown_parameters[PARAMETERS_COUNT];

static void fill_parameters(void)
{
    for (size_t i = 0; i < PARAMETERS_COUNT; i++) {
        const struct parameters_row *row = &parameters_rows[i];
        shown_parameters[i] = (struct roughcontact_parameter){row->name, row->unit, row->meaning, row->clause};
    }
}

size_t roughcontact_parameter_count(void)
{
    return PARAMETERS_COUNT;
}

const struct roughcontact_parameter *roughcontact_parameter(size_t i)
{
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    pthread_once(&once, fill_parameters);
    return i < PARAMETERS_COUNT ? &shown_parameters[i] : NULL;
}

int roughcontact_surface_parameters(const struct roughcontact_surface *surface, double *values, size_t count,
                                    struct roughcontact_status *status)
{
    struct host host;
    struct status problem = {0};
    struct parameters parameters;
    host_put_aside(&host);
    if (!surface || count > PARAMETERS_COUNT) {
        (void)status_fail(&problem, STATUS_USAGE, surface ? "there are %d parameters, not %zu" : "no surface is given",
                          PARAMETERS_COUNT, count);
        return library_end(&host, &problem, status);
    }
    const struct profile *profile = &surface->profile;
    enum status_code code =
        surface->lambda_c_m > 0
            ? parameters_of_roughness(&parameters, profile->height_m, profile->points, profile->spacing_m,
                                      surface->lambda_c_m, &problem)
            : parameters_compute(&parameters, 'P', profile->height_m, profile->points, profile->spacing_m, 1, &problem);
    for (size_t i = 0; i < count; i++)
        values[i] = code == STATUS_OK ? parameters.value[i] : NAN;
    return library_end(&host, &problem, status);
}

void roughcontact_surface_free(struct roughcontact_surface *surface)
{
    if (surface) {
        profile_free(&surface->profile);
        spectrum_free(&surface->spectrum);
    }
    free(surface);
}
