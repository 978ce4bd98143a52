/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs the models on one surface: solves its map and strips, computes the curves, and answers the scene's questions. */
#ifndef ANSWERS_CURVES_H
#define ANSWERS_CURVES_H

#include "members/surface.h"

/** Runs those models of the plan that can answer for a surface that has been read, and plans its direct study where
 * called for. Errors: STATUS_INTERRUPTED, STATUS_MEMORY. */
MUST_CHECK enum status_code surface_answers_find(struct surface_record *record, const struct surface_task *task,
                                                 struct status *status);

#endif
