/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/run.h"

#include "answers/direct_study.h"
#include "base/clock.h"
#include "base/threads.h"
#include "chart/figures.h"
#include "chart/gnuplot.h"
#include "claims/claims.h"
#include "output/exchange.h"
#include "output/json.h"
#include "output/tables.h"
#include "report/report.h"
#include "report/view.h"
#include "results/asked.h"
#include "run/all_surfaces.h"
#include "run/messages.h"
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** A run in progress: what each stage hands to the next. */
struct run {
    const struct scene *scene;
    const struct run_options *options;
    double started;
    struct exchange output;
    struct all_surfaces prepared;
    struct results *results; /* of `prepared` */
    struct benchmark benchmark;
    struct measured_answers *answers; /* one a surface */
    struct comparison comparison;
    struct gnuplot gnuplot;
    json_t *claims, *headline, *view;
    double *sweeps;
    struct direct_study *direct; /* results->direct_count of them */
    size_t direct_lost;          /* surfaces whose direct solution ran out of memory */
};

/** The convergence study: every sweep, by every model that stacks scales. */
static enum status_code run_sweeps(struct run *run, struct status *status)
{
    struct results *results = run->results;
    const struct scene_convergence *study = &run->scene->convergence;
    results->convergence = run->sweeps = calloc(results_sweep_size(results), sizeof *run->sweeps);
    if (!run->sweeps)
        return status_memory(status);
    for (int s = 0; s < CONVERGENCE_SWEEP_COUNT; s++)
        for (size_t v = 0; v < convergence_sweeps[s].count; v++)
            for (size_t m = 0; m < model_count; m++) {
                if (!plan_runs_model(results->plan, m) || !model_rows[m]->stacks_scales)
                    continue;
                struct convergence_law law = {study->alpha, study->gamma, study->scan_length_m,
                                              results_sweep_load(results, m), study->scales};
                *(s == CONVERGENCE_ALPHA ? &law.alpha : &law.gamma) = convergence_sweeps[s].values[v];
                const double *area = results_sweep(results, (enum convergence_sweep)s, m, v);
                convergence_areas(run->sweeps + (area - results->convergence), &law,
                                  results_pair(results, results->baseline), model_rows[m]->plastic,
                                  &results->studies.sweep_scales);
            }
    return STATUS_OK;
}

static void add_times(struct run_times *times, const struct results *results)
{
    for (size_t i = 0; i < results->surface_count; i++) {
        const struct surface_summary *summary = &results->surfaces[i].summary;
        times->read += summary->times.read;
        times->prepare += summary->times.prepare;
        times->spectrum += summary->times.spectrum;
        times->strips += summary->times.strips;
        times->tiles += summary->times.tiles[0] + summary->times.tiles[1];
        times->convergence += summary->times.convergence;
        times->uncertainty += summary->times.uncertainty;
        for (size_t m = 0; m < model_count; m++)
            times->models[m] += surface_model(summary, m)->seconds;
    }
}

/** Runs the models at the loads measured on a surface, fits the factor to the leading model, and solves the targets
 * once more with it. */
static enum status_code run_measured_on(struct run *run, size_t surface, struct status *status)
{
    struct results *results = run->results;
    struct surface_record *record = &results->surfaces[surface];
    const struct measured *measured = &results->measured[surface];
    struct measured_answers *answers = &run->answers[surface];
    const struct surface_task asked = results_task(results, surface);
    const struct model_task task = surface_model_task(record, &asked);
    if (measured_answer(answers, measured, record, &asked, status) != STATUS_OK ||
        measured_fit(answers, measured, plan_leading_model(results->plan), status) != STATUS_OK)
        return status->code;
    record->summary.carried_model = plan_leading_model(results->plan);
    record->summary.carried_quantity = measured_quantity(measured, results->plan->running);
    const bool carries = measured->given->carry && answers->fit.count > 0;
    record->summary.carried = carries ? estimate_value(&answers->fit) : 0;
    if (carries && answers_find(record, results->scene, results->plan, &task, status) != STATUS_OK)
        return status->code;
    known_take_measured(results, surface);
    return STATUS_OK;
}

