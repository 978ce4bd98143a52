/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "members/tiles.h"
#include "base/clock.h"
#include "base/costs.h"

#include "direct/direct_quantities.h"
#include "direct/direct_surface.h"
#include "spectrum/areal.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

const double tiles_budget = 7.5e10;

enum {
    LEAST_SIDE = 32,
    LEAST_POINTS = 12, /* in contact; with fewer a solution is not used */
    BEYOND = 2         /* above the hardness every second load is solved elastically, and steps may be twice as wide: */
}; /* 18 % less of a default report, elastic answers there within 4 %, those with the hardness within .4 % */

static const double tolerance = 3e-4;             /* changes no answer by 0.5 %; 1e-3 changes a resistance by 0.63 % */
static const double coarse = 0.9, closest = 1.15; /* steps of logit A, and loads */
static const double enough = 0.97;                /* A/A_n above which no heavier load is solved */

void tiles_free(struct tiles *tiles)
{
    if (tiles->transfer)
        transfer_free(tiles->transfer);
    free(tiles->transfer);
    free(tiles->height_m);
    *tiles = (struct tiles){.height_m = NULL};
}

/** Divides the map into squares of at most TILES_SIDE points, and chooses how many are solved. */
static void lay_out(struct tiles *tiles)
{
    const struct direct_map_def *def = &tiles->def;
    size_t least = def->nx < def->ny ? def->nx : def->ny, parts = (least + TILES_SIDE - 1) / TILES_SIDE;
    tiles->side = direct_map_mirrored(def, TILES_SIDE) ? fft_quick(least / parts, DIRECT_MAP_FACTOR) : least;
    tiles->columns = def->nx / tiles->side;
    tiles->rows = def->ny / tiles->side;
    while (tiles->columns * tiles->rows > TILES_MOST)
        --*(tiles->columns > tiles->rows ? &tiles->columns : &tiles->rows);
}

void tiles_take(struct tiles *out, struct scan *scan, const struct direct_map_def *def)
{
    size_t least = scan->nx < scan->ny ? scan->nx : scan->ny;
    if (least < LEAST_SIDE || !(fabs(scan->dy_m / scan->dx_m - 1) <= 0.01))
        return;
    *out = (struct tiles){.height_m = scan->z_m, .def = *def};
    out->def.nx = scan->nx;
    out->def.ny = scan->ny;
    out->def.single = true;
    scan->z_m = NULL;
    lay_out(out);
}

enum { SHIFT_SEED = 0x6d617073 };

/** Index of place i on a line of n points that goes on around or as its mirror image. */
static size_t fold(size_t i, size_t n, bool periodic)
{
    size_t within = i % (periodic ? n : 2 * n);
    return within < n ? within : 2 * n - 1 - within;
}

void tiles_pair(struct tiles *tiles, const struct tiles *other)
{
    const struct direct_map_def *own = &tiles->def, *theirs = &other->def;
    if (!tiles->height_m || !other->height_m || !(fabs(own->dx_m / theirs->dx_m - 1) <= 0.01)) {
        tiles_free(tiles);
        return;
    }
    size_t right = (size_t)(direct_random(SHIFT_SEED, 0) * 2 * (double)theirs->nx),
           down = (size_t)(direct_random(SHIFT_SEED, 1) * 2 * (double)theirs->ny);
    for (size_t j = 0; j < own->ny; j++)
        for (size_t i = 0; i < own->nx; i++)
            tiles->height_m[j * own->nx + i] +=
                other->height_m[fold(j + down, theirs->ny, theirs->periodic) * theirs->nx +
                                fold(i + right, theirs->nx, theirs->periodic)];
    tiles->def.periodic = own->periodic && theirs->periodic && own->nx == theirs->nx && own->ny == theirs->ny;
    tiles->def.cutoff = fmax(own->cutoff, theirs->cutoff);
}

/** Where square s begins: they are evenly spaced over the map. */
static size_t first_of(const struct tiles *tiles, size_t s)
{
    size_t column = s % tiles->columns, row = s / tiles->columns;
    size_t free_x = tiles->def.nx - tiles->side, free_y = tiles->def.ny - tiles->side;
    size_t x = tiles->columns > 1 ? column * free_x / (tiles->columns - 1) : free_x / 2,
           y = tiles->rows > 1 ? row * free_y / (tiles->rows - 1) : free_y / 2;
    return y * tiles->def.nx + x;
}

