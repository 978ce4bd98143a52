/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "chart/figure.h"

#include "analysis/direct_study.h"
#include "base/clock.h"
#include "chart/figure_data.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

const struct direct_study *figure_direct(const struct results *results)
{
    for (size_t k = 0; k < results->direct_count; k++)
        if (results->direct[k].surface == results->baseline)
            return &results->direct[k];
    return NULL;
}

const char *figure_extension(const struct figure_row *row)
{
    return row->kind == FIGURE_PATCHES ? ".png" : ".svg";
}

/** The effects and models that the row needs; for a figure a model, in that model. */
static bool is_called_for(const struct figure_row *row, const struct results *results, size_t model)
{
    const struct plan *plan = results->plan;
    unsigned needed = QUANTITY_BIT(row->x) | QUANTITY_BIT(row->y);
    switch (row->kind) {
    case FIGURE_SWEEP:
        return results->convergence && plan_runs_model(plan, model) && model_rows[model]->stacks_scales;
    case FIGURE_SURFACES:
        return plan_runs_model(plan, model) && (model_rows[model]->quantities & plan->wanted & needed) == needed &&
               (model_rows[model]->thesis_place > 0 || model == plan_leading_model(plan));
    case FIGURE_MODELS:
        return (plan_quantities(plan) & needed) == needed && (!row->beyond_thesis || plan_beyond_thesis(plan));
    case FIGURE_DIRECT:
    case FIGURE_DIRECT_RATIO:
        return figure_direct(results) && (plan->wanted & needed) == needed;
    case FIGURE_PATCHES:
        return figure_direct(results) && figure_direct(results)->contact && (plan->wanted & needed) == needed;
    case FIGURE_SENSITIVITY:
        return results->sensitivity && (plan_quantities(plan) & QUANTITY_BIT(row->y));
    case FIGURE_PROFILES:
    case FIGURE_SPECTRA:
        return true;
    case FIGURE_BENCHMARK:
        for (size_t i = 0; results->benchmark && i < results->benchmark->count; i++)
            if (results->benchmark->rows[i].chart == row->chart)
                return true;
        return false;
    }
    return false;
}

/** Place of a model's figure in the row's block of chapter 6, 0 and up; -1: it has none. */
static int place_of(const struct figure_row *row, size_t model)
{
    const struct model_row *m = model_rows[model];
    return m->thesis_place == 0 ? -1 : row->kind == FIGURE_SWEEP ? m->plastic : m->thesis_place - 1;
}

static struct figure figure_of(const struct figure_row *row, size_t model)
{
    struct figure figure = {.row = row, .model = model, .terminal = row->terminal};
    bool single = model == model_count;
    int place = single ? 0 : place_of(row, model);
    if (row->number > 0 && place >= 0)
        snprintf(figure.number, sizeof figure.number, "6-%02d", row->number + place);
    else
        snprintf(figure.number, sizeof figure.number, "%s%s%s", row->name, single ? "" : "-",
                 single ? "" : model_rows[model]->name);
    if (row->kind == FIGURE_SURFACES) {
        snprintf(figure.title, sizeof figure.title, "%s against %s, %s",
                 quantity_rows[model_shown(model_rows[model], row->y)].title, quantity_rows[row->x].short_symbol,
                 model_rows[model]->label);
        figure.terminal = row->terminal && place == 0;
    } else if (row->kind == FIGURE_SWEEP) {
        snprintf(figure.title, sizeof figure.title, "%s, %s", row->title,
                 place < 0                    ? model_rows[model]->label
                 : model_rows[model]->plastic ? "elastic-plastic"
                                              : "elastic");
    } else {
        snprintf(figure.title, sizeof figure.title, "%s", row->title);
    }
    return figure;
}

/** Is it of the answer that the report is asked for? */
static bool decides(const struct figure *figure, const struct results *results)
{
    enum quantity criterion = results_criterion(results);
    bool electrical = results->plan->wanted & QUANTITY_BIT(QUANTITY_ECR); /* TCR is in proportion, and has no ratio */
    if (figure->row->kind == FIGURE_DIRECT_RATIO)
        return figure->row->y == (electrical ? QUANTITY_ECR : QUANTITY_AREA);
    return figure->row->kind == FIGURE_SURFACES && figure->row->y == criterion &&
           figure->model == plan_leading_model(results->plan);
}

/** The thesis's models in its own order, then the others in the table's. */
static int compare_figures(const void *a, const void *b)
{
    const struct figure *f = a, *g = b;
    int x = place_of(f->row, f->model), y = place_of(g->row, g->model);
    if (x < 0 || y < 0)
        return x < 0 && y < 0 ? (f->model > g->model) - (f->model < g->model) : x < 0 ? 1 : -1;
    return x - y;
}

