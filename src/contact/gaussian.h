/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Integrals of asperities over a Gaussian height distribution: F_n(h) = int_h^inf (s-h)^n phi(s) ds (docs/equations.md,
 * Statistical models). They close (4.25), (4.26) and (4.43*) for Hertz's law, under the Gaussian of (4.23). */
#ifndef CONTACT_GAUSSIAN_H
#define CONTACT_GAUSSIAN_H

/** F_0 (number), F_1/2 (radii), F_1 (area) and F_3/2 (load) without the factor exp(log_factor) that they share: their
 * ratios keep every digit where the integrals themselves underflow. */
struct gaussian_integrals {
    double zero, half, one, three_halves;
    double log_factor; /* F_n = value * exp(log_factor) */
};

/** Under the Gaussian of (4.23), at any finite h: F_n = Gamma(n+1)/sqrt(2 pi) exp(-h²/4) D_{-n-1}(h), D the parabolic
 * cylinder function, by GSL's hypergeometric functions (Abramowitz and Stegun 19.12), between -8 and 8 by Chebyshev
 * series made of them once in a process; below -8 the asymptotic series of the moments of |h| + s. Relative error below
 * 1e-13 (tests: gaussian_integrals.csv, gaussian_panels.csv). */
struct gaussian_integrals gaussian_integrals(double h);

#endif