static enum status_code run_measured(struct run *run, struct status *status)
{
    struct results *results = run->results;
    if (!results->measured)
        return STATUS_OK;
    if (!(run->answers = calloc(results->surface_count, sizeof *run->answers)))
        return status_memory(status);
    results->answers = run->answers;
    for (size_t i = 0; i < results->surface_count; i++)
        if (results_measured(results, i) && run_measured_on(run, i, status) != STATUS_OK)
            return status->code;
    return STATUS_OK;
}

/** As direct_study_task.progress. */
static void add_progress(void *context, double work, double all)
{
    struct all_surfaces_stage *stage = context;
    all_surfaces_tell(stage, stage->name, work, all);
}

/** The direct solutions that the plan calls for, one surface after another, each on all threads. */
static enum status_code run_direct(struct run *run, struct status *status)
{
    struct results *results = run->results;
    run->direct = calloc(results->surface_count, sizeof *run->direct);
    if (!run->direct)
        return status_memory(status);
    for (size_t i = 0; i < results->surface_count; i++) {
        if (!results_solves(results, i))
            continue;
        struct surface_record *record = &results->surfaces[i];
        struct all_surfaces_stage stage = {run->options, "direct solution of", record->summary.scene->name, 0,
                                           PTHREAD_MUTEX_INITIALIZER};
        add_progress(&stage, 0, 1);
        const struct direct_study_task task = {
            .surface = record,
            .index = i,
            .asked = {.scene = results->scene, .plan = results->plan, .threads = results->threads},
            .progress = add_progress,
            .progress_context = &stage};
        struct direct_study *study = &run->direct[results->direct_count];
        struct status problem = {0};
        enum status_code rc = direct_study_run(study, &task, &problem);
        add_progress(&stage, 0, stage.done); /* all of it */
        if (rc == STATUS_MEMORY) {
            snprintf(problem.message, sizeof problem.message,
                     "out of memory on %zu x %zu points; take a smaller grid, or fewer threads (--jobs)",
                     record->summary.direct->grid, record->summary.direct->grid);
            note_add(&record->summary.notes, NULL, "note.no_direct\nwhy\t%s", problem.message);
            run->direct_lost++;
        }
        if (rc == STATUS_MEMORY || rc == STATUS_MODEL ||
            rc == STATUS_SCAN) { /* then there is no direct solution, but the models' curves stay */
            direct_study_free(study);
            direct_plan_give_up(record->summary.direct, problem.message);
        } else if (rc != STATUS_OK) {
            return status_fail(status, rc, "surface '%s', solved directly: %s", record->summary.scene->name,
                               problem.message);
        } else {
            results->studies.contacts += study->solutions;
            results->direct_count++;
            results->direct = run->direct;
        }
    }
    return STATUS_OK;
}

/** Solves the contact of a map for its picture and the table of spots, but where a filler holds the metals apart. */
static enum status_code look_at_map(void *context, size_t index, struct threads_turn *turn, struct status *status)
{
    const struct run *run = context;
    const struct results *results = run->results;
    struct surface_record *record = &results->surfaces[index];
    const struct material_pair *pair = &record->summary.pair;
    const double load = results_operating_load(results, index);
    const bool yields = plan_runs(results->plan, EFFECT_PLASTICITY) && pair->hardness_Pa > 0;
    const double hardness = yields ? pair->hardness_Pa / pair->effective_modulus_Pa : INFINITY;
    const struct joint_task joint = {&results->scene->joint, pair, .effects = results->plan->running};
    (void)turn;
    for (size_t m = 0; m < model_count; m++) {
        if (!model_rows[m]->uses_map || model_rows[m]->plastic != yields || !plan_runs_model(results->plan, m))
            continue;
        const struct contact_point at = comparison_middle(results, m, index);
        if (joint_is_held(&at, &joint))
            return STATUS_OK;
    }
    return record->tiles.transfer && load < hardness
               ? map_contact_find(&record->contact, &record->tiles, load, hardness, run->options->stop, status)
               : STATUS_OK;
}

