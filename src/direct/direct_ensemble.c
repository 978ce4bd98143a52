/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_ensemble.h"
#include "base/thread.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <unistd.h>

enum { THREADS_MOST = 64 };

/** What the threads share; `lock` guards next. Tasks are taken in order, so whichever thread fails, the first task that
 * failed is the same. */
struct seed_pool {
    const struct direct_ensemble_def *def;
    struct direct_ensemble *ensemble;
    struct direct_point *fine; /* loads; NULL: none */
    struct status *problem;    /* one a task */
    pthread_mutex_t lock;
    size_t next, end; /* task 0 is the fine grid, task 1 + k seed k */
    bool failed;
};

static enum status_code synthesise(double *height_m, const struct direct_ensemble_def *def, size_t seed,
                                   struct status *status)
{
    if (def->given_m)
        return direct_surface_with_heights(height_m, def->n, def->variance, def->context, def->given_m,
                                           def->given_count, def->first_seed + seed, status);
    return direct_surface_realise(height_m, def->n, def->variance, def->context, def->first_seed + seed, status);
}

/** One surface's ladder; times > 1: on the finer grid. */
static enum status_code solve_surface(struct direct_point *out, double *rms_m, const struct direct_ensemble_def *def,
                                      size_t seed, size_t times, struct status *status)
{
    size_t n = def->n * times;
    double *coarse = malloc(def->n * def->n * sizeof *coarse), *height_m = coarse;
    struct direct_contact contact = {0};
    if (!coarse || (times > 1 && !(height_m = malloc(n * n * sizeof *height_m)))) {
        free(coarse);
        return status_memory(status);
    }
    enum status_code rc = synthesise(coarse, def, seed, status);
    if (rc == STATUS_OK && times > 1)
        rc = direct_surface_refine(height_m, times, coarse, def->n, status);
    if (rc == STATUS_OK)
        rc = direct_contact_make(&contact, height_m, n, n, def->length_m / (double)n, status);
    if (times > 1)
        free(height_m);
    free(coarse);
    if (rc != STATUS_OK)
        return rc;
    *rms_m = contact.rms_m;
    rc = direct_ladder_run(out, &contact, &def->ladder, status);
    direct_contact_free(&contact);
    return rc;
}

static bool take_seed(struct seed_pool *pool, size_t *task)
{
    pthread_mutex_lock(&pool->lock);
    bool more = !pool->failed && pool->next < pool->end;
    if (more)
        *task = pool->next++;
    pthread_mutex_unlock(&pool->lock);
    return more;
}

static void *work(void *context)
{
    struct seed_pool *pool = context;
    for (size_t task; take_seed(pool, &task);) {
        double rms_m;
        struct status *problem = &pool->problem[task];
        size_t loads = pool->ensemble->loads;
        enum status_code rc = task == 0
                                  ? solve_surface(pool->fine, &rms_m, pool->def, 0, pool->def->fine_times, problem)
                                  : solve_surface(pool->ensemble->seed_point + (task - 1) * loads, &rms_m, pool->def,
                                                  task - 1, 1, problem);
        pthread_mutex_lock(&pool->lock);
        if (task == 1)
            pool->ensemble->rms_m = rms_m;
        pool->failed |= rc != STATUS_OK;
        pthread_mutex_unlock(&pool->lock);
    }
    return NULL;
}

/** The tasks up to `end`, by the crew. */
static enum status_code ask_crew(struct seed_pool *pool, size_t end, struct status *status)
{
    const struct direct_crew *crew = pool->def->crew;
    struct direct_ensemble *ensemble = pool->ensemble;
    double rms_m;
    if (pool->next == 0 && crew->fine(crew, pool->fine, pool->def, status) != STATUS_OK)
        return status->code;
    size_t first = pool->next > 0 ? pool->next - 1 : 0;
    if (crew->surfaces(crew, ensemble->seed_point + first * ensemble->loads, &rms_m, pool->def, first, end - 1 - first,
                       status) != STATUS_OK)
        return status->code;
    if (first == 0)
        ensemble->rms_m = rms_m;
    pool->next = end;
    return STATUS_OK;
}

