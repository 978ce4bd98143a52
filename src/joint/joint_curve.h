/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A model's curve with what lies in and around its spots. */
#ifndef JOINT_JOINT_CURVE_H
#define JOINT_JOINT_CURVE_H

#include "contact/model.h"
#include "joint/joint.h"

/** Adds to `curve`, of `row` at the loads of `task`, what the joint's effects make of it: joint_apply() with the spots
 * of the model, which are those of the task's one surface. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code joint_curve(struct model_curve *curve, const struct model_row *row,
                                        const struct model_task *task, const struct joint_task *joint,
                                        struct status *status);

#endif
