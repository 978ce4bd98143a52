/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A team (direct_team.h) of MPI's ranks. */
#ifndef RANKS_TEAM_H
#define RANKS_TEAM_H

#include "direct/direct_team.h"
#include <mpi.h>

/** A team of all ranks of `communicator`, which has to outlive it. Owned: ranks_team_free(). Error: STATUS_MEMORY, the
 * same on all ranks. */
MUST_CHECK enum status_code ranks_team_make(struct direct_team *out, MPI_Comm *communicator, struct status *status);
void ranks_team_free(struct direct_team *team);

/** Wait without keeping a processor busy, which another process may have use for: for a request, for all ranks. */
void ranks_wait(MPI_Request *request);
void ranks_wait_for_all(MPI_Comm communicator);

/** Any number of bytes from the rank `root` to all, or from one rank to another. */
void ranks_spread(void *data, size_t bytes, int root, MPI_Comm communicator);
void ranks_send(const void *data, size_t bytes, int to, MPI_Comm communicator);
void ranks_receive(void *data, size_t bytes, int from, MPI_Comm communicator);

#endif
