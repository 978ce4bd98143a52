/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/integral.h"

#include <gsl/gsl_integration.h>
#include <math.h>
#include <stdbool.h>

enum { QUADRATURE_DEPTH = 30 };

static double bisect(const gsl_function *f, double from, double to, double tolerance, double least, int depth)
{
    double integral, error, magnitude, deviation;
    gsl_integration_qk15(f, from, to, &integral, &error, &magnitude, &deviation);
    if (error <= fmax(tolerance * magnitude, least) || depth == QUADRATURE_DEPTH)
        return integral;
    double middle = from + (to - from) / 2;
    least = fmax(least, tolerance / 64 * magnitude); /* parts that hardly count need not be exact */
    return bisect(f, from, middle, tolerance, least, depth + 1) + bisect(f, middle, to, tolerance, least, depth + 1);
}

/** Kronrod's 7 points and Gauss's 3 among them: nodes from the end to the middle, weights of both. Kronrod 1964;
 * Laurie, Math. Comp. 66 (1997) 1133. */
enum { SHORT_NODES = 4 };
static const double short_node[SHORT_NODES] = {0.9604912687080202834, 0.7745966692414833770, 0.4342437493468025580, 0},
                    short_weight[SHORT_NODES] = {0.1046562260264672652, 0.2684880898683334407, 0.4013974147759622229,
                                                 0.4509165386584741423},
                    short_gauss[SHORT_NODES / 2] = {5.0 / 9, 8.0 / 9};
static const double short_tolerance = 1e-13; /* next to rounding: what is left of doubt is not worth 15 points */

double integral_short(integral_function *f, void *context, double from, double to, double tolerance)
{
    const gsl_function integrand = {f, context};
    double below[SHORT_NODES], above[SHORT_NODES], short_integral, error, magnitude, deviation;
    gsl_integration_qk(SHORT_NODES, short_node, short_gauss, short_weight, below, above, &integrand, from, to,
                       &short_integral, &error, &magnitude, &deviation);
    bool enough = error <= fmin(tolerance, short_tolerance) * magnitude;
    return enough ? short_integral : integral(f, context, from, to, tolerance);
}

double integral(integral_function *f, void *context, double from, double to, double tolerance)
{
    const gsl_function integrand = {f, context};
    return bisect(&integrand, from, to, fmax(tolerance, 1e-14), 0, 0);
}
