/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The surfaces, table 6.2; the files they come from, and what is to be said of them. */
#include "report/view.h"

#include "output/json.h"
#include "output/tables.h"
#include "profile/level.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void view_law(json_t *out, const struct power_law *law)
{
    if (law->found == POWER_LAW_BAND_NONE)
        return;
    if (isfinite(law->gamma))
        json_object_set_new(out, "gamma",
                            json_pack("{s:f, s:o}", "value", law->gamma, "error", json_finite(law->gamma_error)));
    json_set(out, "alpha", law->alpha);
}

/** A row of the table of surfaces: the numbers of the record that data/ has under the conditions `when`, or (NULL) the
 * columns' heads. */
static void put_row(json_t *cells, struct words *words, unsigned when, const struct surface_summary *of)
{
    for (const struct record_field *field = surface_fields; field->key; field++) {
        const double *value = of ? (const void *)((const char *)of + field->offset) : NULL;
        if (field->digits == 0 || !(field->when & (when | RECORD_CSV)))
            continue;
        if (value)
            view_number(view_item(cells), "text", *value / record_unit(field), field->digits, "");
        else
            view_text(view_item(cells), "label", words_say(words, "column.%s", field->key));
    }
}

/** What programs of finite elements ask of a pair of rough surfaces beside its record, at the operating load. */
static void put_constants(json_t *row, const struct view_source *source, size_t surface)
{
    const struct material_pair *pair = results_pair(source->results, surface);
    const struct contact_point at = comparison_middle(source->results, source->leading, surface);
    const double load = results_operating_load(source->results, surface), joint = at.value[QUANTITY_JOINT];
    const double spots = 1 / at.value[QUANTITY_TCR];
    json_set(row, "hardness_Pa", pair->hardness_Pa > 0 ? pair->hardness_Pa : NAN);
    json_set(row, "pressure_Pa", pair->unknown ? NAN : material_pair_pressure(pair, load));
    json_set(row, "spots_W_per_m2K", spots);
    json_set(row, "tcc_W_per_m2K", isfinite(joint) ? joint : spots);
}

static void put_surface(json_t *row, const struct view_source *source, size_t surface)
{
    const struct surface_summary *s = view_summary(source, surface);
    const struct power_law *law = &s->power_law;
    const double shared_m = results_law_wavelength_m(source->results);
    const double wavelength_m = isfinite(shared_m) ? shared_m : law->wavelength_m;
    json_object_update_new(row, record_json(surface_fields, s));
    view_text(row, "surface", view_name(source, surface));
    put_row(view_list(row, "cells"), source->words, tables_surface_when(source->results), s);
    view_flag(row, "map", s->has_map);
    view_flag(row, "several_maps", s->has_map && s->repeats.scans > 1);
    json_set_count(row, "scans", s->scans);
    view_some(row, "pieces", s->repeats.cut);
    put_constants(row, source, surface);
    view_law(view_part(row, "line"), &s->line);
    if (law->found == POWER_LAW_BAND_NONE)
        return;
    json_t *found = view_part(row, "law");
    view_law(found, law);
    view_flag(found, "narrow", law->found == POWER_LAW_BAND_NARROW);
    view_flag(found, "scattered", law->found == POWER_LAW_BAND_SCATTERED);
    view_range(found, "band_m", law->band_m[0], law->band_m[1]);
    json_set(found, "amplitude_m", power_law_amplitude(law, wavelength_m));
    json_set(found, "amplitude_factor", pow(10, power_law_error_decades(law, wavelength_m)));
}

/** Adds what is to be said of a surface to a list of VIEW_ROWS at most. What is the same of several surfaces is one
 * item, its `body`, with the first one's name and the number of others. */
static void put_once(json_t *list, json_t *own, const char *surface)
{
    json_t *item = view_alike(list, "body", own);
    if (item) {
        json_set_count(item, "more_surfaces", (size_t)json_integer_value(json_object_get(item, "more_surfaces")) + 1);
    } else if (json_array_size(list) < VIEW_ROWS) {
        item = view_item(list);
        json_object_set(item, "body", own);
        view_text(item, "surface", surface);
    }
    json_decref(own);
}

/** A row of table 6.1, of a surface's pair with what the models have of it, and its source. The same once. */
static void put_material(json_t *out, const struct material *material, const struct material_pair *pair,
                         const char *surface)
{
    json_t *row = json_material(material);
    put_once(view_list(out, "sources"),
             json_pack("{s:O, s:O}", "name", json_object_get(row, "name"), "source", json_object_get(row, "source")),
             surface);
    if (pair && !pair->unknown) {
        json_set(row, "effective_modulus_Pa", pair->effective_modulus_Pa);
        json_set(row, "hardness_Pa", pair->hardness_Pa);
    }
    put_once(view_list(out, "materials"), row, surface);
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
        const bool rigid = bodies->counterface_kind == MATERIAL_COUNTERFACE_RIGID;
        view_flag(own, "rigid_counterface", rigid);
        view_text(own, "counterface", rigid ? "" : bodies->counterface.name);
        view_flag(own, "elastic_counterface", !rigid && !bodies->counterface.name[0]);
        put_once(list, own, view_name(source, i));
        put_material(out, &bodies->material, pair, view_name(source, i));
        if (bodies->counterface_kind == MATERIAL_COUNTERFACE_ELASTIC &&
            strcmp(bodies->counterface.name, bodies->material.name) != 0)
            put_material(out, &bodies->counterface, NULL, view_name(source, i));
    }
    const size_t rows = json_array_size(view_list(out, "materials"));
    view_flag(out, "has_materials", rows > 0);
    view_flag(out, "pairs_differ", rows > json_array_size(view_list(out, "sources"))); /* one material, several rows */
    view_flag(out, "bodies_differ", some_without || json_array_size(list) > 1);
}

