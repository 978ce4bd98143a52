/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/scan.h"
#include "base/text.h"
#include "scan/format.h"
#include "scan/text_header.h"

#include <gsl/gsl_vector.h>
#include <math.h>
#include <stdlib.h>

const char *const scan_direction_names[SCAN_DIRECTION_COUNT] = {"x", "y"};
const double scan_least_m = 1e-30, scan_most_m = 1e30;

enum { SCAN_POINTS = 3 };

static void reverse(double *values, size_t n)
{
    gsl_vector_view view = gsl_vector_view_array(values, n);
    gsl_vector_reverse(&view.vector);
}

static enum status_code check_positions(struct scan *scan, const struct scan_file *file)
{
    if (scan->x_m) {
        size_t bad = scan_disorder(scan->x_m, 1, scan->nx);
        if (bad < scan->nx)
            return scan_fail(file, 0, "x of point %zu does not go on from the point before; sort the points by x",
                             bad + 1);
        if (scan->x_m[1] < scan->x_m[0]) {
            reverse(scan->x_m, scan->nx);
            for (size_t row = 0; row < scan->ny; row++)
                reverse(scan->z_m + row * scan->nx, scan->nx);
            reverse(scan->margin_m, 2);
            scan_warn(scan, "x descends: the scan was reversed");
        }
        scan->dx_m = (scan->x_m[scan->nx - 1] - scan->x_m[0]) / (double)(scan->nx - 1);
    }
    if (!(scan->dx_m > 0 && isfinite(scan->dx_m)))
        return scan_fail(file, 0, "a spacing of %g m is no spacing", scan->dx_m);
    if (scan->kind == SCAN_AREAL && !(scan->dy_m > 0 && isfinite(scan->dy_m)))
        return scan_fail(file, 0, "a row spacing of %g m is no spacing", scan->dy_m);
    return STATUS_OK;
}

/* Are all lengths scan_least_m to scan_most_m? Squares of what is beyond would overflow or vanish. */
static enum status_code check_lengths(const struct scan *scan, const struct scan_file *file)
{
    double step_m = scan->dx_m, highest_m = -INFINITY, lowest_m = INFINITY;
    for (size_t i = 1; scan->x_m && i < scan->nx; i++)
        step_m = fmin(step_m, scan->x_m[i] - scan->x_m[i - 1]);
    for (size_t i = 0; i < scan->nx * scan->ny; i++) { /* missing points are passed over */
        highest_m = scan->z_m[i] > highest_m ? scan->z_m[i] : highest_m;
        lowest_m = scan->z_m[i] < lowest_m ? scan->z_m[i] : lowest_m;
    }
    const double largest_m = fmax(-lowest_m, highest_m), range_m = highest_m - lowest_m;
    const bool map = scan->kind == SCAN_AREAL;
    const struct {
        bool counts;
        double length_m;
        const char *name;
        char axis;
    } rows[] = {{true, step_m, "a spacing", 'x'},
                {true, (double)scan->nx * scan->dx_m, "a length", 'x'},
                {map, scan->dy_m, "a row spacing", 'y'},
                {map, (double)scan->ny * scan->dy_m, "a width", 'y'},
                {largest_m > scan_most_m, largest_m, "heights", 'z'},
                {range_m > 0 && largest_m <= scan_most_m, range_m, "heights", 'z'}}; /* all may be equal */
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (rows[i].counts && !(rows[i].length_m >= scan_least_m * (1 - 1e-9) && /* positions are rounded */
                                rows[i].length_m <= scan_most_m * (1 + 1e-9)))
            return scan_fail(file, 0, "%s of %.3g m; allowed is %g to %g m: is the unit of %c right?", rows[i].name,
                             rows[i].length_m, scan_least_m, scan_most_m, rows[i].axis);
    return STATUS_OK;
}

