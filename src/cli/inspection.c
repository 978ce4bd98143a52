/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/inspection.h"
#include "cli/command.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static enum status_code look_at_map(struct inspection *out, struct status *status)
{
    if (areal_compute(&out->areal, &out->scan, status) != STATUS_OK)
        return status->code;
    out->roughness = out->areal.rows;
    out->spacing_m = out->scan.dx_m;
    out->length_m = (double)(out->scan.nx - 1) * out->scan.dx_m;
    if (out->areal.spectrum_rows < out->scan.ny)
        scan_warn(&out->scan,
                  "%zu of %zu rows are in the spectrum; the others are flat or miss over a tenth of "
                  "their points",
                  out->areal.spectrum_rows, out->scan.ny);
    struct status ignored = {0};
    if (profile_make(&out->profile, &out->scan, out->scan.ny / 2, &profile_defaults, &ignored) != STATUS_OK)
        profile_free(&out->profile);
    out->profile.note_count = 0; /* one row's are not the map's */
    return STATUS_OK;
}

/** P of the profile before lambda_c, R of the one after. */
static enum status_code compute_parameters(struct inspection *out, struct status *status)
{
    const struct profile *profile = &out->profile;
    struct profile_options primary = out->options;
    struct profile before;
    out->has_parameters = true;
    out->primary = parameters_compute('P', profile->height_m, profile->points, profile->spacing_m, 1);
    if (!(out->options.lambda_c_m > 0))
        return STATUS_OK;
    primary.lambda_c_m = 0;
    if (profile_make(&before, &out->scan, 0, &primary, status) == STATUS_OK) {
        out->primary = parameters_compute('P', before.height_m, before.points, before.spacing_m, 1);
        out->has_filtered = parameters_of_roughness(&out->filtered, profile->height_m, profile->points,
                                                    profile->spacing_m, out->options.lambda_c_m, status) == STATUS_OK;
    }
    profile_free(&before);
    return status->code;
}

