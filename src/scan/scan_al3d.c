/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Alicona AL3D: a magic, tags of 52 bytes (key 20, value 30, CRLF; the second, TagCount, says how many follow), and at
 * DepthImageOffset rows of little-endian floats in metres, each row filled up to a multiple of 8 bytes. */
#include "scan/reader.h"

#include <math.h>

enum { AL3D_MAGIC = sizeof "AliconaImaging\0\r\n" - 1, AL3D_KEY = 20, AL3D_VALUE = 30, AL3D_TAGS = 1000 };

struct al3d_header {
    double tags, nx, ny, offset, dx, dy, invalid;
};

static void read_header(struct al3d_header *header, struct bytes *bytes)
{
    struct {
        const char *key;
        double *number;
    } keys[] = {{"TagCount", &header->tags},
                {"Cols", &header->nx},
                {"Rows", &header->ny},
                {"DepthImageOffset", &header->offset},
                {"PixelSizeXMeter", &header->dx},
                {"PixelSizeYMeter", &header->dy},
                {"InvalidPixelValue", &header->invalid}};
    for (double tag = 0; tag < header->tags + 2 && tag < AL3D_TAGS && !bytes->overrun; tag++) {
        struct string_view key = bytes_text(bytes, AL3D_KEY), value = bytes_text(bytes, AL3D_VALUE);
        bytes_skip(bytes, 2);
        for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
            if (string_view_equals(key, keys[i].key))
                (void)number_read(value, keys[i].number); /* else it stays 0, which is refused below */
    }
}

enum status_code scan_al3d_read(struct scan *out, const struct scan_file *file)
{
    struct al3d_header header = {.invalid = NAN};
    struct bytes bytes = bytes_begin(file, AL3D_MAGIC);
    read_header(&header, &bytes);
    if (!(header.nx >= 1 && header.nx <= UINT32_MAX && header.ny >= 1 && header.ny <= UINT32_MAX))
        return scan_fail(file, 0, "no numbers of points in the tags Cols and Rows");
    if (!(header.offset >= AL3D_MAGIC && header.offset <= (double)file->length))
        return scan_fail(file, 0, "no depth image in the file (DepthImageOffset); export the scan with it");
    size_t nx = (size_t)header.nx, ny = (size_t)header.ny, stride = (nx * sizeof(float) + 7) / 8 * 8;
    bytes = bytes_begin(file, (size_t)header.offset);
    if (scan_reserve(out, nx, ny, bytes_left(&bytes) / stride * nx, file) != STATUS_OK)
        return file->status->code;
    for (size_t row = 0; row < ny; row++) {
        for (size_t i = 0; i < nx; i++) {
            double value = bytes_number(&bytes, BYTES_F32);
            /* the tag has fewer digits than the number it stands for */
            bool invalid = fabs(value - header.invalid) <= 1e-6 * fabs(header.invalid) || !isfinite(value);
            out->z_m[row * nx + i] = invalid ? NAN : value;
        }
        bytes_skip(&bytes, stride - nx * sizeof(float));
    }
    out->dx_m = fabs(header.dx);
    out->dy_m = fabs(header.dy);
    scan_set_units(out, "m", "m");
    return STATUS_OK;
}
