#include "results/surface.h"

#include "base/clock.h"
#include "contact/statistical.h"
#include "results/condense.h"
#include "results/gather.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Power law, statistical parameters, and what the end-to-end jump may have leaked into them. */
static void describe(struct surface_record *record, const struct scene *scene)
{
    struct surface_summary *summary = &record->summary;
    summary->harmonics = record->spectrum.count;
    summary->law = powerlaw_fit(&record->spectrum, scene->fit_band_m);
    struct status status = {0};
    summary->has_asperities = roughness_asperities(&summary->asperities, &summary->roughness, &status) == STATUS_OK;
    if (!summary->has_asperities && (scene->models & SCENE_MODEL_STATISTICAL))
        gather_note(summary, "no GW and JG: %s", status.message);

    const struct powerlaw *law = &summary->law;
    if (isnan(law->gamma)) {
        gather_note(summary, "no power law: %s",
                    law->harmonics < 3 ? "fewer than 3 harmonics lie in the fit band; widen fit_band_m"
                                       : "its alpha is beyond the range of numbers; are the units right?");
        return;
    }
    /* a jump J at the border of the record adds J/(pi n) to harmonic n, an f^-1 tail */
    double shortest = law->band_m[0], leak_m = summary->jump_m * shortest / (M_PI * summary->length_m);
    summary->jump_share = scene->window == SCENE_WINDOW_HANN ? 0 : leak_m / powerlaw_amplitude(law, shortest);
    if (summary->jump_share > 0.5)
        gather_note(
            summary,
            "the ends of the record differ by %.3g um; that jump alone leaks %s of the fitted amplitude at %.3g um, "
            "so gamma is drawn towards 1: try window: hann",
            summary->jump_m * 1e6, summary->jump_share > 1 ? "more than the whole" : "over half", shortest * 1e6);
    if (isfinite(law->knee_m))
        gather_note(summary,
                    "two slopes fit better than one: gamma %.2f above %.3g um, %.2f below; consider fit_band_m",
                    law->gamma_above, law->knee_m * 1e6, law->gamma_below);
    if (law->gamma < 1)
        gather_note(summary,
                    "gamma = %.2f is below 1: the elastic multiscale area depends on the shortest wavelength sampled",
                    law->gamma);
}

/** The second estimate of beta, against the multiscale model of the same material law. */
static void estimate_beta(struct surface_record *record, enum model_id statistical, enum model_id multiscale)
{
    const struct model_curve *low = &record->curves[statistical], *high = &record->curves[multiscale];
    if (!low->exists || !high->exists)
        return;
    double sigma_m = record->summary.asperities.sigma_m, sum = 0;
    size_t common = 0;
    for (size_t i = 0; i < low->count && i < high->count; i++)
        if (low->points[i].load == high->points[i].load) {
            sum += statistical_beta_multiscale(&low->points[i].separation_m, &high->points[i].separation_m, 1, sigma_m);
            common++;
        }
    record->summary.models[statistical].beta_multiscale = common > 0 ? sum / (double)common : NAN;
}

struct model_task surface_task(const struct surface_record *record, const struct scene *scene, const struct plan *plan,
                               const double *loads, size_t load_count)
{
    return (struct model_task){
        .spectrum = &record->spectrum,
        .asperities = record->summary.has_asperities ? &record->summary.asperities : NULL,
        .pair = &plan->pair,
        .loads = loads,
        .load_count = load_count,
        .wanted = plan->wanted,
        .tolerance = scene->tolerance,
        .closure = scene->closure,
    };
}

bool surface_extends(const struct surface_summary *summary, const struct scene *scene)
{
    return !isnan(summary->law.gamma) && !(scene->effects_auto && summary->bound.settled);
}

/** Carries the fitted law on below the sampling limit (twice the spacing), where that can change anything. */
static void extend(struct surface_summary *summary, const struct scene *scene, const struct plan *plan)
{
    double started = clock_seconds();
    for (int m = 0; m < MODEL_COUNT; m++) {
        struct surface_model *model = &summary->models[m];
        if (model_rows[m].family != SCENE_MODEL_MULTISCALE || !model->exists || !surface_extends(summary, scene))
            continue;
        model->extension = convergence_extend(&summary->law, summary->length_m, 2 * summary->spacing_m, &plan->pair,
                                              model_rows[m].plastic, scene->convergence.load);
        model->extended = true;
    }
    summary->times.convergence = clock_seconds() - started;
}

