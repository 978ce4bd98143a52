/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/all_surfaces.h"

#include "answers/answers.h"
#include "answers/direct_study.h"
#include "base/threads.h"
#include "members/surface_read.h"
#include "plan/effects.h"
#include "scene/scene_words.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Reads the rough counterface, if there is one. Without it no result would mean anything. */
static enum status_code read_counterface(struct all_surfaces *out, const struct scene *scene, struct status *status)
{
    if (scene->counterface_surface.files.count == 0)
        return STATUS_OK;
    out->counterface = calloc(1, sizeof *out->counterface);
    if (!out->counterface)
        return status_memory(status);
    if (surface_read(out->counterface, scene, &scene->counterface_surface, NULL, status) != STATUS_OK)
        return status->code;
    if (!out->counterface->summary.usable)
        return status_fail(status, STATUS_SCENE, "the counterface cannot be read: %s",
                           out->counterface->summary.refusal);
    out->results.counterface = out->counterface;
    return STATUS_OK;
}

/** Words for the direct solution: of how many surfaces, what is solved of one, and its expected time. */
static const char *say_direct(const struct plan *plan, const struct results *results, size_t surface, size_t surfaces)
{
    const struct surface_summary *summary = &results->surfaces[surface].summary;
    const struct direct_plan *first = summary->direct;
    const bool minutes = first->seconds >= 100;
    const char *of = first->side > 0
                         ? words_say(plan->words, "direct.map\n%s", first->mirrored ? "mirrored" : "")
                         : words_say(plan->words, "direct.surfaces\nseeds %zu\n%s\n%s", first->seeds,
                                     first->seeds == 1 ? "one_seed" : "", first->fine_times > 1 ? "finer" : "");
    const char *study = words_say(
        plan->words, "direct.study\ngrid %zu\nof %s\nloads %zu\n%s\ntime %.2g %s\n%s\n%s\nbudget %g",
        first->side > 0 ? first->side : first->grid, of, first->loads, first->loads == 1 ? "one_load" : "",
        minutes ? first->seconds / 60 : first->seconds, minutes ? "min" : "s", first->of_spacing ? "of_spacing" : "",
        first->over_budget ? "over_budget" : "", results->scene->direct.budget_s);
    return words_say(plan->words, "direct.planned\n%s\nsurfaces %zu\n%s\nstudy %s\nname\t%s",
                     plan_runs(plan, EFFECT_DIRECT) ? "called" : "", surfaces, surfaces == 1 ? "one_surface" : "",
                     study, summary->scene->name);
}

/** The direct solution's part of the plan. */
static void plan_direct(struct plan *plan, const struct results *results)
{
    const bool runs = plan_runs(plan, EFFECT_DIRECT);
    const struct direct_plan *none = results->surfaces[results->baseline].summary.direct;
    size_t surfaces = 0, first = 0;
    if (!none)
        return;
    for (size_t i = 0; i < results->surface_count; i++)
        if (results_solves(results, i))
            first = surfaces++ > 0 && i != results->baseline ? first : i;
    plan_decide(plan, EFFECT_DIRECT, runs && surfaces > 0,
                surfaces > 0 ? say_direct(plan, results, first, surfaces)
                             : words_say(plan->words, "direct.impossible\n%s\nwhy\t%s", runs ? "called" : "",
                                         direct_plan_problem(none, plan->words)));
}

/** The loads P/(A_n E') of every surface: one list for all, or one each if their moduli differ. */
static enum status_code make_loads(struct all_surfaces *out, const struct scene *scene, struct status *status)
{
    struct results *results = &out->results;
    results->loads_apart = scene->load.kind != UNIT_NUMBER && !scene_has_one_pair(scene, true);
    const size_t lists = results->loads_apart ? scene->surface_count : 1;
    size_t operating = 0;
    if (!(out->loads = calloc(lists * (scene->load.points + 1), sizeof *out->loads)))
        return status_memory(status);
    for (size_t i = 0; i < lists; i++) {
        const struct material_pair pair = scene_pair(&scene->surfaces[i].bodies);
        results->load_count = scene_loads(out->loads + i * results->load_count, &operating, scene, &pair);
    }
    out->plan.operating_place = operating + 1;
    results->loads = out->loads;
    return STATUS_OK;
}

