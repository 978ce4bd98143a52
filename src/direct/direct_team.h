/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Processes that share one grid, each a slab of its rows; what they have to say to each other.
 *
 * A team of NULL is a single process that holds the whole grid: every function here then leaves its argument as it is.
 * All others are collective: every rank of the team calls them in the same order, and all get the same bits. This file
 * knows no way of sending anything; src/ranks fills the calls in.
 */
#ifndef DIRECT_TEAM_H
#define DIRECT_TEAM_H

#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>

struct direct_team {
    size_t rank, size;
    double *scratch; /* DIRECT_TEAM_VALUES a rank */
    void *context;   /* of the calls */
    /** `bytes` of every rank, in the order of ranks, to all. */
    void (*gather)(const struct direct_team *team, void *all, const void *mine, size_t bytes);
    /** Sends `out` to the rank `to` and takes `in` from the rank `from`; team->size: nothing. */
    void (*exchange)(const struct direct_team *team, size_t to, const void *out, size_t from, void *in, size_t bytes);
    /** Prepares the transposition of ny x nx pairs of values, by slabs, from `rows` to `columns` and back; NULL: no
     * memory. Each place has room for the larger of both slabs. */
    void *(*transposition_make)(const struct direct_team *team, size_t ny, size_t nx, double *rows, double *columns);
    void (*transpose)(void *transposition, bool back);
    void (*transposition_free)(void *transposition);
};

enum { DIRECT_TEAM_VALUES = 4 }; /* most values of one sum */

/** Rows of `rank` out of n, the first of them in *first: ceil(n/size) for each as long as there are any. */
size_t direct_team_slab(size_t n, size_t size, size_t rank, size_t *first);

/** Replaces values by their sums (largest) over the ranks; sums are made in the order of ranks. */
void direct_team_add(const struct direct_team *team, double *values, size_t count);
void direct_team_most(const struct direct_team *team, double *values, size_t count);
double direct_team_sum(const struct direct_team *team, double value);
/** Is it so on any rank? */
bool direct_team_any(const struct direct_team *team, bool value);
/** Makes the error of the first rank that has one everybody's. */
enum status_code direct_team_agree(const struct direct_team *team, struct status *status);

#endif
