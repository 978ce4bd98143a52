/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/strips.h"

#include "direct/direct_surface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const double strips_budget = 5e9;

enum { ROWS_MOST = 8 }; /* of a map */

void strips_free(struct strips *strips)
{
    free(strips->height_m);
    free(strips->joined);
    bearing_free(&strips->bearing);
    *strips = (struct strips){.height_m = NULL};
}

/** Has a member all of the `points`, and the first one's spacing? Rows of a map may lack some at their ends. */
static bool is_whole(const struct member *member, size_t points, double spacing_m)
{
    return member->height_m && member->points == points && fabs(member->spacing_m / spacing_m - 1) <= 1e-6;
}

enum status_code strips_gather(struct strips *out, const struct ensemble *set, struct status *status)
{
    bool map = set->scan_count == 1, periodic = true;
    double spacing_m = set->count > 0 ? set->members[0].spacing_m : 0;
    size_t points = 0, whole = 0, taken = 0;
    for (size_t p = 0; p < set->count; p++)
        points = set->members[p].points > points ? set->members[p].points : points;
    for (size_t p = 0; p < set->count; p++)
        if (is_whole(&set->members[p], points, spacing_m)) {
            periodic = periodic && set->members[p].periodic;
            whole++;
        }
    size_t rows = map && whole > ROWS_MOST ? ROWS_MOST : whole;
    if (rows == 0 || (!map && whole < set->count))
        return STATUS_OK;
    if (!(out->height_m = malloc(rows * points * sizeof *out->height_m)))
        return status_memory(status);
    for (size_t p = 0, k = 0; p < set->count; p++) {
        if (!is_whole(&set->members[p], points, spacing_m) || k++ != (2 * taken + 1) * whole / (2 * rows))
            continue;
        memcpy(out->height_m + taken * points, set->members[p].height_m, points * sizeof *out->height_m);
        taken++;
    }
    out->rows = (struct strip_rows){out->height_m, rows, points, spacing_m, periodic};
    out->pairings = 1;
    return STATUS_OK;
}

/** Height of a row at `place` points from its beginning, wherever that is. */
static double height_at(const struct strip_rows *rows, size_t row, double place)
{
    const double *height_m = rows->height_m + row * rows->points;
    size_t n = rows->points, period = rows->periodic ? n : 2 * n;
    double within = fmod(place, (double)period), share = within - floor(within);
    size_t at[2] = {(size_t)within, ((size_t)within + 1) % period};
    for (int k = 0; k < 2; k++)
        at[k] = at[k] < n ? at[k] : 2 * n - 1 - at[k];
    return share > 0 ? (1 - share) * height_m[at[0]] + share * height_m[at[1]] : height_m[at[0]];
}

enum { PAIRING_SEED = 0x70616972 };

enum status_code strips_pair(struct strips *strips, const struct strips *other, struct status *status)
{
    const struct strip_rows own = strips->rows, *theirs = &other->rows;
    if (own.rows == 0 || theirs->rows == 0) {
        strips_free(strips);
        return STATUS_OK;
    }
    size_t pairings = (STRIPS_PAIRINGS + own.rows - 1) / own.rows, rows = own.rows * pairings;
    double *height_m = malloc(rows * own.points * sizeof *height_m), step = own.spacing_m / theirs->spacing_m;
    if (!height_m)
        return status_memory(status);
    step = fabs(step - 1) < 1e-6 ? 1 : step;
    for (size_t r = 0; r < rows; r++) {
        size_t row = (size_t)(direct_random(PAIRING_SEED, 2 * r) * (double)theirs->rows);
        double first = floor(direct_random(PAIRING_SEED, 2 * r + 1) * 2 * (double)theirs->points);
        for (size_t i = 0; i < own.points; i++)
            height_m[r * own.points + i] =
                own.height_m[r / pairings * own.points + i] + height_at(theirs, row, first + (double)i * step);
    }
    free(strips->height_m);
    strips->height_m = height_m;
    strips->pairings = pairings;
    strips->rows.height_m = height_m;
    strips->rows.rows = rows;
    strips->rows.periodic =
        own.periodic && theirs->periodic && fabs((double)own.points * step / (double)theirs->points - 1) < 1e-6;
    return STATUS_OK;
}

uint64_t strips_cost(const struct strips *strips, size_t surrogates)
{
    size_t rows = strips->rows.rows, alone = rows > strips->pairings ? rows : 0;
    return strip_cost(&strips->rows, rows, surrogates) + alone * strip_cost(&strips->rows, 1, surrogates);
}

size_t strips_surrogates(const struct strips *strips, const struct scene *scene)
{
    size_t surrogates = strips->rows.rows > 0 ? STRIP_SURROGATES : 0;
    while (surrogates > 0 && !scene->models_named &&
           (double)scene->surface_count * (double)strips_cost(strips, surrogates) > strips_budget)
        surrogates /= 2;
    return surrogates;
}

/** A strip of these rows, malloc'ed; NULL where it has no answer. */
static enum status_code solve(struct strip **out, struct strips *strips, const size_t *which, size_t count,
                              size_t surrogates, const atomic_bool *stop, struct status *status)
{
    struct status problem = {0};
    if (!(*out = malloc(sizeof **out)))
        return status_memory(status);
    enum status_code rc = strip_solve(*out, &strips->rows, which, count, surrogates, stop, &problem);
    strips->transforms += (*out)->transforms;
    if (rc == STATUS_OK)
        return STATUS_OK;
    free(*out);
    *out = NULL;
    if (strips->problem.code == STATUS_OK)
        strips->problem = problem;
    return rc == STATUS_MODEL ? STATUS_OK : status_fail(status, rc, "%s", problem.message);
}

enum status_code strips_solve(struct strips *strips, struct ensemble *set, size_t surrogates, const atomic_bool *stop,
                              struct status *status)
{
    size_t rows = strips->rows.rows, *which = malloc((rows + 1) * sizeof *which);
    if (!which)
        return status_memory(status);
    for (size_t r = 0; r < rows; r++)
        which[r] = r;
    enum status_code rc = solve(&strips->joined, strips, which, rows, surrogates, stop, status);
    for (size_t p = 0; p < set->count && set->scan_count > 1 && rc == STATUS_OK; p++)
        rc = solve(&set->members[p].strip, strips, which + p * strips->pairings, strips->pairings, surrogates, stop,
                   status);
    free(which);
    return rc == STATUS_OK && strips->joined ? bearing_make(&strips->bearing, &strips->rows, status) : rc;
}
