/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gwyddion simple field: `Gwyddion Simple Field 1.0`, `Key = value` lines, 1 to 4 NUL up to a multiple of 4 bytes, then
 * XRes x YRes little-endian floats; NaN is missing. */
#include "scan/reader.h"

#include <string.h>

struct gsf_header {
    size_t nx, ny;
    double width, height;
    char xy_unit[SCAN_UNIT_SIZE], z_unit[SCAN_UNIT_SIZE];
};

static enum status_code read_header(struct gsf_header *header, struct string_view text, const struct scan_file *file)
{
    const struct scan_key keys[] = {{"XRes", .count = &header->nx},
                                    {"YRes", .count = &header->ny},
                                    {"XReal", .number = &header->width},
                                    {"YReal", .number = &header->height},
                                    {"XYUnits", .unit = header->xy_unit},
                                    {"ZUnits", .unit = header->z_unit},
                                    {0}};
    struct lines lines = lines_begin(text);
    for (struct string_view line; lines_next(&lines, &line);)
        if (scan_take_key(keys, line, lines.number, file) != STATUS_OK)
            return file->status->code;
    return STATUS_OK;
}

enum status_code scan_gsf_read(struct scan *out, const struct scan_file *file)
{
    struct gsf_header header = {0};
    double x_m, z_m;
    const char *stop = memchr(file->bytes, '\0', file->length);
    if (!stop)
        return scan_fail(file, 0, "no NUL behind the header: the file is cut off");
    size_t length = (size_t)(stop - file->bytes);
    if (read_header(&header, (struct string_view){file->bytes, stop}, file) != STATUS_OK ||
        scan_units(out, header.xy_unit, header.z_unit, &x_m, &z_m, file) != STATUS_OK)
        return file->status->code;
    struct bytes bytes = bytes_begin(file, length + 4 - length % 4);
    if (scan_reserve(out, header.nx, header.ny, bytes_left(&bytes) / sizeof(float), file) != STATUS_OK)
        return file->status->code;
    for (size_t i = 0; i < header.nx * header.ny; i++)
        out->z_m[i] = bytes_number(&bytes, BYTES_F32) * z_m;
    out->dx_m = header.width / (double)header.nx * x_m;
    out->dy_m = header.height / (double)header.ny * x_m;
    return STATUS_OK;
}
