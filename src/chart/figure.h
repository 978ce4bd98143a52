/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The report's figures: one row each in figure_rows.c; how they are drawn: drawing.h. */
#ifndef CHART_FIGURE_H
#define CHART_FIGURE_H

#include "chart/gnuplot.h"
#include "results/results.h"

enum figure_kind {
    FIGURE_SWEEP,    /* area against wavelength, the convergence study; a figure a model that stacks scales */
    FIGURE_MODELS,   /* the baseline surface, all models */
    FIGURE_SURFACES, /* all surfaces; a figure a model */
    FIGURE_PROFILES,
    FIGURE_SPECTRA,
    FIGURE_BENCHMARK,    /* error against time */
    FIGURE_DIRECT,       /* the baseline solved directly, with all models on the same surface */
    FIGURE_DIRECT_RATIO, /* these over the direct solution */
    FIGURE_PATCHES,      /* where it touches: a picture */
    FIGURE_SENSITIVITY,  /* the baseline against the shortest wavelength included, all models */
};

/** One row a figure, or a figure a model. */
struct figure_row {
    int number;       /* in chapter 6, of the first of them; 0: `name` */
    const char *name; /* of the file; with a model's name behind it where there is a figure a model */
    enum figure_kind kind;
    const char *section; /* of the report, that shows it: section.h */
    const char *title;   /* of FIGURE_SURFACES: made from x, y and the model */
    bool terminal;       /* drawn by report --show (of FIGURE_SURFACES: the first) */
    enum quantity x, y;
    enum quantity below;     /* over y, in a panel below where it was computed; QUANTITY_LOAD: no such panel */
    const char *below_label; /* what that panel shows */
    enum convergence_sweep sweep;
    enum benchmark_chart chart;
    bool beyond_thesis; /* FIGURE_MODELS: every model, not the thesis's alone */
};

/** Separation/sigma below which a chart cuts curves off that are shown adjusted as well. */
extern const double figure_lowest_separation;

extern const struct figure_row figure_rows[];
extern const size_t figure_row_count;

/** A figure of this report. */
struct figure {
    const struct figure_row *row;
    size_t model;    /* of a figure a model, else model_count */
    char number[64]; /* the file's name: "6-05" */
    char title[128];
    bool terminal;
    struct text letters; /* what draws it as text, once written */
    bool decides; /* one of the first page's: the criterion of all surfaces in the leading model, and its ratio to the
              direct solution */
};

/** Ending of its file: ".svg", or ".png" for a picture. */
const char *figure_extension(const struct figure_row *row);

/** The direct solution of the baseline; NULL: none. */
const struct direct_study *figure_direct(const struct results *results);

/** Those that what ran calls for, in the rows' order. Owned: figure_list_free(). */
struct figure_list {
    struct figure *figures;
    size_t count;
};

MUST_CHECK enum status_code figure_list_make(struct figure_list *out, const struct results *results,
                                             struct status *status);
/** Leaves the first page's figures alone. */
void figure_list_keep_deciding(struct figure_list *list);
void figure_list_free(struct figure_list *list);

/** Writes OUT/figures/NUMBER.csv and NUMBER.gp of every figure; with `terminal_size`, "columns,rows", the main ones are
 * to be drawn as text, too. Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code figure_write_all(struct figure_list *list, const struct results *results,
                                             const char *directory, const char *terminal_size, struct status *status);

/** Draws them all as SVG, and what is to be drawn as text into `terminal_text`: by one gnuplot, or two at once where
 * there are many figures and `jobs` (0: any number) allows. *seconds: their own time. Errors: STATUS_CHART, STATUS_IO.
 */
MUST_CHECK enum status_code figure_draw_all(const struct figure_list *list, const char *directory, unsigned jobs,
                                            struct text *terminal_text, double *seconds, struct status *status);

#endif
