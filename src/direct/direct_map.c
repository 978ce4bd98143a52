/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_map.h"

#include "profile/profile.h"
#include "spectrum/areal.h"
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { LEAST = 8, LEAST_LINE = 4 }; /* points a side of a square, and of a row or column that counts */

static const double cutoff_spacings = 6; /* a direct solution cannot tell shorter waves from noise and steps */
static const double noise_share = 0.02;  /* of the mean square slope, below that: the low-pass is needed */
static const double most_seam = 3; /* mean square second difference across the join of the ends over that inside; of a
                                      map that is not periodic far more */

struct direct_map_lines direct_map_lines(size_t nx, size_t ny, bool columns)
{
    return columns ? (struct direct_map_lines){nx, 1, ny, nx} : (struct direct_map_lines){ny, nx, nx, 1};
}

/** Figures of the rows, or the columns, of a map. */
struct lines {
    size_t count;        /* without a missing point */
    double seam, inside; /* mean squares of their second differences, across the join of their ends and inside */
    double slope, noise; /* mean square slopes, and their part below the cut-off */
};

/** Adds the lines of a map. */
static enum status_code look_along(struct lines *out, const double *height_m, struct direct_map_lines lines,
                                   struct status *status)
{
    const size_t points = lines.points;
    OWNED(memory_free) double *line = malloc(points * sizeof *line);
    if (!line)
        return status_memory(status);
    for (size_t k = 0; k < lines.count && points >= LEAST_LINE && status->code == STATUS_OK; k++) {
        struct spectrum spectrum;
        double bends[2] = {0}; /* across the join, inside */
        bool whole = true;
        for (size_t i = 0; i < points; i++) {
            line[i] = height_m[k * lines.next + i * lines.step];
            whole &= isfinite(line[i]) != 0;
        }
        if (!whole)
            continue;
        for (size_t i = 0; i < points; i++) {
            double bend = line[i] - 2 * line[(i + 1) % points] + line[(i + 2) % points];
            bends[i + 2 < points] += bend * bend / (i + 2 < points ? (double)points - 2 : 2);
        }
        bool periodic = record_window_is_periodic(line, points);
        struct levelling taken; /* a tilt is no slope of the surface's */
        enum spectrum_window window = spectrum_window_for(SPECTRUM_WINDOW_AUTO, periodic);
        if (level_remove(&taken, line, NULL, points, 1, periodic ? LEVEL_MEAN : LEVEL_LINE, status) != STATUS_OK ||
            spectrum_compute(&spectrum, line, points, 1, window, status) != STATUS_OK)
            continue;
        for (size_t i = 0; i < spectrum.count; i++) {
            double slope = pow(spectrum_frequency(&spectrum, i), 2) * spectrum_power(&spectrum, i);
            out->slope += slope;
            out->noise += spectrum_frequency(&spectrum, i) * cutoff_spacings > 1 ? slope : 0;
        }
        out->count++;
        out->seam += bends[0];
        out->inside += bends[1];
        spectrum_free(&spectrum);
    }
    return status->code;
}

/** Convolves the lines of a map with a Gaussian of `reach` weights to a side; beyond its ends a line is continued by
 * its mirror image, that of a periodic map by its other end. `room`: points + 2 reach. */
static void smooth_along(double *field, struct direct_map_lines lines, const double *weight, size_t reach,
                         bool periodic, double *room)
{
    const size_t points = lines.points;
    size_t period = periodic ? points : 2 * points;
    for (size_t k = 0; k < lines.count; k++) {
        double *line = field + k * lines.next;
        for (size_t i = 0; i < points + 2 * reach; i++) {
            size_t at = (i + period * reach - reach) % period;
            room[i] = line[(at < points ? at : period - 1 - at) * lines.step];
        }
        for (size_t i = 0; i < points; i++) {
            double sum = weight[0] * room[i + reach];
            for (size_t r = 1; r <= reach; r++)
                sum += weight[r] * (room[i + reach - r] + room[i + reach + r]);
            line[i * lines.step] = sum;
        }
    }
}

/** Gaussian low-pass of ISO 16610-61, transmission 1/2 at a wave of the map's cut-off in any direction, from the points
 * that are there; NaN where none is near. */
