/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/inspection.h"
#include "contact/cmy.h"
#include "direct/direct_map.h"
#include "output/record.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Where a report would low-pass the map, what is to paste is that of what is left; warns with the effect. */
static enum status_code look_at_low_pass(struct inspection *out, struct status *status)
{
    struct scan scan = out->scan;
    struct direct_map_def map = {.nx = scan.nx, .ny = scan.ny, .dx_m = scan.dx_m, .dy_m = scan.dy_m};
    struct areal_parameters left;
    const size_t size = scan.nx * scan.ny * sizeof *scan.z_m;
    if (scan.nx < PROFILE_SPECTRUM_POINTS) {
        scan_warn(&out->scan, "only %zu points in a row; a report needs %d", scan.nx, PROFILE_SPECTRUM_POINTS);
        return STATUS_OK;
    }
    if (!(scan.z_m = malloc(size)))
        return status_memory(status);
    memcpy(scan.z_m, out->scan.z_m, size);
    if (direct_map_condition(scan.z_m, &map, false, status) == STATUS_OK && map.cutoff > 0 &&
        areal_parameters_of(&left, &scan, status) == STATUS_OK) {
        scan_warn(&out->scan,
                  "a report low-passes it first, at %.3g um, as more than 2 %% of its slopes are shorter: Sq %.3g → "
                  "%.3g um, slope %.2g → %.2g; the line to paste is of that, all others of the map as measured",
                  map.cutoff * map.dx_m * 1e6, out->sigma_m * 1e6, left.sq_m * 1e6, out->areal.surface.sdq, left.sdq);
        out->sigma_m = left.sq_m;
        out->mean_slope = cmy_slope(left.sdq * left.sdq / 2);
    }
    free(scan.z_m);
    return status->code;
}

static enum status_code look_at_map(struct inspection *out, struct status *status)
{
    if (areal_compute(&out->areal, &out->scan, status) != STATUS_OK)
        return status->code;
    const double sdq = out->areal.surface.sdq; /* rows along the lay would have a smaller slope */
    out->sigma_m = out->areal.surface.sq_m;
    out->mean_slope = cmy_slope(sdq * sdq / 2);
    out->roughness = out->areal.rows;
    out->spacing_m = out->scan.dx_m;
    out->points = out->scan.nx * out->scan.ny;
    out->length_m = (double)(out->scan.nx - 1) * out->scan.dx_m;
    if (out->areal.scans.scan_count < out->scan.ny)
        scan_warn(&out->scan, "%zu of %zu rows are in the spectrum; the others are flat or miss too many points",
                  out->areal.scans.scan_count, out->scan.ny);
    struct status ignored = {0};
    if (profile_make(&out->profile, &out->scan, out->scan.ny / 2, &profile_defaults, &ignored) != STATUS_OK)
        profile_free(&out->profile);
    out->profile.note_count = 0; /* one row's are not the map's */
    return look_at_low_pass(out, status);
}

/** P of the profile before lambda_c, R of the one after. */
static enum status_code compute_parameters(struct inspection *out, struct status *status)
{
    const struct profile *profile = &out->profile;
    struct profile_options primary = out->options;
    OWNED(profile_free) struct profile before = {0};
    out->primary = parameters_compute('P', profile->height_m, profile->points, profile->spacing_m, 1);
    if (!(out->options.lambda_c_m > 0))
        return STATUS_OK;
    primary.lambda_c_m = 0;
    if (profile_make(&before, &out->scan, 0, &primary, status) == STATUS_OK) {
        out->primary = parameters_compute('P', before.height_m, before.points, before.spacing_m, 1);
        out->has_filtered = parameters_of_roughness(&out->filtered, profile->height_m, profile->points,
                                                    profile->spacing_m, out->options.lambda_c_m,
                                                    profile->periodic ? NULL : profile->margin_m, status) == STATUS_OK;
    }
    return status->code;
}

/** Fits the law as a report would; a map was not filtered. */
static enum status_code fit_law(struct inspection *out, struct status *status)
{
    bool map = out->scan.kind == SCAN_AREAL;
    const struct profile *profile = &out->profile;
    OWNED(power_law_scans_free) struct power_law_scans single = {0};
    struct power_law_scans *scans = map ? &out->areal.scans : &single;
    OWNED(spectrum_free) struct spectrum own = {0};
    struct power_law_band band;
    if (!map && (power_law_scans_add(&single, profile->height_m, profile->points, profile->spacing_m, profile->digit_m,
                                     status) != STATUS_OK ||
                 spectrum_compute(&own, profile->height_m, profile->points, profile->spacing_m,
                                  spectrum_window_for(SPECTRUM_WINDOW_AUTO, profile->periodic), status) != STATUS_OK))
        return status->code;
    power_law_scans_fit(&band, scans, map ? 0 : out->options.lambda_s_m, NULL);
    out->power_law = power_law_of_band(&band, map ? &out->areal.spectrum : &own);
    return STATUS_OK;
}

