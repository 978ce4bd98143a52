/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/persson_kernel.h"

#include <gsl/gsl_math.h>

static const double middle_from = 0.5, middle_to = 6.75;
enum { RULE = 48 };

/** Gauss-Legendre nodes and weights on -1...1. */
struct rule {
    double node[RULE], weight[RULE];
};

/** P_n by its recurrence, roots by Newton's iteration from Tricomi's guess. */
static struct rule gauss_legendre(void)
{
    struct rule rule;
    for (int i = 0; i < RULE; i++) {
        double x = cos(M_PI * (i + 0.75) / (RULE + 0.5)), slope = 1;
        for (int iteration = 0; iteration < 6; iteration++) {
            double last = 1, value = x;
            for (int n = 2; n <= RULE; n++) {
                double next = ((2 * n - 1) * x * value - (n - 1) * last) / n;
                last = value;
                value = next;
            }
            slope = RULE * (x * value - last) / (x * x - 1);
            x -= value / slope;
        }
        rule.node[i] = x;
        rule.weight[i] = 2 / ((1 - x * x) * slope * slope);
    }
    return rule;
}

/** int_0^inf F(x+v) {v, 1}/(x+v)² exp(-2xv - v²) dv with F = g + 3(1-g) erf²: both integrals without exp(-x²). */
static struct persson_integrals scaled(double energy_factor, const struct rule *rule, double x)
{
    double reach = 40 / (x + sqrt(x * x + 40)); /* 2xv + v² = 40 */
    struct persson_integrals sum = {0, 0};
    for (int i = 0; i < RULE; i++) {
        double v = reach / 2 * (1 + rule->node[i]), t = x + v, probability = erf(t);
        double term = rule->weight[i] * reach / 2 *
                      (energy_factor + 3 * (1 - energy_factor) * probability * probability) * exp(-v * (2 * x + v)) /
                      (t * t);
        sum.separation += term * v;
        sum.conductance += term;
    }
    return sum;
}

/** Chebyshev interpolation of values at the points cos(pi (j+1/2)/n), turned into powers. */
static void interpolate(double power[PERSSON_PANEL_TERMS], const double value[PERSSON_PANEL_TERMS])
{
    enum { N = PERSSON_PANEL_TERMS };
    double before[N] = {1}, now[N] = {0, 1}; /* powers of T_{k-1}, T_k */
    for (int i = 0; i < N; i++)
        power[i] = 0;
    for (int k = 0; k < N; k++) {
        const double *chebyshev = k == 0 ? before : now;
        double coefficient = 0;
        for (int j = 0; j < N; j++)
            coefficient += (k == 0 ? 1.0 : 2.0) / N * value[j] * cos(M_PI * k * (j + 0.5) / N);
        for (int i = 0; i <= k; i++)
            power[i] += coefficient * chebyshev[i];
        if (k == 0)
            continue;
        for (int i = N - 1; i >= 0; i--) { /* T_{k+1} = 2x T_k - T_{k-1} */
            double next = (i > 0 ? 2 * now[i - 1] : 0) - before[i];
            before[i] = now[i];
            now[i] = next;
            /* now[i - 1] is still T_k's: the loop runs downwards */
        }
    }
}

static double panel_width(void)
{
    return log(middle_to / middle_from) / PERSSON_PANELS;
}

static void lay_panels(struct persson_kernel *kernel)
{
    struct rule rule = gauss_legendre();
    for (int p = 0; p < PERSSON_PANELS; p++) {
        double separation[PERSSON_PANEL_TERMS], conductance[PERSSON_PANEL_TERMS];
        for (int j = 0; j < PERSSON_PANEL_TERMS; j++) {
            double place = p + 0.5 + cos(M_PI * (j + 0.5) / PERSSON_PANEL_TERMS) / 2;
            struct persson_integrals at =
                scaled(kernel->energy_factor, &rule, middle_from * exp(place * panel_width()));
            separation[j] = at.separation;
            conductance[j] = at.conductance;
        }
        interpolate(kernel->separation[p], separation);
        interpolate(kernel->conductance[p], conductance);
    }
}

/** Taylor coefficients c_k of t^(2k), k = 0 ... PERSSON_TERMS, of exp(-t²) erf² t. With r the coefficients of
 * erf(t)/t = 2/sqrt(pi) sum (-1)^k t^(2k)/(k! (2k+1)). */
