/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The surfaces, table 6.2; the files they come from, and what is to be said of them. */
#include "report/view.h"

#include "base/number_format.h"
#include "contact/cmy.h"
#include "profile/level.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** "0.0168 ×÷ 1.2": an amplitude with the factor of its standard error. */
static void put_amplitude(json_t *out, const char *name, const struct power_law *law, double wavelength_m)
{
    struct text text = {0};
    number_format(&text, power_law_amplitude(law, wavelength_m) * 1e6, 3);
    text_add(&text, " ×÷ ");
    number_format(&text, pow(10, power_law_error_decades(law, wavelength_m)), 3);
    view_text(out, name, text_string(&text));
    text_free(&text);
}

void view_law(json_t *out, const struct power_law *law)
{
    struct text gamma = {0};
    if (law->found == POWER_LAW_BAND_NONE)
        return;
    number_format_uncertain(&gamma, law->gamma, law->gamma_error);
    view_text(out, "gamma", text_string(&gamma));
    text_free(&gamma);
    view_number(out, "gamma_alone", law->gamma, 3, "");
    view_number(out, "alpha", law->alpha, 3, "");
}

/** As such a program's field takes it: 1.727e+04. */
static void put_plain(json_t *row, const char *name, double value)
{
    char text[32];
    snprintf(text, sizeof text, "%.4g", value);
    if (isfinite(value))
        view_text(row, name, text);
}

/** What programs of finite elements ask of a pair of rough surfaces, in their units, at the operating load. */
static void put_constants(json_t *row, const struct view_source *source, size_t surface)
{
    const struct surface_summary *s = view_summary(source, surface);
    const struct contact_point at = comparison_middle(source->results, source->leading, surface);
    const double load = results_operating_load(source->results, surface), joint = at.value[QUANTITY_JOINT];
    const double spots = 1 / at.value[QUANTITY_TCR];
    put_plain(row, "sigma_um", s->rough.sigma_m * 1e6);
    put_plain(row, "slope", s->rough.slope);
    put_plain(row, "hardness_GPa", s->pair.hardness_Pa > 0 ? s->pair.hardness_Pa * 1e-9 : NAN);
    put_plain(row, "pressure_MPa", s->pair.unknown ? NAN : material_pair_pressure(&s->pair, load) * 1e-6);
    put_plain(row, "spots_W_per_m2K", spots);
    put_plain(row, "tcc_W_per_mm2K", (isfinite(joint) ? joint : spots) * 1e-6);
}

static void put_surface(json_t *row, const struct view_source *source, size_t surface)
{
    const struct surface_summary *s = view_summary(source, surface);
    const struct power_law *law = &s->power_law;
    const struct repeats *repeats = &s->repeats;
    view_text(row, "surface", view_name(source, surface));
    view_number(row, "rq_um", s->roughness.rq_m * 1e6, 3, "");
    view_number(row, "ra_um", s->roughness.ra_m * 1e6, 3, "");
    view_number(row, "length_mm", s->length_m * 1e3, 3, "");
    view_number(row, "spacing_um", s->spacing_m * 1e6, 3, "");
    view_count(row, "scans", s->scans);
    view_flag(row, "rows_of_a_map", repeats->count > 0 && repeats->scans == 1);
    view_some(row, "pieces", repeats->cut);
    view_number(row, "heights", comparison_heights_factor(source->results, surface, QUANTITY_ECR), 2, "");
    put_constants(row, source, surface);
    view_law(view_part(row, "line"), &s->line);
    view_number(row, "line_rms", s->line.misfit_decades, 2, "");
    view_flag(row, "no_law", law->found == POWER_LAW_BAND_NONE);
    if (law->found == POWER_LAW_BAND_NONE)
        return;
    view_law(row, law);
    view_flag(row, "narrow", law->found == POWER_LAW_BAND_NARROW);
    if (law->found == POWER_LAW_BAND_SCATTERED)
        view_number(row, "scattered_rms", law->misfit_decades, 2, "");
    view_range(row, "band_um", law->band_m[0] * 1e6, law->band_m[1] * 1e6, 3, "");
    double wavelength_m = results_law_wavelength_m(source->results);
    put_amplitude(row, "amplitude_um", law, isfinite(wavelength_m) ? wavelength_m : law->wavelength_m);
}

