/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/prepare.h"

#include "analysis/describe.h"
#include "analysis/direct_study.h"
#include "analysis/evaluate.h"
#include "base/threads.h"
#include "scene/scene_words.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SHOWN_MOST = 8 };

/** Reads the rough counterface, if the scene has one. It must be readable: no result would mean anything without it. */
static enum status_code read_counterface(struct prepared *out, const struct scene *scene, struct status *status)
{
    if (scene->counterface_surface.file_count == 0)
        return STATUS_OK;
    out->counterface = calloc(1, sizeof *out->counterface);
    if (!out->counterface)
        return status_memory(status);
    if (describe_surface(out->counterface, scene, &scene->counterface_surface, NULL, status) != STATUS_OK)
        return status->code;
    if (!out->counterface->summary.usable)
        return status_fail(status, STATUS_SCENE, "the counterface cannot be read: %s",
                           out->counterface->summary.refusal);
    out->results.counterface = out->counterface;
    return STATUS_OK;
}

static int compare_roughness(const void *a, const void *b, void *context)
{
    const struct surface_record *surfaces = context;
    size_t i = *(const size_t *)a, j = *(const size_t *)b;
    double x = surfaces[i].summary.roughness.rq_m, y = surfaces[j].summary.roughness.rq_m;
    return x < y ? -1 : x > y ? 1 : i < j ? -1 : 1;
}

/** The number that surfaces are compared by where the summary stands, less is better; infinite: none. */
static double answer_of(const struct results *results, size_t surface)
{
    enum quantity criterion = results_criterion(results);
    const struct curve_summary *leading =
        surface_model(&results->surfaces[surface].summary, plan_leading_model(results->plan));
    double value = leading->exists ? leading->operating.value[criterion] : NAN;
    return isnan(value) ? INFINITY : (quantity_rows[criterion].is & QUANTITY_RISES) ? -value : value;
}

static int compare_answers(const void *a, const void *b, void *context)
{
    const struct results *results = context;
    double x = answer_of(results, *(const size_t *)a), y = answer_of(results, *(const size_t *)b);
    return x < y ? -1 : x > y ? 1 : compare_roughness(a, b, results->surfaces);
}

/** Of too many surfaces the best, the worst, the baseline and others evenly between are shown, in that order. */
static void choose_shown(struct results *results, size_t *order, size_t usable)
{
    qsort_r(order, usable, sizeof *order, compare_answers, results);
    for (size_t k = 0; k < SHOWN_MOST; k++)
        results->shown[k] = order[k * (usable - 1) / (SHOWN_MOST - 1)];
    for (size_t i = 1; i + 1 < usable; i++)
        if (order[i] == results->baseline) {
            size_t k = (i * (SHOWN_MOST - 1) + (usable - 1) / 2) / (usable - 1);
            results->shown[k < 1 ? 1 : k > SHOWN_MOST - 2 ? SHOWN_MOST - 2 : k] = results->baseline;
        }
}

/** The smoothest but one of the usable surfaces that are described; 0: there is none. */
static size_t second_smoothest(const struct results *results)
{
    size_t first = 0, second = 0, found = 0;
    for (size_t i = 0; i < results->surface_count; i++) {
        if (!results->surfaces[i].summary.usable)
            continue;
        bool smoother = found == 0 || compare_roughness(&i, &first, results->surfaces) < 0;
        if (smoother || found == 1 || compare_roughness(&i, &second, results->surfaces) < 0)
            second = smoother && found > 0 ? first : i;
        first = smoother ? i : first;
        found++;
    }
    return second;
}

/** Ranks the usable surfaces and chooses which the charts show and which is the baseline. */
static enum status_code rank_surfaces(struct results *results, struct status *status)
{
    const char *baseline = results->scene->baseline;
    size_t usable = 0, *order = malloc((results->surface_count + SHOWN_MOST) * sizeof *order);
    if (!order)
        return status_memory(status);
    for (size_t i = 0; i < results->surface_count; i++)
        if (results->surfaces[i].summary.usable)
            order[usable++] = i;
    results->by_roughness = order;
    results->usable_count = usable;
    if (usable == 0)
        return STATUS_OK;
    results->shown = order + results->surface_count;
    results->shown_count = usable < SHOWN_MOST ? usable : SHOWN_MOST;
    memcpy(results->shown, order, results->shown_count * sizeof *order);
    results->baseline = second_smoothest(results);
    for (size_t i = 0; baseline && i < usable; i++)
        if (strcmp(results->surfaces[order[i]].summary.scene->name, baseline) == 0)
            results->baseline = order[i];
    if (usable > SHOWN_MOST)
        choose_shown(results, order, usable);
    qsort_r(order, usable, sizeof *order, compare_roughness, results->surfaces);
    return STATUS_OK;
}

