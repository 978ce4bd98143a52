/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The report: templates filled from the view; HTML made of the Markdown. */
#ifndef REPORT_REPORT_H
#define REPORT_REPORT_H

#include "base/text.h"
#include "scene/scene.h"
#include <jansson.h>

/** How a report is written. */
struct report_options {
    const char *templates; /* folder of the templates */
    const char *template; /* the user's own in place of report.md: a file, beside which its parts may lie; NULL: that */
    bool brief;           /* the first page alone */
};

/** Adds the report as Markdown. Errors: of the template (file, line), STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code report_markdown(struct text *out, json_t *view, const struct report_options *options,
                                            struct status *status);

/** Writes report.md, report.html and view.json into `directory`, whose figures are drawn. Errors: the same. */
MUST_CHECK enum status_code report_write(json_t *view, const struct report_options *options, const char *directory,
                                         struct status *status);

/** Adds templates/`name`.txt, filled, for a terminal of 80 columns or as Markdown: lines with tabs are rows of a table,
 * the first its head. Errors: the same. */
MUST_CHECK enum status_code report_terminal(struct text *out, const char *name, const json_t *view,
                                            const char *templates, bool markdown, struct status *status);

enum { REPORTS_COMPARED = 20 /* side by side at most; more are ranked alone */ };

/** Finished reports, by their directories, side by side: what templates/compare.txt is filled from, new
 * (docs/templates.md). Numbers are those of the first one's leading model at its operating load, of each with or
 * without hardness as it leads there; a surface is held
 * against that of its name in the first report that has it. Errors: STATUS_IO where a results.json cannot be read, is
 * damaged, another program's or larger than LIMIT_RESULTS_BYTES, or all together more than LIMIT_RESULTS_VALUES;
 * STATUS_SCAN where no number stands in two reports, or more differs than LIMIT_COMPARED; STATUS_MEMORY. */
MUST_CHECK enum status_code report_compare(json_t **out, char *const *paths, size_t count, struct status *status);

/* ---- HTML, made from Markdown: charts inlined, in the skeleton templates/page.html ---- */

/** Renders `markdown` (GitHub tables, no raw HTML) to one self-contained page in `out`. An image
 * `![alt](figures/x.svg)` becomes the picture directory/figures/x.svg, one that stands outside of words a <figure> with
 * the alt text as caption. Any other image leaves its alt text, a link by another scheme than http, https or mailto its
 * words. Sections make the contents. `templates` is the directory of page.html. Errors: STATUS_IO, those of the
 * template, STATUS_MEMORY. */
MUST_CHECK enum status_code html_render(struct text *out, const char *markdown, const char *title,
                                        const char *directory, const char *templates, struct status *status);

/** Adds the name by which a Markdown link leads to a heading of these words, tags apart: "all-surfaces". */
void html_anchor(struct text *out, const char *heading);

/* ---- OUT/export/: tables of conductance over pressure for other programs. Every file NAME.ENDING of templates/export
 * is a program NAME, filled for each surface from its item of the view's `exports` ---- */

/** Is there a template for every program that the scene names, and a material on every surface? Nothing is asked of a
 * scene that names none. Errors: STATUS_SCENE: a program that is not there (those there are), none named, a surface
 * without material; STATUS_IO: templates/export cannot be read. */
MUST_CHECK enum status_code export_check(const struct scene *scene, const char *templates, struct status *status);

/** Writes export/SURFACE.NAME.ENDING below `directory`, which has an export/, and names them in the view. Errors: of a
 * template, STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code export_write(json_t *view, const struct scene *scene, const char *templates,
                                         const char *directory, struct status *status);

#endif
