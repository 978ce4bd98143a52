/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_ensemble.h"
#include "base/threads.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

const double direct_ensemble_making = 7.5;

/** The work of the threads: the fine grid if there is one, then every seed. */
struct tasks {
    const struct direct_ensemble_def *def;
    struct direct_ensemble *ensemble;
    struct direct_point *fine; /* loads; NULL: none */
};

static void tell(const struct direct_ensemble_def *def, double work)
{
    if (def->solved)
        def->solved(def->solved_context, work);
}

/** Work to make a surface with given heights and to solve the ladder on n x n points, in points times loads. */
static double making_work(const struct direct_ensemble_def *def)
{
    return def->recipe.given_m && !def->map ? direct_ensemble_making * (double)(def->n * def->n) : 0;
}

static double ladder_work(const struct direct_ensemble_def *def, size_t n)
{
    return (double)(n * n) * (double)def->ladder.loads;
}

/** Solves the ladder of a grid's heights, which are freed as soon as they are copied, and tells of each load. */
static enum status_code solve_heights(struct direct_point *out, double *height_m, const struct direct_grid *grid,
                                      const struct direct_ensemble_def *def, struct status *status)
{
    OWNED(direct_contact_free) struct direct_contact contact = {.set = NULL};
    enum status_code rc = direct_contact_make(&contact, height_m, grid, status);
    free(height_m);
    if (rc != STATUS_OK)
        return rc;
    struct direct_ladder_def step = def->ladder;
    step.loads = 1;
    for (size_t i = 0; i < def->ladder.loads && rc == STATUS_OK; i++) {
        step.load = def->ladder.load + i;
        rc = direct_ladder_run(out + i, &contact, &step, status);
        tell(def, (double)(grid->nx * grid->ny));
    }
    return rc;
}

/** One surface's ladder; times > 1: on the finer grid. */
static enum status_code solve_surface(struct direct_point *out, const struct direct_ensemble_def *def, size_t seed,
                                      size_t times, struct status *status)
{
    size_t n = def->n, fine_n = n * times;
    double *height_m = malloc(n * n * sizeof *height_m);
    enum status_code rc =
        height_m ? direct_surface_make(height_m, n, &def->recipe, 1 + seed, status) : status_memory(status);
    if (rc == STATUS_OK && times > 1) {
        double *fine_m = malloc(fine_n * fine_n * sizeof *fine_m);
        rc = fine_m ? direct_surface_refine(fine_m, times, height_m, n, status) : status_memory(status);
        free(height_m);
        height_m = fine_m;
    }
    if (rc == STATUS_OK) {
        tell(def, making_work(def));
        const struct direct_grid grid = {fine_n, fine_n, def->length_m / (double)fine_n, false, false};
        return solve_heights(out, height_m, &grid, def, status);
    }
    free(height_m);
    return rc;
}

/** A part of the map, if it has it. */
static enum status_code solve_part(struct direct_point *out, const struct direct_ensemble_def *def,
                                   enum direct_map_part part, struct status *status)
{
    struct direct_map taken;
    if (!direct_map_has(def->map, part))
        return STATUS_OK;
    if (direct_map_take(&taken, def->map, part, status) != STATUS_OK)
        return status->code;
    return solve_heights(out, taken.height_m, &taken.grid, def, status);
}

double direct_ensemble_work(const struct direct_ensemble_def *def)
{
    size_t fine = def->fine_times > 1 && !def->map, surfaces = def->map ? 1 : def->seeds;
    double work = (double)surfaces * ladder_work(def, def->n) + (double)(surfaces + fine) * making_work(def);
    for (int part = DIRECT_MAP_WHOLE + 1; def->map && part < DIRECT_MAP_PARTS; part++)
        work += direct_map_has(def->map, (enum direct_map_part)part) ? ladder_work(def, def->n / 2) : 0;
    return work + (fine ? ladder_work(def, def->n * def->fine_times) : 0);
}

static enum status_code solve_task(void *context, size_t index, struct threads_turn *turn, struct status *status)
{
    const struct tasks *tasks = context;
    const struct direct_ensemble_def *def = tasks->def;
    bool fine = tasks->fine && index == 0;
    size_t seed = tasks->fine && !fine ? index - 1 : index;
    struct direct_point *out = fine ? tasks->fine : tasks->ensemble->seed_point + seed * tasks->ensemble->loads;
    (void)turn;
    return def->map ? solve_part(out, def, (enum direct_map_part)seed, status)
                    : solve_surface(out, def, seed, fine ? def->fine_times : 1, status);
}

/** Mean and standard error over `count` surfaces. */
static struct direct_mean mean_of(const struct direct_point *point, size_t count, size_t step,
                                  enum direct_quantity quantity)
{
    double sum = 0, square = 0, n = (double)count;
    for (size_t k = 0; k < count; k++)
        sum += direct_point_value(&point[k * step], quantity);
    for (size_t k = 0; k < count; k++) {
        double off = direct_point_value(&point[k * step], quantity) - sum / n;
        square += off * off;
    }
    return (struct direct_mean){sum / n, n > 1 ? sqrt(square / (n - 1) / n) : NAN, 1};
}