static enum status_code low_pass(double *smooth, const double *height, const struct direct_map_def *def,
                                 struct status *status)
{
    const double cutoff[] = {def->cutoff,
                             def->cutoff * (def->dy_m > 0 ? def->dx_m / def->dy_m : 1)}; /* along, across */
    const size_t nx = def->nx, ny = def->ny, most = (size_t)ceil(1.5 * fmax(cutoff[0], cutoff[1])), count = nx * ny;
    const size_t places = (nx > ny ? nx : ny) + 2 * most;
    OWNED(memory_free) double *there = malloc((count + places + most + 1) * sizeof *there);
    double offset = NAN;
    if (!there)
        return status_memory(status);
    double *fields[] = {smooth, there}, *room = there + count, *weight = room + places;
    for (size_t k = 0; k < count; k++) {
        offset = isnan(offset) ? height[k] : offset; /* so that the difference keeps its digits */
        there[k] = isfinite(height[k]);
        smooth[k] = there[k] > 0 ? height[k] - offset : 0;
    }
    for (int across = 0; across < 2; across++) {
        const size_t reach = (size_t)ceil(1.5 * cutoff[across]);
        double sum = 0;
        for (size_t r = 0; r <= reach; r++) {
            weight[r] = exp(-pow(M_PI * (double)r / cutoff[across], 2) / M_LN2);
            sum += weight[r] * (r > 0 ? 2 : 1);
        }
        for (size_t r = 0; r <= reach; r++)
            weight[r] /= sum;
        for (int f = 0; f < 2; f++)
            smooth_along(fields[f], direct_map_lines(nx, ny, across), weight, reach, def->periodic, room);
    }
    for (size_t k = 0; k < count; k++)
        smooth[k] = smooth[k] / there[k] + offset;
    return STATUS_OK;
}

enum status_code direct_map_condition(double *height_m, struct direct_map_def *def, bool as_measured,
                                      struct status *status)
{
    struct lines along = {0}, across = {0};
    size_t nx = def->nx, ny = def->ny;
    if (look_along(&along, height_m, direct_map_lines(nx, ny, false), status) != STATUS_OK ||
        look_along(&across, height_m, direct_map_lines(nx, ny, true), status) != STATUS_OK)
        return status->code;
    def->periodic = along.count == ny && across.count == nx && along.seam <= most_seam * along.inside &&
                    across.seam <= most_seam * across.inside;
    def->noisy = !(along.noise + across.noise <= noise_share * (along.slope + across.slope));
    if (!(def->cutoff > 0))
        def->cutoff = !as_measured && (def->noisy || along.count + across.count == 0) ? cutoff_spacings : 0;
    if (def->cutoff <= 0)
        return STATUS_OK;
    const struct scan scan = {.nx = nx, .ny = ny, .z_m = height_m};
    struct status none = {0};
    OWNED(memory_free) double *flat = malloc(2 * nx * ny * sizeof *flat);
    if (!flat)
        return status_memory(status);
    double *smooth = flat + nx * ny;
    if (areal_flatten(flat, &scan, &none) != STATUS_OK) /* a slope would make a kink where it is mirrored */
        memcpy(flat, height_m, nx * ny * sizeof *flat);
    if (low_pass(smooth, flat, def, status) == STATUS_OK)
        for (size_t k = 0; k < nx * ny; k++)
            height_m[k] = isnan(height_m[k]) ? NAN : height_m[k] - flat[k] + smooth[k];
    return status->code;
}

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

/** Subtracts the least-squares plane, or only the mean; about the middle of a full square its three sums are
 * independent. */
static void take_plane(double *height, size_t n, bool mean_only)
{
    double mean = 0, along = 0, across = 0, square = 0, middle = (double)(n - 1) / 2, count = (double)(n * n);
    for (size_t k = 0; k < n * n; k++)
        mean += (height[k] - height[0]) / count;
    mean += height[0];
    for (size_t k = 0; k < n * n; k++) {
        double x = (double)(k % n) - middle, y = (double)(k / n) - middle, z = height[k] - mean;
        along += mean_only ? 0 : x * z;
        across += mean_only ? 0 : y * z;
        square += x * x;
    }
    for (size_t k = 0; k < n * n; k++)
        height[k] -= mean + along / square * ((double)(k % n) - middle) + across / square * ((double)(k / n) - middle);
}

/** Gives missing points the height of the nearest one, smoothed like the map, so that no steps are left. */
static enum status_code fill(double *height, const bool *missing, size_t n, double cutoff, struct status *status)
{
    const struct direct_map_def square = {.nx = n, .ny = n, .cutoff = cutoff};
    OWNED(memory_free) double *smooth = malloc(n * n * sizeof *smooth);
    if (!smooth)
        return status_memory(status);
    for (size_t k = 0; k < n * n; k++)
        if (missing[k])
            height[k] = nearest(height, missing, n, k % n, k / n);
    if (cutoff > 0 && low_pass(smooth, height, &square, status) == STATUS_OK)
        for (size_t k = 0; k < n * n; k++)
            height[k] = missing[k] ? smooth[k] : height[k];
    return status->code;
}

