/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Processes that share one grid, each a slab of its rows; what they have to say to each other.
 *
 * A team of NULL is a single process that holds the whole grid: every function here then leaves its argument as it is.
 * With a team all is collective: every rank calls it in the same order, and all get the same bits. What is not a slab
 * (the heights given, where the bodies touch) only the first rank has. This file knows no way of sending anything;
 * src/ranks fills the calls in.
 */
#ifndef DIRECT_TEAM_H
#define DIRECT_TEAM_H

#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>

struct direct_ladder_def; /* direct_ladder.h */

struct direct_team {
    size_t rank, size;
    struct status *scratch; /* one a rank: room for what all of them say */
    void *context;          /* of the calls */
    /** Of the first rank alone: has the others call direct_ladder_of_heights() with the same grid and loads. */
    void (*call)(const struct direct_team *team, size_t n, double spacing_m, const struct direct_ladder_def *def);
    /** `bytes` of the first rank to all. */
    void (*spread)(const struct direct_team *team, void *data, size_t bytes);
    /** `bytes` of every rank, in the order of ranks, to all. */
    void (*gather)(const struct direct_team *team, void *all, const void *mine, size_t bytes);
    /** Prepares the transposition of ny x nx pairs of values by slabs; NULL: no memory. Both places have room for the
     * larger of both slabs, and what was in `from` is lost. */
    void *(*transposition_make)(const struct direct_team *team, size_t ny, size_t nx, double *from, double *to);
    void (*transpose)(void *transposition);
    void (*transposition_free)(void *transposition); /* which may be NULL */
};

/** Rows of `rank` out of n, the first of them in *first: ceil(n/size) for each as long as there are any. */
size_t direct_team_slab(size_t n, size_t size, size_t rank, size_t *first);

/** Replaces a few values by their sums (largest) over the ranks; sums are made in the order of ranks. */
void direct_team_add(const struct direct_team *team, double *values, size_t count);
void direct_team_most(const struct direct_team *team, double *values, size_t count);
double direct_team_sum(const struct direct_team *team, double value);
/** Is it so on any rank? */
bool direct_team_any(const struct direct_team *team, bool value);
/** Makes the error of the first rank that has one everybody's. */
enum status_code direct_team_agree(const struct direct_team *team, struct status *status);

#endif