bool prepare_solves(const struct results *results, size_t index)
{
    const struct surface_summary *summary = &results->surfaces[index].summary;
    bool called = results->scene->direct.surfaces == SCENE_DIRECT_ALL || index == results->baseline;
    return called && summary->usable && summary->direct && summary->direct->possible;
}

/** "256 x 256 points, 12 surfaces, 13 loads, about 5.2 s of one core". */
static void describe_direct(struct text *out, const struct direct_plan *plan)
{
    text_add(out, "%zu x %zu points, ", plan->grid, plan->grid);
    if (plan->side > 0)
        text_add(out, plan->mirrored ? "the map mirrored, " : "the map, ");
    else
        text_add(out, "%zu surface%s%s, ", plan->seeds, plan->seeds == 1 ? "" : "s",
                 plan->fine_times > 1 ? " and a finer grid" : "");
    text_add(out, "%zu load%s, about ", plan->loads, plan->loads == 1 ? "" : "s");
    text_add(out, plan->seconds < 100 ? "%.2g s" : "%.2g min",
             plan->seconds < 100 ? plan->seconds : plan->seconds / 60);
    text_add(out, " of one core");
    if (plan->of_spacing) /* else the scene says what the surface is */
        text_add(out, ", down to waves of four spacings, for want of a lambda_s: true at this resolution");
}

/** The direct solution's part of the plan: what it is of, and costs, or in `plan` would. */
static void plan_direct(struct plan *plan, const struct results *results)
{
    struct plan_effect *effect = &plan->effects[EFFECT_DIRECT];
    const struct direct_plan *first = NULL, *none = results->surfaces[results->baseline].summary.direct;
    double budget_s = results->scene->direct.budget_s;
    struct text reason = {0};
    size_t surfaces = 0;
    if (results->usable_count == 0 || !none)
        return;
    for (size_t i = 0; i < results->surface_count; i++) {
        if (!prepare_solves(results, i))
            continue;
        first = first && i != results->baseline ? first : results->surfaces[i].summary.direct;
        surfaces++;
    }
    if (!first) {
        text_add(&reason, effect->runs ? "called for, but %s" : "not called for; %s", none->problem);
    } else {
        text_add(&reason, "%s on %zu surface%s: ",
                 effect->runs ? "called for" : "not called for; `roughcontact direct` solves it", surfaces,
                 surfaces == 1 ? "" : "s");
        describe_direct(&reason, first);
        if (first->over_budget)
            text_add(&reason, ", more than the budget of %g s, which nothing fits", budget_s);
    }
    snprintf(effect->reason, sizeof effect->reason, "%s", text_string(&reason));
    text_free(&reason);
}

/** The loads of every surface: the same list, or each its own of as many. */
static enum status_code make_loads(struct prepared *out, const struct scene *scene, struct status *status)
{
    struct results *results = &out->results;
    double modulus_Pa = scene_pair(&scene->surfaces[0].bodies).effective_modulus_Pa;
    for (size_t i = 1; i < scene->surface_count && scene->load.kind != UNIT_NUMBER; i++)
        results->loads_apart |= scene_pair(&scene->surfaces[i].bodies).effective_modulus_Pa != modulus_Pa;
    for (size_t i = 0; i < (results->loads_apart ? scene->surface_count : 1); i++) {
        struct material_pair pair = scene_pair(&scene->surfaces[i].bodies);
        size_t count, operating;
        double *own;
        if (scene_loads(&own, &count, &operating, scene, &pair, status) != STATUS_OK)
            return status->code;
        double *all = reallocarray(out->loads, (i + 1) * count, sizeof *all);
        if (all)
            memcpy((out->loads = all) + i * count, own, count * sizeof *own);
        free(own);
        if (!all)
            return status_memory(status);
        if (i == 0)
            out->plan.operating_place = operating + 1;
        results->load_count = count;
    }
    results->loads = out->loads;
    return STATUS_OK;
}

void prepare_tell(struct prepare_stage *stage, const char *name, double work, double all)
{
    if (!stage->options->progress)
        return;
    pthread_mutex_lock(&stage->lock);
    stage->done += work;
    stage->options->progress(stage->stage, name, stage->done, all);
    pthread_mutex_unlock(&stage->lock);
}