enum status_code figure_list_make(struct figure_list *out, const struct results *results, struct status *status)
{
    *out = (struct figure_list){.figures = calloc(figure_row_count * model_count, sizeof *out->figures)};
    if (!out->figures)
        return status_memory(status);
    for (size_t i = 0; i < figure_row_count; i++) {
        const struct figure_row *row = &figure_rows[i];
        if (row->kind != FIGURE_SURFACES && row->kind != FIGURE_SWEEP) {
            if (is_called_for(row, results, model_count))
                out->figures[out->count++] = figure_of(row, model_count);
            continue;
        }
        size_t first = out->count;
        for (size_t m = 0; m < model_count; m++)
            if (is_called_for(row, results, m))
                out->figures[out->count++] = figure_of(row, m);
        qsort(out->figures + first, out->count - first, sizeof *out->figures, compare_figures);
    }
    for (size_t i = 0; i < out->count; i++)
        out->figures[i].decides = decides(&out->figures[i], results);
    return STATUS_OK;
}

void figure_list_keep_deciding(struct figure_list *list)
{
    size_t kept = 0;
    for (size_t i = 0; i < list->count; i++)
        if (list->figures[i].decides) {
            list->figures[kept] = list->figures[i];
            list->figures[kept++].terminal = list->figures[i].row->kind == FIGURE_SURFACES;
        }
    list->count = kept;
}

void figure_list_free(struct figure_list *list)
{
    for (size_t i = 0; i < list->count; i++)
        text_free(&list->figures[i].letters);
    free(list->figures);
    *list = (struct figure_list){0};
}

static bool is_sweep(const struct figure_row *row)
{
    return row->kind == FIGURE_SWEEP || row->kind == FIGURE_SENSITIVITY;
}

static bool x_is_logarithmic(const struct figure_row *row)
{
    return is_sweep(row) || row->kind == FIGURE_DIRECT_RATIO || quantity_rows[row->x].logarithmic;
}

static bool y_is_logarithmic(const struct figure_row *row)
{
    return is_sweep(row) || row->kind == FIGURE_DIRECT_RATIO || quantity_rows[row->y].logarithmic;
}

static const enum drawing_kind drawing_kinds[] = {
    [FIGURE_SWEEP] = DRAWING_CURVES,       [FIGURE_MODELS] = DRAWING_CURVES,   [FIGURE_SURFACES] = DRAWING_CURVES,
    [FIGURE_PROFILES] = DRAWING_PROFILES,  [FIGURE_SPECTRA] = DRAWING_SPECTRA, [FIGURE_BENCHMARK] = DRAWING_COST,
    [FIGURE_SENSITIVITY] = DRAWING_CURVES, [FIGURE_DIRECT] = DRAWING_CURVES,   [FIGURE_DIRECT_RATIO] = DRAWING_CURVES,
    [FIGURE_PATCHES] = DRAWING_PATCHES,
};

/** Labels of curves against load, area or wavelength; what a sweep shows, it shows at one load. */
static void label_curves(struct drawing *drawing, const struct figure_row *row, const struct results *results)
{
    const struct results_load_axis axis = results_load_axis(results, results->baseline);
    size_t size = sizeof drawing->x_label;
    if (is_sweep(row))
        snprintf(drawing->x_label, size, "shortest wavelength included (m)");
    else if (axis.unit && row->x == QUANTITY_LOAD)
        snprintf(drawing->x_label, size, "%s (%s)", results->scene->load.kind == UNIT_FORCE ? "load" : "pressure",
                 axis.unit);
    else
        snprintf(drawing->x_label, size, "%s", quantity_rows[row->x].label);
    size = sizeof drawing->y_label;
    if (row->kind == FIGURE_SWEEP)
        snprintf(drawing->y_label, size, "%s, at P/(Aₙ E′) = %g", quantity_rows[QUANTITY_AREA].label,
                 results->scene->convergence.load);
    else
        snprintf(drawing->y_label, size, "%s",
                 row->kind == FIGURE_DIRECT_RATIO ? "model / direct solution" : quantity_rows[row->y].label);
}

