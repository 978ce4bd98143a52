/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One surface in every model, all surfaces in each, the joint, what was measured, the direct solution. */
#include "report/view.h"

#include "answers/direct_study.h"
#include "base/constants.h"
#include "output/json.h"
#include "report/report.h"
#include <math.h>

static bool wants(const struct view_source *source, enum quantity quantity)
{
    return plan_quantities(source->results->plan) & QUANTITY_BIT(quantity);
}

/** Heads a column of a table with the words of `kind` and a quantity's name. */
static void put_head(json_t *out, const struct view_source *source, const char *kind, enum quantity quantity)
{
    view_text(
        view_item(view_list(out, "heads")), "label",
        words_say(source->words, "%s.%s\nunit %s", kind, quantity_rows[quantity].name, quantity_unit(quantity).unit));
}

/** Does the table of one surface have it, as its chart does? */
static bool in_table(const struct view_source *source, enum quantity quantity)
{
    return wants(source, quantity) && quantity_rows[quantity].panels[0].file && !quantity_of_joint(quantity);
}

/** Has this model a gap that is adjusted, and so a β? */
static bool adjusts(const struct view_source *source, size_t m)
{
    const struct plan *plan = source->results->plan;
    return plan_runs_model(plan, m) && (model_rows[m]->quantities & plan->wanted & QUANTITY_BIT(QUANTITY_ADJUSTED));
}

/** A model on the baseline where the summary stands. */
static void put_model(json_t *out, const struct view_source *source, size_t m)
{
    json_t *row = view_item(view_list(out, "rows"));
    const struct results *results = source->results;
    size_t surface = results->baseline;
    const struct contact_point at = comparison_middle(results, m, surface);
    const struct curve_summary *curve = surface_model(view_summary(source, surface), m);
    double scale = asked_load_of(results, surface).scale, sigma_m = view_summary(source, surface)->asperities.sigma_m;
    OWNED(text_free) struct text anchor = {0};
    html_anchor(&anchor, model_rows[m]->label);
    view_text(row, "label", model_rows[m]->label);
    view_text(row, "anchor", text_string(&anchor));
    for (enum quantity q = 0; q < QUANTITY_COUNT; q++)
        if (in_table(source, q))
            view_number(view_item(view_list(row, "cells")), "text",
                        comparison_value(&at, q, m, sigma_m) * quantity_unit(q).scale, 3, "");
    const bool kept_open = plan_runs(results->plan, EFFECT_GAP) && results->scene->joint.bond_line_m > 0,
               some_full =
                   at.value[QUANTITY_AREA] < 1 && curve->full_load <= at.value[QUANTITY_LOAD]; /* not all scans */
    json_set(row, "full_load", curve->exists && !kept_open && !some_full ? curve->full_load * scale : NAN);
    bool invalid = !curve_summary_is_valid(curve, at.value[QUANTITY_LOAD]),
         above = comparison_overloaded(results, m, surface);
    view_flag(row, "invalid", invalid);
    view_flag(row, "above_hardness", above);
    if (adjusts(source, m))
        view_flag(out, "any_adjusted", true);
    if (invalid)
        view_flag(out, "any_invalid", true);
    if (above)
        view_flag(out, "any_above_hardness", true);
    if (json_is_number(json_object_get(row, "full_load")))
        view_flag(out, "any_full", true);
}

static void put_one_surface(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    json_auto_t *item = json_object();
    view_text(item, "surface", view_name(source, results->baseline));
    view_load(item, "load", source, results->baseline, results_operating_load(results, results->baseline));
    for (enum quantity q = 0; q < QUANTITY_COUNT; q++)
        if (in_table(source, q))
            put_head(item, source, "table", q);
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(results->plan, m) && surface_model(&source->baseline->summary, m)->exists)
            put_model(item, source, m);
    view_flag(item, "phonons",
              wants(source, QUANTITY_TCR_SCALE_DEPENDENT) &&
                  results->scene->mean_free_path == SCENE_MEAN_FREE_PATH_THESIS &&
                  isnan(source->baseline->summary.scene->bodies.material.mean_free_path_m));
    const struct curve_summary *leading = surface_model(&source->baseline->summary, source->leading);
    if (leading->exists)
        json_set(item, "area_slope", leading->area_slope);
    double scale = asked_load_of(results, results->baseline).scale;
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(results->plan, m) && source->baseline->curves[m].kink.load > 0) {
            const struct model_kink *kink = &source->baseline->curves[m].kink;
            json_t *one = view_item(view_list(item, "kinks"));
            view_text(one, "label", model_rows[m]->label);
            json_set(one, "load", kink->load * scale);
            json_set(one, "wavelength_m", kink->wavelength_m);
        }
    if (json_object_get(item, "rows"))
        json_object_set(out, "one_surface", item);
}

