/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lines of a chart that lie under others: what of them is drawn in dashes over these. Private to src/chart. */
#ifndef CHART_FIGURE_HIDDEN_H
#define CHART_FIGURE_HIDDEN_H

#include "chart/drawing.h"
#include "chart/figure.h"

struct figure_file; /* figure_data.h */

/** A line that another may hide: inside its model's validity, or a step of a sweep. */
struct figure_line {
    size_t first, end; /* in figure_lines.points */
    char style[24];
};

enum { FIGURE_LINES = 16 }; /* more are not looked at */

/** Owned: figure_hidden_free(). */
struct figure_lines {
    struct figure_line line[FIGURE_LINES];
    size_t count;
    double (*points)[2]; /* of all of them */
    size_t point_count, capacity;
    bool failed; /* no memory for them */
};

/** Begins a line; its points follow by figure_hidden_keep(). */
void figure_hidden_begin(struct figure_lines *lines, const char *style);
void figure_hidden_keep(struct figure_lines *lines, double x, double y);

/** Adds a block for each line of which some lies under later ones on axes of these extents, with the stretches that do
 * (an empty line between two): to be drawn over these in dashes. Style: that of the line, `h`, how many hide it, how
 * many lie there together. */
void figure_hidden_put(struct figure_file *file, struct figure_extent x, struct figure_extent y, bool x_logarithmic,
                       bool y_logarithmic);

void figure_hidden_free(struct figure_lines *lines);

#endif
