/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/evaluate.h"
#include "analysis/shaped.h"

#include "analysis/describe.h"
#include "analysis/direct_study.h"
#include "analysis/effects.h"
#include "base/clock.h"
#include "contact/statistical.h"
#include "joint/joint.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Carries the spectrum on below its last known harmonic, where that can change anything. */
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
        model->extended = true;
    }
    summary->times.convergence = clock_seconds() - started;
}

/** What the models that stack scales say at the operating load where the fitted law (4.53) stands in place of the
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

/** What simulated records say of how far another place of a surface with one scan may answer. */
static enum status_code run_uncertainty(struct surface_record *record, const struct scene *scene,
                                        const struct plan *plan, const struct model_task *task, const atomic_bool *stop,
                                        struct status *status)
{
    struct surface_summary *summary = &record->summary;
    struct model_task counted = *task;
    counted.evaluations = &summary->simulated_evaluations;
    double started = clock_seconds(), waves = model_task_longest_waves(task);
    const struct joint_task joint = surface_joint(record, scene, plan, task);
    const struct surface_record *const bodies[] = {record, record->counterface};
    struct uncertainty_scan scan = {
        .how = record_conditioning_of(scene, false), .task = &counted, .joint = &joint, .stop = stop};
    for (size_t k = 0; k < 2 && bodies[k]; k++)
        scan.body[k] = (struct uncertainty_body){bodies[k]->height_m, bodies[k]->summary.single_points,
                                                 bodies[k]->summary.spacing_m / surface_kappa(summary)};
    struct uncertainty *all = calloc(model_count, sizeof *all);
    if (!all)
        return status_memory(status);
    struct status problem = {0};
    enum status_code rc = uncertainty_run(all, &scan, plan, &problem);
    if (rc != STATUS_OK && rc != STATUS_SCAN)
        (void)status_fail(status, rc, "%s", problem.message);
    for (size_t m = 0; m < model_count && rc == STATUS_OK; m++) {
        const struct model_curve *curve = &record->curves[m];
        if (!curve->exists || !uncertainty_holds(plan, m))
            continue;
        struct estimate estimates[CURVE_ESTIMATES];
        for (int which = 0; which < CURVE_ESTIMATES; which++)
            estimates[which] = estimate_none;
        if (!(record->bands[m] = ensemble_band_make(task->loads, task->load_count))) {
            rc = status_memory(status);
            break;
        }
        for (size_t i = 0; i < curve->count; i++) {
            const struct contact_point *point = &curve->points[i];
            if (point->value[QUANTITY_LOAD] != record->bands[m][i].load)
                break; /* a statistical curve closes at a load of its own */
            struct estimate own[QUANTITY_COUNT];
            for (int q = 0; q < QUANTITY_COUNT; q++)
                own[q] =
                    uncertainty_estimate(&all[m], model_rows[m], (enum quantity)q, point, summary->asperities.sigma_m);
            ensemble_settle(own, point, model_rows[m], &joint, waves);
            for (int q = 0; q < QUANTITY_COUNT; q++)
                for (int side = 0; side < 2; side++)
                    record->bands[m][i].mean[q][side] = estimate_end(&own[q], side);
            if (i == model_task_operating(task))
                memcpy(estimates, own, sizeof own);
        }
        rc = curve_summary_put_estimates(summary->models[m], estimates, status);
    }
    free(all);
    summary->times.uncertainty += clock_seconds() - started;
    return rc == STATUS_SCAN ? STATUS_OK : rc; /* no records of this one */
}

/** The other estimate of beta (4.54), which brings delta_ADJ closest to the separation H of the multiscale model of the
 * same material law, in the mean square: the mean of 4 (H - delta/2)/sigma over the loads that both answer. */
static double nearest_beta(const struct surface_record *record, size_t m)
{
    const struct model_curve *curve = &record->curves[m],
                             *other = &record->curves[model_index(model_rows[m]->counterpart)];
    double sum = 0, count = 0;
    for (size_t i = 0; i < curve->count && i < other->count; i++) {
        const double *own = curve->points[i].value, *multiscale = other->points[i].value;
        if (own[QUANTITY_LOAD] != multiscale[QUANTITY_LOAD])
            continue;
        sum += statistical_beta_multiscale(&own[QUANTITY_SEPARATION], &multiscale[QUANTITY_SEPARATION], 1,
                                           record->summary.asperities.sigma_m);
        count++;
    }
    return sum / count;
}

