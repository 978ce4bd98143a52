/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a curve looks like, by its style word. Private to src/chart.
 *
 * A style word is a name: s1...s8 surfaces, two letters a model (its row in model.h), r1...r9 steps of a sweep, c1...c9
 * methods, `meas` what was measured, `dirl`, `diro` and `dirp` what was solved directly, `cf` the counterface; then
 * perhaps `a` (adjusted) or `S` (in the panel below), then perhaps `x` (outside the range of validity), `b` (the
 * interval of the mean) or `hLN` (what lies under L of the N lines that lie there together). What has no look of its
 * own (fit, fitx, bin, binx, line, knee, choice, patches) is drawn as the chart it stands in says. */
#ifndef CHART_LOOK_H
#define CHART_LOOK_H

#include <stdbool.h>

/** The ink is this one colour everywhere, so that a page can replace it. */
#define LOOK_INK   "#222222"
#define LOOK_QUIET "#808080"

struct look {
    char base[8], stem[12];     /* the name; with `a` or `S` */
    const char *colour;         /* NULL: no look of its own */
    int marker;                 /* gnuplot's point type; -1: none */
    bool adjusted, scaled;      /* `a`, `S` */
    bool outside, band, hidden; /* `x`, `b`, `hLN` */
    unsigned covers, together;  /* L, N */
};

struct look look_of(const char *style);
/** The marker of a curve that is a single point. */
int look_single(const struct look *look);
/** Is it drawn as points with error bars, joined in their order? */
bool look_in_bars(const struct look *look);

#endif