/** Table 6.3: β of each surface, by full contact and by the multiscale model. */
static void put_all_surfaces(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    json_auto_t *item = json_object();
    json_t *heads = view_list(item, "heads"), *rows = view_list(item, "rows");
    for (size_t m = 0; m < model_count; m++)
        if (adjusts(source, m)) {
            json_t *head = view_item(heads);
            view_text(head, "label", model_rows[m]->label);
            if (plan_runs_model(results->plan, model_index(model_rows[m]->counterpart))) {
                view_text(head, "beside", model_rows[m]->counterpart->label);
                view_flag(item, "some_beside", true);
            }
        }
    const bool betas = json_array_size(heads) > 0;
    for (size_t i = 0; i < results->surface_count && betas; i++) {
        if (!results->surfaces[i].summary.usable || json_array_size(rows) >= VIEW_ROWS)
            continue;
        json_t *row = view_item(rows), *cells = view_list(row, "cells");
        view_text(row, "surface", view_name(source, i));
        for (size_t m = 0; m < model_count; m++)
            if (adjusts(source, m)) {
                const struct curve_summary *curve = surface_model(view_summary(source, i), m);
                json_t *full = view_item(cells);
                view_flag(full, model_rows[m]->plastic ? "beta_plastic" : "beta_elastic", true);
                view_number(full, "text", curve->exists ? curve->beta : NAN, 3, "");
                if (plan_runs_model(results->plan, model_index(model_rows[m]->counterpart)))
                    view_number(view_item(cells), "text", curve->exists ? curve->beta_multiscale : NAN, 3, "");
            }
    }
    view_flag(item, "has_betas", betas);
    json_set_count(item, "shown", results->shown_count);
    view_flag(item, "some_shown", results->shown_count < results->usable_count);
    if (results->usable_count > 1 || betas)
        json_object_set(out, "all_surfaces", item);
}

/** Does the area of the sweeps settle, and that of the surfaces? */
static void put_convergence(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    json_t *item = view_part(out, "convergence");
    bool as_expected = true, plastic = false, falls = false;
    size_t diverging = 0, telling = 0;
    double fall = 0;
    for (size_t m = 0; m < model_count; m++) {
        for (size_t v = 0; v < convergence_sweeps[CONVERGENCE_GAMMA].count; v++) {
            if (!plan_runs_model(results->plan, m) || !model_rows[m]->stacks_scales)
                continue;
            bool settles = comparison_converges(results, CONVERGENCE_GAMMA, m, v);
            bool should = convergence_sweeps[CONVERGENCE_GAMMA].values[v] >= 1;
            as_expected = as_expected && (model_rows[m]->plastic || settles == should);
            plastic = plastic || model_rows[m]->plastic;
            falls = falls || (model_rows[m]->plastic && !settles);
        }
        for (size_t k = 0; k < results->usable_count; k++) {
            const struct surface_summary *s = view_summary(source, results->by_roughness[k]);
            const struct curve_summary *curve = surface_model(s, m);
            if (surface_tells_gamma(s) && curve->extension.area_measured > 0)
                fall = fmax(fall, 1 - curve->extension.area_extended / curve->extension.area_measured);
        }
    }
    for (size_t k = 0; k < results->usable_count; k++) {
        telling += surface_tells_gamma(view_summary(source, results->by_roughness[k]));
        diverging += surface_diverges(view_summary(source, results->by_roughness[k]));
    }
    view_flag(item, "as_expected", as_expected);
    view_flag(item, "yielding_ends_it", plastic && !falls);
    if (fall > 0)
        json_set(item, "fall", fall);
    json_set(item, "atom_m", convergence_atom_m);
    view_flag(item, "none_diverges", telling > 0 && diverging == 0);
    json_set_count(item, "surfaces", results->usable_count);
    view_some(item, "diverging", diverging);
    view_some(item, "untold", results->usable_count - telling);
}

void view_models(json_t *out, const struct view_source *source)
{
    put_one_surface(out, source);
    put_all_surfaces(out, source);
    if (source->results->convergence)
        put_convergence(out, source);
}

/** What the scene says lies in the joint; what that does to the answer is told by claims and by the list of effects. */
void view_joint(json_t *out, const struct view_source *source)
{
    const struct scene *scene = source->results->scene;
    const struct joint *joint = &scene->joint;
    const struct plan *plan = source->results->plan;
    json_auto_t *item = json_joint(source->results);
    view_flag(item, "medium", joint->fill == JOINT_MEDIUM);
    view_text(item, "filler",
              joint->filler                               ? joint_filler_names[joint->filler]
              : joint->gas && joint->fill == JOINT_MEDIUM ? joint->gas->name
                                                          : "");
    json_set(item, "radiation", 4 * constant_stefan_boltzmann * pow(joint->temperature_K, 3));
    view_text(item, "metal", joint->plating ? joint_plating_names[joint->plating] : "");
    view_flag(item, "both_plated", joint->both_plated);
    if (plan_runs(plan, EFFECT_SHAPE)) {
        json_t *shape = view_part(item, "shape");
        view_some(shape, "bolts", scene->shape.bolts.count);
        json_set(shape, "bolt_N", scene->shape.bolts.force_N);
        view_flag(shape, "without_place", joint->fields && joint->fields->share);
        view_flag(shape, "scaled", joint->pressed && joint->field_count == 1);
    }
    if (plan->running & (EFFECT_BIT(EFFECT_GAP) | EFFECT_BIT(EFFECT_FILM) | EFFECT_BIT(EFFECT_PLATING) |
                         EFFECT_BIT(EFFECT_HEATING) | EFFECT_BIT(EFFECT_SHAPE)))
        json_object_set(out, "joint", item);
}

