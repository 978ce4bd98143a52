/* SPDX-License-Identifier: GPL-3.0-or-later */
/* ISO 5436-2 SMD: four records that end in ETX: header, remarks, heights, checksum; fields end in NUL. The header's
 * third line is `CX I n unit scale type increment`, the next (CY alike, and) `CZ A n unit scale type`. */
#include "scan/reader.h"
#include "scan/string_view.h"

#include <string.h>

static const char etx = 3;

struct smd_axis {
    char type; /* 'I': evenly spaced, 'A': stored point by point */
    size_t n;
    struct scan_unit unit;
    double scale, increment;
};

bool scan_smd_sniff(const struct scan_file *file)
{
    return string_view_starts(scan_view(file), "ISO 5436") && memchr(file->bytes, etx, file->length) != NULL;
}

/* Cuts the next field off a header line: NUL and blanks separate. */
static bool next_field(struct string_view *line, struct string_view *field)
{
    while (line->start < line->end && (*line->start == '\0' || string_view_is_blank_char(*line->start)))
        line->start++;
    field->start = line->start;
    while (line->start < line->end && *line->start != '\0' && !string_view_is_blank_char(*line->start))
        line->start++;
    field->end = line->start;
    return field->end > field->start;
}

/* `CX I n unit scale type increment`, what is behind the name. */
static bool read_axis(struct smd_axis *axis, struct string_view line)
{
    struct string_view field;
    if (!next_field(&line, &field))
        return false;
    axis->type = *field.start;
    if (!next_field(&line, &field) || !number_read_size(field, &axis->n) || !next_field(&line, &field))
        return false;
    axis->unit = scan_unit_find(field);
    if (!(axis->unit.si > 0) || !next_field(&line, &field) || !number_read(field, &axis->scale) ||
        !next_field(&line, &field))
        return false;
    return axis->type != 'I' || (next_field(&line, &field) && number_read(field, &axis->increment));
}

/* The next record of `rest`, without its ETX and the line end behind that. */
static struct string_view next_record(struct string_view *rest)
{
    struct string_view record = *rest;
    const char *stop = memchr(rest->start, etx, string_view_length(*rest));
    record.end = stop ? stop : rest->end;
    rest->start = stop ? stop + 1 : rest->end;
    return record;
}

static enum status_code read_header(struct smd_axis axis[3], struct string_view header, const struct scan_file *file)
{
    struct lines lines = lines_begin(header);
    for (struct string_view line; lines_next(&lines, &line);) {
        struct string_view field;
        if (lines.number < 3 || !next_field(&line, &field) || string_view_length(field) != 2 || *field.start != 'C')
            continue;
        const char *name = strchr("XYZ", field.start[1]);
        if (!name || !*name || !read_axis(&axis[name - "XYZ"], line))
            return scan_fail(file, lines.number, "axis '%s' is not as ISO 5436-2 has it; export the scan again",
                             scan_quote(field).text);
    }
    if (!axis[0].unit.name || !axis[2].unit.name)
        return scan_fail(file, 0, "no axes CX and CZ in the header");
    if (axis[0].type != 'I' || (axis[1].unit.name && axis[1].type != 'I') || axis[2].type != 'A')
        return scan_fail(file, 0, "positions stored point by point: only evenly spaced SMD scans can be read");
    return STATUS_OK;
}

enum status_code scan_smd_read(struct scan *out, const struct scan_file *file)
{
    struct smd_axis axis[3] = {0};
    struct string_view rest = scan_view(file);
    struct string_view header = next_record(&rest);
    (void)next_record(&rest); /* remarks */
    struct string_view heights = next_record(&rest);
    if (read_header(axis, header, file) != STATUS_OK)
        return file->status->code;
    size_t nx = axis[0].n, ny = axis[1].unit.name ? axis[1].n : 1;
    if (scan_take_text(out, nx, ny, heights, axis[2].scale * axis[2].unit.si, NULL, file) != STATUS_OK)
        return file->status->code;
    out->dx_m = axis[0].increment * axis[0].scale * axis[0].unit.si;
    out->dy_m = axis[1].increment * axis[1].scale * axis[1].unit.si;
    scan_set_units(out, axis[0].unit.name, axis[2].unit.name);
    return STATUS_OK;
}
