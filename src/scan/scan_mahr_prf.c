/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mahr MarWin binary PRF: magic "[p3dlin]", the number of points n at byte 0x14, and 49 bytes behind the start of
 * "[Trajec]" n doubles x, n doubles y, n doubles z in millimetres. */
#include "scan/reader.h"

#include <string.h>

static const char magic[] = "[p3dlin]", trajectory[] = "[Trajec]";
enum { MAHR_COUNT_AT = 0x14, MAHR_DATA_BEHIND = 49 };
static const double mahr_unit_m = 1e-3;

bool scan_mahr_prf_sniff(const struct scan_file *file)
{
    return string_view_starts(scan_view(file), magic);
}

enum status_code scan_mahr_prf_read(struct scan *out, const struct scan_file *file)
{
    struct bytes count = bytes_begin(file, MAHR_COUNT_AT);
    size_t n = bytes_u32(&count);
    const char *found = memmem(file->bytes, file->length, trajectory, strlen(trajectory));
    if (count.overrun || !found)
        return scan_fail(file, 0, "no %s section: the file is cut off; export it again", trajectory);
    struct bytes bytes = bytes_begin(file, (size_t)(found - file->bytes) + MAHR_DATA_BEHIND);
    if (scan_reserve_x(out, n, bytes_left(&bytes) / (3 * sizeof(double)), file) != STATUS_OK)
        return file->status->code;
    for (size_t i = 0; i < n; i++)
        out->x_m[i] = bytes_f64(&bytes) * mahr_unit_m;
    bytes_skip(&bytes, n * sizeof(double)); /* y, across the profile */
    for (size_t i = 0; i < n; i++)
        out->z_m[i] = bytes_f64(&bytes) * mahr_unit_m;
    scan_set_units(out, "mm", "mm");
    return STATUS_OK;
}
