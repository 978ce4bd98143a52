/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves against a load, an area or a wavelength. A curve is solid where its model is valid and dashed outside; of what
 * lies under others dashes are drawn over these; the first two intervals of a mean are filled, more are bars. The steps
 * of a sweep are labelled at their ends. A row whose y is 0 on a logarithmic axis ends its curve at the chart's lower
 * edge. */
#include "chart/drawing_parts.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/** What is drawn of a block. */
struct role {
    bool solid, dashed, marked, entry, end;
    bool filled, bars;   /* the interval of a mean */
    bool measured;       /* with error bars */
    bool point;          /* a single one */
    bool below;          /* in the panel below */
    bool steps_back;     /* its adjusted curve stands beside it */
    bool point_in_entry; /* the legend shows it as a single point */
    bool zero;           /* ends with a row of 0 on a logarithmic axis */
    size_t number;       /* of the curve, one a stem: its letter in text, the stagger of its markers otherwise */
};

struct curves {
    struct text *out;
    const struct drawing *drawing;
    struct role *role;
    bool letters; /* as text */
    bool any_band, any_bars, any_covered, any_dashed, few, swept, any_below;
    const char *note_band;
    double lowest; /* the chart's lower edge, of a logarithmic axis */
};

enum { LEGEND_MOST = 60 };
static const char note_bars[] = "the same, as bars", note_covered[] = "colours in turn",
                  note_outside[] = "outside its validity", note_few[] = "small: outside validity";

static bool is_plain(const struct drawing_block *block)
{
    const struct look *look = &block->look;
    return !look->band && !look->hidden && !look->scaled && !look_in_bars(look);
}

static bool same(const char *a, const char *b)
{
    return strcmp(a, b) == 0;
}

/** Has a block of this stem rows to show? */
static bool stem_shows(const struct drawing *drawing, const char *stem)
{
    for (size_t b = 0; b < drawing->blocks; b++)
        if (is_plain(&drawing->block[b]) && drawing->block[b].rows > 0 && same(drawing->block[b].look.stem, stem))
            return true;
    return false;
}

static bool stem_is_point(const struct drawing *drawing, const struct role *role, const char *stem)
{
    for (size_t b = 0; b < drawing->blocks; b++)
        if (role[b].point && same(drawing->block[b].look.stem, stem))
            return true;
    return false;
}

static int shape(const struct curves *curves, size_t b)
{
    return curves->role[b].steps_back ? -1 : curves->drawing->block[b].look.marker;
}

static double size_of(int shape)
{
    return shape < 0 ? 0.1 : shape % 2 ? 0.75 : 0.9;
}

/** As a single point: the marker of the curve, a cross for one that steps back. */
static int alone(const struct curves *curves, size_t b)
{
    const struct look *look = &curves->drawing->block[b].look;
    return curves->role[b].steps_back ? (look->marker % 2 ? 2 : 1) : look_single(look);
}

static double width(const struct curves *curves, size_t b)
{
    return curves->role[b].steps_back ? 0.7 : curves->drawing->block[b].look.adjusted ? 2.6 : 2;
}

static void number_curves(struct curves *curves)
{
    const struct drawing *drawing = curves->drawing;
    size_t numbers = 0;
    for (size_t b = 0; b < drawing->blocks; b++) {
        const struct look *look = &drawing->block[b].look;
        for (size_t j = 0; j < b; j++) {
            const struct look *other = &drawing->block[j].look;
            if (same(other->base, look->base) && other->adjusted == look->adjusted)
                curves->role[b].number = curves->role[j].number;
        }
        if (curves->role[b].number == 0)
            curves->role[b].number = ++numbers;
    }
    for (size_t b = 0; b < drawing->blocks; b++)
        for (size_t j = 0; j < drawing->blocks; j++)
            if (drawing->block[j].look.adjusted && !drawing->block[b].look.adjusted &&
                same(drawing->block[b].look.base, drawing->block[j].look.base))
                curves->role[b].steps_back = true;
}

