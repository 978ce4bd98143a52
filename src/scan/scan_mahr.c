/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mahr text: sections in brackets, `NO_POINTS=n`, then below [PROFILE_VALUES] one line a point in millimetres:
 * `index=x y z c lock` of MarWin, which names them in a comment above, `index=x z lock` of the MarSurf PS 10. */
#include "scan/reader.h"
#include "scan/string_view.h"
#include "scan/text_header.h"

#include <math.h>
#include <string.h>

static const double mahr_unit_m = 1e-3; /* of both */
enum { MAHR_SHORTEST = 6 };             /* bytes of the shortest line of a point, `0=1 2` and its end */

/* Which of a point's `count` fields are x and z, from 0; count 0 while that is not known. */
struct fields {
    size_t count, x, z;
};

/* The fields by the comment that names them, `X,Y,Z,C,Lock`. */
static struct fields named_fields(struct string_view names)
{
    struct fields fields = {0, SIZE_MAX, SIZE_MAX};
    for (struct string_view name;
         cell_next(&names, memchr(names.start, ',', string_view_length(names)) ? ',' : ' ', &name); fields.count++) {
        fields.x = string_view_equals(name, "x") ? fields.count : fields.x;
        fields.z = string_view_equals(name, "z") ? fields.count : fields.z;
    }
    return fields.x < SIZE_MAX && fields.z < SIZE_MAX ? fields : (struct fields){0};
}

static bool read_length(struct string_view word, double *length_m)
{
    double value;
    bool good = number_scan(word, NUMBER_POINT | NUMBER_COMMA, NULL, &value) == word.end && isfinite(value);
    *length_m = good ? value * mahr_unit_m : 0;
    return good;
}

/* Reads `index=field field ...`; false when the line is not of that form. Where nothing names the fields, the first
 * point tells: up to three are x, z and whether the point is locked. */
static bool read_point(struct string_view line, struct fields *fields, double *x, double *z)
{
    const char *equals = memchr(line.start, '=', string_view_length(line));
    if (!equals)
        return false;
    struct string_view rest = {equals + 1, line.end}, word;
    size_t count = 0;
    while (scan_word(&rest, &word))
        count++;
    if (fields->count == 0)
        *fields = (struct fields){count, 0, count > 3 ? 2 : 1};
    rest.start = equals + 1;
    bool good = count == fields->count && count > 1;
    for (size_t i = 0; good && scan_word(&rest, &word); i++) {
        double length_m;
        good = read_length(word, &length_m) || (i != fields->x && i != fields->z);
        *x = i == fields->x ? length_m : *x;
        *z = i == fields->z ? length_m : *z;
    }
    return good;
}

/* The points from `lines` on, until a section begins or the file ends. */
static enum status_code read_points(struct scan *out, struct lines lines, const struct scan_file *file)
{
    size_t n = 0;
    struct fields fields = {0};
    for (struct string_view line; lines_next(&lines, &line);) {
        bool comment;
        struct string_view content = text_header_uncomment(line, &comment);
        if (comment && n == 0 && fields.count == 0)
            fields = named_fields(content);
        if (comment || content.start == content.end)
            continue;
        if (*content.start == '[')
            break;
        if (n == out->nx)
            return scan_fail(file, lines.number, "more points than NO_POINTS says, %zu; export the scan again",
                             out->nx);
        if (!read_point(content, &fields, &out->x_m[n], &out->z_m[n]))
            return scan_fail(file, lines.number, "'%s' is no line `index=x%s z ...`%s; correct or remove it",
                             scan_quote(content).text, fields.z == 1 ? "" : " y",
                             fields.count > 0 ? " with as many fields as the others" : "");
        n++;
    }
    if (n < out->nx)
        return scan_fail(file, lines.number, "the points end after %zu of %zu; export the scan again", n, out->nx);
    return STATUS_OK;
}

/* Takes over `key=length` in mm, 0 or more. */
static enum status_code take_length(double *length_m, const char *key, struct string_view line, size_t line_number,
                                    const struct scan_file *file)
{
    line.start += string_view_starts(line, key) ? strlen(key) : string_view_length(line);
    if (line.start == line.end || *line.start != '=')
        return STATUS_OK;
    line.start++;
    if (read_length(string_view_trim(line), length_m) && *length_m >= 0)
        return STATUS_OK;
    return scan_fail(file, line_number, "%s is no length", key);
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
        if (take_length(&out->margin_m[0], "PRETRAV_LIN", line, lines.number, file) != STATUS_OK ||
            take_length(&out->margin_m[1], "POSTTRAV_LIN", line, lines.number, file) != STATUS_OK)
            return file->status->code;
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