double tiles_missing(const struct tiles *tiles)
{
    double most = 0, points = (double)(tiles->side * tiles->side);
    for (size_t s = 0; tiles->height_m && s < tiles->columns * tiles->rows; s++) {
        size_t holes = 0;
        const double *first = tiles->height_m + first_of(tiles, s);
        for (size_t k = 0; k < tiles->side * tiles->side; k++)
            holes += isnan(first[k / tiles->side * tiles->def.nx + k % tiles->side]) != 0;
        most = fmax(most, (double)holes / points);
    }
    return most;
}

double tiles_share(const struct tiles *tiles)
{
    return (double)(tiles->columns * tiles->rows * tiles->side * tiles->side) / (double)(tiles->def.nx * tiles->def.ny);
}

double tiles_cost(const struct tiles *tiles, bool capped)
{
    if (!tiles->height_m)
        return 0;
    const double side = (double)tiles->side;
    return (double)(tiles->columns * tiles->rows) * pow(side, 2 + costs.map_power) *
           (costs.map_transforms_elastic + (capped ? costs.map_transforms : 0));
}

bool tiles_fit(struct tiles *tiles, bool capped, double most)
{
    while (tiles->columns * tiles->rows > 1 && tiles_cost(tiles, capped) > most)
        --*(tiles->columns > tiles->rows ? &tiles->columns : &tiles->rows);
    return tiles->height_m && tiles_cost(tiles, capped) <= most;
}

/** Fills gaps of a line by straight lines; false: nothing is there. */
static bool bridge(double *line_m, size_t points)
{
    size_t last = points; /* point that is there */
    for (size_t i = 0; i < points; i++) {
        if (isnan(line_m[i]))
            continue;
        for (size_t k = last < points ? last + 1 : 0; k < i; k++)
            line_m[k] = last < points
                            ? line_m[last] + (line_m[i] - line_m[last]) * (double)(k - last) / (double)(i - last)
                            : line_m[i];
        last = i;
    }
    for (size_t k = last + 1; k < points; k++)
        line_m[k] = line_m[last];
    return last < points;
}

enum status_code tiles_spectrum_along(struct spectrum *out, const struct scan *map, struct direct_map_lines lines,
                                      bool mirrored, struct status *status)
{
    const size_t points = lines.points;
    OWNED(memory_free) double *line_m = malloc(2 * points * sizeof *line_m);
    size_t taken = 0;
    enum status_code rc = line_m ? STATUS_OK : status_memory(status);
    for (size_t k = 0; k < lines.count && rc == STATUS_OK; k++) {
        for (size_t i = 0; i < points; i++)
            line_m[i] = map->z_m[k * lines.next + i * lines.step];
        if (!bridge(line_m, points))
            continue;
        for (size_t i = 0; i < points; i++)
            line_m[2 * points - 1 - i] = mirrored ? line_m[i] : line_m[2 * points - 1 - i];
        rc = spectrum_add_record(out, taken++, line_m, (mirrored ? 2 : 1) * points, map->dx_m, status);
    }
    return rc;
}

/** From rows and columns alike: the spectrum of an isotropic surface with the same mean-square gradient. */
static enum status_code spectrum_of(struct spectrum *out, const struct scan *map, bool mirrored, struct status *status)
{
    OWNED(spectrum_free) struct spectrum across = {0};
    if (tiles_spectrum_along(out, map, direct_map_lines(map->nx, map->ny, false), mirrored, status) == STATUS_OK &&
        tiles_spectrum_along(&across, map, direct_map_lines(map->nx, map->ny, true), mirrored, status) == STATUS_OK)
        (void)!grid_average(out, &across, 1, status);
    return status->code;
}

/** The spectrum of the whole map over its plane, or of the square if that is the whole map. */
static enum status_code spectrum_of_all(struct spectrum *out, const struct tiles *tiles,
                                        const struct transfer_square *square, struct status *status)
{
    const struct direct_map_def *def = &tiles->def;
    struct scan scan = {.nx = def->nx, .ny = def->ny, .dx_m = def->dx_m, .z_m = tiles->height_m};
    if (tiles->side == def->nx && tiles->side == def->ny)
        return spectrum_copy(out, &square->spectrum, status);
    OWNED(memory_free) double *flat_m = malloc(def->nx * def->ny * sizeof *flat_m);
    if (!flat_m)
        return status_memory(status);
    enum status_code rc = areal_flatten(flat_m, &scan, status);
    scan.z_m = flat_m;
    return rc == STATUS_OK ? spectrum_of(out, &scan, !def->periodic, status) : rc;
}

/** What one map is solved for. */
struct ladder {
    double load[TRANSFER_LOADS];
    size_t loads;
    double hardness, finest; /* INFINITY: elastic; above this load steps are coarser: BEYOND */
    const atomic_bool *stop;
};

