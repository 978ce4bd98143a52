/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the commands `plan` and `report` share: all surfaces are read, their effects decided, the models run, and the
 * surfaces ranked. */
#ifndef RUN_ALL_SURFACES_H
#define RUN_ALL_SURFACES_H

#include "answers/measured.h"
#include "output/tables.h"
#include "results/results.h"
#include "run/run.h"
#include <pthread.h>

/** Owned: all_surfaces_free(). Must not be copied: its parts point at each other. */
struct all_surfaces {
    struct plan plan;                   /* the effects that run */
    double *loads;                      /* P/(A_n E') */
    struct surface_record *counterface; /* NULL: smooth */
    struct measured *measured;          /* one a surface, and the scene's */
    struct words words;
    struct results results;
};

/** A stage of the work, for the display of progress by several threads. */
struct all_surfaces_stage {
    const struct run_options *options;
    const char *stage, *name; /* as run_options.progress has them */
    double done;
    pthread_mutex_t lock;
};

/** Adds `work` done on `name`, of `all`, and reports it, one thread at a time. */
void all_surfaces_tell(struct all_surfaces_stage *stage, const char *name, double work, double all);

/** Reads every surface of the scene, one per thread, and runs its models unless `describe_only`. Surfaces that cannot
 * be read are marked. If `curves` is not NULL, curves go to the files of curve_tables_open() in that directory, and
 * only those of the surfaces shown in the report stay in memory. Errors: STATUS_SCAN if the scene has no usable
 * surface; STATUS_IO, STATUS_MEMORY, STATUS_INTERRUPTED. */
MUST_CHECK enum status_code all_surfaces_run(struct all_surfaces *out, const struct scene *scene,
                                             const struct run_options *options, bool describe_only, const char *curves,
                                             struct status *status);
void all_surfaces_free(struct all_surfaces *prepared);

#endif
