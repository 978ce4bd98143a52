/* The data file of one figure: a block a curve. Private to src/chart. */
#ifndef CHART_FIGURE_DATA_H
#define CHART_FIGURE_DATA_H

#include "chart/figure.h"

/** One row an axis: its label, whether it is logarithmic, and the effect its quantity needs. */
struct figure_axis_row {
    const char *label;
    bool logarithmic;
    unsigned effect;
};
extern const struct figure_axis_row figure_axes[]; /* indexed by enum figure_axis */

/** A figure's data file being written, and the style words of its blocks. */
struct figure_file {
    FILE *file;
    struct text styles;
    const struct figure_row *row;
    size_t blocks;
    double floor; /* least resistance up to nearly_full_area; INFINITY: none so far */
};

/** Writes every block of the figure into `file`. Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code figure_data_put(struct figure_file *file, const struct results *results,
                                            const struct surface_record *baseline, struct status *status);

#endif
