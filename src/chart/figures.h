/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The report's charts: one row each in figures.c (docs/report.md, Figures). */
#ifndef CHART_FIGURES_H
#define CHART_FIGURES_H

#include "chart/gnuplot.h"
#include "chart/words.h"
#include "results/results.h"

enum { FIGURES_MOST = 16 };

/** Those that were drawn. */
struct figures {
    struct {
        const char *name; /* of its files */
        char numbers[64]; /* in chapter 6: "6-11 to 6-14"; "": none */
        bool terminal;    /* drawn with letters too */
    } figure[FIGURES_MOST];
    size_t count;
};

/** How they are drawn. */
struct figures_task {
    struct gnuplot *gnuplot;   /* works in DIRECTORY/figures */
    const char *directory;     /* of the report */
    const char *templates;     /* folder of the templates */
    const char *terminal_size; /* "columns,rows": the main ones are drawn as text too; NULL: not so */
    bool brief;                /* those of the first page alone */
    struct words *words;
    bool cost; /* that of what accuracy costs, once that is known, instead of all others */
};

/** Adds to `out`: writes DIRECTORY/figures/NAME.csv and NAME.gp of those that what ran calls for, and has gnuplot draw
 * each as SVG while this goes on: gnuplot_finish() says how that went. Errors: STATUS_IO, STATUS_MEMORY, those of
 * templates. */
MUST_CHECK enum status_code figures_draw(struct figures *out, const struct results *results,
                                         const struct figures_task *task, struct status *status);

/** Takes those drawn with letters, once gnuplot has finished. Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code figures_letters(struct text *out, const struct figures *figures, const char *directory,
                                            struct status *status);

#endif