void view_surfaces(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    const struct scene *scene = results->scene;
    json_t *item = view_part(out, "surfaces"), *rows = view_list(item, "rows");
    put_row(view_list(item, "heads"), source->words, tables_surface_when(results), NULL);
    view_flag(item, "gaps", plan_quantities(source->results->plan) & QUANTITY_BIT(QUANTITY_JOINT));
    size_t scans = 0, of_maps = 0, periodic = 0, windowed = 0, lawless = 0, last_lawless = 0;
    bool has_maps = false, has_lay = false, has_along = false;
    for (size_t i = 0; i < results->surface_count; i++) {
        const struct surface_summary *s = view_summary(source, i);
        if (!s->usable)
            continue;
        scans += s->scans;
        has_maps = has_maps || s->has_map;
        has_lay = has_lay || s->has_lay;
        has_along = has_along || s->scene->along.count > 0;
        of_maps += s->has_map ? s->scans : 0;
        periodic += s->periodic;
        windowed += s->windowed;
        bool law = power_law_holds(&s->power_law);
        lawless += !law;
        last_lawless = law ? last_lawless : i;
        if (json_array_size(rows) < VIEW_ROWS)
            put_surface(view_item(rows), source, i);
    }
    view_flag(item, "has_maps", has_maps);
    view_flag(item, "high_passed", scene->lambda_c_m > 0);
    view_flag(item, "has_bands", scene->fit != POWER_LAW_THESIS);
    if (scene->fit_band_m[0] > 0 || isfinite(scene->fit_band_m[1]))
        view_range(item, "fit_band_m", scene->fit_band_m[0], scene->fit_band_m[1]);
    if (results->usable_count > VIEW_ROWS)
        json_set_count(item, "rows_left_out", results->usable_count - VIEW_ROWS);
    view_text(item, "level", level_names[scene->level]);
    view_flag(item, "level_given", scene->level_given);
    json_set_count(item, "scans", scans);
    view_flag(item, "one_scan", scans == 1);
    view_flag(item, of_maps == scans ? "all_rows" : "some_rows", of_maps > 0);
    view_flag(item, "all_periodic", periodic == scans);
    view_flag(item, "some_periodic", periodic > 0 && periodic < scans);
    json_set_count(item, "periodic", periodic);
    view_flag(item, "all_windowed", windowed == scans);
    view_flag(item, "some_windowed", windowed > 0 && windowed < scans);
    json_set(item, "wavelength_m", results_law_wavelength_m(results));
    view_counted(item, "lawless", lawless, view_name(source, last_lawless));
    if (results->counterface)
        json_set(item, "counterface_rq_m", results->counterface->summary.roughness.rq_m);
    put_bodies(item, source);
    view_flag(item, "isotropic", !has_lay);
    view_flag(item, "has_along", has_along);
}

/* ---- Inputs ---- */

static void put_notes(json_t *out, const struct view_source *source)
{
    for (size_t i = 0; i < source->results->surface_count; i++)
        for (size_t n = 0; n < view_summary(source, i)->notes.count; n++) {
            OWNED(text_free) struct text line = {0};
            json_t *own = json_object();
            note_line(&line, source->words, &view_summary(source, i)->notes.notes[n]);
            view_text(own, "line", text_string(&line));
            put_once(view_list(out, "notes"), own, view_name(source, i));
        }
}

static void put_files(json_t *row, const struct surface_summary *s)
{
    json_t *files = view_list(row, "files");
    const struct scene_files *across = &s->scene->files, *along = &s->scene->along;
    const size_t all = across->count + along->count;
    for (size_t f = 0; f < all && f < 5; f++)
        view_text(view_item(files), "file", f < across->count ? across->path[f] : along->path[f - across->count]);
    if (all > 5)
        json_set_count(row, "more_files", all - 5);
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
    if (results->scene->passed_over)
        json_object_set_new(item, "passed_over", json_lines(results->scene->passed_over));
    json_t *sources = view_list(item, "sources");
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(results->plan, m)) {
            json_t *row = view_item(sources);
            view_text(row, "label", model_rows[m]->label);
            view_text(row, "source", model_rows[m]->source);
            view_text(row, "does", model_rows[m]->does);
            view_text(row, "equations", model_rows[m]->equations);
        }
}
