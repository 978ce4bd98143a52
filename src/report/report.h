/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The report: templates filled from the view; HTML made of the Markdown. */
#ifndef REPORT_REPORT_H
#define REPORT_REPORT_H

#include "base/text.h"
#include <jansson.h>

/** How a report is written. */
struct report_options {
    const char *templates; /* folder of the templates */
    const char *template;  /* the user's own in place of report.md: a file; NULL: that */
    bool brief;            /* the first page alone */
};

/** Adds the report as Markdown. Errors: of the template (file, line), STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code report_markdown(struct text *out, json_t *view, const struct report_options *options,
                                            struct status *status);

/** Writes report.md, report.html and view.json into `directory`, whose figures are drawn. Errors: the same. */
MUST_CHECK enum status_code report_write(json_t *view, const struct report_options *options, const char *directory,
                                         struct status *status);

/** The first page's sentence and table for a terminal of 80 columns. Errors: the same. */
MUST_CHECK enum status_code report_terminal(struct text *out, const json_t *view, const char *templates,
                                            struct status *status);

#endif
