#include "chart/figure.h"

#include "analysis/direct_study.h"
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
    case FIGURE_PROBABILITY:
        for (size_t k = 0; k < results->shown_count; k++)
            if (figure_data_heights_model(&results->store->summaries[results->shown[k]]) < model_count)
                return true;
        return false;
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
    free(list->figures);
    *list = (struct figure_list){0};
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

static bool is_sweep(const struct figure_row *row)
{
    return row->kind == FIGURE_SWEEP || row->kind == FIGURE_SENSITIVITY;
}

static bool is_direct(const struct figure_row *row)
{
    return row->kind == FIGURE_DIRECT || row->kind == FIGURE_DIRECT_RATIO;
}

static bool x_is_logarithmic(const struct figure_row *row)
{
    return is_sweep(row) || row->kind == FIGURE_DIRECT_RATIO || quantity_rows[row->x].logarithmic;
}

static bool y_is_logarithmic(const struct figure_row *row)
{
    return is_sweep(row) || row->kind == FIGURE_DIRECT_RATIO || quantity_rows[row->y].logarithmic;
}

/** The label of the y axis: what a sweep shows, it shows at one load. */
static void add_y_label(struct text *script, const struct figure_row *row, const struct results *results)
{
    if (row->kind == FIGURE_SWEEP)
        text_add(script, " '%s, at P/(Aₙ E′) = %g'", quantity_rows[QUANTITY_AREA].label,
                 results->scene->convergence.load);
    else
        text_add(script, " '%s'",
                 row->kind == FIGURE_DIRECT_RATIO ? "model / direct solution" : quantity_rows[row->y].label);
}

/** What the axes of a figure hold. */
struct axes {
    bool given; /* else the data alone say */
    struct figure_extent x, y, ratio;
};

/** NUMBER.gp: what draws the figure, for this program and for anyone in that directory. */
static enum status_code write_script(const struct figure_file *out, const struct axes *axes,
                                     const struct results *results, const char *directory, struct status *status)
{
    static const char *const templates[] = {
        [FIGURE_SWEEP] = "curves.gp",       [FIGURE_MODELS] = "curves.gp",          [FIGURE_SURFACES] = "curves.gp",
        [FIGURE_PROFILES] = "profiles.gp",  [FIGURE_SPECTRA] = "spectra.gp",        [FIGURE_BENCHMARK] = "cost.gp",
        [FIGURE_SENSITIVITY] = "curves.gp", [FIGURE_DIRECT] = "curves.gp",          [FIGURE_DIRECT_RATIO] = "curves.gp",
        [FIGURE_PATCHES] = "patches.gp",    [FIGURE_PROBABILITY] = "probability.gp"};
    const struct figure_row *row = out->figure->row;
    struct text script = {0};
    const char *number = out->figure->number;
    const struct results_load_axis axis = results_load_axis(results, results->baseline);
    char loads_label[UNIT_LENGTH + 16]; /* a unit holds neither quotes nor control characters */
    snprintf(loads_label, sizeof loads_label, "%s (%s)", results->scene->load.kind == UNIT_FORCE ? "load" : "pressure",
             axis.unit ? axis.unit : "");
    bool curves = is_sweep(row) || is_direct(row) || row->kind == FIGURE_MODELS || row->kind == FIGURE_SURFACES;
    text_add(&script, "# draws figure %s from %s.csv: gnuplot %s.gp\n", number, number, number);
    if (is_direct(row) || row->kind == FIGURE_MODELS || row->kind == FIGURE_SENSITIVITY ||
        (row->kind == FIGURE_BENCHMARK && row->chart >= BENCHMARK_DIRECT_AREA))
        text_add(&script, "load 'models.gp'\n");
    if (row->below != QUANTITY_LOAD)
        text_add(&script, "below_label = '%s'\n", row->below_label);
    text_add(&script, "call '%s' '%s.csv' ('%s' . (exists('dumb_size') ? '.txt' : '%s')) '%s'", templates[row->kind],
             number, number, figure_extension(row), out->figure->title);
    if (row->kind == FIGURE_PATCHES)
        text_add(&script, " '%.6e'", figure_direct(results)->plan.length_m * 1e6);
    if (curves) { /* the others name their own axes */
        text_add(&script, " '%s'",
                 is_sweep(row)                          ? "shortest wavelength included (m)"
                 : axis.unit && row->x == QUANTITY_LOAD ? loads_label
                                                        : quantity_rows[row->x].label);
        add_y_label(&script, row, results);
        text_add(&script, " '%s%s'", x_is_logarithmic(row) ? "x" : "", y_is_logarithmic(row) ? "y" : "");
    }
    text_add(&script, " '%s'", text_string(&out->styles));
    if (axes->given) { /* gnuplot reads '1.0e-06' from a string, but not '1e-06' */
        text_add(&script, " '%.6e %.6e %.6e %.6e", axes->x.low, axes->x.high, axes->y.low, axes->y.high);
        if (axes->ratio.low <= axes->ratio.high)
            text_add(&script, " %.6e %.6e", axes->ratio.low, axes->ratio.high);
        text_add(&script, "'");
    }
    if (row->kind == FIGURE_SENSITIVITY)
        text_add(&script, " '' '%.6e'", results->sensitivity->unsure_m);
    text_add(&script, "\n");
    char name[sizeof out->figure->number + 4];
    snprintf(name, sizeof name, "%s.gp", number);
    enum status_code rc = write_text(&script, directory, name, status);
    text_free(&script);
    return rc;
}