/** On the solutions of one kind, by all threads: neither kind uses what the other found. */
struct spent {
    atomic_uint_fast64_t transforms, nanoseconds; /* of CPU: a thread's own, however many share a processor */
};

static enum status_code solve_load(struct transfer_point *out, struct direct_contact *contact, double load,
                                   const struct ladder *ladder, struct spent *spent, struct status *status)
{
    const struct direct_ladder_def def = {&load, 1, ladder->hardness, tolerance, true, ladder->stop, true};
    struct direct_point found;
    *out = (struct transfer_point){load, NAN, NAN, NAN};
    if (direct_ladder_run(&found, contact, &def, status) != STATUS_OK)
        return status->code;
    spent->transforms += found.convolutions * contact->kernel.points;
    if (found.quantities.contact_points >= LEAST_POINTS)
        *out = (struct transfer_point){load, found.quantities.area_ratio, found.quantities.gap_m, found.constriction_m};
    return STATUS_OK;
}

/** First load after which contact grows by more than interpolation can follow; 0: nowhere. */
static size_t coarsest(const struct transfer_point *point, size_t loads, double finest)
{
    size_t at = 0;
    double most = coarse;
    for (size_t k = 1; k < loads; k++) {
        double area[2] = {fmin(point[k - 1].area_ratio, enough), fmin(point[k].area_ratio, enough)};
        double grown = log(area[1] / area[0] * (1 - area[0]) / (1 - area[1]));
        grown /= point[k - 1].load < finest ? 1 : BEYOND;
        if (isnan(point[k - 1].area_ratio) || point[k].load < closest * point[k - 1].load || !(grown > most))
            continue;
        most = grown;
        at = k;
    }
    return at;
}

/** Solves a map at the loads of the ladder, and at some more between them if `refine`; useless solutions become NaN. */
static enum status_code solve(struct transfer_point *out, const struct direct_map *map, struct ladder *ladder,
                              bool refine, struct spent *spent, struct status *status)
{
    const double started = clock_own_seconds();
    OWNED(direct_contact_free) struct direct_contact contact = {.set = NULL};
    size_t at;
    for (size_t i = 0; i < ladder->loads; i++)
        out[i] = (struct transfer_point){ladder->load[i], NAN, NAN, NAN};
    if (direct_contact_make(&contact, map->height_m, &map->grid, status) != STATUS_OK)
        return status->code;
    for (size_t i = 0; i < ladder->loads && status->code == STATUS_OK; i++)
        if (solve_load(&out[i], &contact, ladder->load[i], ladder, spent, status) != STATUS_OK ||
            out[i].area_ratio > enough)
            break;
    while (refine && status->code == STATUS_OK && ladder->loads < TRANSFER_LOADS &&
           (at = coarsest(out, ladder->loads, ladder->finest)) > 0) {
        double load = sqrt(ladder->load[at - 1] * ladder->load[at]);
        memmove(out + at + 1, out + at, (ladder->loads - at) * sizeof *out);
        memmove(ladder->load + at + 1, ladder->load + at, (ladder->loads++ - at) * sizeof *ladder->load);
        ladder->load[at] = load;
        (void)solve_load(&out[at], &contact, load, ladder, spent, status);
    }
    spent->nanoseconds += (uint64_t)(1e9 * (clock_own_seconds() - started));
    return status->code;
}

static double ln_of(const struct transfer_point *point, int which)
{
    const double value[3] = {point->area_ratio, point->separation_m, point->constriction_m};
    return value[which] > 0 ? log(value[which]) : NAN;
}

/** Standard deviation of `count` numbers. */
static double scatter(const double *value, size_t count)
{
    double mean = 0, square = 0;
    for (size_t k = 0; k < count; k++)
        mean += value[k] / (double)count;
    for (size_t k = 0; k < count; k++)
        square += pow(value[k] - mean, 2);
    return sqrt(square / (double)(count - 1));
}

enum { KINDS = 2 /* elastic, and below the hardness */ };

/** Every solution that the tiles take, on several threads. */
struct work {
    struct tiles *tiles;
    size_t count, kinds; /* of squares; solved */
    struct direct_map first;
    struct transfer_square *square;
    struct ladder ladder[KINDS]; /* complete once the first square is solved */
    struct transfer_point part[KINDS][DIRECT_MAP_PARTS][TRANSFER_LOADS];
    struct spent spent[KINDS];
};

