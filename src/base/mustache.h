/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mustache templates filled from a JSON tree, after the public specification (mustache.github.io), without lambdas. */
#ifndef BASE_MUSTACHE_H
#define BASE_MUSTACHE_H

#include "base/text.h"
#include <jansson.h>

/** How a template is filled. */
struct mustache {
    const json_t *view;
    /** Escapes the text of a {{variable}} for HTML, Markdown or gnuplot; NULL: as it is. */
    void (*escape)(struct text *out, const char *string);
    /** The text of partial `name`, owned by the context; NULL: none, which adds nothing. */
    const char *(*partial)(void *context, const char *name);
    void *context;
};

/** Adds `source`, called `name` in messages, filled in. Beyond the specification an empty text counts as false,
 * `first`, `last` and `more` say where an item of a list stands, where nothing else is called so, and {{name|3 um}}
 * shows an SI number with three digits in that unit, {least, most} or [least, most] as a range, {value, error} with ±;
 * {{name|4g}} is printf's. Errors: STATUS_USAGE with name and line (a tag that is not closed, a section that does not
 * end, endless partials) or with name (LIMIT_TEMPLATE_BYTES, LIMIT_TEMPLATE_STEPS, LIMIT_PAGE_BYTES); STATUS_MEMORY. */
MUST_CHECK enum status_code mustache_render(struct text *out, const char *source, const char *name,
                                            const struct mustache *how, struct status *status);

/** Templates and partials that are files of a folder, read on first use. Owned: mustache_folder_free(). */
struct mustache_folder {
    const char *path;
    const char *ending; /* ".md" */
    json_t *read;       /* name: text */
    struct status *status;
};
/** A mustache.partial of a `struct mustache_folder`. Errors, in its status: STATUS_IO (no such file), STATUS_USAGE (no
 * UTF-8, or a name that leads out of the folder). */
const char *mustache_folder_partial(void *folder, const char *name);
void mustache_folder_free(struct mustache_folder *folder);
/** Adds the template `name` of a folder, whose files are its partials. Errors: mustache_render()'s, STATUS_IO. */
MUST_CHECK enum status_code mustache_file(struct text *out, struct mustache_folder *folder, const char *name,
                                          const json_t *view, void (*escape)(struct text *out, const char *string));

#endif
