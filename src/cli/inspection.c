/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/inspection.h"
#include "base/text.h"
#include "cli/command.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static enum status_code look_at_map(struct inspection *out, struct status *status)
{
    if (areal_compute(&out->areal, &out->scan, status) != STATUS_OK)
        return status->code;
    out->roughness = out->areal.rows;
    out->spectrum = out->areal.spectrum;
    out->areal.spectrum = (struct spectrum){0};
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
    out->has_parameters = true;
    if (!(out->options.lambda_c_m > 0))
        return parameters_compute(&out->primary, 'P', profile->height_m, profile->points, profile->spacing_m, 1,
                                  status);
    struct profile_options primary = out->options;
    struct profile before;
    primary.lambda_c_m = 0;
    if (profile_make(&before, &out->scan, 0, &primary, status) == STATUS_OK &&
        parameters_compute(&out->primary, 'P', before.height_m, before.points, before.spacing_m, 1, status) ==
            STATUS_OK)
        out->has_filtered = parameters_of_roughness(&out->filtered, profile->height_m, profile->points,
                                                    profile->spacing_m, out->options.lambda_c_m, status) == STATUS_OK;
    profile_free(&before);
    return status->code;
}

enum status_code inspection_spectrum(struct inspection *inspection, struct status *status)
{
    const struct profile *profile = &inspection->profile;
    if (inspection->scan.kind == SCAN_AREAL || inspection->spectrum.count > 0)
        return STATUS_OK;
    return spectrum_compute(&inspection->spectrum, profile->height_m, profile->points, profile->spacing_m,
                            spectrum_window_for(SPECTRUM_WINDOW_AUTO, profile->periodic), status);
}

/** The law as a report would fit it. */
static enum status_code fit_law(struct inspection *out, struct status *status)
{
    const struct profile_options *options = &out->options;
    bool map = out->scan.kind == SCAN_AREAL; /* which no filter has cut */
    const double cut[2] = {map ? 0 : options->lambda_s_m,
                           !map && options->lambda_c_m > 0 ? options->lambda_c_m : INFINITY};
    if (out->fit == POWER_LAW_THESIS) {
        if (inspection_spectrum(out, status) != STATUS_OK)
            return status->code;
        out->power_law = power_law_fit(&out->spectrum, cut);
        return STATUS_OK;
    }
    const struct power_law_scans_def def = {map ? 0 : options->lambda_s_m, NULL};
    const struct profile *profile = &out->profile;
    struct power_law_scans single = {0}, *scans = map ? &out->areal.scans : &single;
    enum status_code code = STATUS_OK;
    if (!map)
        code = power_law_scans_add(&single, profile->height_m, profile->points, profile->spacing_m, profile->digit_m,
                                   status);
    if (code == STATUS_OK)
        code = power_law_scans_fit(&out->band, scans, &def, status);
    out->power_law = power_law_of_band(&out->band);
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
    return compute_parameters(out, status);
}

enum status_code inspection_make(struct inspection *out, const struct scan_bytes *file,
                                 const struct scan_options *units, const struct profile_options *options,
                                 enum power_law_method fit, struct status *status)
{
    *out = (struct inspection){.options = *options, .fit = fit};
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
    spectrum_free(&inspection->spectrum);
    areal_free(&inspection->areal);
    profile_free(&inspection->profile);
    scan_free(&inspection->scan);
}

double inspection_spacing_m(const struct inspection *inspection)
{
    return inspection->scan.kind == SCAN_AREAL ? inspection->scan.dx_m : inspection->profile.spacing_m;
}

double inspection_length_m(const struct inspection *inspection)
{
    size_t points = inspection->scan.kind == SCAN_AREAL ? inspection->scan.nx : inspection->profile.points;
    return (double)(points - 1) * inspection_spacing_m(inspection);
}

/** Warnings of scan and profile in one row; NULL beyond the last. */
static const char *warning_at(const struct inspection *inspection, size_t i)
{
    if (i < inspection->scan.warning_count)
        return inspection->scan.warnings[i];
    i -= inspection->scan.warning_count;
    return i < inspection->profile.note_count ? inspection->profile.notes[i] : NULL;
}

static void add_real(json_t *object, const char *key, double value)
{
    json_object_set_new(object, key, command_json_number(value));
}