/** All surfaces. */
struct surfaces {
    struct prepared *prepared;
    struct curve_tables *tables; /* that curves go to; NULL: none */
    const struct plan *plan;     /* of the effects that all run */
    bool bounded, describe_only; /* all are described, and their effects decided, before any model runs */
    struct prepare_stage stage;
};

static struct surface_task task_of(const struct surfaces *all, size_t index)
{
    struct surface_task out = results_task(&all->prepared->results, index);
    out.plan = all->plan;
    out.stop = all->stage.options->stop;
    return out;
}

/** Describes a surface, unless it is. */
static enum status_code describe_one(void *context, size_t index, struct threads_turn *turn, struct status *status)
{
    const struct surfaces *all = context;
    const struct results *results = &all->prepared->results;
    struct surface_record *record = &results->surfaces[index];
    (void)turn;
    return record->summary.scene ? STATUS_OK
                                 : describe_surface(record, results->scene, &results->scene->surfaces[index],
                                                    all->prepared->counterface, status);
}

/** And finds what effects could change on it. */
static enum status_code bound_one(void *context, size_t index, struct threads_turn *turn, struct status *status)
{
    const struct surfaces *all = context;
    struct surface_record *record = &all->prepared->results.surfaces[index];
    const struct surface_task asked = task_of(all, index);
    enum status_code rc = describe_one(context, index, turn, status);
    if (rc == STATUS_OK && record->summary.usable)
        rc = effects_bound(record, &asked, status);
    return rc == STATUS_MEMORY ? surface_put_aside(record, asked.scene, status) : rc;
}

/** The models of a described surface, or the plan alone. */
static enum status_code evaluate_one(const struct surfaces *all, size_t index, struct status *status)
{
    const struct scene *scene = all->prepared->results.scene;
    struct surface_record *record = &all->prepared->results.surfaces[index];
    const struct surface_task asked = task_of(all, index);
    if (!record->summary.usable)
        return STATUS_OK;
    enum status_code rc =
        all->describe_only ? direct_study_plan(record, &asked, status) : evaluate_surface(record, &asked, status);
    if (scene->measured.file_count == 0 && scene->surfaces[index].measured.file_count == 0)
        surface_drop_scans(record); /* else measured loads will be answered on each */
    return rc == STATUS_MEMORY ? surface_put_aside(record, scene, status) : rc;
}

static enum status_code run_one(void *context, size_t index, struct threads_turn *turn, struct status *status)
{
    struct surfaces *all = context;
    const struct results *results = &all->prepared->results;
    struct surface_record *record = &results->surfaces[index];
    enum status_code rc = all->bounded ? STATUS_OK : bound_one(context, index, turn, status);
    if (rc == STATUS_OK)
        rc = evaluate_one(all, index, status);
    if (rc == STATUS_OK && all->tables && record->summary.usable)
        rc = curve_tables_put(all->tables, record, turn, status);
    if (all->tables || all->describe_only)
        surface_drop_arrays(record);
    prepare_tell(&all->stage, results->scene->surfaces[index].name, 1, (double)results->surface_count);
    return rc;
}

/** The place among the loads next to the geometric middle of those at which A/A_n is 0.1 to 10 % on a surface, by the
 * leading model, or what it has of Gaussian heights; the load nearest to 1 % where none is between. */
static enum status_code middle_place(size_t *place, const struct surface_record *record,
                                     const struct surface_task *asked, struct status *status)
{
    const double least = 1e-3, most = 0.1, *loads = asked->loads;
    const struct model_row *row = model_rows[plan_leading_model(asked->plan)];
    size_t count = asked->load_count;
    struct model_task task = surface_model_task(record, asked);
    struct model_curve curve = {.points = calloc(count + 1, sizeof *curve.points)};
    enum status_code rc = curve.points ? STATUS_OK : status_memory(status);
    task.wanted &= QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA);
    if (rc == STATUS_OK)
        rc = ensemble_curve(&curve, NULL, &record->ensemble, row->gaussian ? row->gaussian : row, &task, status);
    double first = NAN, last = NAN, middle, nearest = INFINITY;
    for (size_t i = 0; rc == STATUS_OK && curve.exists && i < curve.count; i++) {
        double area = curve.points[i].value[QUANTITY_AREA], load = curve.points[i].value[QUANTITY_LOAD];
        if (area < least || area > most)
            continue;
        first = isnan(first) ? load : first;
        last = load;
    }
    middle = sqrt(first) * sqrt(last);
    for (size_t i = 0; rc == STATUS_OK && curve.exists && i < curve.count && i < count; i++) {
        double off = fabs(isnan(middle) ? log(curve.points[i].value[QUANTITY_AREA] / sqrt(least * most))
                                        : log(loads[i] / middle));
        if (off < nearest) {
            nearest = off;
            *place = i;
        }
    }
    free(curve.points);
    return rc;
}

