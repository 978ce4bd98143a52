/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/surface.h"

#include "analysis/joined.h"

#include "analysis/gather.h"
#include "analysis/landmarks.h"
#include "base/clock.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Names the models that were asked for and work on asperities, when the surface has none. */
static void note_models_lost(struct surface_summary *summary, uint64_t models, const char *why)
{
    struct text names = {0};
    for (size_t m = 0; m < model_count; m++)
        if ((models & MODEL_BIT(m)) && model_rows[m]->asperity_model)
            text_add(&names, "%s%s", names.length > 0 ? " and " : "", model_rows[m]->label);
    if (names.length > 0)
        gather_note(summary, "no %s: %s", text_string(&names), why);
    text_free(&names);
}

/** gamma at short wavelengths, where convergence is decided. */
static double short_gamma(const struct power_law *law)
{
    return isfinite(law->knee_m) ? law->gamma_below : law->gamma;
}

bool surface_tells_gamma(const struct surface_summary *summary)
{
    const struct power_law *law = &summary->power_law;
    double known_m = summary->length_m / (double)summary->tail.count;
    return power_law_holds(law) && (isnan(law->knee_m) || known_m <= law->band_m[0] * (1 + 1e-9));
}

bool surface_diverges(const struct surface_summary *summary)
{
    const struct power_law *law = &summary->power_law;
    return surface_tells_gamma(summary) && short_gamma(law) + law->gamma_error < 1;
}

/** What the line through all harmonics leaves to say: a step between the ends, two slopes. */
static void note_thesis_fit(struct surface_summary *summary)
{
    const struct power_law *law = &summary->power_law;
    if (isnan(law->gamma)) {
        gather_note(summary, "no power law: %s",
                    law->harmonics < 3 ? "fewer than 3 harmonics lie in the fit band; widen fit_band"
                                       : "its alpha is beyond the range of numbers; are the units right?");
        return;
    }
    /* a jump J at the border of the record adds J/(pi n) to harmonic n, an f^-1 tail */
    double shortest = law->band_m[0], leak_m = summary->jump_m * shortest / (M_PI * summary->length_m);
    bool leaks = summary->windowed < summary->scans && summary->periodic < summary->scans;
    summary->jump_share = leaks ? leak_m / power_law_amplitude(law, shortest) : 0;
    if (summary->jump_share > 0.5)
        gather_note(
            summary,
            "the ends of the record differ by %.3g um; that jump alone leaks %s of the fitted amplitude at %.3g um, "
            "so gamma is drawn towards 1: try window: hann",
            summary->jump_m * 1e6, summary->jump_share > 1 ? "more than the whole" : "over half", shortest * 1e6);
    if (isfinite(law->knee_m))
        gather_note(summary, "two slopes fit better than one: gamma %.2f above %.3g um, %.2f below; consider fit_band",
                    law->gamma_above, law->knee_m * 1e6, law->gamma_below);
}

static void note_band(struct surface_summary *summary, const struct power_law_band *band)
{
    const struct power_law *law = &summary->power_law;
    double line_m[LOG_BIN_MOST];
    size_t count = power_law_band_lines(line_m, band);
    struct text lines = {0};
    if (law->found == POWER_LAW_BAND_NONE)
        gather_note(summary, "no power law found");
    else if (law->found == POWER_LAW_BAND_NARROW)
        gather_note(summary, "the power law is narrow: it holds from %.3g to %.3g um only, under a decade",
                    law->band_m[0] * 1e6, law->band_m[1] * 1e6);
    for (size_t i = 0; i < count; i++)
        text_add(&lines, "%s%.3g um", i > 0 ? ", " : "", line_m[i] * 1e6);
    if (count > 0)
        gather_note(summary, "lines of periodic marks, left out of the fit: %s", text_string(&lines));
    text_free(&lines);
}

static struct power_law_scans_def fit_def(const struct scene *scene)
{
    return (struct power_law_scans_def){scene->lambda_s_m, scene->fit_band_given ? scene->fit_band_m : NULL};
}

