/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The report: templates filled from the view; HTML made of the Markdown. */
#ifndef REPORT_REPORT_H
#define REPORT_REPORT_H

#include "base/text.h"
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

#endif
