/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs one task a surface on several threads; results do not depend on how many. */
#ifndef RUN_WORKERS_H
#define RUN_WORKERS_H

#include "results/results.h"
#include "run/run.h"

/** What is done with each surface, and what is to stay of it goes into results->store. */
enum workers_task {
    WORKERS_DESCRIBE, /* reads and describes it, with its bounds */
    WORKERS_MODEL,    /* runs the plan's models on it; nothing on a refused one */
    WORKERS_TASKS
};

/** Other processes that take a share of the surfaces. They read the scene themselves, so they have to see the same
 * files under the same names. */
struct workers_crew {
    /** Does `task` for every surface, each process for its share, and leaves what comes of it in this one's store. */
    enum status_code (*run)(const struct workers_crew *crew, const struct results *results, enum workers_task task,
                            const struct run_options *options, struct status *status);
};

/** Does `task` for every surface, with the crew of `options` if there is one. Errors: those of the task;
 * STATUS_INTERRUPTED when options->stop was set. */
MUST_CHECK enum status_code workers_run(const struct results *results, enum workers_task task,
                                        const struct run_options *options, struct status *status);
/** The same in this process alone, for the surfaces first, first + step, ... */
MUST_CHECK enum status_code workers_share(const struct results *results, enum workers_task task, size_t first,
                                          size_t step, const struct run_options *options, struct status *status);

#endif