/** Names, labels and kinds of axes. */
static void describe(struct drawing *drawing, const struct figure *figure, const struct results *results)
{
    static const struct {
        const char *x, *y;
        bool logarithmic;
    } own[] = {
        [DRAWING_PROFILES] = {"position (mm)", "height (µm)", false},
        [DRAWING_SPECTRA] = {"wavelength (m)", "amplitude (m)", true},
        [DRAWING_COST] = {"time (s)", "relative error", true},
        [DRAWING_PATCHES] = {"", "", false},
    };
    const struct figure_row *row = figure->row;
    drawing->kind = drawing_kinds[row->kind];
    snprintf(drawing->name, sizeof drawing->name, "%s", figure->number);
    snprintf(drawing->title, sizeof drawing->title, "%s", figure->title);
    if (drawing->kind == DRAWING_CURVES) {
        label_curves(drawing, row, results);
        drawing->log_x = x_is_logarithmic(row);
        drawing->log_y = y_is_logarithmic(row);
    } else {
        snprintf(drawing->x_label, sizeof drawing->x_label, "%s", own[drawing->kind].x);
        snprintf(drawing->y_label, sizeof drawing->y_label, "%s", own[drawing->kind].y);
        drawing->log_x = drawing->log_y = own[drawing->kind].logarithmic;
    }
    if (row->below != QUANTITY_LOAD)
        snprintf(drawing->below_label, sizeof drawing->below_label, "%s", row->below_label);
    if (row->kind == FIGURE_SENSITIVITY)
        drawing->unsure = results->sensitivity->unsure_m;
    if (row->kind == FIGURE_PATCHES)
        drawing->cell = figure_direct(results)->plan.length_m * 1e6;
}

static void join(struct figure_extent *all, struct figure_extent one)
{
    all->low = fmin(all->low, one.low);
    all->high = fmax(all->high, one.high);
}

/** What the axes of a figure hold. */
struct axes {
    struct figure_extent x, y, ratio;
};

/** The charts of all surfaces compare: one y range a quantity, one x range. Charts against load hold all loads. A
 * resistance goes down to little below the floor, a separation shown adjusted as well to where its own is cut. */
static struct axes axes_of(const struct figure_file *files, size_t count, size_t k, const struct results *results)
{
    const struct figure_row *row = files[k].figure->row;
    struct axes axes = {files[k].x, files[k].y, files[k].ratio};
    bool given = row->kind == FIGURE_MODELS || row->kind == FIGURE_SURFACES;
    double floor = files[k].floor;
    for (size_t i = 0; i < count && row->kind == FIGURE_SURFACES; i++) {
        const struct figure_row *other = files[i].figure->row;
        if (other->kind != FIGURE_SURFACES)
            continue;
        if (other->x == row->x)
            join(&axes.x, files[i].x);
        if (other->y == row->y) {
            join(&axes.y, files[i].y);
            join(&axes.ratio, files[i].ratio);
            floor = fmin(floor, files[i].floor);
        }
    }
    if (!given)
        return axes;
    if (row->x == QUANTITY_LOAD) {
        const double *loads = results_loads(results, results->baseline);
        double scale = results_load_axis(results, results->baseline).scale;
        join(&axes.x, (struct figure_extent){scale * loads[0], scale * loads[results->load_count - 1]});
    }
    if (isfinite(floor))
        axes.y.low = fmax(axes.y.low, 0.3 * floor);
    if (files[k].adjusted)
        axes.y.low = fmax(axes.y.low, figure_lowest_separation);
    return axes;
}

static enum status_code write_text(const struct text *content, const char *directory, const char *name,
                                   struct status *status)
{
    struct text path = {0};
    text_add(&path, "%s/figures/%s", directory, name);
    enum status_code rc = content->failed || path.failed
                              ? status_memory(status)
                              : text_write_file(text_string(&path), content->data, content->length, status);
    text_free(&path);
    return rc;
}

static enum status_code write_part(const struct text *content, const struct figure *figure, const char *ending,
                                   const char *directory, struct status *status)
{
    char name[sizeof figure->number + 4];
    snprintf(name, sizeof name, "%s%s", figure->number, ending);
    return write_text(content, directory, name, status);
}