/** The law as a report would fit it; no filter has cut a map. */
static enum status_code fit_law(struct inspection *out, struct status *status)
{
    bool map = out->scan.kind == SCAN_AREAL;
    const struct power_law_scans_def def = {map ? 0 : out->options.lambda_s_m, NULL};
    const struct profile *profile = &out->profile;
    struct power_law_scans single = {0}, *scans = map ? &out->areal.scans : &single;
    struct power_law_band band;
    enum status_code code = STATUS_OK;
    if (!map)
        code = power_law_scans_add(&single, profile->height_m, profile->points, profile->spacing_m, profile->digit_m,
                                   status);
    if (code == STATUS_OK && (code = power_law_scans_fit(&band, scans, &def, status)) == STATUS_OK)
        out->power_law = power_law_of_band(&band);
    power_law_scans_free(&single);
    return code;
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

/** Warnings of scan and profile in one row; NULL beyond the last. */
static const char *warning_at(const struct inspection *inspection, size_t i)
{
    if (i < inspection->scan.warning_count)
        return inspection->scan.warnings[i];
    i -= inspection->scan.warning_count;
    return i < inspection->profile.note_count ? inspection->profile.notes[i] : NULL;
}

static void add_parameters(json_t *object, const struct parameters *parameters)
{
    char key[32];
    for (size_t p = 0; p < PARAMETERS_COUNT; p++) {
        snprintf(key, sizeof key, "%c%s", parameters->letter, parameters_rows[p].name);
        json_set(object, key, parameters->value[p]);
    }
    snprintf(key, sizeof key, "%c_evaluation_length_m", parameters->letter);
    json_set(object, key, parameters->evaluation_length_m);
    snprintf(key, sizeof key, "%c_sampling_lengths", parameters->letter);
    json_object_set_new(object, key, json_integer((json_int_t)parameters->sampling_lengths));
}

void inspection_add_json(json_t *object, const struct inspection *inspection)
{
    const struct profile_options *options = &inspection->options;
    const struct scan *scan = &inspection->scan;
    const struct roughness *r = &inspection->roughness;
    json_t *warnings = json_array();
    const char *warning;
    for (size_t w = 0; (warning = warning_at(inspection, w)); w++)
        json_array_append_new(warnings, json_shown(warning));
    json_object_update_new(
        object, json_pack("{s:s, s:s, s:I, s:o, s:o, s:s, s:s, s:I, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "format",
                          scan->format, "kind", scan->kind == SCAN_AREAL ? "areal" : "profile", "points",
                          (json_int_t)(scan->nx * scan->ny), "spacing_m", json_finite(inspection->spacing_m),
                          "length_m", json_finite(inspection->length_m), "x_unit", scan->x_unit, "z_unit", scan->z_unit,
                          "missing", (json_int_t)scan->missing, "rq_m", json_finite(r->rq_m), "ra_m",
                          json_finite(r->ra_m), "pv_m", json_finite(r->pv_m), "m2", json_finite(r->m2), "m4_per_m2",
                          json_finite(r->m4_per_m2), "alpha_SI", json_finite(inspection->power_law.alpha), "gamma",
                          json_finite(inspection->power_law.gamma), "warnings", warnings));
    if (scan->kind == SCAN_AREAL)
        json_object_update_new(object, json_pack("{s:I, s:I, s:o, s:o, s:o, s:o, s:o}", "nx", (json_int_t)scan->nx,
                                                 "ny", (json_int_t)scan->ny, "dx_m", json_finite(scan->dx_m), "dy_m",
                                                 json_finite(scan->dy_m), "sq_m", json_finite(inspection->areal.sq_m),
                                                 "sa_m", json_finite(inspection->areal.sa_m), "sz_m",
                                                 json_finite(inspection->areal.sz_m)));
    if (!inspection->has_parameters)
        return;
    json_t *parameters = json_object();
    json_set(parameters, "lambda_s_m", options->lambda_s_m > 0 ? options->lambda_s_m : NAN);
    json_set(parameters, "lambda_c_m", options->lambda_c_m > 0 ? options->lambda_c_m : NAN);
    json_object_set_new(parameters, "slope", json_string("7-point"));
    add_parameters(parameters, &inspection->primary);
    if (inspection->has_filtered)
        add_parameters(parameters, &inspection->filtered);
    json_object_set_new(object, "parameters", parameters);
}

/** Lengths in um, five to a line. */
static void print_parameters(const struct parameters *parameters)
{
    for (size_t p = 0; p < PARAMETERS_COUNT; p++) {
        if (p % 5 == 0)
            printf(p == 0 ? "  parameters  " : "\n              ");
        double value = parameters->value[p] * (parameters_rows[p].is_length ? 1e6 : 1);
        if (isnan(value))
            printf("%c%s - ", parameters->letter, parameters_rows[p].name);
        else
            printf("%c%s %.5g ", parameters->letter, parameters_rows[p].name, value);
    }
    printf("\n              lengths in um, over %.6g mm in %zu sampling length%s, slope 7-point\n",
           parameters->evaluation_length_m * 1e3, parameters->sampling_lengths,
           parameters->sampling_lengths == 1 ? "" : "s");
}

/** A line of text that may be hostile. */
static void print_shown(const char *before, const char *hostile)
{
    struct text shown = {0};
    text_add_shown(&shown, hostile);
    printf("%s%s\n", before, text_string(&shown));
    text_free(&shown);
}

static void print_law(const struct power_law *law)
{
    if (law->found == POWER_LAW_BAND_NONE)
        printf("  power law   - (no power law found)\n");
    else
        printf("  power law   gamma %.3f +- %.3f from %.3g to %.3g um%s, misfit %.2g decades\n"
               "              rms amplitude %.4g um x/: %.3g at %.3g um, C %.3g m3\n",
               law->gamma, law->gamma_error, law->band_m[0] * 1e6, law->band_m[1] * 1e6,
               law->found == POWER_LAW_BAND_NARROW ? " (narrow)" : "", law->misfit_decades, law->amplitude_m * 1e6,
               pow(10, law->amplitude_error_decades), law->wavelength_m * 1e6, law->psd_m3);
}

void inspection_print(const char *path, const struct inspection *f)
{
    const struct roughness *r = &f->roughness;
    static const char *const grids[] = {"uniform", "rounded x, nominal spacing used", "uneven x, interpolated"};
    print_shown("", path);
    printf("  format      %s, x in %s, z in %s\n", f->scan.format, f->scan.x_unit, f->scan.z_unit);
    if (f->scan.kind == SCAN_AREAL)
        printf("  points      %zu x %zu, spacing %.6g um x %.6g um, %zu missing\n"
               "  plane out   Sq %.6g um, Sa %.6g um, Sz %.6g um; below: rows, each over its line\n",
               f->scan.nx, f->scan.ny, f->scan.dx_m * 1e6, f->scan.dy_m * 1e6, f->scan.missing, f->areal.sq_m * 1e6,
               f->areal.sa_m * 1e6, f->areal.sz_m * 1e6);
    else
        printf("  points      %zu, spacing %.6g um (%s), length %.6g mm%s\n", f->scan.nx, f->spacing_m * 1e6,
               grids[f->profile.grid], f->length_m * 1e3, f->profile.periodic ? ", periodic" : "");
    if (f->has_parameters)
        print_parameters(&f->primary);
    if (f->has_filtered)
        print_parameters(&f->filtered);
    printf("  roughness   Rq %.6g um, Ra %.6g um, peak to valley %.6g um\n", r->rq_m * 1e6, r->ra_m * 1e6,
           r->pv_m * 1e6);
    printf("  moments     m2 %.6g, m4 %.6g /um2\n", r->m2, r->m4_per_m2 * 1e-12);
    print_law(&f->power_law);
    const char *warning;
    for (size_t w = 0; (warning = warning_at(f, w)); w++)
        print_shown("  note        ", warning);
}
