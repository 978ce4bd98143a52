/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "chart/chart.h"

#include "base/number_format.h"
#include "output/json.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct chart_extent nothing = {INFINITY, -INFINITY};

/* The canvas, in the unit of the drawing, nearly a pixel of a page on a screen: of two panels side by side each is 300
 * wide. */
enum { WIDTH = 800, FONT = 15, LEFT = 90, LABEL = 76, RIGHT = 14, BELOW = 50, NUMBERS = 26, BETWEEN = 20 };
enum { LEGEND_ROW = 23, MARK_ROW = 18, NAME = 24 /* between a name on the y axis and its axis, and before it */ };
/* A letter of a wide font, as not everyone has the one asked for, and what stands before a legend's name. */
static const double LETTER = 8.2, SAMPLE = 47;

/* Of its value: of a narrower range, tics would have the same number in six digits. */
static const double narrowest = 1e-4;

static const struct {
    const char *name;
    size_t columns;
} kinds[CHART_KINDS] = {[CHART_LINE] = {"line", 2},
                        [CHART_BAND] = {"band", 3},
                        [CHART_POINTS] = {"points", 2},
                        [CHART_BARS] = {"bars", 4},
                        [CHART_DOTS] = {"dots", 4}};

struct chart chart_make(const char *name)
{
    struct chart out = {.legend = json_array()};
    snprintf(out.name, sizeof out.name, "%s", name);
    return out;
}

/** Takes the panel begun last away. */
static void drop_panel(struct chart *chart)
{
    const struct chart_panel *panel = &chart->panel[--chart->panels];
    json_decref(panel->curves);
    json_decref(panel->marks);
    json_decref(panel->names);
}

void chart_free(struct chart *chart)
{
    while (chart->panels > 0)
        drop_panel(chart);
    json_decref(chart->legend);
    text_free(&chart->data);
}

static struct chart_panel *last(struct chart *chart)
{
    return &chart->panel[chart->panels - 1];
}

/** A panel without curves goes. */
static void drop_empty(struct chart *chart)
{
    chart_end(chart);
    if (chart->panels > 0 && json_array_size(last(chart)->curves) == 0)
        drop_panel(chart);
}

struct chart_panel *chart_panel(struct chart *chart, const char *title, const char *x_label, const char *y_label,
                                bool log_x, bool log_y)
{
    drop_empty(chart);
    if (chart->panels == CHART_PANELS)
        drop_panel(chart);
    struct chart_panel *panel = &chart->panel[chart->panels++];
    *panel = (struct chart_panel){.unit = {1, 1},
                                  .number = chart->number,
                                  .log_x = log_x,
                                  .log_y = log_y,
                                  .x = nothing,
                                  .y = nothing,
                                  .y_most = nothing,
                                  .curves = json_array(),
                                  .marks = json_array(),
                                  .names = json_array()};
    snprintf(panel->title, sizeof panel->title, "%s", title);
    snprintf(panel->x_label, sizeof panel->x_label, "%s", x_label);
    snprintf(panel->y_label, sizeof panel->y_label, "%s", y_label);
    return panel;
}

static void join(struct chart_extent *all, const struct chart_extent *one)
{
    all->low = fmin(all->low, one->low);
    all->high = fmax(all->high, one->high);
}

static void reach(struct chart_extent *extent, double value)
{
    join(extent, &(struct chart_extent){value, value});
}

/** Characters of the longest text `key` in a list, of the items that have `only` (NULL: all); `least`: none is longer.
 */
static int longest(const json_t *list, const char *key, const char *only, int least)
{
    size_t i;
    json_t *item;
    json_array_foreach (list, i, item) {
        const int length = text_characters(json_string_value(json_object_get(item, key)));
        least = length > least && (!only || json_object_get(item, only)) ? length : least;
    }
    return least;
}

void chart_curve(struct chart *chart, const struct chart_curve *curve)
{
    chart_end(chart);
    chart->curve = *curve;
    chart->own_x = chart->own_y = nothing;
}

