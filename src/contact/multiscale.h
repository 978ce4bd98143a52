/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The multiscale models: every harmonic of the surface is a scale, stacked longest first (4.1, 4.2, 4.11*), with the
 * resistances summed in the same pass (4.42*, 4.48*); docs/equations.md, Stacked scales. */
#ifndef CONTACT_MULTISCALE_H
#define CONTACT_MULTISCALE_H

#include "contact/constriction.h"
#include "contact/model.h"
#include "contact/sinusoid.h"
#include "spectrum/spectrum.h"
#include <stdint.h>

enum { MULTISCALE_BLOCK = 128 };

/** The stack of one surface in one material law. Owned: multiscale_free(). */
struct multiscale {
    struct sinusoid_scale *scales; /* longest wavelength first; made at the first visit, as most are never open */
    size_t count;
    const struct spectrum *spectrum; /* the caller's */
    struct material_pair pair;
    bool plastic;
    const struct sinusoid_fit *closure;
    double full_load;               /* P/(A_n E') from which A = A_n: the largest over the scales */
    double closed_load;             /* the same for no separation left */
    double closed_steepness_per_Pa; /* times a mean pressure: steepness up to which scales are closed under it */
    double *block_closed_Pa;        /* mean pressure above which all of a block of MULTISCALE_BLOCK scales are closed */
};

/** Prepares the stack of `spectrum`, which must outlive it. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code multiscale_make(struct multiscale *out, const struct spectrum *spectrum,
                                            const struct material_pair *pair, bool plastic,
                                            enum sinusoid_fit_id closure, struct status *status);
void multiscale_free(struct multiscale *stack);

/** The `wanted` quantities of the contact at P/(A_n E') = load > 0: A_i = a_i A_{i-1} (4.1) under p_i = P/A_{i-1}
 * (4.2), H = sum Delta_i G_i (4.11*). Skips scales that p_i closes, which change nothing; adds the scales visited to
 * *evaluations. Returns how often the published plastic area was limited: cut off at 1 (4.17 exceeds it before p_p), or
 * raised to the elastic area (closure numeric). */
size_t multiscale_solve(struct contact_point *out, struct multiscale *stack, const struct constriction *spot,
                        unsigned wanted, double load, uint64_t *evaluations);
/** The longest scale that comes into complete contact between two loads, and its load; false: none does. */
bool multiscale_closing(struct model_kink *out, struct multiscale *stack, double low, double high);

/** The rows in model_multiscale.c; counterparts of the statistical models. */
extern const struct model_row model_multiscale_elastic, model_multiscale_plastic;

#endif
