/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One surface in every model, all surfaces in each, the joint, what was measured, the direct solution. */
#include "report/view.h"

#include "answers/direct_study.h"
#include "base/constants.h"
#include "base/number_format.h"
#include "joint/heating.h"
#include "report/html.h"
#include <math.h>

struct range {
    double least, most;
};

static void widen(struct range *range, double value)
{
    if (!isfinite(value))
        return;
    range->least = fmin(range->least, value);
    range->most = fmax(range->most, value);
}

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

/** A model on the baseline where the summary stands. */
static void put_model(json_t *out, const struct view_source *source, size_t m)
{
    json_t *row = view_item(view_list(out, "rows"));
    const struct results *results = source->results;
    size_t surface = results->baseline;
    const struct contact_point at = comparison_middle(results, m, surface);
    const struct curve_summary *curve = surface_model(view_summary(source, surface), m);
    const struct material_pair *pair = results_pair(results, surface);
    double scale = asked_load_of(results, surface).scale, sigma_m = view_summary(source, surface)->asperities.sigma_m;
    struct text anchor = {0};
    html_anchor(&anchor, model_rows[m]->label);
    view_text(row, "label", model_rows[m]->label);
    view_text(row, "anchor", text_string(&anchor));
    text_free(&anchor);
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if (in_table(source, (enum quantity)q))
            view_number(view_item(view_list(row, "cells")), "text",
                        comparison_value(&at, (enum quantity)q, m, sigma_m) * quantity_unit((enum quantity)q).scale, 3,
                        "");
    view_number(row, "full_load", curve->exists ? curve->full_load * scale : NAN, 3, "");
    bool invalid = !curve_summary_is_valid(curve, at.value[QUANTITY_LOAD]);
    bool above = !model_rows[m]->plastic && !pair->unknown && at.value[QUANTITY_AREA] != 0 &&
                 material_pair_pressure(pair, at.value[QUANTITY_LOAD]) > pair->hardness_Pa * at.value[QUANTITY_AREA];
    view_flag(row, "invalid", invalid);
    view_flag(row, "above_hardness", above);
    if (invalid)
        view_flag(out, "any_invalid", true);
    if (above)
        view_flag(out, "any_above_hardness", true);
    if (json_object_get(row, "full_load"))
        view_flag(out, "any_full", true);
}

/** What the heights do: the leading model over the one beside it, which takes them as Gaussian. */
static void put_heights(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    struct range range = {INFINITY, -INFINITY};
    enum quantity quantity = results_criterion(results);
    for (size_t k = 0; k < results->usable_count; k++)
        widen(&range, comparison_heights_factor(results, results->by_roughness[k], quantity));
    if (!(range.least <= range.most))
        return;
    json_t *item = view_part(out, "heights");
    view_text(item, "beside", model_rows[plan_leading_model(results->plan)]->gaussian->label);
    view_text(item, "symbol", quantity_rows[quantity].short_symbol);
    view_range(item, "ratio", range.least, range.most, 2, "");
    view_flag(item, "alike", range.least > 0.9 && range.most < 1.1);
}

static void put_one_surface(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    json_t *item = json_object();
    view_text(item, "surface", view_name(source, results->baseline));
    view_load(item, "load", source, results->baseline, results_operating_load(results, results->baseline));
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if (in_table(source, (enum quantity)q))
            put_head(item, source, "table", (enum quantity)q);
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(results->plan, m) && surface_model(&source->baseline->summary, m)->exists)
            put_model(item, source, m);
    const struct material_pair *pair = results_pair(results, results->baseline);
    if (wants(source, QUANTITY_TCR_SCALE_DEPENDENT) && results->scene->mean_free_path == SCENE_MEAN_FREE_PATH_THESIS)
        view_number(item, "phonon_path_nm", pair->mean_free_path_m[0] * 1e9, 3, "");
    const struct curve_summary *leading = surface_model(&source->baseline->summary, source->leading);
    if (leading->exists)
        view_number(item, "area_slope", leading->area_slope, 3, "");
    double scale = asked_load_of(results, results->baseline).scale;
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(results->plan, m) && source->baseline->curves[m].kink.load > 0) {
            const struct model_kink *kink = &source->baseline->curves[m].kink;
            json_t *one = view_item(view_list(item, "kinks"));
            view_text(one, "label", model_rows[m]->label);
            view_number(one, "load", kink->load * scale, 2, "");
            view_number(one, "wavelength_um", kink->wavelength_m * 1e6, 2, "");
        }
    if (json_object_get(item, "rows"))
        json_object_set(out, "one_surface", item);
    json_decref(item);
}

