/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/gaussian.h"

#include <math.h>
#include <pthread.h>

/** A pair of orders, in more digits than doubles have, so that panels are right to the last one. */
struct family {
    long double n;     /* of the upper; the lower's is n - 1 */
    long double at[2]; /* F_n(0) = 2^(n/2 - 1) Gamma((n+1)/2)/sqrt(pi), F_{n-1}(0) */
};

enum { WHOLES, HALVES, FAMILIES };
static const struct family families[FAMILIES] = {
    [WHOLES] = {1, {0.398942280401432677939946L, 0.5L}},
    [HALVES] = {1.5L, {0.430019993662259767688102L, 0.411089479331229276168302L}},
};

/* As wide as these terms allow; beyond the last panels few terms serve without any. */
enum { TERMS = 14, PER_UNIT = 4, REACH = 8, PANELS = 2 * REACH * PER_UNIT };
enum { SCALED = 1, UNSCALED_PANELS = (REACH + SCALED) * PER_UNIT }; /* from h = 1 on exp(-h²/2) is taken out */

/** (-1)^k d^k F_n/dh^k, k = 0 ... count - 1, of F_n and F_{n-1}: F_n' = -n F_{n-1}, and F'' = n F - h F' on and on. */
static void derive(long double *out, int count, long double n, long double h, const long double f[2])
{
    out[0] = f[0];
    out[1] = n * f[1];
    for (int k = 2; k < count; k++)
        out[k] = (n + 2 - k) * out[k - 2] + h * out[k - 1];
}

/** Carries F_n and F_{n-1} from h to h + t, |t| <= 1/4, by the Taylor series. */
static void carry(long double f[2], long double n, long double h, long double t)
{
    enum { CARRY_TERMS = 24 };
    long double derivative[CARRY_TERMS + 1], value = 0, slope = 0;
    derive(derivative, CARRY_TERMS + 1, n, h, f);
    for (int k = CARRY_TERMS - 1; k >= 0; k--) {
        value = derivative[k] - value * t / (k + 1);
        slope = derivative[k + 1] - slope * t / (k + 1);
    }
    f[0] = value;
    f[1] = slope / n;
}

/** F_n, h < -8: |h|^n sum_k binom(n, 2k) (2k-1)!!/h^(2k). What is left out is of the order exp(-h²/2)/|h|^(2n+1). */
static long double far_below(long double n, long double h)
{
    long double term = 1, sum = 1;
    for (int k = 0; k < REACH * REACH - 2 && fabsl(term) > 1e-19L; k += 2) {
        term *= (n - k) * (n - k - 1) / ((k + 2) * h * h);
        sum += term;
    }
    return powl(-h, n) * sum;
}

/** G_m = exp(h²/2) F_m, m = n - 1 and the `count - 1` orders that follow, for h >= 1. From G_{m+1} = m G_{m-1} - h G_m
 * the ratios G_m/G_{m-1} = m/(h + G_{m+1}/G_m) are a continued fraction of positive terms, summed from far out; the
 * first closes the Wronskian F_n(h) F_{n-1}(-h) + F_{n-1}(h) F_n(-h) = 2 F_n(0) F_{n-1}(0) exp(-h²/2), of which
 * `mirrored` is F_n, F_{n-1} at -h. Nothing cancels. */
static void above(long double *g, int count, const struct family *family, long double h, const long double mirrored[2])
{
    int terms = count + 8 + (int)fminl(480, 480 / (h * h));
    long double ratio = sqrtl(h * h / 4 + family->n + terms) - h / 2; /* of order n + terms */
    for (int k = terms; k >= count; k--)
        ratio = (family->n + k - 1) / (h + ratio);
    for (int k = count - 1; k > 0; k--)
        g[k] = ratio = (family->n + k - 1) / (h + ratio);
    g[0] = 2 * family->at[0] * family->at[1] / (mirrored[0] + ratio * mirrored[1]);
    for (int k = 1; k < count; k++)
        g[k] *= g[k - 1];
}

/** Taylor coefficients about the middle of each panel: of F_n, whose derivative is -n F_{n-1}, or from h = 1 on of
 * G_{n-1}, whose derivative is -G_n. */
static double panels[FAMILIES][PANELS][TERMS];
static pthread_once_t panels_filled = PTHREAD_ONCE_INIT;

static double middle(int panel)
{
    return (panel + 0.5) / PER_UNIT - REACH;
}

/** `derivative` k with the sign of (-1)^k. */
static void set_panel(double coefficient[TERMS], const long double derivative[TERMS])
{
    long double factor = 1;
    for (int k = 0; k < TERMS; k++) {
        coefficient[k] = (double)(factor * derivative[k]);
        factor /= -(k + 1);
    }
}

static void fill_family(double panel[PANELS][TERMS], const struct family *family)
{
    long double f[PANELS][2], derivative[TERMS];
    for (int step = -1; step <= 1; step += 2) { /* from 0 both ways */
        long double carried[2] = {family->at[0], family->at[1]}, h = 0;
        for (int i = step < 0 ? PANELS / 2 - 1 : PANELS / 2; i >= 0 && i < UNSCALED_PANELS; i += step) {
            carry(carried, family->n, h, middle(i) - h);
            h = middle(i);
            f[i][0] = carried[0];
            f[i][1] = carried[1];
        }
    }
    for (int i = 0; i < PANELS; i++) {
        if (i < UNSCALED_PANELS)
            derive(derivative, TERMS, family->n, middle(i), f[i]);
        else
            above(derivative, TERMS, family, middle(i), f[PANELS - 1 - i]);
        set_panel(panel[i], derivative);
    }
}

static void fill_panels(void)
{
    for (int i = 0; i < FAMILIES; i++)
        fill_family(panels[i], &families[i]);
}

static struct gaussian_pair by_panel(int which, double h)
{
    pthread_once(&panels_filled, fill_panels);
    int panel = (int)((h + REACH) * PER_UNIT);
    const double *coefficient = panels[which][panel];
    double t = h - middle(panel), value = coefficient[TERMS - 1], slope = 0;
    for (int k = TERMS - 2; k >= 0; k--) {
        slope = slope * t + value;
        value = value * t + coefficient[k];
    }
    if (panel >= UNSCALED_PANELS)
        return (struct gaussian_pair){-slope, value, -h * h / 2};
    return (struct gaussian_pair){value, -slope / (double)families[which].n, 0};
}

static struct gaussian_pair find(int which, double h)
{
    if (h >= -REACH && h < REACH)
        return by_panel(which, h);
    const struct family *family = &families[which];
    long double below[2] = {far_below(family->n, -fabs(h)), far_below(family->n - 1, -fabs(h))}, g[2];
    if (h < 0)
        return (struct gaussian_pair){(double)below[0], (double)below[1], 0};
    above(g, 2, family, h, below);
    return (struct gaussian_pair){(double)g[1], (double)g[0], -h * h / 2};
}

struct gaussian_pair gaussian_halves(double h)
{
    return find(HALVES, h);
}

struct gaussian_pair gaussian_wholes(double h)
{
    return find(WHOLES, h);
}

struct gaussian_integrals gaussian_integrals(double h)
{
    struct gaussian_pair halves = find(HALVES, h), wholes = find(WHOLES, h);
    return (struct gaussian_integrals){wholes.lower, halves.lower, wholes.upper, halves.upper, halves.log_factor};
}
