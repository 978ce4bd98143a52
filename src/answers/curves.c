/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answers/answers.h"

#include "answers/direct_study.h"
#include "answers/shaped.h"
#include "base/clock.h"
#include "certainty/sensitivity.h"
#include "certainty/uncertainty.h"
#include "contact/statistical.h"
#include "joint/joint.h"
#include "plan/effects.h"
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/** Extrapolates the spectrum to shorter waves, for models that stack scales. */
static void extend(struct surface_record *record, const struct scene *scene)
{
    struct surface_summary *summary = &record->summary;
    double started = clock_seconds();
    for (size_t m = 0; m < model_count; m++) {
        struct curve_summary *model = summary->models ? summary->models[m] : NULL;
        if (!model_rows[m]->stacks_scales || !model || !model->exists || isnan(summary->tail.gamma))
            continue;
        model->extension = convergence_extend(&record->spectrum, &summary->tail, &summary->pair, model_rows[m]->plastic,
                                              scene->convergence.load);
    }
    summary->times.convergence = clock_seconds() - started;
}

/** Runs the models that stack scales at the operating load with the fitted law (4.53) in place of the measured
 * harmonics of its band. */
static enum status_code try_law(struct surface_record *record, const struct model_task *task, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    const struct power_law *fit = &summary->power_law;
    struct spectrum law = record->spectrum;
    const double load = task->loads[model_task_operating(task)];
    struct model_task own = model_task_at(task, &load, 1);
    enum status_code rc = STATUS_OK;
    if (!power_law_holds(fit))
        return rc;
    law.amplitude_m = malloc(law.count * sizeof *law.amplitude_m);
    if (!law.amplitude_m)
        return status_memory(status);
    for (size_t i = 0; i < law.count; i++) {
        double wavelength_m = law.length_m / (double)(i + 1) * surface_kappa(summary);
        law.amplitude_m[i] = wavelength_m >= fit->band_m[0] && wavelength_m <= fit->band_m[1]
                                 ? power_law_amplitude(fit, wavelength_m)
                                 : record->spectrum.amplitude_m[i];
    }
    for (size_t m = 0; m < model_count && rc == STATUS_OK; m++) {
        double area[2] = {NAN, NAN};
        for (int k = 0; k < 2 && model_rows[m]->stacks_scales && record->curves[m].exists && rc == STATUS_OK; k++) {
            struct contact_point points[2] = {quantity_nothing(), quantity_nothing()};
            struct model_curve curve = {.points = points};
            own.spectrum = k == 0 ? &record->spectrum : &law;
            rc = model_run(&curve, model_rows[m], &own, status);
            area[k] = curve.exists && curve.count > 0 ? points[0].value[QUANTITY_AREA] : NAN;
        }
        if (summary->models[m])
            summary->models[m]->law_factor = area[1] / area[0];
    }
    free(law.amplitude_m);
    return rc;
}

/** The other estimate of beta (4.54), for which delta_ADJ is nearest, in the mean square, to the separation H of the
 * multiscale model of the same material law: the mean of 4 (H - delta/2)/sigma over the loads that both answer. */
static double nearest_beta(const struct surface_record *record, size_t m, const struct joint_task *joint)
{
    const struct model_curve *curve = &record->curves[m],
                             *other = &record->curves[model_index(model_rows[m]->counterpart)];
    double sum = 0, count = 0;
    for (size_t i = 0; i < curve->count && i < other->count; i++) {
        const double *own = curve->points[i].value, *multiscale = other->points[i].value;
        if (own[QUANTITY_LOAD] != multiscale[QUANTITY_LOAD] || joint_is_held(&curve->points[i], joint) ||
            joint_is_held(&other->points[i], joint))
            continue;
        sum += statistical_beta_multiscale(own[QUANTITY_SEPARATION], multiscale[QUANTITY_SEPARATION],
                                           record->summary.asperities.sigma_m);
        count++;
    }
    return sum / count;
}

