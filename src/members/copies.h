/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scans that hold the same heights as one before, perhaps in another format: they are no evidence of their own. */
#ifndef MEMBERS_COPIES_H
#define MEMBERS_COPIES_H

#include "scan/scan.h"

enum { COPIES_HEIGHTS = 64 };

/** What is kept of a scan to know it again. */
struct copies_print {
    const char *file;                /* the scene's */
    size_t points;                   /* of all rows */
    double spacing_m, rq_m, digit_m; /* step that the heights are rounded to; 0: none seen */
    double height_m[COPIES_HEIGHTS]; /* spread evenly, over their mean */
};

/** Those of the scans so far. Owned: copies_free(). */
struct copies {
    struct copies_print *prints;
    size_t count;
};
void copies_free(struct copies *copies);

/** The file of a scan so far whose heights are these but for an offset and the rounding of both; NULL: there is none,
 * and it is kept as `file`. A gap is no height. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code copies_find(const char **of, struct copies *copies, const struct scan *scan,
                                        const char *file, struct status *status);

#endif