/** Every scan's law in the band of their mean. */
static enum status_code fit_alone(struct surface_record *record, const struct power_law_scans *scans,
                                  const struct scene *scene, struct status *status)
{
    const struct power_law_scans_def def = fit_def(scene);
    struct repeats *repeats = record->summary.repeats;
    const struct repeats_grouping of = {&record->repeats, scans->file, scans->scan_count};
    if (!repeats)
        return STATUS_OK;
    double *gamma = malloc(2 * of.count * sizeof *gamma);
    if (!gamma)
        return status_memory(status);
    double *psd_m3 = gamma + of.count;
    enum status_code rc = STATUS_OK;
    for (size_t i = 0; i < of.count && rc == STATUS_OK; i++) {
        struct power_law_band alone;
        rc = power_law_scans_fit_alone(&alone, scans, i, &def, &record->band, status);
        struct power_law law = power_law_of_band(&alone);
        gamma[i] = law.gamma;
        psd_m3[i] = law.psd_m3;
    }
    if (rc == STATUS_OK)
        rc = repeats_estimate_grouped(&repeats->gamma, gamma, &of, false, status);
    if (rc == STATUS_OK)
        rc = repeats_estimate_grouped(&repeats->psd_m3, psd_m3, &of, true, status);
    free(gamma);
    return rc;
}

static enum status_code fit_band(struct surface_record *record, struct power_law_scans *scans,
                                 const struct scene *scene, struct status *status)
{
    const struct power_law_scans_def def = fit_def(scene);
    if (power_law_scans_fit(&record->band, scans, &def, status) != STATUS_OK)
        return status->code;
    record->summary.power_law = power_law_of_band(&record->band);
    note_band(&record->summary, &record->band);
    record->tapered = scans->mean;
    scans->mean = (struct spectrum){0};
    return STATUS_OK;
}

/** What is fitted to the spectra of a surface. */
struct fitting {
    struct surface_record *record;
    struct power_law_scans *scans;
    const struct scene *scene;
};

enum { FIT_LAW, FIT_TAIL, FITTINGS };

static enum status_code fit_one(void *context, size_t index, struct threads_turn *turn, struct status *status)
{
    struct fitting *fitting = context;
    struct surface_record *record = fitting->record;
    struct surface_summary *summary = &record->summary;
    (void)turn;
    if (index == FIT_TAIL) {
        const struct scene *scene = fitting->scene;
        double shortest_m = fmax(2 * scene->lambda_s_m, scene->fit_band_m[0]);
        summary->tail = convergence_tail(&record->spectrum,
                                         convergence_known(&record->spectrum, shortest_m, fitting->scans->step_m));
        return STATUS_OK;
    }
    if (fitting->scene->fit != POWER_LAW_THESIS)
        return fit_band(record, fitting->scans, fitting->scene, status);
    summary->power_law = power_law_fit(&record->spectrum, fitting->scene->fit_band_m);
    note_thesis_fit(summary);
    return STATUS_OK;
}

enum { SHARED_POINTS = 1 << 16 }; /* with fewer, threads take longer to start than they save */

/** Power law and statistical parameters. */
static enum status_code describe(struct surface_record *record, struct power_law_scans *scans,
                                 const struct scene *scene, const struct threads *threads, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    struct status none = {0};
    struct fitting fitting = {record, scans, scene};
    double started = clock_seconds();
    summary->harmonics = record->spectrum.count;
    summary->independent = fmax(1, scans->independent);
    if (threads_run(summary->points >= SHARED_POINTS ? threads : NULL, FITTINGS, fit_one, &fitting, status) !=
        STATUS_OK)
        return status->code;
    summary->times.spectrum += clock_seconds() - started;
    summary->has_asperities = roughness_asperities(&summary->asperities, &summary->roughness, &none) == STATUS_OK;
    if (!summary->has_asperities)
        note_models_lost(summary, scene->models, none.message);
    if (surface_diverges(summary))
        gather_note(summary,
                    "gamma = %.2f is below 1: the elastic multiscale area depends on the shortest wavelength sampled",
                    short_gamma(&summary->power_law));
    return STATUS_OK;
}