/** Wall time since the last call. */
static double lap(double *last)
{
    double now = clock_seconds(), passed = now - *last;
    *last = now;
    return passed;
}

/** Scans, effects, models, studies. */
static enum status_code evaluate(struct run *run, struct run_outcome *out, struct status *status)
{
    const char *curves = scene_bins_spectra(run->scene) ? run->output.staging : NULL;
    struct results *results = run->results = &run->prepared.results;
    if (all_surfaces_run(&run->prepared, run->scene, run->options, false, curves, status) != STATUS_OK)
        return status->code;
    if (run_measured(run, status) != STATUS_OK)
        return status->code;
    double last = clock_seconds();
    if (plan_runs(results->plan, EFFECT_CONVERGENCE) && run_sweeps(run, status) != STATUS_OK)
        return status->code;
    out->times.convergence = results->studies.sweep_seconds = lap(&last);
    if (plan_runs(results->plan, EFFECT_DIRECT) && run_direct(run, status) != STATUS_OK)
        return status->code;
    if (threads_run(&results->threads, results->surface_count, look_at_map, run, status) != STATUS_OK)
        return status->code;
    out->times.direct = results->studies.contact_seconds = lap(&last);
    out->evaluations = work_table(&out->work, results, true);
    add_times(&out->times, results);
    return STATUS_OK;
}

static bool stopped(const struct run *run)
{
    return run->options->stop && *run->options->stop;
}

/** Starts gnuplot, once there is something to draw. */
static enum status_code begin_charts(struct run *run, struct status *status)
{
    OWNED(text_free) struct text directory = {0};
    text_add(&directory, "%s/figures", run->output.staging);
    return gnuplot_start(&run->gnuplot, text_string(&directory), status);
}

/** Writes the files of the report. gnuplot draws while costs are measured and tables written. */
static enum status_code write_all(struct run *run, struct run_outcome *out, struct status *status)
{
    const struct run_options *options = run->options;
    const char *staging = run->output.staging;
    struct figures_task drawing = {
        &run->gnuplot,        staging, options->templates, options->terminal_size, options->brief,
        &run->prepared.words, false};
    struct figures figures = {.count = 0};
    double last = clock_seconds();
    if (begin_charts(run, status) != STATUS_OK || figures_draw(&figures, run->results, &drawing, status) != STATUS_OK ||
        stopped(run))
        return status->code;
    out->times.figures = lap(&last);
    const struct results *results = run->results;
    const struct surface_task asked = results_task(results, results->baseline);
    run->results->benchmark = options->no_cost ? NULL : &run->benchmark;
    if (!options->no_cost &&
        benchmark_measure(&run->benchmark, &results->surfaces[results->baseline], &asked, status) != STATUS_OK)
        return status->code;
    out->times.cost = lap(&last);
    drawing.cost = true;
    if (figures_draw(&figures, run->results, &drawing, status) != STATUS_OK || stopped(run))
        return status->code;
    if (tables_write(run->results, staging, status) != STATUS_OK || stopped(run) ||
        comparison_make(&run->comparison, run->results, status) != STATUS_OK ||
        claims_make(&run->claims, run->results, &run->comparison, &run->prepared.words, status) != STATUS_OK ||
        claims_headline(&run->headline, run->results, &run->comparison, &run->prepared.words, status) != STATUS_OK ||
        json_write(run->results, &run->comparison, run->claims, staging, status) != STATUS_OK || stopped(run) ||
        view_make(&run->view, run->results, &run->comparison, run->headline, run->claims, &figures,
                  &run->prepared.words, status) != STATUS_OK)
        return status->code;
    out->times.tables = lap(&last);
    if (figures_finish(&out->charts, &figures, &drawing, status) != STATUS_OK)
        return status->code;
    out->times.gnuplot = lap(&last);
    OWNED(memory_free)
    char *own = !options->template && run->scene->template ? scene_file_path(run->scene, run->scene->template) : NULL;
    const struct report_options how = {options->templates, own ? own : options->template, options->brief};
    enum status_code rc = export_write(run->view, run->scene, options->templates, staging, status);
    rc = rc == STATUS_OK ? report_write(run->view, &how, staging, status) : rc;
    if (rc != STATUS_OK ||
        report_terminal(&out->table, "terminal", run->view, options->templates, false, status) != STATUS_OK)
        return status->code;
    out->missed = view_limits_of(&out->limits, run->results, &run->prepared.words, true);
    out->undecided = view_limits_of(&out->limits, run->results, &run->prepared.words, false);
    out->times.report = lap(&last);
    return stopped(run) ? status->code : status_lost ? status_memory(status) : exchange_commit(&run->output, status);
}

