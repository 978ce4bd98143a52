/* SPDX-License-Identifier: GPL-3.0-or-later */
/* ISO 5436-2 SMD: header, remarks, heights and checksum, four records that end in ETX; fields end in NUL. The header
 * has from its third line on `CX I n unit scale type increment`, for a map CY, and `CZ A n unit scale type`.
 * Its predecessor, the text PRF of NPL and Taylor Hobson: `1 2`, a title, axes CX and CZ of type M, EOR; remarks with
 * `SPACING CX s`, EOR; an integer for each height, EOR, EOF. A height is integer x scale x unit. */
#include "scan/reader.h"

#include <math.h>
#include <string.h>

static const char etx = 3;
enum { NPL_SNIFF = 512 };

struct axis {
    char type; /* 'I' or 'M': evenly spaced; 'A': stored point by point */
    double n;
    struct scan_unit unit; /* name NULL: there is no such axis */
    double scale, increment;
};

/* What follows the name in `CX I n unit scale type increment`. */
static bool read_axis(struct axis *axis, struct string_view line)
{
    struct string_view word[6];
    size_t count = 0;
    while (count < 6 && scan_word(&line, &word[count]))
        count++;
    if (count < 4)
        return false;
    axis->type = *word[0].start;
    axis->unit = scan_unit_find(word[2]);
    return number_read(word[1], &axis->n) && axis->unit.si > 0 && number_read(word[3], &axis->scale) &&
           (axis->type != 'I' || (count == 6 && number_read(word[5], &axis->increment)));
}

bool scan_smd_sniff(const struct scan_file *file)
{
    return string_view_starts(scan_view(file), "ISO 5436") && memchr(file->bytes, etx, file->length) != NULL;
}

/* Cuts the next record, without its ETX, off `rest`. */
static struct string_view next_record(struct string_view *rest)
{
    struct string_view record = *rest;
    const char *stop = memchr(rest->start, etx, string_view_length(*rest));
    record.end = stop ? stop : rest->end;
    rest->start = stop ? stop + 1 : rest->end;
    return record;
}

static enum status_code read_header(struct axis axis[3], struct string_view header, const struct scan_file *file)
{
    struct lines lines = lines_begin(header);
    for (struct string_view line; lines_next(&lines, &line);) {
        struct string_view field;
        char blank[256];
        size_t length = string_view_length(line) < sizeof blank ? string_view_length(line) : sizeof blank;
        for (size_t i = 0; i < length; i++) /* fields end in NUL */
            blank[i] = line.start[i] ? line.start[i] : ' ';
        line = (struct string_view){blank, blank + length};
        if (lines.number < 3 || !scan_word(&line, &field) || string_view_length(field) != 2 || *field.start != 'C')
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
    struct axis axis[3] = {0};
    struct string_view rest = scan_view(file);
    struct string_view header = next_record(&rest);
    (void)next_record(&rest); /* remarks */
    struct string_view heights = next_record(&rest);
    if (read_header(axis, header, file) != STATUS_OK)
        return file->status->code;
    if (scan_take_text(out, axis[0].n, axis[1].unit.name ? axis[1].n : 1, heights, axis[2].scale * axis[2].unit.si,
                       INFINITY, NULL, file) != STATUS_OK)
        return file->status->code;
    out->dx_m = axis[0].increment * axis[0].scale * axis[0].unit.si;
    out->dy_m = axis[1].increment * axis[1].scale * axis[1].unit.si;
    scan_set_units(out, axis[0].unit.name, axis[2].unit.name);
    return STATUS_OK;
}

bool scan_npl_prf_sniff(const struct scan_file *file)
{
    struct string_view text = scan_view(file), word;
    size_t length = file->length < NPL_SNIFF ? file->length : NPL_SNIFF;
    return scan_word(&text, &word) && string_view_equals(word, "1") && scan_word(&text, &word) &&
           string_view_equals(word, "2") && memmem(file->bytes, length, "\nCX M ", 6) != NULL;
}

enum status_code scan_npl_prf_read(struct scan *out, const struct scan_file *file)
{
    struct axis x = {0}, z = {0};
    double spacing = 0;
    size_t records = 0;
    struct lines lines = lines_begin(scan_view(file));
    for (struct string_view line; records < 2 && lines_next(&lines, &line);) {
        struct string_view whole = string_view_trim(line), word;
        line = whole;
        bool good = true, any = scan_word(&line, &word);
        struct axis *axis = any && string_view_equals(word, "CX") ? &x : &z;
        if (string_view_equals(whole, "EOR"))
            records++;
        else if (records == 0 && any && string_view_is_one_of(word, "CX CZ"))
            good = read_axis(axis, line) && axis->type == 'M';
        else if (records == 1 && string_view_starts(whole, "SPACING CX "))
            good = number_read((struct string_view){whole.start + strlen("SPACING CX "), whole.end}, &spacing);
        if (!good)
            return scan_fail(file, lines.number, "'%s' is not as PRF has it; export the scan again",
                             scan_quote(whole).text);
    }
    if (records < 2 || !x.unit.name || !z.unit.name || !(spacing > 0))
        return scan_fail(file, lines.number,
                         "no CX, CZ or `SPACING CX` above the heights: only evenly spaced PRF profiles can be read");
    struct string_view data = {lines.next, lines.end};
    if (scan_take_text(out, z.n, 1, data, z.scale * z.unit.si, INFINITY, "EOR", file) != STATUS_OK)
        return file->status->code;
    out->dx_m = spacing * x.scale * x.unit.si;
    scan_set_units(out, x.unit.name, z.unit.name);
    return STATUS_OK;
}
