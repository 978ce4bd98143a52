/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/areal.h"

#include "profile/level.h"
#include "profile/profile.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { ROW_POINTS = 3 };

/** z = mean + p (x - x_mean) + q (y - y_mean), x and y in points. */
struct plane {
    double x, y, z, p, q;
};

static enum status_code fit_plane(struct plane *out, const struct scan *scan, struct status *status)
{
    *out = (struct plane){0};
    double n = 0, xx = 0, xy = 0, yy = 0, xz = 0, yz = 0, origin = NAN;
    for (size_t i = 0; i < scan->nx * scan->ny; i++) {
        if (isnan(scan->z_m[i]))
            continue;
        origin = isnan(origin) ? scan->z_m[i] : origin;
        n++, out->x += (double)(i % scan->nx), out->y += (double)(i / scan->nx), out->z += scan->z_m[i] - origin;
    }
    out->x /= n, out->y /= n, out->z = out->z / n + origin;
    for (size_t i = 0; i < scan->nx * scan->ny; i++) {
        double x = (double)(i % scan->nx) - out->x, y = (double)(i / scan->nx) - out->y, z = scan->z_m[i] - out->z;
        if (isnan(z))
            continue;
        xx += x * x, xy += x * y, yy += y * y, xz += x * z, yz += y * z;
    }
    double determinant = xx * yy - xy * xy;
    if (!(n >= ROW_POINTS && determinant > 1e-9 * xx * yy))
        return status_fail(status, STATUS_SCAN, "no plane through its %g heights; the map has too many missing points",
                           n);
    out->p = (xz * yy - yz * xy) / determinant;
    out->q = (yz * xx - xz * xy) / determinant;
    return STATUS_OK;
}

/** Mean square slope along lines of `all` points that are `step` apart. */
static double mean_square_slope(const double *flat_m, size_t count, size_t step, size_t all, double spacing_m)
{
    double sum = 0, slopes = 0;
    for (size_t i = step; i + step < count; i++) {
        double slope = (flat_m[i + step] - flat_m[i - step]) / (2 * spacing_m);
        if (isnan(slope) || i / step % all == 0 || i / step % all == all - 1)
            continue;
        sum += slope * slope;
        slopes++;
    }
    return sum / slopes;
}

enum status_code areal_parameters_of(struct areal_parameters *out, const struct scan *scan, struct status *status)
{
    const size_t count = scan->nx * scan->ny;
    OWNED(memory_free) double *flat_m = malloc(count * sizeof *flat_m);
    if (!flat_m)
        return status_memory(status);
    if (areal_flatten(flat_m, scan, status) == STATUS_OK) {
        const struct roughness heights = roughness_of_heights_alone(flat_m, count);
        *out = (struct areal_parameters){
            heights.rq_m,
            heights.ra_m,
            heights.pv_m,
            roughness_skewness(&heights),
            roughness_kurtosis(&heights),
            sqrt(mean_square_slope(flat_m, count, 1, scan->nx, scan->dx_m) +
                 mean_square_slope(flat_m, count, scan->nx, scan->ny, scan->dy_m)),
        };
    }
    return status->code;
}

/** Error: STATUS_SCAN: a map that is flat but for rounding. */
static enum status_code check_heights(const struct areal *areal, const struct scan *scan, struct status *status)
{
    double most = -INFINITY, least = INFINITY;
    for (size_t i = 0; i < scan->nx * scan->ny; i++) {
        most = fmax(most, scan->z_m[i]);
        least = fmin(least, scan->z_m[i]);
    }
    if (most == least)
        return status_fail(status, STATUS_SCAN, "the map is flat: every height is %.9g m; check the column", most);
    if (areal->surface.sz_m <= 32 * DBL_EPSILON * (fabs(most) + most - least))
        return status_fail(status, STATUS_SCAN, "the map is flat: no roughness is left over its plane");
    return STATUS_OK;
}

/** Mean over the rows that have a value. */
struct row_mean {
    double value;
    size_t count;
};

static void join(struct row_mean *mean, double value)
{
    if (!isnan(value))
        mean->value += (value - mean->value) / (double)++mean->count;
}

/** Means over the rows so far, and room for one row. */
struct rows {
    struct row_mean m0, ra, m2, m4;
    double pv_m;
    double *x_m, *z_m; /* nx each: the points that are not missing */
};