/** Has this model a gap that is adjusted, and so a β? */
static bool adjusts(const struct view_source *source, size_t m)
{
    const struct plan *plan = source->results->plan;
    return plan_runs_model(plan, m) && (model_rows[m]->quantities & plan->wanted & QUANTITY_BIT(QUANTITY_ADJUSTED));
}

/** Table 6.3: β of each surface, by full contact and by the multiscale model. */
static void put_all_surfaces(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    bool betas = false;
    for (size_t m = 0; m < model_count; m++)
        betas = betas || adjusts(source, m);
    if (results->usable_count < 2 && !betas)
        return;
    json_t *item = view_part(out, "all_surfaces"), *heads = view_list(item, "heads"), *rows = view_list(item, "rows");
    for (size_t m = 0; m < model_count; m++)
        if (adjusts(source, m)) {
            json_t *head = view_item(heads);
            view_text(head, "label", model_rows[m]->label);
            if (model_rows[m]->counterpart)
                view_text(head, "beside", model_rows[m]->counterpart->label);
        }
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
                view_number(view_item(cells), "text", curve->exists ? curve->beta_multiscale : NAN, 3, "");
            }
    }
    view_flag(item, "has_betas", betas);
    view_count(item, "shown", results->shown_count);
    view_flag(item, "some_shown", results->shown_count < results->usable_count);
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
        view_number(item, "fall_percent", 100 * fall, 2, "");
    view_number(item, "atom_nm", convergence_atom_m * 1e9, 1, "");
    view_flag(item, "none_diverges", telling > 0 && diverging == 0);
    view_count(item, "surfaces", results->usable_count);
    view_some(item, "diverging", diverging);
    view_some(item, "untold", results->usable_count - telling);
}

void view_models(json_t *out, const struct view_source *source)
{
    put_one_surface(out, source);
    put_all_surfaces(out, source);
    put_heights(out, source);
    if (source->results->convergence)
        put_convergence(out, source);
}

/* ---- The joint ---- */

/* Ranges of what no row has, behind those of the quantities. */
enum joint_number { GAP_SHARE = QUANTITY_COUNT, FILM_SHARE, SHAPE_TIMES, CARRYING, JOINT_NUMBERS };

/** What the leading model says of the joint, over the surfaces: quantities as tables have them, shares in %. */
static void joint_ranges(struct range out[JOINT_NUMBERS], const struct view_source *source)
{
    const double film_ohm_m2 = source->results->scene->joint.film_ohm_m2;
    for (int n = 0; n < JOINT_NUMBERS; n++)
        out[n] = (struct range){INFINITY, -INFINITY};
    for (size_t k = 0; k < source->results->usable_count; k++) {
        const struct contact_point at =
            comparison_middle(source->results, source->leading, source->results->by_roughness[k]);
        const double *value = at.value;
        const double carrying = view_summary(source, source->results->by_roughness[k])->carrying;
        const double resistance =
            plan_runs(source->results->plan, EFFECT_GAP) ? 1 / value[QUANTITY_JOINT] : value[QUANTITY_TCR];
        for (int q = 0; q < QUANTITY_COUNT; q++) {
            const struct quantity_unit unit = quantity_unit((enum quantity)q);
            widen(&out[q], value[q] * unit.scale - unit.offset);
        }
        widen(&out[GAP_SHARE], 100 * value[QUANTITY_GAP] / value[QUANTITY_JOINT]);
        widen(&out[CARRYING], 1e6 * carrying * source->results->scene->nominal_area_m2);
        widen(&out[SHAPE_TIMES], 1 / (value[QUANTITY_SHAPE_JOINT] * resistance));
        widen(&out[FILM_SHARE], 100 * film_ohm_m2 / value[QUANTITY_AREA] / value[QUANTITY_JOINT_ECR]);
    }
}

/** Sets the range. */
static void put_range(json_t *out, const char *name, const struct range *range, int digits)
{
    view_range(out, name, range->least, range->most, digits, "");
}

