/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/reader.h"
#include "base/limits.h"
#include "base/unit.h"
#include "scan/text_header.h"

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

enum status_code scan_fail(const struct scan_file *file, size_t line, const char *format, ...)
{
    char message[512];
    va_list args;
    va_start(args, format);
    vsnprintf(message, sizeof message, format, args);
    va_end(args);
    char place[32] = "";
    if (line > 0)
        snprintf(place, sizeof place, ":%zu", line);
    status_fail(file->status, STATUS_SCAN, "%.440s%s: %s", file->path, place, message);
    scan_printable(file->status->message);
    return file->status->code;
}

struct scan_quote scan_quote(struct string_view view)
{
    struct scan_quote quote = {""};
    size_t length = string_view_length(view), shown = length > 24 ? 24 : length;
    for (size_t i = 0; i < shown; i++)
        quote.text[i] = view.start[i] >= 0x20 && view.start[i] < 0x7f ? view.start[i] : '?';
    if (length > shown)
        memcpy(quote.text + shown, "...", 4);
    return quote;
}

void scan_copy(char *to, size_t size, struct string_view view)
{
    size_t length = string_view_length(view) < size ? string_view_length(view) : size - 1;
    memcpy(to, view.start, length);
    to[length] = '\0';
}

void scan_warn(struct scan *scan, const char *format, ...)
{
    if (scan->warning_count == SCAN_WARNINGS)
        return;
    va_list args;
    va_start(args, format);
    vsnprintf(scan->warnings[scan->warning_count], SCAN_WARNING_LENGTH, format, args);
    va_end(args);
    scan_printable(scan->warnings[scan->warning_count++]);
}

static const char *said(const char *name)
{
    return name && *name ? name : NULL;
}

static enum status_code fail_units(const struct scan *out, const char *x, const char *z, const struct scan_file *file)
{
    bool no_x = !*out->x_unit, no_z = !*out->z_unit, x_wrong = x && no_x, z_wrong = z && no_z;
    if (x_wrong || z_wrong)
        return scan_fail(file, 0, "'%.16s' is no unit of length; give %s as m, mm, um, nm, pm, A, in, mil or uin",
                         x_wrong ? x : z, x_wrong ? "x_unit" : "z_unit");
    const char *unknown = out->unknown_unit[no_x && *out->unknown_unit[0] ? 0 : no_z];
    return scan_fail(file, 0,
                     "%s%s%sno unit for %s%s%s; add %s%s%s (or what %s in) to this surface in scene.yaml, or give%s%s",
                     *unknown ? "unknown unit '" : "", unknown, *unknown ? "', " : "", no_x ? "x" : "",
                     no_x && no_z ? " nor for " : "", no_z ? "z" : "", no_x ? "`x_unit: mm`" : "",
                     no_x && no_z ? " and " : "", no_z ? "`z_unit: um`" : "", no_x && no_z ? "they are" : "it is",
                     no_x ? " --x-unit mm" : "", no_z ? " --z-unit um" : "");
}

static struct scan_unit find_unit(const char *name)
{
    return scan_unit_find(string_view_of(name ? name : ""));
}