const struct curve_summary *surface_model(const struct surface_summary *summary, size_t m)
{
    static const struct curve_summary none;
    return summary->models && summary->models[m] ? summary->models[m] : &none;
}

const struct repeats *surface_repeats(const struct surface_summary *summary)
{
    static const struct repeats none = {.rq_m = ESTIMATE_NONE, .gamma = ESTIMATE_NONE, .psd_m3 = ESTIMATE_NONE};
    return summary->repeats ? summary->repeats : &none;
}

struct repeats *surface_repeats_room(struct surface_summary *summary)
{
    if (!summary->repeats)
        summary->repeats = calloc(1, sizeof *summary->repeats);
    return summary->repeats;
}

const struct curve_bounds *surface_bounds(const struct surface_summary *summary, size_t m)
{
    static const struct curve_bounds none;
    return summary->bounds && summary->bounds[m] ? summary->bounds[m] : &none;
}

struct curve_summary *surface_model_room(struct surface_summary *summary, size_t m)
{
    if (!summary->models && !(summary->models = calloc(model_count, sizeof *summary->models)))
        return NULL;
    if (!summary->models[m])
        summary->models[m] = calloc(1, sizeof *summary->models[m]);
    return summary->models[m];
}

struct curve_bounds *surface_bounds_room(struct surface_summary *summary, size_t m)
{
    if (!summary->bounds && !(summary->bounds = calloc(model_count, sizeof *summary->bounds)))
        return NULL;
    if (!summary->bounds[m])
        summary->bounds[m] = calloc(1, sizeof *summary->bounds[m]);
    return summary->bounds[m];
}

/** No one asks for them once the models have run. */
static void free_bounds(struct surface_summary *summary)
{
    for (size_t m = 0; summary->bounds && m < model_count; m++)
        free(summary->bounds[m]);
    free(summary->bounds);
    summary->bounds = NULL;
}

struct model_task surface_task(const struct surface_record *record, const struct scene *scene, const struct plan *plan,
                               const double *loads, size_t load_count)
{
    return (struct model_task){
        .spectrum = &record->spectrum,
        .asperities = record->summary.has_asperities ? &record->summary.asperities : NULL,
        .pair = &record->summary.pair,
        .loads = loads,
        .load_count = load_count,
        .operating_place = plan->operating_place,
        .wanted = plan->wanted,
        .tolerance = scene->tolerance,
        .sinusoid_fit = scene->closure,
        .points = record->points,
        .point_count = record->summary.heights,
        .hardness_Pa = record->summary.pair.hardness_Pa,
    };
}

bool surface_extends(const struct surface_summary *summary, const struct scene *scene)
{
    return !isnan(summary->tail.gamma) && !(scene->effects_auto && summary->bound.converged);
}

/** Carries the spectrum on below its last known harmonic, where that can change anything. */
static void extend(struct surface_record *record, const struct scene *scene)
{
    struct surface_summary *summary = &record->summary;
    double started = clock_seconds();
    for (size_t m = 0; m < model_count; m++) {
        struct curve_summary *model = summary->models ? summary->models[m] : NULL;
        if (!model_rows[m]->stacks_scales || !model || !model->exists || !surface_extends(summary, scene))
            continue;
        model->extension = convergence_extend(&record->spectrum, &summary->tail, &summary->pair, model_rows[m]->plastic,
                                              scene->convergence.load);
        model->extended = true;
    }
    summary->times.convergence = clock_seconds() - started;
}

static enum status_code make_band(struct surface_record *record, size_t m, const struct model_task *task,
                                  struct status *status)
{
    record->bands[m] = repeats_band_make(task->loads, task->load_count);
    return record->bands[m] ? STATUS_OK : status_memory(status);
}

/** Every scan of the surface alone in one model; the curve is their mean. */
static enum status_code run_repeats(struct surface_record *record, size_t m, const struct model_task *task,
                                    struct repeats_result *result, struct status *status)
{
    if (make_band(record, m, task, status) != STATUS_OK)
        return status->code;
    result->band = record->bands[m];
    return repeats_model(&record->curves[m], result, &record->repeats, model_rows[m], task, status);
}

