/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mustache templates filled from a JSON tree, after the public specification (mustache.github.io), without lambdas. */
#ifndef BASE_MUSTACHE_H
#define BASE_MUSTACHE_H

#include "base/text.h"
#include <jansson.h>

/** How a template is filled. */
struct mustache {
    const json_t *view;
    /** Adds what a {{variable}} holds for the target: HTML, Markdown, gnuplot; NULL: as it is. */
    void (*escape)(struct text *out, const char *string);
    /** The text of partial `name`, owned by the context; NULL: there is none, and it stands for nothing. */
    const char *(*partial)(void *context, const char *name);
    void *context;
};

/** Adds `source`, which messages call `name`, filled. Besides what the specification says, an empty text counts as
 * false, and {{name|3 um}} is a number of SI with three digits in that unit, of {least, most} both, of {value, error}
 * the one ± the other; {{name|4g}} is as printf has it. Errors: STATUS_USAGE with name and line (a tag that is not
 * closed, a section that does not end, partials without end), with name what passes LIMIT_TEMPLATE_BYTES,
 * LIMIT_TEMPLATE_STEPS or LIMIT_PAGE_BYTES; STATUS_MEMORY. */
MUST_CHECK enum status_code mustache_render(struct text *out, const char *source, const char *name,
                                            const struct mustache *how, struct status *status);

/** Partials and templates as files of a folder, read when they are first asked for. Owned: mustache_folder_free(). */
struct mustache_folder {
    const char *path;
    const char *ending; /* ".md" */
    json_t *read;       /* name: text */
    struct status *status;
};
/** As mustache.partial, of a `struct mustache_folder`. Errors, in its status: STATUS_IO where the file is not there,
 * STATUS_USAGE where it is no text in UTF-8 or the name leads out of the folder. */
const char *mustache_folder_partial(void *folder, const char *name);
void mustache_folder_free(struct mustache_folder *folder);
/** Adds the template `name` of a folder, filled, with the folder's files as partials. Errors: as mustache_render(),
 * STATUS_IO. */
MUST_CHECK enum status_code mustache_file(struct text *out, struct mustache_folder *folder, const char *name,
                                          const json_t *view, void (*escape)(struct text *out, const char *string));

#endif