/** What a model that has run leaves to say. */
static void note_model(struct surface_record *record, size_t m, size_t left_out)
{
    const struct model_curve *curve = &record->curves[m];
    if (left_out > 0 && curve->exists)
        note_add(&record->summary.notes, NULL,
                 "%s has no solution for %zu of the scans run alone; its curve is of the others", model_rows[m]->label,
                 left_out);
    if (curve->overflows)
        note_add(&record->summary.notes, NULL,
                 "no %s: its numbers leave what can be computed with; check the units, the material and the loads",
                 model_rows[m]->label);
}

enum { MAP_DEGREES = 4 /* of freedom of its standard errors: they are of four quarters, about */ };

/** The interval of a map's direct solution, by its standard errors. */
static enum status_code put_map_errors(struct surface_record *record, size_t m, const struct model_task *task,
                                       struct status *status)
{
    static const double carried[] = {0.02, 0.015, 0.033}; /* rms of ln between the loads solved: eight synthetic maps */
    struct estimate estimates[CURVE_ESTIMATES];
    const struct model_curve *curve = &record->curves[m];
    for (int k = 0; k < CURVE_ESTIMATES; k++)
        estimates[k] = estimate_none;
    if (!(record->bands[m] = ensemble_band_make(task->loads, task->load_count)))
        return status_memory(status);
    for (size_t i = 0; i < curve->count; i++)
        for (int q = 0; q < QUANTITY_COUNT; q++) {
            const struct quantity_row *row = &quantity_rows[q];
            const int which = row->solved.mean; /* area, gap, constriction */
            if (!(row->is & QUANTITY_BANDED) || row->from)
                continue;
            double value = quantity_shown(&curve->points[i], (enum quantity)q, record->summary.asperities.sigma_m);
            double s = transfer_error(task->transfer, model_rows[m]->plastic, which, task->loads[i]);
            struct estimate own = estimate_of_error(value, hypot(s, carried[which]), MAP_DEGREES);
            own.share = q == QUANTITY_AREA;
            for (int side = 0; side < 2; side++)
                record->bands[m][i].mean[q][side] = estimate_end(&own, side);
            if (i == model_task_operating(task))
                estimates[q] = own;
        }
    return curve_summary_put_estimates(record->summary.models[m], estimates, status);
}

/** One model: its curve, or the mean of its scans' curves; what lies in the joint; where it bends; what it hangs on. */
static enum status_code run_model(struct surface_record *record, size_t m, const struct scene *scene,
                                  const struct plan *plan, const struct model_task *task, struct status *status)
{
    struct model_curve *curve = &record->curves[m];
    struct curve_summary *model = record->summary.models[m];
    curve->points = calloc(task->load_count + 1, sizeof *curve->points);
    if (!curve->points)
        return status_memory(status);
    double started = clock_seconds();
    bool several = record->ensemble.scan_count > 1 && !model_rows[m]->uses_map;
    if (plan_runs(plan, EFFECT_SHAPE) && shaped_make(record, m, scene, plan, task, status) != STATUS_OK)
        return status->code;
    if (several && !(record->bands[m] = ensemble_band_make(task->loads, task->load_count)))
        return status_memory(status);
    const struct joint_task joint = surface_joint(record, scene, plan, task);
    struct ensemble_result result = {.joint = &joint, .band = record->bands[m]};
    if (ensemble_curve(curve, &result, &record->ensemble, model_rows[m], task, status) != STATUS_OK)
        return status->code;
    curve->kink.wavelength_m *= surface_kappa(&record->summary);              /* as the scans have it */
    if (joint_curve(curve, model_rows[m], task, &joint, status) != STATUS_OK) /* of several scans, the mean curve's */
        return status->code;
    if (curve->exists)
        curve_summary_make(model, curve, model_rows[m], record->summary.asperities.sigma_m,
                           task->loads[model_task_operating(task)]);
    const struct model_task middle = surface_middle_task(task);
    if ((several && curve_summary_put_estimates(model, result.estimates, status) != STATUS_OK) ||
        sensitivity_run(&model->sensitivity, &record->sensitivity, model_rows[m], &middle, status) != STATUS_OK)
        return status->code;
    model->seconds = clock_seconds() - started;
    if (several && result.scans < 2) { /* one scan alone says nothing of others */
        free(record->bands[m]);
        record->bands[m] = NULL;
    }
    note_model(record, m, result.left_out);
    if (model_rows[m]->uses_map && curve->exists)
        return put_map_errors(record, m, task, status);
    return STATUS_OK;
}

