/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mahr text: sections in brackets, `NO_POINTS=n`, then below [PROFILE_VALUES] a line for each point in mm:
 * `index=x y z c lock` of MarWin, with a comment above that names them, or `index=x z lock` of the MarSurf PS 10. */
#include "scan/reader.h"
#include "scan/text_header.h"

#include <math.h>
#include <string.h>

static const double mahr_unit_m = 1e-3;       /* of both */
enum { MAHR_FIELDS = 64, MAHR_SHORTEST = 6 }; /* most fields; bytes of the shortest line of a point, `0=1 2` */

/* How many fields a point has (0: not known yet), and which are x and z, from 0. */
struct fields {
    size_t count, x, z;
};

/* The fields by the comment that names them, `X,Y,Z,C,Lock`. */
static struct fields named_fields(struct string_view names)
{
    struct fields fields = {0, SIZE_MAX, SIZE_MAX};
    const char delimiter = memchr(names.start, ',', string_view_length(names)) ? ',' : ' ';
    for (struct string_view name; cell_next(&names, delimiter, &name); fields.count++) {
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

/* Reads `index=field field ...`; false where the line is not of that form. Without a comment the first point decides:
 * up to three fields are x, z and lock. */
static bool read_point(struct string_view line, struct fields *fields, double *x, double *z)
{
    const char *equals = memchr(line.start, '=', string_view_length(line));
    struct string_view rest = {equals ? equals + 1 : line.end, line.end}, word[MAHR_FIELDS];
    size_t count = 0;
    while (count < MAHR_FIELDS && scan_word(&rest, &word[count]))
        count++;
    if (fields->count == 0 && equals)
        *fields = (struct fields){count, 0, count > 3 ? 2 : 1};
    return count == fields->count && count > 1 && read_length(word[fields->x], x) && read_length(word[fields->z], z);
}

/* Reads the points up to the next section. */
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

/* Is `line` `key=value`? *value is what follows. */
static bool has_key(struct string_view line, const char *key, struct string_view *value)
{
    *value = (struct string_view){line.start + strlen(key), line.end};
    return string_view_starts(line, key);
}

enum status_code scan_mahr_text_read(struct scan *out, const struct scan_file *file)
{
    static const char *const margins[2] = {"PRETRAV_LIN=", "POSTTRAV_LIN="};
    double n = 0;
    struct lines lines = lines_begin(scan_view(file));
    for (struct string_view line, value; lines_next(&lines, &line);) {
        line = string_view_trim(line);
        if (has_key(line, "NO_POINTS=", &value) && !number_read(value, &n))
            return scan_fail(file, lines.number, "NO_POINTS is no number of points");
        for (size_t end = 0; end < 2; end++)
            if (has_key(line, margins[end], &value) &&
                !(read_length(string_view_trim(value), &out->margin_m[end]) && out->margin_m[end] >= 0))
                return scan_fail(file, lines.number, "%.*s is no length", (int)strlen(margins[end]) - 1, margins[end]);
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
    double n = bytes_number(&count, BYTES_U32);
    const char *found = memmem(file->bytes, file->length, trajectory, strlen(trajectory));
    if (count.overrun || !found)
        return scan_fail(file, 0, "no %s section: the file is cut off; export it again", trajectory);
    struct bytes bytes = bytes_begin(file, (size_t)(found - file->bytes) + MAHR_DATA_BEHIND);
    if (scan_reserve_x(out, n, bytes_left(&bytes) / (3 * sizeof(double)), file) != STATUS_OK)
        return file->status->code;
    for (size_t i = 0; i < out->nx; i++)
        out->x_m[i] = bytes_number(&bytes, BYTES_F64) * mahr_unit_m;
    bytes_skip(&bytes, out->nx * sizeof(double)); /* y, across the profile */
    for (size_t i = 0; i < out->nx; i++)
        out->z_m[i] = bytes_number(&bytes, BYTES_F64) * mahr_unit_m;
    scan_set_units(out, "mm", "mm");
    return STATUS_OK;
}
