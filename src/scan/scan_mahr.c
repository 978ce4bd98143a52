/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mahr text of MarWin and of MarSurf PS 10: sections in brackets, `NO_POINTS=n`, `PRETRAV_LIN=` and `POSTTRAV_LIN=`,
 * then below [PROFILE_VALUES] one line a point, `index=` and fields as the line `// X,Y,Z,C,Lock` names them; without
 * such a line `index=x z lock`. Lengths are millimetres. */
#include "scan/reader.h"
#include "scan/string_view.h"

#include <stdint.h>
#include <string.h>

static const double mahr_unit_m = 1e-3; /* of both */
enum { MAHR_SHORTEST = 6 /* bytes of the shortest line of a point, `0=1 2` and its end */, MAHR_FIELDS = 8 };

/* Which fields behind `index=` are x and z, from 0. */
struct columns {
    size_t x, z;
};

/* The places of X and Z in a comment that names the fields; false: it does not. */
static bool read_columns(struct columns *out, struct string_view comment)
{
    struct columns found = {SIZE_MAX, SIZE_MAX};
    struct string_view name;
    for (size_t i = 0; cell_next(&comment, ',', &name); i++) {
        found.x = string_view_equals(name, "X") ? i : found.x;
        found.z = string_view_equals(name, "Z") ? i : found.z;
    }
    if (found.x >= MAHR_FIELDS || found.z >= MAHR_FIELDS)
        return false;
    *out = found;
    return true;
}

/* Reads `index=a b c ...`; false when the line is not of that form. */
static bool read_point(struct string_view line, const struct columns *columns, double *x, double *z)
{
    const char *equals = memchr(line.start, '=', string_view_length(line));
    size_t last = columns->x > columns->z ? columns->x : columns->z;
    if (!equals)
        return false;
    line.start = equals + 1;
    double value[MAHR_FIELDS];
    for (size_t i = 0; i <= last; i++) {
        struct string_view word;
        if (!scan_word(&line, &word) || !number_read(word, &value[i]))
            return false;
    }
    *x = value[columns->x] * mahr_unit_m;
    *z = value[columns->z] * mahr_unit_m;
    return true;
}

/* The points from `lines` on, until a section begins or the file ends. */
static enum status_code read_points(struct scan *out, struct lines lines, const struct scan_file *file)
{
    size_t n = 0;
    struct columns columns = {0, 1};
    for (struct string_view line; lines_next(&lines, &line);) {
        line = string_view_trim(line);
        if (string_view_starts(line, "//") && n == 0)
            (void)read_columns(&columns, (struct string_view){line.start + 2, line.end});
        if (line.start == line.end || string_view_starts(line, "//"))
            continue;
        if (*line.start == '[')
            break;
        if (n == out->nx)
            return scan_fail(file, lines.number, "more points than NO_POINTS says, %zu; export the scan again",
                             out->nx);
        if (!read_point(line, &columns, &out->x_m[n], &out->z_m[n]))
            return scan_fail(file, lines.number, "'%s' is no line `index=x z ...`; correct or remove it",
                             scan_quote(line).text);
        n++;
    }
    if (n < out->nx)
        return scan_fail(file, lines.number, "the points end after %zu of %zu; export the scan again", n, out->nx);
    return STATUS_OK;
}

/* Takes over how much of the record lies before or behind what was to be measured. */
static void read_margin(double *margin_m, struct string_view line, const char *key)
{
    double length;
    if (string_view_starts(line, key) &&
        number_read((struct string_view){line.start + strlen(key), line.end}, &length) && length > 0)
        *margin_m = length * mahr_unit_m;
}

enum status_code scan_mahr_text_read(struct scan *out, const struct scan_file *file)
{
    size_t n = 0;
    struct lines lines = lines_begin(scan_view(file));
    for (struct string_view line; lines_next(&lines, &line);) {
        line = string_view_trim(line);
        if (string_view_starts(line, "NO_POINTS=") &&
            !number_read_size((struct string_view){line.start + strlen("NO_POINTS="), line.end}, &n))
            return scan_fail(file, lines.number, "NO_POINTS is no number of points");
        read_margin(&out->margin_m[0], line, "PRETRAV_LIN=");
        read_margin(&out->margin_m[1], line, "POSTTRAV_LIN=");
        if (!string_view_equals(line, "[PROFILE_VALUES]"))
            continue;
        size_t room = (size_t)(lines.end - lines.next + 1) / MAHR_SHORTEST;
        if (scan_reserve_x(out, n, room, file) != STATUS_OK)
            return file->status->code;
        scan_set_units(out, "mm", "mm");
        return read_points(out, lines, file);
    }
    return scan_fail(file, lines.number, "no section [PROFILE_VALUES]; export the scan with its profile");
}

/* Mahr MarWin binary PRF: magic "[p3dlin]", the number of points n at byte 0x14, and 49 bytes behind the start of
 * "[Trajec]" n doubles x, n doubles y, n doubles z in millimetres. */
static const char trajectory[] = "[Trajec]";
enum { MAHR_COUNT_AT = 0x14, MAHR_DATA_BEHIND = 49 };

enum status_code scan_mahr_prf_read(struct scan *out, const struct scan_file *file)
{
    struct bytes count = bytes_begin(file, MAHR_COUNT_AT);
    size_t n = (size_t)bytes_number(&count, BYTES_U32);
    const char *found = memmem(file->bytes, file->length, trajectory, strlen(trajectory));
    if (count.overrun || !found)
        return scan_fail(file, 0, "no %s section: the file is cut off; export it again", trajectory);
    struct bytes bytes = bytes_begin(file, (size_t)(found - file->bytes) + MAHR_DATA_BEHIND);
    if (scan_reserve_x(out, n, bytes_left(&bytes) / (3 * sizeof(double)), file) != STATUS_OK)
        return file->status->code;
    for (size_t i = 0; i < n; i++)
        out->x_m[i] = bytes_number(&bytes, BYTES_F64) * mahr_unit_m;
    bytes_skip(&bytes, n * sizeof(double)); /* y, across the profile */
    for (size_t i = 0; i < n; i++)
        out->z_m[i] = bytes_number(&bytes, BYTES_F64) * mahr_unit_m;
    scan_set_units(out, "mm", "mm");
    return STATUS_OK;
}
