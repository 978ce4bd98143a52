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

/** Pads by characters, not bytes: names may be UTF-8. */
static void padded(struct text *out, const char *string, int width)
{
    int columns = 0;
    for (const char *p = string; *p && columns < width; p++)
        columns += ((unsigned char)*p & 0xC0) != 0x80;
    for (const char *p = string; *p; p++) {
        unsigned char c = (unsigned char)*p;
        text_add_bytes(out, c < 0x20 || c == 0x7f ? "?" : p, 1);
    }
    for (; columns < width; columns++)
        text_add_bytes(out, " ", 1);
}

void report_terminal_table(struct text *out, const struct results *results)
{
    static const char *const heads[MODEL_COUNT] = {"MS elastic", "MS plastic", "GW", "JG"};
    const struct plan *plan = results->plan;
    int width = 7;
    for (size_t k = 0; k < results->usable_count; k++) {
        int length = (int)strlen(results->spool->summaries[results->by_roughness[k]].scene->name);
        width = length > width ? length > 28 ? 28 : length : width;
    }
    text_add(out, "%*s", width + 72, "load to full contact, P/(An E')\n");
    padded(out, "surface", width);
    text_add(out, "  Rq [um]       alpha [SI]          gamma   b_GW   b_JG");
    for (int m = 0; m < MODEL_COUNT; m++)
        if (model_called_for((enum model_id)m, plan->families, plan->running))
            text_add(out, " %10s", heads[m]);
    text_add(out, "\n");
    for (size_t i = 0; i < results->spool->count; i++) {
        const struct surface_summary *s = &results->spool->summaries[i];
        if (!s->usable)
            continue;
        char alpha[40], gamma[40], beta[2][16];
        snprintf(alpha, sizeof alpha, "%.3g ± %.2g", s->law.alpha, s->law.alpha_error);
        snprintf(gamma, sizeof gamma, "%.3f ± %.3f", s->law.gamma, s->law.gamma_error);
        for (int b = 0; b < 2; b++) {
            const struct surface_model *model = &s->models[b == 0 ? MODEL_GW : MODEL_JG];
            snprintf(beta[b], sizeof beta[b], model->exists ? "%.2f" : "-", model->beta);
        }
        padded(out, s->scene->name, width);
        text_add(out, "  %7.4g %17s %15s %6s %6s", s->roughness.rq_m * 1e6, alpha, gamma, beta[0], beta[1]);
        for (int m = 0; m < MODEL_COUNT; m++)
            if (model_called_for((enum model_id)m, plan->families, plan->running))
                text_add(out, s->models[m].exists ? " %10.3g" : "          -", s->models[m].full_load);
        text_add(out, "\n");
    }
}
