/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surfaces over MPI's ranks: every rank reads the scene, and does a task for each so many-th of its surfaces. */
#ifndef RANKS_SURFACES_H
#define RANKS_SURFACES_H

#include "direct/direct_team.h"
#include "run/workers.h"
#include <mpi.h>

enum { RANKS_SOURCE_TEXTS = 5 };

/** What the others need to know of a task; the texts that say where the scene is follow it. */
struct ranks_task {
    enum workers_task task;
    size_t surfaces;                   /* of the scene */
    size_t kept;                       /* the surface whose scans a later stage asks for; `surfaces`: none */
    unsigned jobs;                     /* threads of a rank */
    size_t length[RANKS_SOURCE_TEXTS]; /* of directory, material, effects, x_unit, z_unit, with the NUL; 0: not given */
    double tolerance;                  /* scene_overrides.tolerance */
    bool direct;                       /* scene_overrides.direct */
    struct plan plan;
};

/** The scene as this process has read it, between one task and the next. Zero-initialise; ranks_surfaces_free(). */
struct ranks_surfaces {
    char *texts;
    struct scene scene;
    struct prepared *prepared;
};
void ranks_surfaces_free(struct ranks_surfaces *surfaces);

/** Of the first rank: what it tells the others of a task. */
struct ranks_task ranks_surfaces_task(const struct results *results, enum workers_task task,
                                      const struct run_options *options);

/** Of the first rank, when the others know the task: has it done for all surfaces, and puts what comes of it into the
 * store. The surface i is the rank's i modulo the number of ranks, so that it does not matter how long each takes.
 * Errors: the first of any rank. */
MUST_CHECK enum status_code ranks_surfaces_lead(const struct direct_team *team, MPI_Comm communicator,
                                                const struct ranks_task *task, const struct results *results,
                                                const struct run_options *options, struct status *status);

/** Of the others: their share of it. */
void ranks_surfaces_follow(struct ranks_surfaces *surfaces, const struct direct_team *team, MPI_Comm communicator,
                           const struct ranks_task *task, const atomic_bool *stop);

#endif