void chart_row(struct chart *chart, double x, double y, double from, double to)
{
    const struct chart_panel *panel = last(chart);
    bool across = chart->curve.kind == CHART_DOTS;
    const double other = panel->unit[!across];
    const double cell[] = {x / panel->unit[0], y / panel->unit[1], from / other, to / other};
    for (size_t c = 0; c < kinds[chart->curve.kind].columns; c++)
        if (!isfinite(cell[c]) || (cell[c] <= 0 && (c == 0 || (across && c > 1) ? panel->log_x : panel->log_y)))
            return;
    if (chart->rows++ == 0) {
        text_add(&chart->data, chart->blocks > 0 ? "\n\n# " : "# ");
        text_add_shown(&chart->data, chart->curve.legend);
        text_add(&chart->data, "\n");
    }
    for (size_t c = 0; c < kinds[chart->curve.kind].columns; c++) {
        text_add_bytes(&chart->data, ",", c > 0);
        number_digits(&chart->data, cell[c], 9);
        reach(c == 0 || (across && c > 1) ? &chart->own_x : &chart->own_y, cell[c]);
    }
    text_add(&chart->data, "\n");
}

/** Puts a curve into the legend, once a name and look. */
static void add_legend(struct chart *chart, json_t *curve)
{
    const char *title = json_string_value(json_object_get(curve, "title"));
    size_t i;
    json_t *known;
    json_array_foreach (chart->legend, i, known)
        if (strcmp(json_string_value(json_object_get(known, "title")), title) == 0)
            return;
    json_array_append(chart->legend, curve);
}

void chart_end(struct chart *chart)
{
    const struct chart_curve *curve = &chart->curve;
    if (chart->rows == 0)
        return;
    struct chart_panel *panel = last(chart);
    enum chart_kind kind = curve->kind == CHART_LINE && chart->rows == 1 ? CHART_POINTS : curve->kind;
    json_t *item =
        json_pack("{si sb ss si sf si sb so}", "index", (int)chart->blocks++, kinds[kind].name, 1, "colour",
                  curve->colour, "dash", curve->dash ? curve->dash : 1, "width", curve->width > 0 ? curve->width : 2.0,
                  "marker", curve->marker ? curve->marker : 7, "drawn_lines", kind == CHART_LINE || kind == CHART_BAND,
                  "title", json_shown(curve->legend));
    if (item && curve->legend[0])
        add_legend(chart, item);
    json_array_append_new(panel->curves, item);
    join(&panel->x, &chart->own_x);
    join(&panel->y, &chart->own_y);
    chart->notes |= curve->notes;
    chart->rows = 0;
}

void chart_mark(struct chart *chart, bool vertical, double at, const char *name)
{
    struct chart_panel *panel = last(chart);
    chart_end(chart);
    at /= panel->unit[!vertical];
    if (!isfinite(at) || (at <= 0 && (vertical ? panel->log_x : panel->log_y)))
        return;
    json_array_append_new(panel->marks, json_pack("{sb sf so}", vertical ? "vertical" : "horizontal", 1, "at", at,
                                                  "name", json_shown(name)));
    reach(vertical ? &panel->x : &panel->y, at);
}

void chart_name_row(struct chart *chart, double y, const char *name)
{
    struct chart_panel *panel = last(chart);
    OWNED(text_free) struct text label = {0};
    for (const char *c = name; *c; c++) /* gnuplot takes a tic's name for a format */
        text_add_bytes(&label, *c == '%' ? "%%" : c, *c == '%' ? 2 : 1);
    chart_end(chart);
    json_array_append_new(panel->names, json_pack("{sf so}", "at", y, "label", json_shown(text_string(&label))));
    reach(&panel->y, y - 0.4); /* room above for what is marked */
    reach(&panel->y, y + 0.9);
}

/** A tic's number: plain from 0.001 to 9999, else a power of ten; in ASCII on a terminal. */
static json_t *tick_label(double at, bool logarithmic, bool letters)
{
    double size = fabs(at);
    OWNED(text_free) struct text out = {0};
    if (letters)
        text_add(&out, "%.6g", at);
    else if (size == 0 || (size >= 0.99e-3 && size < 9.9e3) || !logarithmic)
        text_add(&out, "%s%.6g", at < 0 ? "−" : "", size);
    else {
        int power = (int)floor(log10(size) + 1e-9), digit = (int)lround(size / pow(10, power));
        if (digit != 1)
            text_add(&out, "%d·", digit);
        number_power_of_ten(&out, power);
    }
    return json_string(text_string(&out));
}

