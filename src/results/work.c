#include "results/work.h"

#include <math.h>

/** Typical times of one evaluation on one core [s], from the benchmark (cmake --workflow --preset bench). They are for
 * planning only; a report prints what it took. */
static const double scale_seconds = 20e-9, gap_seconds = 15e-9, spot_seconds = 8e-9, law_seconds = 120e-9,
                    separation_seconds = 8e-6, extension_seconds = 0.5e-3;

/** Work of the scans of a surface that are run alone. */
static struct model_work parts_work(const struct surface_summary *summary, enum model_id model,
                                    const struct model_task *task)
{
    size_t parts = summary->spread.parts;
    struct model_work work = model_rows[model].work(&model_rows[model], task);
    if (model_rows[model].family == SCENE_MODEL_MULTISCALE)
        return (struct model_work){
            .scales = parts * work.scales, .gaps = parts * work.gaps, .spots = parts * work.spots};
    bool scale_dependent = task->wanted & CONTACT_SCALE_DEPENDENT;
    return (struct model_work){
        .laws = summary->part_laws[model_rows[model].plastic][scale_dependent],
        .separations = summary->part_asperities * task->load_count,
    };
}

struct work work_predict(const struct spool *spool, const struct scene *scene, const struct plan *plan,
                         size_t load_count)
{
    struct work work = {0};
    for (size_t i = 0; i < spool->count; i++) {
        struct surface_record outline = {.summary = spool->summaries[i]}; /* a task's work needs no arrays */
        if (!outline.summary.usable)
            continue;
        outline.spectrum.count = outline.summary.harmonics;
        work.bounds += outline.summary.bound.visits;
        struct model_task task = surface_task(&outline, scene, plan, NULL, load_count);
        for (int m = 0; m < MODEL_COUNT; m++) {
            if (!model_called_for((enum model_id)m, plan->families, plan->running))
                continue;
            struct model_work more = model_rows[m].work(&model_rows[m], &task);
            model_work_add(&work.models[m], &more);
            more = parts_work(&outline.summary, (enum model_id)m, &task);
            model_work_add(&work.models[m], &more);
            work.extensions += model_rows[m].family == SCENE_MODEL_MULTISCALE && plan_runs(plan, EFFECT_CONVERGENCE) &&
                               surface_extends(&outline.summary, scene);
        }
    }
    if (plan_runs(plan, EFFECT_CONVERGENCE))
        for (int s = 0; s < CONVERGENCE_SWEEP_COUNT; s++)
            work.sweep_scales +=
                convergence_sweeps[s].count * scene->convergence.scales * (plan_runs(plan, EFFECT_PLASTICITY) ? 2 : 1);
    return work;
}

struct work work_done(const struct spool *spool, uint64_t sweep_scales)
{
    struct work work = {.sweep_scales = sweep_scales};
    for (size_t i = 0; i < spool->count; i++) {
        work.bounds += spool->summaries[i].bound.visits;
        for (int m = 0; m < MODEL_COUNT; m++) {
            model_work_add(&work.models[m], &spool->summaries[i].models[m].work);
            work.extensions += spool->summaries[i].models[m].extended;
        }
    }
    return work;
}

static double model_seconds(const struct model_work *work)
{
    return (double)work->scales * scale_seconds + (double)work->laws * law_seconds +
           (double)work->separations * separation_seconds;
}

static uint64_t model_evaluations(const struct model_work *work)
{
    return work->scales + work->laws + work->separations;
}

