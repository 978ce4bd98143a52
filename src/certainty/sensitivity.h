/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sensitivity: how area and resistance change with the shortest wavelength, the length of the scan and the hardness. */
#ifndef CERTAINTY_SENSITIVITY_H
#define CERTAINTY_SENSITIVITY_H

#include "members/curve_summary.h"
#include "members/variants.h"

struct sensitivity_change_row {
    const char *name; /* as in sensitivity.csv: "cut-off x2" */
    bool plastic;     /* of plastic models only */
};
extern const struct sensitivity_change_row sensitivity_changes[SENSITIVITY_CHANGES];

/** Runs a model at the one load of `task` on the variants, with a raised hardness, and unchanged (mean spectrum); of
 * the two halves the geometric mean over the whole counts. Strips are those of the unchanged scan. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code sensitivity_run(struct sensitivity_factors *out, const struct variants *variants,
                                            const struct model_row *model, const struct model_task *task,
                                            struct status *status);

#endif
