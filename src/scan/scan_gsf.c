/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gwyddion simple field: `Gwyddion Simple Field 1.0`, `Key = value` lines, 1 to 4 NUL up to a multiple of 4 bytes, then
 * XRes x YRes little-endian floats; NaN is missing. */
#include "scan/reader.h"

#include <string.h>

enum status_code scan_gsf_read(struct scan *out, const struct scan_file *file)
{
    double nx = 0, ny = 0, width = 0, height = 0, x_m, z_m;
    char xy_unit[SCAN_UNIT_SIZE] = "", z_unit[SCAN_UNIT_SIZE] = "";
    const struct scan_key keys[] = {{"XRes", .number = &nx},
                                    {"YRes", .number = &ny},
                                    {"XReal", .number = &width},
                                    {"YReal", .number = &height},
                                    {"XYUnits", .unit = xy_unit},
                                    {"ZUnits", .unit = z_unit},
                                    {0}};
    const char *stop = memchr(file->bytes, '\0', file->length);
    if (!stop)
        return scan_fail(file, 0, "no NUL behind the header: the file is cut off");
    size_t length = (size_t)(stop - file->bytes);
    struct lines lines = lines_begin((struct string_view){file->bytes, stop});
    for (struct string_view line; lines_next(&lines, &line);)
        if (scan_take_key(keys, line, lines.number, file) != STATUS_OK)
            return file->status->code;
    if (scan_units(out, xy_unit, z_unit, &x_m, &z_m, file) != STATUS_OK)
        return file->status->code;
    struct bytes bytes = bytes_begin(file, length + 4 - length % 4);
    if (scan_reserve(out, nx, ny, bytes_left(&bytes) / sizeof(float), file) != STATUS_OK)
        return file->status->code;
    for (size_t i = 0; i < out->nx * out->ny; i++)
        out->z_m[i] = bytes_number(&bytes, BYTES_F32) * z_m;
    out->dx_m = width / nx * x_m;
    out->dy_m = height / ny * x_m;
    return STATUS_OK;
}