/** Evaluations of `effect`, and their likely seconds. */
static uint64_t share(const struct work *work, const struct plan *plan, enum effect effect, double *seconds)
{
    uint64_t gaps = 0, spots = 0, plastic = 0;
    double plastic_seconds = 0;
    for (int m = 0; m < MODEL_COUNT; m++) {
        gaps += work->models[m].gaps;
        spots += work->models[m].spots;
        if (model_rows[m].plastic) {
            plastic += model_evaluations(&work->models[m]);
            plastic_seconds += model_seconds(&work->models[m]);
        }
    }
    bool first_conductor =
        effect == EFFECT_ELECTRICAL || (effect == EFFECT_THERMAL && !plan_runs(plan, EFFECT_ELECTRICAL));
    *seconds = 0;
    switch (effect) {
    case EFFECT_PLASTICITY:
        *seconds = plastic_seconds;
        return plastic;
    case EFFECT_SEPARATION:
        *seconds = (double)gaps * gap_seconds;
        return gaps;
    case EFFECT_ELECTRICAL:
    case EFFECT_THERMAL:
        *seconds = first_conductor ? (double)spots * spot_seconds : 0;
        return first_conductor ? spots : 0;
    case EFFECT_SCALE_DEPENDENT: /* the decision; GW's laws at nodes: without it closed forms do */
        *seconds =
            (double)work->bounds * (scale_seconds + spot_seconds) + (double)work->models[MODEL_GW].laws * law_seconds;
        return work->bounds + work->models[MODEL_GW].laws;
    case EFFECT_CONVERGENCE:
        *seconds = (double)work->sweep_scales * scale_seconds + (double)work->extensions * extension_seconds;
        return work->sweep_scales + work->extensions;
    case EFFECT_COUNT:
        break;
    }
    return 0;
}

static const char *method_of(enum effect effect, const struct plan *plan)
{
    switch (effect) {
    case EFFECT_PLASTICITY:
        return plan->families == SCENE_MODEL_MULTISCALE ? "direct sum over scales"
                                                        : "JG: Gauss-Legendre panels split where its law changes";
    case EFFECT_SCALE_DEPENDENT:
        return plan->families & SCENE_MODEL_STATISTICAL ? "GW: Gauss-Legendre panels, since no closed form exists"
                                                        : "direct sum over scales";
    case EFFECT_CONVERGENCE:
        return "direct sum over scales";
    case EFFECT_THERMAL:
        return plan_runs(plan, EFFECT_ELECTRICAL) ? "the sums of electrical in other units, so nothing of its own"
                                                  : "in the same pass as the area";
    case EFFECT_SEPARATION:
    case EFFECT_ELECTRICAL:
        return "in the same pass as the area";
    case EFFECT_COUNT:
        break;
    }
    return "multiscale: direct sum over scales; GW: closed forms";
}

void work_table(struct work_row rows[WORK_ROWS], const struct work *work, const struct plan *plan)
{
    const struct model_work *elastic = &work->models[MODEL_MULTISCALE_ELASTIC], *gw = &work->models[MODEL_GW];
    uint64_t scale_dependent = gw->laws;
    rows[0] = (struct work_row){
        .name = "area",
        .runs = true,
        .reason = "every report has it",
        .method = method_of(EFFECT_COUNT, plan),
        .evaluations = model_evaluations(elastic) + model_evaluations(gw) - scale_dependent,
        .seconds = model_seconds(elastic) + model_seconds(gw) - (double)scale_dependent * law_seconds,
    };
    for (int e = 0; e < EFFECT_COUNT; e++) {
        struct work_row *row = &rows[e + 1];
        *row = (struct work_row){
            .name = effect_rows[e].name,
            .runs = plan->effects[e].runs,
            .reason = plan->effects[e].reason,
            .method = plan->effects[e].runs ? method_of((enum effect)e, plan) : "",
        };
        if (e == EFFECT_CONVERGENCE)
            row->bytes = (double)work->sweep_scales * sizeof(double);
        if (row->runs || e == EFFECT_SCALE_DEPENDENT) /* deciding against it takes some too */
            row->evaluations = share(work, plan, (enum effect)e, &row->seconds);
    }
}

double work_memory(const struct spool *spool, unsigned jobs)
{
    size_t most = 0;
    for (size_t i = 0; i < spool->count; i++)
        most = spool->summaries[i].points > most ? spool->summaries[i].points : most;
    double program = 11e6, a_point = 96; /* text and numbers of a scan, its profile, transform and spectrum [bytes] */
    double threads = fmin(jobs, (double)spool->count);
    return program + threads * ((double)most * a_point + 2 * sizeof(struct surface_record)) +
           (double)spool->count * sizeof(struct surface_summary);
}
