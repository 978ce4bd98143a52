/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "members/scan_strips.h"

#include "direct/direct_surface.h"

#include <gsl/gsl_minmax.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Largest prime factor allowed in the number of points of an open row: of 512 or more points up to 2 % are left out to
 * get there. With a factor of 107 a transform would take four times as long. */
enum { ROW_FACTOR = 13 };

void strips_free(struct strips *strips)
{
    free(strips->height_m);
    free(strips->seed);
    solved_strip_free(strips->joined);
    strip_nodes_free(&strips->prepared.nodes);
    *strips = (struct strips){.height_m = NULL};
}

/** Has a member all `points`, at this spacing? Rows of a map may lack some at their ends. */
static bool is_whole(const struct member *member, size_t points, double spacing_m)
{
    return member->height_m && member->points == points && fabs(member->spacing_m / spacing_m - 1) <= 1e-6;
}

/** How often each of `rows` rows is paired. */
static size_t pairings_of(size_t rows)
{
    return (STRIPS_PAIRINGS + rows - 1) / rows;
}

/** By their seeds, then as they stand. */
static int by_seed(const void *a, const void *b)
{
    const struct member *one = *(struct member *const *)a, *other = *(struct member *const *)b;
    return one->seed != other->seed ? (one->seed > other->seed) - (one->seed < other->seed)
                                    : (one > other) - (one < other);
}

/** The whole members, malloc'ed: rows of a map as they lie, scans in the order of their seeds, as the rows of a strip
 * press on each other and neither names nor units may change a number; NULL: out of memory. */
static struct member **whole_members(const struct ensemble *set, size_t points, double spacing_m)
{
    struct member **out = malloc((set->count + 1) * sizeof(struct member *));
    size_t count = 0;
    for (size_t p = 0; out && p < set->count; p++)
        if (is_whole(&set->members[p], points, spacing_m))
            out[count++] = &set->members[p];
    if (count > 0 && !out[0]->is_row)
        qsort(out, count, sizeof(struct member *), by_seed);
    return out;
}

enum status_code strips_gather(struct strips *out, struct ensemble *set, bool paired, struct status *status)
{
    bool map = set->count > 0 && set->members[0].is_row, periodic = true;
    double spacing_m = set->count > 0 ? set->members[0].spacing_m : 0;
    size_t points = 0, whole = 0;
    for (size_t p = 0; p < set->count; p++)
        points = set->members[p].points > points ? set->members[p].points : points;
    for (size_t p = 0; p < set->count; p++)
        if (is_whole(&set->members[p], points, spacing_m)) {
            periodic = periodic && set->members[p].periodic;
            whole++;
        }
    if (whole == 0 || (!map && whole < set->count))
        return STATUS_OK;
    size_t rows = paired ? whole * pairings_of(whole) : whole;
    bool fits = rows <= STRIPS_PIECES && rows * points <= STRIPS_POINTS;
    size_t length = !fits ? GSL_MIN(points, STRIPS_PIECE_POINTS) : periodic ? points : fft_quick(points, ROW_FACTOR);
    size_t pieces = fits ? whole : GSL_MIN(STRIPS_PIECES, STRIPS_POINTS / length);
    size_t scans = GSL_MIN(whole, pieces), each = pieces / scans;
    each = each > 2 ? 3 * each / 4 : each; /* the rest would cost a third more and change the answer by 0.1 */
    size_t spread = each > 1 ? each : scans;
    if (!(out->height_m = malloc(scans * each * length * sizeof *out->height_m)) ||
        !(out->seed = malloc(scans * each * sizeof *out->seed)))
        return status_memory(status);
    struct member **in_order = whole_members(set, points, spacing_m);
    if (!in_order)
        return status_memory(status);
    for (size_t taken = 0; taken < scans; taken++) {
        struct member *member = in_order[(2 * taken + 1) * whole / (2 * scans)];
        member->first_piece = taken * each;
        member->pieces = each;
        for (size_t i = 0; i < each; i++) {
            size_t place = each > 1 ? i : taken, first = spread > 1 ? place * (points - length) / (spread - 1) : 0;
            out->seed[taken * each + i] = member->seed + (place << 32);
            memcpy(out->height_m + (taken * each + i) * length, member->height_m + first,
                   length * sizeof *out->height_m);
        }
    }
    free(in_order);
    out->rows = (struct strip_rows){out->height_m, scans * each, length, spacing_m, periodic && length == points,
                                    out->seed,     set->count};
    return STATUS_OK;
}

/** Height of a row `place` points from its beginning, also beyond its end. */
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