/** What a perfect lay would change in model `m`: with frequencies times kappa = sqrt(1/2) the surface is, in lengths
 * that are 1/kappa times its own, this one of a modulus kappa E'. */
static enum status_code run_perfect_lay(struct surface_record *record, size_t m, const struct model_task *task,
                                        struct status *status)
{
    struct material_pair pair = record->summary.pair;
    struct model_task one = surface_middle_task(task), lay = one;
    double load = one.loads[0] / M_SQRT1_2, *out = record->summary.perfect_lay;
    struct contact_point points[2][2] = {{{.value = {0}}}};
    pair.effective_modulus_Pa *= M_SQRT1_2;
    lay.loads = &load;
    lay.pair = &pair;
    out[0] = out[1] = NAN;
    for (int k = 0; k < 2; k++) {
        struct model_curve curve = {.points = points[k]};
        const struct model_task *asked = k == 0 ? &one : &lay;
        if (ensemble_curve(&curve, NULL, &record->ensemble, model_rows[m], asked, status) != STATUS_OK)
            return status->code;
        if (!curve.exists || curve.count == 0 || points[k][0].value[QUANTITY_LOAD] != asked->loads[0])
            return STATUS_OK;
    }
    out[0] = points[1][0].value[QUANTITY_AREA] / points[0][0].value[QUANTITY_AREA];
    if (points[0][0].value[QUANTITY_ECR] > 0)
        out[1] = points[1][0].value[QUANTITY_ECR] / points[0][0].value[QUANTITY_ECR] / M_SQRT1_2;
    return STATUS_OK;
}

/** Room for what the models leave. */
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
static enum status_code solve_strips(struct surface_record *record, const struct plan *plan, const atomic_bool *stop,
                                     struct status *status)
{
    struct surface_summary *summary = &record->summary;
    struct ensemble *set = &record->ensemble;
    struct strips *strips = &record->strips;
    double started = clock_seconds();
    bool used = false;
    for (size_t m = 0; m < model_count; m++)
        used = used || (plan_runs_model(plan, m) && model_rows[m]->uses_strip);
    if (!used || strips->rows.rows == 0)
        return STATUS_OK;
    enum status_code rc = strips_solve(strips, stop, status);
    if (rc == STATUS_OK && set->scan_count > 1)
        rc = strips_solve_members(strips, set, stop, status);
    summary->has_strips = strips->joined;
    for (size_t p = 0; p < set->count; p++) {
        summary->has_strips = summary->has_strips || set->members[p].strip;
        summary->strip_unsolved[1] += set->solved_alone && set->members[p].pieces > 0 && !set->members[p].strip;
    }
    if (rc == STATUS_OK && !summary->has_strips)
        note_add(&summary->notes, NULL, "no strip transfer: %s", strips->problem.message);
    summary->strip_unsolved[0] = strips->unsolved;
    summary->strip_transforms = strips->transforms;
    summary->times.strips = clock_seconds() - started;
    return rc;
}

/** Solves the map that running models use. Where it has no answer the effects are decided once more. */
static enum status_code solve_tiles(struct surface_record *record, const struct scene *scene, struct plan *plan,
                                    const atomic_bool *stop, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    struct tiles *tiles = &record->tiles;
    double started = clock_seconds(), hardness = INFINITY;
    bool used = false;
    for (size_t m = 0; m < model_count; m++)
        used = used || (plan_runs_model(plan, m) && model_rows[m]->uses_map);
    if (!used || !summary->has_tiles)
        return STATUS_OK;
    if (plan_runs(plan, EFFECT_PLASTICITY) && summary->pair.hardness_Pa > 0)
        hardness = summary->pair.hardness_Pa / summary->pair.effective_modulus_Pa;
    if (tiles_solve(tiles, hardness, stop, status) != STATUS_OK)
        return status->code;
    summary->has_tiles = tiles->transfer != NULL;
    summary->tile_transforms = tiles->transforms;
    summary->times.tiles = clock_seconds() - started;
    if (summary->has_tiles)
        return STATUS_OK;
    summary->tile_cost = 0; /* more of it would not help */
    note_add(&summary->notes, NULL, "no direct solution of the map: %s", tiles->problem.message);
    effects_decide(plan, scene, record, 1);
    return STATUS_OK;
}

