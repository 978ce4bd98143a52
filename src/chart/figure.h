/* The report's figures: one row each. C writes a figure's data and the line that draws it; the plot code is in
 * templates/ (*.gp). */
#ifndef CHART_FIGURE_H
#define CHART_FIGURE_H

#include "analysis/benchmark.h"
#include "chart/gnuplot.h"
#include "results/results.h"

enum figure_kind {
    FIGURE_SWEEP,    /* area against wavelength, the convergence study */
    FIGURE_MODELS,   /* the baseline surface, all models */
    FIGURE_SURFACES, /* one model, all surfaces */
    FIGURE_PROFILES,
    FIGURE_SPECTRA,
    FIGURE_COST, /* error against time */
};

enum figure_axis { FIGURE_LOAD, FIGURE_AREA, FIGURE_SEPARATION, FIGURE_ECR, FIGURE_TCR, FIGURE_WAVELENGTH };

struct figure_row {
    const char *number; /* "6-05": the file's name */
    enum figure_kind kind;
    enum figure_axis x, y;
    enum model_id model;          /* FIGURE_SURFACES, FIGURE_SWEEP (elastic or plastic) */
    enum convergence_sweep sweep; /* FIGURE_SWEEP */
    bool terminal;                /* drawn by report --show */
    const char *title;
    enum benchmark_chart cost; /* FIGURE_COST */
};

extern const struct figure_row figure_rows[];
extern const size_t figure_count;

/** The row of that number, NULL when there is none. */
const struct figure_row *figure_find(const char *number);

/** Is the figure called for by what ran? (family, effects, sweeps) */
bool figure_present(const struct figure_row *row, const struct results *results);

/** Writes OUT/figures/NUMBER.csv and NUMBER.gp of every figure that is present, and copies the templates they call
 * beside them. Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code figure_write_all(const struct results *results, const char *directory,
                                             const char *templates, struct status *status);

/** Draws them all: one gnuplot for every chart, as SVG and, when `terminal_size` is "columns,rows", also the main ones
 * as text into `terminal_text`. *seconds: gnuplot's own time. Errors: STATUS_CHART, STATUS_IO. */
MUST_CHECK enum status_code figure_draw_all(const struct results *results, const char *directory,
                                            const char *terminal_size, struct text *terminal_text, double *seconds,
                                            struct status *status);

#endif
