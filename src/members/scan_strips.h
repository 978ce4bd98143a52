/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The strips of a surface (strip.h): pieces of its scans joined, and those of each scan alone. What they take is
 * bounded by how many there are, whatever there is of scans and of points. */
#ifndef MEMBERS_SCAN_STRIPS_H
#define MEMBERS_SCAN_STRIPS_H

#include "members/ensemble.h"

enum {
    STRIPS_PIECES = 24,         /* in one strip, at most; more rows of a surface make its answer no better */
    STRIPS_POINTS = 65536,      /* of all of them */
    STRIPS_PIECE_POINTS = 8192, /* of one that is no whole scan */
    STRIPS_PAIRINGS = 8
};

/** Owned: strips_free(). */
struct strips {
    struct strip_rows rows;      /* levelled with their scans, those of a member next to each other; rows 0: none */
    double *height_m;            /* theirs */
    uint64_t *seed;              /* and a seed of each: its member's and its place in it */
    struct solved_strip *joined; /* all rows in one strip; NULL: not solved */
    struct status problem;       /* why it is not */
    bool roughly;                /* only the scatter of the members' answers is asked: STRIP_ROUGHLY */
    bool in_part;                /* of scans, not all, or not whole */
    size_t unsolved;             /* loads at which solutions did not converge, which are left out */
    uint64_t transforms;         /* pairs of transforms times points that solving took */
};
void strips_free(struct strips *strips);

/** Takes the rows from members that keep their heights, and says in each which are of it; none where they differ in
 * points or spacing. Whole scans where they are STRIPS_PIECES with STRIPS_POINTS at most, of open ones less the points
 * that make their transforms slow; else pieces: of as many scans, evenly chosen, as a strip holds, one of each, its
 * place going evenly from the first scan's beginning to the last one's end; of fewer scans evenly spread windows of
 * each, six of one or two scans. paired: each will be, STRIPS_PAIRINGS times in all or more. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code strips_gather(struct strips *out, struct ensemble *set, bool paired, struct status *status);

/** Two rough bodies: puts heights z1(x) + z2(x + shift) in place of the rows, of a row of `other` and a shift that are
 * drawn by hash, so often that there are STRIPS_PAIRINGS rows or more; none where `other` has none. A member's rows are
 * paired with those of its partner, where it has one, else with any. Where that row ends
 * it goes on as its mirror image, or around if it is periodic; between its points it is straight. Error: STATUS_MEMORY.
 */
MUST_CHECK enum status_code strips_pair(struct strips *strips, struct ensemble *set, const struct strips *other,
                                        const struct ensemble *other_set, struct status *status);

/** Solves all rows joined. Where they have no answer there is none, and `problem` says why. Errors: STATUS_INTERRUPTED,
 * STATUS_MEMORY. */
MUST_CHECK enum status_code strips_solve(struct strips *strips, const struct threads *threads, struct status *status);
/** Solves the rows of each member alone; a member whose rows have no answer has none. Errors as strips_solve(). */
MUST_CHECK enum status_code strips_solve_members(struct strips *strips, struct ensemble *set,
                                                 const struct threads *threads, struct status *status);
#endif
