/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tasks on several threads; the results do not depend on how many threads there are. */
#ifndef BASE_THREADS_H
#define BASE_THREADS_H

#include "base/status.h"

#include <pthread.h>
#include <stddef.h>

/** How many threads, and what ends them. */
struct threads {
    unsigned jobs;           /* 0: one a processor */
    const atomic_bool *stop; /* becomes true when the work is to end early; NULL: never */
};

/** The place of a task in the order of tasks. */
struct threads_turn;

/** What is done to thing `index`, on any thread. */
typedef enum status_code threads_task(void *context, size_t index, struct threads_turn *turn, struct status *status);

/** Does `task` for 0 ... count-1, begun in this order. Errors: that of the failed task of least index, after which none
 * is begun; STATUS_INTERRUPTED when told to stop. */
MUST_CHECK enum status_code threads_run(const struct threads *threads, size_t count, threads_task *task, void *context,
                                        struct status *status);

/** Waits until the tasks of all smaller indices have ended, so that changes to shared data from here on are in order.
 * False: one of them failed, so this result is not needed. NULL, of a task that runs alone: always true. */
bool threads_wait(struct threads_turn *turn);

/** How many threads run `count` tasks. */
size_t threads_number(const struct threads *threads, size_t count);

/** Bytes of stack of each thread, whatever `ulimit -s` says: Debian's default. Unused pages take no memory. */
enum { THREAD_STACK_BYTES = 8 << 20 };

/** Starts work(context) on a thread of its own, to be joined by pthread_join(). False: there can be no other thread. */
bool thread_start(pthread_t *out, void *(*work)(void *context), void *context);

#endif