/** The loads at which errors are found: not the ends of a ladder, where hardly anything or everything touches. */
static struct ladder told_at(size_t only[TRANSFER_ERRORS], const struct ladder *whole)
{
    struct ladder out = *whole;
    out.loads = whole->loads < TRANSFER_ERRORS ? whole->loads : TRANSFER_ERRORS;
    for (size_t k = 0; k < out.loads; k++) {
        only[k] = whole->loads * (k + 1) / (out.loads + 1);
        out.load[k] = whole->load[only[k]];
    }
    return out;
}

/** With fewer than four squares the scatter is that of the quarters of the first. */
static bool quartered(const struct work *work)
{
    return work->count < 4; /* also of a periodic map, which is one sample of its surface */
}

/** The errors of one kind: root of the sum of squares of what every second point changes, what a wider low-pass
 * changes, and the scatter over the squares, or over the quarters of the first where they are fewer than four. The
 * scatter of the four quarters is not divided by two: waves as long as the map make whole maps differ as much as their
 * quarters. */
static void find_errors(struct transfer_errors *out, struct work *work, int kind)
{
    struct transfer_point(*part)[TRANSFER_LOADS] = work->part[kind];
    size_t only[TRANSFER_ERRORS];
    const struct ladder ladder = told_at(only, &work->ladder[kind]);
    for (size_t k = 0; k < ladder.loads; k++) {
        out->ln_load[k] = log(ladder.load[k]);
        part[DIRECT_MAP_WHOLE][k] = work->square[0].point[kind][only[k]];
        for (int q = 0; q < 3; q++) {
            double of[DIRECT_MAP_PARTS], over[TILES_MOST];
            for (int p = 0; p < DIRECT_MAP_PARTS; p++)
                of[p] = ln_of(&part[p][k], q);
            for (size_t s = 0; s < work->count; s++)
                over[s] = ln_of(&work->square[s].point[kind][only[k]], q);
            double error = of[DIRECT_MAP_WHOLE] - of[DIRECT_MAP_SECOND];
            double wider =
                direct_map_has(&work->first, DIRECT_MAP_WIDER) ? of[DIRECT_MAP_WIDER] - of[DIRECT_MAP_SECOND] : 0;
            out->value[k][q] = hypot(hypot(error, wider), quartered(work) ? scatter(of + DIRECT_MAP_QUARTER, 4)
                                                                          : scatter(over, work->count));
        }
    }
    out->count = ladder.loads;
}

static enum status_code take_bearing(double out[TRANSFER_BEARING], const struct direct_map *map, struct status *status)
{
    size_t count = map->grid.nx * map->grid.ny;
    OWNED(memory_free) double *height_m = malloc(count * sizeof *height_m);
    if (!height_m)
        return status_memory(status);
    memcpy(height_m, map->height_m, count * sizeof *height_m);
    transfer_bearing(out, height_m, count);
    return STATUS_OK;
}

static enum status_code make_square(struct direct_map *out, const struct tiles *tiles, size_t s, struct status *status)
{
    return direct_map_make(out, tiles->height_m + first_of(tiles, s), &tiles->def, tiles->side, status);
}

/** The properties of a square that are known without solving it. */
static enum status_code describe(struct transfer_square *out, const struct direct_map *map, struct status *status)
{
    const struct scan all = {.nx = map->grid.nx, .ny = map->grid.ny, .dx_m = map->grid.spacing_m, .z_m = map->height_m};
    return spectrum_of(&out->spectrum, &all, map->grid.mirrored, status) == STATUS_OK
               ? take_bearing(out->bearing, map, status)
               : status->code;
}

/** Solves one of the other squares. */
static enum status_code solve_square(struct work *work, int kind, size_t s, struct status *status)
{
    OWNED(direct_map_free) struct direct_map map = {.height_m = NULL};
    if (make_square(&map, work->tiles, s, status) == STATUS_OK &&
        (kind > 0 || describe(&work->square[s], &map, status) == STATUS_OK))
        (void)solve(work->square[s].point[kind], &map, &work->ladder[kind], false, &work->spent[kind], status);
    return status->code;
}

/** Solves a part of the first square, if it contributes to the error. */
static enum status_code solve_part(struct work *work, int kind, enum direct_map_part p, struct status *status)
{
    OWNED(direct_map_free) struct direct_map map = {.height_m = NULL};
    size_t only[TRANSFER_ERRORS];
    struct ladder ladder = told_at(only, &work->ladder[kind]);
    if (p >= DIRECT_MAP_QUARTER ? !quartered(work) : !direct_map_has(&work->first, p))
        return STATUS_OK;
    if (direct_map_take(&map, &work->first, p, status) == STATUS_OK)
        (void)solve(work->part[kind][p], &map, &ladder, false, &work->spent[kind], status);
    return status->code;
}

