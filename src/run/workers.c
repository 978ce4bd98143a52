#include "run/workers.h"

#include "analysis/direct_study.h"
#include "analysis/effect_bounds.h"
#include "base/thread.h"
#include "base/threads.h"

#include <stdlib.h>
#include <unistd.h>

enum { WORKERS_MOST = 64 };

/** A task on one surface; `record` is zeroed, and freed afterwards. */
typedef enum status_code task_function(struct surface_record *record, const struct results *results, size_t index,
                                       const struct threads *threads, struct status *status);

/** What the threads share; `lock` guards next, done and status. */
struct pool {
    const struct results *results;
    const struct run_options *options;
    task_function *task;
    struct threads inside; /* of each surface, where there are more threads than surfaces */
    pthread_mutex_t lock;
    size_t next, step, done, count; /* the latter two of surfaces done, and to be done */
    struct status status;
};

/** The next surface to do; false when there is none, one failed, or the run is to stop. */
static bool take(struct pool *pool, size_t *index)
{
    pthread_mutex_lock(&pool->lock);
    if (pool->options->stop && *pool->options->stop)
        (void)status_fail(&pool->status, STATUS_INTERRUPTED, "stopped");
    bool more = pool->status.code == STATUS_OK && pool->next < pool->results->store->count;
    if (more) {
        *index = pool->next;
        pool->next += pool->step;
    }
    pthread_mutex_unlock(&pool->lock);
    return more;
}

static void finish(struct pool *pool, size_t index, const struct status *problem)
{
    const struct scene *scene = pool->results->scene;
    pthread_mutex_lock(&pool->lock);
    if (problem->code != STATUS_OK)
        (void)status_fail(&pool->status, problem->code, "%s", problem->message);
    pool->done++;
    if (pool->options->progress)
        pool->options->progress(pool->done, pool->count, scene->surfaces[index].name);
    pthread_mutex_unlock(&pool->lock);
}

static enum status_code describe(struct surface_record *record, const struct results *results, size_t index,
                                 const struct threads *threads, struct status *status)
{
    const struct scene *scene = results->scene;
    if (surface_describe(record, scene, &scene->surfaces[index], results->counterface, threads, status) != STATUS_OK) {
        surface_record_free(record, true);
        return status->code;
    }
    enum status_code rc = STATUS_OK;
    if (record->summary.usable)
        rc = effect_bounds_surface(record, scene, results->plan, results_loads(results, index), results->load_count,
                                   status);
    if (rc == STATUS_OK && record->summary.usable && plan_runs(results->plan, EFFECT_DIRECT))
        rc =
            direct_study_plan(record, scene, results->plan, results_loads(results, index), results->load_count, status);
    if (rc == STATUS_OK)
        rc = surface_store_put(results->store, index, record, status);
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
    return surface_store_put(results->store, index, record, status);
}

static void *run_tasks(void *context)
{
    struct pool *pool = context;
    struct surface_record *record = malloc(sizeof *record);
    for (size_t index; record && take(pool, &index);) {
        struct status problem = {0};
        *record = (struct surface_record){0};
        (void)pool->task(record, pool->results, index, &pool->inside, &problem);
        surface_record_free(record, false);
        finish(pool, index, &problem);
    }
    free(record);
    return record ? NULL : context;
}

enum status_code workers_share(const struct results *results, enum workers_task task, size_t first, size_t step,
                               const struct run_options *options, struct status *status)
{
    static task_function *const tasks[WORKERS_TASKS] = {[WORKERS_DESCRIBE] = describe, [WORKERS_MODEL] = run_models};
    size_t all = results->store->count;
    struct pool pool = {.results = results,
                        .options = options,
                        .task = tasks[task],
                        .lock = PTHREAD_MUTEX_INITIALIZER,
                        .next = first,
                        .step = step,
                        .count = first < all ? (all - first + step - 1) / step : 0};
    pthread_t threads[WORKERS_MOST];
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    size_t asked = options->jobs ? options->jobs : processors > 0 ? (size_t)processors : 1, wanted = asked, started = 0;
    if (wanted > pool.count)
        wanted = pool.count;
    if (wanted > WORKERS_MOST)
        wanted = WORKERS_MOST;
    pool.inside.jobs = asked > wanted && wanted > 0 ? (unsigned)(asked / wanted) : 1;
    while (started + 1 < wanted && thread_start(&threads[started], run_tasks, &pool))
        started++;
    if (run_tasks(&pool))
        (void)status_fail(&pool.status, STATUS_MEMORY, "out of memory");
    for (size_t i = 0; i < started; i++)
        pthread_join(threads[i], NULL);
    pthread_mutex_destroy(&pool.lock);
    if (pool.status.code != STATUS_OK)
        return status_fail(status, pool.status.code, "%s", pool.status.message);
    return STATUS_OK;
}

enum status_code workers_run(const struct results *results, enum workers_task task, const struct run_options *options,
                             struct status *status)
{
    const struct workers_crew *crew = options->workers;
    return crew ? crew->run(crew, results, task, options, status) : workers_share(results, task, 0, 1, options, status);
}
