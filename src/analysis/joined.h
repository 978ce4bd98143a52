/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A model's curve with what lies in and around its spots. */
#ifndef ANALYSIS_JOINED_H
#define ANALYSIS_JOINED_H

#include "contact/model.h"
#include "joint/joint.h"

/** The effects whose quantities are made of spots. */
extern const unsigned joined_on_spots;

/** Do the joint's effects (EFFECT_BITs that run) add anything to a curve? */
bool joined_adds(const struct joint_task *joint);

/** Adds to `curve`, of `row` at the loads of `task`, what the joint's effects make of it: joint_apply() with the spots
 * of the model, which are those of the task's one surface. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code joined_curve(struct model_curve *curve, const struct model_row *row,
                                         const struct model_task *task, const struct joint_task *joint,
                                         struct status *status);

#endif
