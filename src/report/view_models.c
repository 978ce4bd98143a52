/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One surface in every model, all surfaces in each, the joint, what was measured, the direct solution. */
#include "report/view.h"

#include "analysis/direct_study.h"
#include "base/number_format.h"
#include "joint/heating.h"
#include <math.h>

static bool wants(const struct view_source *source, enum quantity quantity)
{
    return plan_quantities(source->results->plan) & QUANTITY_BIT(quantity);
}

/** A model on the baseline where the summary stands. */
static void put_model(json_t *row, const struct view_source *source, size_t m)
{
    const struct results *results = source->results;
    size_t surface = results->baseline;
    const struct contact_point at = comparison_middle(results, m, surface);
    const struct curve_summary *curve = surface_model(view_summary(source, surface), m);
    const struct material_pair *pair = results_pair(results, surface);
    double scale = asked_load_of(results, surface).scale, sigma_m = view_summary(source, surface)->asperities.sigma_m;
    view_text(row, "label", model_rows[m]->label);
    view_flag(row, "leads", m == source->leading);
    view_number(row, "area_percent", 100 * at.value[QUANTITY_AREA], 3, "");
    view_number(row, "separation", comparison_value(&at, model_shown(model_rows[m], QUANTITY_SEPARATION), m, sigma_m),
                3, "");
    view_number(row, "ecr", at.value[QUANTITY_ECR], 3, "");
    view_number(row, "tcr", at.value[QUANTITY_TCR], 3, "");
    view_number(row, "full_load", curve->exists ? curve->full_load * scale : NAN, 3, "");
    view_number(row, "asked", asked_shown(&source->asked, at.value[source->asked.quantity]), 3, "");
    view_flag(row, "invalid", !curve_summary_is_valid(curve, at.value[QUANTITY_LOAD]));
    view_flag(row, "above_hardness",
              !model_rows[m]->plastic && !pair->unknown &&
                  material_pair_pressure(pair, at.value[QUANTITY_LOAD]) > pair->hardness_Pa * at.value[QUANTITY_AREA]);
    size_t beside = asked_beside(results);
    if (m == beside)
        view_flag(row, "same_spectrum_gaussian_heights", true);
}

/** What the heights do: the leading model over the one beside it, which takes them as Gaussian. */
static void put_heights(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    size_t beside = asked_beside(results);
    double least = INFINITY, most = -INFINITY;
    enum quantity quantity = results_criterion(results);
    for (size_t k = 0; k < results->usable_count && beside < model_count; k++) {
        const struct contact_point own = comparison_middle(results, source->leading, results->by_roughness[k]),
                                   other = comparison_middle(results, beside, results->by_roughness[k]);
        double ratio = own.value[quantity] / other.value[quantity];
        if (isfinite(ratio)) {
            least = fmin(least, ratio);
            most = fmax(most, ratio);
        }
    }
    if (!(least <= most))
        return;
    json_t *item = json_object();
    view_text(item, "beside", model_rows[beside]->label);
    view_text(item, "symbol", quantity_rows[quantity].short_symbol);
    view_range(item, "ratio", least, most, 2, "");
    view_flag(item, "alike", least > 0.9 && most < 1.1);
    json_object_set_new(out, "heights", item);
}

/** What falling load changes at some of its shares, over the same load rising. */
static void put_unloading(json_t *out, const struct view_source *source)
{
    static const double shares[] = {0.5, 0.2, 0.1, 0.05};
    const struct surface_unloading *unloading = source->baseline->summary.unloading;
    if (!unloading)
        return;
    const struct unloading *ratio = &unloading->ratio;
    size_t baseline = source->results->baseline;
    json_t *item = json_object(), *rows = view_list(item, "rows");
    view_load(item, "from", source, baseline, unloading->largest_load);
    view_text(item, "label", model_rows[unloading->model]->label);
    for (size_t i = 0; i < sizeof shares / sizeof *shares; i++) {
        double area = unloading_factor(ratio, QUANTITY_AREA, shares[i]);
        if (isnan(area))
            continue;
        json_t *row = view_item(rows);
        view_load(row, "load", source, baseline, shares[i] * unloading->largest_load);
        view_number(row, "area", area, 2, "");
        view_number(row, "gap", unloading_factor(ratio, QUANTITY_SEPARATION, shares[i]), 2, "");
        view_number(row, "resistance", unloading_factor(ratio, QUANTITY_ECR, shares[i]), 2, "");
    }
    view_separate(rows);
    json_object_set_new(out, "unloading", item);
}

