/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the parts' shape makes of a surface's models: their curves carried into every cell of the nominal area. */
#ifndef ANALYSIS_SHAPED_H
#define ANALYSIS_SHAPED_H

#include "analysis/plan.h"

struct surface_record; /* analysis/surface.h */

/** Fills record->shapes[m]; where the model has no gap, or the pressures have no answer, it stays empty and a note says
 * why. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code shaped_make(struct surface_record *record, size_t m, const struct scene *scene,
                                        const struct plan *plan, const struct model_task *task, struct status *status);

#endif
