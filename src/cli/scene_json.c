/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/version.h"
#include "cli/command.h"

#include <string.h>

/** The members that every object begins with. */
static json_t *begin(const char *directory, const char *messages, int exit_status, const char *error)
{
    return json_pack("{s:s, s:s, s:o, s:i, s:s, s:o, s:o}", "program", "roughcontact", "version", version_string(),
                     "directory", json_shown(directory), "exit_status", exit_status, "exit_reason",
                     command_statuses[exit_status], "error", json_shown(error), "messages", json_lines(messages));
}

/** The path of results.json, beside the page. */
static json_t *results_json(const char *page)
{
    struct text path = {0};
    text_add(&path, "%.*s/results.json", (int)(strrchr(page, '/') - page), page);
    json_t *json = json_shown(text_string(&path));
    text_free(&path);
    return json;
}

void scene_json_print_report(const struct run_outcome *outcome, const char *directory, int exit_status,
                             const char *error)
{
    json_t *json = begin(directory, outcome ? text_string(&outcome->messages) : "", exit_status, error);
    const char *path = outcome && !error ? outcome->path : NULL;
    json_object_set_new(json, "report", json_shown(path));
    json_object_set_new(json, "results", path ? results_json(path) : json_null());
    if (outcome && outcome->outline)
        json_object_update(json, outcome->outline);
    if (outcome && !error)
        json_object_set_new(json, "work", json_pack("{s:I}", "evaluations", (json_int_t)outcome->evaluations));
    command_json_print(json);
}

static json_t *surfaces_json(const struct results *results)
{
    json_t *surfaces = json_array();
    for (size_t i = 0; i < results->surface_count; i++) {
        const struct surface_summary *s = &results->surfaces[i].summary;
        json_array_append_new(surfaces, json_pack("{s:o, s:b, s:o}", "surface", json_shown(s->scene->name), "usable",
                                                  s->usable, "refused", json_shown(s->refusal)));
    }
    return surfaces;
}

static json_t *effects_json(const struct results *results)
{
    struct work_row rows[WORK_ROWS];
    json_t *effects = json_array();
    work_account(rows, results);
    for (int r = 0; r < WORK_ROWS; r++)
        json_array_append_new(effects, json_pack("{s:s, s:b, s:o, s:s}", "effect", rows[r].name, "runs", rows[r].runs,
                                                 "reason", json_shown(rows[r].reason), "changes", rows[r].changes));
    return effects;
}

void scene_json_print_plan(const struct results *results, double rough_seconds, const char *directory,
                           const char *messages, int exit_status, const char *error)
{
    json_t *json = begin(directory, messages, exit_status, results ? NULL : error);
    json_t *models = json_array();
    for (size_t m = 0; m < model_count && results; m++)
        json_array_append_new(models, json_pack("{s:s, s:s, s:b, s:s}", "model", model_rows[m]->name, "label",
                                                model_rows[m]->label, "runs", plan_runs_model(results->plan, m),
                                                "valid", model_rows[m]->valid));
    if (results) {
        const struct scene *scene = results->scene;
        json_object_set_new(json, "effects", effects_json(results));
        json_object_set_new(json, "seconds", json_real(rough_seconds));
        json_object_set(json, "models", models);
        json_object_set_new(json, "surfaces", surfaces_json(results));
        json_object_set_new(json, "material_known", json_boolean(results_has_material(results)));
        json_object_set_new(json, "loads", json_integer((json_int_t)results->load_count));
        json_object_set_new(json, "targets", json_integer((json_int_t)scene->target_count));
        json_object_set_new(json, "tolerance", json_real(scene->tolerance));
        json_object_set_new(json, "closure", json_string(sinusoid_fits[scene->closure].name));
    }
    json_decref(models);
    command_json_print(json);
}
