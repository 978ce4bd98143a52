/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Wyko ASCII: `X Size`, `Y Size`, then a line for each block: name, type, length, value. Pixel_size is in mm,
 * Wavelength in nm; the heights below RAW_DATA are in waves, or in the unit in that line; `Bad` is a missing point. */
#include "scan/reader.h"

#include <math.h>

/* Does `line` begin with `key`, whose blanks may be written as '_'? *rest is what follows. */
static bool has_key(struct string_view line, const char *key, struct string_view *rest)
{
    for (; *key && line.start < line.end; key++, line.start++)
        if (*key == ' ' ? *line.start != ' ' && *line.start != '_' : !string_view_starts(line, (char[]){*key, '\0'}))
            return false;
    *rest = line;
    return *key == '\0' && (line.start == line.end || string_view_is_blank_char(*line.start));
}

/* The last word of `line`, and how many there are. */
static struct string_view last_word(struct string_view line, double *count)
{
    struct string_view word, last = {line.end, line.end};
    for (*count = 0; cell_next(&line, ' ', &word); ++*count)
        last = word;
    return last;
}

/* The lines up to the next block, which begins with its name. */
static struct string_view heights_of(struct lines lines)
{
    struct string_view text = {lines.next, lines.next}, line, rest, word;
    while (lines_next(&lines, &line)) {
        rest = string_view_trim(line);
        if (cell_next(&rest, ' ', &word) && !scan_is_missing(word) &&
            !number_scan(word, NUMBER_POINT, NULL, &(double){0}))
            break;
        text.end = line.end;
    }
    return text;
}

enum status_code scan_wyko_read(struct scan *out, const struct scan_file *file)
{
    double nx = 0, ny = 0, pixel_mm = 0, wave_nm = 0, aspect = 1, words;
    const struct {
        const char *key;
        double *number;
    } keys[] = {
        {"X Size", &nx}, {"Y Size", &ny}, {"Pixel size", &pixel_mm}, {"Wavelength", &wave_nm}, {"Aspect", &aspect}};
    struct lines lines = lines_begin(scan_view(file));
    struct string_view line, rest;
    bool heights = false;
    while (!heights && lines_next(&lines, &line)) {
        line = string_view_trim(line);
        heights = has_key(line, "RAW DATA", &rest);
        for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
            if (has_key(line, keys[i].key, &rest) &&
                !(number_read(last_word(rest, &words), keys[i].number) && *keys[i].number > 0))
                return scan_fail(file, lines.number, "'%s' is no %s; correct this line",
                                 scan_quote(last_word(rest, &words)).text, keys[i].key);
    }
    if (!heights)
        return scan_fail(file, 0, "no block RAW_DATA; export the heights with it");
    const char *unit = scan_unit_find(last_word(rest, &words)).name;
    double z_m = unit ? scan_unit_m(unit) : wave_nm * 1e-9;
    if (!(pixel_mm > 0 && z_m > 0))
        return scan_fail(file, 0, "no %s in the header; export the file with it",
                         pixel_mm > 0 ? "Wavelength" : "Pixel_size");
    struct string_view text = heights_of(lines);
    bool by_columns = nx > 1 && ny > 1 && nx != ny && lines_next(&lines, &line);
    (void)last_word(line, &words);
    by_columns = by_columns && words == ny; /* a line holds a column of the map */
    if (scan_take_text(out, by_columns ? ny : nx, by_columns ? nx : ny, text, z_m, INFINITY, NULL, file) != STATUS_OK)
        return file->status->code;
    out->dx_m = pixel_mm * 1e-3;
    out->dy_m = ny > 1 ? out->dx_m * aspect : 0;
    scan_set_units(out, "mm", unit ? unit : "nm");
    if (by_columns) {
        out->dx_m = out->dy_m;
        out->dy_m = pixel_mm * 1e-3;
        return scan_transpose(out, file->status);
    }
    return STATUS_OK;
}
