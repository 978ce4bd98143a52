/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The program over MPI's ranks: the first one runs it, and calls the others to each contact that is solved directly. */
#ifndef RANKS_H
#define RANKS_H

#include "direct/direct_team.h"
#include <stdatomic.h>

/** Starts MPI; before anything else in main(). Returns all ranks as a team; NULL: there is only one. */
const struct direct_team *ranks_begin(int *argc, char ***argv);
/** Were all ranks started with the same words? Collective. */
bool ranks_agree(int argc, char **argv);
/** Of all but the first: solves what that calls for until it calls ranks_end(). *stop (NULL: never) ends a solution. */
void ranks_serve(const atomic_bool *stop);
/** Of the first rank: lets the others go, and ends MPI on all. May be registered with atexit(). */
void ranks_end(void);

#endif
