/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/workers.h"

#include "analysis/direct_study.h"
#include "analysis/effect_bounds.h"
#include "base/clock.h"
#include "base/threads.h"

#include <pthread.h>
#include <stdint.h>
#include <stdlib.h>

/** A task on one surface; `record` is zeroed, and freed afterwards. */
typedef enum status_code task_function(struct surface_record *record, const struct results *results, size_t index,
                                       const struct threads *threads, struct status *status);

/** `lock` guards `done`. */
struct share {
    const struct results *results;
    const struct run_options *options;
    task_function *task;
    size_t count, done;
    struct threads inside; /* of each surface, where there are more threads than surfaces */
    pthread_mutex_t lock;
};

/** A described surface, of which something is left to do. */
struct closing {
    struct surface_record *record;
    const struct results *results;
    size_t index;
};

enum { CLOSING_BOUNDS, CLOSING_ARRAYS, CLOSINGS };
enum { SHARED_POINTS = 1 << 16 }; /* with fewer, threads take longer to start than they save */

/** Plans the models, which adds to the summary alone, or stores the arrays, which takes about as long. */
static enum status_code close_one(void *context, size_t part, struct threads_turn *turn, struct status *status)
{
    struct closing *closing = context;
    struct surface_record *record = closing->record;
    const struct results *results = closing->results;
    const double *loads = results_loads(results, closing->index);
    (void)turn;
    if (!record->summary.usable)
        return STATUS_OK;
    if (part == CLOSING_ARRAYS)
        return surface_store_put_arrays(results->store, closing->index, record, status);
    enum status_code rc =
        effect_bounds_surface(record, results->scene, results->plan, loads, results->load_count, status);
    return rc == STATUS_OK && plan_runs(results->plan, EFFECT_DIRECT)
               ? direct_study_plan(record, results->scene, results->plan, loads, results->load_count, status)
               : rc;
}

static enum status_code describe(struct surface_record *record, const struct results *results, size_t index,
                                 const struct threads *threads, struct status *status)
{
    const struct scene *scene = results->scene;
    double started = clock_seconds();
    if (surface_describe(record, scene, &scene->surfaces[index], results->counterface, threads, status) != STATUS_OK) {
        surface_record_free(record, true);
        return status->code;
    }
    spectrum_free(&record->tapered); /* asked for again of a counterface alone */
    struct closing closing = {record, results, index};
    bool large = record->summary.points >= SHARED_POINTS;
    enum status_code rc = threads_run(large ? threads : NULL, CLOSINGS, close_one, &closing, status);
    record->summary.times.described = clock_seconds() - started;
    if (rc == STATUS_OK)
        rc = surface_store_update(results->store, index, record, status);
    if (rc != STATUS_OK)
        surface_record_free(record, true);
    return rc;
}

static enum status_code run_models(struct surface_record *record, const struct results *results, size_t index,
                                   const struct threads *threads, struct status *status)
{
    if (!results->store->summaries[index].usable)
        return STATUS_OK;
    if (surface_store_get(record, results->store, index, status) != STATUS_OK)
        return status->code;
    enum status_code rc = surface_run_models(record, results->scene, results->plan, results_loads(results, index),
                                             results->load_count, threads, status);
    results->store->summaries[index] = record->summary; /* its texts may have been made anew */
    if (rc != STATUS_OK)
        return rc;
    if (!results->measured || index != results->baseline) /* else no later stage asks for them */
        surface_drop_scans(record);
    return surface_store_update(results->store, index, record, status);
}

static enum status_code run_task(void *context, size_t index, struct threads_turn *unused, struct status *status)
{
    struct share *share = context;
    struct surface_record *record = calloc(1, sizeof *record);
    (void)unused;
    if (!record)
        return status_memory(status);
    enum status_code rc = share->task(record, share->results, index, &share->inside, status);
    surface_record_free(record, false);
    free(record);
    if (share->options->progress) {
        pthread_mutex_lock(&share->lock);
        share->options->progress(++share->done, share->count, share->results->scene->surfaces[index].name);
        pthread_mutex_unlock(&share->lock);
    }
    return rc;
}

enum status_code workers_run(const struct results *results, enum workers_task task, const struct run_options *options,
                             struct status *status)
{
    static task_function *const tasks[WORKERS_TASKS] = {[WORKERS_DESCRIBE] = describe, [WORKERS_MODEL] = run_models};
    const struct threads threads = {.jobs = options->jobs, .stop = options->stop};
    struct share share = {.results = results,
                          .options = options,
                          .task = tasks[task],
                          .count = results->store->count,
                          .lock = PTHREAD_MUTEX_INITIALIZER};
    size_t outside = threads_number(&threads, share.count);
    share.inside.jobs = outside > 0 ? (unsigned)(threads_number(&threads, SIZE_MAX) / outside) : 1;
    enum status_code rc = threads_run(&threads, share.count, run_task, &share, status);
    pthread_mutex_destroy(&share.lock);
    return rc;
}