/** First and number of the rows that a row may be paired with. */
static void partner_rows(size_t range[2], const struct ensemble *set, size_t row, const struct strips *other,
                         const struct ensemble *other_set)
{
    size_t p = 0, q = other_set->count;
    while (p < set->count && row - set->members[p].first_piece >= set->members[p].pieces)
        p++;
    if (p < set->count)
        q = ensemble_partner(set, p, other_set);
    bool partner = q < other_set->count && other_set->members[q].pieces > 0;
    range[0] = partner ? other_set->members[q].first_piece : 0;
    range[1] = partner ? other_set->members[q].pieces : other->rows.rows;
}

enum { PAIRING_SEED = 0x70616972 };

enum status_code strips_pair(struct strips *strips, struct ensemble *set, const struct strips *other,
                             const struct ensemble *other_set, struct status *status)
{
    const struct strip_rows own = strips->rows, *theirs = &other->rows;
    if (own.rows == 0 || theirs->rows == 0) {
        strips_free(strips);
        return STATUS_OK;
    }
    size_t pairings = pairings_of(own.rows), rows = own.rows * pairings;
    double *height_m = malloc(rows * own.points * sizeof *height_m), step = own.spacing_m / theirs->spacing_m;
    uint64_t *seed = malloc(rows * sizeof *seed);
    if (!height_m || !seed) {
        free(height_m);
        free(seed);
        return status_memory(status);
    }
    step = fabs(step - 1) < 1e-6 ? 1 : step;
    for (size_t r = 0; r < rows; r++) {
        size_t range[2];
        seed[r] = strips->seed[r / pairings] + ((uint64_t)(r % pairings) << 40);
        partner_rows(range, set, r / pairings, other, other_set);
        size_t row = range[0] + (size_t)(direct_random(PAIRING_SEED, 2 * r) * (double)range[1]);
        double first = floor(direct_random(PAIRING_SEED, 2 * r + 1) * 2 * (double)theirs->points);
        for (size_t i = 0; i < own.points; i++)
            height_m[r * own.points + i] =
                own.height_m[r / pairings * own.points + i] + height_at(theirs, row, first + (double)i * step);
    }
    for (size_t p = 0; p < set->count; p++) {
        set->members[p].first_piece *= pairings;
        set->members[p].pieces *= pairings;
    }
    free(strips->height_m);
    free(strips->seed);
    strips->seed = seed;
    strips->rows.seed = seed;
    strips->height_m = height_m;
    strips->rows.height_m = height_m;
    strips->rows.rows = rows;
    strips->rows.periodic =
        own.periodic && theirs->periodic && fabs((double)own.points * step / (double)theirs->points - 1) < 1e-6;
    return STATUS_OK;
}

/** Solves these rows as a strip, malloc'ed; NULL without a solution. Costs and problems are recorded in the order of
 * turns, whatever the threads. */
static enum status_code solve(struct solved_strip **out, struct strips *strips, size_t first, size_t count,
                              const struct threads *threads, struct threads_turn *turn, struct status *status)
{
    struct status problem = {0};
    struct solved_strip *solved = calloc(1, sizeof *solved);
    struct strip_rows rows = strips->rows;
    if (!solved)
        return status_memory(status);
    rows.height_m += first * rows.points;
    rows.seed += first;
    rows.rows = count;
    enum status_code rc = strip_solve(&solved->strip, &rows, strips->roughly ? STRIP_ROUGHLY : strip_surrogates(&rows),
                                      threads, &problem);
    if (rc == STATUS_OK)
        rc = bearing_make(&solved->bearing, &rows, &problem);
    if (!threads_wait(turn)) {
        solved_strip_free(solved);
        return STATUS_OK;
    }
    strips->transforms += solved->strip.transforms;
    strips->unsolved += solved->strip.unsolved;
    if (rc == STATUS_OK) {
        *out = solved;
        return STATUS_OK;
    }
    solved_strip_free(solved);
    if (strips->problem.code == STATUS_OK)
        strips->problem = problem;
    return rc == STATUS_MODEL ? STATUS_OK : status_fail(status, rc, "%s", problem.message);
}

enum status_code strips_solve(struct strips *strips, const struct threads *threads, struct status *status)
{
    return solve(&strips->joined, strips, 0, strips->rows.rows, threads, NULL, status);
}

/** The members' strips, each of one thread. */
struct alone {
    struct strips *strips;
    struct member *members;
    struct threads each;
};

static enum status_code solve_member(void *context, size_t index, struct threads_turn *turn, struct status *status)
{
    const struct alone *alone = context;
    struct member *member = &alone->members[index];
    return member->pieces == 0
               ? STATUS_OK
               : solve(&member->strip, alone->strips, member->first_piece, member->pieces, &alone->each, turn, status);
}

enum status_code strips_solve_members(struct strips *strips, struct ensemble *set, const struct threads *threads,
                                      struct status *status)
{
    struct alone alone = {strips, set->members, {1, threads->stop}};
    set->solved_alone = true;
    return threads_run(threads, set->count, solve_member, &alone, status);
}