static void give_roles(struct curves *curves)
{
    const struct drawing *drawing = curves->drawing;
    size_t bands = 0;
    number_curves(curves);
    for (size_t b = 0; b < drawing->blocks; b++) {
        const struct drawing_block *block = &drawing->block[b];
        const struct look *look = &block->look;
        struct role *role = &curves->role[b];
        assert(look->colour);
        for (size_t i = block->first; i < block->end && drawing->log_y && !look->scaled; i++)
            role->zero = role->zero || drawing->row[i][1] == 0;
        role->below = look->scaled && block->rows > 0;
        role->filled = look->band && block->rows > 1 && bands++ < 2;
        role->bars = look->band && block->rows > 1 && !role->filled;
        role->measured = look_in_bars(look) && block->rows > 0;
        role->solid = is_plain(block) && block->rows > 1 && !look->outside;
        role->dashed = is_plain(block) && block->rows > 1 && look->outside;
        role->marked = role->solid && shape(curves, b) > 0;
        role->point = block->rows == 1 && !look->band && !look->hidden && !look->scaled && !same(look->base, "meas");
        curves->any_band = curves->any_band || (look->band && block->rows > 1);
        curves->any_bars = curves->any_bars || role->bars;
        curves->any_covered = curves->any_covered || look->hidden;
        curves->any_dashed = curves->any_dashed || role->dashed;
        curves->few = curves->few || (role->point && look->outside);
        curves->any_below = curves->any_below || role->below;
        if (look->band && block->rows > 1 && !same(block->legend, "band"))
            curves->note_band = block->legend;
    }
    for (size_t b = 0; b < drawing->blocks; b++) {
        const struct look *look = &drawing->block[b].look;
        bool named = is_plain(&drawing->block[b]) && !look->outside && stem_shows(drawing, look->stem);
        curves->role[b].entry = named && !curves->swept;
        curves->role[b].end = named && curves->swept;
        curves->role[b].point_in_entry = drawing->block[b].rows < 2 && stem_is_point(drawing, curves->role, look->stem);
    }
}

static void count_entry(struct drawing_frame *frame, const char *words)
{
    size_t length = drawing_characters(words, LEGEND_MOST);
    frame->entries++;
    frame->longest = length > frame->longest ? length : frame->longest;
}

static struct drawing_frame count_entries(const struct curves *curves)
{
    struct drawing_frame frame = {.longest = 1};
    for (size_t b = 0; b < curves->drawing->blocks; b++)
        if (curves->role[b].entry || curves->role[b].measured)
            count_entry(&frame, curves->drawing->block[b].legend);
    if (curves->any_band && !curves->letters)
        count_entry(&frame, curves->note_band);
    frame.entries += curves->any_bars && !curves->letters;
    if (curves->any_covered && !curves->letters)
        count_entry(&frame, note_covered);
    if (curves->any_dashed || curves->few)
        count_entry(&frame, curves->few ? note_few : note_outside);
    frame.lower_panel = curves->any_below && !curves->letters ? 130 : 0;
    return frame;
}

/* ---------------------------------------------------------------- labels at ends */

/** End of a curve on the axis, 0 to 1, and where its label stands. */
struct end_label {
    double at, label;
    size_t block;
};

static int compare_ends(const void *a, const void *b)
{
    const struct end_label *x = a, *y = b;
    return x->at != y->at ? (x->at > y->at) - (x->at < y->at) : (x->block > y->block) - (x->block < y->block);
}

/** Labels at the ends of a sweep's curves, kept apart, each with a stroke to its curve. */
static void add_end_labels(const struct curves *curves, struct figure_extent axis)
{
    static const double apart = 19.0 / DRAWING_TALL;
    const struct drawing *drawing = curves->drawing;
    struct end_label *end = calloc(drawing->blocks + 1, sizeof *end);
    size_t count = 0, longest = 1;
    curves->out->failed = curves->out->failed || !end;
    for (size_t b = 0; b < drawing->blocks && end; b++) {
        const struct drawing_block *block = &drawing->block[b];
        if (!curves->role[b].end)
            continue;
        double y = drawing->log_y ? log10(block->y_end) : block->y_end;
        size_t length = drawing_characters(block->legend, LEGEND_MOST);
        longest = length > longest ? length : longest;
        end[count++] = (struct end_label){.at = (y - axis.low) / (axis.high - axis.low), .block = b};
    }
    if (count > 0) {
        qsort(end, count, sizeof *end, compare_ends);
        text_add(curves->out, "set rmargin at screen %.17g\n", 1 - (34 + 8.2 * (double)longest) / DRAWING_WIDTH);
        for (size_t k = 0; k < count; k++)
            end[k].label = k > 0 ? fmax(end[k].at, end[k - 1].label + apart) : end[k].at;
        end[count - 1].label = fmin(end[count - 1].label, 1);
        for (size_t k = count - 1; k > 0; k--)
            end[k - 1].label = fmin(end[k - 1].label, end[k].label - apart);
    }
    for (size_t k = 0; k < count; k++) {
        const struct drawing_block *block = &drawing->block[end[k].block];
        text_add(curves->out,
                 "set arrow from graph 1.005, graph %.17g to graph 1.035, graph %.17g nohead lw 1.2 lc rgb '%s'\n"
                 "set label ",
                 end[k].at, end[k].label, block->look.colour);
        drawing_quote(curves->out, block->legend, LEGEND_MOST, false);
        text_add(curves->out, " at graph 1.045, graph %.17g left noenhanced textcolor rgb '" LOOK_INK "'\n",
                 end[k].label);
    }
    free(end);
}

