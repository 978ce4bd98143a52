/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report/report.h"

#include "report/html.h"
#include "report/section.h"
#include <string.h>

/** The parts of the report, in reading order. */
enum part { PART_FIRST_PAGE, PART_CHAPTER, PART_TRUST, PART_APPENDICES };

/** What goes before the first section of a part: a rule ends the first page (printed, it ends the sheet), and what
 * follows a second heading of the first level is folded (html.c). */
static const char *const part_starts[] = {
    [PART_FIRST_PAGE] = "",
    [PART_CHAPTER] = "---\n\n",
    [PART_TRUST] = "",
    [PART_APPENDICES] = "# Appendices\n\n",
};

/* A section needs its row here, in reading order, and its file. */
static const struct {
    enum part part;
    const struct section *section;
} sections[] = {
    {PART_FIRST_PAGE, &section_summary},  {PART_FIRST_PAGE, &section_answers},   {PART_FIRST_PAGE, &section_deciding},
    {PART_FIRST_PAGE, &section_limits},   {PART_CHAPTER, &section_surfaces},     {PART_CHAPTER, &section_material},
    {PART_CHAPTER, &section_convergence}, {PART_CHAPTER, &section_baseline},     {PART_CHAPTER, &section_beyond_thesis},
    {PART_CHAPTER, &section_joint},       {PART_CHAPTER, &section_all_surfaces}, {PART_TRUST, &section_direct},
    {PART_TRUST, &section_validity},      {PART_TRUST, &section_sensitivity},    {PART_TRUST, &section_repeats},
    {PART_TRUST, &section_measured},      {PART_APPENDICES, &section_checks},    {PART_APPENDICES, &section_cost},
    {PART_APPENDICES, &section_computed}, {PART_APPENDICES, &section_methods},   {PART_APPENDICES, &section_sources},
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
    enum part part = PART_FIRST_PAGE;
    for (size_t i = 0; i < sizeof sections / sizeof *sections; i++) {
        const struct section *section = sections[i].section;
        if ((context->brief && sections[i].part != PART_FIRST_PAGE) ||
            (section->called_for && !section->called_for(context)))
            continue;
        text_add(out, "%s%s", out->length > 0 ? "\n\n" : "",
                 sections[i].part != part ? part_starts[sections[i].part] : "");
        part = sections[i].part;
        section->write(out, context);
    }
    squeeze(out);
}

enum status_code report_write(const struct results *results, struct comparison *comparison,
                              const struct figure_list *figures, bool brief, const char *directory,
                              const char *templates, struct status *status)
{
    struct text markdown = {0}, html = {0};
    const struct section_context context = {results, comparison, &results->surfaces[results->baseline], figures, brief};
    report_markdown(&markdown, &context);
    comparison_free(comparison); /* before the page is made, which takes most memory of all */
    enum status_code rc = write_file(directory, "report.md", &markdown, status);
    if (rc == STATUS_OK)
        rc = html_render(&html, text_string(&markdown), results->scene->title, directory, templates, status);
    if (rc == STATUS_OK)
        rc = write_file(directory, "report.html", &html, status);
    text_free(&markdown);
    text_free(&html);
    return rc;
}