/** Does the softer body's metal soften or melt on any surface; of how many is that not known? */
static void put_softening(json_t *out, const struct view_source *source)
{
    size_t soft = 0, unknown = 0, known = 0;
    for (size_t k = 0; k < source->results->usable_count; k++) {
        size_t i = source->results->by_roughness[k];
        const struct heating_metal *metal =
            heating_metal_find(scene_softer(&view_summary(source, i)->scene->bodies)->name);
        double voltage_V = comparison_middle(source->results, source->leading, i).value[QUANTITY_VOLTAGE];
        if (!isfinite(voltage_V))
            continue;
        known++;
        unknown += !metal;
        soft += metal && (voltage_V >= metal->softening_voltage_V ||
                          voltage_V >= heating_voltage(metal->melting_K, source->results->scene->joint.temperature_K));
    }
    view_some(out, "softens", soft);
    view_count(out, "surfaces", known);
    view_flag(out, "stays_solid", known > 0 && soft == 0 && unknown == 0);
    view_flag(out, "softening_unknown", unknown > 0);
}

void view_joint(json_t *out, const struct view_source *source)
{
    const struct plan *plan = source->results->plan;
    const struct joint *joint = &source->results->scene->joint;
    bool gap = plan_runs(plan, EFFECT_GAP), film = plan_runs(plan, EFFECT_FILM),
         plating = plan_runs(plan, EFFECT_PLATING), heat = plan_runs(plan, EFFECT_HEATING);
    bool shape = plan_runs(plan, EFFECT_SHAPE);
    struct range ranges[JOINT_NUMBERS];
    if (!gap && !film && !plating && !heat && !shape)
        return;
    json_t *item = view_part(out, "joint");
    joint_ranges(ranges, source);
    if (gap) {
        json_t *part = view_part(item, "gap");
        const struct range share = ranges[GAP_SHARE];
        view_flag(part, "vacuum", joint->fill == JOINT_VACUUM);
        view_flag(part, "medium", joint->fill == JOINT_MEDIUM);
        view_number(part, "conductivity", joint->conductivity_W_per_mK, 3, "");
        view_text(part, "gas", joint->fill == JOINT_GAS ? joint->gas->name : "");
        view_number(part, "pressure_kPa", joint->pressure_Pa * 1e-3, 3, "");
        view_number(part, "temperature_K", joint->temperature_K, 3, "");
        if (joint->fill != JOINT_VACUUM)
            put_range(part, "share", &share, 2);
        view_text(part, "filler",
                  joint->filler                               ? joint_filler_names[joint->filler]
                  : joint->gas && joint->fill == JOINT_MEDIUM ? joint->gas->name
                                                              : "");
        view_number(part, "bond_line_um", joint->bond_line_m > 0 ? joint->bond_line_m * 1e6 : NAN, 3, "");
        put_range(part, "conductance", &ranges[QUANTITY_JOINT], 2);
        view_number(part, "radiation", 4 * constant_stefan_boltzmann * pow(joint->temperature_K, 3), 2, "");
        view_flag(part, "finish_matters", share.least > 50 && share.most < 100);
        view_flag(part, "load_matters", share.most < 50);
    }
    if (film) {
        json_t *part = view_part(item, "has_film");
        view_number(part, "film", joint->film_ohm_m2, 3, "");
        put_range(part, "share", &ranges[FILM_SHARE], 2);
    }
    if (plating) {
        json_t *part = view_part(item, "has_plating");
        const struct range factor = ranges[QUANTITY_PLATING_FACTOR];
        view_text(part, "metal", joint->plating ? joint_plating_names[joint->plating] : "");
        view_number(part, "thickness_um", joint->plating_thickness_m * 1e6, 3, "");
        view_flag(part, "both", joint->both_plated);
        put_range(part, "factor", &factor, 3);
        view_flag(part, "no_spots", ranges[GAP_SHARE].least >= 100);
        view_flag(part, "helps", factor.most < 1);
        view_flag(part, "hurts", factor.least > 1 && factor.most >= factor.least);
    }
    if (shape) {
        json_t *part = view_part(item, "has_shape");
        const struct scene *scene = source->results->scene;
        const size_t bolts = scene->shape.bolts.count;
        view_number(part, "nominal_mm2", scene->nominal_area_m2 * 1e6, 3, "");
        view_count(part, "bolts", bolts);
        view_number(part, "bolt_kN", bolts > 0 ? scene->shape.bolts.force_N * 1e-3 : NAN, 3, "");
        view_flag(part, "without_place", joint->fields && joint->fields->share);
        view_flag(part, "scaled", joint->pressed && joint->field_count == 1);
        put_range(part, "carrying_mm2", &ranges[CARRYING], 2);
        put_range(part, "times", &ranges[SHAPE_TIMES], 3);
    }
    if (heat) {
        json_t *part = view_part(item, "heating");
        view_number(part, "current_A", joint->current_A, 3, "");
        put_range(part, "voltage_mV", &ranges[QUANTITY_VOLTAGE], 2);
        put_range(part, "temperature_C", &ranges[QUANTITY_TEMPERATURE], 3);
        put_softening(part, source);
    }
}

