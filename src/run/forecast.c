/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/forecast.h"

#include "analysis/direct_study.h"
#include "chart/figure.h"
#include "output/cell.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

const char *const forecast_names[FORECAST_STAGES] = {
    [FORECAST_READ] = "read scans",
    [FORECAST_LEVEL] = "level",
    [FORECAST_SPECTRA] = "spectra",
    [FORECAST_MODELS] = "models",
    [FORECAST_CONVERGENCE] = "convergence",
    [FORECAST_UNCERTAINTY] = "uncertainty",
    [FORECAST_DIRECT] = "direct solution",
    [FORECAST_COST] = "what accuracy costs",
    [FORECAST_TABLES] = "tables and json",
    [FORECAST_CHART_DATA] = "chart data",
    [FORECAST_GNUPLOT] = "gnuplot",
    [FORECAST_PAGE] = "page",
    [FORECAST_OTHER] = "start, store, the rest",
};

/* Typical times [s] on a core whose printf() takes `usual_print` for a number, and on which the program writes one in
 * `usual_number`: read from `report --verbose` of surfaces/chapter6
 * with 121 and with 10 000 loads and of 1000 scans of 8000 points. All but the first scale with the machine. */
static const double usual_print = 0.33e-6, usual_number = 0.1e-6, process_seconds = 26e-3, drawn_seconds = 4.4e-3,
                    figure_seconds = 1.6e-3, page_seconds = 28e-3, page_figure_seconds = 2.6e-3,
                    surface_seconds = 0.06e-3, cost_seconds = 0.16, cost_load_seconds = 26e-6,
                    sweep_scale_seconds = 75e-9, start_seconds = 8e-3, stored_height_seconds = 20e-9,
                    kept_height_seconds = 500e-9;
/* Shares of a written number: of one in JSON, of a curve's point in the charts and on the page. */
static const double table_number = 1.6, json_number = 1.2, chart_number = 1.7, page_number = 0.5;
/* Of the rate on the synthetic spectrum, which has nothing warm and few loads to spread what is done once over. */
static const double model_share = 0.8;
/* Of the models' time: bounds aside, what is asked of them once their curves are there (sensitivity, nearest beta). */
static const double model_rest = 0.8;
/* How often the methods that the section on cost compares sort heights. */
static const double cost_sorts = 25;

enum { ROUNDS = 4, NUMBERS_ROUNDS = 60, NUMBERS = 100, HEIGHTS = 2048, HARMONICS = 128, FEW = 4, LOADS = 28 };

/** The least of some rounds' times. */
static double note(double best, double seconds)
{
    return seconds > 0 && seconds < best ? seconds : best;
}

static enum status_code measure_numbers(struct forecast_rates *out, double (*clock)(void), struct status *status)
{
    const struct cell_guard guard = {NULL, NULL};
    double best = INFINITY;
    for (int r = 0; r < NUMBERS_ROUNDS; r++) {
        struct text row = {0};
        double started = clock();
        for (int i = 0; i < NUMBERS; i++)
            cell_number(&row, &guard, "calibration", 1e-6 * (i + 1) / 3);
        best = note(best, clock() - started);
        bool failed = row.failed;
        text_free(&row);
        if (failed)
            return status_memory(status);
    }
    out->number = isfinite(best) ? best / NUMBERS : usual_number;
    return STATUS_OK;
}

/** This machine's speed at what the program itself has no part in: the system's formatting of numbers. */
static double measure_speed(double (*clock)(void))
{
    double best = INFINITY;
    for (int r = 0; r < NUMBERS_ROUNDS; r++) {
        char digits[32];
        double started = clock();
        for (int i = 0; i < NUMBERS; i++)
            snprintf(digits, sizeof digits, "%.17g", 1e-6 * (i + 1) / 3);
        best = note(best, clock() - started);
    }
    return isfinite(best) ? best / NUMBERS / usual_print : 1;
}

static double n_log_n(double n)
{
    return n > 1 ? n * log2(n) : 0;
}

/** Seconds to sort `heights`: beyond what caches hold, each step takes twice as long. */
static double sort_seconds(const struct forecast_rates *rates, double heights)
{
    static const double cached = 5e5;
    return rates->sort * n_log_n(heights) * (1 + heights / (heights + cached));
}

