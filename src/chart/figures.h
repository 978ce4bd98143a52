/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The report's charts: one row each in figures.c (docs/report.md, Figures). */
#ifndef CHART_FIGURES_H
#define CHART_FIGURES_H

#include "chart/asked.h"
#include "chart/chart.h"
#include "results/comparison.h"

/** Those that what ran calls for. Owned: figures_free(). */
struct figures {
    struct chart *chart;
    size_t count;
};

/** Fills them; brief: those of the first page alone. Errors: STATUS_MEMORY. */
MUST_CHECK enum status_code figures_make(struct figures *out, const struct results *results,
                                         const struct comparison *comparison, bool brief, struct status *status);
void figures_free(struct figures *figures);

/** Writes DIRECTORY/figures/NAME.csv and NAME.gp, and draws them as SVG; with `terminal_size`, "columns,rows", the main
 * ones as text too, into `letters`. *seconds: that gnuplot took. Errors: STATUS_CHART, STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code figures_draw(struct figures *figures, const char *directory, const char *templates,
                                         const char *terminal_size, struct text *letters, double *seconds,
                                         struct status *status);

/** The colour of the k-th surface shown, wherever it stands. */
const char *figures_surface_colour(size_t k);

#endif
