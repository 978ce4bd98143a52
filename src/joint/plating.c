/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "joint/plating.h"

#include <math.h>
#include <stdbool.h>

/** |Q|^n [atan(1/u) - (u/2) ln(1 + 1/u²)], u = nT. The bracket is int_0^inf exp(-2u x) sin²(x)/x² dx, so that these are
 * moments of a positive measure. */
static double term(double n, double thickness_over_radius, double magnitude_log)
{
    double u = n * thickness_over_radius;
    double logarithm = u < 1 ? log1p(u * u) - 2 * log(u) : log1p(1 / u / u);
    double bracket = u > 0 ? atan(1 / u) - u / 2 * logarithm : M_PI_2;
    return exp(n * magnitude_log) * bracket;
}

/** sum_j 2^j term(2^j k): van Wijngaarden's k-th term, which makes a series of one sign alternate. */
static double condensed(double k, double thickness_over_radius, double magnitude_log)
{
    double sum = 0;
    for (double power = 1;; power *= 2) {
        double next = power * term(power * k, thickness_over_radius, magnitude_log);
        sum += next;
        if (!(next > 1e-17 * sum))
            return sum;
    }
}

/** sum_{n>=1} |Q|^n [...], with one sign or `alternating` (the first less), by algorithm 1 of Cohen, Rodriguez Villegas
 * and Zagier (2000, Experimental Mathematics 9, 3), whose relative error is 2/5.8^TERMS here. */
static double series(double thickness_over_radius, double magnitude_log, bool alternating)
{
    enum { TERMS = 18 };
    double (*at)(double, double, double) = alternating ? term : condensed;
    double power = pow(3 + sqrt(8), TERMS), d = (power + 1 / power) / 2, b = -1, c = -d, sum = 0;
    for (int k = 0; k < TERMS; k++) {
        c = b - c;
        sum += c * at(k + 1, thickness_over_radius, magnitude_log);
        b *= (k + TERMS) * (double)(k - TERMS) / ((k + 0.5) * (k + 1));
    }
    return sum / d;
}

double plating_factor(double thickness_over_radius, double plating_resistivity, double body_resistivity)
{
    if (plating_resistivity == body_resistivity)
        return 1;
    bool poorer = plating_resistivity > body_resistivity; /* Q < 0 */
    double lower = poorer ? body_resistivity : plating_resistivity, sum = plating_resistivity + body_resistivity;
    double total =
        4 / M_PI * series(thickness_over_radius, log1p(-2 * (lower / sum)), poorer); /* |Q| = 1 - 2 lower/sum */
    return poorer ? fmax(1 - total, body_resistivity / plating_resistivity) : 1 + total;
}