static void put_one_surface(json_t *out, const struct view_source *source)
{
    json_t *item = json_object(), *rows = view_list(item, "rows");
    const struct results *results = source->results;
    view_text(item, "surface", view_name(source, results->baseline));
    view_load(item, "load", source, results->baseline, results_operating_load(results, results->baseline));
    view_flag(item, "has_separation", wants(source, QUANTITY_SEPARATION));
    view_flag(item, "has_ecr", wants(source, QUANTITY_ECR));
    view_flag(item, "has_tcr", wants(source, QUANTITY_TCR));
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(results->plan, m) && surface_model(&source->baseline->summary, m)->exists)
            put_model(view_item(rows), source, m);
    size_t i;
    json_t *row;
    bool invalid = false, above = false, full = false;
    json_array_foreach(rows, i, row)
    {
        invalid = invalid || json_is_true(json_object_get(row, "invalid"));
        above = above || json_is_true(json_object_get(row, "above_hardness"));
        full = full || json_object_get(row, "full_load");
    }
    view_flag(item, "any_invalid", invalid);
    view_flag(item, "any_full", full);
    view_flag(item, "any_above_hardness", above);
    const struct material_pair *pair = results_pair(results, results->baseline);
    if (wants(source, QUANTITY_TCR_SCALE_DEPENDENT) && results->scene->mean_free_path == SCENE_MEAN_FREE_PATH_THESIS)
        view_number(item, "phonon_path_nm", pair->mean_free_path_m[0] * 1e9, 3, "");
    const struct curve_summary *leading = surface_model(&source->baseline->summary, source->leading);
    if (leading->exists)
        view_number(item, "area_slope", leading->area_slope, 3, "");
    double scale = asked_load_of(results, results->baseline).scale;
    for (size_t m = 0; m < model_count; m++)
        for (size_t k = 0; plan_runs_model(results->plan, m) && k < source->baseline->curves[m].kink_count && k < 1;
             k++) {
            const struct model_kink *kink = &source->baseline->curves[m].kinks[k];
            json_t *one = view_item(view_list(item, "kinks"));
            view_text(one, "label", model_rows[m]->label);
            view_number(one, "load", kink->load * scale, 2, "");
            view_number(one, "wavelength_um", kink->wavelength_m * 1e6, 2, "");
        }
    put_unloading(item, source);
    json_object_set_new(out, "one_surface", item);
}

/** Table 6.3: β of each surface, by full contact and by the multiscale model. */
static void put_all_surfaces(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    json_t *item = json_object(), *heads = view_list(item, "heads"), *rows = view_list(item, "rows");
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(results->plan, m) &&
            (model_rows[m]->quantities & results->plan->wanted & QUANTITY_BIT(QUANTITY_ADJUSTED)))
            view_text(view_item(heads), "label", model_rows[m]->label);
    for (size_t i = 0; i < results->surface_count && json_array_size(heads) > 0; i++) {
        if (!results->surfaces[i].summary.usable || json_array_size(rows) >= VIEW_ROWS)
            continue;
        json_t *row = view_item(rows);
        view_text(row, "surface", view_name(source, i));
        for (size_t m = 0; m < model_count; m++) {
            const struct curve_summary *curve = surface_model(view_summary(source, i), m);
            if (!plan_runs_model(results->plan, m) ||
                !(model_rows[m]->quantities & results->plan->wanted & QUANTITY_BIT(QUANTITY_ADJUSTED)))
                continue;
            view_cell(row, curve->exists ? curve->beta : NAN, 3);
            view_cell(row, curve->exists ? curve->beta_multiscale : NAN, 3);
        }
    }
    view_flag(item, "has_betas", json_array_size(rows) > 0);
    view_flag(item, "has_statistical", plan_uses_asperities(results->plan));
    view_count(item, "shown", results->shown_count);
    view_flag(item, "some_shown", results->shown_count < results->usable_count);
    if (results->usable_count > 1 || json_array_size(rows) > 0)
        json_object_set_new(out, "all_surfaces", item);
    else
        json_decref(item);
}

