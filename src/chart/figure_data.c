/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "chart/figure_data.h"

#include "analysis/direct_study.h"
#include "contact/persson.h"
#include <errno.h>
#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Resistance goes to 0 with the last per cent of the area, over as many decades as a load happens to come close to full
 * contact: the axis ends where a curve's last point at or below this A/A_n stands. */
static const double nearly_full_area = 0.99;

static const struct figure_extent nothing = {INFINITY, -INFINITY};

/** Adds a row of the cells that follow. */
#define put(out, ...)                                                                                                  \
    drawing_add(&(out)->drawing, (const double[]){__VA_ARGS__}, sizeof(double[]){__VA_ARGS__} / sizeof(double))

static void reach(struct figure_extent *extent, double value)
{
    extent->low = fmin(extent->low, value);
    extent->high = fmax(extent->high, value);
}

/** One point, left out where a logarithmic axis cannot show it. Was it written? */
static bool put_point(struct figure_file *out, double x, double y, bool x_logarithmic, bool y_logarithmic)
{
    bool shown = isfinite(x) && isfinite(y) && (!x_logarithmic || x > 0) && (!y_logarithmic || y > 0);
    if (shown) {
        put(out, x, y);
        reach(&out->x, x);
        reach(&out->y, y);
    }
    return shown;
}

/** What a figure shows of a curve: a quantity, or (over) what it is over another one. */
struct shown {
    enum quantity y, over; /* over: QUANTITY_LOAD none */
    double sigma_m;
    const char *style, *legend;
};

static double value_shown(const struct contact_point *point, const struct shown *shown)
{
    double value = quantity_shown(point, shown->y, shown->sigma_m);
    return shown->over == QUANTITY_LOAD ? value : value / point->value[shown->over];
}

/** Points `from` to before `to` of a curve as one block. A resistance ends with the row of full contact, where it is 0.
 */
static void put_part(struct figure_file *out, const struct model_curve *curve, size_t from, size_t to,
                     const struct shown *shown, const char *style)
{
    enum quantity x = out->figure->row->x;
    double scale = x == QUANTITY_LOAD ? out->load_scale : 1;
    bool ratio = shown->over != QUANTITY_LOAD, logarithmic = quantity_rows[shown->y].logarithmic && !ratio;
    bool hides = strcmp(style, shown->style) == 0 && !ratio;
    bool conductance = out->figure->row->y == QUANTITY_JOINT;
    bool before = false; /* the point before was written: a mean of scans is empty from the first full contact on */
    drawing_begin(&out->drawing, style, shown->legend);
    if (hides)
        figure_hidden_begin(&out->lines, style);
    for (size_t i = from; i < to; i++) {
        const struct contact_point *point = &curve->points[i];
        double at = scale * quantity_shown(point, x, shown->sigma_m), value = value_shown(point, shown);
        if (conductance && point->value[QUANTITY_AREA] > nearly_full_area)
            continue; /* it has no bound there */
        if (ratio && isfinite(value)) {
            put(out, at, value);
            reach(&out->ratio, value);
        } else if (!ratio && put_point(out, at, value, quantity_rows[x].logarithmic, logarithmic)) {
            before = true;
            if (hides)
                figure_hidden_keep(&out->lines, at, value);
        } else {
            if (before && (QUANTITY_BIT(shown->y) & QUANTITY_RESISTANCES) && value == 0)
                put(out, x == QUANTITY_LOAD ? fmin(at, scale * curve->full_load) : at, 0);
            before = false;
        }
    }
}

/** A curve as up to three blocks: inside the model's validity, and (dashed, meeting the first or the last valid point)
 * outside. */
static void put_curve(struct figure_file *out, const struct model_curve *curve, const struct model_row *model,
                      const struct shown *shown)
{
    struct curve_validity valid = curve_summary_validity(curve, model);
    if (QUANTITY_BIT(shown->y) & QUANTITY_RESISTANCES && shown->over == QUANTITY_LOAD)
        for (size_t i = 0; i < curve->count && curve->points[i].value[QUANTITY_AREA] <= nearly_full_area; i++)
            out->floor = fmin(out->floor, curve->points[i].value[shown->y]);
    char outside_style[32];
    snprintf(outside_style, sizeof outside_style, "%sx", shown->style);
    put_part(out, curve, valid.first, valid.end, shown, shown->style);
    if (valid.first > 0)
        put_part(out, curve, 0, valid.first + 1, shown, outside_style);
    if (valid.end < curve->count)
        put_part(out, curve, valid.end > 0 ? valid.end - 1 : 0, curve->count, shown, outside_style);
}

