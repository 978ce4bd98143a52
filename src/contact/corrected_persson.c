/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/corrected_persson.h"

#include <math.h>
#include <pthread.h>

enum { KNOTS = 16 };

/** Measured on direct solutions of 48 Gaussian surfaces, Hurst exponents 0.3 ... 1, bandwidths 8 ... 512. */
static const double knot_area[KNOTS] = {0.0012, 0.0025, 0.005, 0.01, 0.02, 0.04, 0.08, 0.15,
                                        0.25,   0.4,    0.55,  0.7,  0.8,  0.88, 0.93, 0.965};
static const double knot_load[KNOTS] = {-0.062, -0.041, -0.047, -0.002, 0.002,  0.014,  0.047,  0.029,
                                        0.036,  0.014,  -0.007, -0.022, -0.032, -0.040, -0.040, -0.037}; /* ln s */
static const double knot_constriction[KNOTS] = {-0.604, -0.469, -0.384, -0.336, -0.274, -0.201, -0.124, -0.045, 0.000,
                                                0.078,  0.172,  0.322,  0.464,  0.621,  0.783,  0.972}; /* ln c */
/** d ln c/d logit A below the first knot and above the last. */
static const double slope_below = 0.115, slope_above = 0.13;

static const double step = 0.2; /* of the integral, in logit A */
static const double reach = 8; /* in logit A beyond the largest area: from there on the integrand is a power of 1 - A */

/** Slope at knot k of the monotone cubic through (x, y), 0 where the data turn (Fritsch and Butland, SIAM J. Sci. Stat.
 * Comput. 5 (1984) 300); at an end that of the parabola through three, limited. */
static double slope_at(size_t k, const double *x, const double *y)
{
    size_t left = k == 0 ? 0 : k == KNOTS - 1 ? KNOTS - 3 : k - 1; /* of three knots */
    double h[2] = {x[left + 1] - x[left], x[left + 2] - x[left + 1]};
    double d[2] = {(y[left + 1] - y[left]) / h[0], (y[left + 2] - y[left + 1]) / h[1]};
    if (k > 0 && k < KNOTS - 1) {
        double w[2] = {2 * h[1] + h[0], h[1] + 2 * h[0]};
        return d[0] * d[1] > 0 ? (w[0] + w[1]) / (w[0] / d[0] + w[1] / d[1]) : 0;
    }
    size_t own = k > 0, other = k == 0;
    double slope = ((2 * h[own] + h[other]) * d[own] - h[own] * d[other]) / (h[own] + h[other]);
    if (!(slope * d[own] > 0))
        return 0;
    return d[0] * d[1] < 0 && fabs(slope) > 3 * fabs(d[own]) ? 3 * d[own] : slope;
}

/** Both cubics, made once per process: logit A of the knots, and the slopes there. */
static struct {
    double place[KNOTS], load_slope[KNOTS], constriction_slope[KNOTS];
} cubics;
static pthread_once_t cubics_made = PTHREAD_ONCE_INIT;

static void make_cubics(void)
{
    for (size_t k = 0; k < KNOTS; k++)
        cubics.place[k] = logit(knot_area[k]);
    for (size_t k = 0; k < KNOTS; k++) {
        cubics.load_slope[k] = slope_at(k, cubics.place, knot_load);
        cubics.constriction_slope[k] = slope_at(k, cubics.place, knot_constriction);
    }
}

/** Hermite's cubic from y[0] to y[1], at the share t of the width. */
static double cubic(const double *y, const double *slope, double width, double t)
{
    double a = width * slope[0], b = width * slope[1], rise = y[1] - y[0];
    return y[0] + t * (a + t * (3 * rise - 2 * a - b + t * (a + b - 2 * rise)));
}

struct corrected_persson_factors corrected_persson_factors(double area_ratio)
{
    pthread_once(&cubics_made, make_cubics);
    const double *x = cubics.place, *s = knot_load, *c = knot_constriction;
    double at = logit(area_ratio);
    if (at <= x[0])
        return (struct corrected_persson_factors){s[0], c[0] + slope_below * (at - x[0])};
    if (at >= x[KNOTS - 1])
        return (struct corrected_persson_factors){s[KNOTS - 1], c[KNOTS - 1] + slope_above * (at - x[KNOTS - 1])};
    size_t k = 0;
    while (at >= x[k + 1])
        k++;
    double width = x[k + 1] - x[k], t = (at - x[k]) / width;
    return (struct corrected_persson_factors){cubic(s + k, cubics.load_slope + k, width, t),
                                              cubic(c + k, cubics.constriction_slope + k, width, t)};
}