void view_models(json_t *out, const struct view_source *source)
{
    put_one_surface(out, source);
    put_all_surfaces(out, source);
    put_heights(out, source);
    if (source->results->convergence) {
        json_t *item = json_object();
        size_t as_expected = 0, elastic = 0, falling = 0, plastic = 0;
        for (size_t v = 0; v < convergence_sweeps[CONVERGENCE_GAMMA].count; v++)
            for (size_t m = 0; m < model_count; m++)
                if (plan_runs_model(source->results->plan, m) && model_rows[m]->stacks_scales) {
                    bool settles = comparison_converges(source->results, CONVERGENCE_GAMMA, m, v);
                    bool should = convergence_sweeps[CONVERGENCE_GAMMA].values[v] >= 1;
                    as_expected += !model_rows[m]->plastic && settles == should;
                    elastic += !model_rows[m]->plastic;
                    falling += model_rows[m]->plastic && !settles;
                    plastic += model_rows[m]->plastic;
                }
        size_t diverging = 0;
        for (size_t k = 0; k < source->results->usable_count; k++)
            diverging += surface_diverges(view_summary(source, source->results->by_roughness[k]));
        view_flag(item, "as_expected", as_expected == elastic);
        view_flag(item, "yielding_ends_it", plastic > 0 && falling == 0);
        double fall = 0;
        for (size_t k = 0; k < source->results->usable_count; k++)
            for (size_t m = 0; m < model_count; m++) {
                const struct convergence_extension *extension =
                    &surface_model(view_summary(source, source->results->by_roughness[k]), m)->extension;
                if (extension->area_measured > 0)
                    fall = fmax(fall, 1 - extension->area_extended / extension->area_measured);
            }
        bool told = false;
        for (size_t k = 0; k < source->results->usable_count; k++)
            for (size_t m = 0; m < model_count; m++)
                told = told || surface_model(view_summary(source, source->results->by_roughness[k]), m)->extended;
        view_flag(item, "untold", !told);
        if (fall > 0)
            view_number(item, "fall_percent", 100 * fall, 2, "");
        view_number(item, "atom_nm", convergence_atom_m * 1e9, 1, "");
        view_number(item, "load", source->results->scene->convergence.load, 3, "");
        view_flag(item, "none_diverges", diverging == 0);
        view_count(item, "diverging", diverging);
        json_object_set_new(out, "convergence", item);
    }
}

/* ---- The joint ---- */

struct range {
    double least, most;
};

/** Of a number of the leading model's points over the surfaces. */
static struct range range_of(const struct view_source *source,
                             double (*number)(const struct contact_point *, const struct joint *))
{
    struct range range = {INFINITY, -INFINITY};
    for (size_t k = 0; k < source->results->usable_count; k++) {
        const struct contact_point at =
            comparison_middle(source->results, source->leading, source->results->by_roughness[k]);
        double value = number(&at, &source->results->scene->joint);
        if (isfinite(value)) {
            range.least = fmin(range.least, value);
            range.most = fmax(range.most, value);
        }
    }
    return range;
}

static double gap_share(const struct contact_point *p, const struct joint *joint)
{
    (void)joint;
    return 100 * p->value[QUANTITY_GAP] / p->value[QUANTITY_JOINT];
}

static double film_share(const struct contact_point *p, const struct joint *joint)
{
    return 100 * joint->film_ohm_m2 / p->value[QUANTITY_AREA] / p->value[QUANTITY_JOINT_ECR];
}

static double plating_factor(const struct contact_point *p, const struct joint *joint)
{
    (void)joint;
    return p->value[QUANTITY_PLATING_FACTOR];
}

static double voltage_mV(const struct contact_point *p, const struct joint *joint)
{
    (void)joint;
    return 1e3 * p->value[QUANTITY_VOLTAGE];
}

static double temperature_C(const struct contact_point *p, const struct joint *joint)
{
    (void)joint;
    return p->value[QUANTITY_TEMPERATURE] - 273.15;
}

/** The body that yields first, whose metal softens first. */
static const struct material *softer_body(const struct view_source *source, size_t surface)
{
    const struct scene_bodies *bodies = &view_summary(source, surface)->scene->bodies;
    bool other = bodies->counterface_kind == MATERIAL_COUNTERFACE_ELASTIC &&
                 bodies->counterface.yield_strength_Pa < bodies->material.yield_strength_Pa;
    return other ? &bodies->counterface : &bodies->material;
}