/** The 95 % interval of the surface's mean against load, where there is one. */
static void put_band(struct figure_file *out, const struct surface_record *record, size_t model, const char *style)
{
    enum quantity y = out->figure->row->y;
    if (!record->bands || !record->bands[model] || out->figure->row->x != QUANTITY_LOAD || !ensemble_band_holds(y))
        return;
    char band_style[32];
    snprintf(band_style, sizeof band_style, "%sb", style);
    drawing_begin(&out->drawing, band_style, "band");
    for (size_t i = 0; i < record->band_count; i++) {
        const struct ensemble_band *band = &record->bands[model][i];
        double low = band->mean[y][0], high = band->mean[y][1];
        if (isfinite(low) && isfinite(high) && low > 0) {
            put(out, out->load_scale * band->load, low, high);
            reach(&out->y, low);
            reach(&out->y, high);
        }
    }
}

/** What was measured, with its error where one is given. */
static void put_measured(struct figure_file *out, const struct measured *measured, unsigned effects)
{
    if (!measured || out->figure->row->y != measured_quantity(measured, effects))
        return;
    drawing_begin(&out->drawing, "meas", "measured");
    for (size_t i = 0; i < measured->count; i++) {
        double value = measured->resistance[i], error = isnan(measured->error[i]) ? 0 : measured->error[i];
        double low = fmax(value - error, value * 1e-3), load = out->load_scale * measured->load[i];
        put(out, load, value, low, value + error);
        reach(&out->x, load);
        reach(&out->y, low);
        reach(&out->y, value + error);
        out->floor = fmin(out->floor, low);
    }
}

/** The adjusted separation beside a model's own, where the run and the model have it. */
static void put_adjusted(struct figure_file *out, const struct surface_record *record, size_t m, unsigned wanted)
{
    const struct model_row *model = model_rows[m];
    char style[32], legend[80];
    if (!(model->quantities & wanted & QUANTITY_BIT(QUANTITY_ADJUSTED)))
        return;
    snprintf(style, sizeof style, "%sa", model->style);
    snprintf(legend, sizeof legend, "%s, adjusted", model->label);
    out->adjusted = true;
    put_curve(out, &record->curves[m], model,
              &(struct shown){QUANTITY_ADJUSTED, QUANTITY_LOAD, record->summary.asperities.sigma_m, style, legend});
}

/** A curve of the panel below: the row's quantity there over the figure's. */
static void put_ratio(struct figure_file *out, const struct surface_record *record, size_t m, unsigned wanted,
                      const char *style, const char *legend)
{
    enum quantity below = out->figure->row->below;
    char ratio_style[32];
    if (below == QUANTITY_LOAD || !(quantity_with_made(model_rows[m]->quantities) & wanted & QUANTITY_BIT(below)))
        return;
    snprintf(ratio_style, sizeof ratio_style, "%sS", style);
    put_curve(out, &record->curves[m], model_rows[m],
              &(struct shown){below, out->figure->row->y, NAN, ratio_style, legend});
}

/** The charts of chapter 6 show the thesis's models, and others where none of those has a curve; the rest shows all. */
static void put_models(struct figure_file *out, const struct surface_record *record, unsigned wanted)
{
    enum quantity y = out->figure->row->y;
    bool thesis = false;
    for (size_t m = 0; m < model_count && out->figure->row->number > 0; m++)
        thesis = thesis || (record->curves[m].exists && model_rows[m]->thesis_place > 0);
    for (size_t m = 0; m < model_count; m++) {
        const struct model_row *model = model_rows[m];
        if (!record->curves[m].exists || !(quantity_with_made(model->quantities) & QUANTITY_BIT(y)) ||
            (model->thesis_place == 0 && thesis))
            continue;
        if (model_shown(model, y) == y)
            put_band(out, record, m, model->style);
        put_curve(out, &record->curves[m], model,
                  &(struct shown){y, QUANTITY_LOAD, record->summary.asperities.sigma_m, model->style, model->label});
        if (y == QUANTITY_SEPARATION)
            put_adjusted(out, record, m, wanted);
        put_ratio(out, record, m, wanted, model->style, model->label);
    }
    if (out->drawing.blocks == 0) /* gnuplot complains of a file without any */
        drawing_begin(&out->drawing, model_rows[0]->style, "no model exists for this surface");
}

