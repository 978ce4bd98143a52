/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The HTML report: made from the Markdown one, charts inlined, in the skeleton templates/page.html. */
#ifndef REPORT_HTML_H
#define REPORT_HTML_H

#include "base/status.h"
#include "base/text.h"

/** Renders `markdown` (GitHub tables, no raw HTML) to one self-contained page in `out`. An image
 * `![alt](figures/x.svg)` becomes the picture directory/figures/x.svg, one that stands outside of words a <figure> with
 * the alt text as caption. Any other image leaves its alt text, a link by another scheme than http, https or mailto its
 * words. Sections make the contents. `templates` is the directory of page.html. Errors: STATUS_IO, those of the
 * template, STATUS_MEMORY. */
MUST_CHECK enum status_code html_render(struct text *out, const char *markdown, const char *title,
                                        const char *directory, const char *templates, struct status *status);

/** Adds the name by which a Markdown link leads to a heading of these words, tags apart: "all-surfaces". */
void html_anchor(struct text *out, const char *heading);

#endif
