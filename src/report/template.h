/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The report's fixed words live in templates/report.md; what is computed comes in by name.
 *   {{name}}                 the field's text
 *   {{#name}} ... {{/name}}  kept when the field is not empty
 *   {{^name}} ... {{/name}}  kept when it is
 * Sections nest. */
#ifndef REPORT_TEMPLATE_H
#define REPORT_TEMPLATE_H

#include "base/text.h"

/** Where fields come from: appends the text of `name` to `out`, or returns false when there is no such field. */
struct template_source {
    bool (*field)(struct text *out, const char *name, void *context);
    void *context;
};

/** Renders `source_text` (named `path` in messages). Errors: STATUS_IO with path and line: unknown field, section not
 * closed; STATUS_MEMORY. */
MUST_CHECK enum status_code template_render(struct text *out, const char *source_text, const char *path,
                                            const struct template_source *source, struct status *status);

#endif