/** Does the softer body's metal soften or melt on any surface; of how many is that not known? */
static void put_softening(json_t *out, const struct view_source *source)
{
    size_t soft = 0, unknown = 0;
    for (size_t k = 0; k < source->results->usable_count; k++) {
        size_t i = source->results->by_roughness[k];
        const struct heating_metal *metal = heating_metal_find(softer_body(source, i)->name);
        double voltage_V = comparison_middle(source->results, source->leading, i).value[QUANTITY_VOLTAGE];
        if (!isfinite(voltage_V))
            continue;
        unknown += !metal;
        soft += metal && (voltage_V >= metal->softening_voltage_V ||
                          voltage_V >= heating_voltage(metal->melting_K, source->results->scene->joint.temperature_K));
    }
    if (soft > 0)
        view_count(out, "softens", soft);
    view_flag(out, "stays_solid", soft == 0 && unknown == 0);
    view_flag(out, "softening_unknown", unknown > 0);
}

void view_joint(json_t *out, const struct view_source *source)
{
    const struct plan *plan = source->results->plan;
    const struct joint *joint = &source->results->scene->joint;
    json_t *item = json_object();
    bool gap = plan_runs(plan, EFFECT_GAP), film = plan_runs(plan, EFFECT_FILM),
         plating = plan_runs(plan, EFFECT_PLATING), heat = plan_runs(plan, EFFECT_HEATING);
    if (!gap && !film && !plating && !heat) {
        json_decref(item);
        return;
    }
    json_object_set_new(out, "joint", item);
    if (gap) {
        json_t *part = json_object();
        struct range share = range_of(source, gap_share);
        view_flag(part, "vacuum", joint->fill == JOINT_VACUUM);
        view_flag(part, "medium", joint->fill == JOINT_MEDIUM);
        view_number(part, "conductivity", joint->conductivity_W_per_mK, 3, "");
        view_text(part, "gas", joint->fill == JOINT_GAS ? joint->gas->name : "");
        view_number(part, "pressure_kPa", joint->pressure_Pa * 1e-3, 3, "");
        view_number(part, "temperature_K", joint->temperature_K, 3, "");
        view_range(part, "share", share.least, share.most, 2, "");
        view_flag(part, "finish_matters", share.least > 50);
        view_flag(part, "load_matters", share.most < 50);
        json_object_set_new(item, "gap", part);
    }
    if (film) {
        json_t *part = json_object();
        struct range share = range_of(source, film_share);
        view_number(part, "film", joint->film_ohm_m2, 3, "");
        view_range(part, "share", share.least, share.most, 2, "");
        json_object_set_new(item, "has_film", part);
    }
    if (plating) {
        json_t *part = json_object();
        struct range factor = range_of(source, plating_factor);
        view_number(part, "thickness_um", joint->plating_thickness_m * 1e6, 3, "");
        view_flag(part, "both", joint->both_plated);
        view_range(part, "factor", factor.least, factor.most, 3, "");
        view_flag(part, "helps", factor.most < 1);
        view_flag(part, "hurts", factor.least > 1 && factor.most >= factor.least);
        json_object_set_new(item, "has_plating", part);
    }
    if (heat) {
        json_t *part = json_object();
        struct range voltage = range_of(source, voltage_mV), temperature = range_of(source, temperature_C);
        view_number(part, "current_A", joint->current_A, 3, "");
        view_range(part, "voltage_mV", voltage.least, voltage.most, 2, "");
        view_range(part, "temperature_C", temperature.least, temperature.most, 3, "");
        put_softening(part, source);
        json_object_set_new(item, "heating", part);
    }
}

/* ---- Measured, and the direct solution ---- */

/** Branch by branch, where there is a curve of falling load for the second. */
static void put_branches(json_t *out, const struct view_source *source)
{
    static const char *const names[] = {"loading", "unloading"};
    const struct results *results = source->results;
    const struct surface_unloading *unloading = source->baseline->summary.unloading;
    if (!unloading || measured_compare(results->measured, results->answers, MEASURED_UNLOADING).points == 0)
        return;
    json_t *item = json_object();
    view_text(item, "label", model_rows[unloading->model]->label);
    for (size_t b = 0; b < 2; b++) {
        struct measured_distance distance = measured_compare(results->measured, results->answers, MEASURED_LOADING + b);
        json_t *branch = json_object();
        view_number(branch, "factor", pow(10, distance.rms_decades), 3, "");
        view_number(branch, "ratio", pow(10, distance.bias_decades), 3, "");
        json_object_set_new(item, names[b], branch);
    }
    json_object_set_new(out, "branches", item);
}

