/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Plastic contact of a Gaussian surface by truncation: all that lies above the other body's plane is in contact at the
 * hardness; spots and conductance follow from how often a profile crosses the plane (equations: truncation). Cooper,
 * Mikic and Yovanovich 1969, Int. J. Heat Mass Transfer 12, 279. */
#ifndef CONTACT_CMY_H
#define CONTACT_CMY_H

#include <stdbool.h>

/** What the law needs of a surface. */
struct cmy {
    double sigma_m; /* root mean square height */
    double slope;   /* m, mean absolute slope of the profile: cmy_slope() */
};

/** m = sqrt(2 m2/pi) of Gaussian heights. */
double cmy_slope(double m2);

/** Contact at one pressure. */
struct cmy_contact {
    double separation_over_sigma; /* l = Y/sigma, from the mean plane */
    double spot_density_per_m2;   /* n */
    double spot_radius_m;         /* a, mean over the spots */
    double conductance;           /* h sigma/(k m), without dimension */
};

/** At P/H = A/A_n = erfc(l/sqrt2)/2: n = (1/16) (m/sigma)² exp(-l²)/erfc(l/sqrt2), a = sqrt(8/pi) (sigma/m) exp(l²/2)
 * erfc(l/sqrt2), h sigma/(k m) = exp(-l²/2)/(2 sqrt(2 pi) (1 - sqrt(A/A_n))^(3/2)) = 2 n a sigma/(m Psi). False, with
 * nothing written, unless 0 < P/H < 1. Valid to P/H = 0.1. */
bool cmy_press(struct cmy_contact *out, const struct cmy *surface, double pressure_over_hardness);

/** Largest P/H = A/A_n at which the law is valid: above, the truncated islands merge. */
#define CMY_VALID_AREA 0.1

/** Depth [m] of the spots at P/H = ratio, to compare with a coating's thickness: d/7, with d = sqrt(2 pi) a the
 * diagonal of a Vickers indent of the same area (Antonetti and Yovanovich 1985, J. Heat Transfer 107, 513). NaN where
 * cmy_press() has no answer. */
double cmy_indent_m(const struct cmy *surface, double ratio);

/** Hardness H = c1 (d/1 um)^c2 [Pa] of the spots at P/H = ratio, d as above. NaN where cmy_press() has no answer. */
double cmy_spot_hardness(const struct cmy *surface, double ratio, double c1_Pa, double c2);

/** Hardness [Pa] of the spots at a pressure, smaller spots being harder: P = H(a(l)) erfc(l/sqrt2)/2, solved for l
 * (Yovanovich, Hegazy and DeVaal 1982, AIAA 82-0887, without its fit). -1 < c2 <= 0. NaN at pressures above P/H = 0.5.
 */
double cmy_microhardness(const struct cmy *surface, double pressure_Pa, double c1_Pa, double c2);

#endif
