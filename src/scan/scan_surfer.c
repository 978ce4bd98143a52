/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Golden Software Surfer grids: DSAA (text), DSBB (binary, version 6), DSRB (binary, version 7). They name no units;
 * rows run from the lowest y on. Heights at or above the blanking value are missing. */
#include "scan/reader.h"
#include "scan/string_view.h"

#include <math.h>
#include <string.h>

static const double surfer_blank = 1.70141e38;
enum { SURFER_GRID = 0x44495247, SURFER_DATA = 0x41544144, SURFER_SECTIONS = 16 };

struct surfer_grid {
    size_t nx, ny;
    double dx, dy, blank;
};

/* Fills the map's grid and makes missing what is blank; its heights are there, in the unit of the file. */
static void take_grid(struct scan *out, const struct surfer_grid *grid, double x_m, double z_m)
{
    out->dx_m = grid->dx * x_m;
    out->dy_m = grid->dy * x_m;
    for (size_t i = 0; i < out->nx * out->ny; i++)
        out->z_m[i] = out->z_m[i] >= grid->blank * (1 - 1e-6) ? NAN : out->z_m[i] * z_m;
}

static double step(double low, double high, size_t n)
{
    return n > 1 ? (high - low) / (double)(n - 1) : 0.0;
}

static enum status_code read_text(struct scan *out, const struct scan_file *file)
{
    struct string_view text = {file->bytes + 4, file->bytes + file->length}, word;
    double head[8], x_m, z_m; /* nx ny xlo xhi ylo yhi zlo zhi */
    for (size_t i = 0; i < 8; i++)
        if (!scan_word(&text, &word) || !number_read(word, &head[i]))
            return scan_fail(file, scan_line(file, text.start), "'%s' in the header of the grid",
                             scan_quote(word).text);
    if (!(head[0] >= 1 && head[0] <= UINT32_MAX && head[1] >= 1 && head[1] <= UINT32_MAX))
        return scan_fail(file, 2, "%g x %g points: nothing measured", head[0], head[1]);
    struct surfer_grid grid = {(size_t)head[0], (size_t)head[1], 0, 0, surfer_blank};
    grid.dx = step(head[2], head[3], grid.nx);
    grid.dy = step(head[4], head[5], grid.ny);
    if (scan_units(out, NULL, NULL, &x_m, &z_m, file) != STATUS_OK ||
        scan_take_text(out, grid.nx, grid.ny, text, 1.0, NULL, file) != STATUS_OK)
        return file->status->code;
    take_grid(out, &grid, x_m, z_m);
    return STATUS_OK;
}

static enum status_code read_values(struct scan *out, const struct surfer_grid *grid, struct bytes *bytes,
                                    enum bytes_type type, const struct scan_file *file)
{
    double x_m, z_m;
    if (scan_units(out, NULL, NULL, &x_m, &z_m, file) != STATUS_OK ||
        scan_reserve(out, grid->nx, grid->ny, bytes_left(bytes) / bytes_size(type), file) != STATUS_OK)
        return file->status->code;
    for (size_t i = 0; i < grid->nx * grid->ny; i++)
        out->z_m[i] = bytes_number(bytes, type);
    take_grid(out, grid, x_m, z_m);
    return STATUS_OK;
}

static enum status_code read_version6(struct scan *out, const struct scan_file *file)
{
    struct bytes bytes = bytes_begin(file, 4);
    struct surfer_grid grid = {.blank = surfer_blank};
    grid.nx = bytes_u16(&bytes);
    grid.ny = bytes_u16(&bytes);
    double x_low = bytes_f64(&bytes), x_high = bytes_f64(&bytes);
    double y_low = bytes_f64(&bytes), y_high = bytes_f64(&bytes);
    bytes_skip(&bytes, 2 * sizeof(double)); /* range of z */
    grid.dx = step(x_low, x_high, grid.nx);
    grid.dy = step(y_low, y_high, grid.ny);
    return read_values(out, &grid, &bytes, BYTES_F32, file);
}

static enum status_code read_version7(struct scan *out, const struct scan_file *file)
{
    struct bytes bytes = bytes_begin(file, 0);
    struct surfer_grid grid = {0};
    for (size_t section = 0; section < SURFER_SECTIONS && !bytes.overrun; section++) {
        uint32_t tag = bytes_u32(&bytes), size = bytes_u32(&bytes);
        struct bytes inside = bytes;
        bytes_skip(&bytes, size);
        if (tag == SURFER_DATA && grid.nx > 0)
            return read_values(out, &grid, &inside, BYTES_F64, file);
        if (tag != SURFER_GRID)
            continue;
        grid.ny = bytes_u32(&inside);
        grid.nx = bytes_u32(&inside);
        bytes_skip(&inside, 2 * sizeof(double)); /* corner */
        grid.dx = bytes_f64(&inside);
        grid.dy = bytes_f64(&inside);
        bytes_skip(&inside, 3 * sizeof(double)); /* range of z, rotation */
        grid.blank = bytes_f64(&inside);
    }
    return scan_fail(file, 0, "no grid and data sections: the file is cut off");
}

enum status_code scan_surfer_read(struct scan *out, const struct scan_file *file)
{
    if (string_view_starts(scan_view(file), "DSAA"))
        return read_text(out, file);
    return string_view_starts(scan_view(file), "DSBB") ? read_version6(out, file) : read_version7(out, file);
}
