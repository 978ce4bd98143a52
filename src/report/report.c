/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report/report.h"

#include "base/mustache.h"
#include "report/html.h"
#include <stdlib.h>

/** Leaves one empty line where parts that are absent left several, and no blanks at the ends of lines. */
static void squeeze(struct text *markdown)
{
    size_t kept = 0, run = 2;
    for (size_t i = 0; i < markdown->length; i++) {
        char c = markdown->data[i];
        if (c == '\n')
            while (kept > 0 && markdown->data[kept - 1] == ' ')
                kept--;
        run = c == '\n' ? run + 1 : 0;
        if (run <= 2)
            markdown->data[kept++] = c;
    }
    if (markdown->data)
        markdown->data[kept] = '\0';
    markdown->length = kept;
}

enum status_code report_markdown(struct text *out, json_t *view, const struct report_options *options,
                                 struct status *status)
{
    struct mustache_folder folder = {options->templates, ".md", NULL, status};
    struct text own = {0};
    enum status_code rc;
    json_object_set_new(view, "brief", json_boolean(options->brief));
    if (options->template) {
        struct mustache how = {view, text_add_markdown_shown, mustache_folder_partial, &folder};
        rc = text_read_file(&own, options->template, status);
        if (rc == STATUS_OK)
            rc = mustache_render(out, text_string(&own), options->template, &how, status);
        text_free(&own);
    } else
        rc = mustache_file(out, &folder, "report", view, text_add_markdown_shown);
    mustache_folder_free(&folder);
    squeeze(out);
    return rc;
}

enum status_code report_write(json_t *view, const struct report_options *options, const char *directory,
                              struct status *status)
{
    struct text markdown = {0}, html = {0}, tree = {0};
    const char *title = json_string_value(json_object_get(view, "title"));
    enum status_code rc = report_markdown(&markdown, view, options, status);
    if (rc == STATUS_OK)
        rc = text_save(&markdown, status, "%s/report.md", directory);
    if (rc == STATUS_OK)
        rc = html_render(&html, text_string(&markdown), title, directory, options->templates, status);
    if (rc == STATUS_OK)
        rc = text_save(&html, status, "%s/report.html", directory);
    char *dumped = rc == STATUS_OK ? json_dumps(view, JSON_INDENT(1) | JSON_SORT_KEYS) : NULL;
    if (rc == STATUS_OK && !dumped)
        rc = status_memory(status);
    if (rc == STATUS_OK) {
        text_add(&tree, "%s\n", dumped);
        rc = text_save(&tree, status, "%s/view.json", directory);
    }
    free(dumped);
    text_free(&tree);
    text_free(&markdown);
    text_free(&html);
    return rc;
}
