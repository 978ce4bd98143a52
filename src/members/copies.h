/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scans that repeat an earlier one, perhaps in another format. They are no further evidence, and count once. */
#ifndef MEMBERS_COPIES_H
#define MEMBERS_COPIES_H

#include "scan/scan.h"

enum { COPIES_HEIGHTS = 64 };

/** What is kept of a scan, to recognise a copy of it. */
struct copies_print {
    char *file;
    size_t points;                   /* of all rows */
    double spacing_m, rq_m, digit_m; /* step to which the heights are rounded; 0: none seen */
    double height_m[COPIES_HEIGHTS]; /* evenly spaced along the scan, less their mean */
};

/** The scans read so far. Owned: copies_free(). */
struct copies {
    struct copies_print *prints;
    size_t count;
};
void copies_free(struct copies *copies);

/** The file of an earlier scan with the same heights, apart from an offset and the rounding of both. NULL: none; then
 * this scan is kept as `file`. Gaps must be in the same places. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code copies_find(const char **of, struct copies *copies, const struct scan *scan,
                                        const char *file, struct status *status);

#endif