enum status_code scan_units(struct scan *out, const char *x_named, const char *z_named, double *x_m, double *z_m,
                            const struct scan_file *file)
{
    const struct text_header *beside = file->options->sidecar ? &file->options->sidecar->header : NULL;
    const char *x = said(x_named), *z = said(z_named);
    for (int i = 0; i < 2; i++) {
        const char *own = i ? z : x, *beside_it = out->unknown_unit[i];
        struct unit other;
        const bool known =
            unit_read(&other, beside_it, strlen(beside_it)) && !unit_of(&other, UNIT_NUMBER | UNIT_DISTANCE);
        if (known && i == 0 && unit_of(&other, UNIT_FORCE | UNIT_PRESSURE | UNIT_RESISTANCE | UNIT_THERMAL_RESISTANCE))
            return scan_fail(file, 0,
                             "x in '%s' is no scan; a measurement goes into scene.yaml as `measured: {file: ...}`",
                             beside_it);
        if (own ? !find_unit(own).name || (i == 0 && !(find_unit(own).si > 0)) : known)
            return scan_fail(file, 0, "%c is in '%.16s' by the file, which is no unit of length; correct it there",
                             "xz"[i], own ? own : beside_it);
    }
    out->units_lacking = !x || !z;
    bool x_beside = !x && beside && (x = text_header_x_unit(beside, out->x_column));
    bool z_beside = !z && beside && (z = text_header_z_unit(beside, out->z_column));
    x = x ? x : said(file->options->x_unit);
    z = z ? z : said(file->options->z_unit);
    struct scan_unit x_unit = find_unit(x), z_unit = find_unit(z);
    if (z_unit.name == scan_slope)
        return scan_fail(file, 0, "z%s%.0zu is a slope, not heights; integrate it%s",
                         out->z_column > 0 ? " in column " : "", out->z_column,
                         out->z_column > 0 ? ", or choose the heights by `column`" : "");
    *x_m = x_unit.si;
    *z_m = z_unit.si;
    scan_set_units(out, *x_m > 0 ? x_unit.name : "", *z_m > 0 ? z_unit.name : "");
    if (!(*x_m > 0 && *z_m > 0))
        return fail_units(out, x, z, file);
    out->units_beside = x_beside || z_beside;
    if (out->units_beside)
        scan_warn(out, "the sidecar '%.120s' gave the unit%s: %s%s%s%s%s", file->options->sidecar->name,
                  x_beside && z_beside ? "s" : "", x_beside ? "x in " : "", x_beside ? out->x_unit : "",
                  x_beside && z_beside ? ", " : "", z_beside ? "z in " : "", z_beside ? out->z_unit : "");
    return STATUS_OK;
}

void scan_warn_units(struct scan *out, const struct scan_file *file)
{
    const char *const units[2][2] = {{out->x_unit, file->options->x_unit}, {out->z_unit, file->options->z_unit}};
    for (size_t i = 0; i < 2; i++) {
        double used = find_unit(units[i][0]).si;
        if (said(units[i][1]) && used > 0 && find_unit(units[i][1]).si != used)
            scan_warn(out, "the file%s names its %c unit, %s: the given %c_unit is not used",
                      out->units_beside ? " or its sidecar" : "", "xz"[i], units[i][0], "xz"[i]);
    }
}

void scan_set_units(struct scan *out, const char *x_unit, const char *z_unit)
{
    snprintf(out->x_unit, sizeof out->x_unit, "%s", x_unit);
    snprintf(out->z_unit, sizeof out->z_unit, "%s", z_unit);
}

enum status_code scan_check_points(double nx, double ny, const struct scan_file *file)
{
    if (!(nx >= 1 && ny >= 1 && nx == floor(nx) && ny == floor(ny)))
        return scan_fail(file, 0, "the header says %.15g x %.15g points: nothing measured", nx, ny);
    if (nx * ny > (double)limit_most(LIMIT_POINTS))
        return scan_fail(file, 0, "%.15g x %.15g points%s", nx, ny, limit_words(LIMIT_POINTS).text);
    return STATUS_OK;
}

enum status_code scan_reserve(struct scan *out, double nx, double ny, size_t room, const struct scan_file *file)
{
    if (nx * ny > (double)room)
        return scan_fail(file, 0, "the header says %.15g x %.15g points, the file ends after %zu; copy it again", nx,
                         ny, room);
    if (scan_check_points(nx, ny, file) != STATUS_OK)
        return file->status->code;
    out->nx = (size_t)nx;
    out->ny = (size_t)ny;
    out->z_m = malloc(out->nx * out->ny * sizeof *out->z_m);
    if (!out->z_m)
        return status_memory(file->status);
    out->kind = ny > 1 ? SCAN_AREAL : SCAN_PROFILE;
    return STATUS_OK;
}