/** What simulated records say of how far another place of a surface with one scan may answer. */
static enum status_code run_uncertainty(struct surface_record *record, const struct scene *scene,
                                        const struct plan *plan, const struct model_task *task, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    const struct uncertainty_scan scan = {
        record->height_m, summary->single_points, summary->spacing_m, piece_how_of(scene, false), task,
        summary->bounds};
    struct uncertainty *all = calloc(model_count, sizeof *all);
    if (!all)
        return status_memory(status);
    if (!summary->simulated)
        summary->simulated = calloc(1, sizeof *summary->simulated);
    enum status_code rc =
        summary->simulated ? uncertainty_run(all, &scan, plan, summary->simulated, status) : status_memory(status);
    for (size_t m = 0; m < model_count && rc == STATUS_OK; m++) {
        const struct model_curve *curve = &record->curves[m];
        if (!curve->exists || !uncertainty_holds(plan, m))
            continue;
        struct estimate estimates[CURVE_ESTIMATES];
        for (int which = 0; which < CURVE_ESTIMATES; which++)
            estimates[which] = estimate_none;
        for (size_t i = 0; i < curve->count; i++)
            for (int q = 0; q < QUANTITY_COUNT && curve->points[i].load == task->loads[model_task_operating(task)]; q++)
                estimates[q] =
                    uncertainty_estimate(&all[m], (enum quantity)q,
                                         quantity_shown(&curve->points[i], model_shown(model_rows[m], (enum quantity)q),
                                                        summary->asperities.sigma_m));
        rc = curve_summary_put_estimates(summary->models[m], estimates, status);
        if (rc == STATUS_OK)
            rc = make_band(record, m, task, status);
        if (rc == STATUS_OK)
            uncertainty_band(record->bands[m], &all[m], curve, model_rows[m], summary->asperities.sigma_m);
    }
    free(all);
    return rc;
}

struct model_task surface_middle_task(const struct model_task *task)
{
    return model_task_at(task, task->loads ? &task->loads[model_task_operating(task)] : NULL, 1);
}

/** What area and resistance at the middle load hang on. */
static enum status_code run_sensitivity(struct surface_record *record, size_t m, const struct model_task *task,
                                        struct status *status)
{
    struct curve_summary *model = record->summary.models[m];
    struct model_task one = surface_middle_task(task);
    struct contact_point as_is = quantity_nothing();
    for (size_t i = 0; i < record->curves[m].count; i++)
        if (record->curves[m].points[i].load == one.loads[0])
            as_is = record->curves[m].points[i];
    bool averaged = record->repeats.count > 0; /* as the changed scans are: the curve is not of the mean spectrum */
    return sensitivity_run(&model->sensitivity, &record->sensitivity, model_rows[m], &one, averaged ? NULL : &as_is,
                           &record->work[m], status);
}

/** Where model `m` bends and its validity ends on this surface. */
static enum status_code run_landmarks(struct surface_record *record, size_t m, const struct model_task *task,
                                      struct status *status)
{
    const unsigned quantities = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_ECR);
    struct landmarks_model searched = {model_rows[m], *task, quantities, &record->repeats};
    const struct landmarks_curve landmarks = {landmarks_run_model, &searched, task->tolerance};
    return landmarks_solve(record->summary.models[m], &record->curves[m], model_rows[m], &landmarks, status);
}

bool surface_seeks_beta(const struct plan *plan, size_t m)
{
    return plan_runs(plan, EFFECT_SEPARATION) && plan_runs_model(plan, m) &&
           plan_runs_model(plan, model_index(model_rows[m]->counterpart));
}

/** The second estimate of beta, against the multiscale model of the same material law. */
static enum status_code estimate_beta(struct surface_record *record, size_t m, const struct model_task *task,
                                      struct status *status)
{
    const unsigned quantities =
        QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_SEPARATION);
    const struct model_row *counterpart = model_rows[m]->counterpart;
    const struct model_curve *curve = &record->curves[m];
    struct curve_summary *model = record->summary.models[m];
    record->work[m].searches++;
    if (!curve->exists || !record->curves[model_index(counterpart)].exists)
        return STATUS_OK;
    struct landmarks_model own = {model_rows[m], *task, quantities, &record->repeats},
                           other = {counterpart, *task, quantities, &record->repeats};
    const struct landmarks_curve adjusted = {landmarks_run_model, &own, task->tolerance},
                                 multiscale = {landmarks_run_model, &other, task->tolerance};
    double to = fmin(curve->full_load, task->loads[task->load_count - 1]);
    return landmarks_nearest_beta(&model->beta_multiscale, &adjusted, &multiscale, task->loads[0], to,
                                  record->summary.asperities.sigma_m, status);
}

