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

/** Does `task` for every surface. Errors: those of the task; STATUS_INTERRUPTED when options->stop was set. */
MUST_CHECK enum status_code workers_run(const struct results *results, enum workers_task task,
                                        const struct run_options *options, struct status *status);

#endif
