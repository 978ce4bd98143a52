/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report/template.h"

#include <stdio.h>
#include <string.h>

enum { DEPTH_MOST = 16, NAME_MOST = 64 };

/** A render in progress: sections open, innermost last, and how many of them are not kept. */
struct render {
    const char *path;
    int line;
    char open[DEPTH_MOST][NAME_MOST];
    bool hidden[DEPTH_MOST];
    int depth, hiding;
};

static enum status_code fail(const struct render *render, struct status *status, const char *problem, const char *name)
{
    return status_fail(status, STATUS_IO, "%s:%d: %s '%s'", render->path, render->line, problem, name);
}

static enum status_code open_section(struct render *render, char kind, const char *name,
                                     const struct template_source *source, struct status *status)
{
    struct text value = {0};
    if (render->depth == DEPTH_MOST)
        return fail(render, status, "too many sections inside each other at", name);
    if (!source->field(&value, name, source->context)) {
        text_free(&value);
        return fail(render, status, "no field", name);
    }
    bool hidden = (value.length > 0) != (kind == '#');
    text_free(&value);
    snprintf(render->open[render->depth], NAME_MOST, "%s", name);
    render->hidden[render->depth++] = hidden;
    render->hiding += hidden;
    return STATUS_OK;
}

static enum status_code tag(struct text *out, struct render *render, const char *tag_text,
                            const struct template_source *source, struct status *status)
{
    char kind = tag_text[0];
    if (kind == '#' || kind == '^')
        return open_section(render, kind, tag_text + 1, source, status);
    if (kind == '/') {
        if (render->depth == 0 || strcmp(render->open[render->depth - 1], tag_text + 1) != 0)
            return fail(render, status, "section closed but not open:", tag_text + 1);
        render->hiding -= render->hidden[--render->depth];
        return STATUS_OK;
    }
    if (render->hiding == 0 && !source->field(out, tag_text, source->context))
        return fail(render, status, "no field", tag_text);
    return STATUS_OK;
}

enum status_code template_render(struct text *out, const char *source_text, const char *path,
                                 const struct template_source *source, struct status *status)
{
    struct render render = {.path = path, .line = 1};
    for (const char *p = source_text; *p;) {
        const char *open = strstr(p, "{{"), *end = open ? open : p + strlen(p);
        if (render.hiding == 0)
            text_add_bytes(out, p, (size_t)(end - p));
        for (; p < end; p++)
            render.line += *p == '\n';
        if (!open)
            break;
        const char *close = strstr(open, "}}");
        char name[NAME_MOST];
        if (!close || (size_t)(close - open) - 2 >= sizeof name)
            return fail(&render, status, "tag not closed at", "{{");
        snprintf(name, sizeof name, "%.*s", (int)(close - open) - 2, open + 2);
        if (tag(out, &render, name, source, status) != STATUS_OK)
            return status->code;
        p = close + 2;
        if (strchr("#^/", name[0]) && *p == '\n') { /* a section's tag alone on its line leaves no empty line */
            p++;
            render.line++;
        }
    }
    if (render.depth > 0)
        return fail(&render, status, "section not closed:", render.open[render.depth - 1]);
    return out->failed ? status_memory(status) : STATUS_OK;
}
