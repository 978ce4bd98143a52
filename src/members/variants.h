/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A surface's scans, changed: what would they be with another cut-off, or half as long? The models run on them too
 * (sensitivity.h). */
#ifndef MEMBERS_VARIANTS_H
#define MEMBERS_VARIANTS_H

#include "members/ensemble.h"
#include "profile/profile.h"

/** A changed scan: its heights low-passed at twice the cut-off; one half of them; and what halves are held against, the
 * whole levelled and windowed as they are: half of a scan that closes on itself does not. */
enum variant { VARIANT_CUTOFF, VARIANT_FIRST_HALF, VARIANT_SECOND_HALF, VARIANT_WHOLE, VARIANT_COUNT };

/** Spectra and moments of the variants of a surface, averaged over its scans like the surface's own. Owned:
 * variants_free(). */
struct variants {
    size_t scans; /* 0: too short to be halved (fewer than 16 points), or not looked at */
    struct member of[VARIANT_COUNT];
    bool levelled[VARIANT_COUNT]; /* as model_task.levelled */
};

/** Adds a profile's variants: low-passed (ISO 16610-21) at twice lambda_s, or four spacings where none is stated,
 * levelled and windowed as the profile is; its halves; and the whole as one that does not close on itself. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code variants_add(struct variants *out, const struct profile *profile,
                                         const struct profile_options *how, enum spectrum_window window,
                                         enum roughness_moments moments, struct status *status);
void variants_free(struct variants *variants);

#endif
