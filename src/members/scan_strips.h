/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The strips of a surface (strip.h): pieces of all its scans joined, and pieces of each scan alone. The number of
 * pieces is limited, so that time and memory do not grow with the scans. */
#ifndef MEMBERS_SCAN_STRIPS_H
#define MEMBERS_SCAN_STRIPS_H

#include "members/ensemble.h"

enum {
    STRIPS_PIECES = 24,         /* at most, in one strip; more rows do not improve the answer */
    STRIPS_POINTS = 65536,      /* at most, of all pieces together */
    STRIPS_PIECE_POINTS = 8192, /* of a piece that is not a whole scan */
    STRIPS_PAIRINGS = 8
};

/** Owned: strips_free(). */
struct strips {
    struct strip_rows rows;         /* levelled with their scans; a member's rows are adjacent; rows 0: none */
    double *height_m;               /* of the rows */
    uint64_t *seed;                 /* of each row, from its member and its place there */
    struct solved_strip *joined;    /* all rows in one strip; NULL: not solved */
    struct prepared_strip prepared; /* that one for its surface */
    struct status problem;          /* why not */
    bool roughly;                   /* only the members' scatter is needed: STRIP_ROUGHLY */
    size_t unsolved;                /* loads left out because no solution converged */
    uint64_t transforms;            /* cost of solving: pairs of transforms times points */
};
void strips_free(struct strips *strips);

/** Takes the rows from members that keep their heights, and notes in each member which are its own. No rows where
 * members differ in points or spacing. At most STRIPS_PIECES scans of STRIPS_POINTS together are taken whole (open ones
 * without the last points, if their transforms are slow otherwise). Of more, pieces are taken: one of each of as many
 * evenly chosen scans as a strip holds, from the beginning of the first to the end of the last; of few scans several
 * evenly spaced windows each, six in all of one or two scans. paired: every row will be paired with another body's, at
 * least STRIPS_PAIRINGS pairs in all. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code strips_gather(struct strips *out, struct ensemble *set, bool paired, struct status *status);

/** Two rough bodies: replaces the rows by z1(x) + z2(x + shift), with a row of `other` and a shift drawn by hash, at
 * least STRIPS_PAIRINGS of them; no rows where `other` has none. A member's rows are paired with its partner's, if it
 * has one, else with any. Beyond its end the other row goes on around if it is periodic, else as its mirror image;
 * between its points it is interpolated linearly. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code strips_pair(struct strips *strips, struct ensemble *set, const struct strips *other,
                                        const struct ensemble *other_set, struct status *status);

/** Solves all rows joined. Without a solution `joined` is NULL and `problem` says why. Errors: STATUS_INTERRUPTED,
 * STATUS_MEMORY. */
MUST_CHECK enum status_code strips_solve(struct strips *strips, const struct threads *threads, struct status *status);
/** Solves the rows of each member alone; member.strip stays NULL without a solution. Errors as strips_solve(). */
MUST_CHECK enum status_code strips_solve_members(struct strips *strips, struct ensemble *set,
                                                 const struct threads *threads, struct status *status);
#endif