/** Heights and slopes like noise, the same in every run. */
static void make_heights(struct slope_point *point)
{
    uint32_t state = 1;
    for (size_t i = 0; i < HEIGHTS; i++) {
        state = state * 1664525u + 1013904223u;
        point[i] = (struct slope_point){1e-6 * ((double)state / 4294967296.0 - 0.5), 1e-3 + 1e-6 * (double)(i % 7)};
    }
}

/** The least time of some runs of model `m` on a task. */
static enum status_code time_model(double *seconds, size_t m, const struct model_task *task, double (*clock)(void),
                                   struct status *status)
{
    struct contact_point points[LOADS + 1];
    *seconds = INFINITY;
    for (int r = 0; r < ROUNDS; r++) {
        struct model_curve curve = {.points = points};
        double started = clock();
        if (model_run(&curve, model_rows[m], task, status) != STATUS_OK)
            return status->code;
        *seconds = note(*seconds, clock() - started);
    }
    return STATUS_OK;
}

/** What more loads take, over what work_seconds() says of them; 1: the clock does not tell. */
static enum status_code measure_model(double *rate, size_t m, const struct model_task *task, double (*clock)(void),
                                      struct status *status)
{
    const struct model_task few = model_task_at(task, task->loads + (LOADS - FEW) / 2, FEW);
    struct model_work more = model_rows[m]->work(model_rows[m], task), less = model_rows[m]->work(model_rows[m], &few);
    double long_s, short_s, weight = work_seconds(&more) - work_seconds(&less);
    if (time_model(&long_s, m, task, clock, status) != STATUS_OK ||
        time_model(&short_s, m, &few, clock, status) != STATUS_OK)
        return status->code;
    *rate = isfinite(long_s) && isfinite(short_s) && long_s > short_s && weight > 0 ? (long_s - short_s) / weight : 1;
    return STATUS_OK;
}

enum status_code forecast_calibrate(struct forecast_rates *out, const struct results *results, double (*clock)(void),
                                    struct status *status)
{
    *out = (struct forecast_rates){.speed = measure_speed(clock)};
    for (size_t m = 0; m < FORECAST_MODELS_MOST; m++)
        out->model[m] = 1;
    if (measure_numbers(out, clock, status) != STATUS_OK || results->usable_count == 0)
        return status->code;
    const struct surface_summary *baseline = &results->store->summaries[results->baseline];
    struct slope_point *point = malloc(HEIGHTS * sizeof *point);
    double *amplitude_m = malloc(HARMONICS * sizeof *amplitude_m), loads[LOADS];
    enum status_code rc = point && amplitude_m ? STATUS_OK : status_memory(status);
    if (rc == STATUS_OK) {
        make_heights(point);
        for (size_t n = 0; n < HARMONICS; n++)
            amplitude_m[n] = baseline->roughness.rq_m * 0.5 * pow((double)(n + 1), -1.5);
        for (size_t i = 0; i < LOADS; i++) { /* from the first to the last of the run */
            size_t last = results->load_count - 1;
            loads[i] = results_loads(results, results->baseline)[i * last / (LOADS - 1)] * (1 + 1e-9 * (double)i);
        }
        const struct spectrum spectrum = {amplitude_m, HARMONICS, baseline->length_m, false};
        struct surface_record outline = {.summary = *baseline, .spectrum = spectrum};
        outline.points = point;
        outline.summary.heights = HEIGHTS;
        const struct model_task task = surface_task(&outline, results->scene, results->plan, loads, LOADS);
        for (size_t m = 0; m < model_count && m < FORECAST_MODELS_MOST && rc == STATUS_OK; m++)
            if (plan_runs_model(results->plan, m) && !(model_rows[m]->asperity_model && !task.asperities))
                rc = measure_model(&out->model[m], m, &task, clock, status);
    }
    double best = INFINITY;
    for (int r = 0; r < ROUNDS && rc == STATUS_OK; r++) {
        struct contacting_slopes slopes;
        double started = clock();
        rc = contacting_slopes_make(&slopes, point, HEIGHTS, 1, NULL, status);
        best = note(best, clock() - started);
        if (rc == STATUS_OK)
            contacting_slopes_free(&slopes);
    }
    out->sort = isfinite(best) ? best / n_log_n(HEIGHTS) : 0;
    free(point);
    free(amplitude_m);
    return rc;
}

