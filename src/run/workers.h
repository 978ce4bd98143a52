/* Runs one task a surface on several threads; results do not depend on how many. */
#ifndef RUN_WORKERS_H
#define RUN_WORKERS_H

#include "results/results.h"
#include "run/run.h"

/** What is done with each surface: `record` is zeroed, and freed afterwards; what is to stay goes into results->store.
 */
typedef enum status_code workers_task(struct surface_record *record, const struct results *results, size_t index,
                                      struct status *status);

/** Reads and describes surface `index`, with its bounds, and stores it. */
workers_task workers_describe;
/** Runs the plan's models on surface `index` and stores it again; does nothing for a refused one. */
workers_task workers_model;

/** Does `task` for every surface. Errors: those of the task; STATUS_INTERRUPTED when options->stop was set. */
MUST_CHECK enum status_code workers_run(const struct results *results, workers_task *task,
                                        const struct run_options *options, struct status *status);

#endif
