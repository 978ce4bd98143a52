/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/scene_json.h"
#include "base/version.h"
#include "cli/command.h"
#include "cli/command_json.h"
#include "spectrum/height_law.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/** What every object begins with. */
static json_t *begin(const char *directory, const char *messages, int exit_status, const char *error)
{
    return json_pack("{s:s, s:s, s:o, s:i, s:s, s:o, s:o}", "program", "roughcontact", "version", version_string(),
                     "directory", command_json_text(directory), "exit_status", exit_status, "exit_reason",
                     command_statuses[exit_status], "error", command_json_optional(error), "messages",
                     command_json_lines(messages));
}

static void print(json_t *json)
{
    if (!command_json_print(json))
        command_complain("", "out of memory"); /* what is printed is no JSON then, and the reader says so */
}

static json_t *times_json(const struct run_times *times)
{
    json_t *json = json_object(), *models = json_object();
    const struct {
        const char *name;
        double seconds;
    } stages[] = {
        {"read", times->read},        {"level", times->prepare},
        {"spectra", times->spectrum}, {"convergence", times->convergence},
        {"direct", times->direct},    {"cost", times->cost},
        {"tables", times->tables},    {"chart_data", times->figures},
        {"gnuplot", times->gnuplot},  {"report", times->report},
        {"total", times->total},
    };
    for (size_t i = 0; i < sizeof stages / sizeof stages[0]; i++)
        json_object_set_new(json, stages[i].name, json_real(stages[i].seconds));
    for (size_t m = 0; m < model_count && times->models; m++)
        json_object_set_new(models, model_rows[m]->name, json_real(times->models[m]));
    json_object_set_new(json, "models", models);
    return json;
}

static json_t *work_json(const struct run_outcome *outcome)
{
    return json_pack("{s:I, s:b, s:f, s:o}", "evaluations", (json_int_t)outcome->evaluations, "as_predicted",
                     outcome->work_agrees, "predicted_s", outcome->predicted_seconds, "taken_s",
                     times_json(&outcome->times));
}

/** The path of results.json, beside the page. */
static json_t *results_json(const char *page)
{
    struct text path = {0};
    text_add(&path, "%.*s/results.json", (int)(strrchr(page, '/') - page), page);
    json_t *json = command_json_text(text_string(&path));
    text_free(&path);
    return json;
}

void scene_json_print_report(const struct run_outcome *outcome, const char *directory, int exit_status,
                             const char *error)
{
    json_t *json = begin(directory, outcome ? text_string(&outcome->messages) : "", exit_status, error);
    const char *path = outcome && !error ? outcome->path : NULL;
    json_object_set_new(json, "report", command_json_optional(path));
    json_object_set_new(json, "results", path ? results_json(path) : json_null());
    if (outcome && outcome->outline)
        json_object_update(json, outcome->outline);
    if (outcome && !error)
        json_object_set_new(json, "work", work_json(outcome));
    print(json);
}

static json_t *surfaces_json(const struct surface_store *store)
{
    json_t *surfaces = json_array();
    for (size_t i = 0; i < store->count; i++) {
        const struct surface_summary *s = &store->summaries[i];
        json_t *json = json_pack("{s:o, s:b, s:o}", "surface", command_json_text(s->scene->name), "usable", s->usable,
                                 "refused", command_json_optional(s->refusal));
        if (s->usable) {
            json_object_set_new(json, "heights", json_string(height_verdicts[s->height_law.verdict].name));
            json_object_set_new(json, "rsk", command_json_number(roughness_skewness(&s->roughness)));
            json_object_set_new(json, "rku", command_json_number(roughness_kurtosis(&s->roughness)));
        }
        json_array_append_new(surfaces, json);
    }
    return surfaces;
}

/** The rows of the plan's table, with the sums below it. */
static void add_effects(json_t *json, const struct prepared *prepared)
{
    struct work_row rows[WORK_ROWS];
    const struct results *results = &prepared->results;
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    double seconds, bytes = work_memory(prepared->store.summaries, prepared->store.count,
                                        processors > 0 ? (unsigned)processors : 1);
    uint64_t evaluations = work_total(&results->predicted, &prepared->plan, &seconds);
    json_t *effects = json_array();
    work_table(rows, &results->predicted, &prepared->plan);
    for (int r = 0; r < WORK_ROWS; r++)
        json_array_append_new(effects, json_pack("{s:s, s:b, s:o, s:o, s:I, s:f, s:f}", "effect", rows[r].name, "runs",
                                                 rows[r].runs, "reason", command_json_text(rows[r].reason), "method",
                                                 command_json_text(rows[r].method), "evaluations",
                                                 (json_int_t)rows[r].evaluations, "seconds", rows[r].seconds,
                                                 "memory_bytes", r == 0 ? bytes : rows[r].bytes));
    json_object_set_new(json, "effects", effects);
    json_object_set_new(json, "evaluations", json_integer((json_int_t)evaluations));
    json_object_set_new(json, "seconds", json_real(seconds));
    json_object_set_new(json, "memory_bytes",
                        json_real(bytes + rows[EFFECT_CONVERGENCE + 1].bytes + rows[EFFECT_DIRECT + 1].bytes));
}

static json_t *stages_json(const struct forecast *likely)
{
    json_t *stages = json_array();
    for (int s = 0; s < FORECAST_STAGES; s++)
        json_array_append_new(stages,
                              json_pack("{s:s, s:f}", "stage", forecast_names[s], "seconds", likely->seconds[s]));
    return stages;
}

void scene_json_print_plan(const struct prepared *prepared, const struct forecast *likely, const char *directory,
                           bool brief, const char *messages, int exit_status, const char *error)
{
    json_t *json = begin(directory, messages, exit_status, prepared ? NULL : error);
    json_t *models = json_array();
    for (size_t m = 0; m < model_count && prepared; m++)
        json_array_append_new(models, json_pack("{s:s, s:s, s:b, s:s}", "model", model_rows[m]->name, "label",
                                                model_rows[m]->label, "runs", plan_runs_model(&prepared->plan, m),
                                                "valid", model_rows[m]->valid));
    if (prepared) {
        const struct results *results = &prepared->results;
        const struct scene *scene = results->scene;
        add_effects(json, prepared);
        json_object_set_new(json, "stages", stages_json(likely));
        json_object_set_new(json, "elapsed_seconds", json_real(likely->total));
        json_object_set(json, "models", models);
        json_object_set_new(json, "surfaces", surfaces_json(&prepared->store));
        json_object_set_new(json, "material_known", json_boolean(results_has_material(results)));
        json_object_set_new(json, "loads", json_integer((json_int_t)results->load_count));
        json_object_set_new(json, "targets", json_integer((json_int_t)scene->target_count));
        json_object_set_new(json, "tolerance", json_real(scene->tolerance));
        json_object_set_new(json, "closure", json_string(sinusoid_fits[scene->closure].name));
        json_object_set_new(json, "brief", json_boolean(brief));
    }
    json_decref(models);
    print(json);
}
