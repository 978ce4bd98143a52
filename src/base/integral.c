/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/integral.h"

#include <gsl/gsl_integration.h>
#include <math.h>

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

double integral(integral_function *f, void *context, double from, double to, double tolerance)
{
    const gsl_function integrand = {f, context};
    return bisect(&integrand, from, to, fmax(tolerance, 1e-14), 0, 0);
}
