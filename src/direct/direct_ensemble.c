/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_ensemble.h"
#include "base/threads.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

/** What the threads work at: the fine grid if there is one, and then every seed. */
struct tasks {
    const struct direct_ensemble_def *def;
    struct direct_ensemble *ensemble;
    struct direct_point *fine; /* loads; NULL: none */
};

/** One surface's ladder; times > 1: on the finer grid. */
static enum status_code solve_surface(struct direct_point *out, double *rms_m, const struct direct_ensemble_def *def,
                                      size_t seed, size_t times, struct status *status)
{
    size_t n = def->n, fine_n = n * times;
    double *height_m = malloc(n * n * sizeof *height_m);
    enum status_code rc = height_m ? direct_surface_make(height_m, n, def->variance, def->context, def->given_m,
                                                         def->given_count, 1 + seed, status)
                                   : status_memory(status);
    if (rc == STATUS_OK && times > 1) {
        double *fine_m = malloc(fine_n * fine_n * sizeof *fine_m);
        rc = fine_m ? direct_surface_refine(fine_m, times, height_m, n, status) : status_memory(status);
        free(height_m);
        height_m = fine_m;
    }
    if (rc == STATUS_OK)
        return direct_ladder_of_heights(out, rms_m, NULL, height_m, fine_n, def->length_m / (double)fine_n,
                                        &def->ladder, def->team, status);
    free(height_m);
    return rc;
}

static enum status_code solve_task(void *context, size_t index, struct threads_turn *turn, struct status *status)
{
    const struct tasks *tasks = context;
    struct direct_ensemble *ensemble = tasks->ensemble;
    (void)turn;
    if (tasks->fine && index == 0)
        return solve_surface(tasks->fine, NULL, tasks->def, 0, tasks->def->fine_times, status);
    size_t seed = tasks->fine ? index - 1 : index;
    return solve_surface(ensemble->seed_point + seed * ensemble->loads, seed == 0 ? &ensemble->rms_m : NULL, tasks->def,
                         seed, 1, status);
}

/* The quantities that are averaged. */
enum averaged { AREA, GAP, CONSTRICTION, PATCHES };

static double value_of(const struct direct_point *point, enum averaged quantity)
{
    const double values[] = {[AREA] = point->quantities.area_ratio,
                             [GAP] = point->quantities.gap_m,
                             [CONSTRICTION] = point->constriction_m,
                             [PATCHES] = (double)point->patches};
    return values[quantity];
}

/** Mean and standard error over the seeds. */
static struct direct_mean mean_of(const struct direct_ensemble *ensemble, size_t load, enum averaged quantity)
{
    double sum = 0, square = 0, n = (double)ensemble->seeds;
    for (size_t k = 0; k < ensemble->seeds; k++)
        sum += value_of(&ensemble->seed_point[k * ensemble->loads + load], quantity);
    for (size_t k = 0; k < ensemble->seeds; k++) {
        double off = value_of(&ensemble->seed_point[k * ensemble->loads + load], quantity) - sum / n;
        square += off * off;
    }
    return (struct direct_mean){sum / n, n > 1 ? sqrt(square / (n - 1) / n) : NAN, 1};
}

/** Corrected by the fine grid's ratio; a quantity that is 0 on the coarse grid is 0 on the fine one. The distance of
 * the mean planes, which may be 0 or less, by a difference. */
static struct direct_mean corrected(const struct direct_ensemble *ensemble, const struct direct_point *fine,
                                    size_t load, enum averaged quantity)
{
    struct direct_mean mean = mean_of(ensemble, load, quantity);
    double coarse = value_of(&ensemble->seed_point[load], quantity);
    if (fine && coarse != 0)
        mean.fine_ratio = value_of(&fine[load], quantity) / coarse;
    mean.value *= mean.fine_ratio;
    mean.standard_error *= mean.fine_ratio;
    return mean;
}

static enum direct_ensemble_state state_of(const struct direct_ensemble *ensemble, size_t load)
{
    bool few = false;
    for (size_t k = 0; k < ensemble->seeds; k++) {
        const struct direct_point *point = &ensemble->seed_point[k * ensemble->loads + load];
        if (!point->exists)
            return DIRECT_ENSEMBLE_COMPLETE;
        few |= point->quantities.contact_points < DIRECT_ENSEMBLE_POINTS;
    }
    return few ? DIRECT_ENSEMBLE_FEW_POINTS : DIRECT_ENSEMBLE_GIVEN;
}

static void summarise(struct direct_ensemble *ensemble, const struct direct_point *fine, double length_m)
{
    static const struct direct_mean none = {NAN, NAN, NAN};
    double cell_m2 = length_m * length_m;
    for (size_t load = 0; load < ensemble->loads; load++) {
        struct direct_ensemble_point *point = &ensemble->point[load];
        *point = (struct direct_ensemble_point){
            .area_ratio = none, .gap_m = none, .constriction_m = none, .patches_per_m2 = none};
        point->state = state_of(ensemble, load);
        if (point->state != DIRECT_ENSEMBLE_GIVEN)
            continue;
        point->area_ratio = corrected(ensemble, fine, load, AREA);
        point->gap_m = corrected(ensemble, fine, load, GAP);
        point->constriction_m = corrected(ensemble, fine, load, CONSTRICTION);
        point->patches_per_m2 = corrected(ensemble, fine, load, PATCHES);
        point->patches_per_m2.value /= cell_m2;
        point->patches_per_m2.standard_error /= cell_m2;
    }
}

enum status_code direct_ensemble_run(struct direct_ensemble *out, const struct direct_ensemble_def *def,
                                     struct status *status)
{
    assert(def->seeds > 0 && def->ladder.loads > 0);
    const struct threads threads = {def->team ? 1 : def->threads, def->ladder.stop};
    size_t fine = def->fine_times > 1;
    *out = (struct direct_ensemble){.loads = def->ladder.loads, .seeds = def->seeds, .rms_m = NAN};
    out->point = calloc(out->loads, sizeof *out->point);
    out->seed_point = calloc(def->seeds * out->loads, sizeof *out->seed_point);
    struct tasks tasks = {def, out, fine ? calloc(out->loads, sizeof *tasks.fine) : NULL};
    if (!out->point || !out->seed_point || (fine && !tasks.fine))
        (void)status_memory(status);
    else if (threads_run(&threads, fine + def->seeds, solve_task, &tasks, status) == STATUS_OK) {
        for (size_t k = 0; k < def->seeds * out->loads; k++)
            out->convolutions += out->seed_point[k].convolutions;
        for (size_t k = 0; tasks.fine && k < out->loads; k++)
            out->fine_convolutions += tasks.fine[k].convolutions;
        summarise(out, tasks.fine, def->length_m);
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
