/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answers/direct_study.h"

#include <math.h>
#include <stdlib.h>

static const double contact_tolerance = 1e-6; /* finds the same points in contact as 1e-12 */

/** A study in progress. */
struct maker {
    const struct direct_study_task *task;
    struct direct_study *study;
    struct direct_spectrum spectrum; /* of the surfaces made for a profile */
    struct direct_map map;
    double work; /* of all ensembles together */
};

static void tell(void *context, double work)
{
    const struct maker *maker = context;
    maker->task->progress(maker->task->progress_context, work, maker->work);
}

/** Surfaces made with the height distribution of a short scan have too flat a top, which shows at light loads. So
 * Gaussian ones are used while skewness and kurtosis are nearly Gaussian. */
static bool is_nearly_gaussian(const struct roughness *roughness)
{
    double kurtosis = roughness_kurtosis(roughness);
    return fabs(roughness_skewness(roughness)) < 0.5 && kurtosis >= 2.5 && kurtosis <= 4;
}

enum status_code direct_study_plan(struct surface_record *record, const struct surface_task *asked,
                                   struct status *status)
{
    struct surface_summary *surface = &record->summary;
    const struct scene *scene = asked->scene;
    const struct plan *plan = asked->plan;
    double hardness_Pa = !isnan(scene->direct.hardness_Pa) ? scene->direct.hardness_Pa : surface->pair.hardness_Pa;
    bool capped = plan_runs(plan, EFFECT_PLASTICITY) && hardness_Pa > 0;
    double resolved_m = 4 * surface->spacing_m;                      /* waves of two to four points are noisy */
    double kappa = surface->map.nx > 0 ? 1 : surface_kappa(surface); /* a map is solved as it is, with its lay */
    const struct direct_plan_task task = {
        .direct = &scene->direct,
        .divisor = scene_load_divisor(scene, scene->direct.kind, &surface->pair),
        .operating = plan->operating_place > 0 ? plan->operating_place - 1 : asked->load_count / 2,
        .loads = asked->loads,
        .load_count = asked->load_count,
        .map = surface->map,
        .height_m = record->direct_m,
        .length_m = surface->length_m / kappa,
        .spectrum = &record->spectrum,
        .lambda_s_m = fmin(scene->lambda_s_m > 0      ? scene->lambda_s_m
                           : scene->fit_band_m[0] > 0 ? fmax(scene->fit_band_m[0], resolved_m)
                                                      : resolved_m,
                           surface->length_m / 2) /
                      kappa,
        .of_spacing = !(scene->lambda_s_m > 0 || scene->fit_band_m[0] > resolved_m),
        .slope = sqrt(surface->roughness.m2) * kappa,
        .hardness = capped ? hardness_Pa / surface->pair.effective_modulus_Pa : INFINITY,
        .resistance =
            plan->running & (EFFECT_BIT(EFFECT_ELECTRICAL) | EFFECT_BIT(EFFECT_THERMAL) | EFFECT_BIT(EFFECT_STIFFNESS)),
        .gaussian = scene->counterface_surface.files.count > 0 || is_nearly_gaussian(&surface->roughness),
    };
    surface->direct = calloc(1, sizeof *surface->direct);
    if (!surface->direct)
        return status_memory(status);
    direct_plan_make(surface->direct, &task);
    return STATUS_OK;
}

/** The spectrum for the models: of the law, or the mean of the map's rows. */
static enum status_code find_rows(struct maker *maker, struct status *status)
{
    struct direct_study *study = maker->study;
    const struct direct_plan *plan = &study->plan;
    if (plan->side == 0) {
        size_t count = direct_law_harmonics(&plan->law), most = plan->grid / 2 - 1;
        count = count < most ? count : most;
        study->rows = (struct spectrum){malloc(count * sizeof(double)), count, plan->length_m, false};
        if (!study->rows.amplitude_m)
            return status_memory(status);
        for (size_t i = 0; i < count; i++)
            study->rows.amplitude_m[i] = direct_law_amplitude(&plan->law, i + 1);
        return STATUS_OK;
    }
    const struct direct_grid *grid = &maker->map.grid;
    const struct scan map = {.nx = grid->nx, .ny = grid->ny, .dx_m = grid->spacing_m, .z_m = maker->map.height_m};
    enum status_code rc =
        tiles_spectrum_along(&study->rows, &map, direct_map_lines(grid->nx, grid->ny, false), grid->mirrored, status);
    study->rows.length_m /= surface_kappa(&maker->task->surface->summary);
    return rc;
}

