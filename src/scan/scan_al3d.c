/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Alicona AL3D: a magic, tags of 52 bytes (key 20, value 30, CRLF; the second, TagCount, says how many follow), and at
 * DepthImageOffset rows of little-endian floats in metres, each row filled up to a multiple of 8 bytes. */
#include "scan/reader.h"

#include <math.h>

enum { AL3D_MAGIC = sizeof "AliconaImaging\0\r\n" - 1, AL3D_KEY = 20, AL3D_VALUE = 30, AL3D_TAGS = 1000 };

enum status_code scan_al3d_read(struct scan *out, const struct scan_file *file)
{
    double tags = 0, cols = 0, rows = 0, offset = 0, missing = NAN;
    const struct {
        const char *key;
        double *number;
    } keys[] = {{"TagCount", &tags},
                {"Cols", &cols},
                {"Rows", &rows},
                {"DepthImageOffset", &offset},
                {"PixelSizeXMeter", &out->dx_m},
                {"PixelSizeYMeter", &out->dy_m},
                {"InvalidPixelValue", &missing}};
    struct bytes bytes = bytes_begin(file, AL3D_MAGIC);
    for (double tag = 0; tag < tags + 2 && tag < AL3D_TAGS && !bytes.overrun; tag++) {
        struct string_view key = bytes_text(&bytes, AL3D_KEY), value = bytes_text(&bytes, AL3D_VALUE);
        bytes_skip(&bytes, 2);
        for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
            if (string_view_equals(key, keys[i].key))
                (void)number_read(value, keys[i].number); /* else it stays 0, which is refused below */
    }
    if (scan_check_points(cols, rows, file) != STATUS_OK)
        return file->status->code;
    if (!(offset >= AL3D_MAGIC && offset <= (double)file->length))
        return scan_fail(file, 0, "no depth image in the file (DepthImageOffset); export the scan with it");
    size_t nx = (size_t)cols, ny = (size_t)rows, stride = (nx * sizeof(float) + 7) / 8 * 8;
    bytes = bytes_begin(file, (size_t)offset);
    if (scan_reserve(out, cols, rows, bytes_left(&bytes) / stride * nx, file) != STATUS_OK)
        return file->status->code;
    for (size_t row = 0; row < ny; row++) {
        for (size_t i = 0; i < nx; i++) {
            double value = bytes_number(&bytes, BYTES_F32);
            /* the tag has fewer digits than the number it stands for */
            bool none = fabs(value - missing) <= 1e-6 * fabs(missing) || !isfinite(value);
            out->z_m[row * nx + i] = none ? NAN : value;
        }
        bytes_skip(&bytes, stride - nx * sizeof(float));
    }
    out->dx_m = fabs(out->dx_m);
    out->dy_m = fabs(out->dy_m);
    scan_set_units(out, "m", "m");
    return STATUS_OK;
}
