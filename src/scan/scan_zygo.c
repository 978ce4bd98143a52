/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Zygo MetroPro text, `Zygo ASCII Data File` and `Zygo XYZ Data File`: a header of twelve lines, then blocks that end
 * in a line `#`. Header: line 4 first column, first row, columns, rows; line 8 source, scale factor S, wavelength W
 * [m], aperture, obliquity O, magnification, lateral resolution [m], time; line 11 phase resolution: 0, 1, 2 for
 * R = 4096, 32768, 131072. ASCII: a block of intensities, perhaps empty, and one of phases; a height is phase S O W/R,
 * phases from 2147483640 on are missing. XYZ: lines `column row height`, in micrometres or `No Data`. */
#include "scan/reader.h"

#include <math.h>
#include <string.h>

static const double phase_missing = 2147483640;
static const double xyz_unit_m = 1e-6;
enum { HEADER_LINES = 12, SIZE_LINE = 4, OPTICS_LINE = 8, PHASE_LINE = 11, FIELDS = 8 };

/* The numbers at the beginning of a line, and how many there are. */
static size_t read_numbers(double out[FIELDS], struct string_view line)
{
    struct string_view word;
    size_t count = 0;
    while (count < FIELDS && scan_word(&line, &word) && number_read(word, &out[count]))
        count++;
    return count;
}

/* The spacing, columns and rows, and the height of one phase. */
static enum status_code read_header(struct scan *out, double size[2], double *phase_m, struct lines *lines,
                                    const struct scan_file *file)
{
    static const double resolutions[] = {4096, 32768, 131072};
    double scale = NAN;
    struct string_view line;
    for (size_t n = 1; n <= HEADER_LINES && lines_next(lines, &line); n++) {
        double field[FIELDS] = {0};
        const size_t count = read_numbers(field, line);
        if (n == SIZE_LINE) {
            if (count < 4)
                return scan_fail(file, n, "no numbers of columns and rows here; export the map again");
            memcpy(size, field + 2, 2 * sizeof *size);
        } else if (n == OPTICS_LINE) {
            if (count < 7 || !(field[6] > 0) || !(field[1] > 0 && field[2] > 0 && field[4] > 0))
                return scan_fail(file, n,
                                 "no scale factor, wavelength, obliquity or lateral resolution here; calibrate the "
                                 "instrument and export the map again");
            scale = field[1] * field[2] * field[4];
            out->dx_m = out->dy_m = field[6];
        } else if (n == PHASE_LINE) {
            if (count < 1 || !(field[0] == 0 || field[0] == 1 || field[0] == 2))
                return scan_fail(file, n, "no phase resolution 0, 1 or 2 here; export the map again");
            *phase_m = scale / resolutions[(size_t)field[0]];
        }
    }
    return lines->number == HEADER_LINES ? STATUS_OK : scan_fail(file, 0, "the header is cut off; copy the file again");
}

/* Moves behind the next line that is `#`. */
static bool skip_block(struct lines *lines)
{
    for (struct string_view line; lines_next(lines, &line);)
        if (string_view_equals(string_view_trim(line), "#"))
            return true;
    return false;
}

static enum status_code read_phases(struct scan *out, const double size[2], struct lines lines, double phase_m,
                                    const struct scan_file *file)
{
    if (!skip_block(&lines) || !skip_block(&lines))
        return scan_fail(file, 0, "no block of phases; copy the file again");
    return scan_take_text(out, size[0], size[1], (struct string_view){lines.next, lines.end}, phase_m, phase_missing,
                          "#", file);
}

static enum status_code read_points(struct scan *out, const double size[2], struct lines lines,
                                    const struct scan_file *file)
{
    enum { SHORTEST = 6 }; /* bytes of `0 0 1` and its end */
    if (!skip_block(&lines))
        return scan_fail(file, 0, "no line `#` above the points; copy the file again");
    if (scan_reserve(out, size[0], size[1], (size_t)(lines.end - lines.next + 1) / SHORTEST, file) != STATUS_OK)
        return file->status->code;
    for (size_t i = 0; i < out->nx * out->ny; i++)
        out->z_m[i] = NAN;
    for (struct string_view line; lines_next(&lines, &line) && !string_view_equals(string_view_trim(line), "#");) {
        struct string_view word[3], rest = line;
        size_t column = 0, row = 0, count = 0;
        double height;
        while (count < 3 && scan_word(&rest, &word[count]))
            count++;
        if (count == 0)
            continue;
        if (count < 3 || !number_read_size(word[0], &column) || !number_read_size(word[1], &row) || column >= out->nx ||
            row >= out->ny)
            return scan_fail(file, lines.number,
                             "'%s' is no line `column row height` of a map of %zu x %zu; correct it",
                             scan_quote(line).text, out->nx, out->ny);
        if (number_read(word[2], &height))
            out->z_m[row * out->nx + column] = height * xyz_unit_m;
        else if (!string_view_equals(word[2], "No"))
            return scan_fail(file, lines.number, "'%s' is no height; correct it or write No Data",
                             scan_quote(word[2]).text);
    }
    return STATUS_OK;
}

enum status_code scan_zygo_read(struct scan *out, const struct scan_file *file)
{
    double size[2] = {0}, phase_m = NAN;
    struct lines lines = lines_begin(scan_view(file));
    if (read_header(out, size, &phase_m, &lines, file) != STATUS_OK)
        return file->status->code;
    const bool xyz = string_view_starts(scan_view(file), "Zygo XYZ");
    scan_set_units(out, "m", xyz ? "um" : "m");
    return xyz ? read_points(out, size, lines, file) : read_phases(out, size, lines, phase_m, file);
}
