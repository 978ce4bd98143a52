/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What accuracy costs: relative error against time, one line a method, the chosen setting ringed. An error below 1e-16
 * is none that double precision can show: its point stands on the lower edge, off the scale. */
#include "chart/drawing_parts.h"

#include <math.h>
#include <string.h>

static const double exact = 1e-16;
static const char note_exact[] = "on the lower edge: below 10⁻¹⁶";

static bool is_choice(const struct drawing_block *block)
{
    return strcmp(block->style, "choice") == 0;
}

/** Is there a row to show, be it off the scale? */
static bool shows(const struct drawing *drawing, const struct drawing_block *block)
{
    for (size_t i = block->first; i < block->end; i++)
        if (drawing->row[i][0] > 0 && isfinite(drawing->row[i][1]))
            return true;
    return false;
}

static void add_title(struct text *out, const char *words)
{
    text_add(out, " title ");
    drawing_quote(out, words, 60, false);
}

void drawing_cost(struct text *out, struct drawing *drawing)
{
    struct figure_extent x, y;
    struct drawing_frame frame = {.longest = 1};
    double top, height;
    bool off = false; /* points off the scale, which only the x axis makes room for */
    drawing_extents(drawing, &x, &y);
    bool empty = x.low > x.high;
    for (size_t b = 0; b < drawing->blocks; b++) {
        const struct drawing_block *block = &drawing->block[b];
        size_t length = drawing_characters(block->legend, 60);
        for (size_t i = block->first; i < block->end; i++) {
            const double *row = drawing->row[i];
            if (!(row[0] > 0 && row[1] < exact))
                continue;
            off = true;
            x = (struct figure_extent){fmin(x.low, row[0]), fmax(x.high, row[0])};
        }
        if (!shows(drawing, block))
            continue;
        frame.entries++;
        frame.longest = length > frame.longest ? length : frame.longest;
    }
    if (off) {
        size_t length = drawing_characters(note_exact, 60);
        frame.entries++;
        frame.longest = length > frame.longest ? length : frame.longest;
    }
    drawing_frame(out, drawing, &frame, NULL, &top, &height);
    if (empty)
        text_add(out, "%s", drawing_nothing);
    drawing_axis(out,
                 &(struct drawing_axis){
                     .axis = 'x', .kind = DRAWING_LOG, .low = x.low, .high = x.high, .room = 0.04, .most_tics = 8});
    struct figure_extent axis = drawing_axis(
        out, &(struct drawing_axis){
                 .axis = 'y', .kind = DRAWING_LOG, .low = y.low, .high = y.high, .room = 0.05, .most_tics = 8});
    char shown[80];
    snprintf(shown, sizeof shown, "1:($2 < %g ? %.17g : $2)", exact, y.low > y.high ? 1 : pow(10, axis.low));
    text_add(out, "plot 1/0 notitle");
    for (size_t b = 0; b < drawing->blocks; b++) {
        const struct drawing_block *block = &drawing->block[b];
        if (is_choice(block) || !shows(drawing, block))
            continue;
        drawing_plot(out, b, shown);
        text_add(out, "linespoints lw 1.4 lc rgb '%s' pt %d ps 0.75", block->look.colour, block->look.marker);
        add_title(out, block->legend);
    }
    for (int entry = 0; entry < 2; entry++)
        for (size_t b = 0; b < drawing->blocks; b++) {
            if (!is_choice(&drawing->block[b]) || !shows(drawing, &drawing->block[b]))
                continue;
            if (entry == 0) {
                drawing_plot(out, b, shown);
                text_add(out, "points pt 6 ps 2.4 lc rgb '" LOOK_INK "' notitle");
            } else {
                text_add(out, ", \\\n keyentry with points pt 6 ps 1.3 lc rgb '" LOOK_INK "'");
                add_title(out, drawing->block[b].legend);
            }
        }
    if (off) {
        text_add(out, ", \\\n keyentry with points pt 7 ps 0.75 lc rgb '" LOOK_QUIET "'");
        add_title(out, note_exact);
    }
    text_add(out, "\n");
}
