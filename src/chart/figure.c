#include "chart/figure.h"

#include "chart/figure_data.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

bool figure_present(const struct figure_row *row, const struct results *results)
{
    const struct plan *plan = results->plan;
    unsigned needs = figure_axes[row->x].effect | figure_axes[row->y].effect;
    if ((plan->running & needs) != needs)
        return false;
    switch (row->kind) {
    case FIGURE_SWEEP:
        return results->convergence && model_called_for(row->model, SCENE_MODEL_MULTISCALE, plan->running);
    case FIGURE_SURFACES:
        return model_called_for(row->model, plan->families, plan->running);
    case FIGURE_MODELS:
    case FIGURE_PROFILES:
    case FIGURE_SPECTRA:
        return true;
    case FIGURE_COST:
        for (size_t i = 0; results->cost && i < results->cost->count; i++)
            if (results->cost->rows[i].chart == row->cost)
                return true;
        return false;
    }
    return false;
}

/** NUMBER.gp: what draws the figure, for this program and for anyone in that directory. */
static enum status_code write_script(const struct figure_file *out, const struct results *results,
                                     const char *directory, struct status *status)
{
    const struct figure_row *row = out->row;
    struct text script = {0}, path = {0};
    const char *number = row->number;
    text_add(&script, "# draws figure %s from %s.csv: gnuplot %s.gp\n", number, number, number);
    const char *template = row->kind == FIGURE_PROFILES  ? "profiles.gp"
                           : row->kind == FIGURE_SPECTRA ? "spectra.gp"
                           : row->kind == FIGURE_COST    ? "cost.gp"
                                                         : "curves.gp";
    text_add(&script, "call '%s' '%s.csv' ('%s' . (exists('dumb_size') ? '.txt' : '.svg')) '%s'", template, number,
             number, row->title);
    bool curves = strcmp(template, "curves.gp") == 0; /* the others name their own axes */
    if (curves)
        text_add(&script, " '%s' '%s' '%s'", figure_axes[row->x].label, figure_axes[row->y].label,
                 figure_axes[row->x].logarithmic ? figure_axes[row->y].logarithmic ? "xy" : "x" : "y");
    text_add(&script, " '%s'", text_string(&out->styles));
    /* One load axis for all, so that they compare. gnuplot reads '1.0e-06' from a string, but not '1e-06'. */
    if (curves && row->x == FIGURE_LOAD)
        text_add(&script, " '%.6e %.6e %.6e'", results->loads[0], results->loads[results->load_count - 1],
                 isfinite(out->floor) ? out->floor : 0);
    text_add(&script, "\n");
    text_add(&path, "%s/figures/%s.gp", directory, number);
    enum status_code rc = script.failed || path.failed
                              ? status_memory(status)
                              : text_write_file(text_string(&path), script.data, script.length, status);
    text_free(&script);
    text_free(&path);
    return rc;
}

static enum status_code write_figure(const struct figure_row *row, const struct results *results,
                                     const struct surface_record *baseline, const char *directory,
                                     struct status *status)
{
    struct figure_file out = {.row = row, .floor = INFINITY};
    struct text path = {0};
    text_add(&path, "%s/figures/%s.csv", directory, row->number);
    out.file = fopen(text_string(&path), "w");
    text_free(&path);
    if (!out.file)
        return status_fail(status, STATUS_IO, "cannot write figure %s: %s", row->number, strerror(errno));
    enum status_code rc = figure_data_put(&out, results, baseline, status);
    bool bad = ferror(out.file);
    if (fclose(out.file) != 0 || bad)
        rc = status_fail(status, STATUS_IO, "cannot write figure %s: %s", row->number, strerror(errno));
    if (rc == STATUS_OK)
        rc = write_script(&out, results, directory, status);
    text_free(&out.styles);
    return rc;
}

static enum status_code copy_template(const char *name, const char *templates, const char *directory,
                                      struct status *status)
{
    struct text from = {0}, to = {0}, content = {0};
    text_add(&from, "%s/%s", templates, name);
    text_add(&to, "%s/figures/%s", directory, name);
    enum status_code rc = text_read_file(&content, text_string(&from), status);
    if (rc == STATUS_OK)
        rc = text_write_file(text_string(&to), content.data, content.length, status);
    text_free(&from);
    text_free(&to);
    text_free(&content);
    return rc;
}

enum status_code figure_write_all(const struct results *results, const char *directory, const char *templates,
                                  struct status *status)
{
    static const char *const files[] = {"style.gp",  "blocks.gp",   "axis.gp",    "legend.gp",
                                        "curves.gp", "profiles.gp", "spectra.gp", "cost.gp"};
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++)
        if (copy_template(files[i], templates, directory, status) != STATUS_OK)
            return status->code;
    struct surface_record baseline;
    if (surface_store_get(&baseline, results->store, results->baseline, status) != STATUS_OK)
        return status->code;
    enum status_code rc = STATUS_OK;
    for (size_t i = 0; i < figure_count && rc == STATUS_OK; i++)
        if (figure_present(&figure_rows[i], results))
            rc = write_figure(&figure_rows[i], results, &baseline, directory, status);
    surface_record_free(&baseline, false);
    return rc;
}

/** Moves the text charts from their files into `out`. */
static enum status_code collect_text(struct text *out, const struct results *results, const char *directory,
                                     struct status *status)
{
    enum status_code rc = STATUS_OK;
    for (size_t i = 0; i < figure_count && rc == STATUS_OK; i++) {
        if (!figure_rows[i].terminal || !figure_present(&figure_rows[i], results))
            continue;
        struct text path = {0};
        text_add(&path, "%s/figures/%s.txt", directory, figure_rows[i].number);
        rc = gnuplot_take_text(out, text_string(&path), status);
        text_free(&path);
    }
    return rc;
}

enum status_code figure_draw_all(const struct results *results, const char *directory, const char *terminal_size,
                                 struct text *terminal_text, double *seconds, struct status *status)
{
    struct text path = {0};
    struct gnuplot gnuplot;
    text_add(&path, "%s/figures", directory);
    enum status_code rc = gnuplot_start(&gnuplot, text_string(&path), status);
    text_free(&path);
    if (rc != STATUS_OK)
        return rc;
    for (size_t i = 0; i < figure_count; i++)
        if (figure_present(&figure_rows[i], results))
            gnuplot_send(&gnuplot, "load '%s.gp'", figure_rows[i].number);
    if (terminal_size)
        gnuplot_send(&gnuplot, "dumb_size = '%s'", terminal_size);
    for (size_t i = 0; terminal_size && i < figure_count; i++)
        if (figure_rows[i].terminal && figure_present(&figure_rows[i], results))
            gnuplot_send(&gnuplot, "load '%s.gp'", figure_rows[i].number);
    rc = gnuplot_finish(&gnuplot, status);
    *seconds = gnuplot.seconds;
    return rc == STATUS_OK && terminal_size ? collect_text(terminal_text, results, directory, status) : rc;
}
