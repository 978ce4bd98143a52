/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gauss-Legendre panels for the statistical integrals. The asperity law is evaluated once at fixed interferences; a
 * separation then costs one exponential per node. */
#ifndef CONTACT_QUADRATURE_H
#define CONTACT_QUADRATURE_H

#include "contact/asperity.h"
#include <stddef.h>

/** u = omega/sigma_s; the rest is the law times the quadrature weight, 1/sqrt(2 pi) of the Gaussian included. */
struct quadrature_node {
    double u, area, load, radius;  /* m², N, m */
    double radius_scale_dependent; /* a²/(a + knudsen length) [m] */
};

/** Owned: quadrature_free(). */
struct quadrature {
    size_t count;
    struct quadrature_node *node; /* ascending u */
    double beyond_fit;            /* u from which a/R > 0.41 */
    double radius_clamped;        /* u from which a/R is clamped to 1 */
    double log_cut;               /* terms below exp(-log_cut) of the largest are left out */
};

/** int law(sigma_s u) phi(u + d) du over u > 0, without the factor exp(log_factor). */
struct quadrature_sums {
    double area, load;
    double load_beyond_fit, load_radius_clamped; /* on asperities with a/R > 0.41, and > 1 */
    double radius, radius_scale_dependent, log_factor;
};

/** Panels for (4.25), (4.26), (4.43*), (4.46*) and (4.51) under the Gaussian of (4.23), in t = sqrt(u) to remove the
 * square root at u = 0, with breaks where the law changes (1.9 omega_c, a/R = 0.41, a/R = 1); for d >= lowest_d (in
 * sigma_s), to a relative tolerance. knudsen_length_m 0: no scale dependence. lowest_d above about -2000. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code quadrature_make(struct quadrature *out, const struct asperity *asperity, double sigma_s_m,
                                            double knudsen_length_m, double lowest_d, double tolerance,
                                            struct status *status);
void quadrature_free(struct quadrature *panels);

/** All sums at separation d (in sigma_s) under the Gaussian of (4.23), d >= the lowest_d of quadrature_make(). */
void quadrature_sum(struct quadrature_sums *out, const struct quadrature *panels, double d);

/** sum_k law_k u_k^j of the Gaussian at d, j = 0, 1, 2, without exp(*log_factor): they give the derivatives of the
 * integral of the area, or of the load, with respect to d. */
void quadrature_moments(double moment[3], double *log_factor, const struct quadrature *panels, bool area, double d);

/** Mean spot radius over the area of contact, int a³ phi/int a² phi [m], at separation d (in sigma_s). */
double quadrature_mean_radius(const struct quadrature *panels, double d);

#endif
