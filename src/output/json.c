/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/json.h"

#include "answers/direct_study.h"
#include "base/version.h"
#include "output/tables.h"
#include <errno.h>
#include <jansson.h>
#include <math.h>
#include <string.h>

json_t *json_material(const struct material *material)
{
    json_t *json = json_pack("{s:o}", "name", json_shown(material->name));
    for (size_t i = 0; i < material_property_count; i++) {
        double value = material_value(material, &material_properties[i]);
        if (!material_properties[i].optional || value > 0)
            json_set(json, material_properties[i].key, value);
    }
    json_object_set_new(json, "source", json_shown(material->source));
    return json;
}

static json_t *counterface_json(const struct scene_bodies *bodies)
{
    if (bodies->counterface_kind == MATERIAL_COUNTERFACE_RIGID)
        return json_string("rigid");
    return isnan(bodies->counterface.youngs_modulus_Pa) ? json_null() : json_material(&bodies->counterface);
}

json_t *json_joint(const struct results *results)
{
    const struct joint *joint = &results->scene->joint;
    json_t *json = json_object();
    const bool gap = plan_runs(results->plan, EFFECT_GAP), heating = plan_runs(results->plan, EFFECT_HEATING);
    if (gap) {
        const char *names[] = {[JOINT_VACUUM] = "vacuum", [JOINT_GAS] = "", [JOINT_MEDIUM] = "medium"};
        json_object_set_new(json, "gap", json_string(joint->gas ? joint->gas->name : names[joint->fill]));
        if (joint->fill == JOINT_GAS && joint->pressure_Pa > 0) { /* without pressure the gaps are empty */
            json_set(json, "gap_pressure_Pa", joint->pressure_Pa);
            json_set(json, "accommodation", joint->accommodation);
        } else if (joint->fill == JOINT_MEDIUM)
            json_set(json, "gap_conductivity_W_per_mK", joint->conductivity_W_per_mK);
        if (joint->bond_line_m > 0)
            json_set(json, "bond_line_m", joint->bond_line_m);
    }
    if (gap || heating)
        json_set(json, "temperature_K", joint->temperature_K);
    if (plan_runs(results->plan, EFFECT_FILM))
        json_set(json, "film_ohm_m2", joint->film_ohm_m2);
    if (plan_runs(results->plan, EFFECT_PLATING)) {
        json_set(json, "plating_thickness_m", joint->plating_thickness_m);
        json_set(json, "plating_resistivity_ohm_m", joint->plating_ohm_m);
        json_set_count(json, "plated_sides", joint->both_plated ? 2 : 1);
    }
    if (heating)
        json_set(json, "current_A", joint->current_A);
    return json;
}

static json_t *files_json(const struct scene_files *of)
{
    json_t *files = json_array();
    for (size_t f = 0; f < of->count; f++)
        json_array_append_new(files, json_shown(of->path[f]));
    return files;
}

