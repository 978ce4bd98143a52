#include "cli/inspection.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double all_wavelengths[2] = {0, INFINITY};

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

static enum status_code look_at_profile(struct inspection *out, struct status *status)
{
    struct profile *profile = &out->profile;
    if (profile_make(profile, &out->scan, 0, &out->options, status) != STATUS_OK)
        return status->code;
    out->roughness = profile->measured_x_m
                         ? roughness_of_points(profile->measured_x_m, profile->measured_z_m, profile->points)
                         : roughness_of_heights(profile->height_m, profile->points, profile->spacing_m);
    if (compute_parameters(out, status) != STATUS_OK)
        return status->code;
    return spectrum_compute(&out->spectrum, profile->height_m, profile->points, profile->spacing_m,
                            spectrum_window_for(SPECTRUM_WINDOW_AUTO, profile->periodic), status);
}

/** The law as a report would fit it. */
static enum status_code fit_law(struct inspection *out, struct status *status)
{
    const struct profile_options *options = &out->options;
    bool map = out->scan.kind == SCAN_AREAL;
    const double cut[2] = {options->lambda_s_m, options->lambda_c_m > 0 ? options->lambda_c_m : INFINITY};
    if (out->fit == POWER_LAW_THESIS) {
        out->power_law = power_law_fit(&out->spectrum, map ? all_wavelengths : cut);
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

enum status_code inspection_make(struct inspection *out, const char *path, const struct scan_options *units,
                                 const struct profile_options *options, enum power_law_method fit,
                                 struct status *status)
{
    *out = (struct inspection){.options = *options, .fit = fit};
    if (scan_read(&out->scan, path, units, status) != STATUS_OK)
        return status->code;
    enum status_code code = out->scan.kind == SCAN_AREAL ? look_at_map(out, status) : look_at_profile(out, status);
    if (code == STATUS_OK)
        code = fit_law(out, status);
    return code == STATUS_OK ? STATUS_OK : status_prefix(status, "%s", path);
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

const char *inspection_warning(const struct inspection *inspection, size_t i)
{
    if (i < inspection->scan.warning_count)
        return inspection->scan.warnings[i];
    i -= inspection->scan.warning_count;
    return i < inspection->profile.note_count ? inspection->profile.notes[i] : NULL;
}

static json_t *real(double value)
{
    return isfinite(value) ? json_real(value) : json_null();
}

static void add_real(json_t *object, const char *key, double value)
{
    json_object_set_new(object, key, real(value));
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
        json_array_append_new(curve, real(parameters->material_ratio_m[i]));
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
    if (inspection->scan.kind == SCAN_AREAL) {
        json_object_set_new(object, "nx", json_integer((json_int_t)inspection->scan.nx));
        json_object_set_new(object, "ny", json_integer((json_int_t)inspection->scan.ny));
        add_real(object, "dx_m", inspection->scan.dx_m);
        add_real(object, "dy_m", inspection->scan.dy_m);
        add_real(object, "sq_m", inspection->areal.sq_m);
        add_real(object, "sa_m", inspection->areal.sa_m);
        add_real(object, "sz_m", inspection->areal.sz_m);
    }
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
        double value = parameters->value[p];
        if (isnan(value))
            printf("%c%s - ", parameters->letter, row->name);
        else
            printf("%c%s %.5g%s ", parameters->letter, row->name,
                   value * (length  ? 1e6
                            : ratio ? 100
                                    : 1),
                   ratio ? "%" : "");
    }
    printf("\n              lengths in um, over %.6g mm in %zu sampling length%s, slope %s\n",
           parameters->evaluation_length_m * 1e3, parameters->sampling_lengths,
           parameters->sampling_lengths == 1 ? "" : "s", parameters_slope);
}

void inspection_print(const struct inspection *inspection)
{
    if (inspection->scan.kind == SCAN_AREAL)
        printf("  plane out   Sq %.6g um, Sa %.6g um, Sz %.6g um; below: rows, each over its line\n",
               inspection->areal.sq_m * 1e6, inspection->areal.sa_m * 1e6, inspection->areal.sz_m * 1e6);
    if (inspection->has_parameters)
        print_parameters(&inspection->primary);
    if (inspection->has_filtered)
        print_parameters(&inspection->filtered);
}
