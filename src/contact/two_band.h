/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The two-band multiscale model: the stack of multiscale.h with two scales in place of every harmonic, each of which
 * takes half of the elastic energy of flattening the surface, so that the answer does not depend on the scan's length
 * (equations: two bands). */
#ifndef CONTACT_TWO_BAND_H
#define CONTACT_TWO_BAND_H

#include "contact/multiscale.h"
#include "material/material.h"
#include "spectrum/spectrum.h"

enum { TWO_BAND_COUNT = 2 };

/** The two scales. */
struct two_band {
    size_t split_harmonic; /* m: number of the harmonic at which half of the energy is reached, from 1 */
    double split_share;    /* s: share of that harmonic in band 1, 0 < s <= 1 */
    double amplitude_m[TWO_BAND_COUNT];
    double frequency_per_m[TWO_BAND_COUNT];
};

/** Area ratio beyond which separation and resistance are not to be trusted: within 0.75 they are 0.43...2.1 and
 * 0.64...1.7 of the direct solutions of random surfaces, beyond it both fall to 0 too early. */
extern const double two_band_trusted_area;
/** Share of the hardness H_d in the pressure P/A_n beyond which the elastic-plastic gap is not to be trusted: there it
 * is 1...9 times that of the direct solutions with a capped pressure. */
extern const double two_band_trusted_hardness_share;

/** Splits the harmonics n = 1...N (mean square Delta_n²/2 of the profile) at half of sum f_n Delta_n²; a band has
 * amplitude sqrt2 sqrt(S0) and frequency sqrt(S2/S0), S0 = sum w Delta², S2 = sum w f² Delta², w = 1 within it, s or
 * 1 - s at the split: the variance and the mean-square gradient of the isotropic surface with those profiles. False,
 * and nothing written, when there is no amplitude. */
bool two_band_split(struct two_band *out, const struct spectrum *spectrum);

/** The stack of `bands` for multiscale_solve(). `plastic` with a finite hardness_Pa is the law `plastic-limited`: on a
 * scale that yields a = max(a, min(1, p/H_d)); INFINITY leaves the law as published. Owned: multiscale_free(). Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code two_band_stack(struct multiscale *out, const struct two_band *bands,
                                           const struct material_pair *pair, bool plastic, double hardness_Pa,
                                           enum sinusoid_fit_id closure, struct status *status);

/** Separation of an elastic stack from its resistance, which knows the light loads better than the gaps do [m]:
 * H_B(P) = 2/((rho_1+rho_2) E') int_P^{P_c} ECR A_n dP', P_c = max p* (Barber 2003, Proc. R. Soc. A 459, 53). The
 * resistivity drops out. All of `load` (P/(A_n E') > 0, ascending) in one pass from above, each with the relative
 * `tolerance`. Adds the scales visited to *evaluations. */
void two_band_separation(double *separation_m, const double *load, size_t count, struct multiscale *stack,
                         double tolerance, uint64_t *evaluations);

/** May the separation and the resistance at this area ratio be shown? */
bool two_band_trusted(double area_ratio);
/** May the elastic-plastic separation at P/A_n = pressure_Pa be shown? (The resistance of the limited law may.) */
bool two_band_plastic_gap_trusted(double area_ratio, double pressure_Pa, double hardness_Pa);

#endif