static void erf_square_taylor(double c[PERSSON_TERMS + 1])
{
    double r[PERSSON_TERMS + 1], e[PERSSON_TERMS + 1];
    e[0] = 1; /* of exp(-t²) */
    for (int k = 0; k <= PERSSON_TERMS; k++) {
        if (k > 0)
            e[k] = -e[k - 1] / k;
        r[k] = M_2_SQRTPI * e[k] / (2 * k + 1);
        c[k] = 0;
    }
    for (int i = 0; i <= PERSSON_TERMS; i++)
        for (int j = 0; i + j < PERSSON_TERMS; j++)
            for (int k = 0; i + j + k < PERSSON_TERMS; k++)
                c[i + j + k + 1] += r[i] * r[j] * e[k];
}

struct persson_kernel persson_kernel(double energy_factor)
{
    double g = energy_factor, rest = 3 * (1 - g);
    /* int_0^inf erf² t exp(-t²)/t dt = (4/pi) int_0^{1/sqrt2} atan(v)/(1-v²) dv, and
     * int_0^inf erf² t exp(-t²)/t² dt = (4/sqrt(pi)) arsinh(1/sqrt2) - sqrt(pi)/3 */
    static const double erf_square_over_t = 0.40712493463438924;
    double erf_square_over_t2 = 2 * M_2_SQRTPI * asinh(M_SQRT1_2) - sqrt(M_PI) / 3;
    struct persson_kernel kernel = {
        .energy_factor = g,
        .constant = g * (-M_EULER / 2 - 1) + rest * erf_square_over_t,
        .slope = g * sqrt(M_PI) - rest * erf_square_over_t2,
    };
    double erf_square[PERSSON_TERMS + 1], exponential = 1;
    erf_square_taylor(erf_square);
    for (int k = 1; k <= PERSSON_TERMS; k++) { /* s'' = f/x² */
        exponential /= -k;
        kernel.taylor[k - 1] = (g * exponential + rest * erf_square[k]) / (2 * k * (2 * k - 1.0));
    }
    lay_panels(&kernel);
    return kernel;
}

static struct persson_integrals small(const struct persson_kernel *kernel, double x, double logarithm)
{
    double square = x * x, sum = 0, derivative = 0; /* of sum taylor_k x^(2k), the derivative times x */
    for (int k = PERSSON_TERMS; k > 0; k--) {
        sum = (sum + kernel->taylor[k - 1]) * square;
        derivative = (derivative + 2 * k * kernel->taylor[k - 1]) * square;
    }
    return (struct persson_integrals){
        -kernel->energy_factor * logarithm + kernel->constant + kernel->slope * x + sum,
        (kernel->energy_factor - derivative) / x - kernel->slope,
    };
}

static struct persson_integrals middle(const struct persson_kernel *kernel, double x, double logarithm)
{
    double place = (logarithm - log(middle_from)) / panel_width();
    int p = (int)fmin(fmax(place, 0), PERSSON_PANELS - 1);
    const double *a = kernel->separation[p], *b = kernel->conductance[p];
    double t = 2 * (place - p) - 1, separation = 0, conductance = 0, factor = exp(-x * x);
    for (int i = PERSSON_PANEL_TERMS; i-- > 0;) {
        separation = separation * t + a[i];
        conductance = conductance * t + b[i];
    }
    return (struct persson_integrals){factor * separation, factor * conductance};
}

/** t = sqrt(x² + w): s = exp(-x²)/(2x²) sum k! [(-1)^k - C(-3/2, k)] x^(-2k), I_2 = exp(-x²)/(2x³) sum k! C(-3/2, k)
 * x^(-2k). */
static struct persson_integrals large(const struct persson_kernel *kernel, double x)
{
    double factor = (3 - 2 * kernel->energy_factor) * exp(-x * x) / (2 * x * x);
    double geometric = 1, binomial = 1, separation = 0, conductance = 1;
    for (int k = 1; k < 20; k++) {
        geometric *= -k / (x * x);
        binomial *= -(k + 0.5) / (x * x);
        separation += geometric - binomial;
        conductance += binomial;
    }
    return (struct persson_integrals){factor * separation, factor * conductance / x};
}

struct persson_integrals persson_integrals(const struct persson_kernel *kernel, double x, double logarithm)
{
    if (x < middle_from)
        return small(kernel, x, logarithm);
    return x < middle_to ? middle(kernel, x, logarithm) : large(kernel, x);
}
