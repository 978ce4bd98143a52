/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Adaptive integration of a function of one variable, and its antiderivative over a panel. */
#ifndef BASE_INTEGRAL_H
#define BASE_INTEGRAL_H

/** A function to integrate, with what else it needs. */
typedef double integral_function(double x, void *context);

/** int_from^to f dx, to `tolerance` relative to the integral of |f| (at best 1e-14), by Gauss and Kronrod's 7 and 15
 * points with bisection, 30 times at most: a jump costs its last part only.
 * Piessens et al., QUADPACK, 1983. */
double integral(integral_function *f, void *context, double from, double to, double tolerance);

enum { INTEGRAL_PANEL_TERMS = 14 };

/** The antiderivative of a smooth function over a panel, as a Chebyshev series. */
struct integral_panel {
    double from, to;
    double series[INTEGRAL_PANEL_TERMS + 1];
    double error; /* of the function, about: the last two terms of its own series */
};

/** Interpolates f at Chebyshev's points, which leave out both limits. from and to are in any order. */
struct integral_panel integral_panel_make(integral_function *f, void *context, double from, double to);
/** int_from^x f dx, x within the panel; wrong by about |x - from| times its error at most. */
double integral_panel_at(const struct integral_panel *panel, double x);

#endif