/* ---------------------------------------------------------------- markers */

/** Places of a curve's markers: nine or ten, staggered among neighbouring curves. */
static void marker_places(const struct curves *curves, size_t b, size_t *first, size_t *every)
{
    *every = (size_t)fmax(1, ceil((double)curves->drawing->block[b].rows / 9.0));
    *first = (size_t)((double)*every * (double)(curves->role[b].number % 4) / 4);
}

/** Places where a curve says its numbers when it is pointed at. */
static void spoken_places(const struct drawing_block *block, double parts, bool centred, size_t *first, size_t *every)
{
    *every = (size_t)fmax(1, ceil((double)block->rows / parts));
    *first = centred && *every / 2 > 0 ? *every / 2 - 1 : *every - 1;
}

/** Adds a data block of some rows of a block of the drawing. Is there any? */
static bool add_points(const struct curves *curves, const char *name, size_t b, size_t first, size_t every)
{
    const struct drawing *drawing = curves->drawing;
    const struct drawing_block *block = &drawing->block[b];
    bool any = false, log_y = drawing->log_y && !block->look.scaled;
    for (size_t i = block->first + first; i < block->end; i += every) {
        const double *row = drawing->row[i];
        if (isnan(row[0]) || (drawing->log_x && !(row[0] > 0)) || (log_y && !(row[1] > 0)))
            continue;
        if (!any)
            text_add(curves->out, "$%s%zu << EOD\n", name, b);
        any = true;
        for (size_t c = 0; c < 3 && !isnan(row[c]); c++)
            text_add(curves->out, "%s%.9g", c > 0 ? "," : "", row[c]);
        text_add(curves->out, "\n");
    }
    if (any)
        text_add(curves->out, "EOD\n");
    return any;
}

struct marks {
    bool marker, spoken, bars;
};

static void add_all_points(const struct curves *curves, struct marks *marks)
{
    for (size_t b = 0; b < curves->drawing->blocks; b++) {
        const struct role *role = &curves->role[b];
        const struct drawing_block *block = &curves->drawing->block[b];
        size_t first, every;
        marks[b] = (struct marks){0};
        marker_places(curves, b, &first, &every);
        if (role->marked || (role->below && !block->look.outside))
            marks[b].marker = add_points(curves, "marks", b, first, every);
        if (role->bars)
            marks[b].bars = add_points(curves, "bars", b, first, every);
        if (role->solid || role->point || role->measured) {
            spoken_places(block, role->solid ? 4 : 10, role->solid, &first, &every);
            marks[b].spoken = add_points(curves, "spoken", b, first, every);
        }
    }
}

/* ---------------------------------------------------------------- plots */

static void add_title(const struct curves *curves, const char *words)
{
    text_add(curves->out, " title ");
    drawing_quote(curves->out, words, LEGEND_MOST, false);
}

static void add_letters(const struct curves *curves)
{
    const struct drawing *drawing = curves->drawing;
    text_add(curves->out, "plot 1/0 notitle");
    for (int pass = 0; pass < 5; pass++)
        for (size_t b = 0; b < drawing->blocks; b++) {
            const struct role *role = &curves->role[b];
            if (pass == 0 ? role->solid : pass == 2 && role->point) {
                drawing_plot(curves->out, b, "1:2");
                text_add(curves->out, "points pt %zu notitle", role->number);
            } else if (pass == 1 && role->dashed) {
                text_add(curves->out, ", \\\n data index %zu every 4::1 using 1:2 with points pt %zu notitle", b,
                         role->number);
            } else if (pass == 3 && role->entry) {
                text_add(curves->out, ", \\\n keyentry with points pt %zu", role->number);
                add_title(curves, drawing->block[b].legend);
            } else if (pass == 4 && role->measured) {
                drawing_plot(curves->out, b, "1:2");
                text_add(curves->out, "points pt 15");
                add_title(curves, drawing->block[b].legend);
            }
        }
    text_add(curves->out, "\n");
}

