/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Charts of a panel a surface: profiles, spectra with their power laws, heights on normal-probability axes; and the
 * picture of where two bodies touch. */
#include "chart/drawing_parts.h"

#include <assert.h>
#include <math.h>
#include <string.h>

static bool is_style(const struct drawing_block *block, const char *style)
{
    return strcmp(block->style, style) == 0;
}

/** Canvas, the chart's title, and the label of all its y axes at `label_x` (share of the width). */
static void begin(struct text *out, const struct drawing *drawing, double height, double panels_middle, double label_x)
{
    drawing_canvas(out, drawing, height, NULL);
    text_add(out, "set multiplot\nunset key\nset label 1 ");
    drawing_quote(out, drawing->title, 80, false);
    text_add(out, " at screen 0.545, screen %.17g center noenhanced textcolor rgb '" LOOK_INK "'\nset label 2 ",
             1 - 16 / height);
    drawing_label(out, drawing->y_label, false);
    text_add(out, " at screen %g, screen %.17g center rotate textcolor rgb '" LOOK_INK "'\n", label_x,
             panels_middle / height);
    struct figure_extent x, y;
    drawing_extents(drawing, &x, &y);
    if (x.low > x.high)
        text_add(out, "%s", drawing_nothing);
}

static void add_margins(struct text *out, double top, double bottom, double left, double right)
{
    text_add(out,
             "set tmargin at screen %.5f; set bmargin at screen %.5f\n"
             "set lmargin at screen %.5f; set rmargin at screen %.5f\n",
             top, bottom, left, right);
}

static void add_x_label(struct text *out, const struct drawing *drawing, bool bare)
{
    text_add(out, "set xlabel ");
    drawing_label(out, bare ? "" : drawing->x_label, false);
    text_add(out, "\n");
}

/** The head of a panel: the name of what it shows. */
static void add_head(struct text *out, const struct drawing_block *block, bool narrow)
{
    text_add(out, "set label 3 ");
    drawing_quote(out, block->legend, narrow ? 36 : 80, narrow);
    text_add(out, " at graph 0, graph 1 offset 0, 0.7 left noenhanced textcolor rgb '" LOOK_INK "'\n");
}

/** What is said in a panel of the line over it. */
static void add_remark(struct text *out, const struct drawing_block *block)
{
    text_add(out, "set label 4 ");
    drawing_quote(out, block->legend, 36, false);
    text_add(out, " at graph 0.97, graph 0.07 right noenhanced textcolor rgb '" LOOK_INK "'\n");
}

void drawing_profiles(struct text *out, struct drawing *drawing)
{
    static const double gap_shared = 34, gap_apart = 66;
    struct figure_extent all_x, all_y;
    size_t rows = 0, first = drawing->blocks, row = 0;
    bool shared = true; /* one length axis, unless a profile is over five times as long as another */
    drawing_extents(drawing, &all_x, &all_y);
    for (size_t b = drawing->blocks; b-- > 0;)
        if (drawing->block[b].rows > 0) {
            const struct drawing_block *block = &drawing->block[b];
            shared = shared && 5 * (block->x_high - block->x_low) >= all_x.high - all_x.low;
            rows++;
            first = b;
        }
    bool empty = rows == 0;
    if (empty) {
        rows = 1;
        first = 0;
    }
    int columns = rows > 1 ? 2 : 1;
    double panel = rows > 1 ? 92 : 240, gap = shared ? gap_shared : gap_apart, heads = columns > 1 ? 22 : 0;
    double top = (drawing->title[0] ? 34 : 6) + heads, height = top + (double)rows * (panel + gap) + 66;
    begin(out, drawing, height, 66 + 0.5 * (double)rows * (panel + gap), 0.022);
    if (columns > 1)
        text_add(
            out,
            "set label 4 'each on its own height scale' at screen 0.32, screen %.17g center textcolor rgb '" LOOK_INK
            "'\nset label 5 'all on one scale' at screen 0.78, screen %.17g center textcolor rgb '" LOOK_INK "'\n",
            1 - (top - 8) / height, 1 - (top - 8) / height);
    for (size_t b = first; b < drawing->blocks; b++) {
        const struct drawing_block *block = &drawing->block[b];
        if (block->rows == 0 && !empty)
            continue;
        row++;
        for (int column = 1; column <= columns; column++) {
            bool one = column == 2; /* scale for all */
            add_margins(out, 1 - (top + (double)(row - 1) * (panel + gap) + gap) / height,
                        1 - (top + (double)row * (panel + gap)) / height, one ? 0.62 : 0.14,
                        columns > 1 && !one ? 0.53 : 0.965);
            drawing_axis(out, &(struct drawing_axis){.axis = 'x',
                                                     .kind = DRAWING_TIGHT,
                                                     .low = shared || one ? all_x.low : block->x_low,
                                                     .high = shared || one ? all_x.high : block->x_high,
                                                     .most_tics = columns > 1 ? 5 : 8});
            drawing_axis(out, &(struct drawing_axis){.axis = 'y',
                                                     .kind = DRAWING_TIGHT,
                                                     .low = one ? all_y.low : block->y_low,
                                                     .high = one ? all_y.high : block->y_high,
                                                     .room = 0.06,
                                                     .most_tics = rows > 1 ? 5 : 7});
            if ((shared || one) && row < rows)
                text_add(out, "set format x ''\n");
            add_x_label(out, drawing, row < rows);
            if (one)
                text_add(out, "unset label 3\n");
            else
                add_head(out, block, false);
            if (block->rows == 0)
                text_add(out, "plot 1/0 notitle\n");
            else if (block->rows == 1)
                text_add(out, "plot data index %zu using 1:2 with points pt 7 ps 0.5 lc rgb '%s' notitle\n", b,
                         block->look.colour);
            else
                text_add(out, "plot data index %zu using 1:2 with lines lw 1.1 lt %zu lc rgb '%s' notitle\n", b, b + 1,
                         block->look.colour);
            if (row == 1 && column == 1)
                text_add(out, "unset label 1; unset label 2; unset label 4; unset label 5\n");
        }
        if (empty)
            break;
    }
    text_add(out, "unset multiplot\n");
}