static void surface_legend(char *legend, size_t size, const struct surface_summary *summary)
{
    snprintf(legend, size, "%s, Rq %.3g µm", summary->scene->name, summary->roughness.rq_m * 1e6);
}

/** Bins of the spectrum the law is fitted to: wavelength, amplitude, one standard error below and above, decades over
 * the law (empty: no law). */
static void put_bins(struct figure_file *out, const struct power_law_band *band, const char *style, const char *legend,
                     bool (*is_one)(enum power_law_band_use))
{
    drawing_begin(&out->drawing, style, legend);
    for (size_t j = 0; j < band->bins; j++) {
        const struct log_bin *bin = &band->bin[j];
        double s = sqrt(bin->variance), high_m = pow(10, bin->y + s), low_m = pow(10, bin->y - s);
        if (!is_one(band->use[j]) || !isfinite(high_m) || !(low_m > 0))
            continue;
        put(out, pow(10, bin->x), pow(10, bin->y), low_m, high_m,
            isfinite(band->residual_decades[j]) ? band->residual_decades[j] : NAN);
    }
}

static bool is_used(enum power_law_band_use use)
{
    return use == POWER_LAW_BAND_USED;
}

static bool is_line(enum power_law_band_use use)
{
    return use == POWER_LAW_BAND_LINE;
}

static bool is_left_out(enum power_law_band_use use)
{
    return !is_used(use) && !is_line(use);
}

/** What the law was found in. A knee's row has the amplitude of the bin next to it. */
static void put_found(struct figure_file *out, const struct power_law_band *band)
{
    put_bins(out, band, "bin", "in the fit", is_used);
    put_bins(out, band, "binx", "not in the fit", is_left_out);
    put_bins(out, band, "line", "lines", is_line);
    drawing_begin(&out->drawing, "knee", "knees");
    for (size_t k = 0; k + 1 < band->pieces; k++)
        for (size_t j = 0; j < band->bins; j++)
            if (pow(10, band->bin[j].x) < band->knee_m[k]) {
                put_point(out, band->knee_m[k], pow(10, band->bin[j].y), true, true);
                break;
            }
}

/** Spectrum of one surface: points (thinned evenly in log wavelength), the fit over its band, the fit beyond. */
static void put_spectrum(struct figure_file *out, const struct surface_record *record, const char *style,
                         const char *legend)
{
    enum { MOST = 400 };
    size_t index[MOST], count = results_sweep_scales(index, MOST, record->spectrum.count);
    const struct power_law *law = &record->summary.power_law;
    double longest = record->spectrum.length_m, shortest = longest / (double)record->spectrum.count;
    drawing_begin(&out->drawing, style, legend);
    for (size_t k = 0; k < count; k++)
        put_point(out, 1 / spectrum_frequency(&record->spectrum, index[k]), record->spectrum.amplitude_m[index[k]],
                  true, true);
    char fit[80] = "no power law";
    if (isfinite(law->gamma))
        snprintf(fit, sizeof fit, "γ %.2f ± %.2f%s", law->gamma, law->gamma_error,
                 law->found == POWER_LAW_BAND_NARROW ? ", narrow" : "");
    drawing_begin(&out->drawing, "fit", fit);
    for (int i = 0; i < 2; i++)
        put_point(out, law->band_m[i], power_law_amplitude(law, law->band_m[i]), true, true);
    drawing_begin(&out->drawing, "fitx", fit);
    put_point(out, shortest, power_law_amplitude(law, shortest), true, true);
    put_point(out, law->band_m[0], power_law_amplitude(law, law->band_m[0]), true, true);
    if (record->band && record->band->bins > 0)
        put_found(out, record->band);
}