/** Finds what of a figure's lines is hidden, now that its axes are known, and writes its script and its data. */
static enum status_code complete_figure(struct figure_file *out, struct figure *figure, const struct axes *axes,
                                        const struct results *results, const char *directory, const char *terminal_size,
                                        struct status *status)
{
    const struct figure_row *row = figure->row;
    struct drawing *drawing = &out->drawing;
    struct text script = {0}, data = {0};
    describe(drawing, figure, results);
    if (row->kind == FIGURE_SURFACES || row->kind == FIGURE_SWEEP)
        figure_hidden_put(out, axes->x, axes->y, drawing->log_x, drawing->log_y);
    if (row->kind == FIGURE_SURFACES || row->kind == FIGURE_MODELS) {
        drawing->axes_given = axes->x.low <= axes->x.high && axes->y.low <= axes->y.high;
        drawing->x = axes->x;
        drawing->y = axes->y;
        drawing->ratio = axes->ratio;
    }
    if (out->lines.failed || drawing->failed)
        return status_memory(status);
    enum status_code rc = drawing_script(&script, drawing, NULL, status);
    if (rc == STATUS_OK && terminal_size && figure->terminal)
        rc = drawing_script(&figure->letters, drawing, terminal_size, status);
    if (rc == STATUS_OK)
        rc = write_part(&script, figure, ".gp", directory, status);
    drawing_thin(drawing);
    if (rc == STATUS_OK) {
        drawing_data(&data, drawing);
        rc = write_part(&data, figure, ".csv", directory, status);
    }
    text_free(&script);
    text_free(&data);
    return rc;
}

enum status_code figure_write_all(struct figure_list *list, const struct results *results, const char *directory,
                                  const char *terminal_size, struct status *status)
{
    struct figure_file *files = calloc(list->count + 1, sizeof *files);
    if (!files)
        return status_memory(status);
    for (size_t i = 0; i < list->count; i++)
        files[i] = figure_data_start(&list->figures[i]);
    figure_data_put(files, list->count, results);
    enum status_code rc = STATUS_OK;
    for (size_t i = 0; i < list->count && rc == STATUS_OK; i++) {
        struct axes axes = axes_of(files, list->count, i, results);
        rc = complete_figure(&files[i], &list->figures[i], &axes, results, directory, terminal_size, status);
    }
    for (size_t i = 0; i < list->count; i++)
        figure_data_free(&files[i]);
    free(files);
    return rc;
}

/** Moves the text charts from their files into `out`. */
static enum status_code collect_text(struct text *out, const struct figure_list *list, const char *directory,
                                     struct status *status)
{
    enum status_code rc = STATUS_OK;
    for (size_t i = 0; i < list->count && rc == STATUS_OK; i++) {
        if (list->figures[i].letters.length == 0)
            continue;
        struct text path = {0};
        text_add(&path, "%s/figures/%s.txt", directory, list->figures[i].number);
        rc = gnuplot_take_text(out, text_string(&path), status);
        text_free(&path);
    }
    return rc;
}

/** Many figures are drawn by this many processes, whatever the threads: gnuplot's pen remembers the figure before, so
 * the same ones have to follow each other. Starting one takes as long as drawing some ten. */
enum { DRAWERS_MOST = 2, FIGURES_A_DRAWER = 10 };

/** Starts process `k` of `drawers` and sends what it is to draw. */
static enum status_code start_drawing(struct gnuplot *out, const struct figure_list *list, const char *directory,
                                      size_t k, size_t drawers, struct status *status)
{
    if (gnuplot_start(out, directory, status) != STATUS_OK)
        return status->code;
    for (size_t i = k; i < list->count; i += drawers) {
        gnuplot_send(out, "load '%s.gp'", list->figures[i].number);
        if (list->figures[i].letters.length > 0)
            gnuplot_send(out, "%s", text_string(&list->figures[i].letters));
    }
    return STATUS_OK;
}

enum status_code figure_draw_all(const struct figure_list *list, const char *directory, unsigned jobs,
                                 struct text *terminal_text, double *seconds, struct status *status)
{
    struct gnuplot gnuplot[DRAWERS_MOST];
    struct text path = {0};
    size_t drawers = list->count > FIGURES_A_DRAWER ? DRAWERS_MOST : 1, started = 0, ended = 0;
    double begun = clock_seconds();
    text_add(&path, "%s/figures", directory);
    enum status_code rc = path.failed ? status_memory(status) : STATUS_OK;
    while (ended < drawers && (rc == STATUS_OK || ended < started)) {
        if (started < drawers && rc == STATUS_OK && (jobs != 1 || started == ended)) {
            rc = start_drawing(&gnuplot[started], list, text_string(&path), started, drawers, status);
            started += rc == STATUS_OK;
            continue;
        }
        struct status own = {0};
        enum status_code end = gnuplot_finish(&gnuplot[ended++], &own);
        if (rc == STATUS_OK && end != STATUS_OK) {
            *status = own;
            rc = end;
        }
    }
    text_free(&path);
    *seconds = clock_seconds() - begun;
    return rc == STATUS_OK ? collect_text(terminal_text, list, directory, status) : rc;
}
