/* Evaluates the surfaces of a scene on several threads; the results do not depend on how many. */
#ifndef RUN_WORKERS_H
#define RUN_WORKERS_H

#include "results/tables.h"
#include "run/run.h"

/** Evaluates every surface into results->spool. Errors: those of surface_evaluate() and spool_put();
 * STATUS_INTERRUPTED when options->stop was set. */
MUST_CHECK enum status_code workers_evaluate(const struct results *results, const struct run_options *options,
                                             struct status *status);

#endif