static void put_profile(struct figure_file *out, const struct surface_record *record, const char *style,
                        const char *legend)
{
    drawing_begin(&out->drawing, style, legend);
    for (size_t i = 0; i < record->preview_points; i++)
        put(out, record->preview_x_m[i] * 1e3, record->preview_z_m[i] * 1e6);
}

static bool is_of_surfaces(const struct figure_file *out)
{
    enum figure_kind kind = out->figure->row->kind;
    return kind == FIGURE_SURFACES || kind == FIGURE_PROFILES || kind == FIGURE_SPECTRA;
}

/** Puts what a figure of all surfaces shows of the k-th of them. */
static void put_surface(struct figure_file *out, const struct results *results, size_t k,
                        const struct surface_record *record)
{
    const struct figure_row *row = out->figure->row;
    char legend[200], style[24];
    out->load_scale = results_load_axis(results, results->shown[k]).scale;
    surface_legend(legend, sizeof legend, &record->summary);
    snprintf(style, sizeof style, "s%zu", k + 1);
    if (row->kind == FIGURE_PROFILES) {
        put_profile(out, record, style, legend);
    } else if (row->kind == FIGURE_SPECTRA) {
        put_spectrum(out, record, style, legend);
    } else {
        size_t m = out->figure->model;
        put_band(out, record, m, style);
        put_curve(out, &record->curves[m], model_rows[m],
                  &(struct shown){model_shown(model_rows[m], row->y), QUANTITY_LOAD, record->summary.asperities.sigma_m,
                                  style, legend});
        put_ratio(out, record, m, results->plan->wanted, style, legend);
    }
}

static void put_counterface(struct figure_file *out, const struct surface_record *counterface)
{
    char legend[80];
    snprintf(legend, sizeof legend, "counterface, Rq %.3g µm", counterface->summary.roughness.rq_m * 1e6);
    put_profile(out, counterface, "cf", legend);
}

static void put_sweep(struct figure_file *out, const struct results *results)
{
    enum { MOST = 150 };
    const struct scene_convergence *study = &results->scene->convergence;
    const struct convergence_sweep_row *sweep = &convergence_sweeps[out->figure->row->sweep];
    size_t index[MOST], count = results_sweep_scales(index, MOST, study->scales);
    for (size_t v = 0; v < sweep->count; v++) {
        char legend[40], style[24];
        snprintf(legend, sizeof legend, "%s = %g", out->figure->row->sweep == CONVERGENCE_ALPHA ? "α" : "γ",
                 sweep->values[v]);
        snprintf(style, sizeof style, "r%zu", 1 + (8 * v + (sweep->count - 1) / 2) / (sweep->count - 1));
        drawing_begin(&out->drawing, style, legend);
        figure_hidden_begin(&out->lines, style);
        const double *area = results_sweep(results, out->figure->row->sweep, out->figure->model, v);
        for (size_t k = 0; k < count; k++) {
            double wavelength_m = study->scan_length_m / (double)(index[k] + 1);
            if (put_point(out, wavelength_m, area[index[k]], true, true))
                figure_hidden_keep(&out->lines, wavelength_m, area[index[k]]);
        }
    }
}

static void put_sensitivity(struct figure_file *out, const struct sensitivity_curves *curves)
{
    enum quantity y = out->figure->row->y;
    for (size_t m = 0; m < model_count; m++) {
        const struct contact_point *points = curves->points + m * SENSITIVITY_WAVELENGTHS;
        bool any = false;
        for (size_t w = 0; w < SENSITIVITY_WAVELENGTHS; w++)
            any = any || points[w].value[y] > 0;
        if (!any)
            continue;
        drawing_begin(&out->drawing, model_rows[m]->style, model_rows[m]->label);
        for (size_t w = 0; w < SENSITIVITY_WAVELENGTHS; w++)
            put_point(out, curves->wavelength_m[w], points[w].value[y], true, true);
    }
    if (out->drawing.blocks == 0)
        drawing_begin(&out->drawing, model_rows[0]->style, "no model has a value");
}

