/* SPDX-License-Identifier: GPL-3.0-or-later */
/* NPL and Taylor Hobson text PRF: `1 2`, a title, the axes CX and CZ, EOR; remarks with `SPACING CX s`, EOR; one
 * integer a height, EOR, EOF. A height is integer x factor x unit. */
#include "scan/reader.h"
#include "scan/string_view.h"

#include <string.h>

enum { NPL_SNIFF = 512 };

struct npl_axis {
    size_t n;
    struct scan_unit unit;
    double factor;
};

bool scan_npl_prf_sniff(const struct scan_file *file)
{
    struct string_view text = scan_view(file), word;
    size_t length = file->length < NPL_SNIFF ? file->length : NPL_SNIFF;
    return scan_word(&text, &word) && string_view_equals(word, "1") && scan_word(&text, &word) &&
           string_view_equals(word, "2") && memmem(file->bytes, length, "\nCX M ", 6) != NULL;
}

/* `CX M 2.2401e+004 MM 1.0e+000 D`: name, M, points, unit, factor, data type. */
static bool read_axis(struct npl_axis *axis, struct string_view line)
{
    struct string_view word;
    double n;
    if (!scan_word(&line, &word) || !scan_word(&line, &word) || !string_view_equals(word, "M"))
        return false;
    if (!scan_word(&line, &word) || !number_read(word, &n) || n < 1 || n > 1e12)
        return false;
    axis->n = (size_t)n;
    if (!scan_word(&line, &word))
        return false;
    axis->unit = scan_unit_find(word);
    return axis->unit.si > 0 && scan_word(&line, &word) && number_read(word, &axis->factor);
}

enum status_code scan_npl_prf_read(struct scan *out, const struct scan_file *file)
{
    struct npl_axis x = {0}, z = {0};
    double spacing = 0;
    size_t records = 0;
    struct lines lines = lines_begin(scan_view(file));
    for (struct string_view line; records < 2 && lines_next(&lines, &line);) {
        line = string_view_trim(line);
        bool good = true;
        if (string_view_equals(line, "EOR"))
            records++;
        else if (records == 0 && string_view_starts(line, "CX "))
            good = read_axis(&x, line);
        else if (records == 0 && string_view_starts(line, "CZ "))
            good = read_axis(&z, line);
        else if (records == 1 && string_view_starts(line, "SPACING CX "))
            good = number_read((struct string_view){line.start + strlen("SPACING CX "), line.end}, &spacing);
        if (!good)
            return scan_fail(file, lines.number, "'%s' is not as PRF has it; export the scan again",
                             scan_quote(line).text);
    }
    if (records < 2 || !x.unit.name || !z.unit.name || !(spacing > 0))
        return scan_fail(file, lines.number,
                         "no CX, CZ or `SPACING CX` above the heights: only evenly spaced PRF profiles can be read");
    struct string_view data = {lines.next, lines.end};
    if (scan_take_text(out, z.n, 1, data, z.factor * z.unit.si, "EOR", file) != STATUS_OK)
        return file->status->code;
    out->dx_m = spacing * x.factor * x.unit.si;
    scan_set_units(out, x.unit.name, z.unit.name);
    return STATUS_OK;
}