static FILE *open_data(const struct figure *figure, const char *directory, const char *mode)
{
    struct text path = {0};
    text_add(&path, "%s/figures/%s.csv", directory, figure->number);
    FILE *file = path.failed ? NULL : fopen(text_string(&path), mode);
    text_free(&path);
    return file;
}

static enum status_code close_data(struct figure_file *out, struct status *status)
{
    bool bad = ferror(out->file);
    if (fclose(out->file) != 0 || bad)
        return status_fail(status, STATUS_IO, "cannot write figure %s: %s", out->figure->number, strerror(errno));
    out->file = NULL;
    return STATUS_OK;
}

static enum status_code write_data(struct figure_file *out, const struct results *results,
                                   const struct surface_record *baseline, const char *directory, struct status *status)
{
    out->file = open_data(out->figure, directory, "w");
    if (!out->file)
        return status_fail(status, STATUS_IO, "cannot write figure %s: %s", out->figure->number, strerror(errno));
    enum status_code rc = figure_data_put(out, results, baseline, status);
    enum status_code closed = close_data(out, status);
    return rc != STATUS_OK ? rc : closed != STATUS_OK ? closed : out->lines.failed ? status_memory(status) : STATUS_OK;
}

static void join(struct figure_extent *all, struct figure_extent one)
{
    all->low = fmin(all->low, one.low);
    all->high = fmax(all->high, one.high);
}

/** The charts of all surfaces compare: one y range a quantity, one x range. Charts against load hold all loads. A
 * resistance goes down to little below the floor, a separation shown adjusted as well to where its own is cut. */
static struct axes axes_of(const struct figure_file *files, size_t count, size_t k, const struct results *results)
{
    const struct figure_row *row = files[k].figure->row;
    struct axes axes = {.given = row->kind == FIGURE_MODELS || row->kind == FIGURE_SURFACES};
    axes.x = files[k].x;
    axes.y = files[k].y;
    axes.ratio = files[k].ratio;
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
    if (!axes.given)
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
    axes.given = axes.x.low <= axes.x.high && axes.y.low <= axes.y.high;
    return axes;
}

/** Finds what of a figure's lines is hidden, now that its axes are known, and writes its script. */
static enum status_code complete_figure(struct figure_file *out, const struct axes *axes, const struct results *results,
                                        const char *directory, struct status *status)
{
    const struct figure_row *row = out->figure->row;
    if (row->kind == FIGURE_SURFACES || row->kind == FIGURE_SWEEP) {
        out->file = open_data(out->figure, directory, "a");
        if (!out->file)
            return status_fail(status, STATUS_IO, "cannot write figure %s: %s", out->figure->number, strerror(errno));
        figure_hidden_put(out, axes->x, axes->y, x_is_logarithmic(row), y_is_logarithmic(row));
        if (close_data(out, status) != STATUS_OK)
            return status->code;
        if (out->lines.failed)
            return status_memory(status);
    }
    return write_script(out, axes, results, directory, status);
}