/** A grid of panels, one a block that has a look of its own, with the blocks that follow it up to the next of these. */
struct grid {
    const struct drawing *drawing;
    size_t panels, columns, rows;
    double top, panel, gap, height;
};

static bool begins_panel(const struct drawing_block *block)
{
    return block->look.colour != NULL;
}

static struct grid make_grid(const struct drawing *drawing, double extra)
{
    struct grid grid = {.drawing = drawing, .gap = 34, .top = drawing->title[0] ? 34 : 6};
    assert(drawing->blocks == 0 || begins_panel(&drawing->block[0]));
    for (size_t b = 0; b < drawing->blocks; b++)
        grid.panels += begins_panel(&drawing->block[b]);
    grid.columns = grid.panels > 1 ? 2 : 1;
    grid.rows = (grid.panels + grid.columns - 1) / grid.columns;
    grid.panel = (grid.panels > 1 ? 200 : 340) + extra;
    grid.height = grid.top + (double)grid.rows * (grid.panel + grid.gap) + 66;
    return grid;
}

/** The end of the blocks of the panel that begins with `b`. */
static size_t panel_end(const struct drawing *drawing, size_t b)
{
    do
        b++;
    while (b < drawing->blocks && !begins_panel(&drawing->block[b]));
    return b;
}

static double panel_top(const struct grid *grid, size_t p)
{
    size_t row = p / grid->columns;
    return 1 - (grid->top + (double)row * (grid->panel + grid->gap) + grid->gap) / grid->height;
}

static double panel_bottom(const struct grid *grid, size_t p)
{
    size_t row = p / grid->columns;
    return 1 - (grid->top + (double)(row + 1) * (grid->panel + grid->gap)) / grid->height;
}

/** The lines over the points of a panel: solid where fitted, dashed beyond. */
static void add_fit(struct text *out, const struct drawing_block *block, size_t b)
{
    if (block->rows < 2)
        return;
    drawing_plot(out, b, "1:2");
    text_add(out, "lines %s lc rgb '" LOOK_INK "' notitle",
             is_style(block, "fit") ? "lt 1 lw 1.6" : "lt 1 lw 1.1 dt (7,4)");
}

static bool is_bins(const struct drawing_block *block)
{
    return is_style(block, "bin") || is_style(block, "binx") || is_style(block, "line");
}

static int bin_marker(const struct drawing_block *block)
{
    return is_style(block, "line") ? 6 : 7;
}

static const char *bin_colour(const struct drawing_block *block)
{
    return is_style(block, "binx") ? LOOK_QUIET : LOOK_INK;
}

/** Decades over the law, of the bins. A bin far off the law is left out, not drawn at the edge; without a law there are
 * none. */
static void add_strip(struct text *out, const struct grid *grid, size_t p, size_t b, struct figure_extent x,
                      double left, double right)
{
    const struct drawing *drawing = grid->drawing;
    bool bare = p + grid->columns < grid->panels, law = false;
    double bottom = panel_bottom(grid, p);
    text_add(out, "unset label 3; unset label 4\n");
    add_margins(out, bottom + 62 / grid->height - 8 / grid->height, bottom, left, right);
    drawing_axis(out, &(struct drawing_axis){.axis = 'x',
                                             .kind = DRAWING_LOG,
                                             .low = x.low,
                                             .high = x.high,
                                             .room = 0.03,
                                             .most_tics = grid->columns > 1 ? 5 : 8,
                                             .bare = bare});
    add_x_label(out, drawing, bare);
    text_add(out,
             "unset logscale y\nset yrange [-0.3:0.3] noextend\nset ytics %s\nplot 0 lt 1 lw 1.1 lc rgb '" LOOK_INK
             "' notitle",
             p % grid->columns == 0 ? "('−0.2' -0.2, '0' 0, '0.2' 0.2)" : "('' -0.2, '' 0, '' 0.2)");
    for (size_t i = b + 1; i < panel_end(drawing, b); i++) {
        const struct drawing_block *block = &drawing->block[i];
        law = law || (is_style(block, "fit") && block->rows > 0);
        if (!law || !is_bins(block) || block->rows == 0)
            continue;
        drawing_plot(out, i, "1:5:(log10($4/$2))");
        text_add(out, "yerrorbars pt %d ps 0.3 lw 1 lc rgb '%s' notitle", bin_marker(block), bin_colour(block));
    }
    text_add(out, "\n");
}

