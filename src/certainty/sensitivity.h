/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the answers hang on: how area and resistance change when the shortest wavelength, the length of the scan or the
 * hardness is another. */
#ifndef CERTAINTY_SENSITIVITY_H
#define CERTAINTY_SENSITIVITY_H

#include "members/curve_summary.h"
#include "members/variants.h"

struct sensitivity_change_row {
    const char *name; /* as in sensitivity.csv: "cut-off x2" */
    bool plastic;     /* changes plastic models alone */
};
extern const struct sensitivity_change_row sensitivity_changes[SENSITIVITY_CHANGES];

/** Runs a model on the variants, with the hardness raised, and as it is (of the mean spectrum, as the variants are), at
 * the one load of `task`; of the halves the geometric mean counts, over the whole. Strips stay those of the scan as it
 * is. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code sensitivity_run(struct sensitivity_factors *out, const struct variants *variants,
                                            const struct model_row *model, const struct model_task *task,
                                            struct status *status);

#endif