struct joint_task surface_joint(const struct surface_record *record, const struct scene *scene, const struct plan *plan,
                                const struct model_task *task)
{
    return (struct joint_task){&scene->joint,          task->pair,    record->summary.asperities.sigma_m,
                               scene->nominal_area_m2, plan->running, task->tolerance};
}

static enum status_code keep_estimates(struct curve_summary *model, const struct repeats_result *result,
                                       struct status *status)
{
    struct estimate all[CURVE_ESTIMATES];
    memcpy(all, result->middle, sizeof result->middle);
    all[CURVE_FULL_LOAD] = result->full_load;
    all[CURVE_BETA] = result->beta;
    return curve_summary_put_estimates(model, all, status);
}

/** What the models of a surface run on. */
struct modelling {
    struct surface_record *record;
    const struct scene *scene;
    const struct plan *plan;
    struct model_task task;
};

/** What a model that has run leaves to say. */
static void note_model(struct surface_record *record, size_t m, size_t left_out)
{
    const struct model_curve *curve = &record->curves[m];
    if (left_out > 0 && curve->exists)
        gather_note(&record->summary, "%s has no solution for %zu of the scans run alone; its curve is of the others",
                    model_rows[m]->label, left_out);
    if (curve->overflows)
        gather_note(&record->summary,
                    "no %s: its numbers leave what can be computed with; check the units, the material and the loads",
                    model_rows[m]->label);
}

/** Has a number of a curve of several scans no interval? */
static bool loses_interval(const struct surface_record *record, size_t m)
{
    const struct model_curve *curve = &record->curves[m];
    for (size_t i = 0; record->bands[m] && i < curve->count && i < record->band_count; i++)
        for (int q = 0; q < QUANTITY_COUNT && record->bands[m][i].load == curve->points[i].load; q++) {
            double value = quantity_value(&curve->points[i], model_shown(model_rows[m], (enum quantity)q));
            if (repeats_band_holds((enum quantity)q) && value > 0 && isnan(record->bands[m][i].mean[q][0]))
                return true;
        }
    return false;
}

/** Names the models whose scans answer so differently that an interval's ends are no numbers. */
static void note_intervals(struct surface_record *record)
{
    struct text names = {0};
    for (size_t m = 0; m < model_count; m++)
        if (record->repeats.count > 1 && !record->repeats.no_intervals && loses_interval(record, m))
            text_add(&names, "%s%s", names.length > 0 ? ", " : "", model_rows[m]->label);
    if (names.length > 0)
        gather_note(&record->summary,
                    "no interval at some loads (%s): the scans differ there by more than numbers hold; are they of one "
                    "surface, in one unit?",
                    text_string(&names));
    text_free(&names);
}