/** The lines and areas of the chart. */
static void add_lines(const struct curves *curves)
{
    const struct drawing *drawing = curves->drawing;
    struct text *out = curves->out;
    char shown[64];
    snprintf(shown, sizeof shown, "1:($2 > 0 ? $2 : %.17g)", curves->lowest);
    for (size_t b = 0; b < drawing->blocks; b++)
        if (curves->role[b].filled) {
            drawing_plot(curves->out, b, "1:2:3");
            text_add(out, "filledcurves fc rgb '%s' fs transparent solid 0.2 noborder notitle",
                     drawing->block[b].look.colour);
        }
    for (size_t b = 0; b < drawing->blocks; b++)
        if (curves->role[b].dashed) {
            drawing_plot(curves->out, b, curves->role[b].zero ? shown : "1:2");
            text_add(out, "lines dt (7,4) lw %g lc rgb '%s' notitle", curves->role[b].steps_back ? 0.7 : 1.3,
                     drawing->block[b].look.colour);
        }
    for (size_t b = 0; b < drawing->blocks; b++)
        if (curves->role[b].solid) {
            drawing_plot(curves->out, b, curves->role[b].zero ? shown : "1:2");
            text_add(out, "lines lw %g lc rgb '%s' notitle", width(curves, b), drawing->block[b].look.colour);
        }
    for (size_t b = drawing->blocks; b-- > 0;) { /* of L under N lines dashes take N - L parts of N: all show in turn */
        const struct look *look = &drawing->block[b].look;
        if (!look->hidden)
            continue;
        drawing_plot(curves->out, b, "1:2");
        text_add(out, "lines lw 2 dt (%u,%u) lc rgb '%s' notitle", 8 * (look->together - look->covers),
                 8 * look->covers, look->colour);
    }
}

/** A few points a curve say their numbers when they are pointed at; names stay out of it, as gnuplot does not escape
 * them there. */
static void add_spoken(const struct curves *curves, size_t b)
{
    text_add(curves->out,
             ", \\\n $spoken%zu using 1:2:(sprintf('%%.4g, %%.4g', $1, $2)) with labels hypertext point pt 11 ps 1.4 "
             "lc rgb '#ff%s' notitle",
             b, curves->drawing->block[b].look.colour + 1);
}

static void add_markers(const struct curves *curves, const struct marks *marks)
{
    const struct drawing *drawing = curves->drawing;
    struct text *out = curves->out;
    for (size_t b = 0; b < drawing->blocks; b++)
        if (marks[b].bars)
            text_add(out, ", \\\n $bars%zu using 1:2:(0):($3 - $2) with vectors nohead lw 1.4 lc rgb '%s' notitle", b,
                     drawing->block[b].look.colour);
    for (size_t b = 0; b < drawing->blocks; b++)
        if (curves->role[b].marked && marks[b].marker)
            text_add(out, ", \\\n $marks%zu using 1:2 with points pt %d ps %g lw 1.3 lc rgb '%s' notitle", b,
                     shape(curves, b), size_of(shape(curves, b)), drawing->block[b].look.colour);
    for (size_t b = 0; b < drawing->blocks; b++)
        if (curves->role[b].point) {
            drawing_plot(curves->out, b, "1:2");
            text_add(out, "points pt %d ps %g lw 1.3 lc rgb '%s' notitle", alone(curves, b),
                     drawing->block[b].look.outside ? 0.6 : 1.1, drawing->block[b].look.colour);
        }
    for (size_t b = 0; b < drawing->blocks; b++)
        if (curves->role[b].solid && marks[b].spoken)
            add_spoken(curves, b);
    for (size_t b = 0; b < drawing->blocks; b++)
        if (!curves->role[b].solid && marks[b].spoken)
            add_spoken(curves, b);
}

