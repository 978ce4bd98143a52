/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "library/host.h"
#include "library/roughcontact.h"
#include "members/curve_summary.h"
#include "profile/profile.h"
#include "scene/scene.h"
#include "spectrum/power_law_scans.h"
#include "spectrum/roughness.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct roughcontact_scan {
    struct scan scan;
};

struct roughcontact_surface {
    struct profile profile;
    struct spectrum spectrum;
    struct asperities asperities;
    struct cmy rough;
    bool has_asperities;
    struct status problem; /* why there are none */
    struct roughcontact_roughness roughness;
    struct roughcontact_spectrum shown_spectrum;
    struct roughcontact_power_law power_law;
};

struct roughcontact_material {
    struct material material;
};

struct roughcontact_curve {
    size_t count;
    struct roughcontact_point *points;
};

/** Gives the host its settings back; `problem` goes to the caller's status (NULL: nowhere). The public code of it. */
static int end(const struct host *host, const struct status *problem, struct roughcontact_status *status)
{
    static const int codes[STATUS_INTERRUPTED + 1] = {
        [STATUS_MEMORY] = ROUGHCONTACT_MEMORY, [STATUS_IO] = ROUGHCONTACT_IO,
        [STATUS_USAGE] = ROUGHCONTACT_USAGE,   [STATUS_SCAN] = ROUGHCONTACT_SCAN,
        [STATUS_MODEL] = ROUGHCONTACT_MODEL,   [STATUS_NUMBER] = ROUGHCONTACT_NUMBER};
    host_give_back(host);
    if (status) {
        status->code = codes[problem->code];
        struct text shown = {0}; /* names of files and surfaces are in it */
        text_add_shown(&shown, problem->message);
        const char *message = shown.failed ? "out of memory" : text_string(&shown);
        snprintf(status->message, sizeof status->message, "%.*s", (int)text_fit(message, sizeof status->message - 1),
                 message);
        text_free(&shown);
    }
    return codes[problem->code];
}

/** Does `work`, by which `problem` comes about, with the host's settings put aside. */
#define LIBRARY_CALL(work)                                                                                             \
    struct host host;                                                                                                  \
    struct status problem = {0};                                                                                       \
    host_put_aside(&host);                                                                                             \
    (void)(work);                                                                                                      \
    return end(&host, &problem, status)

static const struct roughcontact_scan_options scan_defaults;
static const struct roughcontact_surface_options surface_defaults = {.row = ROUGHCONTACT_NO_ROW};
static const struct roughcontact_run_options run_defaults = {.hardness_Pa = NAN};

void roughcontact_scan_options_init(struct roughcontact_scan_options *options)
{
    *options = scan_defaults;
}

void roughcontact_surface_options_init(struct roughcontact_surface_options *options)
{
    *options = surface_defaults;
}

void roughcontact_run_options_init(struct roughcontact_run_options *options)
{
    *options = run_defaults;
}

/** Reads the file at `path`, or with `path` NULL the bytes of `given`. */
static enum status_code read_scan(struct roughcontact_scan **out, const char *path, const struct scan_bytes *given,
                                  const struct roughcontact_scan_options *options, struct status *status)
{
    const struct roughcontact_scan_options own = options ? *options : scan_defaults;
    struct text copy = {0};
    *out = NULL;
    if (!path && !given->bytes)
        return status_fail(status, STATUS_USAGE, given->path ? "there are no bytes" : "no file is named");
    const char *const units[2] = {own.x_unit, own.z_unit};
    for (int axis = 0; axis < 2; axis++)
        if (units[axis] && *units[axis] && !(scan_unit_m(units[axis]) > 0))
            return status_fail(status, STATUS_USAGE, "%c_unit is '%.60s'; give a unit of length such as mm or um",
                               "xz"[axis], units[axis]);
    const struct scan_options how = {.x_unit = own.x_unit, .z_unit = own.z_unit};
    struct roughcontact_scan *made = calloc(1, sizeof *made);
    if (!made)
        return status_memory(status);
    if (!path)
        text_add_bytes(&copy, given->bytes, given->length); /* readers want a NUL behind the last byte */
    struct scan_bytes bytes = {text_string(&copy), copy.length, given->path};
    enum status_code code = path          ? scan_read(&made->scan, path, &how, status)
                            : copy.failed ? status_memory(status)
                                          : scan_read_bytes(&made->scan, &bytes, &how, status);
    text_free(&copy);
    if (code != STATUS_OK) {
        roughcontact_scan_free(made);
        return code;
    }
    if (made->scan.next_entry > 0)
        scan_warn(&made->scan, "the archive holds several scans; '%.60s', the first, is read", made->scan.part);
    *out = made;
    return STATUS_OK;
}