/** What is to be known of the joint beside its numbers. */
static void note_joint(struct surface_record *record, const struct scene *scene, const struct plan *plan)
{
    const struct joint *joint = &scene->joint;
    const struct joint_layer *metal = &joint_platings[joint->plating];
    struct note_list *notes = &record->summary.notes;
    const double thick_m = joint->plating_thickness_m;
    if (plan_runs(plan, EFFECT_GAP) && joint->fill == JOINT_MEDIUM && !(joint->bond_line_m > 0))
        note_add(notes, NULL, "no bond_line: the filler is as thin as the gaps, which none is; give it, such as 25 um");
    if (plan_runs(plan, EFFECT_PLATING) && joint->plating && (thick_m < metal->least_m || thick_m > metal->most_m))
        note_add(notes, NULL, "%.3g um of %s, of which %.3g to %.3g um are usual", thick_m * 1e6,
                 joint_plating_names[joint->plating], metal->least_m * 1e6, metal->most_m * 1e6);
}

enum status_code evaluate_models(struct surface_record *record, const struct scene *scene, const struct plan *plan,
                                 const double *loads, size_t load_count, const atomic_bool *stop, struct status *status)
{
    struct model_task task = surface_model_task(record, scene, plan, loads, load_count);
    if (make_model_room(record, plan, load_count, status) != STATUS_OK)
        return status->code;
    for (size_t m = 0; m < model_count; m++) {
        if (!plan_runs_model(plan, m))
            continue;
        task.evaluations = &record->summary.models[m]->evaluations;
        if (run_model(record, m, scene, plan, &task, status) != STATUS_OK)
            return status->code;
    }
    task.evaluations = NULL;
    size_t leading = plan_leading_model(plan);
    if (!record->summary.has_lay && plan_runs_model(plan, leading) &&
        run_perfect_lay(record, leading, &task, status) != STATUS_OK)
        return status->code;
    if (plan_runs(plan, EFFECT_UNCERTAINTY) && record->height_m &&
        run_uncertainty(record, scene, plan, &task, stop, status) != STATUS_OK)
        return status->code;
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs(plan, EFFECT_SEPARATION) && plan_runs_model(plan, m) &&
            plan_runs_model(plan, model_index(model_rows[m]->counterpart)))
            record->summary.models[m]->beta_multiscale = nearest_beta(record, m);
    if (plan_runs(plan, EFFECT_CONVERGENCE)) {
        extend(record, scene);
        if (try_law(record, &task, status) != STATUS_OK)
            return status->code;
    }
    note_joint(record, scene, plan);
    if (record->shapes && plan_runs_model(plan, leading))
        record->summary.carrying = joint_shape_area(&record->shapes[leading], task.loads[model_task_operating(&task)]);
    return answers_find(record, scene, plan, &task, status);
}

/** The leading model at the shares of the largest load, times what unloading does there. */
static enum status_code unload(struct surface_unloading *out, const struct surface_record *record,
                               const struct model_task *task, struct status *status)
{
    double loads[UNLOADING_SHARES];
    size_t count = out->ratio.count;
    struct contact_point points[UNLOADING_SHARES + 1];
    struct model_curve curve = {.points = points};
    for (size_t i = 0; i < count; i++)
        loads[i] = out->largest_load * out->ratio.share[count - 1 - i];
    struct model_task asked = model_task_at(task, loads, count);
    if (ensemble_curve(&curve, NULL, &record->ensemble, model_rows[out->model], &asked, status) != STATUS_OK)
        return status->code;
    if (curve.count < count)
        return status_fail(status, STATUS_MODEL, "the curve of %s ends below unload_from",
                           model_rows[out->model]->label);
    for (int q = QUANTITY_AREA; q < QUANTITY_COUNT; q++) {
        double up[UNLOADING_SHARES];
        for (size_t i = 0; i < count; i++)
            up[i] = points[count - 1 - i].value[q];
        unloading_bound(&out->ratio, (enum quantity)q, up);
    }
    for (size_t i = 0; i < count; i++) {
        out->points[i] = points[i];
        for (int q = QUANTITY_AREA; q < QUANTITY_COUNT; q++)
            out->points[i].value[q] *= unloading_factor(&out->ratio, (enum quantity)q, loads[i] / out->largest_load);
    }
    return STATUS_OK;
}

