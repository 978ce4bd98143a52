/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What tasks leave in their turn, whatever the number of threads, and which failure is told. */
#include "base/threads.h"
#include "support.h"

#include <pthread.h>
#include <unistd.h>

enum { TASKS = 200 };

struct log {
    size_t order[TASKS], count, begun;
    size_t fails[2]; /* TASKS: none */
    pthread_mutex_t lock;
};

static enum status_code task(void *context, size_t index, struct threads_turn *turn, struct status *status)
{
    struct log *log = context;
    pthread_mutex_lock(&log->lock);
    log->begun++;
    pthread_mutex_unlock(&log->lock);
    if (index % 5 == 0)
        usleep(2000); /* so that the others are early */
    for (int i = 0; i < 2; i++)
        if (index == log->fails[i]) {
            usleep(i == 0 ? 3000 : 0);
            return status_fail(status, STATUS_SCAN, "task %zu", index);
        }
    if (threads_wait(turn))
        log->order[log->count++] = index; /* no lock: nobody else has its turn */
    return STATUS_OK;
}

static struct log run(unsigned jobs, const size_t fails[2], enum status_code expected, const char *message)
{
    const struct threads threads = {.jobs = jobs};
    struct log log = {.fails = {fails[0], fails[1]}, .lock = PTHREAD_MUTEX_INITIALIZER};
    struct status status = {0};
    assert_int_equal(threads_run(&threads, TASKS, task, &log, &status), expected);
    assert_string_equal(status.message, message);
    for (size_t i = 0; i < log.count; i++)
        assert_int_equal(log.order[i], i);
    return log;
}

TEST_CASE(test_in_order)
{
    static const size_t none[2] = {TASKS, TASKS};
    for (unsigned jobs = 0; jobs < 100; jobs += jobs < 5 ? 1 : 31) {
        struct log log = run(jobs, none, STATUS_OK, "");
        assert_int_equal(log.count, TASKS);
        assert_int_equal(log.begun, TASKS);
    }
}

/* Task 101 fails first, 100 later: it is 100 that is told, and nothing after it was written. */
TEST_CASE(test_the_first_failure)
{
    static const size_t two[2] = {100, 101};
    for (unsigned jobs = 1; jobs < 9; jobs++) {
        struct log log = run(jobs, two, STATUS_SCAN, "task 100");
        assert_int_equal(log.count, 100);
        assert_true(log.begun <= 101 + jobs);
    }
}

TEST_CASE(test_stop)
{
    static const atomic_bool stop = true;
    const struct threads threads = {.jobs = 3, .stop = &stop};
    struct log log = {.fails = {TASKS, TASKS}, .lock = PTHREAD_MUTEX_INITIALIZER};
    expect_fails(STATUS_INTERRUPTED, "", threads_run, &threads, TASKS, task, &log);
    assert_int_equal(log.begun, 0);
}

TEST_CASE(test_nothing_to_do)
{
    const struct threads threads = {0};
    struct log log = {.fails = {TASKS, TASKS}, .lock = PTHREAD_MUTEX_INITIALIZER};
    expect_ok(threads_run, &threads, 0, task, &log);
    assert_int_equal(log.begun, 0);
    assert_true(threads_wait(NULL));
}

static enum status_code measure_stack(void *context, size_t index, struct threads_turn *turn, struct status *status)
{
    pthread_attr_t attributes;
    size_t *bytes = context;
    (void)turn, (void)status;
    usleep(20000); /* so that every thread has one of them */
    assert_int_equal(pthread_getattr_np(pthread_self(), &attributes), 0);
    assert_int_equal(pthread_attr_getstacksize(&attributes, &bytes[index]), 0);
    pthread_attr_destroy(&attributes);
    return STATUS_OK;
}

/* As under `ulimit -s 128`. */
TEST_CASE(test_stacks_do_not_hang_on_the_limit)
{
    enum { JOBS = 4 };
    size_t bytes[JOBS] = {0}, small = 0;
    pthread_attr_t before, little;
    assert_int_equal(pthread_getattr_default_np(&before), 0);
    assert_int_equal(pthread_attr_init(&little), 0);
    assert_int_equal(pthread_attr_setstacksize(&little, 128 << 10), 0);
    assert_int_equal(pthread_setattr_default_np(&little), 0);
    expect_ok(threads_run, &(struct threads){.jobs = JOBS}, JOBS, measure_stack, bytes);
    for (size_t i = 0; i < JOBS; i++)
        small += bytes[i] < THREAD_STACK_BYTES;
    assert_true(small <= 1); /* the one that calls has what it has */
    assert_int_equal(pthread_setattr_default_np(&before), 0);
    pthread_attr_destroy(&before);
    pthread_attr_destroy(&little);
}
