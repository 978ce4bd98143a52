/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The ensemble of a surface's repeated scans: scans of one length, subrecords of longer ones, rows of a map. */
#ifndef MEMBERS_REPEATS_H
#define MEMBERS_REPEATS_H

#include "members/ensemble.h"
#include "profile/profile.h"

/** What the scans of a surface say apart. */
struct repeats {
    size_t count; /* members: 0 or at least 2 */
    size_t scans; /* files; 1: a map, whose rows they are: these are not independent, and tell no interval */
    size_t cut;   /* subrecords that scans longer than the shortest were cut to; 0: all of one length */
    struct estimate rq_m, gamma, psd_m3; /* the latter two by `fit: auto`, where there is a law */
};

/** Adds a file, of which nothing is known yet. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code repeats_add_scan(struct ensemble *set, const char *file, struct status *status);

/** Adds a profile of the last file: row `row` of `rows`. STRIPS_PIECES of them, evenly spaced, are members. Takes over
 * what `own` has of it, and the heights of a scan of one row. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code repeats_add(struct ensemble *set, size_t row, size_t rows, struct profile *profile,
                                        struct member *own, struct status *status);

/** Cuts scans of unlike lengths to subrecords as long as the shortest; *cut: how many members they are, 0 where none is
 * longer. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code repeats_cut_to_shortest(struct ensemble *set, size_t *cut, const struct scene *scene,
                                                    struct status *status);

/** Puts the members on the grid of `mean`, their mean spectrum, and lets them say how far they differ. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code repeats_compare(struct repeats *out, struct ensemble *set, const struct spectrum *mean,
                                            struct status *status);

#endif