enum { STRIP_SHARES = 5 }; /* a strip that has fewer of them tells too little */

/** The curve of falling load. Where there is none a note says why. */
static enum status_code run_unloading(struct surface_record *record, const struct evaluate_task *task,
                                      const struct plan *plan, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    struct surface_unloading *out = summary->unloading = calloc(1, sizeof *out);
    const struct model_task asked = surface_model_task(record, task->scene, plan, task->loads, task->load_count);
    double started = clock_seconds(), hardness = asked.hardness_Pa / asked.pair->effective_modulus_Pa;
    struct status problem = {0};
    enum status_code rc = STATUS_OK;
    if (!out)
        return status_memory(status);
    out->largest_load = scene_load_of(&task->scene->unload_from, task->scene, asked.pair);
    out->model = plan_leading_model(plan);
    if (asked.rows)
        rc = unloading_solve(&out->ratio, asked.rows, out->largest_load, hardness, task->stop, &problem);
    if (rc == STATUS_OK && out->ratio.count < STRIP_SHARES)
        rc = status_fail(&problem, STATUS_MODEL, "too few spots touch in its strip; take longer or more scans");
    if (rc == STATUS_OK)
        rc = unload(out, record, &asked, &problem);
    summary->times.unloading = clock_seconds() - started;
    if (rc == STATUS_OK && out->ratio.raised > 1)
        note_add(&summary->notes, NULL,
                 "unloading: its strip was loaded to %g times unload_from, so that enough spots touch",
                 out->ratio.raised);
    if (rc == STATUS_OK)
        return rc;
    free(out);
    summary->unloading = NULL;
    if (rc != STATUS_MODEL)
        return status_fail(status, rc, "%s", problem.message);
    note_add(&summary->notes, NULL, "no curve of unloading: %s", problem.message);
    return STATUS_OK;
}

static enum status_code evaluate(struct surface_record *out, const struct evaluate_task *task, struct status *status)
{
    const struct scene *scene = task->scene;
    struct plan plan = *task->plan;
    if ((!task->described && describe_surface(out, scene, task->surface, task->counterface, status) != STATUS_OK) ||
        !out->summary.usable)
        return status->code;
    if (effects_bound(out, scene, &plan, task->loads, task->load_count, status) != STATUS_OK)
        return status->code;
    effects_decide(&plan, scene, out, 1);
    out->summary.running = plan.running;
    if ((task->describe_only || plan_runs(&plan, EFFECT_DIRECT)) &&
        direct_study_plan(out, scene, &plan, task->loads, task->load_count, status) != STATUS_OK)
        return status->code;
    if (task->describe_only)
        return STATUS_OK;
    enum status_code rc = solve_tiles(out, scene, &plan, task->stop, status);
    if (rc == STATUS_OK)
        rc = solve_strips(out, &plan, task->stop, status);
    if (rc == STATUS_OK)
        rc = evaluate_models(out, scene, &plan, task->loads, task->load_count, task->stop, status);
    if (rc == STATUS_OK && plan_runs(&plan, EFFECT_UNLOADING))
        rc = run_unloading(out, task, &plan, status);
    if (!task->keep_scans)
        surface_drop_scans(out);
    return rc;
}

enum status_code evaluate_surface(struct surface_record *out, const struct evaluate_task *task, struct status *status)
{
    enum status_code rc = evaluate(out, task, status);
    return rc == STATUS_MEMORY ? surface_put_aside(out, task->scene, status) : rc;
}