double corrected_persson_load(double area_ratio, double m2)
{
    return exp(corrected_persson_factors(area_ratio).load) * persson_load(area_ratio, m2);
}

double corrected_persson_area(double load, double m2)
{
    double before = 0, area = 0.5; /* a change of A changes the right side by a third of it */
    for (int i = 0; i < 100 && area < 1 && fabs(area - before) > 1e-15 * area; i++) {
        before = area;
        double eased = m2 * (persson_energy_factor + (1 - persson_energy_factor) * area);
        area = erf(load / exp(corrected_persson_factors(area).load) / sqrt(eased));
    }
    return area;
}

/** A point of the integral. */
struct place {
    double ln_load, constriction_m, product_m; /* ln p, l, l p */
};

static struct place place_at(double area_ratio, const struct persson *persson)
{
    struct corrected_persson_factors ln = corrected_persson_factors(area_ratio);
    double load = persson_load(area_ratio, persson->m2);
    double length_m = exp(ln.constriction) * persson_constriction(persson, load);
    return (struct place){log(load) + ln.load, length_m, length_m * load * exp(ln.load)};
}

/** int l p d ln p by the parabola through three points (Simpson's rule where they are even). */
static double between(const struct place *a, const struct place *b, const struct place *c)
{
    double first = b->ln_load - a->ln_load, second = c->ln_load - b->ln_load, both = first + second;
    return both / 6 *
           ((2 - second / first) * a->product_m + both * both / (first * second) * b->product_m +
            (2 - first / second) * c->product_m);
}

/** The integral down to an area. */
struct integral {
    double x, sum_m; /* logit A; 2 int l dp */
    struct place above;
};

static void descend(struct integral *at, double area, const struct persson *persson)
{
    double to = logit(area), steps = fmax(1, ceil((at->x - to) / step)), width = (at->x - to) / steps;
    for (double k = 1; k <= steps && fabs(at->x - to) > 1e-9; k++) { /* unless it is there */
        struct place middle = place_at(logistic(at->x - (k - 0.5) * width), persson),
                     here = place_at(k < steps ? logistic(at->x - k * width) : area, persson);
        at->sum_m += 2 * between(&here, &middle, &at->above);
        at->above = here;
    }
    at->x = to;
}

static void descend_all(struct corrected_persson_point *point, size_t count, struct integral *at,
                        const struct persson *persson)
{
    for (size_t i = count; i-- > 0;) {
        descend(at, point[i].area_ratio, persson);
        point[i].constriction_m = at->above.constriction_m;
        point[i].separation_m = at->sum_m;
    }
}

/** The lengths alone. */
static void lengths(struct corrected_persson_point *point, size_t count, const struct persson *persson)
{
    for (size_t i = 0; i < count; i++) {
        point[i].constriction_m = place_at(point[i].area_ratio, persson).constriction_m;
        point[i].separation_m = NAN;
    }
}

void corrected_persson_curve(struct corrected_persson_point *point, size_t count, const struct persson *persson,
                             bool with_separation)
{
    if (!with_separation) {
        lengths(point, count, persson);
        return;
    }
    double x = logit(CORRECTED_PERSSON_LARGEST_AREA) + reach;
    struct place above = place_at(logistic(x), persson), below = place_at(logistic(x - step), persson);
    /* beyond: l p is a power of 1 - A while p hardly changes */
    double rest_m =
        (above.product_m + below.product_m) * (above.ln_load - below.ln_load) / log(below.product_m / above.product_m);
    struct integral at = {x, rest_m, above};
    descend(&at, knot_area[KNOTS - 1], persson); /* to the last knot first, where the slope of c changes */
    descend_all(point, count, &at, persson);
}

void corrected_persson_below(struct corrected_persson_point *point, size_t count, const struct persson *persson,
                             const struct corrected_persson_point *known)
{
    if (isnan(known->separation_m)) {
        lengths(point, count, persson);
        return;
    }
    struct integral at = {logit(known->area_ratio), known->separation_m, place_at(known->area_ratio, persson)};
    descend_all(point, count, &at, persson);
}
