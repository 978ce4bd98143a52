/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/persson.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_chebyshev.h>
#include <gsl/gsl_integration.h>
#include <math.h>
#include <pthread.h>
#include <stdlib.h>

const double persson_energy_factor = 0.45;

double persson_erf_inverse(double y)
{
    if (y > 0.5) /* l = Phi^-1(1 - (1-y)/2), erf(l/sqrt2) = y */
        return gsl_cdf_ugaussian_Qinv((1 - y) / 2) / M_SQRT2;
    double x = gsl_cdf_ugaussian_Pinv(0.5 + y / 2) / M_SQRT2; /* 1/2 + y/2 loses digits of y; */
    return x - (erf(x) - y) * exp(x * x) / M_2_SQRTPI;        /* a Newton step restores them */
}

double persson_load(double area_ratio, double m2)
{
    return persson_erf_inverse(area_ratio) *
           sqrt(m2 * (persson_energy_factor + (1 - persson_energy_factor) * area_ratio));
}

/** x exp(x²) I_2(x) as Chebyshev series on panels of equal width in sqrt(x), made once per process. */
enum { PANELS = 11, ORDER = 12, RULE = 64 };
static const double integral_end = 9; /* exp(-81) is negligible beside the steepest waves, where x < 5 */
static double coefficient[PANELS][ORDER + 1], value[PANELS][ORDER + 1];
static gsl_cheb_series panel[PANELS];
static gsl_integration_glfixed_table *rule;

/** Spacing of the nodes in ln y; relative difference in y² up to which rings are divided together. */
static const double distance = 0.1, together = 1e-5;

/** I_2 of ln x as Chebyshev series on cells as wide as the spacing of the nodes, so that at one load all nodes lie at
 * the same place in their cells: eight times faster than an integral at each. */
enum { CELLS = 240, DEGREE = 9 };
static double cell[CELLS][DEGREE + 1];
static double cells_begin; /* ln x */

static pthread_once_t panels_made = PTHREAD_ONCE_INIT;

/** exp(x²) f(t)/t² dt of ln t. */
static double integrand(double logarithm, void *from)
{
    double x = *(double *)from, t = exp(logarithm), probability = erf(t);
    double f = persson_energy_factor + 3 * (1 - persson_energy_factor) * probability * probability;
    return f * exp((x - t) * (x + t)) / t;
}

static double scaled_integral(double x, void *context)
{
    (void)context;
    gsl_function of = {integrand, &x};
    return x * gsl_integration_glfixed(&of, log(x), log(x * x + 40) / 2, rule);
}

static double integral_of_ln(double logarithm, void *context)
{
    (void)context;
    return persson_integral(fmin(exp(logarithm), nextafter(integral_end, 0)));
}

static void make_panels(void)
{
    double values[DEGREE + 1];
    gsl_function of = {scaled_integral, NULL};
    rule = gsl_integration_glfixed_table_alloc(RULE);
    for (int p = 0; p < PANELS && rule; p++) {
        panel[p] = (gsl_cheb_series){.c = coefficient[p], .order = ORDER, .order_sp = ORDER, .f = value[p]};
        gsl_cheb_init(&panel[p], &of, integral_end * p * p / (PANELS * PANELS),
                      integral_end * (p + 1) * (p + 1) / (PANELS * PANELS));
    }
    of.function = integral_of_ln;
    cells_begin = log(integral_end) - CELLS * distance;
    for (int k = 0; k < CELLS && rule; k++) {
        gsl_cheb_series series = {.c = cell[k], .order = DEGREE, .order_sp = DEGREE, .f = values};
        gsl_cheb_init(&series, &of, cells_begin + k * distance, cells_begin + (k + 1) * distance);
        cell[k][0] /= 2;
    }
}

double persson_integral(double x)
{
    return gsl_cheb_eval(&panel[(int)(PANELS * sqrt(x / integral_end))], x) * exp(-x * x) / x;
}

/** Lagrange's polynomials through so many nodes: their barycentric weights. */
enum { SHARES = 12 };
static const double barycentric[SHARES] = {1, -11, 55, -165, 330, -462, 462, -330, 165, -55, 11, -1};

/** Shares a ring of Y² = `square` out to SHARES nodes about it, so that it stands for what it is in every polynomial of
 * degree SHARES-1. `bottom` is the least Y. */