/** Figures that the run will draw, as far as the plan tells. */
static double count_figures(const struct results *results, bool no_cost)
{
    static const double sweeps;
    static const struct sensitivity_curves curves;
    struct benchmark_row rows[] = {{.chart = BENCHMARK_INTEGRALS}, {.chart = BENCHMARK_CURVES}};
    const struct benchmark cost = {.rows = rows, .count = 2};
    struct direct_study *direct = calloc(1, sizeof *direct);
    struct results outline = *results;
    struct figure_list list;
    struct status status = {0};
    double count = 0;
    outline.convergence = plan_runs(results->plan, EFFECT_CONVERGENCE) ? &sweeps : NULL;
    outline.sensitivity = &curves;
    outline.benchmark = no_cost ? NULL : &cost;
    if (direct && plan_runs(results->plan, EFFECT_DIRECT)) {
        direct->surface = results->baseline;
        outline.direct = direct;
        outline.direct_count = 1;
    }
    if (figure_list_make(&list, &outline, &status) == STATUS_OK) {
        count = (double)list.count;
        figure_list_free(&list);
    }
    free(direct);
    return count;
}

static double bits(unsigned set)
{
    return (double)__builtin_popcount(set);
}

/** Numbers of all curves as one table has them. */
static double count_numbers(const struct results *results)
{
    double numbers = 0;
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(results->plan, m))
            numbers += (double)results->usable_count * (double)results->load_count *
                       (2 + bits(quantity_with_made(model_rows[m]->quantities) & results->plan->wanted));
    return numbers;
}

static double threads_of(const struct results *results, const struct run_options *options)
{
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    double threads = options->jobs ? options->jobs : processors > 0 ? (double)processors : 1;
    threads = fmin(threads, processors > 0 ? (double)processors : 1);
    return fmax(1, fmin(threads, (double)results->store->count));
}

static void forecast_models(struct forecast *out, const struct results *results, const struct forecast_rates *rates)
{
    const struct plan *plan = results->plan;
    const struct work *work = &results->predicted;
    for (size_t i = 0; i < results->store->count; i++) {
        const struct surface_summary *summary = &results->store->summaries[i];
        for (size_t m = 0; m < model_count && summary->usable; m++) {
            if (!plan_runs_model(plan, m))
                continue;
            struct model_work of_model = work_of_model(summary, m, results->scene, plan);
            out->seconds[FORECAST_MODELS] += model_share * rates->model[m] * work_seconds(&of_model);
            if (model_rows[m]->uses_heights)
                out->seconds[FORECAST_MODELS] += sort_seconds(rates, (double)summary->heights);
        }
    }
    out->seconds[FORECAST_CONVERGENCE] = rates->speed * sweep_scale_seconds * (double)work->sweep_scales;
    work_uncertainty(&work->simulated, &out->seconds[FORECAST_UNCERTAINTY]);
    out->seconds[FORECAST_UNCERTAINTY] *= rates->speed;
    out->seconds[FORECAST_DIRECT] = rates->speed * work->contact_seconds;
}

