/* The data file of one figure: a block a curve. Private to src/chart. */
#ifndef CHART_FIGURE_DATA_H
#define CHART_FIGURE_DATA_H

#include "chart/figure.h"

/** Least and largest value drawn; low > high: none. */
struct figure_extent {
    double low, high;
};

/** A line that another may hide: inside its model's validity, or a step of a sweep. */
struct figure_line {
    size_t first, end; /* in figure_file.points */
    char style[24];
};

enum { FIGURE_LINES = 16 };

/** A figure's data file being written, and the style words of its blocks. Owned: figure_data_free(). */
struct figure_file {
    FILE *file;
    struct text styles;
    const struct figure *figure;
    size_t blocks;
    double floor;                     /* least resistance up to nearly_full_area; INFINITY: none so far */
    struct figure_extent x, y, ratio; /* ratio: of the panel below */
    bool adjusted;                    /* an adjusted separation stands beside the model's own */
    struct figure_line lines[FIGURE_LINES];
    size_t line_count;
    double (*points)[2]; /* of these lines */
    size_t point_count, capacity;
    bool failed; /* no memory for them */
};

struct figure_file figure_data_start(const struct figure *figure);
void figure_data_free(struct figure_file *file);

/** The model that used this surface's heights; model_count: none did. */
size_t figure_data_heights_model(const struct surface_summary *summary);

/** Writes every block of the figure into `file`. Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code figure_data_put(struct figure_file *file, const struct results *results,
                                            const struct surface_record *baseline, struct status *status);

/** Adds a block for each line of which some lies under later ones on axes of these extents, with the stretches that do
 * (an empty line between two): to be drawn over these in dashes. Style: that of the line, `h`, how many hide it, how
 * many lie there together. */
void figure_data_put_hidden(struct figure_file *file, struct figure_extent x, struct figure_extent y,
                            bool x_logarithmic, bool y_logarithmic);

#endif
