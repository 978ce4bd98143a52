/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Digital Surf SUR (surfaces) and PRO (profiles): a header of 512 bytes, remarks, and 16 or 32-bit integers, perhaps
 * compressed by zlib in several streams. z = integer x step + offset in the unit of the step. */
#include "base/limits.h"
#include "scan/reader.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

static const char plain[] = "DIGITAL SURF";
enum { SUR_PROFILE = 1, SUR_SURFACE = 2, SUR_HEADER = 512, SUR_UNIT = 16, SUR_STREAMS = 64 };

struct sur_header {
    int format, objects, kind, special, bits;
    int32_t z_min;
    uint32_t nx, ny;
    double step[3], z_offset;
    char unit[3][SUR_UNIT + 1];
    size_t remarks; /* bytes between header and heights */
};

static bool read_header(struct sur_header *header, struct bytes *bytes)
{
    bytes_skip(bytes, strlen(plain));
    header->format = bytes_i16(bytes);
    header->objects = bytes_i16(bytes);
    bytes_skip(bytes, 2); /* version */
    header->kind = bytes_i16(bytes);
    bytes_skip(bytes, 30 + 30 + 6); /* names, material, acquisition, range */
    header->special = bytes_i16(bytes);
    bytes_skip(bytes, 2 + 8); /* absolute, gauge resolution and reserved */
    header->bits = bytes_i16(bytes);
    header->z_min = bytes_i32(bytes);
    bytes_skip(bytes, 4); /* largest */
    header->nx = bytes_u32(bytes);
    header->ny = bytes_u32(bytes);
    bytes_skip(bytes, 4); /* their product */
    for (size_t axis = 0; axis < 3; axis++)
        header->step[axis] = (double)bytes_f32(bytes);
    bytes_skip(bytes, 3 * 16); /* names of the axes */
    for (size_t axis = 0; axis < 3; axis++)
        scan_copy(header->unit[axis], sizeof header->unit[axis], bytes_text(bytes, SUR_UNIT));
    /* units and ratios for display, flags, reserved, time, duration, reserved */
    bytes_skip(bytes, 3 * 16 + 3 * 4 + 3 * 2 + 12 + 7 * 2 + 4 + 10);
    header->remarks = bytes_u16(bytes);
    header->remarks += bytes_u16(bytes);
    bytes_skip(bytes, 128 + 8); /* client's zone, offsets of x and y */
    header->z_offset = (double)bytes_f32(bytes);
    bytes_skip(bytes, 34);
    return !bytes->overrun;
}

/* Inflates the streams behind `bytes`: their number, the two sizes (inflated, deflated) of each, the streams. What the
 * heights take, `most` bytes, and the file's own size bound what is allocated. */
static enum status_code inflate_streams(char **data, size_t *size, struct bytes *bytes, size_t most,
                                        const struct scan_file *file)
{
    uint32_t streams = bytes_u32(bytes), length[SUR_STREAMS][2] = {{0}};
    size_t total = 0, room = limit_unpacked(bytes_left(bytes));
    if (streams == 0 || streams > SUR_STREAMS)
        return scan_fail(file, 0, "%u compressed streams: the file is damaged", streams);
    for (uint32_t i = 0; i < streams; i++) {
        length[i][0] = bytes_u32(bytes);
        length[i][1] = bytes_u32(bytes);
        total += length[i][0];
    }
    if (bytes->overrun || total > room)
        return scan_fail(file, 0, "compressed streams longer than the file can hold; copy it again");
    if (total > most)
        return scan_fail(file, 0, "compressed streams of %zu bytes, where the heights take %zu; copy it again", total,
                         most);
    *data = malloc(total + 1);
    if (!*data)
        return status_memory(file->status);
    for (uint32_t i = 0; i < streams; i++) {
        const char *from = bytes->at;
        bytes_skip(bytes, length[i][1]);
        uLongf got = length[i][0];
        if (bytes->overrun || uncompress((Bytef *)*data + *size, &got, (const Bytef *)from, length[i][1]) != Z_OK ||
            got != length[i][0])
            return scan_fail(file, 0, "compressed stream %u is damaged; copy the file again", i + 1);
        *size += got;
    }
    return STATUS_OK;
}

static enum bytes_type type_of(const struct sur_header *header)
{
    return header->bits == 16 ? BYTES_I16 : BYTES_I32;
}

static size_t rows_of(const struct sur_header *header)
{
    return header->kind == SUR_PROFILE ? 1 : header->ny;
}

static enum status_code take_heights(struct scan *out, const struct sur_header *header, struct bytes bytes,
                                     const struct scan_file *file)
{
    double x_m, z_m;
    enum bytes_type type = type_of(header);
    size_t ny = rows_of(header);
    if (scan_units(out, header->unit[0], header->unit[2], &x_m, &z_m, file) != STATUS_OK ||
        scan_reserve(out, header->nx, ny, bytes_left(&bytes) / bytes_size(type), file) != STATUS_OK)
        return file->status->code;
    double missing = header->special == 1 ? (double)header->z_min - 2 : NAN;
    for (size_t i = 0; i < out->nx * ny; i++) {
        double value = bytes_number(&bytes, type);
        out->z_m[i] = value == missing ? NAN : (value * header->step[2] + header->z_offset) * z_m;
    }
    double y_m = scan_unit_m(header->unit[1]);
    out->dx_m = header->step[0] * x_m;
    out->dy_m = header->step[1] * (y_m > 0 ? y_m : x_m);
    if (header->objects > 1)
        scan_warn(out, "the file holds %d objects: only the first was read", header->objects);
    return STATUS_OK;
}

enum status_code scan_sur_read(struct scan *out, const struct scan_file *file)
{
    struct sur_header header = {0};
    struct bytes bytes = bytes_begin(file, 0);
    if (!read_header(&header, &bytes))
        return scan_fail(file, 0, "the file ends within its header of %d bytes", SUR_HEADER);
    if (header.format != 0)
        return scan_fail(file, 0, "byte order of old Macintosh computers; save the file again with MountainsMap");
    if (header.kind != SUR_PROFILE && header.kind != SUR_SURFACE)
        return scan_fail(file, 0, "kind %d is neither profile nor surface; export one of these", header.kind);
    if (header.bits != 16 && header.bits != 32)
        return scan_fail(file, 0, "%d bits a point: only 16 and 32 can be read", header.bits);
    bytes_skip(&bytes, header.remarks);
    if (string_view_starts(scan_view(file), plain))
        return take_heights(out, &header, bytes, file);
    if (scan_check_points(header.nx, rows_of(&header), file) != STATUS_OK)
        return file->status->code;
    char *data = NULL;
    size_t size = 0, most = header.nx * rows_of(&header) * bytes_size(type_of(&header));
    enum status_code code = inflate_streams(&data, &size, &bytes, most, file);
    if (code == STATUS_OK)
        code = take_heights(out, &header, (struct bytes){data, data + size, false}, file);
    free(data);
    return code;
}