/** Notes on a model that has run. */
static void note_model(struct surface_record *record, size_t m, size_t left_out)
{
    const struct model_curve *curve = &record->curves[m];
    if (left_out > 0 && curve->exists)
        note_add(&record->summary.notes, NULL, "note.unsolved\nmodel %s\nscans %zu", model_rows[m]->label, left_out);
    if (curve->overflows)
        note_add(&record->summary.notes, NULL, "note.overflow\nmodel %s", model_rows[m]->label);
}

/** Runs one model: its curve with the joint, its uncertainty, and its sensitivity. */
static enum status_code run_model(struct surface_record *record, size_t m, const struct surface_task *asked,
                                  const struct model_task *task, struct status *status)
{
    struct model_curve *curve = &record->curves[m];
    struct curve_summary *model = record->summary.models[m];
    curve->points = calloc(task->load_count + 1, sizeof *curve->points);
    if (!curve->points)
        return status_memory(status);
    double started = clock_seconds();
    bool several = record->ensemble.scan_count > 1 && !model_rows[m]->uses_map;
    if (plan_runs(asked->plan, EFFECT_SHAPE) && shaped_make(record, m, asked, task, status) != STATUS_OK)
        return status->code;
    if (several && !(record->bands[m] = ensemble_band_make(task->loads, task->load_count)))
        return status_memory(status);
    const struct joint_task joint = surface_joint(record, asked->scene, asked->plan, task);
    struct ensemble_result result = {.joint = &joint, .band = record->bands[m]};
    if (ensemble_curve(curve, &result, &record->ensemble, model_rows[m], task, status) != STATUS_OK)
        return status->code;
    curve->kink.wavelength_m *= surface_kappa(&record->summary); /* in the scans' lengths */
    if (curve->exists)
        joint_hold(curve->points, curve->count, &joint);
    if (model_rows[m]->plastic && !(curve->count > 0 && joint_is_held(&curve->points[curve->count - 1], &joint)))
        curve->crushed_load = task->pair->hardness_Pa / task->pair->effective_modulus_Pa;
    if (joint_curve(curve, model_rows[m], task, &joint, status) != STATUS_OK) /* for several scans, on the mean curve */
        return status->code;
    if (curve->exists)
        curve_summary_make(model, curve, model_rows[m], record->summary.asperities.sigma_m,
                           task->loads[model_task_operating(task)]);
    struct model_task middle = model_task_at(task, &task->loads[model_task_operating(task)], 1);
    middle.flatter.strip = NULL; /* the variants are those of the steeper direction */
    if ((several && curve_summary_put_estimates(model, result.estimates, status) != STATUS_OK) ||
        sensitivity_run(&model->sensitivity, &record->variants, model_rows[m], &middle, status) != STATUS_OK)
        return status->code;
    model->seconds = clock_seconds() - started;
    if (several && result.scans < 2) { /* a single scan has no scatter */
        free(record->bands[m]);
        record->bands[m] = NULL;
    }
    note_model(record, m, result.left_out);
    if (model_rows[m]->uses_map && curve->exists)
        return uncertainty_of_map(record, m, task, &joint, status);
    return STATUS_OK;
}

/** Makes room for the models' results. */
static enum status_code make_model_room(struct surface_record *record, const struct plan *plan, size_t load_count,
                                        struct status *status)
{
    record->curves = calloc(model_count, sizeof *record->curves);
    record->bands = calloc(model_count, sizeof *record->bands);
    record->band_count = load_count;
    if (!record->curves || !record->bands)
        return status_memory(status);
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(plan, m) && !surface_model_room(&record->summary, m))
            return status_memory(status);
    return STATUS_OK;
}