static void add_parameters(json_t *object, const struct parameters *parameters)
{
    char key[32];
    json_t *curve = json_array();
    for (size_t p = 0; p < PARAMETERS_COUNT; p++) {
        snprintf(key, sizeof key, "%c%s", parameters->letter, parameters_rows[p].name);
        add_real(object, key, parameters->value[p]);
    }
    for (size_t i = 0; i < PARAMETERS_CURVE; i++)
        json_array_append_new(curve, command_json_number(parameters->material_ratio_m[i]));
    snprintf(key, sizeof key, "%c_evaluation_length_m", parameters->letter);
    add_real(object, key, parameters->evaluation_length_m);
    snprintf(key, sizeof key, "%c_sampling_lengths", parameters->letter);
    json_object_set_new(object, key, json_integer((json_int_t)parameters->sampling_lengths));
    snprintf(key, sizeof key, "%c_material_ratio_m", parameters->letter);
    json_object_set_new(object, key, curve);
}

void inspection_add_json(json_t *object, const struct inspection *inspection)
{
    const struct profile_options *options = &inspection->options;
    const struct scan *scan = &inspection->scan;
    const struct roughness *r = &inspection->roughness;
    json_t *warnings = json_array();
    const char *warning;
    for (size_t w = 0; (warning = warning_at(inspection, w)); w++)
        json_array_append_new(warnings, command_json_text(warning));
    json_object_update_new(
        object,
        json_pack("{s:s, s:s, s:I, s:o, s:o, s:s, s:s, s:I, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "format",
                  scan->format, "kind", scan->kind == SCAN_AREAL ? "areal" : "profile", "points",
                  (json_int_t)(scan->nx * scan->ny), "spacing_m", command_json_number(inspection_spacing_m(inspection)),
                  "length_m", command_json_number(inspection_length_m(inspection)), "x_unit", scan->x_unit, "z_unit",
                  scan->z_unit, "missing", (json_int_t)scan->missing, "rq_m", command_json_number(r->rq_m), "ra_m",
                  command_json_number(r->ra_m), "pv_m", command_json_number(r->pv_m), "m2", command_json_number(r->m2),
                  "m4_per_m2", command_json_number(r->m4_per_m2), "alpha_SI",
                  command_json_number(inspection->power_law.alpha), "gamma",
                  command_json_number(inspection->power_law.gamma), "warnings", warnings));
    if (scan->kind == SCAN_AREAL)
        json_object_update_new(object, json_pack("{s:I, s:I, s:o, s:o, s:o, s:o, s:o}", "nx", (json_int_t)scan->nx,
                                                 "ny", (json_int_t)scan->ny, "dx_m", command_json_number(scan->dx_m),
                                                 "dy_m", command_json_number(scan->dy_m), "sq_m",
                                                 command_json_number(inspection->areal.sq_m), "sa_m",
                                                 command_json_number(inspection->areal.sa_m), "sz_m",
                                                 command_json_number(inspection->areal.sz_m)));
    if (!inspection->has_parameters)
        return;
    json_t *parameters = json_object();
    add_real(parameters, "lambda_s_m", options->lambda_s_m > 0 ? options->lambda_s_m : NAN);
    add_real(parameters, "lambda_c_m", options->lambda_c_m > 0 ? options->lambda_c_m : NAN);
    json_object_set_new(parameters, "slope", json_string(parameters_slope));
    add_parameters(parameters, &inspection->primary);
    if (inspection->has_filtered)
        add_parameters(parameters, &inspection->filtered);
    json_object_set_new(object, "parameters", parameters);
}

/** Lengths in um, material ratios in %, eight to a line. */
static void print_parameters(const struct parameters *parameters)
{
    for (size_t p = 0; p < PARAMETERS_COUNT; p++) {
        const struct parameters_row *row = &parameters_rows[p];
        bool length = strcmp(row->unit, "m") == 0, ratio = strncmp(row->name, "mrk", 3) == 0;
        if (p % 8 == 0)
            printf(p == 0 ? "  parameters  " : "\n              ");
        double value = parameters->value[p], scale = length ? 1e6 : ratio ? 100 : 1;
        if (isnan(value))
            printf("%c%s - ", parameters->letter, row->name);
        else
            printf("%c%s %.5g%s ", parameters->letter, row->name, value * scale, ratio ? "%" : "");
    }
    printf("\n              lengths in um, over %.6g mm in %zu sampling length%s, slope %s\n",
           parameters->evaluation_length_m * 1e3, parameters->sampling_lengths,
           parameters->sampling_lengths == 1 ? "" : "s", parameters_slope);
}