static json_t *scene_json(const struct results *results)
{
    const struct scene *scene = results->scene;
    json_t *effects = json_object(), *models = json_array();
    for (int e = 0; e < EFFECT_COUNT; e++)
        json_object_set_new(effects, effect_rows[e].name,
                            json_pack("{s:b, s:o}", "runs", plan_runs(results->plan, (enum effect)e), "reason",
                                      json_shown(results->plan->reasons[e])));
    static const enum record_kind kinds[] = {
        [SCENE_SAID_NUMBER] = RECORD_NUMBER, [SCENE_SAID_COUNT] = RECORD_COUNT, [SCENE_SAID_TEXT] = RECORD_TEXT};
    const struct scene_bodies *bodies = &scene->bodies;
    const struct material_pair pair = scene_pair(bodies);
    for (size_t m = 0; m < model_count; m++)
        if (scene->models & MODEL_BIT(m))
            json_array_append_new(models, json_string(model_rows[m]->name));
    json_t *json = json_object();
    struct scene_said said;
    for (size_t k = 0; scene_said(&said, scene, k); k++)
        if (said.kind != SCENE_SAID_APART)
            json_object_set_new(json, said.key, record_value_json(kinds[said.kind], said.at));
    json_object_set_new(json, "models", models);
    json_object_set_new(json, "effects", effects);
    json_object_set_new(json, "material", pair.unknown ? json_null() : json_material(&bodies->material));
    json_object_set_new(json, "counterface", counterface_json(bodies));
    json_set_all(json, "loads_over_AnEp", results->loads, results->loads_apart ? 0 : results->load_count);
    if (scene->load.unit_text[0])
        json_object_set_new(json, scene->load.kind == UNIT_NUMBER ? "operating_load_unit" : "load_unit",
                            json_shown(scene->load.unit_text));
    if (results->usable_count > 0)
        json_set(json, "operating_load_over_AnEp", results_operating_load(results, results->baseline));
    if (scene->called & results->plan->running)
        json_object_set_new(json, "joint", json_joint(results));
    json_set_all(json, "shape_size_m", scene->joint.size_m,
                 scene->joint.bulge_per_m > 0 || scene->joint.fields ? 2 : 0);
    json_set(json, "shape_force_N", scene->joint.pressed ? scene->joint.fields->mean * scene->nominal_area_m2 : NAN);
    json_set(json, "shape_bulge_per_m", scene->joint.bulge_per_m > 0 ? scene->joint.bulge_per_m : NAN);
    json_set(json, "effective_modulus_Pa", pair.unknown ? NAN : pair.effective_modulus_Pa);
    json_set(json, "hardness_Pa", pair.unknown ? NAN : pair.hardness_Pa);
    json_object_set_new(json, "spectra", json_string(scene_bins_spectra(scene) ? "bins" : "every harmonic"));
    if (scene_bins_spectra(scene))
        json_object_set_new(json, "curves", json_string("in data/contact.csv alone"));
    json_set(json, "lay", scene->lay_given ? scene->lay : NAN);
    json_object_set_new(json, "baseline", json_shown(results->surfaces[results->baseline].summary.scene->name));
    if (scene->measured.files.count == 1)
        json_object_set_new(json, "measured_file", json_shown(scene->measured.files.path[0]));
    if (results->counterface)
        json_object_set_new(json, "counterface_surface",
                            json_pack("{s:o, s:s}", "files", files_json(&scene->counterface_surface.files), "sha256",
                                      results->counterface->summary.hash));
    json_set_all(json, "fit_band_m", scene->fit_band_m, 2);
#define FIELD(...) RECORD_FIELD(struct scene_convergence, __VA_ARGS__)
    static const struct record_field convergence[] = {
        FIELD(NUMBER, "alpha", alpha, JSON),         FIELD(NUMBER, "gamma", gamma, JSON),
        FIELD(NUMBER, "load_over_AnEp", load, JSON), FIELD(NUMBER, "scan_length_m", scan_length_m, JSON),
        FIELD(COUNT, "scales", scales, JSON),        {0}};
    json_object_set_new(json, "convergence", record_json(convergence, &scene->convergence));
    return json;
}

/** A model on a surface: its curve, its numbers where the summary stands as tables show them, what is known of these.
 */
static json_t *model_json(const struct results *results, size_t surface, size_t m)
{
    const struct surface_record *record = &results->surfaces[surface];
    const struct curve_summary *model = surface_model(&record->summary, m);
    const struct contact_point at = comparison_middle(results, m, surface);
    json_t *json = json_object(), *operating = json_object();
    json_auto_t *known = json_object();
    json_set(json, "full_contact_load_over_AnEp", model->full_load);
    json_set(json, "beta", model->beta);
    json_set(json, "beta_from_multiscale", model->beta_multiscale);
    json_set(json, "area_load_slope", model->area_slope);
    json_set(json, "largest_load_share_beyond_fit", model->most_beyond_fit);
    json_set_count(json, "evaluations", model->evaluations);
    json_set_count(json, "areas_limited", model->clamped);
    json_set(json, "largest_load_share_clamped_at_radius", model->most_radius_clamped);
    for (enum quantity q = 0; q < QUANTITY_COUNT; q++) {
        if (!(results->plan->wanted & QUANTITY_BIT(q)))
            continue;
        json_t *values = scene_bins_spectra(results->scene) ? NULL : json_array(); /* else contact.csv alone has them */
        for (size_t i = 0; values && i < record->curves[m].count; i++)
            json_array_append_new(values, json_finite(record->curves[m].points[i].value[q]));
        json_object_set_new(json, quantity_rows[q].name, values);
        json_set(operating, quantity_shown_name(q), comparison_value(&at, q, m, record->summary.asperities.sigma_m));
    }
    json_object_set_new(json, "operating", operating);
    for (int which = 0; which < CURVE_ESTIMATES; which++) {
        const struct estimate *estimate = curve_summary_estimate(model, which);
        if (tables_estimate_key(which) && estimate->count > 0)
            json_object_set_new(known, tables_estimate_key(which), record_estimate_json(estimate));
    }
    if (json_object_size(known) > 0)
        json_object_set(json, "at_middle_load", known);
    return json;
}

