/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/gaussian.h"

#include <gsl/gsl_sf_bessel.h>
#include <gsl/gsl_sf_erf.h>
#include <math.h>

static const double inverse_sqrt_2pi = 0.39894228040143267794;

/** F_n/F_{n-1} for h > 0: with i_n = F_n/Gamma(n+1), (n+1) i_{n+1} = i_{n-1} - h i_n, so that
 * i_n/i_{n-1} = 1/(h + (n+1) i_{n+1}/i_n): a continued fraction of positive terms, summed from far out. */
static double ratio_to_lower(double n, double h)
{
    int terms = 8 + (int)(420 / (h * h));
    double ratio = 1 / (h / 2 + sqrt(h * h / 4 + n + terms + 2));
    for (int k = terms; k >= 0; k--)
        ratio = 1 / (h + (n + 1 + k) * ratio);
    return n * ratio;
}

static struct gaussian_integrals far_above(double h)
{
    double zero = 0.5 * exp(h * h / 2 + gsl_sf_log_erfc(h / M_SQRT2));
    double minus_half = 0.5 * sqrt(h / M_PI) * gsl_sf_bessel_Knu_scaled(0.25, h * h / 4);
    double half = minus_half * ratio_to_lower(0.5, h);
    return (struct gaussian_integrals){
        .zero = zero,
        .half = half,
        .one = zero * ratio_to_lower(1, h),
        .three_halves = half * ratio_to_lower(1.5, h),
        .log_factor = -h * h / 2,
    };
}

/** exp(-h²/2) sum_k (-h)^k/k! 2^((n+k-1)/2) Gamma((n+k+1)/2)/sqrt(2 pi): even and odd k apart, each by its term ratio.
 */
static double series(double n, double h)
{
    double even = exp2((n - 1) / 2) * tgamma((n + 1) / 2) * inverse_sqrt_2pi;
    double odd = -h * exp2(n / 2) * tgamma((n + 2) / 2) * inverse_sqrt_2pi;
    double sum = even + odd;
    for (int k = 2; k < 1000; k += 2) {
        even *= h * h * (n + k - 1) / (k * (k - 1.0));
        odd *= h * h * (n + k) / (k * (k + 1.0));
        sum += even + odd;
        if (even + fabs(odd) < 1e-17 * fabs(sum))
            break;
    }
    return exp(-h * h / 2) * sum;
}

/** |h|^n sum_k binom(n, 2k) (2k-1)!!/h^(2k); what is left out is of the order exp(-h²/2). */
static double far_below(double n, double h)
{
    double term = 1, sum = 1;
    for (int k = 0; k < 2 * 12; k += 2) {
        term *= (n - k) * (n - k - 1) / ((k + 2) * h * h);
        sum += term;
    }
    return pow(-h, n) * sum;
}

struct gaussian_integrals gaussian_integrals(double h)
{
    if (h > 2)
        return far_above(h);
    double (*evaluate)(double, double) = h < -8 ? far_below : series;
    return (struct gaussian_integrals){0.5 * erfc(h / M_SQRT2), evaluate(0.5, h), evaluate(1, h), evaluate(1.5, h), 0};
}
