/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What `plan` and `report` share: every surface of the scene in one pass, its effects joined, surfaces ranked. */
#ifndef RUN_PREPARE_H
#define RUN_PREPARE_H

#include "analysis/measured.h"
#include "output/tables.h"
#include "results/results.h"
#include "run/run.h"
#include <pthread.h>

/** Owned: prepared_free(). Not to be moved: its parts point at each other. */
struct prepared {
    struct plan plan;                   /* the effects that the scene allows and a surface called for */
    double *loads;                      /* P/(A_n E') */
    struct surface_record *counterface; /* NULL: smooth */
    struct measured *measured;          /* one a surface; NULL: none */
    struct results results;
    struct results_infinite infinite; /* of the tables */
};

/** A stage of the work, of which several threads tell how far they are. */
struct prepare_stage {
    const struct run_options *options;
    const char *stage, *name; /* as run_options.progress has them */
    double done;
    pthread_mutex_t lock;
};

/** Adds `work` of `all`, done to the thing `name`, and tells who asks for it, one thread at a time. */
void prepare_tell(struct prepare_stage *stage, const char *name, double work, double all);

/** Runs every surface of the scene, one a thread: describes it and, unless `describe_only`, runs its models. A surface
 * that cannot be read is marked. Curves stay in memory; where `curves` is not NULL they go to the
 * files of curve_tables_open() in that directory, and stay only of the surfaces that the report shows. Errors:
 * STATUS_SCAN when the scene has no surface; STATUS_IO, STATUS_MEMORY, STATUS_INTERRUPTED. */
MUST_CHECK enum status_code prepare(struct prepared *out, const struct scene *scene, const struct run_options *options,
                                    bool describe_only, const char *curves, struct status *status);
void prepared_free(struct prepared *prepared);

/** Is surface `index` to be solved directly? */
bool prepare_solves(const struct results *results, size_t index);

/** The plan as a table for a terminal: effect, run or skipped, why, how; with what was done and the time it took when
 * `done`. Returns the evaluations, of all effects. */
uint64_t prepare_table(struct text *out, const struct results *results, bool done);

/** Roughly how long the report will take here [s]. */
double prepare_rough_seconds(const struct results *results, const struct run_options *options);

#endif
