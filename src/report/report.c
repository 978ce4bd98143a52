#include "report/report.h"

#include "report/html.h"
#include "report/section.h"
#include <string.h>

/* A section needs its row here, in reading order, and its file. */
static const struct section *const sections[] = {
    &section_summary,       &section_surfaces,     &section_material, &section_convergence, &section_baseline,
    &section_beyond_thesis, &section_correlations, &section_joint,    &section_direct,      &section_all_surfaces,
    &section_checks,        &section_sensitivity,  &section_repeats,  &section_measured,    &section_validity,
    &section_cost,          &section_computed,     &section_methods,  &section_sources,
};

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

/** Leaves one empty line where texts and figures that are absent left several. */
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

void report_markdown(struct text *out, const struct section_context *context)
{
    for (size_t i = 0; i < sizeof sections / sizeof *sections; i++)
        if (!sections[i]->called_for || sections[i]->called_for(context)) {
            if (out->length > 0)
                text_add(out, "\n\n");
            sections[i]->write(out, context);
        }
    squeeze(out);
}

enum status_code report_write(const struct results *results, const struct figure_list *figures, const char *directory,
                              const char *templates, struct status *status)
{
    struct comparison comparison = {0};
    struct surface_record baseline = {0};
    struct text markdown = {0}, html = {0};
    const struct section_context context = {results, &comparison, &baseline, figures};
    enum status_code rc = comparison_make(&comparison, results, status);
    if (rc == STATUS_OK)
        rc = surface_store_get(&baseline, results->store, results->baseline, status);
    if (rc == STATUS_OK) {
        report_markdown(&markdown, &context);
        rc = write_file(directory, "report.md", &markdown, status);
    }
    if (rc == STATUS_OK)
        rc = html_render(&html, text_string(&markdown), results->scene->title, directory, templates, status);
    if (rc == STATUS_OK)
        rc = write_file(directory, "report.html", &html, status);
    surface_record_free(&baseline, false);
    comparison_free(&comparison);
    text_free(&markdown);
    text_free(&html);
    return rc;
}