/** The tasks up to `end`, in threads. */
static enum status_code solve_seeds(struct seed_pool *pool, size_t end, struct status *status)
{
    if (pool->def->crew)
        return ask_crew(pool, end, status);
    pthread_t threads[THREADS_MOST];
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    size_t wanted = pool->def->threads ? pool->def->threads : processors > 0 ? (size_t)processors : 1, started = 0;
    wanted = wanted < THREADS_MOST ? wanted : THREADS_MOST;
    wanted = wanted < end - pool->next ? wanted : end - pool->next;
    pool->end = end;
    while (started + 1 < wanted && thread_start(&threads[started], work, pool))
        started++;
    (void)work(pool);
    for (size_t i = 0; i < started; i++)
        pthread_join(threads[i], NULL);
    for (size_t task = 0; task < end; task++)
        if (pool->problem[task].code != STATUS_OK)
            return status_fail(status, pool->problem[task].code, "%s", pool->problem[task].message);
    return STATUS_OK;
}

/* The quantities that are averaged. */

static double area_of(const struct direct_point *point)
{
    return point->quantities.area_ratio;
}

static double gap_of(const struct direct_point *point)
{
    return point->quantities.gap_m;
}

static double plane_gap_of(const struct direct_point *point)
{
    return point->quantities.plane_gap_m;
}

static double constriction_of(const struct direct_point *point)
{
    return point->constriction_m;
}

static double patches_of(const struct direct_point *point)
{
    return (double)point->patches;
}

/** Mean and standard error over the seeds, of the values or of their logarithms. */
static struct direct_mean mean_of(const struct direct_ensemble *ensemble, size_t load,
                                  double (*quantity)(const struct direct_point *), bool logarithm)
{
    double sum = 0, square = 0, n = (double)ensemble->seeds;
    for (int pass = 0; pass < 2; pass++)
        for (size_t k = 0; k < ensemble->seeds; k++) {
            double value = quantity(&ensemble->seed_point[k * ensemble->loads + load]);
            value = logarithm ? log(value) : value;
            if (pass == 0)
                sum += value;
            else
                square += (value - sum / n) * (value - sum / n);
        }
    return (struct direct_mean){sum / n, n > 1 ? sqrt(square / (n - 1) / n) : NAN, 1};
}

/** Corrected by the fine grid's ratio; a quantity that is 0 on the coarse grid is 0 on the fine one. */
static struct direct_mean corrected(const struct direct_ensemble *ensemble, const struct direct_point *fine,
                                    size_t load, double (*quantity)(const struct direct_point *))
{
    struct direct_mean mean = mean_of(ensemble, load, quantity, false);
    double coarse = quantity(&ensemble->seed_point[load]);
    if (fine && coarse != 0)
        mean.fine_ratio = quantity(&fine[load]) / coarse;
    mean.value *= mean.fine_ratio;
    mean.standard_error *= mean.fine_ratio;
    return mean;
}

/** The distance of the mean planes may be 0 or less: corrected by a difference. */
static struct direct_mean shifted(const struct direct_ensemble *ensemble, const struct direct_point *fine, size_t load)
{
    struct direct_mean mean = mean_of(ensemble, load, plane_gap_of, false);
    mean.fine_ratio = fine ? plane_gap_of(&fine[load]) - plane_gap_of(&ensemble->seed_point[load]) : 0;
    mean.value += mean.fine_ratio;
    return mean;
}

static enum direct_ensemble_state state_of(const struct direct_ensemble *ensemble, size_t load, size_t *least)
{
    *least = SIZE_MAX;
    for (size_t k = 0; k < ensemble->seeds; k++) {
        const struct direct_point *point = &ensemble->seed_point[k * ensemble->loads + load];
        if (!point->exists) {
            *least = 0;
            return DIRECT_ENSEMBLE_COMPLETE;
        }
        if (point->quantities.contact_points < *least)
            *least = point->quantities.contact_points;
    }
    return *least < DIRECT_ENSEMBLE_POINTS ? DIRECT_ENSEMBLE_FEW_POINTS : DIRECT_ENSEMBLE_GIVEN;
}

