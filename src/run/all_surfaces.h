/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What `plan` and `report` share: every surface of the scene in one pass, its effects joined, surfaces ranked. */
#ifndef RUN_ALL_SURFACES_H
#define RUN_ALL_SURFACES_H

#include "answers/measured.h"
#include "output/tables.h"
#include "results/results.h"
#include "run/run.h"
#include <pthread.h>

/** Owned: all_surfaces_free(). Not to be moved: its parts point at each other. */
struct all_surfaces {
    struct plan plan;                   /* the effects that the scene allows and a surface called for */
    double *loads;                      /* P/(A_n E') */
    struct surface_record *counterface; /* NULL: smooth */
    struct measured *measured;          /* one a surface; NULL: none */
    struct words words;
    struct results results;
    struct results_infinite infinite; /* of the tables */
};

/** A stage of the work, of which several threads tell how far they are. */
struct all_surfaces_stage {
    const struct run_options *options;
    const char *stage, *name; /* as run_options.progress has them */
    double done;
    pthread_mutex_t lock;
};

/** Adds `work` of `all`, done to the thing `name`, and tells who asks for it, one thread at a time. */
void all_surfaces_tell(struct all_surfaces_stage *stage, const char *name, double work, double all);

/** Runs every surface of the scene, one a thread: describes it and, unless `describe_only`, runs its models. A surface
 * that cannot be read is marked. Curves stay in memory; where `curves` is not NULL they go to the
 * files of curve_tables_open() in that directory, and stay only of the surfaces that the report shows. Errors:
 * STATUS_SCAN when the scene has no surface; STATUS_IO, STATUS_MEMORY, STATUS_INTERRUPTED. */
MUST_CHECK enum status_code all_surfaces_run(struct all_surfaces *out, const struct scene *scene,
                                             const struct run_options *options, bool describe_only, const char *curves,
                                             struct status *status);
void all_surfaces_free(struct all_surfaces *prepared);

#endif