/* ---- Measured, and the direct solution ---- */

/** How the measured conductance grows with load, where the points tell, and the leading model's. */
static void put_exponent(json_t *out, const struct measured_exponent *exponent)
{
    struct text own = {0};
    if (!isfinite(exponent->measured) || !isfinite(exponent->model))
        return;
    json_t *item = view_part(out, "exponent");
    number_format_uncertain(&own, exponent->measured, exponent->sd);
    view_text(item, "measured", text_string(&own));
    view_number(item, "model", exponent->model, 2, "");
    text_free(&own);
}

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
        view_count(row, "points", distance.points);
        view_number(row, "factor", pow(10, distance.rms_decades), 3, "");
        view_number(row, "ratio", pow(10, distance.bias_decades), 3, "");
    }
    size_t nearest = measured_nearest(measured, answers);
    if (nearest < model_count)
        view_text(item, "nearest", model_rows[nearest]->label);
    put_exponent(item, &answers->exponent);
    view_counted(item, "points", measured->count, NULL);
    if (measured->run_count > 1)
        view_count(item, "runs", measured->run_count);
    view_text(item, "surface", view_name(source, surface));
    view_separate(rows);
}

static void put_study(json_t *item, const struct view_source *source, const struct direct_study *study)
{
    const struct material_pair *pair = results_pair(source->results, study->surface);
    json_t *rows = view_list(item, "rows");
    view_text(item, "surface", view_name(source, study->surface));
    view_flag(item, "map", study->plan.side > 0);
    view_count(item, "grid", study->plan.grid);
    view_counted(item, "seeds", study->curves[DIRECT_STUDY_ELASTIC].seeds, NULL);
    view_flag(item, "gaussian", study->plan.gaussian);
    view_flag(item, "at_this_resolution", study->plan.side > 0 || study->plan.of_spacing);
    view_number(item, "cell_um", study->plan.length_m * 1e6, 3, "");
    for (size_t m = 0; m < model_count; m++) {
        if (!study->models[m].exists)
            continue;
        json_t *row = view_item(rows);
        view_text(row, "label", model_rows[m]->label);
        for (int q = 0; q < QUANTITY_COUNT; q++) {
            const struct direct_study_distance distance = direct_study_distance(study, pair, m, (enum quantity)q);
            if (!quantity_rows[q].solved.ratio || !wants(source, (enum quantity)q))
                continue;
            json_t *cell = view_item(view_list(row, "cells"));
            if (distance.loads > 0)
                view_range(cell, "text", distance.least, distance.most, 2, "");
        }
    }
    bool resolved = false;
    for (size_t i = 0; i < study->plan.loads; i++)
        resolved = resolved || isfinite(direct_study_value(study, pair, DIRECT_STUDY_ELASTIC, QUANTITY_AREA, i, NULL));
    view_flag(item, "unresolved", !resolved);
    view_count(item, "least_points", DIRECT_ENSEMBLE_POINTS);
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
    view_separate(json_object_get(out, "measured_models"));
    if (!plan_runs(results->plan, EFFECT_DIRECT))
        return;
    json_t *item = view_part(out, "direct");
    view_text(item, "reason", results->plan->effects[EFFECT_DIRECT].reason);
    view_flag(item, "solved", results->direct_count > 0);
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if (quantity_rows[q].solved.ratio && wants(source, (enum quantity)q))
            put_head(item, source, "table.direct", (enum quantity)q);
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