/** The item of a list that is, or whose `part` is, the same as another; NULL: none. */
static json_t *alike(const json_t *list, const char *part, const json_t *other)
{
    size_t i;
    json_t *item;
    json_array_foreach(list, i, item)
    {
        if (json_equal(part ? json_object_get(item, part) : item, other))
            return item;
    }
    return NULL;
}

/** Takes what is to be said of a surface into a list of VIEW_ROWS at most, where what is the same of several stands
 * once, as the `body` of an item: with the first one's name, the others counted. */
static void put_once(json_t *list, json_t *own, const char *surface)
{
    json_t *item = alike(list, "body", own);
    if (item) {
        view_count(item, "more_surfaces", (size_t)json_integer_value(json_object_get(item, "more_surfaces")) + 1);
    } else if (json_array_size(list) < VIEW_ROWS) {
        item = view_item(list);
        json_object_set(item, "body", own);
        view_text(item, "surface", surface);
    }
    json_decref(own);
}

/** A row of table 6.1: a property of the material in the unit that engineers have it in; of a pair what the models have
 * of it. The same once. */
static void put_material(json_t *out, const struct material *material, const struct material_pair *pair)
{
    static const struct {
        const char *key;
        double scale;
    } columns[] = {{"E_Pa", 1e-9}, {"nu", 1}, {"Sy_Pa", 1e-6}, {"resistivity_ohm_m", 1}, {"conductivity_W_per_mK", 1}};
    json_t *list = view_list(out, "materials"), *row = json_object();
    view_text(row, "material", material->name);
    for (size_t c = 0; c < sizeof columns / sizeof *columns; c++) {
        const struct material_property *property = material_property_find(columns[c].key);
        view_number(row, property->name, columns[c].scale * material_value(material, property), 3, "");
    }
    if (pair && !pair->unknown) {
        view_number(row, "modulus", pair->effective_modulus_Pa * 1e-9, 3, "");
        view_number(row, "hardness", pair->hardness_Pa * 1e-6, 3, "");
    }
    view_text(row, "source", material->source ? material->source : "");
    if (!alike(list, NULL, row) && json_array_size(list) < VIEW_ROWS)
        json_array_append(list, row);
    json_decref(row);
}

/** The bodies of the surfaces, alike ones together. */
static void put_bodies(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    json_t *list = view_list(out, "bodies");
    bool some_without = false;
    for (size_t i = 0; i < results->surface_count; i++) {
        const struct scene_bodies *bodies = &view_summary(source, i)->scene->bodies;
        const struct material_pair *pair = results_pair(results, i);
        bool named = bodies->material.name[0];
        some_without = some_without || (view_summary(source, i)->usable && !named);
        if (!view_summary(source, i)->usable || !named)
            continue;
        json_t *own = json_object();
        view_text(own, "material", bodies->material.name);
        view_flag(own, "rigid_counterface", bodies->counterface_kind == MATERIAL_COUNTERFACE_RIGID);
        view_text(own, "counterface", bodies->counterface.name);
        put_once(list, own, view_name(source, i));
        put_material(out, &bodies->material, pair);
        if (bodies->counterface_kind == MATERIAL_COUNTERFACE_ELASTIC &&
            strcmp(bodies->counterface.name, bodies->material.name) != 0)
            put_material(out, &bodies->counterface, NULL);
    }
    view_separate(list);
    view_separate(view_list(out, "materials"));
    view_flag(out, "has_materials", json_array_size(view_list(out, "materials")) > 0);
    view_flag(out, "bodies_differ", some_without || json_array_size(list) > 1);
}

