/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The scans of a surface with another cut-off or half the length, on which the models run to find how sensitive their
 * answers are (sensitivity.h). */
#ifndef MEMBERS_VARIANTS_H
#define MEMBERS_VARIANTS_H

#include "members/ensemble.h"
#include "profile/profile.h"

/** The scan low-passed at twice the cut-off; its halves; and the whole scan levelled and windowed as the halves are,
 * for comparison with them: half of a periodic scan is not periodic. */
enum variant { VARIANT_CUTOFF, VARIANT_FIRST_HALF, VARIANT_SECOND_HALF, VARIANT_WHOLE, VARIANT_COUNT };

/** Spectra and moments of the variants, averaged over the scans. Owned: variants_free(). */
struct variants {
    size_t scans; /* 0: too short to be halved (fewer than 16 points), or not asked for */
    struct member of[VARIANT_COUNT];
    bool levelled[VARIANT_COUNT]; /* as model_task.levelled */
    bool left_out;                /* set before scans are read: no model will run on them */
};

/** Adds a profile's variants: low-passed (ISO 16610-21) at twice lambda_s, or four spacings where none is stated,
 * levelled and windowed as the profile is; its halves; and the whole as if it were not periodic. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code variants_add(struct variants *out, const struct profile *profile, double lambda_s_m,
                                         const struct scene *scene, struct status *status);
void variants_free(struct variants *variants);

#endif