static enum status_code look_at_profile(struct inspection *out, struct status *status)
{
    struct profile *profile = &out->profile;
    if (profile_make(profile, &out->scan, 0, &out->options, status) != STATUS_OK)
        return status->code;
    out->roughness = profile->measured_x_m
                         ? roughness_of_points(profile->measured_x_m, profile->measured_z_m, profile->points)
                         : roughness_of_heights(profile->height_m, profile->points, profile->spacing_m);
    out->spacing_m = profile->spacing_m;
    out->sigma_m = out->roughness.rq_m;
    out->mean_slope = cmy_slope(out->roughness.m2);
    out->points = profile->points;
    out->length_m = (double)(profile->points - 1) * profile->spacing_m;
    enum status_code code = compute_parameters(out, status);
    scan_free_points(&out->scan);
    return code;
}

enum status_code inspection_make(struct inspection *out, const struct scan_bytes *file,
                                 const struct scan_options *units, const struct profile_options *options,
                                 struct status *status)
{
    *out = (struct inspection){.options = *options};
    enum status_code code = strcmp(file->path, "-") == 0
                                ? scan_read_bytes(&out->scan, file, units, status)
                                : scan_read_beside(&out->scan, file, file->path, units, status);
    if (code != STATUS_OK)
        return code;
    code = out->scan.kind == SCAN_AREAL ? look_at_map(out, status) : look_at_profile(out, status);
    if (code == STATUS_OK)
        code = fit_law(out, status);
    return code == STATUS_OK ? STATUS_OK : status_prefix(status, "%s", file->path);
}

void inspection_free(struct inspection *inspection)
{
    areal_free(&inspection->areal);
    profile_free(&inspection->profile);
    scan_free(&inspection->scan);
}

static void add_parameters(json_t *object, const struct parameters *parameters)
{
    char key[32];
    for (size_t p = 0; p < PARAMETERS_COUNT; p++) {
        snprintf(key, sizeof key, "%c%s", parameters->letter, parameters_names[p]);
        json_set(object, key, parameters->value[p]);
    }
    snprintf(key, sizeof key, "%c_evaluation_length_m", parameters->letter);
    json_set(object, key, parameters->evaluation_length_m);
    snprintf(key, sizeof key, "%c_first_m", parameters->letter);
    json_set(object, key, parameters->first_m);
    snprintf(key, sizeof key, "%c_sampling_lengths", parameters->letter);
    json_object_set_new(object, key, json_integer((json_int_t)parameters->sampling_lengths));
}

#define FIELD(...) RECORD_FIELD(struct inspection, __VA_ARGS__)
static const struct record_field fields[] = {
    FIELD(COUNT, "points", points, JSON),
    FIELD(NUMBER, "spacing_m", spacing_m, JSON),
    FIELD(NUMBER, "length_m", length_m, JSON),
    FIELD(CHARACTERS, "x_unit", scan.x_unit, JSON),
    FIELD(CHARACTERS, "z_unit", scan.z_unit, JSON),
    FIELD(COUNT, "missing", scan.missing, JSON),
    FIELD(NUMBER, "rq_m", roughness.rq_m, JSON),
    FIELD(NUMBER, "ra_m", roughness.ra_m, JSON),
    FIELD(NUMBER, "pv_m", roughness.pv_m, JSON),
    FIELD(NUMBER, "m2", roughness.m2, JSON),
    FIELD(NUMBER, "m4_per_m2", roughness.m4_per_m2, JSON),
    FIELD(NUMBER, "sigma_m", sigma_m, JSON),
    FIELD(NUMBER, "mean_slope", mean_slope, JSON),
    FIELD(NUMBER, "alpha_SI", power_law.alpha, JSON),
    FIELD(NUMBER, "gamma", power_law.gamma, JSON),
    FIELD(NUMBER, "gamma_stderr", power_law.gamma_error, JSON),
    FIELD(NUMBER, "fit_amplitude_m", power_law.amplitude_m, JSON),
    FIELD(NUMBER, "fit_amplitude_stderr_decades", power_law.amplitude_error_decades, JSON),
    FIELD(NUMBER, "fit_wavelength_m", power_law.wavelength_m, JSON),
    FIELD(NUMBER, "fit_low_m", power_law.band_m[0], JSON),
    FIELD(NUMBER, "fit_high_m", power_law.band_m[1], JSON),
    FIELD(NUMBER, "fit_misfit_decades", power_law.misfit_decades, JSON),
    FIELD(NUMBER, "fit_psd_m3", power_law.psd_m3, JSON),
    {0}};