/** The baseline, before any model runs: the scene's, the only one, or by roughness. Of more surfaces than that it is
 * sought among the first hundred. */
static enum status_code find_baseline(size_t *baseline, struct surfaces *all, const struct threads *threads,
                                      struct status *status)
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
    enum status_code rc = threads_run(threads, count, describe_one, all, status);
    *baseline = second_smoothest(&all->prepared->results);
    return rc;
}

/** Where the summary stands if the scene does not say. What is described for it stays so. */
static enum status_code choose_operating_load(struct surfaces *all, const struct threads *threads,
                                              struct status *status)
{
    size_t baseline, place = all->plan->operating_place - 1;
    if (find_baseline(&baseline, all, threads, status) != STATUS_OK)
        return status->code;
    const struct surface_record *record = &all->prepared->results.surfaces[baseline];
    const struct surface_task asked = task_of(all, baseline);
    enum status_code rc = record->summary.usable ? middle_place(&place, record, &asked, status) : STATUS_OK;
    all->prepared->plan.operating_place = place + 1;
    return rc;
}

/** Describes and runs once more the surfaces that the report shows, as all arrays have gone. */
static enum status_code run_shown(struct surfaces *all, struct status *status)
{
    struct results *results = &all->prepared->results;
    for (size_t i = 0; i < results->surface_count; i++) {
        struct surface_record *record = &results->surfaces[i];
        bool shown = i == results->baseline || record->summary.scene->measured.file_count > 0;
        for (size_t k = 0; k < results->shown_count; k++)
            shown = shown || results->shown[k] == i;
        if (!record->summary.usable || !shown)
            continue;
        surface_record_free(record);
        if (describe_one(all, i, NULL, status) != STATUS_OK || evaluate_one(all, i, status) != STATUS_OK ||
            !record->summary.usable)
            return status_memory(status); /* it is ranked by now, and cannot go aside */
    }
    return STATUS_OK;
}

/** What was measured, on usable surfaces: on the baseline what the scene says, on others what is said of them. */
static enum status_code read_measured(struct prepared *out, struct status *status)
{
    struct results *results = &out->results;
    const struct scene *scene = results->scene;
    size_t before = 0;
    for (size_t k = 0; k < results->usable_count; k++) {
        size_t i = results->by_roughness[k];
        const struct scene_surface *surface = &scene->surfaces[i];
        bool both = i == results->baseline && scene->measured.file_count > 0;
        const struct scene_measured *given = both ? &scene->measured : &surface->measured;
        if (both && surface->measured.file_count > 0)
            return status_fail(status, STATUS_SCENE,
                               "the baseline, '%s', has 'measured' of its own and the scene's; remove either",
                               scene_words_show(surface->name).text);
        if (given->file_count == 0)
            continue;
        if (!out->measured && !(out->measured = calloc(results->surface_count, sizeof *out->measured)))
            return status_memory(status);
        results->measured = out->measured;
        if (measured_read(&out->measured[i], given, before, scene, &out->plan, results_pair(results, i), status) !=
            STATUS_OK)
            return status->code;
        before += out->measured[i].count;
        if (measured_quantity(&out->measured[i], out->plan.running) != results_measured_quantity(results))
            return status_fail(status, STATUS_SCENE, "both ECR and TCR are measured; take out one of them");
    }
    return STATUS_OK;
}

