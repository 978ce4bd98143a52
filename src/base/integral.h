/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Adaptive integration of a function of one variable. */
#ifndef BASE_INTEGRAL_H
#define BASE_INTEGRAL_H

/** A function to integrate, with what else it needs. */
typedef double integral_function(double x, void *context);

/** int_from^to f dx, to `tolerance` relative to the integral of |f| (at best 1e-14), by Gauss and Kronrod's 7 and 15
 * points with bisection, 30 times at most: a jump costs its last part only.
 * Piessens et al., QUADPACK, 1983. */
double integral(integral_function *f, void *context, double from, double to, double tolerance);

#endif