struct forecast forecast_make(const struct results *results, const struct forecast_rates *rates,
                              const struct run_options *options)
{
    struct forecast out = {{0}, 0};
    const struct surface_store *store = results->store;
    double figures = options->brief ? 2 : count_figures(results, options->no_cost), numbers = count_numbers(results);
    double spectra = 0, most_heights = 0, heights = 0, described = 0, threads = threads_of(results, options);
    bool bins = scene_bins_spectra(results->scene); /* then the curves are not in results.json either */
    for (size_t i = 0; i < store->count; i++) {
        const struct surface_summary *summary = &store->summaries[i];
        out.seconds[FORECAST_READ] += summary->times.read;
        out.seconds[FORECAST_LEVEL] += summary->times.prepare;
        out.seconds[FORECAST_SPECTRA] += summary->times.spectrum;
        spectra += 3.5 * (bins ? 40 : (double)summary->harmonics); /* tenths of decades */
        most_heights = fmax(most_heights, (double)summary->heights);
        heights += (double)summary->heights;
        described += summary->times.described;
    }
    double shown = results->usable_count > 0 /* curves of some surfaces alone are drawn */
                       ? numbers * (double)results->shown_count / (double)results->usable_count
                       : 0;
    forecast_models(&out, results, rates);
    if (!options->no_cost)
        out.seconds[FORECAST_COST] = rates->speed * (cost_seconds + cost_load_seconds * (double)results->load_count) +
                                     cost_sorts * sort_seconds(rates, fmin(most_heights, 2e5));
    double sweeps = plan_runs(results->plan, EFFECT_CONVERGENCE) ? 16000 : 0; /* 150 scales of each sweep */
    out.seconds[FORECAST_TABLES] =
        rates->number * table_number * ((1 + (bins ? 0 : json_number)) * numbers + spectra + sweeps + NUMBERS);
    out.seconds[FORECAST_CHART_DATA] = rates->speed * figure_seconds * figures +
                                       rates->number * chart_number * shown + /* heights are sorted once more */
                                       sort_seconds(rates, most_heights);
    bool both = figures > 10 && options->jobs != 1;
    out.seconds[FORECAST_GNUPLOT] = rates->speed * (process_seconds + drawn_seconds * figures / (both ? 2 : 1));
    out.seconds[FORECAST_PAGE] =
        rates->speed * (page_seconds + page_figure_seconds * figures + surface_seconds * (double)store->count) +
        rates->number * page_number * shown;
    double stored = rates->speed * stored_height_seconds * heights; /* each later stage takes them from the store */
    out.seconds[FORECAST_CHART_DATA] += stored;
    out.seconds[FORECAST_PAGE] += stored;
    double read = out.seconds[FORECAST_READ] + out.seconds[FORECAST_LEVEL] + out.seconds[FORECAST_SPECTRA];
    out.seconds[FORECAST_OTHER] = rates->speed * (start_seconds + kept_height_seconds * heights) +
                                  model_rest * out.seconds[FORECAST_MODELS] + fmax(0, described - read);
    for (int s = FORECAST_MODELS; s < FORECAST_STAGES; s++)
        out.total +=
            out.seconds[s] /
            (s == FORECAST_MODELS || s == FORECAST_UNCERTAINTY || s == FORECAST_TABLES || s == FORECAST_OTHER ? threads
                                                                                                              : 1);
    out.total += fmin(described, read) / threads; /* parts of a large scan are read side by side */
    return out;
}

struct forecast forecast_of_times(const struct run_times *times)
{
    struct forecast out = {{0}, times->total};
    out.seconds[FORECAST_READ] = times->read;
    out.seconds[FORECAST_LEVEL] = times->prepare;
    out.seconds[FORECAST_SPECTRA] = times->spectrum;
    for (size_t m = 0; times->models && m < model_count; m++)
        out.seconds[FORECAST_MODELS] += times->models[m];
    out.seconds[FORECAST_CONVERGENCE] = times->convergence;
    out.seconds[FORECAST_UNCERTAINTY] = NAN; /* in the time of the models' threads */
    out.seconds[FORECAST_DIRECT] = NAN;      /* likewise */
    out.seconds[FORECAST_COST] = times->cost;
    out.seconds[FORECAST_TABLES] = times->tables;
    out.seconds[FORECAST_CHART_DATA] = times->figures;
    out.seconds[FORECAST_GNUPLOT] = times->gnuplot;
    out.seconds[FORECAST_PAGE] = times->report;
    out.seconds[FORECAST_OTHER] = NAN;
    return out;
}

void forecast_table(struct text *out, const struct forecast *likely, const struct forecast *took)
{
    text_add(out, "%-28s %10s%s\n", "stage", "seconds", took ? "      taken" : "");
    for (int s = 0; s <= FORECAST_STAGES; s++) {
        double actual = !took ? NAN : s < FORECAST_STAGES ? took->seconds[s] : took->total;
        text_add(out, "%-28s %10.4f", s < FORECAST_STAGES ? forecast_names[s] : "all, elapsed",
                 s < FORECAST_STAGES ? likely->seconds[s] : likely->total);
        if (!isnan(actual))
            text_add(out, " %10.4f", actual);
        text_add(out, "\n");
    }
}
