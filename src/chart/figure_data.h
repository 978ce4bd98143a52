/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The data of one figure: a block a curve. Private to src/chart. */
#ifndef CHART_FIGURE_DATA_H
#define CHART_FIGURE_DATA_H

#include "chart/figure_hidden.h"

/** A figure being made. Owned: figure_data_free(). */
struct figure_file {
    struct drawing drawing;
    const struct figure *figure;
    double load_scale;                /* of the surface drawn: P/(A_n E') to what the axis of loads stands in */
    double floor;                     /* least resistance up to nearly_full_area; INFINITY: none so far */
    struct figure_extent x, y, ratio; /* ratio: of the panel below */
    bool adjusted;                    /* an adjusted separation stands beside the model's own */
    struct figure_lines lines;
};

struct figure_file figure_data_start(const struct figure *figure);
void figure_data_free(struct figure_file *file);

/** Puts every block of `count` figures into their files. */
void figure_data_put(struct figure_file *files, size_t count, const struct results *results);

#endif