void all_surfaces_tell(struct all_surfaces_stage *stage, const char *name, double work, double all)
{
    if (!stage->options->progress)
        return;
    pthread_mutex_lock(&stage->lock);
    stage->done += work;
    stage->options->progress(stage->stage, name, stage->done, all);
    pthread_mutex_unlock(&stage->lock);
}

/** The pass over all surfaces. */
struct pass {
    struct all_surfaces *prepared;
    struct curve_tables *tables; /* to which curves are written; NULL: they stay in memory */
    const struct plan *plan;     /* effects and models for all surfaces */
    bool bounded, describe_only; /* bounded: all are read, and effects decided, before any model runs */
    struct all_surfaces_stage stage;
};

/** What is asked of a surface; as many surfaces as possible run at once, and share the threads evenly. */
static struct surface_task task_of(const struct pass *all, size_t index)
{
    const struct results *results = &all->prepared->results;
    const struct threads *threads = &results->threads;
    struct surface_task out = results_task(results, index);
    out.plan = all->plan;
    out.threads = *threads;
    out.threads.jobs = (unsigned)(threads_number(threads, SIZE_MAX) / threads_number(threads, results->surface_count));
    return out;
}

/** Reads a surface, unless that is done. */
static enum status_code describe_one(void *context, size_t index, struct threads_turn *turn, struct status *status)
{
    const struct pass *all = context;
    const struct results *results = &all->prepared->results;
    struct surface_record *record = &results->surfaces[index];
    (void)turn;
    record->variants.left_out = all->describe_only;
    return record->summary.scene ? STATUS_OK
                                 : surface_read(record, results->scene, &results->scene->surfaces[index],
                                                all->prepared->counterface, status);
}

/** The same, and bounds what effects could change on it. */
static enum status_code bound_one(void *context, size_t index, struct threads_turn *turn, struct status *status)
{
    const struct pass *all = context;
    struct surface_record *record = &all->prepared->results.surfaces[index];
    const struct surface_task asked = task_of(all, index);
    enum status_code rc = describe_one(context, index, turn, status);
    if (rc == STATUS_OK && record->summary.usable)
        rc = effects_bound(record, &asked, status);
    return rc == STATUS_MEMORY ? surface_put_aside(record, asked.scene, status) : rc;
}

/** Runs the models on a surface that has been read, or only plans its direct solution. */
static enum status_code evaluate_one(const struct pass *all, size_t index, struct status *status)
{
    const struct scene *scene = all->prepared->results.scene;
    struct surface_record *record = &all->prepared->results.surfaces[index];
    const struct surface_task asked = task_of(all, index);
    if (!record->summary.usable)
        return STATUS_OK;
    enum status_code rc =
        all->describe_only ? direct_study_plan(record, &asked, status) : surface_answers_find(record, &asked, status);
    if (scene->measured.files.count == 0 && scene->surfaces[index].measured.files.count == 0)
        surface_drop_scans(record); /* else the models will run on them at the measured loads */
    return rc == STATUS_MEMORY ? surface_put_aside(record, scene, status) : rc;
}

static enum status_code run_one(void *context, size_t index, struct threads_turn *turn, struct status *status)
{
    struct pass *all = context;
    const struct results *results = &all->prepared->results;
    struct surface_record *record = &results->surfaces[index];
    enum status_code rc = all->bounded ? STATUS_OK : bound_one(context, index, turn, status);
    if (rc == STATUS_OK)
        rc = evaluate_one(all, index, status);
    if (rc == STATUS_OK && all->tables && record->summary.usable)
        rc = curve_tables_put(all->tables, record, turn, status);
    if (all->tables || all->describe_only)
        surface_drop_arrays(record);
    all_surfaces_tell(&all->stage, results->scene->surfaces[index].name, 1, (double)results->surface_count);
    return rc;
}

