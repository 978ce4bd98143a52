/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "chart/drawing_parts.h"

#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

size_t drawing_characters(const char *string, size_t most)
{
    size_t count = 0;
    for (; *string && count < most; count++) {
        size_t length = text_character(string);
        string += length ? length : 1;
    }
    return count;
}

/** Adds `count` characters; those of ASCII that could mean anything to gnuplot, wherever they stand, as octal escapes.
 * Returns what follows them. */
static const char *add_characters(struct text *out, const char *string, size_t count)
{
    for (const char *start = string; *string && count > 0; count--) {
        size_t length = text_character(string);
        if (*string == '>' && string - start >= 2 && string[-1] == ']' && string[-2] == ']')
            text_add(out, "›"); /* gnuplot does not escape what ends a CDATA section */
        else if (length != 1)
            text_add_bytes(out, length ? string : "?", length ? length : 1);
        else if (isalnum((unsigned char)*string) || strchr(" .,:;()+-/=", *string))
            text_add_bytes(out, string, 1);
        else
            text_add(out, "\\%03o", (unsigned)*string);
        string += length ? length : 1;
    }
    return string;
}

void drawing_quote(struct text *out, const char *text, size_t most, bool both_ends)
{
    struct text shown = {0};
    text_add_shown(&shown, text);
    const char *string = text_string(&shown);
    size_t count = drawing_characters(string, SIZE_MAX), start = both_ends ? most / 2 - 1 : most - 1;
    text_add(out, "\"");
    if (count <= most)
        add_characters(out, string, count);
    else {
        string = add_characters(out, string, start);
        text_add(out, "…");
        for (size_t left = count - start - (most - most / 2); both_ends && left > 0; left--) {
            size_t length = text_character(string);
            string += length ? length : 1;
        }
        if (both_ends)
            add_characters(out, string, SIZE_MAX);
    }
    text_add(out, "\"");
    text_free(&shown);
}

void drawing_label(struct text *out, const char *label, bool letters)
{
    text_add(out, "'");
    for (; *label; label++)
        if (*label == '\'')
            text_add(out, "''");
        else if (!letters || (*label != '{' && *label != '}'))
            text_add_bytes(out, label, 1);
    text_add(out, "'");
}

const char drawing_nothing[] =
    "set label 1000 'no data in range' at graph 0.5, graph 0.5 center textcolor rgb '" LOOK_INK "'\n";

void drawing_plot(struct text *out, size_t b, const char *columns)
{
    text_add(out, ", \\\n data index %zu using %s with ", b, columns);
}

/* The grid is translucent, fit for any background. */
static const char style[] = "reset\n"
                            "set encoding utf8\n"
                            "set minussign\n"
                            "set datafile separator ','\n"
                            "set tics textcolor rgb '" LOOK_INK "'\n"
                            "set xlabel textcolor rgb '" LOOK_INK "' offset 0, 0.3\n"
                            "set ylabel textcolor rgb '" LOOK_INK "'\n"
                            "set title textcolor rgb '" LOOK_INK "' offset 0, -0.5\n"
                            "set key textcolor rgb '" LOOK_INK "' noenhanced Left reverse samplen 2.2 spacing 1.1\n";

void drawing_canvas(struct text *out, const struct drawing *drawing, double height, const char *terminal_size)
{
    text_add_bytes(out, style, sizeof style - 1);
    if (terminal_size)
        text_add(out,
                 "set border 15 lc rgb '" LOOK_INK "' lw 1\nset tics nomirror out scale 1\n"
                 "set xlabel offset 0, 0\nset title offset 0, 0\nset terminal dumb size %s noenhanced mono\n",
                 terminal_size);
    else
        text_add(out,
                 "set border 3 lc rgb '" LOOK_INK "' lw 1\nset tics nomirror out scale 0.5\n"
                 "set grid lc rgb '#B0808080' lw 0.7 lt 1\n"
                 "set terminal svg size %d,%.0f dynamic enhanced font 'Helvetica, Arial, sans-serif,15' "
                 "background rgb '#ffffff'\n",
                 DRAWING_WIDTH, height);
    text_add(out, "set output '%s.%s'\ndata = '%s.csv'\n", drawing->name, terminal_size ? "txt" : "svg", drawing->name);
}

static void add_power(struct text *out, int power, bool letters)
{
    if (letters)
        text_add(out, "1e%d", power);
    else if (power == 0 || power == 1)
        text_add(out, power ? "10" : "1");
    else
        text_add(out, "10^{%s%d}", power < 0 ? "−" : "", abs(power));
}