static json_t *notes_json(const struct note_list *list, struct words *words)
{
    json_t *array = json_array();
    for (size_t n = 0; n < list->count; n++) {
        OWNED(text_free) struct text line = {0};
        note_line(&line, words, &list->notes[n]);
        json_array_append_new(array, json_shown(text_string(&line)));
    }
    return array;
}

/** What was found beside the law's numbers; of fit: thesis its class alone. */
static json_t *fit_json(const struct surface_record *record, enum power_law_method method)
{
    static const struct power_law_band dropped;
    const struct power_law_band *band = record->band ? record->band : &dropped;
    const struct power_law *law = &record->summary.power_law;
    json_t *json = json_pack("{s:s, s:s}", "method", power_law_method_names[method], "class",
                             power_law_band_class_names[law->found]);
    if (method == POWER_LAW_THESIS)
        return json;
    double line_m[LOG_BIN_MOST];
    json_set_all(json, "knees_m", band->knee_m, band->pieces > 0 ? band->pieces - 1 : 0);
    json_set_all(json, "lines_m", line_m, power_law_band_lines(line_m, band));
    json_set(json, "share_of_m2", band->slope_share);
    return json;
}

/** r and what the scans' frequencies were multiplied by. */
static json_t *lay_json(const struct surface_summary *s)
{
    json_t *json = json_object();
    json_set(json, "r", s->has_lay ? s->lay : NAN);
    json_set(json, "kappa", surface_kappa(s));
    if (s->scene->along.count > 0)
        json_object_set_new(json, "along", files_json(&s->scene->along));
    return json;
}

/** The points measured on a surface, what the models say at their loads, and the factor of the predicted conductance
 * that it carries. */
static json_t *measured_json(const struct results *results, size_t index)
{
    const struct measured *measured = &results->measured[index];
    const struct measured_answers *answers = &results->answers[index];
    const double ends[] = {estimate_end(&answers->fit, 0), estimate_end(&answers->fit, 1)};
    const enum quantity whole = measured_quantity(measured, results->plan->running);
    const bool rises = quantity_rows[whole].is & QUANTITY_RISES;
    const char *quantity = quantity_rows[rises ? measured_quantity(measured, 0) : whole].name;
    json_t *models = json_object();
    json_t *json = json_pack("{s:o, s:s, s:b, s:s, s:o}", "files", files_json(&measured->given->files), "model",
                             model_rows[plan_leading_model(results->plan)]->name, "carried",
                             measured->given->carry && answers->fit.count > 0, "quantity", quantity, "models", models);
    json_object_set_new(json, "units_of_file",
                        json_pack("[o, o]", json_shown(measured->load_unit), json_shown(measured->resistance_unit)));
    json_set_count(json, "points", measured->count);
    json_set(json, "conductance_factor", estimate_value(&answers->fit));
    json_set_all(json, "conductance_factor_95", ends, 2);
    json_set_all(json, "load_over_AnEp", measured->load, measured->count);
    json_set_all(json, quantity, measured->resistance, measured->count);
    json_set_all(json, "error", measured->error, measured->count);
    for (size_t m = 0; m < model_count; m++) {
        struct measured_distance distance = measured_compare(measured, answers, m);
        json_t *model = distance.points > 0 ? json_object() : NULL; /* of NULL nothing is set */
        json_set(model, "rms_decades", distance.rms_decades);
        json_set(model, "bias_decades", distance.bias_decades);
        json_set_all(model, quantity, answers->resistance + m * measured->count, measured->count);
        json_object_set_new(models, model_rows[m]->name, model);
    }
    return json;
}