/** Every scan of the surface alone in one model. */
static enum status_code run_parts(struct surface_record *record, enum model_id model, const struct model_task *task,
                                  struct status *status)
{
    if (record->part_count < 2)
        return STATUS_OK;
    record->band_count = task->load_count;
    record->bands[model] = calloc(task->load_count, sizeof *record->bands[model]);
    if (!record->bands[model])
        return status_memory(status);
    return spread_model(&record->summary.spread, record->bands[model], record->parts, record->part_count, model, task,
                        &record->summary.models[model].work, status);
}

enum status_code surface_run_models(struct surface_record *record, const struct scene *scene, const struct plan *plan,
                                    const double *loads, size_t load_count, struct status *status)
{
    struct surface_summary *summary = &record->summary;
    struct model_task task = surface_task(record, scene, plan, loads, load_count);
    for (int m = 0; m < MODEL_COUNT; m++) {
        struct model_curve *curve = &record->curves[m];
        if (!model_called_for((enum model_id)m, plan->families, plan->running))
            continue;
        curve->points = calloc(load_count + 1, sizeof *curve->points);
        if (!curve->points)
            return status_memory(status);
        double started = clock_seconds();
        if (model_run(curve, (enum model_id)m, &task, status) != STATUS_OK)
            return status->code;
        summary->times.models[m] = clock_seconds() - started;
        if (curve->exists)
            condense_curve(&summary->models[m], curve, &model_rows[m], summary->asperities.sigma_m);
        else
            summary->models[m].work = curve->work;
        if (curve->overflows)
            gather_note(
                summary,
                "no %s: its numbers leave what can be computed with; check the units, the material and the loads",
                model_rows[m].label);
        if (run_parts(record, (enum model_id)m, &task, status) != STATUS_OK)
            return status->code;
    }
    if (plan_runs(plan, EFFECT_SEPARATION)) {
        estimate_beta(record, MODEL_GW, MODEL_MULTISCALE_ELASTIC);
        estimate_beta(record, MODEL_JG, MODEL_MULTISCALE_PLASTIC);
    }
    if (plan_runs(plan, EFFECT_CONVERGENCE))
        extend(summary, scene, plan);
    return STATUS_OK;
}

enum status_code surface_describe(struct surface_record *out, const struct scene *scene,
                                  const struct scene_surface *surface, const struct surface_record *counterface,
                                  struct status *status)
{
    struct surface_summary *summary = &out->summary;
    struct status problem = {0};
    struct hash hash = hash_start();
    summary->scene = surface;
    enum status_code rc = STATUS_OK;
    for (size_t f = 0; f < surface->file_count && rc == STATUS_OK; f++)
        rc = gather_file(out, scene, surface, surface->files[f], &hash, &problem);
    hash_finish(&hash, summary->hash);
    if (rc == STATUS_MEMORY)
        return status_memory(status);
    if (rc != STATUS_OK) {
        summary->refusal = strdup(problem.message);
        return summary->refusal ? STATUS_OK : status_memory(status);
    }
    summary->usable = true;
    if (counterface && gather_counterface(out, counterface, status) != STATUS_OK)
        return status->code;
    describe(out, scene);
    return gather_describe_parts(out, scene, status);
}

void surface_record_free(struct surface_record *record, bool with_texts)
{
    spectrum_free(&record->spectrum);
    for (int m = 0; m < MODEL_COUNT; m++)
        free(record->curves[m].points);
    for (int m = 0; m < MODEL_COUNT; m++)
        free(record->bands[m]);
    memset(record->curves, 0, sizeof record->curves);
    memset(record->bands, 0, sizeof record->bands);
    gather_free_parts(record);
    if (with_texts) {
        free(record->summary.refusal);
        free(record->summary.notes);
        record->summary.refusal = record->summary.notes = NULL;
    }
}