/** Solves the strips that running models use. */
static enum status_code solve_strips(struct surface_record *record, const struct plan *plan,
                                     const struct threads *threads, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    struct ensemble *set = &record->ensemble;
    struct strips *strips = &record->strips;
    double started = clock_seconds();
    if (!(plan_running_models(plan) & model_flagged(offsetof(struct model_row, uses_strip))) || strips->rows.rows == 0)
        return STATUS_OK;
    enum status_code rc = strips_solve(strips, threads, status);
    if (rc == STATUS_OK && set->scan_count > 1)
        rc = strips_solve_members(strips, set, threads, status);
    if (rc == STATUS_OK && record->flatter)
        rc = strips_solve(&record->flatter->strips, threads, status);
    summary->has_strips = strips->joined;
    for (size_t p = 0; p < set->count; p++) {
        summary->has_strips = summary->has_strips || set->members[p].strip;
        summary->strip_unsolved[1] += set->solved_alone && set->members[p].pieces > 0 && !set->members[p].strip;
    }
    if (rc == STATUS_OK && !summary->has_strips)
        note_add(&summary->notes, NULL, "note.no_strips\nwhy\t%s", strips->problem.message);
    summary->strip_unsolved[0] = strips->unsolved;
    summary->strip_transforms = strips->transforms + (record->flatter ? record->flatter->strips.transforms : 0);
    summary->times.strips = clock_seconds() - started;
    return rc;
}

/** Solves the map if models use it. Without a solution they are taken out of the plan. */
static enum status_code solve_tiles(struct surface_record *record, struct plan *plan, const struct threads *threads,
                                    struct status *status)
{
    struct surface_summary *summary = &record->summary;
    struct tiles *tiles = &record->tiles;
    double started = clock_seconds(), hardness = INFINITY;
    if (!(plan_running_models(plan) & model_flagged(offsetof(struct model_row, uses_map))) || !summary->has_tiles)
        return STATUS_OK;
    if (plan_runs(plan, EFFECT_PLASTICITY) && summary->pair.hardness_Pa > 0)
        hardness = summary->pair.hardness_Pa / summary->pair.effective_modulus_Pa;
    if (tiles_solve(tiles, hardness, threads, status) != STATUS_OK)
        return status->code;
    summary->has_tiles = tiles->transfer != NULL;
    const double seconds = clock_seconds() - started, share[2] = {1 - tiles->capped, tiles->capped};
    for (int kind = 0; kind < 2; kind++) {
        summary->tile_transforms[kind] = tiles->transforms[kind];
        summary->times.tiles[kind] = seconds * share[kind];
    }
    if (summary->has_tiles && tiles->def.cutoff > 0)
        note_add(&summary->notes, NULL, "note.low_pass");
    const size_t squares = tiles->columns * tiles->rows;
    const double solved = tiles_share(tiles);
    if (summary->has_tiles && (squares > 1 || solved < 0.9))
        note_add(&summary->notes, NULL, "note.squares\nsquares %zu\n%s\nside %zu\npercent %.2g", squares,
                 squares == 1 ? "one" : "", tiles->side, 100 * solved);
    if (summary->has_tiles)
        return STATUS_OK;
    summary->tile_cost = 0; /* a larger budget would not help */
    note_add(&summary->notes, NULL, "note.no_tiles\nwhy\t%s", tiles->problem.message);
    effects_fit_models(plan, record, 1);
    return STATUS_OK;
}

/** Notes on filler and plating. */
static void note_joint(struct surface_record *record, const struct scene *scene, const struct plan *plan)
{
    const struct joint *joint = &scene->joint;
    const struct joint_layer *metal = &joint_platings[joint->plating];
    struct note_list *notes = &record->summary.notes;
    const double thick_m = joint->plating_thickness_m;
    if (plan_runs(plan, EFFECT_GAP) && joint->fill == JOINT_MEDIUM && !joint->gas && !(joint->bond_line_m > 0))
        note_add(notes, NULL, "note.no_bond_line");
    if (plan_runs(plan, EFFECT_PLATING) && joint->plating && (thick_m < metal->least_m || thick_m > metal->most_m))
        note_add(notes, NULL, "note.plating\nthick %.3g\nmetal %s\nleast %.3g\nmost %.3g", thick_m * 1e6,
                 joint_plating_names[joint->plating], metal->least_m * 1e6, metal->most_m * 1e6);
}

