/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Resistance of a contact: the constriction of the current (or heat) that flows from one half space into the other.
 *
 * On the contact c both conductors share one potential, elsewhere no flux crosses; with a flat interface the potentials
 * are +-rho ĵ/|q| under the flux density j. So j solves
 *     (1/|q|) j = l on c,  j = 0 off c,  mean j = 1,
 * and the constriction length l [m] gives, times nominal area,
 *     electrical ECR A_n = (rho1 + rho2) l,   thermal TCR A_n = (1/k1 + 1/k2) l.
 * For elastic contact l = -(E'/2) d(mean gap)/d(p̄) (Barber, Proc. R. Soc. A 459 (2003) 53). One circular spot of radius
 * a in an infinite cell is Holm's: l = L²/4a.
 */
#ifndef DIRECT_CONSTRICTION_H
#define DIRECT_CONSTRICTION_H

#include "direct/direct_contact.h"

/** Constriction length l = <j, u>/<j> of the points p > 0 of a solved contact, by preconditioned conjugate gradients
 * until it is too large by at most the share `tolerance`: for a residual r of the potential that is <r, K^-1 r> on the
 * set, and <r, |q| r>, which the iteration knows, is never less. Of a strip, which needs j itself, until the potential
 * is constant to the root of that share; l is then as good. 0 where every point is in contact. gap_m of the contact is
 * overwritten, its pressure stays; j becomes the response of a strip. Iterations and convolutions are added to those of
 * the contact. Errors: STATUS_MODEL: no convergence; STATUS_INTERRUPTED when *stop (NULL: never) becomes non-zero;
 * STATUS_MEMORY. */
MUST_CHECK enum status_code direct_constriction_of_contact(double *length_m, struct direct_contact *contact,
                                                           double tolerance, const atomic_bool *stop,
                                                           struct status *status);

#endif
