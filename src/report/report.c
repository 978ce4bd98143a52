#include "report/report.h"

#include "base/version.h"
#include "chart/figure.h"
#include "report/html.h"
#include "report/section.h"
#include "report/template.h"
#include "report/words.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/** Sections of the template that stand or fall with what ran. */
static bool flag(const char *name, const struct plan *plan, bool *on)
{
    const struct {
        const char *name;
        bool on;
    } flags[] = {
        {"multiscale", plan->families & SCENE_MODEL_MULTISCALE},
        {"statistical", plan->families & SCENE_MODEL_STATISTICAL},
        {"plasticity", plan_runs(plan, EFFECT_PLASTICITY)},
        {"separation", plan_runs(plan, EFFECT_SEPARATION)},
        {"electrical", plan_runs(plan, EFFECT_ELECTRICAL)},
        {"thermal", plan_runs(plan, EFFECT_THERMAL)},
        {"scale_dependent", plan_runs(plan, EFFECT_SCALE_DEPENDENT)},
        {"convergence", plan_runs(plan, EFFECT_CONVERGENCE)},
    };
    for (size_t i = 0; i < sizeof flags / sizeof flags[0]; i++)
        if (strcmp(flags[i].name, name) == 0) {
            *on = flags[i].on;
            return true;
        }
    return false;
}

/** `figure 6-05`: the image with its caption, or nothing when the figure is not called for. */
static bool figure(struct text *out, const char *number, const struct section_context *context)
{
    const struct figure_row *row = figure_find(number);
    if (!row)
        return false;
    if (!figure_present(row, context->results))
        return true;
    text_add(out, "![");
    if (number[0] >= '0' && number[0] <= '9')
        text_add(out, "Figure %s. ", number);
    text_add(out, "%s", row->title);
    if (row->kind == FIGURE_MODELS) {
        text_add(out, ", surface ");
        words_surface(out, context->results, context->results->baseline);
    }
    text_add(out, ".](figures/%s.svg)", number);
    return true;
}

static bool field(struct text *out, const char *name, void *data)
{
    const struct section_context *context = data;
    const struct section_row *lists[] = {section_tables, section_prose, section_cost};
    bool on;
    if (flag(name, context->results->plan, &on)) {
        if (on)
            text_add(out, "yes");
        return true;
    }
    if (strcmp(name, "title") == 0) {
        text_add_markdown(out, context->results->scene->title);
        return true;
    }
    if (strcmp(name, "version") == 0) {
        text_add(out, "%s", version_string());
        return true;
    }
    if (strncmp(name, "figure ", 7) == 0)
        return figure(out, name + 7, context);
    for (size_t l = 0; l < sizeof lists / sizeof lists[0]; l++)
        for (const struct section_row *row = lists[l]; row->name; row++)
            if (strcmp(row->name, name) == 0) {
                row->write(out, context);
                return true;
            }
    return false;
}

static enum status_code write_file(const char *directory, const char *name, const struct text *content,
                                   struct status *status)
{
    struct text path = {0};
    if (content->failed)
        return status_memory(status);
    text_add(&path, "%s/%s", directory, name);
    enum status_code rc = text_write_file(text_string(&path), content->data, content->length, status);
    text_free(&path);
    return rc;
}

enum status_code report_write(const struct results *results, const char *directory, const char *templates,
                              struct status *status)
{
    struct study study;
    struct surface_record baseline = {0};
    struct text path = {0}, template = {0}, markdown = {0}, html = {0};
    struct section_context context = {results, &study, &baseline};
    struct template_source source = {field, &context};
    text_add(&path, "%s/report.md", templates);
    enum status_code rc = study_make(&study, results, status);
    if (rc == STATUS_OK)
        rc = spool_get(&baseline, results->spool, results->baseline, status);
    if (rc == STATUS_OK)
        rc = text_read_file(&template, text_string(&path), status);
    if (rc == STATUS_OK)
        rc = template_render(&markdown, text_string(&template), text_string(&path), &source, status);
    if (rc == STATUS_OK)
        rc = write_file(directory, "report.md", &markdown, status);
    if (rc == STATUS_OK)
        rc = html_render(&html, text_string(&markdown), results->scene->title, directory, templates, status);
    if (rc == STATUS_OK)
        rc = write_file(directory, "report.html", &html, status);
    surface_record_free(&baseline, false);
    text_free(&path);
    text_free(&template);
    text_free(&markdown);
    text_free(&html);
    return rc;
}

