/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Wyko (Veeco, Bruker Vision) text, `Wyko ASCII Data File Format`: `X Size` and `Y Size`, a line a block of name, type,
 * length and value, and below the block RAW_DATA a line of heights a row: Bad where nothing was measured. Pixel_size is
 * in mm; heights are in waves of Wavelength [nm] times Mult, or in the unit that the line RAW_DATA names. */
#include "scan/reader.h"
#include "scan/string_view.h"

#include <string.h>

static const double pixel_unit_m = 1e-3, wavelength_unit_m = 1e-9;

bool scan_wyko_sniff(const struct scan_file *file)
{
    return string_view_starts(scan_view(file), "Wyko ASCII Data File Format");
}

struct wyko_header {
    size_t nx, ny;
    double pixel, aspect, wavelength, multiple;
};

/* The last field of a line that begins with `name`, of its lines. */
static bool read_field(double *out, struct string_view line, const char *name)
{
    struct string_view cell, last = {line.start, line.start};
    if (!string_view_starts(line, name))
        return false;
    while (cell_next(&line, '\t', &cell))
        last = cell.start < cell.end ? cell : last;
    return number_read(last, out) && *out > 0;
}

static bool read_size(size_t *out, struct string_view line, const char *name)
{
    double value = 0;
    if (!read_field(&value, line, name) || value > 1e9)
        return false;
    *out = (size_t)value;
    return true;
}

/* Is it the line of the block of heights? *unit_m is that of its fourth field, where there is one, else 0. */
static bool is_data(double *unit_m, struct string_view line)
{
    struct string_view cell;
    *unit_m = 0;
    if (!string_view_starts(line, "RAW DATA") && !string_view_starts(line, "RAW_DATA"))
        return false;
    for (size_t i = 0; cell_next(&line, '\t', &cell); i++)
        *unit_m = i == 3 && cell.start < cell.end ? scan_unit_find(cell).si : *unit_m;
    return true;
}

enum status_code scan_wyko_read(struct scan *out, const struct scan_file *file)
{
    struct wyko_header header = {.aspect = 1, .multiple = 1};
    struct lines lines = lines_begin(scan_view(file));
    for (struct string_view line; lines_next(&lines, &line);) {
        double unit_m;
        (void)(read_size(&header.nx, line, "X Size") || read_size(&header.ny, line, "Y Size") ||
               read_field(&header.pixel, line, "Pixel_size") || read_field(&header.aspect, line, "Aspect") ||
               read_field(&header.wavelength, line, "Wavelength") || read_field(&header.multiple, line, "Mult"));
        if (!is_data(&unit_m, line))
            continue;
        if (!(header.pixel > 0) || (!(unit_m > 0) && !(header.wavelength > 0)))
            return scan_fail(file, lines.number,
                             "no Pixel_size or no Wavelength above this line; export the map again");
        out->nx = header.nx;
        out->ny = header.ny;
        const double height_m = unit_m > 0 ? unit_m : header.wavelength * wavelength_unit_m * header.multiple;
        scan_set_units(out, "mm", unit_m > 0 ? scan_unit_of(unit_m) : "nm");
        out->dx_m = header.pixel * pixel_unit_m;
        out->dy_m = out->dx_m * header.aspect;
        return scan_take_text(out, (struct string_view){lines.next, lines.end}, height_m, NULL, file);
    }
    return scan_fail(file, 0, "no block RAW_DATA; export the map with its heights");
}
