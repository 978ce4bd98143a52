#include "spectrum/areal.h"

#include "profile/level.h"
#include "profile/profile.h"
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

static void measure_heights(struct areal *out, const struct scan *scan, const struct plane *plane)
{
    double n = 0, square = 0, absolute = 0, highest = -INFINITY, lowest = INFINITY;
    for (size_t i = 0; i < scan->nx * scan->ny; i++) {
        double x = (double)(i % scan->nx) - plane->x, y = (double)(i / scan->nx) - plane->y;
        double z = scan->z_m[i] - plane->z - plane->p * x - plane->q * y;
        if (isnan(z))
            continue;
        n++, square += z * z, absolute += fabs(z);
        highest = fmax(highest, z);
        lowest = fmin(lowest, z);
    }
    out->sq_m = sqrt(square / n);
    out->sa_m = absolute / n;
    out->sz_m = highest - lowest;
}

/** Mean squares of slope and curvature over the points whose neighbours are there; whether there are any. */
static bool measure_slopes(struct roughness *row, const double *x_m, const double *z_m, size_t count, double spacing_m)
{
    size_t triples = 0;
    for (size_t i = 1; i + 1 < count; i++) {
        if (x_m[i + 1] - x_m[i - 1] > 2.5 * spacing_m)
            continue;
        double slope = (z_m[i + 1] - z_m[i - 1]) / (2 * spacing_m);
        double curvature = (z_m[i + 1] - 2 * z_m[i] + z_m[i - 1]) / spacing_m / spacing_m;
        row->m2 += slope * slope;
        row->m4_per_m2 += curvature * curvature;
        triples++;
    }
    row->m2 /= (double)triples;
    row->m4_per_m2 /= (double)triples;
    return triples > 0;
}

/** Takes one more value into a mean of `so_far`. */
static void join(double *mean, double value, size_t so_far)
{
    *mean += (value - *mean) / (double)(so_far + 1);
}

/** Adds row `y` over its own least-squares line. x_m and z_m hold nx each. */
static enum status_code add_row(struct areal *out, const struct scan *scan, size_t y, double *x_m, double *z_m,
                                struct status *status)
{
    size_t count = 0;
    struct levelling line;
    struct roughness row = {0};
    for (size_t i = 0; i < scan->nx; i++)
        if (!isnan(scan->z_m[y * scan->nx + i])) {
            x_m[count] = (double)i * scan->dx_m;
            z_m[count++] = scan->z_m[y * scan->nx + i];
        }
    if (count < ROW_POINTS)
        return STATUS_OK;
    if (level_remove(&line, z_m, x_m, count, scan->dx_m, SCENE_LEVEL_LINE, status) != STATUS_OK)
        return status->code;
    double highest = -INFINITY, lowest = INFINITY;
    for (size_t i = 0; i < count; i++) {
        row.m0_m2 += z_m[i] * z_m[i] / (double)count;
        row.ra_m += fabs(z_m[i]) / (double)count;
        highest = fmax(highest, z_m[i]);
        lowest = fmin(lowest, z_m[i]);
    }
    join(&out->rows.m0_m2, row.m0_m2, out->row_count);
    join(&out->rows.ra_m, row.ra_m, out->row_count++);
    out->rows.rq_m = sqrt(out->rows.m0_m2);
    out->rows.pv_m = fmax(out->rows.pv_m, highest - lowest);
    if (measure_slopes(&row, x_m, z_m, count, scan->dx_m)) {
        join(&out->rows.m2, row.m2, out->slope_rows);
        join(&out->rows.m4_per_m2, row.m4_per_m2, out->slope_rows++);
    }
    return STATUS_OK;
}

/** Adds the spectrum of row `y`, if the row can be a profile of the map's full width. */
static enum status_code add_spectrum(struct areal *out, const struct scan *scan, size_t y, struct status *status)
{
    struct profile profile;
    struct spectrum spectrum = {0};
    struct status refused = {0};
    enum status_code code = profile_make(&profile, scan, y, &profile_defaults, &refused);
    if (code == STATUS_OK && profile.trimmed == 0) {
        code = spectrum_compute(&spectrum, profile.height_m, profile.points, profile.spacing_m, SCENE_WINDOW_NONE,
                                &refused);
        if (code == STATUS_OK && out->spectrum_rows++ == 0) {
            out->spectrum = spectrum;
        } else {
            if (code == STATUS_OK)
                spectrum_average(&out->spectrum, &spectrum, out->spectrum_rows - 1);
            spectrum_free(&spectrum);
        }
    }
    profile_free(&profile);
    return code == STATUS_MEMORY ? status_memory(status) : STATUS_OK;
}

enum status_code areal_compute(struct areal *out, const struct scan *scan, struct status *status)
{
    struct plane plane;
    *out = (struct areal){0};
    if (fit_plane(&plane, scan, status) != STATUS_OK)
        return status->code;
    measure_heights(out, scan, &plane);
    double *x_m = malloc(2 * scan->nx * sizeof *x_m);
    if (!x_m)
        return status_memory(status);
    enum status_code code = STATUS_OK;
    for (size_t y = 0; code == STATUS_OK && y < scan->ny; y++) {
        code = add_row(out, scan, y, x_m, x_m + scan->nx, status);
        if (code == STATUS_OK)
            code = add_spectrum(out, scan, y, status);
    }
    free(x_m);
    if (code == STATUS_OK && out->slope_rows == 0)
        return status_fail(status, STATUS_SCAN, "no row of the map has three heights side by side");
    return code;
}

void areal_free(struct areal *areal)
{
    spectrum_free(&areal->spectrum);
    *areal = (struct areal){0};
}