static json_t *surface_json(const struct results *results, size_t index, struct words *words)
{
    const struct surface_record *record = &results->surfaces[index];
    const struct surface_summary *s = &record->summary;
    const struct scene *scene = results->scene;
    json_t *models = json_object();
    for (size_t m = 0; m < model_count; m++)
        if (surface_model(s, m)->exists)
            json_object_set_new(models, model_rows[m]->name, model_json(results, index, m));
    json_t *json = json_pack("{s:o, s:o, s:s, s:s, s:s}", "surface", json_shown(s->scene->name), "files",
                             files_json(&s->scene->files), "sha256", s->hash, "format", s->format, "units", s->units);
    if (s->scene->bodies.material_given || s->scene->bodies.counterface_given) {
        json_object_set_new(json, "material", json_material(&s->scene->bodies.material));
        json_object_set_new(json, "counterface", counterface_json(&s->scene->bodies));
        json_set(json, "effective_modulus_Pa", s->pair.effective_modulus_Pa);
    }
    if (s->pair.hardness_Pa > 0 && s->pair.hardness_Pa != scene_pair(&scene->bodies).hardness_Pa)
        json_set(json, "hardness_Pa", s->pair.hardness_Pa);
    json_object_update_new(json, record_json(surface_fields, s));
    json_set(json, "heights_factor_ecr", comparison_heights_factor(results, index));
    json_set(json, "rsk", roughness_skewness(&s->roughness));
    json_set(json, "rku", roughness_kurtosis(&s->roughness));
    json_object_set_new(json, "fit", fit_json(record, scene->fit));
    json_object_set_new(json, "lay", lay_json(s));
    json_set_count(json, "scans", s->scans);
    json_set_count(json, "scans_periodic", s->periodic);
    json_set_count(json, "scans_windowed", s->windowed);
    json_set(json, "scans_independent", s->independent);
    json_set(json, "longest_waves", s->longest_waves);
    if (s->repeats.scans > 1)
        json_object_set_new(json, "spread", record_json(repeats_fields, &s->repeats));
    if (results_measured(results, index))
        json_object_set_new(json, "measured", measured_json(results, index));
    json_object_set_new(json, "notes", notes_json(&s->notes, words));
    json_object_set_new(json, "models", models);
    return json;
}

/** One kind of direct solution of a surface, load by load. */
static json_t *direct_curve_json(const struct direct_study *study, const struct results *results,
                                 enum direct_study_kind kind)
{
    const struct direct_study_curve *curve = &study->curves[kind];
    const struct material_pair *pair = results_pair(results, study->surface);
    double value[SCENE_DIRECT_LOADS], error[SCENE_DIRECT_LOADS];
    json_t *json = json_pack("{s:s, s:I}", "heights", direct_study_heights(study), "seeds", (json_int_t)curve->seeds);
    json_set(json, "hardness_Pa",
             kind == DIRECT_STUDY_CAPPED ? study->plan.hardness * pair->effective_modulus_Pa : NAN);
    json_set_all(json, quantity_rows[QUANTITY_LOAD].name, study->plan.load, curve->loads);
    for (enum quantity q = 0; q < QUANTITY_COUNT; q++) {
        const char *name = quantity_rows[q].name;
        char error_name[64];
        if (!quantity_rows[q].solved.column || !(results->plan->wanted & QUANTITY_BIT(q)))
            continue;
        for (size_t i = 0; i < curve->loads; i++)
            value[i] = direct_study_value(study, pair, kind, q, i, &error[i]);
        snprintf(error_name, sizeof error_name, "%s_stderr", name);
        json_set_all(json, name, value, curve->loads);
        json_set_all(json, error_name, error, curve->loads);
    }
    return json;
}