void drawing_spectra(struct text *out, struct drawing *drawing)
{
    struct figure_extent x, y;
    bool strips = false;
    size_t p = 0;
    for (size_t b = 0; b < drawing->blocks; b++)
        strips = strips || is_bins(&drawing->block[b]);
    struct grid grid = make_grid(drawing, strips ? 60 : 0);
    double wide = 0.86 / (double)grid.columns;
    begin(out, drawing, grid.height, 66 + 0.5 * (double)grid.rows * (grid.panel + grid.gap), 0.03);
    drawing_extents(drawing, &x, &y);
    /* A point is a square as long as it is wide: strokes of one path take a fifth of the bytes of as many markers. */
    double dot = x.low <= x.high ? pow(10, 1.2 / (DRAWING_WIDTH * wide) * log10(x.high / x.low)) : 1;
    for (size_t b = 0; b < drawing->blocks; b = panel_end(drawing, b), p++) {
        const struct drawing_block *points = &drawing->block[b];
        double left = 0.13 + (double)(p % grid.columns) * wide, right = left + wide - 0.03;
        bool bare = p + grid.columns < grid.panels; /* only the outer panels carry numbers */
        add_margins(out, panel_top(&grid, p), panel_bottom(&grid, p) + (strips ? 62 / grid.height : 0), left, right);
        drawing_axis(out, &(struct drawing_axis){.axis = 'x',
                                                 .kind = DRAWING_LOG,
                                                 .low = x.low,
                                                 .high = x.high,
                                                 .room = 0.03,
                                                 .most_tics = grid.columns > 1 ? 5 : 8,
                                                 .bare = bare || strips});
        drawing_axis(out, &(struct drawing_axis){.axis = 'y',
                                                 .kind = DRAWING_LOG,
                                                 .low = y.low,
                                                 .high = y.high,
                                                 .room = 0.04,
                                                 .most_tics = 6,
                                                 .bare = p % grid.columns > 0});
        add_x_label(out, drawing, bare || strips);
        add_head(out, points, grid.columns > 1);
        text_add(out, "unset label 4\n");
        for (size_t i = b + 1; i < panel_end(drawing, b); i++)
            if (is_style(&drawing->block[i], "fit"))
                add_remark(out, &drawing->block[i]);
        text_add(out, "plot 1/0 notitle");
        if (points->rows > 0)
            text_add(out,
                     ", \\\n data index %zu using ($1*%.9g):2:($1*%.9g):(0) with vectors nohead lw 2.4 lc rgb '#20%s' "
                     "notitle",
                     b, 1 / dot, dot - 1 / dot, points->look.colour + 1);
        for (size_t i = b + 1; i < panel_end(drawing, b); i++) {
            const struct drawing_block *block = &drawing->block[i];
            if (is_bins(block) && block->rows > 0) {
                drawing_plot(out, i, "1:2:3:4");
                text_add(out, "yerrorbars pt %d ps 0.35 lw 1.2 lc rgb '%s' notitle", bin_marker(block),
                         bin_colour(block));
            } else if (is_style(block, "knee") && block->rows > 0) {
                drawing_plot(out, i, "1:($2*10**-0.35):(0):($2*(10**0.35-10**-0.35))");
                text_add(out, "vectors nohead lw 1.2 dt (3,3) lc rgb '" LOOK_QUIET "' notitle");
            } else if (is_style(block, "fit") || is_style(block, "fitx"))
                add_fit(out, block, i);
        }
        text_add(out, "\n");
        if (strips)
            add_strip(out, &grid, p, b, x, left, right);
        text_add(out, "unset label 1; unset label 2\n");
    }
    text_add(out, "unset multiplot\n");
}

/** Rows of contact, each a run of points, filled. No words in the picture: its caption has them. */
void drawing_patches(struct text *out, struct drawing *drawing)
{
    text_add(out,
             "reset\nset encoding utf8\nset datafile separator ','\n"
             "set terminal png medium size 640,640 background rgb '#ffffff'\nset output '%s.png'\n"
             "unset key; unset tics\nset border 15 lc rgb '" LOOK_QUIET
             "'\nset lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0\nset size square\n"
             "set xrange [0:%.6e]\nset yrange [0:%.6e]\nset style fill solid 1 noborder\n"
             "plot '%s.csv' every ::1 using (($1 + $2) / 2):(($3 + $4) / 2):1:2:3:4 with boxxyerror lc rgb '#1257D0'\n",
             drawing->name, drawing->cell, drawing->cell, drawing->name);
}