static const struct record_field map_fields[] = {FIELD(COUNT, "nx", scan.nx, JSON),
                                                 FIELD(COUNT, "ny", scan.ny, JSON),
                                                 FIELD(NUMBER, "dx_m", scan.dx_m, JSON),
                                                 FIELD(NUMBER, "dy_m", scan.dy_m, JSON),
                                                 FIELD(NUMBER, "sq_m", areal.surface.sq_m, JSON),
                                                 FIELD(NUMBER, "sa_m", areal.surface.sa_m, JSON),
                                                 FIELD(NUMBER, "sz_m", areal.surface.sz_m, JSON),
                                                 FIELD(NUMBER, "ssk", areal.surface.ssk, JSON),
                                                 FIELD(NUMBER, "sku", areal.surface.sku, JSON),
                                                 FIELD(NUMBER, "sdq", areal.surface.sdq, JSON),
                                                 {0}};

json_t *inspection_json(const char *path, const struct inspection *inspection)
{
    const struct profile_options *options = &inspection->options;
    const struct scan *scan = &inspection->scan;
    json_t *warnings = json_array();
    for (size_t w = 0; w < scan->warning_count; w++)
        json_array_append_new(warnings, json_shown(scan->warnings[w]));
    for (size_t n = 0; n < inspection->profile.note_count; n++)
        json_array_append_new(warnings, json_shown(inspection->profile.notes[n]));
    json_t *json = json_pack("{s:o, s:s, s:s}", "file", json_shown(path), "format", scan->format, "kind",
                             scan->kind == SCAN_AREAL ? "areal" : "profile");
    json_object_update_new(json, record_json(fields, inspection));
    json_object_set_new(json, "warnings", warnings);
    json_object_set_new(json, "fit", json_string(power_law_band_class_names[inspection->power_law.found]));
    if (scan->kind == SCAN_AREAL) {
        json_object_update_new(json, record_json(map_fields, inspection));
        return json;
    }
    static const char *const grids[] = {"uniform", "steps of a few lengths", "uneven x, interpolated"};
    json_object_set_new(json, "positions", json_string(grids[inspection->profile.grid]));
    json_object_set_new(json, "periodic", json_boolean(inspection->profile.periodic));
    json_t *parameters = json_object();
    json_set(parameters, "lambda_s_m", options->lambda_s_m > 0 ? options->lambda_s_m : NAN);
    json_set(parameters, "lambda_c_m", options->lambda_c_m > 0 ? options->lambda_c_m : NAN);
    json_object_set_new(parameters, "slope", json_string("7-point"));
    add_parameters(parameters, &inspection->primary);
    if (inspection->has_filtered)
        add_parameters(parameters, &inspection->filtered);
    json_object_set_new(json, "parameters", parameters);
    return json;
}

static void show(json_t *view, const char *name, double value, int digits)
{
    char number[40];
    snprintf(number, sizeof number, "%.*g", digits, value);
    json_object_set_new(view, name, json_string(number));
}

json_t *inspection_view(const char *path, const struct inspection *f)
{
    const struct power_law *law = &f->power_law;
    json_t *view = inspection_json(path, f);
    char gamma[64];
    if (f->scan.kind == SCAN_AREAL)
        show(view, "ssk", round(1e3 * f->areal.surface.ssk) / 1e3 + 0.0, 4); /* no -0 */
    show(view, "m4_per_um2", f->roughness.m4_per_m2 * 1e-12, 6);
    show(view, "amplitude_times", pow(10, law->amplitude_error_decades), 3);
    snprintf(gamma, sizeof gamma, "%.3f +- %.3f", law->gamma, law->gamma_error);
    json_object_update_new(view,
                           json_pack("{s:b, s:b, s:b, s:b, s:s}", "map", f->scan.kind == SCAN_AREAL, "no_law",
                                     law->found == POWER_LAW_BAND_NONE, "narrow", law->found == POWER_LAW_BAND_NARROW,
                                     "scattered", law->found == POWER_LAW_BAND_SCATTERED, "gamma", gamma));
    return view;
}
