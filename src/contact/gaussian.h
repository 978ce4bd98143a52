/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Integrals of asperities over a Gaussian height distribution: F_n(h) = int_h^inf (s-h)^n phi(s) ds (docs/equations.md,
 * Statistical models). They close (4.25), (4.26) and (4.43*) for Hertz's law, under the Gaussian of (4.23). h any
 * finite number; relative error below 2e-15 (tests: gaussian_integrals.csv, gaussian_panels.csv). */
#ifndef CONTACT_GAUSSIAN_H
#define CONTACT_GAUSSIAN_H

/** F_n and F_{n-1} at one h, without the factor exp(log_factor) that they share: their ratio keeps every digit where
 * the integrals themselves underflow. */
struct gaussian_pair {
    double upper, lower;
    double log_factor; /* F_n = upper * exp(log_factor) */
};

/** F_3/2 and F_1/2: load and radii. */
struct gaussian_pair gaussian_halves(double h);
/** F_1 and F_0: area and number. */
struct gaussian_pair gaussian_wholes(double h);

/** All four, with one factor. */
struct gaussian_integrals {
    double zero, half, one, three_halves;
    double log_factor;
};

/** Of F_n = Gamma(n+1)/sqrt(2 pi) exp(-h²/4) D_{-n-1}(h), D the parabolic cylinder function, for both pairs, under the
 * Gaussian of (4.23):
 *  -8 <= h < 8  Taylor series about the middle of a panel of width 1/4; the first call in a process takes the
 *               coefficients of all 64 from F_n(0), by such series from panel to panel, and above 1 as below
 *  h >= 8       backward continued fraction of F_n/F_{n-1}, and the Wronskian with the integrals at -h
 *  h < -8       asymptotic series of the moments of |h| + s
 * Abramowitz and Stegun 19.2, 19.4, 19.6, 19.15. */
struct gaussian_integrals gaussian_integrals(double h);

#endif
