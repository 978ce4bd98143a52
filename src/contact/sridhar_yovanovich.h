/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elastoplastic truncation: between Mikic's elastic and CMY's plastic contact. Sridhar and Yovanovich 1996, J. Heat
 * Transfer 118, 3. The source was not at hand: the constants pass five numerical checks (both limits, and the
 * correlations against the closed form), nothing more. */
#ifndef CONTACT_SRIDHAR_YOVANOVICH_H
#define CONTACT_SRIDHAR_YOVANOVICH_H

#include "contact/truncation.h"

/** e = 1.67 (E'/S_f) m: elastoplastic contact strain; large is plastic. S_f is the flow stress. */
double sridhar_yovanovich_strain(double effective_modulus_Pa, double flow_stress_Pa, double slope);

/** The law for truncation.h: f = [1 + (6.5/e)²]^(1/2)/[1 + (13/e)^1.2]^(1/1.2), H_ep = 2.76 S_f/[1 + (6.5/e)²]^(1/2).
 */
struct truncation sridhar_yovanovich(double sigma_m, double slope, double effective_modulus_Pa, double flow_stress_Pa);

/** h sigma/(k m) from P/H_ep: for e > 5 1.245 b1 (P/H_ep)^(0.95 b2), b1 = (1 + 46690/e^2.49)^(1/30), b2 = (1 +
 * 2086.9/e^1.842)^(-1/600), within 4 % of the closed form for P/H_ep 1e-5...1e-2; else 1.54 (P/H_ep)^0.94, within 3 %.
 */
double sridhar_yovanovich_correlation(double pressure_over_hardness, double strain);

#endif