/** The direct solutions as points with their errors. */
static void put_direct_points(struct figure_file *out, const struct direct_study *study,
                              const struct material_pair *pair)
{
    static const char *const styles[] = {"dirl", "diro", "dirp"}, *const heights[] = {"scan's heights", "Gaussian"};
    enum quantity y = out->figure->row->y;
    double scale = quantity_rows[y].over_sigma ? 1 / sqrt(study->moments.m0_m2) : 1;
    for (int kind = 0; kind < DIRECT_STUDY_KINDS; kind++) {
        const struct direct_study_curve *curve = &study->curves[kind];
        bool leading = kind == (int)study->leading, capped = kind == DIRECT_STUDY_CAPPED;
        char legend[80] = "direct, elastic";
        if (!curve->points)
            continue;
        if (capped)
            snprintf(legend, sizeof legend, "direct, with the hardness");
        else if (study->plan.heights)
            snprintf(legend, sizeof legend, "direct, %s", heights[kind]);
        drawing_begin(&out->drawing, styles[leading ? 0 : capped ? 2 : 1], legend);
        for (size_t i = 0; i < curve->loads; i++) {
            double error, value = scale * direct_study_value(study, pair, (enum direct_study_kind)kind, y, i, &error);
            error = isnan(error) ? 0 : scale * error;
            if (value > 0)
                put(out, out->load_scale * study->plan.load[i], value, fmax(value - error, value * 1e-3),
                    value + error);
        }
    }
}

static void put_direct(struct figure_file *out, const struct direct_study *study, const struct plan *plan,
                       const struct material_pair *pair)
{
    enum quantity y = out->figure->row->y;
    for (size_t m = 0; m < model_count; m++) {
        struct contact_point points[SCENE_DIRECT_LOADS];
        struct model_curve curve = {.exists = true, .points = points};
        for (size_t i = 0; i < study->plan.loads; i++)
            if (direct_study_model(study, m, i))
                points[curve.count++] = *direct_study_model(study, m, i);
        if (curve.count > 0 && (model_rows[m]->quantities & plan->wanted & QUANTITY_BIT(y)))
            put_curve(out, &curve, model_rows[m],
                      &(struct shown){y, QUANTITY_LOAD, sqrt(study->moments.m0_m2), model_rows[m]->style,
                                      model_rows[m]->label});
    }
    put_direct_points(out, study, pair);
}

/** The direct solution's own error as a band round 1: standard error and what the grid leaves. */
static void put_direct_ratio(struct figure_file *out, const struct direct_study *study,
                             const struct material_pair *pair)
{
    enum quantity y = out->figure->row->y;
    drawing_begin(&out->drawing, "dirlb", "error of the direct solution");
    for (size_t i = 0; i < study->plan.loads; i++) {
        double error, value = direct_study_value(study, pair, study->leading, y, i, &error);
        double share = (isnan(error) ? 0 : error / value) + direct_study_grid_error(study, study->leading, y, i);
        if (value > 0)
            put(out, out->load_scale * study->plan.load[i], 1 / (1 + share), 1 + share);
    }
    for (size_t m = 0; m < model_count; m++) {
        bool any = false;
        for (size_t i = 0; i < study->plan.loads; i++)
            any = any || direct_study_ratio(study, pair, m, y, i) > 0;
        if (!any)
            continue;
        drawing_begin(&out->drawing, model_rows[m]->style, model_rows[m]->label);
        for (size_t i = 0; i < study->plan.loads; i++)
            put_point(out, out->load_scale * study->plan.load[i], direct_study_ratio(study, pair, m, y, i), true, true);
    }
}

/** Runs of points in contact, row by row [um]. */
static void put_patches(struct figure_file *out, const struct direct_study *study)
{
    size_t n = study->plan.grid;
    double step_um = study->plan.length_m * 1e6 / (double)n;
    drawing_begin(&out->drawing, "patches", "x from, x to, y from, y to (um)");
    for (size_t j = 0; j < n; j++)
        for (size_t i = 0; i < n; i++) {
            size_t from = i;
            while (i < n && study->contact[j * n + i])
                i++;
            if (i > from)
                put(out, (double)from * step_um, (double)i * step_um, (double)j * step_um, (double)(j + 1) * step_um);
        }
}

/** The error of a row as its chart shows it: below 1e-16 it is nothing that double precision can show. */
static double cost_error(const struct benchmark_row *row)
{
    if (row->chart >= BENCHMARK_DIRECT_AREA)
        return fmax(row->mean, 1e-3); /* an error of exactly 0 has no place on a logarithmic axis */
    return row->error < 1e-16 ? 0 : row->error;
}