/** Finds the load nearest to the geometric middle of those at which A/A_n is 0.1 to 10 %, by the leading model or its
 * Gaussian part; if there are none, the load with A/A_n nearest to 1 %. */
static enum status_code middle_place(size_t *place, const struct surface_record *record,
                                     const struct surface_task *asked, struct status *status)
{
    const double least = 1e-3, most = 0.1, *loads = asked->loads;
    const struct model_row *row = model_rows[plan_leading_model(asked->plan)];
    size_t count = asked->load_count;
    struct model_task task = surface_model_task(record, asked);
    OWNED(memory_free) struct contact_point *points = calloc(count + 1, sizeof *points);
    struct model_curve curve = {.points = points};
    task.wanted &= QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA);
    if (!points)
        return status_memory(status);
    if (ensemble_curve(&curve, NULL, &record->ensemble, row->gaussian ? row->gaussian : row, &task, status) !=
        STATUS_OK)
        return status->code;
    double first = NAN, last = NAN, middle, nearest = INFINITY;
    for (size_t i = 0; curve.exists && i < curve.count; i++) {
        double area = curve.points[i].value[QUANTITY_AREA], load = curve.points[i].value[QUANTITY_LOAD];
        if (area < least || area > most)
            continue;
        first = isnan(first) ? load : first;
        last = load;
    }
    middle = sqrt(first) * sqrt(last);
    for (size_t i = 0; curve.exists && i < curve.count && i < count; i++) {
        double off = fabs(isnan(middle) ? log(curve.points[i].value[QUANTITY_AREA] / sqrt(least * most))
                                        : log(loads[i] / middle));
        if (off < nearest) {
            nearest = off;
            *place = i;
        }
    }
    return STATUS_OK;
}

/** The baseline, before any model runs: the scene's, the only one, or chosen by roughness among the first hundred. */
static enum status_code find_baseline(size_t *baseline, struct pass *all, struct status *status)
{
    enum { MOST = 100 };
    const struct scene *scene = all->prepared->results.scene;
    size_t count = scene->surface_count < MOST ? scene->surface_count : MOST;
    *baseline = 0;
    for (size_t i = 0; i < scene->surface_count && scene->baseline; i++)
        if (strcmp(scene->surfaces[i].name, scene->baseline) == 0)
            *baseline = i;
    if (scene->baseline || count == 1)
        return describe_one(all, *baseline, NULL, status);
    enum status_code rc = threads_run(&all->prepared->results.threads, count, describe_one, all, status);
    *baseline = results_second_smoothest(&all->prepared->results);
    return rc;
}

/** Chooses the operating load if the scene gives none. Surfaces read for this stay in memory. */
static enum status_code choose_operating_load(struct pass *all, struct status *status)
{
    size_t baseline, place = all->plan->operating_place - 1;
    if (find_baseline(&baseline, all, status) != STATUS_OK)
        return status->code;
    const struct surface_record *record = &all->prepared->results.surfaces[baseline];
    const struct surface_task asked = task_of(all, baseline);
    enum status_code rc = record->summary.usable ? middle_place(&place, record, &asked, status) : STATUS_OK;
    all->prepared->plan.operating_place = place + 1;
    return rc;
}