int roughcontact_scan_read_file(struct roughcontact_scan **out, const char *path,
                                const struct roughcontact_scan_options *options, struct roughcontact_status *status)
{
    LIBRARY_CALL(read_scan(out, path, &(struct scan_bytes){.path = path}, options, &problem));
}

int roughcontact_scan_read_bytes(struct roughcontact_scan **out, const void *bytes, size_t length, const char *name,
                                 const struct roughcontact_scan_options *options, struct roughcontact_status *status)
{
    const struct scan_bytes given = {bytes || length > 0 ? bytes : "", length, name ? name : "scan"};
    LIBRARY_CALL(read_scan(out, NULL, &given, options, &problem));
}

const char *roughcontact_scan_warning(const struct roughcontact_scan *scan, size_t i)
{
    return i < scan->scan.warning_count ? scan->scan.warnings[i] : NULL;
}

void roughcontact_scan_free(struct roughcontact_scan *scan)
{
    if (scan)
        scan_free(&scan->scan);
    free(scan);
}

static const int laws[] = {[POWER_LAW_BAND_NONE] = ROUGHCONTACT_LAW_NONE,
                           [POWER_LAW_BAND_SCATTERED] = ROUGHCONTACT_LAW_SCATTERED,
                           [POWER_LAW_BAND_NARROW] = ROUGHCONTACT_LAW_NARROW,
                           [POWER_LAW_BAND_LAW] = ROUGHCONTACT_LAW_FOUND};