static void add_tick(json_t *ticks, double at, bool logarithmic, bool letters)
{
    json_array_append_new(ticks, json_pack("{sf so}", "at", at, "label", tick_label(at, logarithmic, letters)));
}

/** Of a logarithmic axis, whose ends may be too far apart for a quotient. */
static double decades_of(const struct chart_extent *extent)
{
    return fmin(log10(extent->high / extent->low), DBL_MAX_10_EXP - DBL_MIN_10_EXP);
}

/** Few tics: of a logarithmic axis 1, 2, 5 within two decades, then decades, or every so many of them. */
static json_t *ticks_of(const struct chart_extent *extent, bool logarithmic, bool letters, double most)
{
    json_t *ticks = json_array();
    if (logarithmic) {
        double decades = decades_of(extent);
        int step = (int)fmax(1, ceil(decades / most)), first = (int)floor(log10(extent->low));
        for (int power = first; power <= log10(extent->high); power++)
            for (int digit = 1; digit <= 5; digit += digit == 2 ? 3 : 1) {
                double at = digit * pow(10, power);
                bool wanted = digit == 1 ? (power % step + step) % step == 0 : decades <= 0.36 * most;
                if (wanted && at >= extent->low * (1 - 1e-9) && at <= extent->high * (1 + 1e-9))
                    add_tick(ticks, at, true, letters);
            }
        if (json_array_size(ticks) > 1)
            return ticks;
        json_array_clear(ticks);
    }
    double range = extent->high - extent->low, step = pow(10, floor(log10(range / most)));
    while (range / step > most)
        step *= range / step > 2.5 * most ? (range / step > 5 * most ? 10 : 5) : 2;
    double first = ceil(extent->low / step - 1e-9); /* beyond 2^53 itself plus 1 is itself */
    for (int i = 0; i <= most && first + i <= extent->high / step + 1e-9; i++)
        add_tick(ticks, (first + i) * step + 0.0, false, letters); /* no -0 */
    return ticks;
}

/** The range an axis shows: what is drawn and a little more. */
static struct chart_extent range_of(struct chart_extent data, bool logarithmic)
{
    if (!(data.low <= data.high))
        data = (struct chart_extent){logarithmic ? 0.1 : 0, 1};
    if (logarithmic) {
        double room = fmax(0.03 * decades_of(&data), data.high / data.low < 1.2 ? 0.15 : 0.02);
        return (struct chart_extent){fmax(data.low / pow(10, room), DBL_MIN), fmin(data.high * pow(10, room), DBL_MAX)};
    }
    double range = data.high - data.low, size = fmax(fabs(data.low), fabs(data.high));
    double room = range > narrowest * size ? 0.04 * range : fmax(0.1 * size, 1e-9);
    return (struct chart_extent){data.low - room, data.high + room};
}

/** Where things are, in the unit of the drawing, y downwards from the top. */
struct layout {
    size_t columns, rows, legend_columns;
    double wide, gap, panel, height; /* of a panel, between two, of a panel, of all */
    double above;                    /* a panel, below its title: for the names of marks */
    double top[CHART_PANELS];        /* of a row's panels */
    double legend_x, legend_y;       /* of the legend's corner, or of the middle of its upper side */
    bool legend_beside;              /* it stands where the last row has no panel */
    bool letters;                    /* on a terminal */
};

/** The label below a panel, unless the panel further down says the same. */
static const char *x_label_of(const struct chart *chart, size_t columns, size_t p)
{
    const char *own = chart->panel[p].x_label;
    return p + columns < chart->panels && strcmp(chart->panel[p + columns].x_label, own) == 0 ? "" : own;
}

/** Room for the longest name of marks across the panels. */
static double marks_width(const struct chart *chart, const char *across)
{
    int most = 0;
    for (size_t p = 0; p < chart->panels; p++)
        most = longest(chart->panel[p].marks, "name", across, most);
    return most > 0 ? LETTER * most + 8 : 0;
}