/** Reads and runs once more the surfaces that the report shows, as all arrays were freed. */
static enum status_code run_shown(struct pass *all, struct status *status)
{
    struct results *results = &all->prepared->results;
    for (size_t i = 0; i < results->surface_count; i++) {
        struct surface_record *record = &results->surfaces[i];
        bool shown = i == results->baseline || record->summary.scene->measured.files.count > 0;
        for (size_t k = 0; k < results->shown_count; k++)
            shown = shown || results->shown[k] == i;
        if (!record->summary.usable || !shown)
            continue;
        surface_record_free(record);
        if (describe_one(all, i, NULL, status) != STATUS_OK || evaluate_one(all, i, status) != STATUS_OK ||
            !record->summary.usable)
            return status_memory(status); /* it is already ranked, and cannot be refused any more */
    }
    return STATUS_OK;
}

/** Measurements of the baseline are given by the scene or by the surface, not both. */
static enum status_code check_both(const struct scene *scene, const struct scene_surface *surface,
                                   struct status *status)
{
    if (scene->measured.files.count == 0 || surface->measured.files.count == 0)
        return STATUS_OK;
    return status_fail(status, STATUS_SCENE,
                       "the baseline, '%s', has 'measured' of its own and the scene's; remove either",
                       scene_words_show(surface->name).text);
}

/** Reads the measurements of every surface, and behind them the scene's, before any model runs. */
static enum status_code read_measured(struct all_surfaces *out, struct status *status)
{
    const struct scene *scene = out->results.scene;
    const struct scene_measured *first = NULL;
    size_t before = 0;
    if (!(out->measured = calloc(scene->surface_count + 1, sizeof *out->measured)))
        return status_memory(status);
    for (size_t i = 0; i <= scene->surface_count; i++) {
        const bool own = i < scene->surface_count;
        const struct scene_measured *given = own ? &scene->surfaces[i].measured : &scene->measured;
        /* the modulus only scales loads: which surface has the scene's is not known yet */
        const struct material_pair any = {.effective_modulus_Pa = 1},
                                   pair = own ? scene_pair(&scene->surfaces[i].bodies) : any;
        out->measured[i] = (struct measured){.given = given, .before = before};
        if (given->files.count == 0)
            continue;
        if (measured_read(&out->measured[i], scene, &out->plan, &pair, status) != STATUS_OK)
            return status->code;
        if (own &&
            (scene->surface_count == 1 || (scene->baseline && strcmp(scene->baseline, scene->surfaces[i].name) == 0)) &&
            check_both(scene, &scene->surfaces[i], status) != STATUS_OK)
            return status->code;
        first = first ? first : given;
        if (first->quantity != given->quantity)
            return status_fail(status, STATUS_SCENE, "both ECR and TCR are measured; take out one of them");
        before += out->measured[i].count;
    }
    return STATUS_OK;
}

/** Gives the scene's measurements to the baseline, and drops those of surfaces that cannot be used. */
static enum status_code place_measured(struct all_surfaces *out, struct status *status)
{
    struct results *results = &out->results;
    const struct scene *scene = results->scene;
    struct measured *measured = &out->measured[results->baseline];
    if (scene->measured.files.count > 0) {
        if (check_both(scene, &scene->surfaces[results->baseline], status) != STATUS_OK)
            return status->code;
        measured->given = &scene->measured;
        if (measured_read(measured, scene, &out->plan, results_pair(results, results->baseline), status) != STATUS_OK)
            return status->code;
    }
    for (size_t i = 0; i < results->surface_count; i++) {
        if (!results->surfaces[i].summary.usable)
            measured_free(&out->measured[i]);
        if (out->measured[i].count > 0)
            results->measured = out->measured;
    }
    return STATUS_OK;
}

