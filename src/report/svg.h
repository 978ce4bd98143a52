/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A chart as inline SVG: gnuplot's drawing reduced to what the page needs, and to nothing that could act or load. */
#ifndef REPORT_SVG_H
#define REPORT_SVG_H

#include "base/status.h"
#include "base/text.h"

enum { SVG_CURVES = 16 };

/** Curves of a drawing by their colours, but for greys: what is drawn in one colour is of one model or surface. Owned:
 * svg_curves_free(). */
struct svg_curves {
    unsigned count;
    struct {
        unsigned colour;  /* 0xrrggbb */
        struct text name; /* the legend's, HTML-escaped; empty: in none */
    } curve[SVG_CURVES];
};
void svg_curves_free(struct svg_curves *curves);

/** Adds the drawing `svg` (the content of file `path`, which messages name) to `out` as one <svg> element.
 * Elements and attributes are kept by a list of what gnuplot draws with; scripts, event attributes, styles, links and
 * references out of the drawing are not on it. Identifiers get the prefix "fig<number>." so that several drawings can
 * share a page. The white background is dropped, ink (#222222, black) becomes var(--ink) and white var(--paper), which
 * the page defines for light and dark; currentColor would not do, as gnuplot sets `color` on its groups.
 * What belongs to a curve gets the class "curve<k>", k = 1, 2, ... counting `curves`, which are added to. A text that
 * gnuplot lets a point show (`with labels hypertext`) becomes its <title>.
 * `label` (HTML-escaped) names the drawing for screen readers.
 * Errors: STATUS_IO with file and line when the drawing is not well-formed. */
MUST_CHECK enum status_code svg_inline(struct text *out, const struct text *svg, const char *path, unsigned number,
                                       const char *label, struct svg_curves *curves, struct status *status);

#endif