static void add_entries(const struct curves *curves)
{
    const struct drawing *drawing = curves->drawing;
    struct text *out = curves->out;
    for (size_t b = 0; b < drawing->blocks; b++) {
        const struct role *role = &curves->role[b];
        int mark = role->point_in_entry ? alone(curves, b) : shape(curves, b);
        if (!role->entry)
            continue;
        text_add(out, ", \\\n keyentry with linespoints lw %g lc rgb '%s' pt %d ps %g", width(curves, b),
                 drawing->block[b].look.colour, mark, role->point_in_entry ? 0.9 : size_of(shape(curves, b)));
        add_title(curves, drawing->block[b].legend);
    }
    if (curves->any_dashed) {
        text_add(out, ", \\\n keyentry with lines dt (7,4) lw 1.3 lc rgb '" LOOK_QUIET "'");
        add_title(curves, curves->few ? note_few : note_outside);
    } else if (curves->few) {
        text_add(out, ", \\\n keyentry with points pt 7 ps 0.6 lc rgb '" LOOK_QUIET "'");
        add_title(curves, note_few);
    }
    if (curves->any_covered) {
        text_add(out, ", \\\n keyentry with lines dt (8,8) lw 2 lc rgb '" LOOK_INK "'");
        add_title(curves, note_covered);
    }
    if (curves->any_band) {
        text_add(out, ", \\\n keyentry with boxes fc rgb '" LOOK_QUIET "' fs transparent solid 0.3 noborder");
        add_title(curves, curves->note_band);
    }
    if (curves->any_bars) {
        text_add(out, ", \\\n keyentry with points pt '|' tc rgb '" LOOK_QUIET "'");
        add_title(curves, note_bars);
    }
    for (int pass = 0; pass < 2; pass++)
        for (size_t b = 0; b < drawing->blocks; b++) {
            const struct look *look = &drawing->block[b].look;
            if (!curves->role[b].measured)
                continue;
            drawing_plot(curves->out, b, pass == 0 ? "1:2" : "1:2:3:4");
            text_add(out, pass == 0 ? "lines lw 0.9 lc rgb '%s' notitle" : "yerrorbars lc rgb '%s'", look->colour);
            if (pass == 0)
                continue;
            text_add(out, " pt %d ps 0.9 lw 1.4", look->marker);
            add_title(curves, drawing->block[b].legend);
        }
}

/** The panel below: ratios, on the same x axis. */
static void add_lower_panel(const struct curves *curves, const struct marks *marks, struct figure_extent x, double top,
                            double height, double lower)
{
    const struct drawing *drawing = curves->drawing;
    struct text *out = curves->out;
    double low = 1, high = 1.01;
    for (size_t b = 0; b < drawing->blocks; b++)
        if (curves->role[b].below) {
            low = fmin(low, drawing->block[b].y_low);
            high = fmax(high, drawing->block[b].y_high);
        }
    if (drawing->axes_given && drawing->ratio.low <= drawing->ratio.high) {
        low = fmin(low, drawing->ratio.low);
        high = fmax(high, drawing->ratio.high);
    }
    text_add(out,
             "unset key; unset title; unset label; unset arrow; unset object\n"
             "set tmargin at screen %.17g; set bmargin at screen %.17g\n",
             1 - (top + DRAWING_TALL + 34) / height, 1 - (top + DRAWING_TALL + lower) / height);
    drawing_axis(out, &(struct drawing_axis){.axis = 'x',
                                             .kind = drawing->log_x ? DRAWING_LOG : DRAWING_ZERO,
                                             .low = x.low,
                                             .high = x.high,
                                             .most_tics = 8});
    text_add(out, "set xlabel ");
    drawing_label(out, drawing->x_label, false);
    text_add(out, "\nunset logscale y; set ytics autofreq\n");
    drawing_axis(out, &(struct drawing_axis){.axis = 'y',
                                             .kind = low > 0 && high > 5 * low ? DRAWING_LOG : DRAWING_TIGHT,
                                             .low = low,
                                             .high = high,
                                             .room = 0.06,
                                             .most_tics = 4});
    text_add(out, "unset xzeroaxis\nset ylabel 'ratio'\nset label 1 ");
    drawing_label(out, drawing->below_label, false);
    text_add(out, " at graph 0, graph 1 offset 0, 0.7 left noenhanced textcolor rgb '" LOOK_INK
                  "'\nplot 1 lt 1 lw 0.7 lc rgb '" LOOK_QUIET "' notitle");
    for (int solid = 0; solid < 2; solid++)
        for (size_t b = 0; b < drawing->blocks; b++)
            if (curves->role[b].below && drawing->block[b].look.outside == !solid) {
                drawing_plot(curves->out, b, "1:2");
                text_add(out, solid ? "lines lw 2 lc rgb '%s' notitle" : "lines dt (7,4) lw 1.3 lc rgb '%s' notitle",
                         drawing->block[b].look.colour);
            }
    for (size_t b = 0; b < drawing->blocks; b++)
        if (curves->role[b].below && marks[b].marker) {
            int marker = drawing->block[b].look.marker;
            text_add(out, ", \\\n $marks%zu using 1:2 with points pt %d ps %g lw 1.3 lc rgb '%s' notitle", b, marker,
                     marker < 0 ? 0.1 : 0.75, drawing->block[b].look.colour);
        }
    text_add(out, "\nunset multiplot\n");
}