/** A line of text that may be hostile. */
static void print_shown(const char *before, const char *hostile)
{
    struct text shown = {0};
    text_add_shown(&shown, hostile);
    printf("%s%s\n", before, text_string(&shown));
    text_free(&shown);
}

/** A line of wavelengths, if there are any. */
static void print_waves(const char *what, const double *wave_m, size_t count)
{
    for (size_t i = 0; i < count; i++)
        printf("%s%.3g um", i == 0 ? what : ", ", wave_m[i] * 1e6);
    printf("%s", count == 0 ? "" : "\n");
}

static void print_law(const struct inspection *f)
{
    const struct power_law *law = &f->power_law;
    if (f->fit == POWER_LAW_THESIS && isnan(law->gamma)) {
        printf("  power law   - (%s)\n",
               law->harmonics < 3 ? "it takes 3 harmonics" : "alpha leaves the range of numbers");
    } else if (law->found == POWER_LAW_BAND_NONE) {
        printf("  power law   - (no power law found)\n");
    } else {
        printf("  power law   gamma %.3f +- %.3f from %.3g to %.3g um%s, %s %.2g decades\n", law->gamma,
               law->gamma_error, law->band_m[0] * 1e6, law->band_m[1] * 1e6,
               law->found == POWER_LAW_BAND_NARROW ? " (narrow)" : "",
               f->fit == POWER_LAW_THESIS ? "scatter" : "misfit", law->misfit_decades);
        printf("              %samplitude %.4g um x/: %.3g at %.3g um, C %.3g m3\n",
               f->fit == POWER_LAW_THESIS ? "" : "rms ", law->amplitude_m * 1e6, pow(10, law->amplitude_error_decades),
               law->wavelength_m * 1e6, law->psd_m3);
    }
    double line_m[LOG_BIN_MOST];
    print_waves("              knees at ", f->band.knee_m, f->band.pieces > 0 ? f->band.pieces - 1 : 0);
    size_t lines = power_law_band_lines(line_m, &f->band);
    print_waves("              lines at ", line_m, lines);
}

void inspection_print(const char *path, const struct inspection *f)
{
    const struct roughness *r = &f->roughness;
    static const char *const grids[] = {"uniform", "rounded x, nominal spacing used", "uneven x, interpolated"};
    static const char *const level_labels[LEVEL_COUNT] = {"as it is",     "mean out", "line out",
                                                          "parabola out", "arc out",  "robust line"};
    enum level level = f->options.periodic_mean && f->profile.periodic ? LEVEL_MEAN : f->options.level;
    print_shown("", path);
    printf("  format      %s, x in %s, z in %s\n", f->scan.format, f->scan.x_unit, f->scan.z_unit);
    if (f->scan.kind == SCAN_AREAL)
        printf("  points      %zu x %zu, spacing %.6g um x %.6g um, %zu missing\n"
               "  plane out   Sq %.6g um, Sa %.6g um, Sz %.6g um; below: rows, each over its line\n",
               f->scan.nx, f->scan.ny, f->scan.dx_m * 1e6, f->scan.dy_m * 1e6, f->scan.missing, f->areal.sq_m * 1e6,
               f->areal.sa_m * 1e6, f->areal.sz_m * 1e6);
    else
        printf("  points      %zu, spacing %.6g um (%s), length %.6g mm\n"
               "  %-11s tilt %.4g um/mm, end-to-end jump left %.4g um%s\n",
               f->scan.nx, f->profile.spacing_m * 1e6, grids[f->profile.grid], inspection_length_m(f) * 1e3,
               level_labels[level], f->profile.tilt * 1e3, f->profile.end_jump_m * 1e6,
               f->profile.periodic ? ", periodic" : "");
    if (f->has_parameters)
        print_parameters(&f->primary);
    if (f->has_filtered)
        print_parameters(&f->filtered);
    printf("  roughness   Rq %.6g um, Ra %.6g um, peak to valley %.6g um\n", r->rq_m * 1e6, r->ra_m * 1e6,
           r->pv_m * 1e6);
    printf("  moments     m2 %.6g, m4 %.6g /um2, ", r->m2, r->m4_per_m2 * 1e-12);
    double nayak = roughness_nayak(r);
    if (isnan(nayak))
        printf("Nayak - (no slope from a point to the next but one)\n");
    else
        printf("Nayak %.4g\n", nayak);
    print_law(f);
    const char *warning;
    for (size_t w = 0; (warning = warning_at(f, w)); w++)
        print_shown("  note        ", warning);
}