static struct layout layout_of(const struct chart *chart)
{
    struct layout out = {.columns = chart->panels > 1 ? 2 : 1};
    const size_t entries = json_array_size(chart->legend);
    const int name = longest(chart->legend, "title", NULL, 8);
    int label = 0;
    bool own = !chart->shares; /* axes of its own take each panel their room; shared ones are numbered at the first */
    double title = 10, y = 0;
    for (size_t p = 0; p < chart->panels; p++) {
        own = own || chart->panel[p].alone;
        title = chart->panel[p].title[0] ? 26 : title;
        label = (int)fmax(label, text_characters(chart->panel[p].y_label));
    }
    out.rows = (chart->panels + out.columns - 1) / out.columns;
    out.panel = chart->panel_height > 0 ? chart->panel_height : out.columns == 1 ? 260 : 110;
    out.panel = fmax(out.panel, LETTER * label); /* which is written upwards beside it */
    const double beside_panel = marks_width(chart, "horizontal");
    out.above = marks_width(chart, "vertical") > 0 ? MARK_ROW : 0;
    title += out.above;
    out.gap = (own ? LEFT + 4 : BETWEEN) + beside_panel;
    out.wide = (WIDTH - LEFT - RIGHT - beside_panel - (double)(out.columns - 1) * out.gap) / (double)out.columns;
    for (size_t row = 0; row < out.rows; row++) {
        bool labelled = false;
        for (size_t p = row * out.columns; p < (row + 1) * out.columns && p < chart->panels; p++)
            labelled = labelled || x_label_of(chart, out.columns, p)[0];
        out.top[row] = y + title;
        y += title + out.panel + (labelled ? BELOW : NUMBERS);
    }
    size_t last_row = chart->panels - (out.rows - 1) * out.columns, free = out.columns - last_row;
    double beside = LEFT + (double)last_row * (out.wide + out.gap) - (own ? 50 : 0); /* no numbers stand there */
    const size_t columns = (size_t)fmax(1, (WIDTH - 20) / (9.6 * name + 68)), rows = (entries + columns - 1) / columns;
    const double below = y + 4 + LEGEND_ROW * (double)rows,
                 beside_end = out.top[out.rows - 1] - 10 + LEGEND_ROW * (double)entries;
    out.legend_beside = entries > 0 && free > 0 && LETTER * name + SAMPLE <= WIDTH - beside && beside_end <= below;
    out.legend_columns = out.legend_beside ? 1 : columns;
    out.legend_x = out.legend_beside ? beside : WIDTH / 2.0;
    out.legend_y = out.legend_beside ? out.top[out.rows - 1] - 10 : y + 4;
    out.height = 4 + (entries == 0 ? y : out.legend_beside ? fmax(y, beside_end) : below + 4);
    return out;
}

/** Has the names of marks across x, above the panel, stay within it and beside one another: from the last one on, each
 * over its line, or ending where the next begins. `left` and `wide` are the panel's. */
static void align_marks(const struct chart_panel *panel, const struct chart_extent *x, double left, double wide)
{
    double end = wide;
    size_t i;
    json_t *mark;
    json_array_foreach (panel->marks, i, mark) {
        json_object_del(mark, "name_x");
    }
    for (;;) {
        json_t *next = NULL;
        double at = -INFINITY;
        json_array_foreach (panel->marks, i, mark) {
            const double own = json_number_value(json_object_get(mark, "at"));
            if (json_object_get(mark, "vertical") && !json_object_get(mark, "name_x") && own > at) {
                at = own;
                next = mark;
            }
        }
        if (!next)
            return;
        const double share =
            panel->log_x ? log(at / x->low) / log(x->high / x->low) : (at - x->low) / (x->high - x->low);
        const double name = LETTER * text_characters(json_string_value(json_object_get(next, "name")));
        const double start = fmin(share * wide - name / 2, end - name);
        json_object_set_new(next, "name_x", json_real((left + start) / WIDTH));
        end = start - LETTER;
    }
}

