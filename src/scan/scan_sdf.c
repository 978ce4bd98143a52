/* SPDX-License-Identifier: GPL-3.0-or-later */
/* ISO 25178-71 SDF and its predecessors: 'a' (text) or 'b' (binary) and a version. Scales are metres per step and per
 * unit of height. Text: `Key = value` lines, `*`, heights, `*`, a trailer. Binary: a header of 81 bytes, heights. */
#include "scan/reader.h"

#include <math.h>

static const char *const sdf_versions[] = {"ISO-", "BCR-", "BCR - ", "NPL-"};
enum { SDF_BINARY_HEADER = 81, SDF_OLYMPUS_EXTRA = 8 };

struct sdf_header {
    double nx, ny, compression, type, x_scale, y_scale, z_scale;
};

bool scan_sdf_sniff(const struct scan_file *file)
{
    if (file->length < 8 || (file->bytes[0] != 'a' && file->bytes[0] != 'b'))
        return false;
    struct string_view version = {file->bytes + 1, file->bytes + file->length};
    for (size_t i = 0; i < sizeof sdf_versions / sizeof *sdf_versions; i++)
        if (string_view_starts(version, sdf_versions[i]))
            return true;
    return false;
}

static enum status_code check_header(struct scan *out, const struct sdf_header *header, const struct scan_file *file)
{
    if (header->compression != 0)
        return scan_fail(file, 0, "compressed SDF (Compression = %.0f) cannot be read; export it uncompressed",
                         header->compression);
    if (!isfinite(header->z_scale) || header->z_scale == 0)
        return scan_fail(file, 0, "a Zscale of %g gives no heights", header->z_scale);
    out->dx_m = header->x_scale;
    out->dy_m = header->y_scale;
    scan_set_units(out, "m", "m");
    return STATUS_OK;
}

static enum status_code read_text(struct scan *out, const struct scan_file *file)
{
    struct sdf_header header = {0};
    const struct scan_key keys[] = {{"NumPoints", .number = &header.nx},
                                    {"NumProfiles", .number = &header.ny},
                                    {"Compression", .number = &header.compression},
                                    {"Xscale", .number = &header.x_scale},
                                    {"Yscale", .number = &header.y_scale},
                                    {"Zscale", .number = &header.z_scale},
                                    {0}};
    struct lines lines = lines_begin(scan_view(file));
    struct string_view line;
    bool star = false;
    lines_next(&lines, &line); /* the version */
    while (!star && lines_next(&lines, &line)) {
        star = string_view_equals(string_view_trim(line), "*");
        if (!star && scan_take_key(keys, line, lines.number, file) != STATUS_OK)
            return file->status->code;
    }
    if (!star)
        return scan_fail(file, lines.number, "no line `*` between header and heights");
    if (check_header(out, &header, file) != STATUS_OK)
        return file->status->code;
    return scan_take_text(out, header.nx, header.ny, (struct string_view){lines.next, lines.end}, header.z_scale,
                          INFINITY, "*", file);
}

static enum status_code read_binary(struct scan *out, const struct scan_file *file)
{
    /* of each type the value that marks a missing point, which NaN always is */
    static const double missing[BYTES_COUNT] = {NAN, UINT16_MAX, UINT32_MAX, NAN, NAN, INT16_MIN, INT32_MIN, NAN};
    struct bytes bytes = bytes_begin(file, 8 + 10 + 12 + 12); /* version, maker, two dates */
    struct sdf_header header = {0};
    header.nx = bytes_number(&bytes, BYTES_U16);
    header.ny = bytes_number(&bytes, BYTES_U16);
    header.x_scale = bytes_number(&bytes, BYTES_F64);
    header.y_scale = bytes_number(&bytes, BYTES_F64);
    header.z_scale = bytes_number(&bytes, BYTES_F64);
    bytes_skip(&bytes, 8); /* resolution */
    header.compression = bytes_number(&bytes, BYTES_U8);
    header.type = bytes_number(&bytes, BYTES_U8);
    bytes_skip(&bytes, 1); /* kind of check sum */
    if (bytes.overrun)
        return scan_fail(file, 0, "the file ends within its header of %d bytes", SDF_BINARY_HEADER);
    if (header.type >= BYTES_COUNT)
        return scan_fail(file, 0, "data type %.0f is none of ISO 25178-71", header.type);
    enum bytes_type type = (enum bytes_type)header.type;
    if (check_header(out, &header, file) != STATUS_OK ||
        scan_reserve(out, header.nx, header.ny, bytes_left(&bytes) / bytes_size(type), file) != STATUS_OK)
        return file->status->code;
    /* Olympus writes 8 bytes more between header and heights */
    size_t points = out->nx * out->ny;
    if (bytes_left(&bytes) == points * bytes_size(type) + SDF_OLYMPUS_EXTRA)
        bytes_skip(&bytes, SDF_OLYMPUS_EXTRA);
    for (size_t i = 0; i < points; i++) {
        double value = bytes_number(&bytes, type);
        out->z_m[i] = value == missing[type] ? NAN : value * header.z_scale;
    }
    return STATUS_OK;
}

enum status_code scan_sdf_read(struct scan *out, const struct scan_file *file)
{
    return file->bytes[0] == 'a' ? read_text(out, file) : read_binary(out, file);
}