static struct direct_ensemble_def ensemble_def(struct maker *maker, enum direct_study_kind kind)
{
    const struct direct_plan *plan = &maker->study->plan;
    const struct surface_record *surface = maker->task->surface;
    bool capped = kind == DIRECT_STUDY_CAPPED;
    return (struct direct_ensemble_def){
        .ladder = {plan->load, capped ? plan->capped_loads : plan->loads, capped ? plan->hardness : INFINITY,
                   contact_tolerance, plan->resistance, maker->task->asked.threads.stop},
        .map = plan->side > 0 ? &maker->map : NULL,
        .length_m = plan->length_m,
        .n = plan->side > 0 ? plan->side : plan->grid,
        .fine_times = plan->fine_times,
        .recipe = {direct_spectrum_variance, &maker->spectrum, plan->gaussian ? NULL : surface->direct_m,
                   surface->direct_count},
        .seeds = capped ? plan->fewer : plan->seeds,
        .threads = maker->task->asked.threads.jobs,
        .solved = maker->task->progress ? tell : NULL,
        .solved_context = maker,
    };
}

static enum status_code solve_ensemble(struct maker *maker, enum direct_study_kind kind,
                                       const struct direct_ensemble_def *def, struct status *status)
{
    struct direct_ensemble ensemble;
    if (def->ladder.loads == 0)
        return STATUS_OK;
    if (direct_ensemble_run(&ensemble, def, status) != STATUS_OK)
        return status->code;
    maker->study->curves[kind] = (struct direct_study_curve){ensemble.point, def->ladder.loads, def->seeds};
    maker->study->solutions += def->ladder.loads * ensemble.ladders;
    ensemble.point = NULL;
    direct_ensemble_free(&ensemble);
    return STATUS_OK;
}

/** Runs the models on the spectrum of the rows. */
static enum status_code run_models(struct maker *maker, struct status *status)
{
    struct direct_study *study = maker->study;
    const struct direct_study_task *task = maker->task;
    const struct direct_plan *plan = &study->plan;
    struct roughness moments = task->surface->summary.roughness;
    struct asperities asperities;
    struct status none = {0};
    roughness_from_spectrum(&moments, &study->rows);
    bool has_asperities = roughness_asperities(&asperities, &moments, &none) == STATUS_OK;
    study->models = calloc(model_count, sizeof *study->models);
    if (!study->models)
        return status_memory(status);
    struct surface_task asked = task->asked;
    asked.loads = plan->load;
    asked.load_count = plan->loads;
    struct model_task ask = surface_model_task(task->surface, &asked);
    ask.rough = (struct cmy){.sigma_m = 0};
    ask.spectrum = &study->rows; /* all waves of this surface are known */
    ask.levelled = false;
    ask.asperities = has_asperities ? &asperities : NULL;
    if (!isnan(asked.scene->direct.hardness_Pa)) /* else both have the surface's */
        ask.hardness_Pa = asked.scene->direct.hardness_Pa;
    ask.transfer = NULL; /* the map's own solution is what models are compared with */
    enum status_code rc = STATUS_OK;
    for (size_t m = 0; m < model_count && rc == STATUS_OK; m++) {
        struct model_curve *curve = &study->models[m];
        if (!plan_runs_model(asked.plan, m))
            continue;
        curve->points = calloc(ask.load_count + 1, sizeof *curve->points);
        rc = curve->points ? model_run(curve, model_rows[m], &ask, status) : status_memory(status);
    }
    return rc;
}

static enum status_code run_study(struct maker *maker, struct status *status)
{
    struct direct_study *study = maker->study;
    const struct surface_record *surface = maker->task->surface;
    if (study->plan.side > 0) {
        if (direct_map_make(&maker->map, surface->direct_m, &surface->summary.map, study->plan.side, status) !=
            STATUS_OK)
            return status->code;
    } else if (direct_spectrum_of_law(&maker->spectrum, &study->plan.law, status) != STATUS_OK) {
        return status->code;
    }
    if (find_rows(maker, status) != STATUS_OK)
        return status->code;
    struct direct_ensemble_def defs[DIRECT_STUDY_KINDS];
    for (int kind = 0; kind < DIRECT_STUDY_KINDS; kind++) {
        defs[kind] = ensemble_def(maker, (enum direct_study_kind)kind);
        maker->work += direct_ensemble_work(&defs[kind]);
    }
    for (int kind = 0; kind < DIRECT_STUDY_KINDS; kind++)
        if (solve_ensemble(maker, (enum direct_study_kind)kind, &defs[kind], status) != STATUS_OK)
            return status->code;
    return run_models(maker, status);
}

enum status_code direct_study_run(struct direct_study *out, const struct direct_study_task *task, struct status *status)
{
    *out = (struct direct_study){.surface = task->index, .plan = *task->surface->summary.direct};
    struct maker maker = {.task = task, .study = out};
    enum status_code rc = run_study(&maker, status);
    direct_spectrum_free(&maker.spectrum);
    direct_map_free(&maker.map);
    if (rc != STATUS_OK)
        direct_study_free(out);
    return rc;
}

