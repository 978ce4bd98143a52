/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Models on parts that are not flat: the model's curve is applied in every cell of the nominal area. */
#ifndef ANSWERS_SHAPED_H
#define ANSWERS_SHAPED_H

#include "members/surface.h"

/** Fills record->shapes[m]. If the model has no gap, or the pressures no solution, it stays empty and a note says why.
 * Error: STATUS_MEMORY. */
MUST_CHECK enum status_code shaped_make(struct surface_record *record, size_t m, const struct surface_task *asked,
                                        const struct model_task *task, struct status *status);

/** Bulge over length of a good ground or lapped part: 1 um over 10 mm. Drawings ask for less: 50 um over 100 mm under
 * power modules (Fuji Electric, heat sink flatness), 50 um over 30 mm by ISO 2768-2 H. */
extern const double shaped_usual_flatness;
/** For parts of unknown flatness: the factor by which a bulge of shaped_usual_flatness times the side of a square
 * nominal area would multiply the resistance in one of JOINT_WAYS. The cells interpolate `curve`. NaN: not known,
 * because the curve ends below the local pressures, or out of memory. */
double shaped_usual_factor(const struct model_curve *curve, const struct model_row *row, const struct joint_task *joint,
                           double load, int way);

#endif
