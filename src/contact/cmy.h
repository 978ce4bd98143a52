/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Plastic truncation (CMY) and its elastic sister (Mikic): laws for truncation.h, and the correlations in use for them.
 * Cooper, Mikic and Yovanovich 1969, Int. J. Heat Mass Transfer 12, 279; Mikic 1974, ibid. 17, 205. */
#ifndef CONTACT_CMY_H
#define CONTACT_CMY_H

#include "contact/truncation.h"

/** Plastic contact of hardness H: all that is truncated touches, f = 1. */
struct truncation cmy_plastic(double sigma_m, double slope, double hardness_Pa);

/** Elastic contact: half of what is truncated touches, H_e = E' m/sqrt2, f = 1/2; A tends to sqrt(pi/m2) P/E'. */
struct truncation cmy_elastic(double sigma_m, double slope, double effective_modulus_Pa);

/** h sigma/(k m) = 1.25 (P/H)^0.95, a fit of the plastic closed form: 0.987...1.010 of it for 1.2e-4 < P/H < 2e-2, less
 * by 6 % at 0.07 (Yovanovich 1981). */
double cmy_plastic_correlation(double pressure_over_hardness);

/** h sigma/(k m) = 1.55 (P/H_e)^0.94, of the elastic closed form: within 2.7 % for P/H_e 3.5e-6...0.2 (Mikic 1974). */
double cmy_elastic_correlation(double pressure_over_hardness);

/** Hardness [Pa] of the spots themselves, smaller spots being harder: P = H(a(l)) erfc(l/sqrt2)/2 with
 * H = c1 (d/1 um)^c2, d = sqrt(2 pi) a the diagonal of the Vickers indentation of the area of a spot, solved for l
 * (Yovanovich, Hegazy and DeVaal 1982, AIAA 82-0887, without its fit). -1 < c2 <= 0. NaN when the pressure is beyond
 * all of them. */
double cmy_microhardness(double sigma_m, double slope, double pressure_Pa, double c1_Pa, double c2);

#endif
