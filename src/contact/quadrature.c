/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/quadrature.h"

#include "base/status.h"
#include <assert.h>
#include <gsl/gsl_integration.h>
#include <math.h>
#include <stdlib.h>

static const double inverse_sqrt_2pi = 0.39894228040143267794;
enum { PANELS_MOST = 1024 };

/** Largest u that counts at separation d: there the Gaussian is exp(-log_cut) of its largest value over u > 0. */
static double reach(double d, double log_cut)
{
    return d > 0 ? 2 * log_cut / (d + sqrt(d * d + 2 * log_cut)) : sqrt(2 * log_cut) - d;
}

/** Adds borders in t = sqrt(u) up to `end`. A panel is at most 0.35 wide near zero (where the weight is exp(-d t²), d
 * up to 40), about 2 wide in u further out (the width of the Gaussian), and at most 1.2 times its distance from the
 * law's nearest singularity, `singular` below t = 0. */
static size_t lay(double *border, size_t count, double end, double singular)
{
    double start = border[count - 1];
    while (start < end && count < PANELS_MOST) {
        double width = fmin(fmin(0.35, 1 / fmax(start, 1)), 1.2 * (start + singular));
        double next = start + 1.1 * width >= end ? end : start + width;
        border[count++] = start = next;
    }
    return count;
}

/** Borders from 0 to sqrt(last), with breaks where the law changes. Up to the first break a = sqrt(R sigma_s) t, so
 * that a²/(a + knudsen length) has a pole at a = -(knudsen length); beyond it the law has fractional powers of u. */
static size_t borders(double *border, const struct asperity *asperity, double sigma_s_m, double knudsen_length_m,
                      double last)
{
    double pole = knudsen_length_m > 0 ? knudsen_length_m / sqrt(asperity->radius_m * sigma_s_m) : INFINITY;
    const double changes[] = {asperity_yield_onset * asperity->critical_interference_m / sigma_s_m,
                              asperity_interference_at(asperity, asperity_fitted_radius_ratio) / sigma_s_m,
                              asperity_interference_at(asperity, 1) / sigma_s_m, last};
    size_t count = 1;
    border[0] = 0;
    for (int i = 0; i < 4; i++)
        count = lay(border, count, sqrt(fmin(changes[i], last)), i == 0 ? pole : 0);
    return count;
}

enum status_code quadrature_make(struct quadrature *out, const struct asperity *asperity, double sigma_s_m,
                                 double knudsen_length_m, double lowest_d, double tolerance, struct status *status)
{
    double border[PANELS_MOST];
    size_t order = (size_t)fmin(20, fmax(4, ceil(-log10(tolerance)) + 2)); /* integrals of tests/data then meet it */
    *out = (struct quadrature){.log_cut = 8 - log(tolerance)};
    size_t panel_count =
        borders(border, asperity, sigma_s_m, knudsen_length_m, reach(fmin(lowest_d, 0), out->log_cut)) - 1;
    assert(panel_count + 1 < PANELS_MOST);
    out->count = panel_count * order;
    out->beyond_fit = asperity_interference_at(asperity, asperity_fitted_radius_ratio) / sigma_s_m;
    out->radius_clamped = asperity_interference_at(asperity, 1) / sigma_s_m;
    gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(order);
    out->node = malloc(out->count * sizeof *out->node);
    if (!rule || !out->node) {
        gsl_integration_glfixed_table_free(rule);
        return status_memory(status);
    }
    for (size_t p = 0, k = 0; p < panel_count; p++)
        for (size_t i = 0; i < order; i++, k++) {
            double t, weight;
            gsl_integration_glfixed_point(border[p], border[p + 1], i, &t, &weight, rule);
            weight *= 2 * t * inverse_sqrt_2pi; /* du = 2 t dt */
            struct asperity_contact contact = asperity_press(asperity, sigma_s_m * t * t);
            double radius = weight * contact.radius_m;
            out->node[k] =
                (struct quadrature_node){t * t, weight * contact.area_m2, weight * contact.load_N, radius,
                                         radius * (contact.radius_m / (contact.radius_m + knudsen_length_m))};
        }
    gsl_integration_glfixed_table_free(rule);
    return STATUS_OK;
}

void quadrature_free(struct quadrature *panels)
{
    free(panels->node);
    *panels = (struct quadrature){0};
}

/** The nodes that count at d: range[0] ... range[1]-1. */
static void find_range(size_t range[2], const struct quadrature *panels, double d)
{
    double last = reach(d, panels->log_cut), first = -d - sqrt(2 * panels->log_cut);
    range[0] = 0;
    while (range[0] < panels->count && panels->node[range[0]].u < first)
        range[0]++;
    range[1] = range[0];
    while (range[1] < panels->count && panels->node[range[1]].u <= last)
        range[1]++;
}

/** ln of the factor left out of all sums: exp(-d²/2) for d > 0. */
static double log_factor_at(double d)
{
    return d > 0 ? -d * d / 2 : 0;
}

/** exp(-(u + d)²/2 - log_factor). */
static double weight_at(double u, double d)
{
    return exp(d > 0 ? -u * (u / 2 + d) : -(u + d) * (u + d) / 2);
}

void quadrature_sum(struct quadrature_sums *out, const struct quadrature *panels, double d)
{
    *out = (struct quadrature_sums){.log_factor = log_factor_at(d)};
    size_t range[2];
    find_range(range, panels, d);
    for (size_t k = range[0]; k < range[1]; k++) {
        const struct quadrature_node *node = &panels->node[k];
        double weight = weight_at(node->u, d), load = weight * node->load;
        out->area += weight * node->area;
        out->load += load;
        if (node->u > panels->beyond_fit)
            out->load_beyond_fit += load;
        if (node->u > panels->radius_clamped)
            out->load_radius_clamped += load;
        out->radius += weight * node->radius;
        out->radius_scale_dependent += weight * node->radius_scale_dependent;
    }
}

void quadrature_moments(double moment[3], double *log_factor, const struct quadrature *panels, bool area, double d)
{
    size_t range[2];
    for (int j = 0; j < 3; j++)
        moment[j] = 0;
    find_range(range, panels, d);
    for (size_t k = range[0]; k < range[1]; k++) {
        const struct quadrature_node *node = &panels->node[k];
        double term = weight_at(node->u, d) * (area ? node->area : node->load);
        for (int j = 0; j < 3; j++, term *= node->u)
            moment[j] += term;
    }
    *log_factor = log_factor_at(d);
}

double quadrature_mean_radius(const struct quadrature *panels, double d)
{
    double area = 0, area_radius = 0;
    for (size_t k = 0; k < panels->count; k++) {
        const struct quadrature_node *node = &panels->node[k];
        double weight = weight_at(node->u, d) * node->area;
        area += weight;
        if (node->radius > 0)
            area_radius += weight * (node->area / (M_PI * node->radius)); /* pi a²/(pi a) */
    }
    return area_radius / area;
}
