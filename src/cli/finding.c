#include "cli/finding.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double all_wavelengths[2] = {0, INFINITY};

static enum status_code look_at_map(struct finding *out, struct status *status)
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
static enum status_code compute_parameters(struct finding *out, struct status *status)
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

static enum status_code look_at_profile(struct finding *out, struct status *status)
{
    struct profile *profile = &out->profile;
    if (profile_make(profile, &out->scan, 0, &out->options, status) != STATUS_OK)
        return status->code;
    out->roughness = profile->measured_x_m
                         ? roughness_of_points(profile->measured_x_m, profile->measured_z_m, profile->points)
                         : roughness_of_heights(profile->height_m, profile->points, profile->spacing_m);
    if (compute_parameters(out, status) != STATUS_OK)
        return status->code;
    return spectrum_compute(&out->spectrum, profile->height_m, profile->points, profile->spacing_m, SCENE_WINDOW_NONE,
                            status);
}

enum status_code finding_make(struct finding *out, const char *path, const struct scan_options *units,
                              const struct profile_options *options, struct status *status)
{
    *out = (struct finding){.options = *options};
    if (scan_read(&out->scan, path, units, status) != STATUS_OK)
        return status->code;
    enum status_code code = out->scan.kind == SCAN_AREAL ? look_at_map(out, status) : look_at_profile(out, status);
    if (code != STATUS_OK)
        return status_prefix(status, "%s", path);
    double cut[2] = {options->lambda_s_m, options->lambda_c_m > 0 ? options->lambda_c_m : INFINITY};
    out->law = powerlaw_fit(&out->spectrum, out->scan.kind == SCAN_AREAL ? all_wavelengths : cut);
    return STATUS_OK;
}

void finding_free(struct finding *finding)
{
    spectrum_free(&finding->spectrum);
    areal_free(&finding->areal);
    profile_free(&finding->profile);
    scan_free(&finding->scan);
}

double finding_spacing_m(const struct finding *finding)
{
    return finding->scan.kind == SCAN_AREAL ? finding->scan.dx_m : finding->profile.spacing_m;
}

double finding_length_m(const struct finding *finding)
{
    size_t points = finding->scan.kind == SCAN_AREAL ? finding->scan.nx : finding->profile.points;
    return (double)(points - 1) * finding_spacing_m(finding);
}

const char *finding_warning(const struct finding *finding, size_t i)
{
    if (i < finding->scan.warning_count)
        return finding->scan.warnings[i];
    i -= finding->scan.warning_count;
    return i < finding->profile.note_count ? finding->profile.notes[i] : NULL;
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

void finding_add_json(json_t *object, const struct finding *finding)
{
    const struct profile_options *options = &finding->options;
    if (finding->scan.kind == SCAN_AREAL) {
        json_object_set_new(object, "nx", json_integer((json_int_t)finding->scan.nx));
        json_object_set_new(object, "ny", json_integer((json_int_t)finding->scan.ny));
        add_real(object, "dx_m", finding->scan.dx_m);
        add_real(object, "dy_m", finding->scan.dy_m);
        add_real(object, "sq_m", finding->areal.sq_m);
        add_real(object, "sa_m", finding->areal.sa_m);
        add_real(object, "sz_m", finding->areal.sz_m);
    }
    if (!finding->has_parameters)
        return;
    json_t *parameters = json_object();
    add_real(parameters, "lambda_s_m", options->lambda_s_m > 0 ? options->lambda_s_m : NAN);
    add_real(parameters, "lambda_c_m", options->lambda_c_m > 0 ? options->lambda_c_m : NAN);
    json_object_set_new(parameters, "slope", json_string(parameters_slope));
    add_parameters(parameters, &finding->primary);
    if (finding->has_filtered)
        add_parameters(parameters, &finding->filtered);
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

void finding_print(const struct finding *finding)
{
    if (finding->scan.kind == SCAN_AREAL)
        printf("  plane out   Sq %.6g um, Sa %.6g um, Sz %.6g um; below: rows, each over its line\n",
               finding->areal.sq_m * 1e6, finding->areal.sa_m * 1e6, finding->areal.sz_m * 1e6);
    if (finding->has_parameters)
        print_parameters(&finding->primary);
    if (finding->has_filtered)
        print_parameters(&finding->filtered);
}
