/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the models say of one described surface: its tiles and strips solved, its curves, and all that is asked of them.
 */
#ifndef ANSWERS_CURVES_H
#define ANSWERS_CURVES_H

#include "members/surface.h"

/** A described surface to its answers, by the models of the plan that it has an answer by, and the plan of its direct
 * solution where that is called for. Errors: STATUS_INTERRUPTED, STATUS_MEMORY. */
MUST_CHECK enum status_code surface_answers_find(struct surface_record *record, const struct surface_task *task,
                                                 struct status *status);

#endif
