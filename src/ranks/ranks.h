/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The program over MPI's ranks. The first rank runs it; the others wait for surfaces to describe, to run the models on
 * and to solve. */
#ifndef RANKS_H
#define RANKS_H

#include "direct/direct_crew.h"
#include "run/workers.h"
#include <stdatomic.h>
#include <stdbool.h>

struct ranks_options {
    size_t ranks_per_grid; /* that share one surface of an ensemble; 0: as many as there are ranks for a surface */
};

/** Starts MPI. Before anything else in main(). */
void ranks_begin(int *argc, char ***argv);
bool ranks_is_first(void);
/** Of the first rank: the others as a crew; NULL: there are none. */
const struct direct_crew *ranks_crew(const struct ranks_options *options);
/** The same for the surfaces of a report. */
const struct workers_crew *ranks_workers(void);
/** Of the others: does what the first rank asks for until that calls ranks_end(). *stop ends what is being done. */
void ranks_serve(const atomic_bool *stop);
/** Of the first rank: lets the others go, and ends MPI on all. May be registered with atexit(). */
void ranks_end(void);

#endif
