/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The multiscale models: every harmonic of the surface is a scale, stacked longest first (4.1, 4.2, 4.11*);
 * docs/equations.md, Stacked scales. The electrical and thermal resistance is summed in the same pass (4.42*, 4.48*).
 */
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
    struct sinusoid_scale *scales; /* longest wavelength first; made when first visited: most are closed by then */
    size_t count;
    const struct spectrum *spectrum; /* that scales are made of: the caller's */
    struct material_pair pair;
    bool plastic;
    const struct sinusoid_fit *closure;
    double full_load;               /* P/(A_n E') from which A = A_n: the largest over the scales */
    double closed_load;             /* the same for no separation left */
    double closed_steepness_per_Pa; /* times a mean pressure: scales that steep, or less, are closed under it */
    double *block_closed_Pa;        /* of every MULTISCALE_BLOCK scales: a mean pressure above which all are closed */
};

/** Prepares the stack of `spectrum`, which has to be there as long as the stack, for `pair`, elastic-plastic when
 * `plastic`. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code multiscale_make(struct multiscale *out, const struct spectrum *spectrum,
                                            const struct material_pair *pair, bool plastic,
                                            enum sinusoid_fit_id closure, struct status *status);
void multiscale_free(struct multiscale *stack);

/** Contact at P/(A_n E') = load > 0: A_i = a_i A_{i-1} (4.1) under p_i = P/A_{i-1} (4.2); H = sum Delta_i G_i
 * (4.11*); the resistances of `spot`, only the quantities in `wanted` (others stay NaN). Passes over
 * scales that p_i closes: they would add nothing, and leave the area as it is. Adds the scales visited to *evaluations.
 * Returns at how many of them the published plastic area had to be limited: cut off at 1 (4.17 exceeds it before p_p),
 * or raised to the elastic area (closure numeric). */
size_t multiscale_solve(struct contact_point *out, struct multiscale *stack, const struct constriction *spot,
                        unsigned wanted, double load, uint64_t *evaluations);
/** The longest of the scales that become complete between two loads, and the load at which it does; false: none does.
 * Takes a few walks of the stack, passing over what is closed at both. */
bool multiscale_closing(struct model_kink *out, struct multiscale *stack, double low, double high);

/** The rows of this stack (model_multiscale.c); the statistical models name them as counterparts. */
extern const struct model_row model_multiscale_elastic, model_multiscale_plastic;

#endif
