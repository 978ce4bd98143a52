/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One chart before it is drawn: its data, a block a curve, and the gnuplot script that draws them. Ranges, counts and
 * texts are reckoned here, so that gnuplot has nothing to work out and reads each row once or twice. Private to
 * src/chart, but for what draws a chart as text (figure.h, inspect). */
#ifndef CHART_DRAWING_H
#define CHART_DRAWING_H

#include "base/status.h"
#include "base/text.h"
#include "chart/look.h"

enum drawing_kind {
    DRAWING_CURVES,   /* against a load, an area or a wavelength */
    DRAWING_PROFILES, /* a row of panels a surface */
    DRAWING_SPECTRA,  /* a panel a surface */
    DRAWING_COST,     /* relative error against time, one line a method */
    DRAWING_PATCHES,  /* where two bodies touch: a picture */
};

/** Least and largest value drawn; low > high: none. */
struct figure_extent {
    double low, high;
};

enum { DRAWING_COLUMNS = 5 };

struct drawing_block {
    char style[32]; /* its style word: look.h */
    char legend[256];
    size_t first, end; /* its rows among the drawing's */
    /* reckoned: */
    struct look look;
    size_t rows; /* that the axes can show */
    double x_low, x_high, y_low, y_high, y_end;
};

/** Owned: drawing_free(). */
struct drawing {
    enum drawing_kind kind;
    char name[64]; /* of its files */
    char title[128], x_label[128], y_label[128], below_label[64];
    bool log_x, log_y;
    bool axes_given; /* the axes hold these at least; the y axis begins at y.low, and cuts what is below */
    struct figure_extent x, y, ratio; /* ratio: of the panel below */
    double unsure;                    /* left of this x the chart is shaded; 0: nowhere */
    double cell;                      /* DRAWING_PATCHES: side of the picture, in the unit of the data */

    struct drawing_block *block;
    size_t blocks, block_capacity;
    double (
        *row)[DRAWING_COLUMNS]; /* of all blocks; cells from the first NaN on are none, a row without any parts lines */
    size_t rows, row_capacity;
    bool failed; /* no memory for them */
};

void drawing_free(struct drawing *drawing);

/** Starts a curve. */
void drawing_begin(struct drawing *drawing, const char *style, const char *legend);
/** Adds a row of `count` cells to the curve begun last; 0: a gap in its line. */
void drawing_add(struct drawing *drawing, const double *cell, size_t count);

/** NAME.gp, which draws NAME.svg (or .png) from NAME.csv; with `terminal_size`, "columns,rows", what draws NAME.txt
 * with letters instead (DRAWING_CURVES only). To be called before drawing_thin(), as markers stand on points of their
 * own. Errors: STATUS_MEMORY. */
MUST_CHECK enum status_code drawing_script(struct text *out, struct drawing *drawing, const char *terminal_size,
                                           struct status *status);

/** Leaves out the points of curves that nobody would miss: a line of more than `drawing_whole` points keeps both ends,
 * both sides of its gaps and as many of its own points as bring the straight lines between them within
 * `drawing_tolerance` of each point left out. Sweeping cone, one pass: J. Sklansky and V. Gonzalez, Fast polygonal
 * approximation of digitized curves, Pattern Recognition 12 (1980) 327-331. */
void drawing_thin(struct drawing *drawing);
extern const size_t drawing_whole;
extern const double drawing_tolerance; /* in the drawing's own units, of which it is 680 wide */

/** NAME.csv: one block a curve, two blank lines between blocks; the first row of a block is its legend text. */
void drawing_data(struct text *out, const struct drawing *drawing);

#endif
