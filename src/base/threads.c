/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/threads.h"

#include <unistd.h>

enum { THREADS_MOST = 64 };

struct crowd;

/** One a thread: its task. */
struct threads_turn {
    struct crowd *crowd;
    size_t index;
    bool busy;
};

/** What the threads share; `lock` guards all below it. */
struct crowd {
    const struct threads *threads;
    threads_task *task;
    void *context;
    size_t count, number;
    pthread_mutex_t lock;
    pthread_cond_t ended;
    struct threads_turn turns[THREADS_MOST];
    size_t next, begun;
    size_t failed; /* the least index that failed; count: none */
    struct status status;
};

size_t threads_number(const struct threads *threads, size_t count)
{
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    size_t wanted = threads->jobs ? threads->jobs : processors > 0 ? (size_t)processors : 1;
    wanted = wanted < count ? wanted : count;
    return wanted < THREADS_MOST ? wanted : THREADS_MOST;
}

/** Begins the next task; false where there is none, one failed, or it is time to stop. */
static bool begin(struct crowd *crowd, struct threads_turn *turn)
{
    pthread_mutex_lock(&crowd->lock);
    if (crowd->threads->stop && *crowd->threads->stop && crowd->next < crowd->count &&
        crowd->status.code == STATUS_OK) {
        (void)status_fail(&crowd->status, STATUS_INTERRUPTED, "stopped");
        crowd->failed = crowd->next;
    }
    turn->busy = crowd->status.code == STATUS_OK && crowd->next < crowd->count;
    if (turn->busy)
        turn->index = crowd->next++;
    pthread_mutex_unlock(&crowd->lock);
    return turn->busy;
}

static void end(struct crowd *crowd, struct threads_turn *turn, const struct status *problem)
{
    pthread_mutex_lock(&crowd->lock);
    if (problem->code != STATUS_OK && turn->index < crowd->failed) {
        crowd->status = *problem;
        crowd->failed = turn->index;
    }
    turn->busy = false;
    pthread_cond_broadcast(&crowd->ended);
    pthread_mutex_unlock(&crowd->lock);
}

/** Is a task of a smaller index still running? Those not begun have larger ones. */
static bool is_early(const struct crowd *crowd, const struct threads_turn *turn)
{
    for (size_t i = 0; i < crowd->number; i++)
        if (crowd->turns[i].busy && crowd->turns[i].index < turn->index)
            return true;
    return false;
}

bool threads_wait(struct threads_turn *turn)
{
    if (!turn)
        return true;
    struct crowd *crowd = turn->crowd;
    pthread_mutex_lock(&crowd->lock);
    while (is_early(crowd, turn))
        pthread_cond_wait(&crowd->ended, &crowd->lock);
    bool in_vain = crowd->failed < turn->index;
    pthread_mutex_unlock(&crowd->lock);
    return !in_vain;
}

static void *run_tasks(void *context)
{
    struct crowd *crowd = context;
    pthread_mutex_lock(&crowd->lock);
    struct threads_turn *turn = &crowd->turns[crowd->begun++];
    pthread_mutex_unlock(&crowd->lock);
    turn->crowd = crowd;
    while (begin(crowd, turn)) {
        struct status problem = {0};
        (void)crowd->task(crowd->context, turn->index, turn, &problem);
        end(crowd, turn, &problem);
    }
    return NULL;
}

enum status_code threads_run(const struct threads *threads, size_t count, threads_task *task, void *context,
                             struct status *status)
{
    struct crowd crowd = {.threads = threads,
                          .task = task,
                          .context = context,
                          .count = count,
                          .number = threads_number(threads, count),
                          .lock = PTHREAD_MUTEX_INITIALIZER,
                          .ended = PTHREAD_COND_INITIALIZER,
                          .failed = count};
    pthread_t started[THREADS_MOST];
    size_t others = 0;
    while (others + 1 < crowd.number && thread_start(&started[others], run_tasks, &crowd))
        others++;
    run_tasks(&crowd);
    for (size_t i = 0; i < others; i++)
        pthread_join(started[i], NULL);
    pthread_mutex_destroy(&crowd.lock);
    pthread_cond_destroy(&crowd.ended);
    if (crowd.status.code != STATUS_OK)
        return status_fail(status, crowd.status.code, "%s", crowd.status.message);
    return STATUS_OK;
}

bool thread_start(pthread_t *out, void *(*work)(void *context), void *context)
{
    pthread_attr_t attributes;
    if (pthread_attr_init(&attributes) != 0)
        return false;
    bool started = pthread_attr_setstacksize(&attributes, THREAD_STACK_BYTES) == 0 &&
                   pthread_create(out, &attributes, work, context) == 0;
    pthread_attr_destroy(&attributes);
    return started;
}
