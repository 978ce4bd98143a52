/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Integrals of asperities over a Gaussian height distribution: F_n(h) = int_h^inf (s-h)^n phi(s) ds (docs/equations.md,
 * Statistical models). They close (4.25), (4.26) and (4.43*) for Hertz's law, under the Gaussian of (4.23). */
#ifndef CONTACT_GAUSSIAN_H
#define CONTACT_GAUSSIAN_H

/** F_0 (number), F_1/2 (radii), F_1 (area) and F_3/2 (load) without their common factor exp(log_factor), so that ratios
 * keep every digit where the integrals underflow. */
struct gaussian_integrals {
    double zero, half, one, three_halves;
    double log_factor; /* F_n = value * exp(log_factor) */
};

/** At any finite h: F_n = Gamma(n+1)/sqrt(2 pi) exp(-h²/4) D_{-n-1}(h), D the parabolic cylinder function, by GSL's
 * hypergeometric functions (Abramowitz and Stegun 19.12); from -8 to 8 by Chebyshev series of them, made once per
 * process; below -8 by the asymptotic series. Relative error below 1e-13 (tests). */
struct gaussian_integrals gaussian_integrals(double h);

#endif
