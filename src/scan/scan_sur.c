/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Digital Surf SUR (surfaces) and PRO (profiles): a header of 512 bytes, remarks, and integers of 16 or 32 bits,
 * perhaps compressed by zlib in several streams. z = integer x step + offset, in the unit of the step. */
#include "base/limits.h"
#include "scan/reader.h"

#include <math.h>
#include <stdlib.h>
#include <zlib.h>

enum { SUR_PROFILE = 1, SUR_SURFACE = 2, SUR_HEADER = 512, SUR_UNIT = 16, SUR_STREAMS = 64 };

struct sur_header {
    double format, objects, kind, special, bits, z_min, nx, ny, step[3], remarks, private, z_offset;
    char unit[3][SUR_UNIT + 1];
};

static void read_header(struct sur_header *header, const struct scan_file *file)
{
    const struct {
        size_t at;
        enum bytes_type type;
        double *number;
    } fields[] = {
        {12, BYTES_I16, &header->format},   {14, BYTES_I16, &header->objects},   {18, BYTES_I16, &header->kind},
        {86, BYTES_I16, &header->special},  {98, BYTES_I16, &header->bits},      {100, BYTES_I32, &header->z_min},
        {108, BYTES_U32, &header->nx},      {112, BYTES_U32, &header->ny},       {120, BYTES_F32, &header->step[0]},
        {124, BYTES_F32, &header->step[1]}, {128, BYTES_F32, &header->step[2]},  {334, BYTES_U16, &header->remarks},
        {336, BYTES_U16, &header->private}, {474, BYTES_F32, &header->z_offset},
    };
    for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
        struct bytes bytes = bytes_begin(file, fields[i].at);
        *fields[i].number = bytes_number(&bytes, fields[i].type);
    }
    struct bytes units = bytes_begin(file, 180);
    for (size_t axis = 0; axis < 3; axis++)
        scan_copy(header->unit[axis], sizeof header->unit[axis], bytes_text(&units, SUR_UNIT));
}

/* Unpacks the streams: their number, the two sizes (unpacked, packed) of each, the streams. No more is allocated than
 * the heights take, `most` bytes, and than a file of this size can hold. */
static enum status_code inflate_streams(char **data, size_t *size, struct bytes bytes, size_t most,
                                        const struct scan_file *file)
{
    double streams = bytes_number(&bytes, BYTES_U32), total = 0;
    uLong length[SUR_STREAMS][2] = {{0}};
    size_t room = limit_unpacked(bytes_left(&bytes));
    if (streams == 0 || streams > SUR_STREAMS)
        return scan_fail(file, 0, "%.0f compressed streams: the file is damaged", streams);
    for (size_t i = 0; i < (size_t)streams; i++) {
        length[i][0] = (uLong)bytes_number(&bytes, BYTES_U32);
        length[i][1] = (uLong)bytes_number(&bytes, BYTES_U32);
        total += (double)length[i][0];
    }
    if (bytes.overrun || total > (double)room)
        return scan_fail(file, 0, "compressed streams longer than the file can hold; copy it again");
    if (total > (double)most)
        return scan_fail(file, 0, "compressed streams of %.0f bytes, where the heights take %zu; copy it again", total,
                         most);
    *data = malloc((size_t)total + 1);
    if (!*data)
        return status_memory(file->status);
    for (size_t i = 0; i < (size_t)streams; i++) {
        const char *from = bytes.at;
        bytes_skip(&bytes, length[i][1]);
        uLong got = length[i][0];
        if (bytes.overrun || uncompress((Bytef *)*data + *size, &got, (const Bytef *)from, length[i][1]) != Z_OK ||
            got != length[i][0])
            return scan_fail(file, 0, "compressed stream %zu is damaged; copy the file again", i + 1);
        *size += got;
    }
    return STATUS_OK;
}

static enum status_code take_heights(struct scan *out, const struct sur_header *header, struct bytes bytes,
                                     const struct scan_file *file)
{
    double x_m, z_m, y_m = scan_unit_m(header->unit[1]), missing = header->special == 1 ? header->z_min - 2 : NAN;
    enum bytes_type type = header->bits == 16 ? BYTES_I16 : BYTES_I32;
    if (scan_units(out, header->unit[0], header->unit[2], &x_m, &z_m, file) != STATUS_OK ||
        scan_reserve(out, header->nx, header->ny, bytes_left(&bytes) / bytes_size(type), file) != STATUS_OK)
        return file->status->code;
    for (size_t i = 0; i < out->nx * out->ny; i++) {
        double value = bytes_number(&bytes, type);
        out->z_m[i] = value == missing ? NAN : (value * header->step[2] + header->z_offset) * z_m;
    }
    out->dx_m = header->step[0] * x_m;
    out->dy_m = header->step[1] * (y_m > 0 ? y_m : x_m);
    if (header->objects > 1)
        scan_warn(out, "the file holds %.0f objects: only the first was read", header->objects);
    return STATUS_OK;
}

enum status_code scan_sur_read(struct scan *out, const struct scan_file *file)
{
    struct sur_header header = {0};
    read_header(&header, file);
    if (file->length < SUR_HEADER)
        return scan_fail(file, 0, "the file ends within its header of %d bytes", SUR_HEADER);
    if (header.format != 0)
        return scan_fail(file, 0, "byte order of old Macintosh computers; save the file again with MountainsMap");
    if (header.kind != SUR_PROFILE && header.kind != SUR_SURFACE)
        return scan_fail(file, 0, "kind %.0f is neither profile nor surface; export one of these", header.kind);
    if (header.bits != 16 && header.bits != 32)
        return scan_fail(file, 0, "%.0f bits a point: only 16 and 32 can be read", header.bits);
    header.ny = header.kind == SUR_PROFILE ? 1 : header.ny;
    struct bytes bytes = bytes_begin(file, SUR_HEADER + (size_t)(header.remarks + header.private));
    if (string_view_starts(scan_view(file), "DIGITAL SURF"))
        return take_heights(out, &header, bytes, file);
    if (scan_check_points(header.nx, header.ny, file) != STATUS_OK)
        return file->status->code;
    OWNED(memory_free) char *data = NULL;
    size_t size = 0;
    enum status_code code =
        inflate_streams(&data, &size, bytes, (size_t)(header.nx * header.ny * header.bits / 8), file);
    return code == STATUS_OK ? take_heights(out, &header, (struct bytes){data, data + size, false}, file) : code;
}
