/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the models say of one described surface: its tiles and strips solved, its curves, and all that is asked of them.
 */
#ifndef ANALYSIS_EVALUATE_H
#define ANALYSIS_EVALUATE_H

#include "analysis/surface.h"

/** A described surface to its answers, by the models of the plan that it has an answer by, and the plan of its direct
 * solution where that is called for. Errors: STATUS_INTERRUPTED, STATUS_MEMORY. */
MUST_CHECK enum status_code evaluate_surface(struct surface_record *record, const struct surface_task *task,
                                             struct status *status);

/** Runs the models that the plan calls for on a described surface, one after another. Errors: STATUS_INTERRUPTED,
 * STATUS_MEMORY. */
MUST_CHECK enum status_code evaluate_models(struct surface_record *record, const struct surface_task *asked,
                                            struct status *status);
#endif
