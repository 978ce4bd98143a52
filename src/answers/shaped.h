/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the parts' shape makes of a surface's models: their curves carried into every cell of the nominal area. */
#ifndef ANSWERS_SHAPED_H
#define ANSWERS_SHAPED_H

#include "members/surface.h"

/** Fills record->shapes[m]; where the model has no gap, or the pressures have no answer, it stays empty and a note says
 * why. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code shaped_make(struct surface_record *record, size_t m, const struct surface_task *asked,
                                        const struct model_task *task, struct status *status);

#endif