/** A map that is solved directly loses its plane, whatever is taken out of its rows. */
static void note_plane(struct surface_record *record, const struct scene *scene, const struct plan *plan)
{
    const struct surface_summary *summary = &record->summary;
    const bool models = plan_running_models(plan) & model_flagged(offsetof(struct model_row, uses_map)),
               study = summary->direct && summary->direct->possible && summary->direct->side > 0;
    if (((models && summary->has_tiles) || study) && (scene->lambda_c_m > 0 || scene->level != LEVEL_LINE))
        note_add(&record->summary.notes, NULL, "note.plane");
}

/** Prepares the strips that have been solved, for targets and limits too. */
static enum status_code prepare_strips(struct surface_record *record, const struct model_task *task,
                                       struct status *status)
{
    struct model_task flatter = *task;
    flatter.strip = task->flatter.strip;
    flatter.spectrum = task->flatter.spectrum;
    if ((task->strip && model_strips_prepare(&record->strips.prepared, task, status) != STATUS_OK) ||
        (flatter.strip && model_strips_prepare(&record->flatter->strips.prepared, &flatter, status) != STATUS_OK))
        return status->code;
    return ensemble_prepare(&record->ensemble, task, status);
}

/** Runs the plan's models one after another, and what depends on all of them. */
static enum status_code curves_run(struct surface_record *record, const struct surface_task *asked,
                                   struct status *status)
{
    const struct scene *scene = asked->scene;
    const struct plan *plan = asked->plan;
    struct model_task task = surface_model_task(record, asked);
    if (make_model_room(record, plan, task.load_count, status) != STATUS_OK ||
        prepare_strips(record, &task, status) != STATUS_OK)
        return status->code;
    for (size_t m = 0; m < model_count; m++) {
        if (!plan_runs_model(plan, m))
            continue;
        task.evaluations = &record->summary.models[m]->evaluations;
        if (run_model(record, m, asked, &task, status) != STATUS_OK)
            return status->code;
    }
    task.evaluations = NULL;
    size_t leading = plan_leading_model(plan);
    if (plan_runs(plan, EFFECT_UNCERTAINTY) && record->height_m &&
        uncertainty_run(record, asked, &task, status) != STATUS_OK)
        return status->code;
    const struct joint_task joint = surface_joint(record, scene, plan, &task);
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs(plan, EFFECT_SEPARATION) && plan_runs_model(plan, m) &&
            plan_runs_model(plan, model_index(model_rows[m]->counterpart)))
            record->summary.models[m]->beta_multiscale = nearest_beta(record, m, &joint);
    if (plan_runs(plan, EFFECT_CONVERGENCE)) {
        extend(record, scene);
        if (try_law(record, &task, status) != STATUS_OK)
            return status->code;
    }
    note_joint(record, scene, plan);
    note_plane(record, scene, plan);
    if (record->shapes && plan_runs_model(plan, leading))
        record->summary.carrying = joint_shape_area(&record->shapes[leading], task.loads[model_task_operating(&task)]);
    return answers_find(record, scene, plan, &task, status);
}

enum status_code surface_answers_find(struct surface_record *record, const struct surface_task *task,
                                      struct status *status)
{
    struct plan plan = *task->plan;
    struct surface_task asked = *task;
    asked.plan = &plan;
    effects_fit_models(&plan, record, 1);
    if ((plan_runs(&plan, EFFECT_DIRECT) && direct_study_plan(record, &asked, status) != STATUS_OK) ||
        solve_tiles(record, &plan, &asked.threads, status) != STATUS_OK ||
        solve_strips(record, &plan, &asked.threads, status) != STATUS_OK)
        return status->code;
    return curves_run(record, &asked, status);
}