static void share_out(const struct persson *out, double bottom, double square, double weight_m)
{
    double share[SHARES], sum = 0, among_all = fmax(0, log(sqrt(square) / bottom) / distance);
    double place = among_all - floor(among_all) + SHARES / 2 - 1;
    struct persson_node *node = out->node + (size_t)among_all + 1;
    for (int k = 0; k < SHARES; k++) {
        if (place == k) {
            node[k].weight_m += weight_m;
            return;
        }
        share[k] = barycentric[k] / (place - k);
        sum += share[k];
    }
    for (int k = 0; k < SHARES; k++)
        node[k].weight_m += share[k] / sum * weight_m;
}

/** q_n = sqrt2 2 pi f_n of index i. */
static double wave_number(const struct spectrum *spectrum, size_t i)
{
    return M_SQRT2 * 2 * M_PI * spectrum_frequency(spectrum, i);
}

double persson_lost_wave(const struct spectrum *spectrum)
{
    enum { LONGEST = 3 };
    double sum_m2 = 0;
    for (size_t i = 0; i < LONGEST && spectrum->count >= LONGEST; i++)
        sum_m2 += spectrum_power(spectrum, i) / LONGEST;
    return sum_m2;
}

enum status_code persson_make(struct persson *out, const struct spectrum *spectrum, double lost_m2,
                              struct status *status)
{
    pthread_once(&panels_made, make_panels);
    *out = (struct persson){.m0_m2 = spectrum_moment(spectrum, 0), .m2 = spectrum_moment(spectrum, 1)};
    size_t first = 0, last = spectrum->count;
    while (first < last && !(spectrum_power(spectrum, first) > 0))
        first++;
    if (!(out->m2 > 0))
        return STATUS_OK;
    double bottom = 2 * M_PI * spectrum_frequency(spectrum, first) * sqrt(spectrum_power(spectrum, first));
    double lost_slope = M_PI * spectrum_frequency(spectrum, 0) * sqrt(lost_m2), square = lost_slope * lost_slope;
    bottom = lost_m2 > 0 ? fmin(bottom, lost_slope) : bottom;
    out->m0_m2 += lost_m2;
    out->m2 += square;
    out->count = (size_t)(log(sqrt(out->m2) / bottom) / distance) + SHARES + 2;
    out->node = calloc(out->count, sizeof *out->node);
    if (!out->node || !rule) {
        persson_free(out);
        return status_memory(status);
    }
    for (size_t k = 0; k < out->count; k++)
        out->node[k].slope = bottom * exp(distance * ((double)k - SHARES / 2));
    if (lost_m2 > 0) /* half the lowest wave number, q/2: 2/q less 1/q */
        share_out(out, bottom, square, 1 / wave_number(spectrum, 0) / sqrt(M_PI));
    double start = 0, beyond = 0, weight_m = 0; /* of the rings not divided yet: Y² of the first, and the excess */
    for (size_t i = first; i < last; i++) {
        double q = wave_number(spectrum, i), omega = q / M_SQRT2;
        double next = i + 1 < last ? 1 / wave_number(spectrum, i + 1) : 0, own_m = (1 / q - next) / sqrt(M_PI);
        square += omega * omega * spectrum_power(spectrum, i);
        if (weight_m > 0 && square > (1 + together) * start) {
            share_out(out, bottom, start + beyond / weight_m, weight_m);
            weight_m = beyond = 0;
        }
        start = weight_m > 0 ? start : square;
        weight_m += own_m;
        beyond += own_m * (square - start);
    }
    share_out(out, bottom, start + beyond / weight_m, weight_m);
    return STATUS_OK;
}

void persson_free(struct persson *persson)
{
    free(persson->node);
    *persson = (struct persson){0};
}

double persson_constriction(const struct persson *persson, double load)
{
    double place = persson->count > 0 ? (log(load / persson->node[0].slope) - cells_begin) / distance : 0;
    double whole = floor(place), t = 2 * (place - whole) - 1, before = 1, here = t, sums[DEGREE + 1] = {0}, sum_m = 0;
    for (size_t k = persson->count; k-- > 0 && whole - (double)k < CELLS;) {
        double weight_m = persson->node[k].weight_m;
        if (whole < (double)k) {
            sum_m += weight_m * persson_integral(load / persson->node[k].slope);
            continue;
        }
        const double *own = cell[(int)(whole - (double)k)];
        for (int d = 0; d <= DEGREE; d++)
            sums[d] += weight_m * own[d];
    }
    sum_m += sums[0] + t * sums[1];
    for (int d = 2; d <= DEGREE; d++) {
        double next = 2 * t * here - before;
        before = here;
        here = next;
        sum_m += here * sums[d];
    }
    return sum_m;
}
