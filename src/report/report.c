/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report/report.h"

#include "base/mustache.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/** Where a template of the user and its parts come from. */
struct folders {
    struct mustache_folder *own, *program;
    const char *base; /* of the user's template, which is no part of itself */
};

/** As mustache.partial: one that lies beside the user's template, else the program's. */
static const char *part_of_either(void *context, const char *name)
{
    struct folders *folders = context;
    OWNED(text_free) struct text beside = {0}, path = {0};
    text_add(&beside, "%s.md", name);
    text_add(&path, "%s/%s", folders->own->path, text_string(&beside));
    return strcmp(text_string(&beside), folders->base) != 0 && access(text_string(&path), F_OK) == 0
               ? mustache_folder_partial(folders->own, text_string(&beside))
               : mustache_folder_partial(folders->program, name);
}

/** Fills the user's own template. */
static enum status_code fill_own(struct text *out, const json_t *view, const struct report_options *options,
                                 struct mustache_folder *program, struct status *status)
{
    const char *slash = strrchr(options->template, '/'), *base = slash ? slash + 1 : options->template;
    OWNED(text_free) struct text path = {0};
    text_add_bytes(&path, slash ? options->template : ".", slash ? (size_t)(slash - options->template) : 1);
    OWNED(mustache_folder_free) struct mustache_folder own = {text_string(&path), "", NULL, status};
    struct folders folders = {&own, program, base};
    struct mustache how = {view, text_add_markdown_shown, part_of_either, &folders};
    const char *source = mustache_folder_partial(&own, base);
    return source ? mustache_render(out, source, options->template, &how, status) : status->code;
}

enum status_code report_markdown(struct text *out, json_t *view, const struct report_options *options,
                                 struct status *status)
{
    OWNED(mustache_folder_free) struct mustache_folder folder = {options->templates, ".md", NULL, status};
    json_object_set_new(view, "brief", json_boolean(options->brief));
    enum status_code rc = options->template ? fill_own(out, view, options, &folder, status)
                                            : mustache_file(out, &folder, "report", view, text_add_markdown_shown);
    text_squeeze(out);
    return rc;
}

enum status_code report_write(json_t *view, const struct report_options *options, const char *directory,
                              struct status *status)
{
    OWNED(text_free) struct text markdown = {0}, html = {0}, tree = {0};
    const char *title = json_string_value(json_object_get(view, "title"));
    if (report_markdown(&markdown, view, options, status) != STATUS_OK ||
        text_save(&markdown, status, "%s/report.md", directory) != STATUS_OK ||
        html_render(&html, text_string(&markdown), title, directory, options->templates, status) != STATUS_OK ||
        text_save(&html, status, "%s/report.html", directory) != STATUS_OK)
        return status->code;
    OWNED(memory_free) char *dumped = json_dumps(view, JSON_INDENT(1) | JSON_SORT_KEYS);
    text_add(&tree, "%s\n", dumped ? dumped : "");
    return text_save(&tree, status, "%s/view.json", directory);
}
