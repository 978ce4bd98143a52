/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The HTML report: made from the Markdown one, charts inlined, in the skeleton templates/page.html. */
#ifndef REPORT_HTML_H
#define REPORT_HTML_H

#include "base/status.h"
#include "base/text.h"

/** Renders `markdown` (GitHub tables, no raw HTML) to one self-contained page in `out`.
 * Images `![alt](figures/x.svg)` become inline SVG read from `directory`/figures/x.svg, wrapped in <figure> with the
 * alt text as caption; identifiers inside each SVG are made unique, its white background dropped and its ink colour
 * (#222222) replaced by the page's, so that it follows light and dark (svg.h). Any other image leaves its alt text, a
 * link by another scheme than http, https or mailto its words. Headings get ids by GitHub's rule; those of sections and
 * subsections make the contents. `templates` is the directory of page.html, whose fields are {{title}}, {{contents}}
 * and {{body}}. Errors: STATUS_IO (a file cannot be read, a chart is not well-formed, an unknown field),
 * STATUS_MEMORY. */
MUST_CHECK enum status_code html_render(struct text *out, const char *markdown, const char *title,
                                        const char *directory, const char *templates, struct status *status);

#endif