/** Adds row `y` over its own least-squares line. */
static enum status_code add_row(struct rows *rows, const struct scan *scan, size_t y, struct status *status)
{
    const double *row_m = scan->z_m + y * scan->nx;
    double *x_m = rows->x_m, *z_m = rows->z_m;
    size_t count = 0;
    struct levelling line;
    for (size_t i = 0; i < scan->nx; i++)
        if (!isnan(row_m[i])) {
            x_m[count] = (double)i * scan->dx_m;
            z_m[count++] = row_m[i];
        }
    if (count < ROW_POINTS)
        return STATUS_OK;
    if (level_remove(&line, z_m, x_m, count, 0, LEVEL_LINE, status) != STATUS_OK)
        return status->code;
    for (size_t i = scan->nx; i-- > 0;) /* back to their places, last first */
        z_m[i] = isnan(row_m[i]) ? NAN : z_m[--count];
    const struct roughness row = roughness_of_heights(z_m, scan->nx, scan->dx_m);
    join(&rows->m0, row.m0_m2);
    join(&rows->ra, row.ra_m);
    join(&rows->m2, row.m2);
    join(&rows->m4, row.m4_per_m2);
    rows->pv_m = fmax(rows->pv_m, row.pv_m);
    return STATUS_OK;
}

/** Averages the spectrum of row `y` into the map's, if the row can be a profile. */
static enum status_code add_spectrum(struct areal *out, const struct scan *scan, size_t y, struct status *status)
{
    OWNED(profile_free) struct profile profile = {0};
    OWNED(spectrum_free) struct spectrum spectrum = {0};
    struct status refused = {0};
    if (profile_make(&profile, scan, y, &profile_defaults, &refused) == STATUS_OK &&
        spectrum_compute(&spectrum, profile.height_m, profile.points, profile.spacing_m,
                         spectrum_window_for(SPECTRUM_WINDOW_AUTO, profile.periodic), &refused) == STATUS_OK &&
        power_law_scans_add(&out->scans, profile.height_m, profile.points, profile.spacing_m, profile.digit_m,
                            &refused) == STATUS_OK)
        (void)!grid_average(&out->spectrum, &spectrum, out->scans.scan_count - 1, &refused);
    return refused.code == STATUS_MEMORY ? status_memory(status) : STATUS_OK;
}

enum status_code areal_compute(struct areal *out, const struct scan *scan, struct status *status)
{
    *out = (struct areal){0};
    if (areal_parameters_of(&out->surface, scan, status) != STATUS_OK || check_heights(out, scan, status) != STATUS_OK)
        return status->code;
    struct rows rows = {.x_m = malloc(2 * scan->nx * sizeof *rows.x_m)};
    if (!rows.x_m)
        return status_memory(status);
    rows.z_m = rows.x_m + scan->nx;
    for (size_t y = 0; status->code == STATUS_OK && y < scan->ny; y++)
        if (add_row(&rows, scan, y, status) == STATUS_OK)
            (void)add_spectrum(out, scan, y, status);
    free(rows.x_m);
    if (status->code != STATUS_OK)
        return status->code;
    power_law_scans_end_file(&out->scans, out->scans.scan_count, true);
    if (rows.m2.count == 0 || rows.m4.count == 0)
        return status_fail(status, STATUS_SCAN, "no row of the map has three heights side by side");
    out->rows = (struct roughness){.rq_m = sqrt(rows.m0.value),
                                   .ra_m = rows.ra.value,
                                   .pv_m = rows.pv_m,
                                   .m0_m2 = rows.m0.value,
                                   .m2 = rows.m2.value,
                                   .m4_per_m2 = rows.m4.value,
                                   .cube_m3 = NAN,
                                   .fourth_m4 = NAN};
    return STATUS_OK;
}

void areal_free(struct areal *areal)
{
    spectrum_free(&areal->spectrum);
    power_law_scans_free(&areal->scans);
    *areal = (struct areal){0};
}

enum status_code areal_flatten(double *height_m, const struct scan *scan, struct status *status)
{
    struct plane plane;
    if (fit_plane(&plane, scan, status) != STATUS_OK)
        return status->code;
    for (size_t i = 0; i < scan->nx * scan->ny; i++) {
        double x = (double)(i % scan->nx) - plane.x, y = (double)(i / scan->nx) - plane.y;
        height_m[i] = scan->z_m[i] - plane.z - plane.p * x - plane.q * y;
    }
    return STATUS_OK;
}
