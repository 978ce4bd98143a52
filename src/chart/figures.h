/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The report's charts: one row each in figures.c (docs/report.md, Figures). */
#ifndef CHART_FIGURES_H
#define CHART_FIGURES_H

#include "base/words.h"
#include "chart/gnuplot.h"
#include "results/results.h"

enum {
    FIGURES_MAPS = 2,
    FIGURES_MOST = 11 + FIGURES_MAPS + 2 * QUANTITY_COUNT,
    FIGURE_NAME = 32,
    FIGURE_FEW_POINTS = 200
};

/** What a chart's caption has to say of what is drawn in it. */
enum figure_note {
    FIGURE_BAND,            /* 95 % about a curve */
    FIGURE_OUTSIDE,         /* dashed, or a hollow mark: outside a model's range of validity */
    FIGURE_ADJUSTED,        /* a gap that is adjusted */
    FIGURE_SCALE_DEPENDENT, /* dotted */
    FIGURE_LAST_SCALE,      /* dotted, of the finest scale alone */
    FIGURE_CUT,             /* not drawn near full contact */
    FIGURE_DIRECT,          /* the direct solution, a model over it */
    FIGURE_FEW,             /* open: of fewer than FIGURE_FEW_POINTS points of the grid in contact */
    FIGURE_LAW,
    FIGURE_BINS,
    FIGURE_OPEN_BINS, /* which the law is not fitted to */
    FIGURE_KNEES,
    FIGURE_MEASURED, /* square: what was measured */
    FIGURE_LIMIT,
    FIGURE_BOUND,      /* open: no answer, but what it is at most or at least */
    FIGURE_UNADJUSTED, /* dot-dash: a gap that is not adjusted, beside the one that is */
    FIGURE_NOTES
};
extern const char *const figure_notes[]; /* as the view names them */

/** Those that were drawn. */
struct figures {
    struct {
        char name[FIGURE_NAME]; /* of its files */
        char numbers[64];       /* of its panels in chapter 6: "6-11 to 6-14"; "": none */
        unsigned notes;         /* bits of enum figure_note */
        bool terminal;          /* drawn with letters too */
        size_t map;             /* the surface that is one and one more; 0: a chart of curves */
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

/** "map-" and of a surface's name, which may be anything, what stands in any file's name: ASCII letters and digits, -
 * for others; cut to the size. */
void figures_map_name(char *out, size_t size, const char *surface);
/** Adds to `out`: writes DIRECTORY/figures/NAME.csv and NAME.gp of those that what ran calls for, and has gnuplot draw
 * each as SVG while this goes on: figures_finish() says how that went. Errors: STATUS_IO, STATUS_MEMORY, those of
 * templates. */
MUST_CHECK enum status_code figures_draw(struct figures *out, const struct results *results,
                                         const struct figures_task *task, struct status *status);

/** Waits for gnuplot, and takes what was drawn with letters. Errors: those of gnuplot_finish(); STATUS_CHART: a chart
 * is not drawn, though gnuplot did not complain; STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code figures_finish(struct text *letters, const struct figures *figures,
                                           const struct figures_task *task, struct status *status);

#endif