/** The axes of the chart, and what stands on them. */
static void add_axes(struct curves *curves, struct figure_extent *x, double lower_panel)
{
    const struct drawing *drawing = curves->drawing;
    struct text *out = curves->out;
    struct figure_extent y;
    bool cut = false, log_y = drawing->log_y; /* cut: curves leave through the chart's lower edge */
    drawing_extents(drawing, x, &y);
    bool empty = x->low > x->high;
    if (drawing->axes_given && !empty) {
        *x = (struct figure_extent){fmin(x->low, drawing->x.low), fmax(x->high, drawing->x.high)};
        cut = y.low < drawing->y.low * (log_y ? 1 - 1e-5 : 1) - (log_y ? 0 : 1e-5 * (y.high - y.low));
        y = (struct figure_extent){drawing->y.low, fmax(y.high, drawing->y.high)};
    }
    drawing_axis(out, &(struct drawing_axis){.axis = 'x',
                                             .kind = drawing->log_x ? DRAWING_LOG : DRAWING_ZERO,
                                             .low = x->low,
                                             .high = x->high,
                                             .most_tics = curves->letters ? 6 : 8,
                                             .bare = lower_panel > 0,
                                             .letters = curves->letters});
    /* Where curves are cut the axis ends there: its room below is taken back. */
    double low = cut && !log_y && y.low < 0 ? (y.low + 0.04 * y.high) / 1.04 : y.low;
    struct figure_extent axis = drawing_axis(out, &(struct drawing_axis){.axis = 'y',
                                                                         .kind = log_y ? DRAWING_LOG : DRAWING_ZERO,
                                                                         .low = low,
                                                                         .high = y.high,
                                                                         .room = 0.04,
                                                                         .most_tics = curves->letters ? 5 : 7,
                                                                         .letters = curves->letters});
    curves->lowest = log_y && !empty ? pow(10, axis.low) : 0;
    if (empty)
        text_add(out, "%s", drawing_nothing);
    if (!log_y && !curves->letters)
        text_add(out, "set xzeroaxis lc rgb '" LOOK_QUIET "' lw 0.7 lt 1\n");
    if (curves->swept && !empty)
        add_end_labels(curves, axis);
    if (drawing->unsure > x->low && !empty && !curves->letters)
        text_add(out,
                 "set object 1 rectangle from graph 0, graph 0 to first %.9g, graph 1 behind fc rgb '" LOOK_QUIET
                 "' fs transparent solid 0.15 noborder\n",
                 fmin(drawing->unsure, x->high));
}

void drawing_curves(struct text *out, struct drawing *drawing, const char *terminal_size)
{
    struct curves curves = {.out = out,
                            .drawing = drawing,
                            .role = calloc(drawing->blocks + 1, sizeof *curves.role),
                            .letters = terminal_size,
                            .note_band = "95 % interval, scans of this length"};
    struct marks *marks = calloc(drawing->blocks + 1, sizeof *marks);
    struct figure_extent x;
    double top, height;
    curves.swept = drawing->blocks > 0 && drawing->block[0].style[0] == 'r' && !terminal_size;
    out->failed = out->failed || !curves.role || !marks;
    if (!out->failed) {
        give_roles(&curves);
        struct drawing_frame frame = count_entries(&curves);
        drawing_frame(out, drawing, &frame, terminal_size, &top, &height);
        if (frame.lower_panel > 0)
            text_add(out, "set multiplot\n");
        add_axes(&curves, &x, frame.lower_panel);
        if (frame.lower_panel > 0)
            text_add(out, "set xlabel ''\nset lmargin at screen 0.15; set rmargin at screen 0.965\n");
        if (curves.letters)
            add_letters(&curves);
        else {
            add_all_points(&curves, marks);
            text_add(out, "plot 1/0 notitle");
            add_lines(&curves);
            add_markers(&curves, marks);
            add_entries(&curves);
            text_add(out, "\n");
            if (frame.lower_panel > 0)
                add_lower_panel(&curves, marks, x, top, height, frame.lower_panel);
        }
    }
    free(curves.role);
    free(marks);
}