/** One model; none needs what another makes, and only their notes have an order. */
static enum status_code run_model(void *context, size_t m, struct threads_turn *turn, struct status *status)
{
    const struct modelling *modelling = context;
    struct surface_record *record = modelling->record;
    const struct model_task *task = &modelling->task;
    if (!plan_runs_model(modelling->plan, m))
        return STATUS_OK;
    struct model_curve *curve = &record->curves[m];
    struct curve_summary *model = record->summary.models[m];
    curve->points = calloc(task->load_count + 1, sizeof *curve->points);
    if (!curve->points)
        return status_memory(status);
    double started = clock_seconds();
    bool several = repeats_several(&record->repeats, model_rows[m]);
    struct repeats_result result = {.left_out = 0};
    if (several ? run_repeats(record, m, task, &result, status) != STATUS_OK
                : model_run(curve, model_rows[m], task, status) != STATUS_OK)
        return status->code;
    const struct joint_task joint = surface_joint(record, modelling->scene, modelling->plan, task);
    if (joined_curve(curve, model_rows[m], task, &joint, status) != STATUS_OK) /* of several scans, the mean curve's */
        return status->code;
    if (curve->exists) {
        curve_summary_make(model, curve, model_rows[m], record->summary.asperities.sigma_m);
        if (run_landmarks(record, m, task, status) != STATUS_OK)
            return status->code;
    }
    record->work[m] = curve->work;
    record->work[m].searches++;
    model->seconds = clock_seconds() - started;
    if ((several && keep_estimates(model, &result, status) != STATUS_OK) ||
        run_sensitivity(record, m, task, status) != STATUS_OK)
        return status->code;
    bool says = curve->overflows || (curve->exists && result.left_out > 0);
    if (says && threads_wait(turn)) /* few do: else none waits */
        note_model(record, m, result.left_out);
    return STATUS_OK;
}

/** Room for what the models leave: all of it before the first runs. */
static enum status_code make_model_room(struct surface_record *record, const struct plan *plan, size_t load_count,
                                        struct status *status)
{
    record->curves = calloc(model_count, sizeof *record->curves);
    record->bands = calloc(model_count, sizeof *record->bands);
    record->work = calloc(model_count, sizeof *record->work);
    record->band_count = load_count;
    if (!record->curves || !record->bands || !record->work)
        return status_memory(status);
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(plan, m) && !surface_model_room(&record->summary, m))
            return status_memory(status);
    return STATUS_OK;
}

/** All that is asked for of the models. */
static enum status_code run_models(struct modelling *modelling, size_t load_count, struct status *status)
{
    struct surface_record *record = modelling->record;
    const struct scene *scene = modelling->scene;
    const struct plan *plan = modelling->plan;
    const struct model_task *task = &modelling->task;
    if (make_model_room(record, plan, load_count, status) != STATUS_OK ||
        threads_run(record->spectrum.count >= SHARED_POINTS / 2 ? task->threads : NULL, model_count, run_model,
                    modelling, status) != STATUS_OK)
        return status->code;
    if (plan_runs(plan, EFFECT_UNCERTAINTY) && record->height_m &&
        run_uncertainty(record, scene, plan, task, status) != STATUS_OK)
        return status->code;
    for (size_t m = 0; m < model_count; m++)
        if (surface_seeks_beta(plan, m) && estimate_beta(record, m, task, status) != STATUS_OK)
            return status->code;
    if (plan_runs(plan, EFFECT_CONVERGENCE))
        extend(record, scene);
    free_bounds(&record->summary);
    note_intervals(record);
    if (answers_find(record, scene, plan, task, status) != STATUS_OK)
        return status->code;
    for (size_t m = 0; record->summary.models && m < model_count; m++) {
        struct curve_summary *model = record->summary.models[m];
        if (!model)
            continue;
        record->work[m].searches += scene->target_count;
        model->evaluations = model_evaluations(&record->work[m]);
    }
    return STATUS_OK;
}

enum status_code surface_run_models(struct surface_record *record, const struct scene *scene, const struct plan *plan,
                                    const double *loads, size_t load_count, const struct threads *threads,
                                    struct status *status)
{
    struct modelling modelling = {record, scene, plan, surface_task(record, scene, plan, loads, load_count)};
    struct model_kept kept = {.spectrum = modelling.task.spectrum, .pair = modelling.task.pair};
    modelling.task.threads = threads;
    modelling.task.kept = &kept;
    enum status_code rc = run_models(&modelling, load_count, status);
    model_kept_free(&kept);
    return rc;
}

/** Heights stay where a model that was asked for uses them, or unasked where they are not Gaussian; two rough bodies
 * have none in common. */