/** How far each model is from what was measured. */
static void put_measured_models(json_t *out, const struct view_source *source)
{
    const struct measured *measured = source->results->measured;
    json_t *item = json_object(), *rows = view_list(item, "rows");
    for (size_t m = 0; m < model_count; m++) {
        struct measured_distance distance = measured_compare(measured, source->results->answers, m);
        if (!source->baseline->curves[m].exists || distance.points == 0)
            continue;
        json_t *row = view_item(rows);
        view_text(row, "label", model_rows[m]->label);
        view_count(row, "points", distance.points);
        view_number(row, "factor", pow(10, distance.rms_decades), 3, "");
        view_number(row, "ratio", pow(10, distance.bias_decades), 3, "");
    }
    struct measured_ranking rank = measured_rank(measured, source->results->answers);
    if (rank.nearest < model_count)
        view_text(item, "nearest", model_rows[rank.nearest]->label);
    put_branches(item, source);
    view_count(item, "points", measured->count);
    view_text(item, "surface", view_name(source, source->results->baseline));
    view_separate(rows);
    json_object_set_new(out, "measured_models", item);
}

static void put_distance(json_t *row, const char *name, const struct direct_study *study,
                         const struct material_pair *pair, size_t m, enum quantity quantity)
{
    struct direct_study_distance distance = direct_study_distance(study, pair, m, quantity);
    if (distance.loads > 0)
        view_range(row, name, distance.least, distance.most, 2, "");
}

static void put_study(json_t *item, const struct view_source *source, const struct direct_study *study)
{
    const struct material_pair *pair = results_pair(source->results, study->surface);
    json_t *rows = view_list(item, "rows");
    view_text(item, "surface", view_name(source, study->surface));
    view_flag(item, "map", study->plan.side > 0);
    view_count(item, "grid", study->plan.grid);
    view_count(item, "seeds", study->curves[study->leading].seeds);
    view_flag(item, "gaussian", study->leading == DIRECT_STUDY_GAUSSIAN);
    view_flag(item, "at_this_resolution", study->plan.side > 0 || study->plan.of_spacing);
    view_number(item, "cell_um", study->plan.length_m * 1e6, 3, "");
    for (size_t m = 0; m < model_count; m++) {
        if (!study->models[m].exists)
            continue;
        json_t *row = view_item(rows);
        view_text(row, "label", model_rows[m]->label);
        put_distance(row, "area", study, pair, m, QUANTITY_AREA);
        put_distance(row, "gap", study, pair, m, QUANTITY_SEPARATION);
        put_distance(row, "ecr", study, pair, m, QUANTITY_ECR);
    }
    bool resolved = false;
    for (size_t i = 0; i < study->plan.loads; i++)
        resolved = resolved || isfinite(direct_study_value(study, pair, study->leading, QUANTITY_AREA, i, NULL));
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
    if (results->measured)
        put_measured_models(out, source);
    if (!plan_runs(results->plan, EFFECT_DIRECT))
        return;
    json_t *item = json_object();
    json_object_set_new(out, "direct", item);
    view_text(item, "reason", results->plan->effects[EFFECT_DIRECT].reason);
    view_flag(item, "solved", results->direct_count > 0);
    view_flag(item, "has_ecr", wants(source, QUANTITY_ECR));
    view_flag(item, "has_gap", wants(source, QUANTITY_SEPARATION));
    for (size_t k = 0; k < results->direct_count && k < VIEW_ROWS; k++)
        put_study(view_item(view_list(item, "studies")), source, &results->direct[k]);
    for (size_t i = 0; i < results->surface_count; i++) {
        const struct surface_summary *s = view_summary(source, i);
        if (!s->usable || !s->direct || s->direct->possible)
            continue;
        json_t *row = view_item(view_list(item, "not_solved"));
        view_text(row, "surface", view_name(source, i));
        view_text(row, "why", s->direct->problem);
    }
}
