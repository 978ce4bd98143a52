#include "analysis/surface.h"

#include "analysis/gather.h"
#include "base/clock.h"
#include "contact/statistical.h"
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

/** Power law, statistical parameters, and what the end-to-end jump may have leaked into them. */
static void describe(struct surface_record *record, const struct scene *scene)
{
    struct surface_summary *summary = &record->summary;
    summary->harmonics = record->spectrum.count;
    summary->power_law = power_law_fit(&record->spectrum, scene->fit_band_m);
    struct status status = {0};
    summary->has_asperities = roughness_asperities(&summary->asperities, &summary->roughness, &status) == STATUS_OK;
    if (!summary->has_asperities)
        note_models_lost(summary, scene->models, status.message);

    const struct power_law *law = &summary->power_law;
    if (isnan(law->gamma)) {
        gather_note(summary, "no power law: %s",
                    law->harmonics < 3 ? "fewer than 3 harmonics lie in the fit band; widen fit_band_m"
                                       : "its alpha is beyond the range of numbers; are the units right?");
        return;
    }
    /* a jump J at the border of the record adds J/(pi n) to harmonic n, an f^-1 tail */
    double shortest = law->band_m[0], leak_m = summary->jump_m * shortest / (M_PI * summary->length_m);
    summary->jump_share = scene->window == SPECTRUM_WINDOW_HANN ? 0 : leak_m / power_law_amplitude(law, shortest);
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
static void estimate_beta(struct surface_record *record, size_t model)
{
    size_t counterpart = model_index(model_rows[model]->counterpart);
    if (counterpart == model_count || !record->curves[model].exists || !record->curves[counterpart].exists)
        return;
    const struct model_curve *low = &record->curves[model], *high = &record->curves[counterpart];
    double sigma_m = record->summary.asperities.sigma_m, sum = 0;
    size_t common = 0;
    for (size_t i = 0; i < low->count && i < high->count; i++)
        if (low->points[i].load == high->points[i].load) {
            sum += statistical_beta_multiscale(&low->points[i].separation_m, &high->points[i].separation_m, 1, sigma_m);
            common++;
        }
    record->summary.models[model].beta_multiscale = common > 0 ? sum / (double)common : NAN;
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
        .sinusoid_fit = scene->closure,
    };
}

bool surface_extends(const struct surface_summary *summary, const struct scene *scene)
{
    return !isnan(summary->power_law.gamma) && !(scene->effects_auto && summary->bound.converged);
}

/** Carries the fitted law on below the sampling limit (twice the spacing), where that can change anything. */
static void extend(struct surface_summary *summary, const struct scene *scene, const struct plan *plan)
{
    double started = clock_seconds();
    for (size_t m = 0; m < model_count; m++) {
        struct curve_summary *model = &summary->models[m];
        if (!model_rows[m]->stacks_scales || !model->exists || !surface_extends(summary, scene))
            continue;
        model->extension = convergence_extend(&summary->power_law, summary->length_m, 2 * summary->spacing_m,
                                              &plan->pair, model_rows[m]->plastic, scene->convergence.load);
        model->extended = true;
    }
    summary->times.convergence = clock_seconds() - started;
}

/** Every scan of the surface alone in one model. */
static enum status_code run_repeats(struct surface_record *record, size_t m, const struct model_task *task,
                                    struct status *status)
{
    struct curve_summary *model = &record->summary.models[m];
    if (record->repeat_count < 2)
        return STATUS_OK;
    record->band_count = task->load_count;
    record->bands[m] = calloc(task->load_count, sizeof *record->bands[m]);
    if (!record->bands[m])
        return status_memory(status);
    return repeats_model(&model->repeated_beta, &model->repeated_log_full_load, record->bands[m], record->repeats,
                         record->repeat_count, model_rows[m], task, &model->work, status);
}

static enum status_code run_model(struct surface_record *record, size_t m, const struct model_task *task,
                                  struct status *status)
{
    struct model_curve *curve = &record->curves[m];
    struct curve_summary *model = &record->summary.models[m];
    curve->points = calloc(task->load_count + 1, sizeof *curve->points);
    if (!curve->points)
        return status_memory(status);
    double started = clock_seconds();
    if (model_run(curve, model_rows[m], task, status) != STATUS_OK)
        return status->code;
    model->seconds = clock_seconds() - started;
    if (curve->exists)
        curve_summary_make(model, curve, model_rows[m], record->summary.asperities.sigma_m);
    else
        model->work = curve->work;
    if (curve->overflows)
        gather_note(&record->summary,
                    "no %s: its numbers leave what can be computed with; check the units, the material and the loads",
                    model_rows[m]->label);
    return run_repeats(record, m, task, status);
}

enum status_code surface_run_models(struct surface_record *record, const struct scene *scene, const struct plan *plan,
                                    const double *loads, size_t load_count, struct status *status)
{
    struct model_task task = surface_task(record, scene, plan, loads, load_count);
    record->curves = calloc(model_count, sizeof *record->curves);
    record->bands = calloc(model_count, sizeof *record->bands);
    if (!record->curves || !record->bands)
        return status_memory(status);
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(plan, m) && run_model(record, m, &task, status) != STATUS_OK)
            return status->code;
    for (size_t m = 0; m < model_count && plan_runs(plan, EFFECT_SEPARATION); m++)
        estimate_beta(record, m);
    if (plan_runs(plan, EFFECT_CONVERGENCE))
        extend(&record->summary, scene, plan);
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
    summary->models = calloc(model_count, sizeof *summary->models);
    if (!summary->models)
        return status_memory(status);
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
    return gather_describe_repeats(out, scene, status);
}

void surface_summary_free(struct surface_summary *summary)
{
    free(summary->refusal);
    free(summary->notes);
    free(summary->models);
    summary->refusal = summary->notes = NULL;
    summary->models = NULL;
}

void surface_record_free(struct surface_record *record, bool with_summary)
{
    spectrum_free(&record->spectrum);
    for (size_t m = 0; m < model_count; m++) {
        if (record->curves)
            free(record->curves[m].points);
        if (record->bands)
            free(record->bands[m]);
    }
    free(record->curves);
    free(record->bands);
    record->curves = NULL;
    record->bands = NULL;
    gather_free_repeats(record);
    if (with_summary)
        surface_summary_free(&record->summary);
}