/** Columns that `string` takes on a terminal: its characters. */
static int columns_of(const char *string)
{
    int columns = 0;
    for (; *string; string++)
        columns += ((unsigned char)*string & 0xC0) != 0x80;
    return columns;
}

/** Pads by characters, not bytes: names may be UTF-8. */
static void padded(struct text *out, const char *string, int width)
{
    struct text shown = {0};
    text_add_shown(&shown, string);
    int columns = columns_of(text_string(&shown));
    text_add(out, "%s%*s", text_string(&shown), columns < width ? width - columns : 0, "");
    text_free(&shown);
}

static bool shows(const struct plan *plan, int model)
{
    return model_called_for((enum model_id)model, plan->families, plan->running);
}

/** Two lines: the second names the columns, the first what the last of them have in common. */
static void terminal_head(struct text *out, const struct plan *plan, int width)
{
    static const char *const betas[MODEL_COUNT] = {[MODEL_GW] = "b_GW", [MODEL_JG] = "b_JG"};
    static const char *const heads[MODEL_COUNT] = {"MS el.", "MS pl.", "GW", "JG"};
    struct text names = {0};
    int before = width + 32; /* the loads begin there */
    for (int m = 0; m < MODEL_COUNT; m++)
        if (betas[m] && shows(plan, m)) {
            text_add(&names, " %4s", betas[m]);
            before += 5;
        }
    for (int m = 0; m < MODEL_COUNT; m++)
        if (shows(plan, m))
            text_add(&names, " %7s", heads[m]);
    text_add(out, "%*sP/(An E') at full contact\n%-*s Rq, um    alpha [SI]     gamma%s\n", before, "", width, "surface",
             text_string(&names));
    text_free(&names);
}

static void terminal_row(struct text *out, const struct plan *plan, const struct surface_summary *s, int width)
{
    char alpha[40], gamma[40];
    snprintf(alpha, sizeof alpha, "%.2g±%.1g", s->law.alpha, s->law.alpha_error);
    snprintf(gamma, sizeof gamma, "%.2f±%.2f", s->law.gamma, s->law.gamma_error);
    padded(out, s->scene->name, width);
    text_add(out, " %6.3g %*s%s %*s%s", s->roughness.rq_m * 1e6, 13 - columns_of(alpha), "", alpha,
             9 - columns_of(gamma), "", gamma);
    for (int m = MODEL_GW; m <= MODEL_JG; m++)
        if (shows(plan, m))
            text_add(out, s->models[m].exists ? " %4.1f" : "    -", s->models[m].beta);
    for (int m = 0; m < MODEL_COUNT; m++)
        if (shows(plan, m))
            text_add(out, s->models[m].exists ? " %7.2g" : "       -", s->models[m].full_load);
    text_add(out, "\n");
}

void report_terminal_table(struct text *out, const struct results *results)
{
    int width = 7;
    for (size_t k = 0; k < results->usable_count; k++) {
        int length = columns_of(results->spool->summaries[results->by_roughness[k]].scene->name);
        width = length > width ? length > 28 ? 28 : length : width;
    }
    terminal_head(out, results->plan, width);
    for (size_t i = 0; i < results->spool->count; i++)
        if (results->spool->summaries[i].usable)
            terminal_row(out, results->plan, &results->spool->summaries[i], width);
}