static json_t *direct_json(const struct direct_study *study, const struct results *results)
{
    const struct surface_summary *surface = &results->surfaces[study->surface].summary;
    const struct direct_plan *plan = &study->plan;
    json_t *solutions = json_array(), *ratios = json_object();
    for (int kind = 0; kind < DIRECT_STUDY_KINDS; kind++)
        if (study->curves[kind].points)
            json_array_append_new(solutions, direct_curve_json(study, results, (enum direct_study_kind)kind));
    for (size_t m = 0; m < model_count; m++) {
        if (!study->models[m].exists)
            continue;
        json_t *model = json_object();
        size_t loads = study->curves[direct_study_kind_of(study, m)].loads;
        for (enum quantity q = 0; q < QUANTITY_COUNT; q++) {
            double ratio[SCENE_DIRECT_LOADS];
            if (!quantity_rows[q].solved.ratio || !(results->plan->wanted & QUANTITY_BIT(q)))
                continue;
            for (size_t i = 0; i < loads; i++)
                ratio[i] = direct_study_ratio(study, results_pair(results, study->surface), m, q, i);
            json_set_all(model, quantity_rows[q].short_symbol, ratio, loads);
        }
        json_object_set_new(ratios, model_rows[m]->name, model);
    }
    json_t *json = json_pack("{s:o, s:s, s:I, s:I, s:o, s:o}", "surface", json_shown(surface->scene->name), "source",
                             plan->side > 0 ? "map" : "law", "grid", (json_int_t)plan->grid, "contacts_solved",
                             (json_int_t)study->solutions, "solutions", solutions, "model_over_direct", ratios);
    json_set(json, "cell_m", plan->length_m);
    json_set(json, "lambda_s_m", plan->lambda_s_m);
    json_set(json, "alpha_SI", plan->side > 0 ? NAN : plan->law.alpha);
    json_set(json, "gamma", plan->side > 0 ? NAN : plan->law.gamma);
    json_set(json, "roll_off_m", plan->side > 0 ? NAN : plan->length_m / plan->law.roll_off);
    return json;
}

/** Evaluations by effect. */
static json_t *work_json(const struct results *results)
{
    struct work_row rows[WORK_ROWS];
    json_t *json = json_object();
    work_account(rows, results);
    for (int r = 0; r < WORK_ROWS; r++)
        json_object_set_new(json, rows[r].name, json_pack("{s:I}", "evaluations", (json_int_t)rows[r].evaluations));
    return json;
}

/** The surfaces held against each other in the leading model, the best first. */
static json_t *comparison_json(const struct results *results, const struct comparison *ranking)
{
    json_t *ranks = json_array(), *pairs = json_array();
    for (size_t i = 0; i < ranking->count; i++) {
        const char *name = results->surfaces[ranking->surface[i]].summary.scene->name;
        char letters[RANKING_LETTERS + 1];
        ranking_groups_letters(letters, &ranking->groups, i);
        json_array_append_new(ranks, json_pack("{s:o, s:s}", "surface", json_shown(name), "letters", letters));
        for (size_t j = i + 1; j < ranking->count; j++) {
            const struct comparison_pair *pair = comparison_pair_of(ranking, i, j);
            json_t *json = json_pack("{s:I, s:I, s:s}", "better", (json_int_t)i, "other", (json_int_t)j, "verdict",
                                     comparison_told_apart(pair) ? "told apart" : "not told apart");
            json_set(json, "ratio", pair->ratio);
            json_set_all(json, "ratio_95", (const double[]){pair->low, pair->high}, 2);
            json_set(json, "p", pair->p);
            json_array_append_new(pairs, json);
        }
    }
    return json_pack("{s:s, s:o, s:o}", "quantity", quantity_rows[ranking->criterion].name, "ranks", ranks, "pairs",
                     pairs);
}

static json_t *refused_json(const struct results *results)
{
    json_t *refused = json_array();
    for (size_t i = 0; i < results->surface_count; i++) {
        const struct surface_summary *s = &results->surfaces[i].summary;
        if (!s->usable)
            json_array_append_new(refused, json_pack("{s:o, s:o}", "surface", json_shown(s->scene->name), "error",
                                                     json_shown(s->refusal)));
    }
    return refused;
}

