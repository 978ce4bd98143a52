/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the answers hang on: how area and resistance change when the shortest wavelength, the length of the scan or the
 * hardness is another. */
#ifndef ANALYSIS_SENSITIVITY_H
#define ANALYSIS_SENSITIVITY_H

#include "analysis/ensemble.h"
#include "profile/profile.h"

/** A changed scan: its heights low-passed at twice the cut-off; one half of them; and what halves are held against, the
 * whole levelled and windowed as they are: half of a scan that closes on itself does not. */
enum sensitivity_variant {
    SENSITIVITY_CUTOFF,
    SENSITIVITY_FIRST_HALF,
    SENSITIVITY_SECOND_HALF,
    SENSITIVITY_WHOLE,
    SENSITIVITY_VARIANTS
};

/** What is changed, one thing at a time. */
enum sensitivity_change {
    SENSITIVITY_CUTOFF_DOUBLED,
    SENSITIVITY_SCAN_HALVED,
    SENSITIVITY_HARDNESS_RAISED, /* by a tenth, with the yield strength; of plastic models */
    SENSITIVITY_CHANGES
};
struct sensitivity_change_row {
    const char *name; /* as in sensitivity.csv: "cut-off x2" */
    bool plastic;     /* changes plastic models alone */
};
extern const struct sensitivity_change_row sensitivity_changes[SENSITIVITY_CHANGES];

/** Spectra and moments of the variants of a surface, averaged over its scans like the surface's own. Owned:
 * sensitivity_free(). */
struct sensitivity {
    size_t scans; /* 0: too short to be halved (fewer than 16 points), or not looked at */
    struct member variants[SENSITIVITY_VARIANTS];
    bool levelled[SENSITIVITY_VARIANTS]; /* as model_task.levelled */
};

/** Answer changed / answer as it is, at the middle load; NaN where either is empty, or the change is none for the
 * model. The other way (cut-off halved, scan doubled, hardness lowered) is predicted by the inverses. */
struct sensitivity_factors {
    double area[SENSITIVITY_CHANGES], ecr[SENSITIVITY_CHANGES];
};

/** Adds a profile's variants: low-passed (ISO 16610-21) at twice lambda_s, or four spacings where none is stated,
 * levelled and windowed as the profile is; its halves; and the whole as one that does not close on itself. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code sensitivity_add(struct sensitivity *out, const struct profile *profile,
                                            const struct profile_options *how, enum spectrum_window window,
                                            enum roughness_moments moments, struct status *status);
void sensitivity_free(struct sensitivity *sensitivity);

/** Runs a model on the variants, with the hardness raised, and as it is (of the mean spectrum, as the variants are), at
 * the one load of `task`; of the halves the geometric mean counts, over the whole. Strips stay those of the scan as it
 * is. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code sensitivity_run(struct sensitivity_factors *out, const struct sensitivity *sensitivity,
                                            const struct model_row *model, const struct model_task *task,
                                            struct status *status);

#endif
