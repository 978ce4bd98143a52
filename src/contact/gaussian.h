/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Integrals of asperities over a Gaussian height distribution: F_n(h) = int_h^inf (s-h)^n phi(s) ds (docs/equations.md,
 * Statistical models). */
#ifndef CONTACT_GAUSSIAN_H
#define CONTACT_GAUSSIAN_H

/** F_0, F_1/2, F_1 and F_3/2 at one h, without the factor exp(log_factor) that they share: their ratios keep every
 * digit where the integrals themselves underflow. */
struct gaussian_integrals {
    double zero, half, one, three_halves;
    double log_factor; /* F_n = value * exp(log_factor) */
};

/** They close (4.25), (4.26) and (4.43*) for Hertz's law, under the Gaussian of (4.23). h any finite number.
 * F_n = Gamma(n+1)/sqrt(2 pi) exp(-h²/4) D_{-n-1}(h), D the parabolic cylinder function:
 *  h > 2       backward continued fraction of F_n/F_{n-1} from F_{-1/2} = sqrt(h)/(2 pi) e^{-h²/4} K_1/4(h²/4) and
 *              F_0 = erfc(h/sqrt2)/2 (no cancellation)
 *  -8 <= h <= 2 Maclaurin series in h
 *  h < -8      asymptotic series of the moments of |h| + s
 * Relative error below 1e-13 (tests: gaussian_integrals.csv). Abramowitz and Stegun 19.5, 19.6, 19.15. */
struct gaussian_integrals gaussian_integrals(double h);

#endif