/* ---- Measured, and the direct solution ---- */

/** How far each model is from what was measured on a surface. */
static void put_measured_models(json_t *item, const struct view_source *source, size_t surface)
{
    const struct measured *measured = &source->results->measured[surface];
    const struct measured_answers *answers = &source->results->answers[surface];
    json_t *rows = view_list(item, "rows");
    for (size_t m = 0; m < model_count; m++) {
        struct measured_distance distance = measured_compare(measured, answers, m);
        if (!surface_model(view_summary(source, surface), m)->exists || distance.points == 0)
            continue;
        json_t *row = view_item(rows);
        view_text(row, "label", model_rows[m]->label);
        json_set_count(row, "points", distance.points);
        json_set(row, "factor", pow(10, distance.rms_decades));
        json_set(row, "ratio", pow(10, distance.bias_decades));
    }
    size_t nearest = measured_nearest(measured, answers);
    if (nearest < model_count)
        view_text(item, "nearest", model_rows[nearest]->label);
    view_counted(item, "points", measured->count, NULL);
    if (measured->run_count > 1)
        json_set_count(item, "runs", measured->run_count);
    view_text(item, "surface", view_name(source, surface));
}

static void put_study(json_t *item, const struct view_source *source, const struct direct_study *study)
{
    const struct material_pair *pair = results_pair(source->results, study->surface);
    json_t *rows = view_list(item, "rows");
    view_text(item, "surface", view_name(source, study->surface));
    view_flag(item, "map", study->plan.side > 0);
    /* of a mirrored map what is measured, not its images */
    const size_t times = study->plan.mirrored ? 2 : 1;
    json_set_count(item, "grid", study->plan.grid / times);
    view_counted(item, "seeds", study->curves[DIRECT_STUDY_ELASTIC].seeds, NULL);
    view_flag(item, "gaussian", study->plan.gaussian);
    view_flag(item, "at_this_resolution", study->plan.side > 0 || study->plan.of_spacing || study->plan.coarse);
    json_set(item, "cell_m", study->plan.length_m / (double)times);
    view_flag(item, "mirrored", study->plan.mirrored);
    for (size_t m = 0; m < model_count; m++) {
        if (!study->models[m].exists)
            continue;
        json_t *row = view_item(rows);
        view_text(row, "label", model_rows[m]->label);
        for (enum quantity q = 0; q < QUANTITY_COUNT; q++) {
            const struct direct_study_distance distance = direct_study_distance(study, pair, m, q);
            if (!quantity_rows[q].solved.ratio || !wants(source, q))
                continue;
            json_t *cell = view_item(view_list(row, "cells"));
            if (distance.loads > 0)
                view_range(cell, "ratio", distance.least, distance.most);
        }
    }
    bool resolved = false;
    for (size_t i = 0; i < study->plan.loads; i++)
        resolved = resolved || isfinite(direct_study_value(study, pair, DIRECT_STUDY_ELASTIC, QUANTITY_AREA, i, NULL));
    view_flag(item, "unresolved", !resolved);
    json_set_count(item, "least_points", DIRECT_ENSEMBLE_POINTS / (times * times));
    size_t nearest = direct_study_nearest(
        study, pair, results_criterion(source->results) == QUANTITY_ECR ? QUANTITY_ECR : QUANTITY_AREA);
    if (nearest < model_count)
        view_text(item, "nearest", model_rows[nearest]->label);
}

void view_direct(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    for (size_t i = 0; i < results->surface_count; i++)
        if (results_measured(results, i) && json_array_size(view_list(out, "measured_models")) < VIEW_ROWS)
            put_measured_models(view_item(view_list(out, "measured_models")), source, i);
    if (!results->scene->direct.called) /* else it also says why none was made */
        return;
    json_t *item = view_part(out, "direct");
    for (enum quantity q = 0; q < QUANTITY_COUNT; q++)
        if (quantity_rows[q].solved.ratio && wants(source, q))
            put_head(item, source, "table.direct", q);
    for (size_t k = 0; k < results->direct_count && k < VIEW_ROWS; k++)
        put_study(view_item(view_list(item, "studies")), source, &results->direct[k]);
    for (size_t i = 0; i < results->surface_count; i++) {
        const struct surface_summary *s = view_summary(source, i);
        if (!s->usable || !s->direct || s->direct->possible)
            continue;
        json_t *row = view_item(view_list(item, "not_solved"));
        view_text(row, "surface", view_name(source, i));
        view_text(row, "why", direct_plan_problem(s->direct, source->words));
    }
}