/** Means over the seeds, corrected by the ratio of the fine grid; what is 0 on the coarse grid is 0 on the fine one. */
static struct direct_mean over_seeds(const struct direct_ensemble *ensemble, const struct direct_point *fine,
                                     size_t load, enum direct_quantity quantity)
{
    const struct direct_point *coarse = &ensemble->seed_point[load];
    struct direct_mean mean = mean_of(coarse, ensemble->seeds, ensemble->loads, quantity);
    if (fine && direct_point_value(coarse, quantity) != 0)
        mean.fine_ratio = direct_point_value(&fine[load], quantity) / direct_point_value(coarse, quantity);
    mean.value *= mean.fine_ratio;
    mean.standard_error *= mean.fine_ratio;
    return mean;
}

/** Values of a map with their errors. */
static struct direct_mean of_map(const struct direct_ensemble *ensemble, const struct direct_map *map, size_t load,
                                 enum direct_quantity quantity)
{
    const struct direct_point *part = &ensemble->seed_point[load];
    double value[DIRECT_MAP_PARTS];
    for (size_t k = 0; k < DIRECT_MAP_PARTS; k++)
        value[k] = direct_point_value(&part[k * ensemble->loads], quantity);
    double error = value[DIRECT_MAP_WHOLE] - value[DIRECT_MAP_SECOND];
    if (direct_map_has(map, DIRECT_MAP_WIDER))
        error = hypot(error, value[DIRECT_MAP_WIDER] - value[DIRECT_MAP_SECOND]);
    for (int k = DIRECT_MAP_QUARTER; k < DIRECT_MAP_PARTS && direct_map_has(map, DIRECT_MAP_QUARTER); k++)
        error = hypot(error, (value[k] - value[DIRECT_MAP_WHOLE]) / sqrt(4 * 3)); /* half their scatter about it */
    return (struct direct_mean){value[DIRECT_MAP_WHOLE], fabs(error), 1};
}

static bool resolved(const struct direct_ensemble *ensemble, const struct direct_map *map, size_t load)
{
    const size_t least = map && map->grid.mirrored ? DIRECT_ENSEMBLE_POINTS / 4 : DIRECT_ENSEMBLE_POINTS;
    bool enough = true;
    for (size_t k = 0; k < ensemble->seeds; k++) {
        const struct direct_point *point = &ensemble->seed_point[k * ensemble->loads + load];
        enough &= point->exists && point->quantities.contact_points >= least;
    }
    return enough;
}

static void summarise(struct direct_ensemble *ensemble, const struct direct_point *fine,
                      const struct direct_ensemble_def *def)
{
    for (size_t load = 0; load < ensemble->loads; load++)
        for (int q = 0; q < DIRECT_QUANTITIES; q++)
            ensemble->point[load].mean[q] = !resolved(ensemble, def->map, load) ? (struct direct_mean){NAN, NAN, NAN}
                                            : def->map ? of_map(ensemble, def->map, load, (enum direct_quantity)q)
                                                       : over_seeds(ensemble, fine, load, (enum direct_quantity)q);
}

enum status_code direct_ensemble_run(struct direct_ensemble *out, const struct direct_ensemble_def *def,
                                     struct status *status)
{
    assert(def->seeds > 0 && def->ladder.loads > 0);
    const struct threads threads = {def->threads, def->ladder.stop};
    size_t fine = def->fine_times > 1 && !def->map, surfaces = def->map ? DIRECT_MAP_PARTS : def->seeds;
    *out = (struct direct_ensemble){.loads = def->ladder.loads, .seeds = def->map ? 1 : def->seeds};
    out->point = calloc(out->loads, sizeof *out->point);
    out->seed_point = calloc(surfaces * out->loads, sizeof *out->seed_point);
    struct tasks tasks = {def, out, fine ? calloc(out->loads, sizeof *tasks.fine) : NULL};
    if (!out->point || !out->seed_point || (fine && !tasks.fine))
        (void)status_memory(status);
    else if (threads_run(&threads, fine + surfaces, solve_task, &tasks, status) == STATUS_OK) {
        out->ladders = fine;
        for (size_t k = 0; k < surfaces; k++)
            out->ladders += !def->map || direct_map_has(def->map, (enum direct_map_part)k);
        summarise(out, tasks.fine, def);
    }
    free(tasks.fine);
    if (status->code != STATUS_OK)
        direct_ensemble_free(out);
    return status->code;
}

void direct_ensemble_free(struct direct_ensemble *ensemble)
{
    free(ensemble->point);
    free(ensemble->seed_point);
    *ensemble = (struct direct_ensemble){0};
}
