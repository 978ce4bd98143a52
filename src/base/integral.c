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

struct integral_panel integral_panel_make(integral_function *f, void *context, double from, double to)
{
    enum { N = INTEGRAL_PANEL_TERMS };
    struct integral_panel panel = {.from = from, .to = to};
    double coefficient[N + 2] = {0}, middle = from + (to - from) / 2, half = (to - from) / 2;
    for (int j = 0; j < N; j++) {
        double t = cos(M_PI * (j + 0.5) / N), value = 2.0 / N * f(middle + half * t, context);
        double before = 1, now = t; /* T_k and T_{k+1} */
        for (int k = 0; k < N; k++) {
            double next = 2 * t * now - before;
            coefficient[k] += value * before;
            before = now;
            now = next;
        }
    }
    panel.error = fabs(coefficient[N - 1]) + fabs(coefficient[N - 2]);
    /* int T_k = T_{k+1}/(2k+2) - T_{k-1}/(2k-2); T_0's coefficient is twice its own here, as that asks for */
    for (int k = 1; k <= N; k++) {
        panel.series[k] = half * (coefficient[k - 1] - coefficient[k + 1]) / (2 * k);
        panel.series[0] += k % 2 ? panel.series[k] : -panel.series[k]; /* 0 at t = -1 */
    }
    return panel;
}

double integral_panel_at(const struct integral_panel *panel, double x)
{
    double t = 2 * (x - panel->from) / (panel->to - panel->from) - 1, now = 0, before = 0;
    for (int k = INTEGRAL_PANEL_TERMS; k > 0; k--) { /* Clenshaw 1955 */
        double next = 2 * t * now - before + panel->series[k];
        before = now;
        now = next;
    }
    return t * now - before + panel->series[0];
}
