/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "library/library.h"

#include "analysis/curve_summary.h"
#include "contact/model.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct roughcontact_run_options defaults = {
    .size = sizeof defaults, .hardness_Pa = NAN, .load = ROUGHCONTACT_LOAD_OVER_MODULUS};

struct roughcontact_curve {
    size_t count;
    struct roughcontact_point *points;
};

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

void roughcontact_run_options_init(struct roughcontact_run_options *options, size_t size)
{
    library_init(options, size, &defaults, sizeof defaults);
}

/** The bodies of a contact. */
struct bodies {
    const struct material *material, *counterface; /* NULL: none; a rigid flat */
};

static bool is_known(const struct material *material, const char *key)
{
    return !isnan(material_value(material, material_property_find(key)));
}

/** The first property that an effect needs and a body does not have; NULL: there is none. */
static const char *find_lack(const struct bodies *bodies, enum effect effect)
{
    for (const char *const *key = effect_rows[effect].properties; *key; key++)
        if (!bodies->material || !is_known(bodies->material, *key) ||
            (bodies->counterface && !is_known(bodies->counterface, *key)))
            return *key;
    return NULL;
}

/** QUANTITY_BITs of all that the bodies have the properties for. */
static unsigned find_wanted(const struct bodies *bodies)
{
    static const enum effect effects[] = {EFFECT_SEPARATION, EFFECT_ELECTRICAL, EFFECT_THERMAL, EFFECT_SCALE_DEPENDENT};
    unsigned running = 0;
    for (size_t e = 0; e < sizeof effects / sizeof *effects; e++)
        if (!find_lack(bodies, effects[e]))
            running |= EFFECT_BIT(effects[e]);
    return quantity_wanted(running);
}

static enum status_code check_body(const struct material *material, const char *which, struct status *status)
{
    for (const char *const *key = (const char *const[]){"E_Pa", "nu", NULL}; material && *key; key++)
        if (!is_known(material, *key))
            return status_fail(status, STATUS_USAGE, "the %s has no %s; set it by roughcontact_material_set()", which,
                               *key);
    return STATUS_OK;
}

static enum status_code take_bodies(struct bodies *out, struct material_pair *pair,
                                    const struct roughcontact_run_options *options, struct status *status)
{
    *out = (struct bodies){options->material ? &options->material->material : NULL,
                           options->counterface ? &options->counterface->material : NULL};
    *pair = material_pair_unknown();
    if (!out->material && (out->counterface || options->hardness_Pa > 0))
        return status_fail(status, STATUS_USAGE, "a %s is given, but no material",
                           out->counterface ? "counterface" : "hardness");
    if (check_body(out->material, "material", status) != STATUS_OK ||
        check_body(out->counterface, "counterface", status) != STATUS_OK)
        return status->code;
    if (!isnan(options->hardness_Pa) && !(options->hardness_Pa >= 1e3 && options->hardness_Pa <= 1e12))
        return status_fail(status, STATUS_USAGE, "hardness_Pa is %g; allowed is 1e3 to 1e12, or NaN",
                           options->hardness_Pa);
    if (out->material)
        *pair =
            material_pair(out->material, out->counterface ? MATERIAL_COUNTERFACE_ELASTIC : MATERIAL_COUNTERFACE_RIGID,
                          out->counterface ? out->counterface : out->material);
    if (options->hardness_Pa > 0)
        pair->hardness_Pa = options->hardness_Pa;
    return STATUS_OK;
}

/** Can this model answer? */
static enum status_code check_model(const struct model_row *row, const char *name,
                                    const struct roughcontact_surface *surface, const struct bodies *bodies,
                                    struct status *status)
{
    if (!row)
        return status_fail(status, STATUS_USAGE,
                           "unknown model '%.60s'; roughcontact_model_name() has those that are known",
                           name ? name : "");
    const char *lack = row->plastic ? find_lack(bodies, EFFECT_PLASTICITY) : NULL;
    if (lack && !bodies->material)
        return status_fail(status, STATUS_USAGE, "model '%s' needs a material with %s", row->name, lack);
    if (lack)
        return status_fail(status, STATUS_USAGE, "model '%s' needs %s; set it by roughcontact_material_set()",
                           row->name, lack);
    if (row->asperity_model && !surface->has_asperities)
        return status_fail(status, STATUS_MODEL, "no %s for this surface: %s", row->name, surface->problem.message);
    return STATUS_OK;
}

