/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_map.h"

#include "direct/direct_kernel.h"
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { LEAST = 8 }; /* points a side */

/** Height of the known point nearest to (i, j): rings of growing half width, until none further out can be nearer. */
static double nearest(const double *height, const bool *missing, size_t n, size_t i, size_t j)
{
    double best = INFINITY, value = NAN;
    for (long ring = 1; ring < (long)n && (double)(ring * ring) <= best; ring++)
        for (long y = (long)j - ring; y <= (long)j + ring; y++) {
            bool edge = y == (long)j - ring || y == (long)j + ring;
            for (long x = (long)i - ring; x <= (long)i + ring; x += edge ? 1 : 2 * ring) {
                if (x < 0 || y < 0 || x >= (long)n || y >= (long)n || missing[(size_t)y * n + (size_t)x])
                    continue;
                double dx = (double)(x - (long)i), dy = (double)(y - (long)j), square = dx * dx + dy * dy;
                if (square < best) {
                    best = square;
                    value = height[(size_t)y * n + (size_t)x];
                }
            }
        }
    return value;
}

/** Takes the least-squares plane off; about the middle of a full square its three sums part. */
static void take_plane(double *height, size_t n)
{
    double mean = 0, along = 0, across = 0, square = 0, middle = (double)(n - 1) / 2, count = (double)(n * n);
    for (size_t k = 0; k < n * n; k++)
        mean += (height[k] - height[0]) / count;
    mean += height[0];
    for (size_t k = 0; k < n * n; k++) {
        double x = (double)(k % n) - middle, y = (double)(k / n) - middle, z = height[k] - mean;
        along += x * z;
        across += y * z;
        square += x * x;
    }
    for (size_t k = 0; k < n * n; k++)
        height[k] -= mean + along / square * ((double)(k % n) - middle) + across / square * ((double)(k / n) - middle);
}

/** The square, filled and level, into `height`. */
static enum status_code take_square(struct direct_map *map, double *height, size_t n, const double *from, size_t nx,
                                    struct status *status)
{
    bool *missing = malloc(n * n * sizeof *missing);
    if (!missing)
        return status_memory(status);
    for (size_t k = 0; k < n * n; k++) {
        height[k] = from[k / n * nx + k % n];
        missing[k] = !isfinite(height[k]);
        map->filled += missing[k];
    }
    if (2 * map->filled <= n * n) {
        for (size_t k = 0; k < n * n; k++)
            if (missing[k])
                height[k] = nearest(height, missing, n, k % n, k / n);
        take_plane(height, n);
    }
    free(missing);
    if (2 * map->filled > n * n)
        return status_fail(status, STATUS_SCAN,
                           "%zu of the map's %zu points are missing; fill them or take another part", map->filled,
                           n * n);
    return STATUS_OK;
}

/** Gaussian low-pass of a periodic square, transmission 1/2 at a wave of `cutoff` points in any direction. */
static enum status_code low_pass(double *height, size_t n, double cutoff, struct status *status)
{
    struct direct_kernel kernel;
    size_t side = n / 2 + 1;
    if (direct_kernel_make(&kernel, NULL, n, n, 1, status) != STATUS_OK)
        return status->code;
    double *transmission = kernel.compliance; /* has the shape, and is not needed */
    for (size_t k = 0; k < side * side; k++) {
        double r = hypot((double)(k / side), (double)(k % side)) / (double)n * cutoff;
        transmission[k] = exp2(-r * r) / (double)(n * n);
    }
    for (size_t j = 0; j < n; j++)
        memcpy(kernel.field + j * kernel.stride, height + j * n, n * sizeof *height);
    direct_kernel_convolve(&kernel, transmission);
    for (size_t j = 0; j < n; j++)
        memcpy(height + j * n, kernel.field + j * kernel.stride, n * sizeof *height);
    direct_kernel_free(&kernel);
    return STATUS_OK;
}

/** Root mean square about the mean. */
static double rms(const double *z, size_t count)
{
    double mean = 0, square = 0;
    for (size_t k = 0; k < count; k++)
        mean += z[k] / (double)count;
    for (size_t k = 0; k < count; k++)
        square += (z[k] - mean) * (z[k] - mean) / (double)count;
    return sqrt(square);
}

enum status_code direct_map_make(struct direct_map *out, const double *height_m, size_t nx, size_t ny, double dx_m,
                                 double dy_m, size_t most, double cutoff, struct status *status)
{
    size_t n = nx < ny ? nx : ny;
    n = n < most ? n : most;
    *out = (struct direct_map){.n = 2 * n, .spacing_m = dx_m};
    if (n < LEAST)
        return status_fail(status, STATUS_SCAN, "a square of %zu points a side is too small; %d are needed", n, LEAST);
    if (!(dx_m > 0) || !(fabs(dy_m / dx_m - 1) <= 0.01))
        return status_fail(status, STATUS_SCAN,
                           "spacings of %g m along and %g m across the rows are not the same; resample the map", dx_m,
                           dy_m);
    double *square = malloc(n * n * sizeof *square);
    out->height_m = malloc(4 * n * n * sizeof *out->height_m);
    if (!square || !out->height_m)
        (void)status_memory(status);
    else if (take_square(out, square, n, height_m, nx, status) == STATUS_OK) {
        for (size_t j = 0; j < 2 * n; j++)
            for (size_t i = 0; i < 2 * n; i++)
                out->height_m[j * 2 * n + i] = square[(j < n ? j : 2 * n - 1 - j) * n + (i < n ? i : 2 * n - 1 - i)];
        if (cutoff <= 0 || low_pass(out->height_m, 2 * n, cutoff, status) == STATUS_OK)
            out->rms_m = rms(out->height_m, 4 * n * n);
    }
    free(square);
    if (status->code != STATUS_OK)
        direct_map_free(out);
    return status->code;
}

void direct_map_free(struct direct_map *map)
{
    free(map->height_m);
    *map = (struct direct_map){0};
}