/** OUT as given, else out/<name of DIR>. */
static enum status_code begin_output(struct run *run, struct status *status)
{
    if (run->options->output)
        return exchange_begin(&run->output, run->options->output, status);
    OWNED(memory_free) char *real = realpath(run->scene->directory, NULL);
    if (!real)
        return status_fail(status, STATUS_IO, "cannot open '%s'", run->scene->directory);
    const char *name = strrchr(real, '/');
    OWNED(text_free) struct text target = {0};
    text_add(&target, "out/%s", name && name[1] ? name + 1 : "root");
    return exchange_begin(&run->output, text_string(&target), status);
}

enum status_code run_report(struct run_outcome *out, const struct scene *scene, const struct run_options *options,
                            struct status *status)
{
    struct run run = {.scene = scene, .options = options, .started = clock_seconds(), .gnuplot.input = -1};
    char gnuplot[GNUPLOT_PATH]; /* looked for before any work is done */
    *out = (struct run_outcome){.path = NULL};
    if (export_check(scene, options->templates, status) == STATUS_OK && begin_output(&run, status) == STATUS_OK &&
        gnuplot_find(gnuplot, status) == STATUS_OK && evaluate(&run, out, status) == STATUS_OK && !stopped(&run))
        (void)write_all(&run, out, status);
    enum status_code rc = status->code;
    if (run.output.staging[0] && (stopped(&run) || rc == STATUS_INTERRUPTED)) {
        *status = (struct status){0}; /* replaces other errors: Ctrl-C also stops gnuplot, perhaps first */
        rc =
            status_fail(status, STATUS_INTERRUPTED, "stopped by a signal; '%s' is as it was before", run.output.target);
    }
    if (rc != STATUS_OK && rc != STATUS_INTERRUPTED && status_lost) /* then any other error follows from that */
        rc = (*status = (struct status){0}, status_memory(status));
    if (rc == STATUS_OK && asprintf(&out->path, "%s/report.html", run.output.target) < 0)
        rc = status_memory(status);
    out->refused = messages_add(&out->messages, &out->left_out, &run.prepared.results, rc == STATUS_OK);
    out->left_out += run.direct_lost;
    if (options->outline && rc == STATUS_OK)
        out->outline = json_outline(run.results);
    for (size_t k = 0; k < run.prepared.results.direct_count; k++)
        direct_study_free(&run.direct[k]);
    free(run.direct);
    for (size_t i = 0; run.answers && i < run.prepared.results.surface_count; i++)
        measured_answers_free(&run.answers[i]);
    free(run.answers);
    all_surfaces_free(&run.prepared);
    (void)gnuplot_end(&run.gnuplot); /* before its directory goes: it still draws there */
    exchange_abandon(&run.output);
    free(run.sweeps);
    comparison_free(&run.comparison);
    json_decref(run.view);
    json_decref(run.claims);
    json_decref(run.headline);
    out->times.total = clock_seconds() - run.started;
    return rc;
}

void run_outcome_free(struct run_outcome *outcome)
{
    text_free(&outcome->messages);
    text_free(&outcome->table);
    text_free(&outcome->limits);
    text_free(&outcome->charts);
    text_free(&outcome->work);
    json_decref(outcome->outline);
    free(outcome->path);
}
