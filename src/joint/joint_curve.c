/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "joint/joint_curve.h"

#include <math.h>
#include <stdlib.h>

/** The effects whose quantities are made of spots. */
static const unsigned joint_on_spots =
    EFFECT_BIT(EFFECT_FILM) | EFFECT_BIT(EFFECT_PLATING) | EFFECT_BIT(EFFECT_HEATING);

/** Do the joint's effects (EFFECT_BITs that run) add anything to a curve? */
static bool joint_adds(const struct joint_task *joint)
{
    return joint->effects & (joint_on_spots | EFFECT_BIT(EFFECT_GAP));
}

enum status_code joint_curve(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                             const struct joint_task *joint, struct status *status)
{
    struct contact_spots *spots = NULL;
    enum status_code rc = STATUS_OK;
    if (!curve->exists || !joint_adds(joint))
        return STATUS_OK;
    if (row->spots && (joint->effects & joint_on_spots)) {
        spots = calloc(task->load_count + 1, sizeof *spots);
        if (!spots)
            return status_memory(status);
        rc = row->spots(spots, row, task, status);
        for (size_t i = 0; i < curve->count; i++)
            if (i >= task->load_count || curve->points[i].value[QUANTITY_LOAD] != task->loads[i]) /* full contact */
                spots[i] = (struct contact_spots){NAN, NAN};
    }
    if (rc == STATUS_OK)
        joint_apply(curve->points, spots, curve->count, joint);
    free(spots);
    return rc;
}