/** One panel's tree: place, axes, tics, curves. */
static json_t *panel_view(const struct chart *chart, const struct layout *layout, size_t p)
{
    const struct chart_panel *panel = &chart->panel[p];
    struct chart_extent x = panel->x, y = panel->y;
    for (size_t q = 0; chart->shares && !panel->alone && q < chart->panels; q++)
        if (!chart->panel[q].alone) {
            join(&x, &chart->panel[q].x);
            join(&y, &chart->panel[q].y);
        }
    if (panel->y_most.low <= panel->y_most.high)
        y = (struct chart_extent){fmax(y.low, panel->y_most.low), fmin(y.high, panel->y_most.high)};
    x = range_of(x, panel->log_x);
    y = range_of(y, panel->log_y);
    size_t row = p / layout->columns, column = p % layout->columns;
    bool bare = chart->shares && column > 0 && !panel->alone && !chart->panel[p - 1].alone; /* numbered before */
    double names = fmax(0, LETTER * longest(panel->names, "label", NULL, 0) + NAME - LEFT); /* more than numbers take */
    double left = LEFT + (double)column * (layout->wide + layout->gap), top = layout->top[row];
    align_marks(panel, &x, left + names, layout->wide - names);
    json_t *ticks = json_array_size(panel->names) > 0
                        ? json_incref(panel->names)
                        : ticks_of(&y, panel->log_y, layout->letters, layout->panel < 150 ? 4 : 6);
    json_t *x_ticks = ticks_of(&x, panel->log_x, layout->letters, layout->columns > 1 ? 5 : 8);
    return json_pack("{so so so sb sb sb sf sf sf sf sf sf sf sf so so sO sO sf sf sf}", "title",
                     json_shown(panel->title), "x_label", json_shown(x_label_of(chart, layout->columns, p)), "y_label",
                     json_shown(bare ? "" : panel->y_label), "log_x", panel->log_x, "log_y", panel->log_y, "bare", bare,
                     "x_low", x.low, "x_high", x.high, "y_low", y.low, "y_high", y.high, "left", (left + names) / WIDTH,
                     "right", (left + layout->wide) / WIDTH, "top", 1 - top / layout->height, "bottom",
                     1 - (top + layout->panel) / layout->height, "y_ticks", ticks, "x_ticks", x_ticks, "curves",
                     panel->curves, "marks", panel->marks, "title_y", 1 - (top - 12 - layout->above) / layout->height,
                     "mark_y", 1 - (top - 10) / layout->height, "y_label_x", (left - LABEL) / WIDTH);
}

void chart_escape(struct text *out, const char *string)
{
    for (; *string; string++)
        if (*string == '\'')
            text_add(out, "’");
        else if (strncmp(string, "]]>", 3) == 0) {
            text_add(out, "]]›");
            string += 2;
        } else
            text_add_bytes(out, string, 1);
}

enum status_code chart_script(struct text *out, struct chart *chart, struct mustache_folder *templates,
                              const char *terminal_size)
{
    drop_empty(chart);
    struct layout layout = layout_of(chart);
    layout.letters = terminal_size != NULL;
    json_auto_t *view = json_pack("{ss si sf si sb sO sb sI sf sf sb}", "name", chart->name, "width", WIDTH, "height",
                                  ceil(layout.height), "font", FONT, "letters", terminal_size != NULL, "legend",
                                  chart->legend, "has_legend", json_array_size(chart->legend) > 0, "legend_columns",
                                  (json_int_t)layout.legend_columns, "legend_x", layout.legend_x / WIDTH, "legend_y",
                                  1 - layout.legend_y / layout.height, "legend_beside", layout.legend_beside);
    json_t *panels = json_array();
    for (size_t p = 0; p < chart->panels; p++)
        json_array_append_new(panels, panel_view(chart, &layout, p));
    json_object_set_new(view, "panels", panels);
    json_object_set_new(view, "size", json_string(terminal_size ? terminal_size : ""));
    return mustache_file(out, templates, terminal_size ? "charts/letters" : "charts/panels", view, chart_escape);
}

enum status_code chart_write(struct chart *chart, struct mustache_folder *templates, const char *directory)
{
    OWNED(text_free) struct text script = {0};
    if (chart_script(&script, chart, templates, NULL) != STATUS_OK ||
        text_save(&script, templates->status, "%s/%s.gp", directory, chart->name) != STATUS_OK)
        return templates->status->code;
    return text_save(&chart->data, templates->status, "%s/%s.csv", directory, chart->name);
}
