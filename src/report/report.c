#include "report/report.h"

#include "base/number_format.h"
#include "base/version.h"
#include "chart/figure.h"
#include "report/html.h"
#include "report/section.h"
#include "report/template.h"
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
    section_caption(out, context, row);
    text_add(out, "](figures/%s.svg)", number);
    return true;
}

static bool field(struct text *out, const char *name, void *data)
{
    const struct section_context *context = data;
    const struct section_row *lists[] = {section_summary, section_tables, section_prose, section_cost, section_repeat};
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

/** Leaves one empty line where fields and figures that are absent left several. */
static void squeeze(struct text *markdown)
{
    size_t kept = 0, run = 0;
    for (size_t i = 0; i < markdown->length; i++) {
        run = markdown->data[i] == '\n' ? run + 1 : 0;
        if (run <= 2)
            markdown->data[kept++] = markdown->data[i];
    }
    if (markdown->data)
        markdown->data[kept] = '\0';
    markdown->length = kept;
}

enum status_code report_write(const struct results *results, const char *directory, const char *templates,
                              struct status *status)
{
    struct comparison study = {0};
    struct surface_record baseline = {0};
    struct text path = {0}, template = {0}, markdown = {0}, html = {0};
    struct section_context context = {results, &study, &baseline};
    struct template_source source = {field, &context};
    text_add(&path, "%s/report.md", templates);
    enum status_code rc = comparison_make(&study, results, status);
    if (rc == STATUS_OK)
        rc = surface_store_get(&baseline, results->store, results->baseline, status);
    if (rc == STATUS_OK)
        rc = text_read_file(&template, text_string(&path), status);
    if (rc == STATUS_OK)
        rc = template_render(&markdown, text_string(&template), text_string(&path), &source, status);
    squeeze(&markdown);
    if (rc == STATUS_OK)
        rc = write_file(directory, "report.md", &markdown, status);
    if (rc == STATUS_OK)
        rc = html_render(&html, text_string(&markdown), results->scene->title, directory, templates, status);
    if (rc == STATUS_OK)
        rc = write_file(directory, "report.html", &html, status);
    surface_record_free(&baseline, false);
    comparison_free(&study);
    text_free(&path);
    text_free(&template);
    text_free(&markdown);
    text_free(&html);
    return rc;
}