/** The loads as P/(A_n E'), malloc'ed. */
static enum status_code take_loads(double **out, const double *loads, size_t count,
                                   const struct roughcontact_run_options *options, const struct material_pair *pair,
                                   struct status *status)
{
    bool pressure = options->load == ROUGHCONTACT_LOAD_PRESSURE_PA;
    if (!pressure && options->load != ROUGHCONTACT_LOAD_OVER_MODULUS)
        return status_fail(status, STATUS_USAGE, "load %d is not known; give one of roughcontact_load", options->load);
    if (pressure && pair->unknown)
        return status_fail(status, STATUS_USAGE, "loads in Pa need a material; without one they are P/(A_n E')");
    if (!loads || count == 0)
        return status_fail(status, STATUS_USAGE, "no loads are given");
    double *all = malloc(count * sizeof *all);
    *out = all;
    if (!all)
        return status_memory(status);
    for (size_t i = 0; i < count; i++) {
        all[i] = pressure ? loads[i] / pair->effective_modulus_Pa : loads[i];
        if (!(all[i] > 0 && isfinite(all[i]) && (i == 0 || all[i] > all[i - 1])))
            return status_fail(status, STATUS_USAGE, "load %zu is %g; loads are to be above 0, finite and ascending",
                               i + 1, loads[i]);
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
    static const size_t only = 0;
    struct status problem = {0};
    if (!row->uses_strip)
        return STATUS_OK;
    if (!(*out = malloc(sizeof **out)))
        return status_memory(status);
    enum status_code code = strip_solve(*out, profile, &only, 1, STRIP_SURROGATES, NULL, &problem);
    return code == STATUS_OK ? STATUS_OK
                             : status_fail(status, code, "no %s for this surface: %s", row->name, problem.message);
}

static enum status_code run(struct roughcontact_curve **out, const struct roughcontact_surface *surface,
                            const char *model, const double *loads, size_t count,
                            const struct roughcontact_run_options *options, struct status *status)
{
    struct roughcontact_run_options own = defaults;
    struct bodies bodies;
    struct material_pair pair;
    const struct model_row *row = find_model(model);
    double *over_modulus = NULL;
    struct strip *strip = NULL;
    if (!surface)
        return status_fail(status, STATUS_USAGE, "no surface is given");
    if (library_take(&own, sizeof own, options, "roughcontact_run_options_init", status) != STATUS_OK ||
        take_bodies(&bodies, &pair, &own, status) != STATUS_OK ||
        check_model(row, model, surface, &bodies, status) != STATUS_OK)
        return status->code;
    struct roughcontact_curve *made = calloc(1, sizeof *made);
    enum status_code code = made ? take_loads(&over_modulus, loads, count, &own, &pair, status) : status_memory(status);
    const struct profile *profile = &surface->profile;
    const struct strip_rows rows = {profile->height_m, 1, profile->points, profile->spacing_m, profile->periodic};
    if (code == STATUS_OK)
        code = solve_strip(&strip, row, &rows, status);
    if (code == STATUS_OK) {
        const struct model_task task = {.spectrum = &surface->spectrum,
                                        .asperities = surface->has_asperities ? &surface->asperities : NULL,
                                        .pair = &pair,
                                        .loads = over_modulus,
                                        .load_count = count,
                                        .wanted = find_wanted(&bodies),
                                        .tolerance = 1e-6, /* the scene's default */
                                        .sinusoid_fit = SINUSOID_FIT_THESIS,
                                        .hardness_Pa = pair.hardness_Pa,
                                        .rows = &rows,
                                        .strip = strip};
        code = solve(made, row, &task, status);
    }
    free(over_modulus);
    free(strip);
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
    struct host host;
    struct status problem = {0};
    host_put_aside(&host);
    *out = NULL;
    (void)run(out, surface, model, loads, count, options, &problem);
    return library_end(&host, &problem, status);
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
