/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Processes that solve surfaces for the one that asks them. NULL everywhere stands for none but the caller. */
#ifndef DIRECT_CREW_H
#define DIRECT_CREW_H

#include "base/status.h"
#include <stddef.h>
#include <stdint.h>

struct direct_ensemble_def;
struct direct_ladder_def;
struct direct_point;

struct direct_crew {
    void *context; /* of the calls */
    /** Solves `count` of an ensemble's surfaces from the `first` on, on its coarse grid: count x loads points, and Sq
     * of the first one. */
    enum status_code (*surfaces)(const struct direct_crew *crew, struct direct_point *out, double *rms_m,
                                 const struct direct_ensemble_def *def, size_t first, size_t count,
                                 struct status *status);
    /** The first surface on the fine grid: loads points. */
    enum status_code (*fine)(const struct direct_crew *crew, struct direct_point *out,
                             const struct direct_ensemble_def *def, struct status *status);
    /** direct_ladder_of_heights(). */
    enum status_code (*heights)(const struct direct_crew *crew, struct direct_point *out, uint8_t *touching,
                                const double *height_m, size_t n, double spacing_m, const struct direct_ladder_def *def,
                                struct status *status);
};

#endif