/** Is the standard error small enough at every load that gives numbers? A gap or constriction of 0 scatters no more. */
static bool is_enough(const struct direct_ensemble *ensemble, const struct direct_ensemble_def *def)
{
    size_t least;
    if (!(def->enough > 0) || ensemble->seeds < 2)
        return false;
    for (size_t load = 0; load < ensemble->loads; load++) {
        if (state_of(ensemble, load, &least) != DIRECT_ENSEMBLE_GIVEN)
            continue;
        double (*quantity)(const struct direct_point *) = def->ladder.resistance ? constriction_of : gap_of;
        bool zero = false;
        for (size_t k = 0; k < ensemble->seeds; k++)
            zero |= quantity(&ensemble->seed_point[k * ensemble->loads + load]) <= 0;
        if (!zero && !(mean_of(ensemble, load, quantity, true).standard_error < def->enough))
            return false;
    }
    return true;
}

static void summarise(struct direct_ensemble *ensemble, const struct direct_point *fine, double length_m)
{
    static const struct direct_mean none = {NAN, NAN, NAN};
    double cell_m2 = length_m * length_m;
    for (size_t load = 0; load < ensemble->loads; load++) {
        struct direct_ensemble_point *point = &ensemble->point[load];
        *point = (struct direct_ensemble_point){
            .area_ratio = none, .gap_m = none, .plane_gap_m = none, .constriction_m = none, .patches_per_m2 = none};
        point->state = state_of(ensemble, load, &point->least_points);
        if (point->state != DIRECT_ENSEMBLE_GIVEN)
            continue;
        point->area_ratio = corrected(ensemble, fine, load, area_of);
        point->gap_m = corrected(ensemble, fine, load, gap_of);
        point->plane_gap_m = shifted(ensemble, fine, load);
        point->constriction_m = corrected(ensemble, fine, load, constriction_of);
        point->patches_per_m2 = corrected(ensemble, fine, load, patches_of);
        point->patches_per_m2.value /= cell_m2;
        point->patches_per_m2.standard_error /= cell_m2;
    }
}

static enum status_code run(struct seed_pool *pool, struct status *status)
{
    struct direct_ensemble *ensemble = pool->ensemble;
    const struct direct_ensemble_def *def = pool->def;
    size_t batch = def->enough > 0 ? DIRECT_ENSEMBLE_BATCH : def->seeds;
    pool->next = pool->fine ? 0 : 1;
    do {
        size_t seeds = ensemble->seeds + batch < def->seeds ? ensemble->seeds + batch : def->seeds;
        if (solve_seeds(pool, 1 + seeds, status) != STATUS_OK)
            return status->code;
        ensemble->seeds = seeds;
    } while (ensemble->seeds < def->seeds && !is_enough(ensemble, def));
    for (size_t k = 0; k < ensemble->seeds * ensemble->loads; k++)
        ensemble->convolutions += ensemble->seed_point[k].convolutions;
    for (size_t k = 0; pool->fine && k < ensemble->loads; k++)
        ensemble->fine_convolutions += pool->fine[k].convolutions;
    summarise(ensemble, pool->fine, def->length_m);
    return STATUS_OK;
}

enum status_code direct_ensemble_run(struct direct_ensemble *out, const struct direct_ensemble_def *def,
                                     struct status *status)
{
    assert(def->seeds > 0 && def->ladder.loads > 0);
    bool has_fine = def->fine_times > 1;
    *out = (struct direct_ensemble){.loads = def->ladder.loads, .rms_m = NAN};
    out->point = calloc(out->loads, sizeof *out->point);
    out->seed_point = calloc(def->seeds * out->loads, sizeof *out->seed_point);
    struct seed_pool pool = {.def = def, .ensemble = out, .lock = PTHREAD_MUTEX_INITIALIZER};
    pool.fine = has_fine ? calloc(out->loads, sizeof *pool.fine) : NULL;
    pool.problem = calloc(1 + def->seeds, sizeof *pool.problem);
    if (!out->point || !out->seed_point || (has_fine && !pool.fine) || !pool.problem)
        (void)status_memory(status);
    else
        (void)run(&pool, status);
    pthread_mutex_destroy(&pool.lock);
    free(pool.fine);
    free(pool.problem);
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