enum status_code prepare(struct prepared *out, const struct scene *scene, const struct run_options *options,
                         bool describe_only, const char *curves, struct status *status)
{
    *out = (struct prepared){.counterface = NULL};
    plan_make(&out->plan, scene);
    struct results *results = &out->results;
    *results = (struct results){
        .scene = scene, .plan = &out->plan, .surface_count = scene->surface_count, .infinite = &out->infinite};
    if (scene->surface_count == 0)
        return status_fail(status, STATUS_SCAN, "no scan in '%s': put the profilometer's files there",
                           scene->directory);
    if (!(results->surfaces = calloc(scene->surface_count, sizeof *results->surfaces)))
        return status_memory(status);
    if (make_loads(out, scene, status) != STATUS_OK || read_counterface(out, scene, status) != STATUS_OK)
        return status->code;
    const struct threads threads = {.jobs = options->jobs, .stop = options->stop};
    struct surfaces all = {.prepared = out,
                           .plan = &out->plan,
                           .bounded = !scene_bins_spectra(scene),
                           .describe_only = describe_only,
                           .stage = {options, "models of", NULL, 0, PTHREAD_MUTEX_INITIALIZER}};
    prepare_tell(&all.stage, scene->surfaces[0].name, 0, (double)scene->surface_count);
    if ((scene->operating.load == 0 && choose_operating_load(&all, &threads, status) != STATUS_OK) ||
        (all.bounded && threads_run(&threads, scene->surface_count, bound_one, &all, status) != STATUS_OK))
        return status->code;
    if (all.bounded) /* what one surface calls for runs on all; of more than memory holds, all that is allowed */
        effects_decide(&out->plan, scene, results->surfaces, results->surface_count);
    if (curves && curve_tables_open(&all.tables, results, &out->plan, curves, status) != STATUS_OK)
        return curve_tables_close(all.tables, status);
    enum status_code rc = threads_run(&threads, scene->surface_count, run_one, &all, status);
    if (curve_tables_close(all.tables, status) != STATUS_OK)
        rc = status->code;
    const struct plan ran = out->plan;
    all.plan = &ran;
    if (!all.bounded)
        effects_decide(&out->plan, scene, results->surfaces, results->surface_count);
    effects_fit_models(&out->plan, results->surfaces, results->surface_count);
    all.tables = NULL;
    if (rc != STATUS_OK || rank_surfaces(results, status) != STATUS_OK ||
        (curves && !describe_only && run_shown(&all, status) != STATUS_OK))
        return status->code;
    plan_direct(&out->plan, results);
    for (size_t i = 0; i < results->surface_count && out->plan.beside; i++) {
        struct surface_record *record = &results->surfaces[i];
        const struct surface_task asked = results_task(results, i);
        const struct model_task task = surface_model_task(record, &asked);
        if (record->curves) /* alone, a map was led by its own solution */
            answers_check_limits(record, scene, &out->plan, &task);
    }
    return read_measured(out, status);
}

void prepared_free(struct prepared *prepared)
{
    for (size_t i = 0; prepared->results.surfaces && i < prepared->results.surface_count; i++)
        surface_record_free(&prepared->results.surfaces[i]);
    free(prepared->results.surfaces);
    for (size_t i = 0; prepared->measured && i < prepared->results.surface_count; i++)
        measured_free(&prepared->measured[i]);
    free(prepared->measured);
    if (prepared->counterface)
        surface_record_free(prepared->counterface);
    free(prepared->counterface);
    free(prepared->loads);
    free(prepared->results.by_roughness);
    *prepared = (struct prepared){0};
}

uint64_t prepare_table(struct text *out, const struct results *results, bool done)
{
    enum { WIDTH = 80, INDENT = 26 };
    uint64_t evaluations = 0;
    struct effects_row rows[EFFECTS_ROWS];
    effects_account(rows, results->plan, results->surfaces, results->surface_count, &results->studies);
    text_add(out, "%-16s %-8s%s  %s\n", "effect", "", done ? "  evaluations    seconds" : "", "why");
    for (int r = 0; r < EFFECTS_ROWS; r++) {
        text_add(out, "%-16s %-8s", rows[r].name, rows[r].runs ? "run" : "skipped");
        if (done)
            text_add(out, " %12llu %10.4f", (unsigned long long)rows[r].evaluations, rows[r].seconds);
        struct text why = {0};
        text_add_shown(&why, rows[r].reason); /* may name a surface */
        text_add(out, "  ");
        text_add_wrapped(out, text_string(&why), done ? 1 << 20 : WIDTH, INDENT);
        text_add(out, "\n");
        text_free(&why);
        evaluations += rows[r].evaluations;
    }
    return evaluations;
}

double prepare_rough_seconds(const struct results *results, const struct run_options *options)
{
    const struct threads threads = {.jobs = options->jobs};
    double direct = 0;
    for (size_t i = 0; i < results->surface_count && plan_runs(results->plan, EFFECT_DIRECT); i++)
        if (prepare_solves(results, i))
            direct += results->surfaces[i].summary.direct->seconds;
    return effects_rough_seconds(results->plan, results->surfaces, results->surface_count, results->load_count, direct,
                                 threads_number(&threads, SIZE_MAX));
}