/** Tics of a logarithmic axis over less than two powers of ten. */
static void add_between(struct text *out, const struct drawing_axis *axis, double low, double high)
{
    static const double many[] = {1, 1.5, 2, 3, 4, 5, 7}, few[] = {1, 2, 5};
    const double *steps = high - low < 0.8 ? many : few;
    size_t count = high - low < 0.8 ? sizeof many / sizeof *many : sizeof few / sizeof *few;
    const char *comma = "";
    for (int k = (int)ceil(low) - 1; k <= (int)floor(high); k++)
        for (size_t i = 0; i < count; i++) {
            double at = steps[i] * pow(10, k);
            if (log10(at) < low || log10(at) > high)
                continue;
            text_add(out, "%s'", comma);
            if (!axis->bare && (abs(k) < 4 || axis->letters))
                text_add(out, "%g", at);
            else if (!axis->bare) {
                text_add(out, "%g×", steps[i]);
                add_power(out, k, axis->letters);
            }
            text_add(out, "' %.17g", at);
            comma = ", ";
        }
}

static struct figure_extent add_logarithmic(struct text *out, const struct drawing_axis *axis)
{
    double low = log10(axis->low), high = log10(axis->high);
    if (high - low < 0.5) {
        double middle = (low + high) / 2;
        low = middle - 0.25;
        high = middle + 0.25;
    }
    /* A little more than nothing, or rounding would put the outermost points outside. */
    double room = axis->room * (high - low) + 1e-9;
    low = fmax(low - room, -300);
    high = fmin(high + room, 300);
    text_add(out, "set logscale %c; set %crange [%.17g:%.17g] noextend\nset %ctics (", axis->axis, axis->axis,
             pow(10, low), pow(10, high), axis->axis);
    int first = (int)ceil(low), last = (int)floor(high);
    if (last > first) {
        int every = (int)ceil((last - first + 1) / axis->most_tics);
        const char *comma = "";
        for (int k = first; k <= last; k++)
            if (k % every == 0) {
                text_add(out, "%s'", comma);
                if (!axis->bare)
                    add_power(out, k, axis->letters);
                text_add(out, "' %.17g", pow(10, k));
                comma = ", ";
            }
    } else
        add_between(out, axis, low, high);
    text_add(out, ")\n");
    return (struct figure_extent){low, high};
}

static struct figure_extent add_linear(struct text *out, const struct drawing_axis *axis)
{
    double low = axis->low, high = axis->high;
    bool from_zero = axis->kind == DRAWING_ZERO && low >= 0;
    low = from_zero ? 0 : low;
    if (high <= low)
        high = low + (low == 0 ? 1 : fabs(low));
    double room = axis->room * (high - low);
    high += room;
    low -= from_zero ? 0 : room;
    double step = (high - low) / axis->most_tics, magnitude = pow(10, floor(log10(step))), digit = step / magnitude;
    step = magnitude * (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10);
    text_add(out, "set %crange [%.17g:%.17g] noextend; set %ctics %.17g; set format %c '%s'\n", axis->axis, low, high,
             axis->axis, step, axis->axis, axis->bare ? "" : "%g");
    return (struct figure_extent){low, high};
}

struct figure_extent drawing_axis(struct text *out, const struct drawing_axis *axis)
{
    if (axis->low > axis->high) {
        text_add(out, "set %crange [0:1]\nunset %ctics\n", axis->axis, axis->axis);
        return (struct figure_extent){0, 1};
    }
    return axis->kind == DRAWING_LOG ? add_logarithmic(out, axis) : add_linear(out, axis);
}

void drawing_frame(struct text *out, const struct drawing *drawing, const struct drawing_frame *frame,
                   const char *terminal_size, double *top, double *height)
{
    int key_size = frame->entries > 4 && frame->longest > 33 ? 13 : 15;
    double fit = floor(670.0 / (54 + 0.49 * key_size * (double)frame->longest));
    double columns = fmax(1, fmin((double)frame->entries, fit));
    double rows = ceil((double)frame->entries / columns);
    double below = 14 + 1.65 * key_size * rows;
    *top = drawing->title[0] ? 36 : 12;
    *height = ceil(*top + DRAWING_TALL + frame->lower_panel + 66 + below);
    drawing_canvas(out, drawing, *height, terminal_size);
    if (drawing->title[0]) {
        text_add(out, "set title ");
        drawing_quote(out, drawing->title, 80, false);
        text_add(out, " noenhanced\n");
    }
    text_add(out, "set xlabel ");
    drawing_label(out, drawing->x_label, terminal_size);
    text_add(out, terminal_size ? "\nset label 2 " : "\nset ylabel ");
    drawing_label(out, drawing->y_label, terminal_size);
    if (terminal_size)
        text_add(out, " at screen 0.02, screen 0.99 left\nset key bmargin center vertical\n");
    else /* gnuplot reckons a character wider than the font draws it; the negative width takes that back */
        text_add(out,
                 "\nset tmargin at screen %.17g; set bmargin at screen %.17g\n"
                 "set key at screen 0.5, %.4f center top vertical maxrows %.0f width %.1f font ',%d'\n",
                 1 - *top / *height, 1 - (*top + DRAWING_TALL) / *height, below / *height, rows,
                 -0.28 * (double)frame->longest, key_size);
}
