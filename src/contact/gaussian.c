/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/gaussian.h"

#include <gsl/gsl_chebyshev.h>
#include <gsl/gsl_sf_hyperg.h>
#include <math.h>
#include <pthread.h>

enum { ORDERS = 4, REACH = 8, TERMS = 14 };
static const double orders[ORDERS] = {0, 0.5, 1, 1.5};

/** F_n, from h = 1 on without exp(-h²/2); nothing cancels. */
static double direct(double h, void *order)
{
    double n = *(const double *)order, x = h * h / 2;
    if (h >= 1)
        return tgamma(n + 1) * exp2(-(n + 1) / 2) / sqrt(2 * M_PI) * gsl_sf_hyperg_U((n + 1) / 2, 0.5, x);
    double even = tgamma((n + 1) / 2) * gsl_sf_hyperg_1F1((n + 1) / 2, 0.5, x),
           odd = tgamma(n / 2 + 1) * gsl_sf_hyperg_1F1(n / 2 + 1, 1.5, x);
    return exp(-x) * exp2(n / 2 - 1) / sqrt(M_PI) * (even - M_SQRT2 * h * odd);
}

/** h < -8: |h|^n sum_k binom(n, 2k) (2k-1)!!/h^(2k). What is left out is of the order exp(-h²/2)/|h|^(2n+1). */
static double far_below(double n, double h)
{
    double term = 1, sum = 1;
    for (int k = 0; k < REACH * REACH - 2 && fabs(term) > 1e-17; k += 2) {
        term *= (n - k) * (n - k - 1) / ((k + 2) * h * h);
        sum += term;
    }
    return pow(-h, n) * sum;
}

/** direct() on panels of width 1. */
static double coefficient[ORDERS][2 * REACH][TERMS + 1], value[ORDERS][2 * REACH][TERMS + 1];
static gsl_cheb_series panel[ORDERS][2 * REACH];
static pthread_once_t panels_made = PTHREAD_ONCE_INIT;

static void make_panels(void)
{
    for (int o = 0; o < ORDERS; o++)
        for (int p = 0; p < 2 * REACH; p++) {
            double n = orders[o];
            gsl_function of = {direct, &n};
            panel[o][p] =
                (gsl_cheb_series){.c = coefficient[o][p], .order = TERMS, .order_sp = TERMS, .f = value[o][p]};
            gsl_cheb_init(&panel[o][p], &of, p - REACH, p + 1 - REACH);
        }
}

struct gaussian_integrals gaussian_integrals(double h)
{
    double f[ORDERS];
    pthread_once(&panels_made, make_panels);
    for (int o = 0; o < ORDERS; o++) {
        double n = orders[o];
        if (h >= -REACH && h < REACH)
            f[o] = gsl_cheb_eval(&panel[o][(int)floor(h) + REACH], h);
        else
            f[o] = h < 0 ? far_below(n, h) : direct(h, &n);
    }
    return (struct gaussian_integrals){f[0], f[1], f[2], f[3], h < 1 ? 0 : -h * h / 2};
}
