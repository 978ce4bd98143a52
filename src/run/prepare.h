/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What `plan` and `report` share: scans read and described, effects decided, work predicted. No model runs here. */
#ifndef RUN_PREPARE_H
#define RUN_PREPARE_H

#include "analysis/measured.h"
#include "results/results.h"
#include "run/run.h"

/** Owned: prepared_free(). Not to be moved: its parts point at each other. */
struct prepared {
    struct plan plan;
    double *loads; /* P/(A_n E') */
    struct surface_store store;
    struct surface_record *counterface; /* NULL: smooth */
    struct measured measured;
    struct results results;
};

/** Reads every surface of the scene; arrays go to a temporary file in `directory`, or nowhere when it is NULL. A
 * surface that cannot be read is marked in the store. Errors: STATUS_SCAN when the scene has no surface; STATUS_IO,
 * STATUS_MEMORY, STATUS_INTERRUPTED. */
MUST_CHECK enum status_code prepare(struct prepared *out, const struct scene *scene, const struct run_options *options,
                                    const char *directory, struct status *status);
void prepared_free(struct prepared *prepared);

/** Is surface `index` to be solved directly? */
bool prepare_solves(const struct results *results, size_t index);

/** The plan as a table for a terminal: effect, run or skipped, evaluations, seconds; the work that was done beside the
 * prediction when `done` is not NULL. */
void prepare_table(struct text *out, const struct prepared *prepared, const struct work *done);

#endif