static void drop_points(struct surface_record *record, const struct scene *scene)
{
    bool asked = scene->models_named || record->summary.height_law.verdict != HEIGHTS_GAUSSIAN;
    if (asked && scene->counterface_surface.file_count == 0)
        return;
    free(record->points);
    record->points = NULL;
    record->summary.heights = 0;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/** The files by name: what comes out does not depend on the order in which a scene lists them. malloc'ed; NULL: out of
 * memory. */
static const char **sorted_files(const struct scene_surface *surface)
{
    const char **files = malloc((surface->file_count + 1) * sizeof *files);
    if (!files)
        return NULL;
    for (size_t f = 0; f < surface->file_count; f++)
        files[f] = surface->files[f];
    qsort(files, surface->file_count, sizeof *files, by_name);
    return files;
}

/** From what was gathered to the description of the surface. */
static enum status_code conclude(struct surface_record *record, struct power_law_scans *scans,
                                 const struct scene *scene, const struct surface_record *counterface,
                                 const struct threads *threads, struct status *status)
{
    if (counterface && gather_counterface(record, scans, counterface, status) != STATUS_OK)
        return status->code;
    if (describe(record, scans, scene, threads, status) != STATUS_OK)
        return status->code;
    const struct spectrum *spectrum = record->tapered.count > 0 ? &record->tapered : &record->spectrum;
    if (height_law_find(&record->summary.height_law, &record->summary.roughness, spectrum, record->summary.independent,
                        scene->level, status) != STATUS_OK)
        return status->code;
    drop_points(record, scene);
    if (gather_describe_repeats(record, scene, status) != STATUS_OK)
        return status->code;
    bool found = scene->fit == POWER_LAW_AUTO && record->band.law != POWER_LAW_BAND_NONE;
    return found ? fit_alone(record, scans, scene, status) : STATUS_OK;
}

/** The files of a surface, and which of them are refused. */
struct files {
    const char **name; /* sorted */
    size_t count, refused;
    char **refusal; /* why; NULL: not refused */
};

static void free_files(struct files *files)
{
    for (size_t f = 0; files->refusal && f < files->count; f++)
        free(files->refusal[f]);
    free(files->refusal);
    free(files->name);
}

/** Gathers every file that is not refused. What cannot be used is refused, and *again set where it left something
 * behind. */
static enum status_code gather_files(struct surface_record *out, struct power_law_scans *scans,
                                     const struct scene *scene, struct files *files, struct hash *hash,
                                     const struct threads *threads, bool *again, struct status *status)
{
    *again = false;
    for (size_t f = 0; f < files->count; f++) {
        struct status problem = {0};
        size_t before = out->repeats.scan_count;
        if (files->refusal[f])
            continue;
        enum status_code rc =
            gather_file(out, scans, scene, out->summary.scene, files->name[f], hash, threads, &problem);
        if (rc == STATUS_MEMORY || rc == STATUS_INTERRUPTED)
            return status_fail(status, rc, "%s", problem.message);
        if (rc == STATUS_OK)
            continue;
        *again = *again || out->repeats.scan_count > before;
        files->refusal[f] = strdup(problem.message);
        files->refused++;
        if (!files->refusal[f])
            return status_memory(status);
    }
    return STATUS_OK;
}

/** Says which scans were refused, but for the `first` of a surface that has no other: that is its own refusal. Before
 * all else that is noted, as these are never left out. */
static enum status_code note_refused(struct surface_summary *summary, const struct files *files, size_t first,
                                     struct status *status)
{
    struct text notes = {0};
    size_t used = files->count - files->refused;
    for (size_t f = 0; f < files->count; f++) {
        if (!files->refusal[f] || (used == 0 && f == first))
            continue;
        text_add(&notes, "%s%s", notes.length > 0 ? "\n" : "", files->refusal[f]);
        if (used > 0)
            text_add(&notes, " - refused; %zu of its %zu scans are used", used, files->count);
    }
    if (summary->notes)
        text_add(&notes, "\n%s", summary->notes);
    if (notes.failed) {
        text_free(&notes);
        return status_memory(status);
    }
    free(summary->notes);
    summary->notes = notes.data;
    summary->refused_scans = files->refused;
    return STATUS_OK;
}

/** Gathers the scans of a surface that can be used. Error: why there is none. */
static enum status_code gather_usable(struct surface_record *out, struct power_law_scans *scans,
                                      const struct scene *scene, struct files *files, const struct threads *threads,
                                      struct status *status)
{
    struct hash hash = hash_start(), unused = hash_start();
    bool again;
    enum status_code rc = gather_files(out, scans, scene, files, &hash, threads, &again, status);
    hash_finish(&hash, out->summary.hash);
    while (rc == STATUS_OK && again && files->refused < files->count) { /* from the start, without those */
        struct surface_summary kept = out->summary;
        free(kept.notes);
        kept.notes = NULL;
        surface_record_free(out, false);
        power_law_scans_free(scans);
        *scans = (struct power_law_scans){0};
        *out = (struct surface_record){.summary = {.scene = kept.scene, .pair = kept.pair, .times = kept.times}};
        memcpy(out->summary.hash, kept.hash, sizeof kept.hash);
        rc = gather_files(out, scans, scene, files, &unused, threads, &again, status);
    }
    if (rc != STATUS_OK || files->refused == 0)
        return rc;
    size_t first = 0;
    while (!files->refusal[first])
        first++;
    if (files->count > 1 && note_refused(&out->summary, files, first, status) != STATUS_OK)
        return status->code;
    if (files->refused < files->count)
        return STATUS_OK;
    return status_fail(status, STATUS_SCAN, "%s", files->refusal[first]);
}

enum status_code surface_describe(struct surface_record *out, const struct scene *scene,
                                  const struct scene_surface *surface, const struct surface_record *counterface,
                                  const struct threads *threads, struct status *status)
{
    struct surface_summary *summary = &out->summary;
    struct status problem = {0};
    struct power_law_scans scans = {0};
    struct files files = {sorted_files(surface), surface->file_count, 0,
                          calloc(surface->file_count + 1, sizeof(char *))};
    summary->scene = surface;
    summary->pair = scene_pair(surface->bodies);
    enum status_code rc = files.name && files.refusal ? gather_usable(out, &scans, scene, &files, threads, &problem)
                                                      : status_memory(&problem);
    free_files(&files);
    if (rc == STATUS_OK)
        rc = gather_conclude(out, &scans, scene, &problem);
    if (rc == STATUS_OK) {
        summary->usable = true;
        rc = conclude(out, &scans, scene, counterface, threads, &problem);
    }
    power_law_scans_free(&scans);
    if (rc == STATUS_MEMORY)
        return status_memory(status);
    if (rc != STATUS_OK) {
        summary->usable = false;
        summary->refusal = strdup(problem.message);
        return summary->refusal ? STATUS_OK : status_memory(status);
    }
    return STATUS_OK;
}

void surface_drop_scans(struct surface_record *record)
{
    repeats_free(&record->repeats);
    free(record->height_m);
    record->height_m = NULL;
}

void surface_summary_free(struct surface_summary *summary)
{
    free(summary->refusal);
    free(summary->notes);
    free_bounds(summary);
    for (size_t m = 0; summary->models && m < model_count; m++)
        if (summary->models[m]) {
            free(summary->models[m]->estimates);
            free(summary->models[m]);
        }
    free(summary->models);
    free(summary->repeats);
    free(summary->simulated);
    free(summary->direct);
    free(summary->answers);
    free(summary->limits);
    summary->repeats = NULL;
    summary->simulated = NULL;
    summary->direct = NULL;
    summary->answers = NULL;
    summary->limits = NULL;
    summary->refusal = summary->notes = NULL;
    summary->models = NULL;
}

void surface_record_free(struct surface_record *record, bool with_summary)
{
    spectrum_free(&record->spectrum);
    spectrum_free(&record->tapered);
    for (size_t m = 0; m < model_count; m++) {
        if (record->curves)
            free(record->curves[m].points);
        if (record->bands)
            free(record->bands[m]);
    }
    free(record->curves);
    free(record->bands);
    free(record->work);
    record->curves = NULL;
    record->bands = NULL;
    record->work = NULL;
    free(record->points);
    record->points = NULL;
    free(record->direct_m);
    record->direct_m = NULL;
    sensitivity_free(&record->sensitivity);
    surface_drop_scans(record);
    if (with_summary)
        surface_summary_free(&record->summary);
}
