/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The report: Markdown section by section, HTML from the Markdown. Every number in it comes from the results. */
#ifndef REPORT_REPORT_H
#define REPORT_REPORT_H

#include "base/text.h"
#include "chart/figure.h"
#include "results/comparison.h"

/** Writes report.md and report.html into `directory`, whose `figures` are drawn; `comparison`, of the results, ends
 * here; brief: the first page alone. Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code report_write(const struct results *results, struct comparison *comparison,
                                         const struct figure_list *figures, bool brief, const char *directory,
                                         const char *templates, struct status *status);

struct section_context;
/** The report as Markdown: every section that is called for, in reading order. */
void report_markdown(struct text *out, const struct section_context *context);

/** The compact table for a terminal: surface, Rq, amplitude at one wavelength, gamma, beta, load to full contact of
 * each model. */
void report_terminal_table(struct text *out, const struct results *results);

/** The targets' and limits' sentences for a terminal, a line each; nothing where the scene has none. */
void report_terminal_answers(struct text *out, const struct results *results);
/** Names each surface that misses a limit, a line each, and returns how many lines those are. */
size_t report_missed_limits(struct text *out, const struct results *results);

#endif
