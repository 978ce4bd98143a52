/* The report: Markdown from templates/report.md, HTML from the Markdown. Every number in it comes from the results. */
#ifndef REPORT_REPORT_H
#define REPORT_REPORT_H

#include "base/text.h"
#include "results/results.h"

/** Writes report.md and report.html into `directory`, whose figures are drawn. Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code report_write(const struct results *results, const char *directory, const char *templates,
                                         struct status *status);

/** The compact table for a terminal: surface, Rq, alpha, gamma, beta, load to full contact of each model. */
void report_terminal_table(struct text *out, const struct results *results);

#endif