/** One line a study and method, and a ring round what the report uses. */
static void put_cost(struct figure_file *out, const struct benchmark *cost)
{
    size_t methods = 0;
    const struct benchmark_row *before = NULL;
    for (size_t i = 0; i < cost->count; before = &cost->rows[i++]) {
        const struct benchmark_row *row = &cost->rows[i];
        if (row->chart != out->figure->row->chart)
            continue;
        if (!before || strcmp(before->study, row->study) != 0 || strcmp(before->method, row->method) != 0) {
            char legend[80], style[24];
            bool integral = row->chart == BENCHMARK_INTEGRALS, direct = row->chart >= BENCHMARK_DIRECT_AREA;
            if (direct) /* as everywhere else in the report */
                snprintf(style, sizeof style, "%s", row->model ? row->model->style : "dirl");
            else
                snprintf(style, sizeof style, "c%zu", methods++ % 9 + 1);
            snprintf(legend, sizeof legend, "%s, %s", integral ? row->model->label : row->method,
                     integral ? row->method : row->study);
            drawing_begin(&out->drawing, style, direct ? row->method : legend);
        }
        put(out, row->seconds, cost_error(row));
    }
    bool chosen = false;
    for (size_t i = 0; i < cost->count; i++)
        chosen = chosen || (cost->rows[i].chart == out->figure->row->chart && cost->rows[i].chosen);
    if (!chosen && out->figure->row->chart >= BENCHMARK_DIRECT_AREA)
        return;
    drawing_begin(&out->drawing, "choice", "used in this report");
    for (size_t i = 0; i < cost->count; i++)
        if (cost->rows[i].chart == out->figure->row->chart && cost->rows[i].chosen)
            put(out, cost->rows[i].seconds, cost_error(&cost->rows[i]));
}

struct figure_file figure_data_start(const struct figure *figure)
{
    return (struct figure_file){.figure = figure, .floor = INFINITY, .x = nothing, .y = nothing, .ratio = nothing};
}

void figure_data_free(struct figure_file *file)
{
    drawing_free(&file->drawing);
    figure_hidden_free(&file->lines);
}

/** Puts what a figure shows that is not of all surfaces. */
static void put_own(struct figure_file *file, const struct results *results, const struct surface_record *baseline)
{
    file->load_scale = results_load_axis(results, results->baseline).scale;
    switch (file->figure->row->kind) {
    case FIGURE_SWEEP:
        put_sweep(file, results);
        break;
    case FIGURE_DIRECT:
        file->load_scale = results_load_axis(results, figure_direct(results)->surface).scale;
        put_direct(file, figure_direct(results), results->plan, results_pair(results, figure_direct(results)->surface));
        break;
    case FIGURE_DIRECT_RATIO:
        file->load_scale = results_load_axis(results, figure_direct(results)->surface).scale;
        put_direct_ratio(file, figure_direct(results), results_pair(results, figure_direct(results)->surface));
        break;
    case FIGURE_PATCHES:
        put_patches(file, figure_direct(results));
        break;
    case FIGURE_SENSITIVITY:
        put_sensitivity(file, results->sensitivity);
        break;
    case FIGURE_BENCHMARK:
        put_cost(file, results->benchmark);
        break;
    case FIGURE_MODELS:
        put_models(file, baseline, results->plan->wanted);
        put_measured(file, results->measured, results->plan->running);
        break;
    case FIGURE_SURFACES:
    case FIGURE_PROFILES:
    case FIGURE_SPECTRA:
        break;
    }
}

void figure_data_put(struct figure_file *files, size_t count, const struct results *results)
{
    for (size_t i = 0; i < count; i++)
        put_own(&files[i], results, &results->surfaces[results->baseline]);
    for (size_t k = 0; k < results->shown_count; k++)
        for (size_t i = 0; i < count; i++)
            if (is_of_surfaces(&files[i]))
                put_surface(&files[i], results, k, &results->surfaces[results->shown[k]]);
    for (size_t i = 0; i < count && results->counterface; i++)
        if (files[i].figure->row->kind == FIGURE_PROFILES)
            put_counterface(&files[i], results->counterface);
}