void view_surfaces(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    const struct scene *scene = results->scene;
    json_t *item = view_part(out, "surfaces"), *rows = view_list(item, "rows");
    view_flag(item, "gaps", plan_quantities(source->results->plan) & QUANTITY_BIT(QUANTITY_JOINT));
    size_t scans = 0, of_maps = 0, periodic = 0, windowed = 0, lawless = 0, last_lawless = 0;
    bool has_heights = false;
    for (size_t i = 0; i < results->surface_count; i++) {
        const struct surface_summary *s = view_summary(source, i);
        if (!s->usable)
            continue;
        scans += s->scans;
        of_maps += s->repeats.count > 0 && s->repeats.scans == 1 ? s->scans : 0;
        periodic += s->periodic;
        windowed += s->windowed;
        bool law = power_law_holds(&s->power_law);
        lawless += !law;
        last_lawless = law ? last_lawless : i;
        has_heights = has_heights || isfinite(comparison_heights_factor(results, i, QUANTITY_ECR));
        if (json_array_size(rows) < VIEW_ROWS)
            put_surface(view_item(rows), source, i);
    }
    view_flag(item, "has_heights", has_heights);
    view_flag(item, "has_bands", scene->fit != POWER_LAW_THESIS);
    if (scene->fit_band_m[0] > 0 || isfinite(scene->fit_band_m[1]))
        view_range(item, "fit_band_um", scene->fit_band_m[0] * 1e6, scene->fit_band_m[1] * 1e6, 3, "µm");
    if (results->usable_count > VIEW_ROWS)
        view_count(item, "rows_left_out", results->usable_count - VIEW_ROWS);
    view_text(item, "level", level_names[scene->level]);
    view_flag(item, "level_given", scene->level_given);
    view_count(item, "scans", scans);
    view_flag(item, "one_scan", scans == 1);
    view_flag(item, of_maps == scans ? "all_rows" : "some_rows", of_maps > 0);
    view_flag(item, "all_periodic", periodic == scans);
    view_flag(item, "some_periodic", periodic > 0 && periodic < scans);
    view_count(item, "periodic", periodic);
    view_flag(item, "all_windowed", windowed == scans);
    view_flag(item, "some_windowed", windowed > 0 && windowed < scans);
    view_number(item, "wavelength_um", results_law_wavelength_m(results) * 1e6, 3, "");
    view_counted(item, "lawless", lawless, view_name(source, last_lawless));
    if (results->counterface)
        view_number(item, "counterface_rq_um", results->counterface->summary.roughness.rq_m * 1e6, 3, "");
    put_bodies(item, source);
    view_flag(item, "isotropic", !source->baseline->summary.has_lay);
}

/* ---- Inputs ---- */

static void put_notes(json_t *out, const struct view_source *source)
{
    for (size_t i = 0; i < source->results->surface_count; i++)
        for (size_t n = 0; n < view_summary(source, i)->notes.count; n++) {
            struct text line = {0};
            json_t *own = json_object();
            note_line(&line, source->words, &view_summary(source, i)->notes.notes[n]);
            view_text(own, "line", text_string(&line));
            put_once(view_list(out, "notes"), own, view_name(source, i));
            text_free(&line);
        }
}

static void put_files(json_t *row, const struct surface_summary *s)
{
    json_t *files = view_list(row, "files");
    for (size_t f = 0; f < s->scene->files.count && f < 5; f++)
        view_text(view_item(files), "file", s->scene->files.path[f]);
    view_separate(files);
    if (s->scene->files.count > 5)
        view_count(row, "more_files", s->scene->files.count - 5);
}

void view_inputs(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    json_t *item = view_part(out, "inputs"), *rows = view_list(item, "rows"), *refused = view_list(item, "refused");
    for (size_t i = 0; i < results->surface_count; i++) {
        const struct surface_summary *s = view_summary(source, i);
        if (s->refusal && json_array_size(refused) < VIEW_ROWS) {
            json_t *row = view_item(refused);
            view_text(row, "surface", view_name(source, i));
            view_text(row, "why", s->refusal);
        }
        if (!s->usable || json_array_size(rows) >= VIEW_ROWS)
            continue;
        json_t *row = view_item(rows);
        char hash[17];
        view_text(row, "surface", view_name(source, i));
        put_files(row, s);
        view_text(row, "format", s->format);
        view_text(row, "units", s->units);
        snprintf(hash, sizeof hash, "%.16s", s->hash);
        view_text(row, "hash", hash);
    }
    put_notes(item, source);
    view_flag(item, "binned_spectra", scene_bins_spectra(results->scene));
    for (const char *line = results->scene->passed_over; line && *line;
         line += strcspn(line, "\n"), line += *line == '\n') {
        char *one = strndup(line, strcspn(line, "\n"));
        if (one)
            view_text(view_item(view_list(item, "passed_over")), "line", one);
        free(one);
    }
    json_t *sources = view_list(item, "sources");
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(results->plan, m)) {
            json_t *row = view_item(sources);
            view_text(row, "label", model_rows[m]->label);
            view_text(row, "source", model_rows[m]->source);
            if (model_rows[m]->equations)
                view_text(row, "equations", model_rows[m]->equations);
        }
}