enum status_code scan_reserve_x(struct scan *out, double n, size_t room, const struct scan_file *file)
{
    if (scan_reserve(out, n, 1, room, file) != STATUS_OK)
        return file->status->code;
    out->x_m = malloc(out->nx * sizeof *out->x_m);
    return out->x_m ? STATUS_OK : status_memory(file->status);
}

enum status_code scan_take_key(const struct scan_key *keys, struct string_view line, size_t line_number,
                               const struct scan_file *file)
{
    const char *equals = memchr(line.start, '=', string_view_length(line));
    struct string_view key = string_view_trim((struct string_view){line.start, equals ? equals : line.start});
    struct string_view value = string_view_trim((struct string_view){equals ? equals + 1 : line.end, line.end});
    while (keys->key && !string_view_equals(key, keys->key))
        keys++;
    if (!keys->key)
        return STATUS_OK;
    if (keys->unit)
        scan_copy(keys->unit, SCAN_UNIT_SIZE, value);
    else if (!number_read(value, keys->number))
        return scan_fail(file, line_number, "%s = '%s' is no number it can have", keys->key, scan_quote(value).text);
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

size_t scan_line(const struct scan_file *file, const char *at)
{
    struct lines lines = lines_begin(scan_view(file));
    for (struct string_view line; lines_next(&lines, &line);)
        if (lines.next > at)
            break;
    return lines.number;
}

bool scan_is_missing(struct string_view cell)
{
    const char *at = cell.start;
    while (at < cell.end && *at == '*')
        at++;
    return (cell.end > cell.start && at == cell.end) || string_view_is_one_of(cell, "NaN BAD");
}

enum status_code scan_take_text(struct scan *out, double nx, double ny, struct string_view text, double z_m,
                                double blank, const char *end, const struct scan_file *file)
{
    struct string_view word;
    if (scan_reserve(out, nx, ny, (string_view_length(text) + 1) / 2, file) != STATUS_OK)
        return file->status->code;
    for (size_t i = 0; i < out->nx * out->ny; i++) {
        double value;
        if (!scan_word(&text, &word))
            return scan_fail(file, scan_line(file, text.start), "the heights end after %zu of %zu; copy the file again",
                             i, out->nx * out->ny);
        if (number_scan(word, NUMBER_POINT, NULL, &value) == word.end && isfinite(value))
            out->z_m[i] = value >= blank ? NAN : value * z_m;
        else if (scan_is_missing(word))
            out->z_m[i] = NAN;
        else
            return scan_fail(file, scan_line(file, word.start), "'%s' among the heights; correct or remove it",
                             scan_quote(word).text);
    }
    if (scan_word(&text, &word) && !(end && string_view_starts(word, end)))
        return scan_fail(file, scan_line(file, word.start), "more heights than the header says, %zu x %zu", out->nx,
                         out->ny);
    return STATUS_OK;
}

/* No NUL, nor control characters that no text has, in the first bytes. */
bool scan_text_sniff(const struct scan_file *file)
{
    enum { LOOKED_AT = 4096 };
    size_t length = file->length;
    while (length > 0 && (file->bytes[length - 1] == '\0' || file->bytes[length - 1] == 0x1a))
        length--; /* some programs end a text with these */
    for (size_t i = 0; i < length && i < LOOKED_AT; i++) {
        unsigned char c = (unsigned char)file->bytes[i];
        if (c == '\0' || (c < 0x20 && !strchr("\t\n\v\f\r\x1a\x02\x03\x04", c)))
            return false;
    }
    return true;
}

size_t scan_disorder(const double *x, size_t stride, size_t n)
{
    bool up = n > 1 && x[stride] > x[0];
    for (size_t i = 0; i < n; i++) {
        double here = x[i * stride], before = i > 0 ? x[(i - 1) * stride] : up ? -INFINITY : INFINITY;
        if (!isfinite(here) || !(up ? here > before : here < before))
            return i;
    }
    return n;
}
