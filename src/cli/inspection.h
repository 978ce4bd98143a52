/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What `inspect` finds in a file. */
#ifndef CLI_INSPECTION_H
#define CLI_INSPECTION_H

#include "profile/profile.h"
#include "spectrum/areal.h"
#include "spectrum/parameters.h"

#include <jansson.h>

/** Figures of a profile, over its least-squares line (or as `options` says); of uneven points without a filter at the
 * measured points, not the interpolated ones. Of a map, its heights over the plane and its rows as profiles. */
struct inspection {
    struct scan scan;
    struct profile profile; /* of a map its middle row, for a chart, if it is usable */
    struct areal areal;
    struct roughness roughness;
    double sigma_m, mean_slope;          /* to paste; of a map as a report would low-pass it */
    struct power_law power_law;          /* of the band found */
    size_t points;                       /* that the numbers are of: without ends that were left out */
    double spacing_m, length_m;          /* along x; from first to last point */
    struct parameters primary, filtered; /* P; R where lambda_c is given */
    bool has_filtered;
    struct profile_options options;
};

/** Inspects a file's bytes; "-" is standard input, without sidecars. Free with inspection_free() in any case. Errors:
 * those of the stages. */
MUST_CHECK enum status_code inspection_make(struct inspection *out, const struct scan_bytes *file,
                                            const struct scan_options *units, const struct profile_options *options,
                                            struct status *status);
void inspection_free(struct inspection *inspection);

/** The figures as a new object. */
json_t *inspection_json(const char *path, const struct inspection *inspection);
/** The same with its numbers as texts, for templates/inspect.txt. */
json_t *inspection_view(const char *path, const struct inspection *inspection);

#endif
