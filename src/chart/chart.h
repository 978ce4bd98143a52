/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A chart of one or more panels: its data, a block a curve, and the tree of names and numbers that its script in
 * templates/charts is filled from. Ranges, tics and places are reckoned here; how anything is drawn stands there. */
#ifndef CHART_CHART_H
#define CHART_CHART_H

#include "base/mustache.h"

/** What a chart draws of a curve, by its columns. */
enum chart_kind {
    CHART_LINE,   /* x, y */
    CHART_BAND,   /* x, y from, y to */
    CHART_POINTS, /* x, y */
    CHART_BARS,   /* x, y, y from, y to */
    CHART_DOTS,   /* x, y, x from, x to */
    CHART_KINDS
};

struct chart_curve {
    enum chart_kind kind;
    const char *legend; /* "": none; may come from outside; as long as the chart lives, as has: */
    const char *colour; /* "#rrggbb" */
    int dash;           /* gnuplot's dash type; 0: solid */
    int marker;         /* gnuplot's point type; 0: 7 */
    double width;       /* of a line; 0: 2 */
    unsigned notes;     /* for the caption, once it is drawn: bits of the caller's */
};

/** Least and largest value; low > high: none. */
struct chart_extent {
    double low, high;
};

enum { CHART_PANELS = 40, CHART_NAME = 32, CHART_TEXT = 160 };

struct chart_panel {
    char title[CHART_TEXT], x_label[CHART_TEXT], y_label[CHART_TEXT];
    bool log_x, log_y;
    bool alone;                     /* its axes are its own where the others share theirs */
    double unit[2];                 /* x's, y's: one of what the axis has, in what rows and marks are given in */
    int number;                     /* as the chart's, when it was begun */
    struct chart_extent x, y;       /* of the data; grown by curves */
    struct chart_extent y_most;     /* what is beyond is cut off; low > high: nothing */
    json_t *curves, *marks, *names; /* owned */
};

struct chart {
    char name[CHART_NAME]; /* of its files */
    int number;            /* of panels begun from here on, in chapter 6: 11 of figure 6-11; 0: none */
    bool shares;           /* all panels but those `alone` have one x and one y axis */
    double panel_height;   /* 0: as is usual; never less than a y axis's label takes */
    struct chart_panel panel[CHART_PANELS];
    size_t panels;
    unsigned notes; /* of all curves drawn */
    json_t *legend; /* owned */
    struct text data;
    size_t blocks, rows; /* curves with anything to see; rows of the one begun last */
    struct chart_curve curve;
    struct chart_extent own_x, own_y; /* of the curve begun last */
};

/** Starts a chart. Owned: chart_free(). */
struct chart chart_make(const char *name);
void chart_free(struct chart *chart);
/** Starts a panel, which curves and marks need, and returns it for its other members; beyond CHART_PANELS it replaces
 * the last. */
struct chart_panel *chart_panel(struct chart *chart, const char *title, const char *x_label, const char *y_label,
                                bool log_x, bool log_y);
/** Starts a curve in the last panel; one without rows is left out. */
void chart_curve(struct chart *chart, const struct chart_curve *curve);
/** Adds a row: as many numbers as its kind has columns. What the axes cannot show is left out. */
void chart_row(struct chart *chart, double x, double y, double from, double to);
/** Ends the curve begun last; chart_curve(), chart_panel() and chart_write() do so themselves. */
void chart_end(struct chart *chart);
/** A line across the panel begun last, at x (or y), with its name. */
void chart_mark(struct chart *chart, bool vertical, double at, const char *name);
/** A name on the y axis of the panel begun last, in place of numbers. */
void chart_name_row(struct chart *chart, double y, const char *name);
/** As mustache_escape: what may stand between single quotes of a script. */
void chart_escape(struct text *out, const char *string);
/** Adds the script that draws the chart, of the folder of templates, for files *.gp: charts/panels.gp, or with
 * `terminal_size`, "columns,rows", letters.gp. Errors: of templates, STATUS_MEMORY. */
MUST_CHECK enum status_code chart_script(struct text *out, struct chart *chart, struct mustache_folder *templates,
                                         const char *terminal_size);
/** Writes NAME.csv and NAME.gp into `directory`. Errors: the same, STATUS_IO. */
MUST_CHECK enum status_code chart_write(struct chart *chart, struct mustache_folder *templates, const char *directory);
#endif