/* Checks what scan.h promises about every scan, whichever reader made it. */
static enum status_code check(struct scan *scan, const struct scan_file *file)
{
    size_t points = scan->nx * scan->ny;
    scan->dy_m = scan->kind == SCAN_AREAL ? scan->dy_m : 0.0;
    if (scan->nx < SCAN_POINTS || points < SCAN_POINTS)
        return scan_fail(file, 0, "only %zu points in a row; a scan needs at least %d", scan->nx, SCAN_POINTS);
    if (check_positions(scan, file) != STATUS_OK)
        return file->status->code;
    scan->missing = 0;
    for (size_t i = 0; i < points; i++) {
        if (isinf(scan->z_m[i]))
            return scan_fail(file, 0, "the height of point %zu is infinite", i + 1);
        scan->missing += isnan(scan->z_m[i]) ? 1 : 0;
    }
    if (points - scan->missing < SCAN_POINTS)
        return scan_fail(file, 0, "%zu of %zu heights are missing", scan->missing, points);
    return check_lengths(scan, file);
}

enum status_code scan_read_bytes(struct scan *out, const struct scan_bytes *bytes, const struct scan_options *options,
                                 struct status *status)
{
    const struct scan_file file = {bytes->bytes, bytes->length, bytes->path, options, status};
    *out = (struct scan){.ny = 1};
    if (scan_packed_read(out, &file) != STATUS_OK)
        return status->code;
    if (options->z_column > 0 && out->z_column == 0)
        return scan_fail(&file, 0, "a file of format %s has no columns to choose from; remove `column`", out->format);
    return check(out, &file);
}

enum status_code scan_read_beside(struct scan *out, const struct scan_bytes *bytes, const char *path,
                                  const struct scan_options *options, struct status *status)
{
    struct status problem = {0};
    enum status_code code = scan_read_bytes(out, bytes, options, &problem);
    struct sidecar sidecar;
    char *found = NULL;
    if (code != STATUS_MEMORY && out->units_lacking && sidecar_find(&sidecar, &found, path, status) != STATUS_OK)
        return status->code;
    if (found) {
        struct scan_options with = *options;
        with.sidecar = &sidecar;
        scan_free(out);
        problem = (struct status){0};
        code = scan_read_bytes(out, bytes, &with, &problem);
        if (out->units_beside)
            out->sidecar = found;
    }
    if (!out->sidecar)
        free(found);
    *status = problem;
    return code;
}

enum status_code scan_read(struct scan *out, const char *path, const struct scan_options *options,
                           struct status *status)
{
    *out = (struct scan){.ny = 1};
    OWNED(text_free) struct text text = {0};
    enum status_code code = text_read_file(&text, path, status);
    if (code == STATUS_OK) {
        struct scan_bytes file = {text_string(&text), text.length, path};
        struct scan_options how = *options;
        how.spent = &text;
        code = scan_read_beside(out, &file, path, &how, status);
    }
    return code;
}

enum status_code scan_transpose(struct scan *scan, struct status *status)
{
    const size_t nx = scan->nx, ny = scan->ny;
    const double dx_m = scan->dx_m;
    double *z_m = malloc(nx * ny * sizeof *z_m);
    if (!z_m)
        return status_memory(status);
    for (size_t row = 0; row < ny; row++)
        for (size_t i = 0; i < nx; i++)
            z_m[i * ny + row] = scan->z_m[row * nx + i];
    scan_free_points(scan);
    scan->z_m = z_m;
    scan->nx = ny;
    scan->ny = nx;
    scan->dx_m = scan->dy_m;
    scan->dy_m = dx_m;
    return STATUS_OK;
}

void scan_free_points(struct scan *scan)
{
    free(scan->x_m);
    free(scan->z_m);
    scan->x_m = scan->z_m = NULL;
}

void scan_free(struct scan *scan)
{
    scan_free_points(scan);
    free(scan->sidecar);
    *scan = (struct scan){0};
}