/** models.gp: the look of every model's line. */
static enum status_code write_models(const char *directory, struct status *status)
{
    struct text script = {0};
    for (size_t m = 0; m < model_count; m++)
        text_add(&script, "colour_%s = '%s'; marker_%s = %d # %s\n", model_rows[m]->style, model_rows[m]->colour,
                 model_rows[m]->style, model_rows[m]->marker, model_rows[m]->name);
    enum status_code rc = write_text(&script, directory, "models.gp", status);
    text_free(&script);
    return rc;
}

static enum status_code copy_template(const char *name, const char *templates, const char *directory,
                                      struct status *status)
{
    struct text from = {0}, content = {0};
    text_add(&from, "%s/%s", templates, name);
    enum status_code rc = text_read_file(&content, text_string(&from), status);
    if (rc == STATUS_OK)
        rc = write_text(&content, directory, name, status);
    text_free(&from);
    text_free(&content);
    return rc;
}

enum status_code figure_write_all(const struct figure_list *list, const struct results *results, const char *directory,
                                  const char *templates, struct status *status)
{
    static const char *const names[] = {"style.gp",    "blocks.gp",  "axis.gp", "legend.gp",      "curves.gp",
                                        "profiles.gp", "spectra.gp", "cost.gp", "probability.gp", "patches.gp"};
    size_t count = sizeof names / sizeof names[0] - (figure_direct(results) ? 0 : 1);
    for (size_t i = 0; i < count; i++)
        if (copy_template(names[i], templates, directory, status) != STATUS_OK)
            return status->code;
    if (write_models(directory, status) != STATUS_OK)
        return status->code;
    struct surface_record baseline;
    if (surface_store_get_part(&baseline, results->store, results->baseline, SURFACE_BYTES_SPECTRUM, status) !=
        STATUS_OK)
        return status->code;
    struct figure_file *files = calloc(list->count + 1, sizeof *files);
    enum status_code rc = files ? STATUS_OK : status_memory(status);
    size_t made = 0;
    for (; made < list->count && rc == STATUS_OK; made++) {
        files[made] = figure_data_start(&list->figures[made]);
        rc = write_data(&files[made], results, &baseline, directory, status);
    }
    for (size_t i = 0; i < list->count && rc == STATUS_OK; i++) {
        struct axes axes = axes_of(files, list->count, i, results);
        rc = complete_figure(&files[i], &axes, results, directory, status);
    }
    for (size_t i = 0; i < made; i++)
        figure_data_free(&files[i]);
    free(files);
    surface_record_free(&baseline, false);
    return rc;
}

/** Moves the text charts from their files into `out`. */
static enum status_code collect_text(struct text *out, const struct figure_list *list, const char *directory,
                                     struct status *status)
{
    enum status_code rc = STATUS_OK;
    for (size_t i = 0; i < list->count && rc == STATUS_OK; i++) {
        if (!list->figures[i].terminal)
            continue;
        struct text path = {0};
        text_add(&path, "%s/figures/%s.txt", directory, list->figures[i].number);
        rc = gnuplot_take_text(out, text_string(&path), status);
        text_free(&path);
    }
    return rc;
}

enum status_code figure_draw_all(const struct figure_list *list, const char *directory, const char *terminal_size,
                                 struct text *terminal_text, double *seconds, struct status *status)
{
    struct text path = {0};
    struct gnuplot gnuplot;
    text_add(&path, "%s/figures", directory);
    enum status_code rc = gnuplot_start(&gnuplot, text_string(&path), status);
    text_free(&path);
    if (rc != STATUS_OK)
        return rc;
    for (size_t i = 0; i < list->count; i++)
        gnuplot_send(&gnuplot, "load '%s.gp'", list->figures[i].number);
    if (terminal_size)
        gnuplot_send(&gnuplot, "dumb_size = '%s'", terminal_size);
    for (size_t i = 0; terminal_size && i < list->count; i++)
        if (list->figures[i].terminal)
            gnuplot_send(&gnuplot, "load '%s.gp'", list->figures[i].number);
    rc = gnuplot_finish(&gnuplot, status);
    *seconds = gnuplot.seconds;
    return rc == STATUS_OK && terminal_size ? collect_text(terminal_text, list, directory, status) : rc;
}
