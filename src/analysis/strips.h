/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The strips of a surface (strip.h): all of its rows joined, and each scan alone. */
#ifndef ANALYSIS_STRIPS_H
#define ANALYSIS_STRIPS_H

#include "analysis/ensemble.h"

enum { STRIPS_PAIRINGS = 8 };

/** Owned: strips_free(). */
struct strips {
    struct strip_rows rows; /* levelled; of a map at most 8 whole ones, evenly spaced; rows 0: none */
    size_t pairings;      /* rows next to each other that are one scan's, each against another place of the counterface;
                             1: it is smooth */
    double *height_m;     /* theirs */
    struct strip *joined; /* all rows in one strip; NULL: not solved */
    struct status problem;  /* why it is not */
    struct bearing bearing; /* where it is */
    uint64_t transforms;    /* pairs of transforms times points that solving took */
};
void strips_free(struct strips *strips);

/** Takes the rows from members that keep their heights; none where they differ in points or spacing. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code strips_gather(struct strips *out, const struct ensemble *set, struct status *status);

/** Two rough bodies: puts heights z1(x) + z2(x + shift) in place of the rows, of a row of `other` and a shift that are
 * drawn by hash, so often that there are STRIPS_PAIRINGS rows or more; none where `other` has none. Where that row ends
 * it goes on as its mirror image, or around if it is periodic; between its points it is straight. Error: STATUS_MEMORY.
 */
MUST_CHECK enum status_code strips_pair(struct strips *strips, const struct strips *other, struct status *status);

/** What strips_solve() takes at least (with one surrogate) and at most, by a count: pairs of transforms times points.
 */
uint64_t strips_cost(const struct strips *strips, size_t surrogates);

/** The count that a whole report spends at most on strips: about a minute of one core. */
extern const double strips_budget;
/** Surrogates for a surface: STRIP_SURROGATES where the scene names its models, else as many as its share of the budget
 * allows; 0: not even one, and no strip is solved. */
size_t strips_surrogates(const struct strips *strips, const struct scene *scene);

/** Solves the joined rows, and of several scans every member's own. A surface whose strip has no answer has none.
 * Errors: STATUS_INTERRUPTED, STATUS_MEMORY. */
MUST_CHECK enum status_code strips_solve(struct strips *strips, struct ensemble *set, size_t surrogates,
                                         const atomic_bool *stop, struct status *status);
#endif