/** Solves the first square, below the hardness and elastic. */
static enum status_code solve_first(void *context, size_t index, struct threads_turn *turn, struct status *status)
{
    struct work *work = context;
    const size_t kind = work->kinds - 1 - index;
    (void)turn;
    return solve(work->square[0].point[kind], &work->first, &work->ladder[kind], true, &work->spent[kind], status);
}

/** How many others there are of each kind: the other squares, then the parts of the first. */
static size_t others_of(const struct work *work)
{
    return work->count - 1 + DIRECT_MAP_PARTS - DIRECT_MAP_SECOND;
}

static enum status_code solve_other(void *context, size_t index, struct threads_turn *turn, struct status *status)
{
    struct work *work = context;
    const size_t others = others_of(work), s = 1 + index % others;
    const int kind = (int)(work->kinds - 1 - index / others);
    (void)turn;
    return s < work->count
               ? solve_square(work, kind, s, status)
               : solve_part(work, kind, (enum direct_map_part)(DIRECT_MAP_SECOND + s - work->count), status);
}

/** Solves all. */
static enum status_code solve_all(struct work *work, const struct threads *threads, struct status *status)
{
    struct ladder *ladder = work->ladder;
    if (make_square(&work->first, work->tiles, 0, status) != STATUS_OK ||
        describe(&work->square[0], &work->first, status) != STATUS_OK)
        return status->code;
    const double gradient = sqrt(2 * spectrum_moment(&work->square[0].spectrum, 1));
    for (size_t k = 0; k < TRANSFER_LADDER; k++) {
        double load = transfer_ladder[k] * gradient;
        bool beyond = ladder[0].loads > 0 && ladder[0].load[ladder[0].loads - 1] >= ladder[0].finest;
        if (!beyond || (TRANSFER_LADDER - 1 - k) % BEYOND == 0)
            ladder[0].load[ladder[0].loads++] = load;
    }
    ladder[1].loads = transfer_capped_loads(ladder[1].load, gradient, ladder[1].hardness);
    work->kinds = ladder[1].loads > 0 ? 2 : 1;
    if (threads_run(threads, work->kinds, solve_first, work, status) != STATUS_OK)
        return status->code;
    return threads_run(threads, work->kinds * others_of(work), solve_other, work, status);
}

static enum status_code run(struct tiles *tiles, double hardness, const struct threads *threads, struct status *status)
{
    struct work work = {.tiles = tiles,
                        .count = tiles->columns * tiles->rows,
                        .ladder = {{.hardness = INFINITY, .finest = hardness, .stop = threads->stop},
                                   {.hardness = hardness, .finest = INFINITY, .stop = threads->stop}}};
    struct transfer *transfer = tiles->transfer = calloc(1, sizeof *transfer);
    work.square = calloc(work.count, sizeof *work.square);
    enum status_code rc = work.square && transfer ? solve_all(&work, threads, status) : status_memory(status);
    if (rc == STATUS_OK)
        rc = spectrum_of_all(&transfer->spectrum, tiles, work.square, status);
    if (rc == STATUS_OK)
        rc = transfer_make(
            transfer, &(struct transfer_squares){work.square, work.count, {work.ladder[0].loads, work.ladder[1].loads}},
            hardness, status);
    for (int kind = 0; kind < (int)work.kinds && rc == STATUS_OK; kind++)
        find_errors(&transfer->error[kind], &work, kind);
    for (size_t s = 0; work.square && s < work.count; s++)
        spectrum_free(&work.square[s].spectrum);
    direct_map_free(&work.first);
    free(work.square);
    for (int kind = 0; kind < KINDS; kind++)
        tiles->transforms[kind] = work.spent[kind].transforms;
    const double capped = (double)work.spent[1].nanoseconds;
    tiles->capped = capped > 0 ? capped / (capped + (double)work.spent[0].nanoseconds) : 0;
    return rc;
}

enum status_code tiles_solve(struct tiles *tiles, double hardness, const struct threads *threads, struct status *status)
{
    enum status_code rc = run(tiles, hardness, threads, &tiles->problem);
    if (rc != STATUS_OK && tiles->transfer) {
        transfer_free(tiles->transfer);
        free(tiles->transfer);
        tiles->transfer = NULL;
    }
    return rc == STATUS_OK || rc == STATUS_MODEL || rc == STATUS_SCAN
               ? STATUS_OK
               : status_fail(status, rc, "%s", tiles->problem.message);
}
