/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the scripts of all kinds of charts have in common. Private to src/chart/drawing*.c. */
#ifndef CHART_DRAWING_PARTS_H
#define CHART_DRAWING_PARTS_H

#include "chart/drawing.h"

enum { DRAWING_WIDTH = 680, DRAWING_TALL = 340 };

/** Adds `string` as gnuplot's double-quoted string, of at most `most` characters: beyond, its end is cut, or its middle
 * (`both_ends`), as names often differ at their end. It may come from outside: no character of it means anything there.
 */
void drawing_quote(struct text *out, const char *string, size_t most, bool both_ends);
/** Adds an axis label, which comes from the program and may hold gnuplot's _{} and ^{}; a terminal shows them without
 * the braces. */
void drawing_label(struct text *out, const char *label, bool letters);
/** Characters of a text in UTF-8, `most` where there are more. */
size_t drawing_characters(const char *string, size_t most);

/** Adds the settings all charts share, the canvas and the file it goes to. */
void drawing_canvas(struct text *out, const struct drawing *drawing, double height, const char *terminal_size);

enum drawing_axis_kind {
    DRAWING_LOG,
    DRAWING_ZERO,  /* linear, from 0 when nothing is negative */
    DRAWING_TIGHT, /* linear */
};

/** Range and tics of one axis. */
struct drawing_axis {
    char axis; /* x or y */
    enum drawing_axis_kind kind;
    double low, high; /* what the data need; low > high: nothing */
    double room;      /* left beyond them, as a fraction of the range */
    double most_tics;
    bool bare; /* without their numbers */
    bool letters;
};
/** Adds it. Returns where the axis begins and ends, as powers of ten on a logarithmic one. */
struct figure_extent drawing_axis(struct text *out, const struct drawing_axis *axis);

/** The words of a chart without data. */
extern const char drawing_nothing[];

/** Title, axis labels and legend below the data, for charts of one panel. */
struct drawing_frame {
    size_t entries, longest; /* of the legend, and of these in characters */
    double lower_panel;      /* height of a panel below the main one; 0: none */
};
/** Adds canvas and frame; *top: above the panel, *height: of the drawing. */
void drawing_frame(struct text *out, const struct drawing *drawing, const struct drawing_frame *frame,
                   const char *terminal_size, double *top, double *height);

/** All rows that the axes can show, without those of a panel below; low > high: none. */
void drawing_extents(const struct drawing *drawing, struct figure_extent *x, struct figure_extent *y);
bool drawing_can_show(const struct drawing *drawing, double x, double y);

/** Adds what begins the plot of block `b`: "data index B using COLUMNS with ". */
void drawing_plot(struct text *out, size_t b, const char *columns);

/* The kinds. */
void drawing_curves(struct text *out, struct drawing *drawing, const char *terminal_size);
void drawing_cost(struct text *out, struct drawing *drawing);
void drawing_profiles(struct text *out, struct drawing *drawing);
void drawing_spectra(struct text *out, struct drawing *drawing);
void drawing_patches(struct text *out, struct drawing *drawing);

#endif