json_t *json_outline(const struct results *results)
{
    json_t *limits = tables_json(results, TABLES_LIMITS), *missed = json_array(), *undecided = json_array(), *limit;
    size_t index;
    json_array_foreach (limits, index, limit) {
        const char *verdict = json_string_value(json_object_get(limit, "verdict"));
        if (strcmp(verdict, limit_verdict_words[LIMIT_MISSED]) == 0)
            json_array_append(missed, limit);
        else if (strcmp(verdict, limit_verdict_words[LIMIT_MET]) != 0)
            json_array_append(undecided, limit);
    }
    return json_pack("{s:o, s:o, s:o, s:o, s:o}", "refused", refused_json(results), "answers",
                     tables_json(results, TABLES_ANSWERS), "limits", limits, "missed_limits", missed,
                     "undecided_limits", undecided);
}

/** Prints one value behind `before`; takes it over. Who closes the file sees what failed. */
static void print(FILE *file, const char *before, json_t *json)
{
    OWNED(text_free) struct text text = {0};
    status_lost |= !json_text(&text, json);
    fprintf(file, "%s%s", before, text_string(&text));
    json_decref(json);
}

/** The surfaces in the making. */
struct printing {
    FILE *file;
    const struct results *results;
    const char *before;
};

/** A usable surface, with words of its own: they are for one thread. */
static enum status_code print_surface(void *context, size_t index, struct threads_turn *turn, struct status *status)
{
    struct printing *all = context;
    struct words *given = all->results->plan->words, own = {.said = NULL};
    if (!all->results->surfaces[index].summary.usable)
        return STATUS_OK;
    if (given)
        own = (struct words){given->file, json_array(), status};
    json_auto_t *surface = surface_json(all->results, index, given ? &own : NULL);
    OWNED(text_free) struct text text = {0};
    status_lost |= !json_text(&text, surface);
    if (status->code == STATUS_OK && threads_wait(turn)) {
        fprintf(all->file, "%s%s", all->before, text_string(&text));
        all->before = ",\n";
    }
    json_decref(own.said);
    return status->code;
}

static json_t *studies_json(const struct results *results)
{
    json_t *studies = json_array();
    for (size_t k = 0; k < results->direct_count; k++)
        json_array_append_new(studies, direct_json(&results->direct[k], results));
    return studies;
}

/** The claims without their marks. */
static json_t *claims_json(const json_t *claims)
{
    json_t *out = json_deep_copy(claims), *claim;
    size_t i;
    json_array_foreach (out, i, claim) {
        json_object_del(claim, "markdown");
    }
    return out;
}

enum status_code json_write(const struct results *results, const struct comparison *comparison, const json_t *claims,
                            const char *directory, struct status *status)
{
    const struct scene *scene = results->scene;
    OWNED(text_free) struct text path = {0};
    text_add(&path, "%s/results.json", directory);
    FILE *file = fopen(text_string(&path), "w");
    if (!file)
        return status_fail(status, STATUS_IO, "cannot write results.json: %s", strerror(errno));
    struct printing all = {file, results, "\n"};
    print(file, "{\"schema_version\": 1,\n\"program\": ", json_string("roughcontact"));
    print(file, ",\n\"version\": ", json_string(version_string()));
    print(file, ",\n\"scene\": ", scene_json(results));
    print(file, ",\n\"leading\": ", json_string(model_rows[plan_leading_model(results->plan)]->name));
    print(file, ",\n\"claims\": ", claims_json(claims));
    fputs(",\n\"surfaces\": [", file);
    (void)!threads_run(&results->threads, results->surface_count, print_surface, &all, status);
    print(file, "],\n\"refused\": ", refused_json(results));
    print(file, ",\n\"comparison\": ", comparison_json(results, comparison));
    if (scene->passed_over)
        print(file, ",\n\"passed_over\": ", json_lines(scene->passed_over));
    if (scene->target_count > 0)
        print(file, ",\n\"answers\": ", tables_json(results, TABLES_ANSWERS));
    if (scene->limit_count > 0)
        print(file, ",\n\"limits\": ", tables_json(results, TABLES_LIMITS));
    if (results->direct_count > 0)
        print(file, ",\n\"direct\": ", studies_json(results));
    print(file, ",\n\"work\": ", work_json(results));
    fputs("}\n", file);
    const bool lost = ferror(file);
    if ((fclose(file) != 0 || lost) && status->code == STATUS_OK)
        return status_fail(status, STATUS_IO, "cannot write results.json: %s", status_reason(errno));
    return status->code; /* perhaps for want of a word */
}