enum status_code all_surfaces_run(struct all_surfaces *out, const struct scene *scene,
                                  const struct run_options *options, bool describe_only, const char *curves,
                                  struct status *status)
{
    *out = (struct all_surfaces){.counterface = NULL};
    struct results *results = &out->results;
    *results = (struct results){.scene = scene,
                                .plan = &out->plan,
                                .surface_count = scene->surface_count,
                                .threads = {options->jobs, options->stop}};
    if (scene->surface_count == 0)
        return status_fail(status, STATUS_SCAN, "no scan in '%s': put the profilometer's files there",
                           scene->directory);
    if (!(results->surfaces = calloc(scene->surface_count, sizeof *results->surfaces)))
        return status_memory(status);
    if (words_read(&out->words, options->templates, status) == STATUS_OK)
        plan_make(&out->plan, scene, &out->words);
    if (status->code != STATUS_OK)
        return status->code;
    if (read_measured(out, status) != STATUS_OK || make_loads(out, scene, status) != STATUS_OK ||
        read_counterface(out, scene, status) != STATUS_OK)
        return status->code;
    struct pass all = {.prepared = out,
                       .plan = &out->plan,
                       .bounded = !scene_bins_spectra(scene),
                       .describe_only = describe_only,
                       .stage = {options, "models of", NULL, 0, PTHREAD_MUTEX_INITIALIZER}};
    all_surfaces_tell(&all.stage, scene->surfaces[0].name, 0, (double)scene->surface_count);
    if ((scene->operating.value == 0 && choose_operating_load(&all, status) != STATUS_OK) ||
        (all.bounded && threads_run(&results->threads, scene->surface_count, bound_one, &all, status) != STATUS_OK))
        return status->code;
    struct plan ran = out->plan;
    ran.words = NULL; /* words are for one thread */
    if (all.bounded)  /* an effect needed on one surface runs on all; with too many surfaces for memory, all allowed
                         effects run */
        effects_decide(&out->plan, scene, results->surfaces, results->surface_count);
    ran.running = out->plan.running;
    ran.wanted = out->plan.wanted;
    ran.beside = out->plan.beside;
    all.plan = &ran; /* each surface runs those of its models that can answer */
    if (curves && curve_tables_open(&all.tables, results, curves, status) != STATUS_OK)
        return curve_tables_close(all.tables, status);
    enum status_code rc = threads_run(&results->threads, scene->surface_count, run_one, &all, status);
    if (curve_tables_close(all.tables, status) != STATUS_OK)
        rc = status->code;
    if (all.bounded)
        effects_fit_models(&out->plan, results->surfaces, results->surface_count);
    else
        effects_decide(&out->plan, scene, results->surfaces, results->surface_count);
    if (rc == STATUS_OK)
        rc = results_rank(results, status);
    if (rc == STATUS_OK && results->usable_count == 0)
        rc = status_fail(status, STATUS_SCAN, "no usable surface in '%s'", scene->directory);
    if (rc == STATUS_OK && plan_running_models(&out->plan) == 0)
        rc = status_fail(status, STATUS_MODEL,
                         "no model is left for these scans and this material; name others in 'models', or leave the "
                         "line out");
    if (rc != STATUS_OK || (curves && run_shown(&all, status) != STATUS_OK))
        return status->code;
    plan_direct(&out->plan, results);
    for (size_t i = 0; i < results->surface_count && out->plan.beside; i++) {
        struct surface_record *record = &results->surfaces[i];
        const struct surface_task asked = results_task(results, i);
        const struct model_task task = surface_model_task(record, &asked);
        if (record->curves) /* on its own, a map was led by its direct solution */
            answers_check_limits(record, scene, &out->plan, &task);
    }
    (void)place_measured(out, status);
    return status->code; /* perhaps a missing word in words.txt */
}

void all_surfaces_free(struct all_surfaces *prepared)
{
    for (size_t i = 0; prepared->results.surfaces && i < prepared->results.surface_count; i++)
        surface_record_free(&prepared->results.surfaces[i]);
    free(prepared->results.surfaces);
    for (size_t i = 0; prepared->measured && i <= prepared->results.surface_count; i++)
        measured_free(&prepared->measured[i]);
    free(prepared->measured);
    if (prepared->counterface)
        surface_record_free(prepared->counterface);
    free(prepared->counterface);
    free(prepared->loads);
    free(prepared->results.by_roughness);
    words_free(&prepared->words);
    *prepared = (struct all_surfaces){0};
}