/** The square from the first corner of a map of rows of nx heights, filled and level. */
static enum status_code take_square(struct direct_map *map, const double *from, size_t nx, struct status *status)
{
    const size_t n = map->grid.nx;
    double *height = map->height_m;
    OWNED(memory_free) bool *missing = malloc(n * n * sizeof *missing);
    size_t holes = 0;
    if (!missing)
        return status_memory(status);
    for (size_t k = 0; k < n * n; k++) {
        height[k] = from[k / n * nx + k % n];
        missing[k] = !isfinite(height[k]);
        holes += missing[k];
    }
    if (holes == 0 || fill(height, missing, n, map->cutoff, status) == STATUS_OK)
        take_plane(height, n, !map->grid.mirrored);
    return status->code;
}

bool direct_map_mirrored(const struct direct_map_def *def, size_t most)
{
    return !def->periodic || def->nx != def->ny || def->nx > most || def->nx % 2 != 0;
}

/** Points a side of the square. */
static size_t side_of(const struct direct_map_def *def, size_t most)
{
    const size_t side = def->nx < def->ny ? def->nx : def->ny;
    return side < most ? side : most;
}

enum status_code direct_map_check(const double *height_m, const struct direct_map_def *def, size_t most,
                                  struct status *status)
{
    const size_t n = side_of(def, most);
    size_t holes = 0;
    if (n < LEAST)
        return status_fail(status, STATUS_SCAN, "a square of %zu points a side is too small; %d are needed", n, LEAST);
    if (!(def->dx_m > 0) || !(fabs(def->dy_m / def->dx_m - 1) <= 0.01))
        return status_fail(status, STATUS_SCAN,
                           "spacings of %g m along and %g m across the rows are not the same; resample the map",
                           def->dx_m, def->dy_m);
    for (size_t k = 0; k < n * n; k++)
        holes += isfinite(height_m[k / n * def->nx + k % n]) ? 0 : 1;
    if ((double)holes > DIRECT_MAP_HOLES * (double)(n * n))
        return status_fail(status, STATUS_SCAN,
                           "%zu of the map's %zu points are missing; fill them or take another part", holes, n * n);
    return STATUS_OK;
}

enum status_code direct_map_make(struct direct_map *out, const double *height_m, const struct direct_map_def *def,
                                 size_t most, struct status *status)
{
    const size_t n = side_of(def, most);
    *out = (struct direct_map){.grid = {n, n, def->dx_m, direct_map_mirrored(def, most), def->single},
                               .cutoff = def->cutoff};
    if (direct_map_check(height_m, def, most, status) != STATUS_OK)
        return status->code;
    out->height_m = malloc(n * n * sizeof *out->height_m);
    if (!out->height_m)
        return status_memory(status);
    (void)take_square(out, height_m, def->nx, status);
    if (status->code != STATUS_OK)
        direct_map_free(out);
    return status->code;
}

void direct_map_free(struct direct_map *map)
{
    free(map->height_m);
    *map = (struct direct_map){0};
}

bool direct_map_has(const struct direct_map *map, enum direct_map_part part)
{
    return part >= DIRECT_MAP_QUARTER ? map->grid.mirrored && map->grid.nx / 2 >= LEAST
                                      : part != DIRECT_MAP_WIDER || map->cutoff > 0;
}

enum status_code direct_map_take(struct direct_map *out, const struct direct_map *map, enum direct_map_part part,
                                 struct status *status)
{
    const struct direct_grid *grid = &map->grid;
    const size_t all = grid->nx, every = part == DIRECT_MAP_WHOLE ? 1 : 2, n = all / every, half = all / 2;
    const bool wider = part == DIRECT_MAP_WIDER;
    const struct direct_map_def def = {.nx = all,
                                       .ny = all,
                                       .dx_m = grid->spacing_m,
                                       .dy_m = grid->spacing_m,
                                       .periodic = !grid->mirrored,
                                       .cutoff = map->cutoff,
                                       .single = grid->single};
    if (part >= DIRECT_MAP_QUARTER) {
        size_t quarter = (size_t)(part - DIRECT_MAP_QUARTER);
        return direct_map_make(out, map->height_m + (quarter / 2 * all + quarter % 2) * half, &def, half, status);
    }
    *out = *map;
    out->grid = (struct direct_grid){n, n, grid->spacing_m * (double)every, grid->mirrored, grid->single};
    out->height_m = malloc(all * all * sizeof *out->height_m);
    if (!out->height_m)
        return status_memory(status);
    memcpy(out->height_m, map->height_m, all * all * sizeof *out->height_m);
    if (wider && low_pass(out->height_m, map->height_m, &def, status) != STATUS_OK)
        direct_map_free(out);
    for (size_t k = 0; k < n * n && out->height_m; k++)
        out->height_m[k] = out->height_m[k / n * every * all + k % n * every];
    return status->code;
}