void direct_study_free(struct direct_study *study)
{
    for (int kind = 0; kind < DIRECT_STUDY_KINDS; kind++)
        free(study->curves[kind].points);
    for (size_t m = 0; study->models && m < model_count; m++)
        free(study->models[m].points);
    free(study->models);
    spectrum_free(&study->rows);
    *study = (struct direct_study){0};
}

const char *direct_study_heights(const struct direct_study *study)
{
    return study->plan.side > 0 ? "map" : study->plan.gaussian ? "gaussian" : "scan";
}

/** The solved mean from which a quantity follows; NULL: not solved. */
static const struct direct_mean *mean_of(const struct direct_study *study, enum direct_study_kind kind,
                                         enum quantity quantity, size_t i)
{
    const struct quantity_solved *solved = &quantity_rows[quantity].solved;
    const struct direct_study_curve *curve = &study->curves[kind];
    bool there = curve->points && i < curve->loads && solved->column;
    return there && (kind == DIRECT_STUDY_ELASTIC || !solved->elastic) ? &curve->points[i].mean[solved->mean] : NULL;
}

double direct_study_value(const struct direct_study *study, const struct material_pair *pair,
                          enum direct_study_kind kind, enum quantity quantity, size_t i, double *error)
{
    const struct quantity_solved *solved = &quantity_rows[quantity].solved;
    const struct direct_mean *mean = mean_of(study, kind, quantity, i);
    double factor = mean && solved->factor ? solved->factor(pair, mean->value) : 1;
    if (error)
        *error = mean ? mean->standard_error * factor : NAN;
    return mean ? mean->value * factor : NAN;
}

double direct_study_grid_error(const struct direct_study *study, enum direct_study_kind kind, enum quantity quantity,
                               size_t i)
{
    const struct direct_mean *mean = mean_of(study, kind, quantity, i);
    return mean && isfinite(mean->fine_ratio) ? fabs(mean->fine_ratio - 1) : 0;
}

enum direct_study_kind direct_study_kind_of(const struct direct_study *study, size_t model)
{
    return model_rows[model]->plastic && study->curves[DIRECT_STUDY_CAPPED].points ? DIRECT_STUDY_CAPPED
                                                                                   : DIRECT_STUDY_ELASTIC;
}

/** The model's point at load `i`; NULL: none. */
static const struct contact_point *point_at(const struct direct_study *study, size_t model, size_t i)
{
    const struct model_curve *curve = &study->models[model];
    for (size_t k = 0; curve->exists && k < curve->count; k++)
        if (curve->points[k].value[QUANTITY_LOAD] == study->plan.load[i])
            return &curve->points[k];
    return NULL;
}

double direct_study_ratio(const struct direct_study *study, const struct material_pair *pair, size_t model,
                          enum quantity quantity, size_t i)
{
    const struct contact_point *point = point_at(study, model, i);
    double direct = direct_study_value(study, pair, direct_study_kind_of(study, model), quantity, i, NULL);
    double value = point ? point->value[quantity] : NAN;
    return value > 0 && direct > 0 ? value / direct : NAN;
}

struct direct_study_distance direct_study_distance(const struct direct_study *study, const struct material_pair *pair,
                                                   size_t model, enum quantity quantity)
{
    struct direct_study_distance out = {0, NAN, INFINITY, -INFINITY};
    double sum = 0;
    for (size_t i = 0; i < study->plan.loads; i++) {
        double ratio = direct_study_ratio(study, pair, model, quantity, i);
        if (isnan(ratio))
            continue;
        sum += fabs(log(ratio));
        out.loads++;
        out.least = fmin(out.least, ratio);
        out.most = fmax(out.most, ratio);
    }
    if (out.loads > 0)
        out.mean_factor = exp(sum / (double)out.loads);
    return out;
}

size_t direct_study_nearest(const struct direct_study *study, const struct material_pair *pair, enum quantity quantity)
{
    size_t nearest = model_count, most = 0;
    double least = INFINITY;
    for (size_t m = 0; m < model_count; m++) /* a model that answers at few loads cannot be nearest */
        if (direct_study_kind_of(study, m) == DIRECT_STUDY_ELASTIC) {
            size_t loads = direct_study_distance(study, pair, m, quantity).loads;
            most = loads > most ? loads : most;
        }
    for (size_t m = 0; m < model_count; m++) {
        struct direct_study_distance distance = direct_study_distance(study, pair, m, quantity);
        if (direct_study_kind_of(study, m) == DIRECT_STUDY_ELASTIC && 2 * distance.loads > most &&
            distance.mean_factor < least) {
            least = distance.mean_factor;
            nearest = m;
        }
    }
    return nearest;
}
