#include "scan/reader.h"
#include "scan/number.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void scan_printable(char *string)
{
    for (; *string; string++)
        if ((unsigned char)*string < 0x20 || *string == 0x7f)
            *string = '?';
}

enum status_code scan_fail(struct status *status, const struct scan_bytes *file, size_t line, const char *format, ...)
{
    char message[512];
    va_list args;
    va_start(args, format);
    vsnprintf(message, sizeof message, format, args);
    va_end(args);
    if (line > 0)
        status_fail(status, STATUS_SCAN, "%.440s:%zu: %s", file->path, line, message);
    else
        status_fail(status, STATUS_SCAN, "%.440s: %s", file->path, message);
    scan_printable(status->message);
    return status->code;
}

struct scan_quote scan_quote(struct string_view span)
{
    struct scan_quote quote = {""};
    size_t length = string_view_length(span), shown = length > 24 ? 24 : length;
    for (size_t i = 0; i < shown; i++)
        quote.text[i] = span.start[i] >= 0x20 && span.start[i] < 0x7f ? span.start[i] : '?';
    if (length > shown)
        memcpy(quote.text + shown, "...", 4);
    return quote;
}

void scan_copy(char *to, size_t size, struct string_view span)
{
    size_t length = string_view_length(span) < size ? string_view_length(span) : size - 1;
    memcpy(to, span.start, length);
    to[length] = '\0';
}

static double choose_unit(char name[16], const char *named, const char *scene)
{
    if (!named || !*named)
        named = scene;
    const char *known = scan_unit_name(named, strlen(named));
    snprintf(name, 16, "%s", known ? known : "");
    return known ? scan_unit_m(named, strlen(named)) : 0.0;
}

enum status_code scan_units(struct scan *out, const char *x_named, const char *z_named, double *x_m, double *z_m,
                            const struct scan_bytes *file, const struct scan_options *options, struct status *status)
{
    *x_m = choose_unit(out->x_unit, x_named, options->x_unit);
    *z_m = choose_unit(out->z_unit, z_named, options->z_unit);
    if (*x_m > 0 && *z_m > 0)
        return STATUS_OK;
    bool x_given = !(*x_m > 0) && *options->x_unit, z_given = !(*z_m > 0) && *options->z_unit;
    if (x_given || z_given)
        return scan_fail(status, file, 0,
                         "'%.16s' is no unit of length; give %s as m, mm, um, nm, pm, A, in, mil or uin",
                         x_given ? options->x_unit : options->z_unit, x_given ? "x_unit" : "z_unit");
    if (*x_m > 0)
        return scan_fail(status, file, 0,
                         "no unit for z; add `z_unit: um` (or mm, nm, ...) to this surface in scene.yaml, or give "
                         "--z-unit um");
    if (*z_m > 0)
        return scan_fail(status, file, 0,
                         "no unit for x; add `x_unit: mm` (or um, nm, ...) to this surface in scene.yaml, or give "
                         "--x-unit mm");
    return scan_fail(status, file, 0,
                     "no unit for x nor for z; add `x_unit: mm` and `z_unit: um` (or what they are in) to this surface "
                     "in scene.yaml, or give --x-unit mm --z-unit um");
}

void scan_set_units(struct scan *out, const char *x_unit, const char *z_unit)
{
    snprintf(out->x_unit, sizeof out->x_unit, "%s", x_unit);
    snprintf(out->z_unit, sizeof out->z_unit, "%s", z_unit);
}

enum status_code scan_reserve(struct scan *out, size_t nx, size_t ny, size_t room, const struct scan_bytes *file,
                              struct status *status)
{
    if (nx == 0 || ny == 0)
        return scan_fail(status, file, 0, "the header says %zu x %zu points: nothing measured", nx, ny);
    if (ny > room / nx)
        return scan_fail(status, file, 0, "the header says %zu x %zu points, the file ends after %zu; copy it again",
                         nx, ny, room);
    out->z_m = malloc(nx * ny * sizeof *out->z_m);
    if (!out->z_m)
        return status_memory(status);
    out->nx = nx;
    out->ny = ny;
    out->kind = ny > 1 ? SCAN_AREAL : SCAN_PROFILE;
    return STATUS_OK;
}

static bool is_gap(char c)
{
    return string_view_is_blank_char(c) || c == '\n';
}

bool scan_word(struct string_view *text, struct string_view *word)
{
    while (text->start < text->end && is_gap(*text->start))
        text->start++;
    word->start = text->start;
    while (text->start < text->end && !is_gap(*text->start))
        text->start++;
    word->end = text->start;
    return word->end > word->start;
}

size_t scan_line(const struct scan_bytes *file, const char *at)
{
    struct lines lines = lines_begin(scan_span(file));
    for (struct string_view line; lines_next(&lines, &line);)
        if (lines.next > at)
            break;
    return lines.number;
}

bool scan_is_missing(struct string_view cell)
{
    return string_view_equals(cell, "NaN") || string_view_equals(cell, "BAD");
}

enum status_code scan_fill(struct scan *out, struct string_view *text, double z_m, const struct scan_bytes *file,
                           struct status *status)
{
    size_t count = out->nx * out->ny;
    for (size_t i = 0; i < count; i++) {
        struct string_view word;
        if (!scan_word(text, &word))
            return scan_fail(status, file, scan_line(file, text->start),
                             "the heights end after %zu of %zu; copy the file again", i, count);
        double value;
        if (number_scan(word, NUMBER_POINT, NULL, &value) == word.end && isfinite(value))
            out->z_m[i] = value * z_m;
        else if (scan_is_missing(word))
            out->z_m[i] = NAN;
        else
            return scan_fail(status, file, scan_line(file, word.start), "'%s' among the heights; correct or remove it",
                             scan_quote(word).text);
    }
    return STATUS_OK;
}

size_t scan_disorder(const double *x, size_t n)
{
    if (n < 2)
        return n;
    bool up = x[1] > x[0];
    for (size_t i = 0; i < n; i++) {
        if (!isfinite(x[i]))
            return i;
        if (i > 0 && !(up ? x[i] > x[i - 1] : x[i] < x[i - 1]))
            return i;
    }
    return n;
}