/** The same ranges as those of the scene's keys. */
static enum status_code check_options(const struct roughcontact_surface_options *o, struct status *status)
{
    static const char *const names[] = {"lambda_s_m", "lambda_c_m"};
    const double values[] = {o->lambda_s_m, o->lambda_c_m};
    for (int i = 0; i < 2; i++)
        if (!(values[i] == 0 || (values[i] >= 1e-12 && values[i] <= 1e3)))
            return status_fail(status, STATUS_USAGE, "%s is %g; allowed is 1e-12 to 1000, or 0", names[i], values[i]);
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
static enum status_code fit_law(struct roughcontact_power_law *out, const struct profile *profile,
                                const struct spectrum *spectrum, double lambda_s_m, struct status *status)
{
    const struct power_law_scans_def def = {.lambda_s_m = lambda_s_m};
    struct power_law_scans scans = {0};
    struct power_law_band band;
    enum status_code code =
        power_law_scans_add(&scans, profile->height_m, profile->points, profile->spacing_m, profile->digit_m, status);
    if (code == STATUS_OK)
        code = power_law_scans_fit(&band, &scans, &def, status);
    if (code == STATUS_OK) {
        struct power_law law = power_law_of_band(&band, spectrum);
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
    out->rough = (struct cmy){r.rq_m, cmy_slope(r.m2)};
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
    return fit_law(&out->power_law, profile, &out->spectrum, lambda_s_m, status);
}

static enum status_code make(struct roughcontact_surface **out, const struct roughcontact_scan *scan,
                             const struct roughcontact_surface_options *options, struct status *status)
{
    const struct roughcontact_surface_options own = options ? *options : surface_defaults;
    size_t row;
    *out = NULL;
    if (!scan)
        return status_fail(status, STATUS_USAGE, "no scan is given");
    if (check_options(&own, status) != STATUS_OK || find_row(&row, &scan->scan, own.row, status) != STATUS_OK)
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
    LIBRARY_CALL(make(out, scan, options, &problem));
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

static enum status_code new_material(struct roughcontact_material **out, const char *name, struct status *status)
{
    const struct material *found = name ? material_find(name) : NULL;
    *out = NULL;
    if (name && !found)
        return status_fail(status, STATUS_USAGE,
                           "unknown material '%.60s'; `roughcontact materials` lists those that are known", name);
    if (!(*out = malloc(sizeof **out)))
        return status_memory(status);
    (*out)->material = found ? *found : material_unknown("");
    return STATUS_OK;
}

int roughcontact_material_new(struct roughcontact_material **out, const char *name, struct roughcontact_status *status)
{
    LIBRARY_CALL(new_material(out, name, &problem));
}

static enum status_code set_property(struct roughcontact_material *material, const char *key, double value,
                                     struct status *status)
{
    const struct material_property *property = key ? material_property_find(key) : NULL;
    if (!material)
        return status_fail(status, STATUS_USAGE, "no material is given");
    if (!property)
        return status_fail(status, STATUS_USAGE,
                           "no property is called '%.60s'; `roughcontact materials --json` has those that are known",
                           key ? key : "");
    if (!(value >= property->least && value <= property->most))
        return status_fail(status, STATUS_USAGE, "%s is %g; allowed is %g to %g", key, value, property->least,
                           property->most);
    memcpy((char *)&material->material + property->offset, &value, sizeof value);
    return STATUS_OK;
}

int roughcontact_material_set(struct roughcontact_material *material, const char *key, double value,
                              struct roughcontact_status *status)
{
    LIBRARY_CALL(set_property(material, key, value, &problem));
}

void roughcontact_material_free(struct roughcontact_material *material)
{
    free(material);
}

const char *roughcontact_model_name(size_t i)
{
    return i < model_count ? model_rows[i]->name : NULL;
}

static const struct model_row *find_model(const char *name)
{
    for (size_t m = 0; name && m < model_count; m++)
        if (strcmp(model_rows[m]->name, name) == 0)
            return model_rows[m];
    return NULL;
}

/** QUANTITY_BITs of all that the bodies have the properties for. */
static unsigned find_wanted(const struct scene_bodies *bodies)
{
    static const enum effect effects[] = {EFFECT_SEPARATION, EFFECT_ELECTRICAL, EFFECT_THERMAL, EFFECT_SCALE_DEPENDENT};
    unsigned running = 0;
    const char *body;
    for (size_t e = 0; e < sizeof effects / sizeof *effects; e++)
        if (!scene_lack(&body, bodies, &effect_rows[effects[e]]))
            running |= EFFECT_BIT(effects[e]);
    return quantity_wanted(running);
}

static enum status_code check_body(const struct roughcontact_material *body, const char *which, struct status *status)
{
    for (const char *const *key = (const char *const[]){"E_Pa", "nu", NULL}; body && *key; key++)
        if (isnan(material_value(&body->material, material_property_find(*key))))
            return status_fail(status, STATUS_USAGE, "the %s has no %s; set it by roughcontact_material_set()", which,
                               *key);
    return STATUS_OK;
}

static enum status_code take_bodies(struct scene_bodies *out, const struct roughcontact_run_options *options,
                                    struct status *status)
{
    const struct roughcontact_material *material = options->material, *counterface = options->counterface;
    *out = (struct scene_bodies){.material = material ? material->material : material_unknown(""),
                                 .counterface_kind =
                                     counterface ? MATERIAL_COUNTERFACE_ELASTIC : MATERIAL_COUNTERFACE_RIGID,
                                 .counterface = counterface ? counterface->material : material_unknown(""),
                                 .hardness_Pa = options->hardness_Pa};
    if (!material && (counterface || options->hardness_Pa > 0))
        return status_fail(status, STATUS_USAGE, "a %s is given, but no material",
                           counterface ? "counterface" : "hardness");
    if (check_body(material, "material", status) != STATUS_OK ||
        check_body(counterface, "counterface", status) != STATUS_OK)
        return status->code;
    if (!isnan(options->hardness_Pa) && !(options->hardness_Pa >= 1e3 && options->hardness_Pa <= 1e12))
        return status_fail(status, STATUS_USAGE, "hardness_Pa is %g; allowed is 1e3 to 1e12, or NaN",
                           options->hardness_Pa);
    return STATUS_OK;
}

/** Can this model answer? */
static enum status_code check_model(const struct model_row *row, const char *name,
                                    const struct roughcontact_surface *surface, const struct scene_bodies *bodies,
                                    struct status *status)
{
    const char *body;
    if (!row)
        return status_fail(status, STATUS_USAGE,
                           "unknown model '%.60s'; roughcontact_model_name() has those that are known",
                           name ? name : "");
    const struct material_property *lack =
        row->plastic ? scene_lack(&body, bodies, &effect_rows[EFFECT_PLASTICITY]) : NULL;
    if (lack)
        return status_fail(status, STATUS_USAGE, "model '%s' needs a material with %s", row->name, lack->key);
    if (row->asperity_model && !surface->has_asperities)
        return status_fail(status, STATUS_MODEL, "no %s for this surface: %s", row->name, surface->problem.message);
    return STATUS_OK;
}

/** The loads as P/(A_n E'), malloc'ed. */
static enum status_code take_loads(double **out, const struct model_task *asked,
                                   const struct roughcontact_run_options *options, const struct material_pair *pair,
                                   struct status *status)
{
    bool pressure = options->load == ROUGHCONTACT_LOAD_PRESSURE_PA;
    if (!pressure && options->load != ROUGHCONTACT_LOAD_OVER_MODULUS)
        return status_fail(status, STATUS_USAGE, "load %d is not known; give one of roughcontact_load", options->load);
    if (pressure && pair->unknown)
        return status_fail(status, STATUS_USAGE, "loads in Pa need a material; without one they are P/(A_n E')");
    if (!asked->loads || asked->load_count == 0)
        return status_fail(status, STATUS_USAGE, "no loads are given");
    double *all = malloc(asked->load_count * sizeof *all);
    *out = all;
    if (!all)
        return status_memory(status);
    for (size_t i = 0; i < asked->load_count; i++) {
        all[i] = pressure ? asked->loads[i] / pair->effective_modulus_Pa : asked->loads[i];
        if (!(all[i] > 0 && isfinite(all[i]) && (i == 0 || all[i] > all[i - 1])))
            return status_fail(status, STATUS_USAGE, "load %zu is %g; loads are to be above 0, finite and ascending",
                               i + 1, asked->loads[i]);
    }
    return STATUS_OK;
}

/** One point a load; those that the curve does not have, as a statistical model's beyond full contact, do not exist. */
static void show_curve(struct roughcontact_curve *out, const struct model_curve *curve, const struct model_row *row,
                       const struct model_task *task)
{
    const struct curve_validity valid = curve_summary_validity(curve, row);
    const struct contact_point nothing = quantity_nothing();
    size_t at = 0;
    for (size_t i = 0; i < task->load_count; i++) {
        double load = task->loads[i];
        while (at < curve->count && curve->points[at].value[QUANTITY_LOAD] < load)
            at++;
        bool exists = at < curve->count && curve->points[at].value[QUANTITY_LOAD] == load;
        const struct contact_point *point = exists ? &curve->points[at] : &nothing;
        out->points[i] = (struct roughcontact_point){.exists = exists,
                                                     .valid = exists && at >= valid.first && at < valid.end,
                                                     .load = load,
                                                     .pressure_Pa = material_pair_pressure(task->pair, load),
                                                     .area_ratio = point->value[QUANTITY_AREA],
                                                     .separation_m = point->value[QUANTITY_SEPARATION],
                                                     .ecr_ohm_m2 = point->value[QUANTITY_ECR],
                                                     .tcr_K_m2_per_W = point->value[QUANTITY_TCR],
                                                     .tcr_sd_K_m2_per_W = point->value[QUANTITY_TCR_SCALE_DEPENDENT]};
    }
}

/** Runs the model of a task that was checked. */
static enum status_code solve(struct roughcontact_curve *out, const struct model_row *row,
                              const struct model_task *task, struct status *status)
{
    struct model_curve curve = {.points = calloc(task->load_count + 1, sizeof *curve.points)};
    out->count = task->load_count;
    out->points = calloc(task->load_count, sizeof *out->points);
    enum status_code code = curve.points && out->points ? model_run(&curve, row, task, status) : status_memory(status);
    if (code == STATUS_OK && curve.overflows)
        code = status_fail(status, STATUS_NUMBER,
                           "no %s: its numbers leave what can be computed with; check the units, the material and "
                           "the loads",
                           row->name);
    else if (code == STATUS_OK && !curve.exists)
        code = status_fail(status, STATUS_MODEL, "%s has no solution for this surface", row->name);
    if (code == STATUS_OK)
        show_curve(out, &curve, row, task);
    free(curve.points);
    return code;
}

/** The profile as a strip, malloc'ed, of a model that works on it. */
static enum status_code solve_strip(struct strip **out, const struct model_row *row, const struct strip_rows *profile,
                                    struct status *status)
{
    struct status problem = {0};
    if (!row->uses_strip)
        return STATUS_OK;
    if (!(*out = malloc(sizeof **out)))
        return status_memory(status);
    enum status_code code = strip_solve(*out, profile, STRIP_SURROGATES, NULL, &problem);
    return code == STATUS_OK ? STATUS_OK
                             : status_fail(status, code, "no %s for this surface: %s", row->name, problem.message);
}

static enum status_code run(struct roughcontact_curve **out, const struct roughcontact_surface *surface,
                            const char *model, const struct model_task *asked,
                            const struct roughcontact_run_options *options, struct status *status)
{
    const struct roughcontact_run_options own = options ? *options : run_defaults;
    struct scene_bodies bodies;
    const struct model_row *row = find_model(model);
    double *over_modulus = NULL;
    struct strip *strip = NULL;
    struct bearing bearing = {0};
    *out = NULL;
    if (!surface)
        return status_fail(status, STATUS_USAGE, "no surface is given");
    if (take_bodies(&bodies, &own, status) != STATUS_OK ||
        check_model(row, model, surface, &bodies, status) != STATUS_OK)
        return status->code;
    const struct material_pair pair = scene_pair(&bodies);
    struct roughcontact_curve *made = calloc(1, sizeof *made);
    enum status_code code = made ? take_loads(&over_modulus, asked, &own, &pair, status) : status_memory(status);
    const struct profile *profile = &surface->profile;
    const struct strip_rows rows = {profile->height_m, 1, profile->points, profile->spacing_m, profile->periodic, NULL};
    if (code == STATUS_OK)
        code = solve_strip(&strip, row, &rows, status);
    if (code == STATUS_OK && strip)
        code = bearing_make(&bearing, &rows, status);
    if (code == STATUS_OK) {
        const struct model_task task = {.spectrum = &surface->spectrum,
                                        .rough = surface->rough,
                                        .asperities = surface->has_asperities ? &surface->asperities : NULL,
                                        .pair = &pair,
                                        .loads = over_modulus,
                                        .load_count = asked->load_count,
                                        .wanted = find_wanted(&bodies),
                                        .tolerance = 1e-6, /* the scene's default */
                                        .sinusoid_fit = SINUSOID_FIT_THESIS,
                                        .hardness_Pa = pair.hardness_Pa,
                                        .levelled = !profile->periodic,
                                        .rows = &rows,
                                        .strip = strip,
                                        .bearing = strip ? &bearing : NULL};
        code = solve(made, row, &task, status);
    }
    free(over_modulus);
    free(strip);
    bearing_free(&bearing);
    if (code == STATUS_OK)
        *out = made;
    else
        roughcontact_curve_free(made);
    return code;
}

int roughcontact_run(struct roughcontact_curve **out, const struct roughcontact_surface *surface, const char *model,
                     const double *loads, size_t count, const struct roughcontact_run_options *options,
                     struct roughcontact_status *status)
{
    const struct model_task asked = {.loads = loads, .load_count = count};
    LIBRARY_CALL(run(out, surface, model, &asked, options, &problem));
}

const struct roughcontact_point *roughcontact_curve_point(const struct roughcontact_curve *curve, size_t i)
{
    return i < curve->count ? &curve->points[i] : NULL;
}

void roughcontact_curve_free(struct roughcontact_curve *curve)
{
    if (curve)
        free(curve->points);
    free(curve);
}
