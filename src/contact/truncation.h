/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contact of Gaussian surfaces by truncation: what of one surface lies above the other's plane is contact, in the
 * proportion `fraction`; spots and conductance follow from how often a profile crosses that plane (equations:
 * truncation). Cooper, Mikic and Yovanovich 1969, Int. J. Heat Mass Transfer 12, 279 (plastic); Mikic 1974, ibid. 17,
 * 205 (elastic); Sridhar and Yovanovich 1996, J. Heat Transfer 118, 3 (elastoplastic). */
#ifndef CONTACT_TRUNCATION_H
#define CONTACT_TRUNCATION_H

#include <stdbool.h>

/** One law on one surface. */
struct truncation {
    double sigma_m;     /* root mean square height */
    double slope;       /* m, mean absolute slope of the profile: sqrt(2 m2/pi) for Gaussian heights */
    double hardness_Pa; /* H, or what stands for it in the law */
    double fraction;    /* f of the truncated area that is contact: 1 plastic, 1/2 elastic */
};

/** m = sqrt(2 m2/pi) of Gaussian heights. */
double truncation_slope(double m2);

/** Contact at one pressure. */
struct truncation_contact {
    double separation_over_sigma; /* l = Y/sigma, from the mean plane */
    double area_ratio;            /* A/A_n = P/H */
    double spot_density_per_m2;   /* n */
    double spot_radius_m;         /* a, mean over the spots */
    double conductance;           /* h sigma/(k m), without dimension */
};

/** At P/H = pressure_over_hardness: A/A_n = P/H = f erfc(l/sqrt2)/2, n = (1/16) (m/sigma)² exp(-l²)/erfc(l/sqrt2),
 * a = sqrt(f) sqrt(8/pi) (sigma/m) exp(l²/2) erfc(l/sqrt2), h sigma/(k m) = sqrt(f) exp(-l²/2)/(2 sqrt(2 pi) (1 -
 * sqrt(A/A_n))^(3/2)) = 2 n a sigma/(m Psi). False, and nothing written, when P/H is not between 0 and f (at f all of
 * the surface is truncated). Valid to P/H = 0.1. */
bool truncation_press(struct truncation_contact *out, const struct truncation *law, double pressure_over_hardness);

/** Largest P/H = A/A_n for which the laws are meant: above, truncated islands run together. */
#define TRUNCATION_VALID_AREA 0.1

/** ECR A_n = rho sigma/(m (h sigma/(k m))) [ohm m²], rho half of both resistivities; with 1/k in its place TCR A_n. */
double truncation_resistance(const struct truncation *law, const struct truncation_contact *contact,
                             double resistivity);

#endif
