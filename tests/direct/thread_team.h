/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A team (direct_team.h) of threads: what ranks do, without any of MPI. */
#ifndef THREAD_TEAM_H
#define THREAD_TEAM_H

#include "direct/direct_team.h"

/** Runs `work` in `size` threads, each with its own rank of one team, to their end. */
void thread_team_run(size_t size, void (*work)(const struct direct_team *team, void *context), void *context);

#endif
