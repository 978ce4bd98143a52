/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The members from a surface's repeated scans: scans of one length, pieces of longer scans, rows of a map. */
#ifndef MEMBERS_REPEATS_H
#define MEMBERS_REPEATS_H

#include "members/ensemble.h"
#include "profile/profile.h"

/** How the scans of a surface differ. */
struct repeats {
    size_t count;                        /* members: 0 or at least 2 */
    size_t scans;                        /* files; 1: a map, whose rows are not independent and give no interval */
    size_t cut;                          /* pieces to which longer scans were cut; 0: all scans are equally long */
    struct estimate rq_m, gamma, psd_m3; /* the latter two with `fit: auto`, where a law was found */
};

/** Adds a file. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code repeats_add_scan(struct ensemble *set, struct status *status);

/** Adds row `row` of `rows` of the last file as a member, `own`, which is taken over. Of more than STRIPS_PIECES rows
 * only that many, evenly spaced, become members. Takes the profile's heights if it is a single row. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code repeats_add(struct ensemble *set, size_t row, size_t rows, struct profile *profile,
                                        struct member *own, struct status *status);

/** Cuts longer scans to pieces as long as the shortest; *cut: the number of members then, 0 where none is longer.
 * Error: STATUS_MEMORY. */
MUST_CHECK enum status_code repeats_cut_to_shortest(struct ensemble *set, size_t *cut, const struct scene *scene,
                                                    struct status *status);

/** Brings the members' spectra to the wavelengths of their mean, `mean`, and finds the scatter of Rq. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code repeats_compare(struct repeats *out, struct ensemble *set, const struct spectrum *mean,
                                            struct status *status);

#endif
