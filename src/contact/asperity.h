/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One spherical asperity pressed by omega (4.27-4.38, 4.45); docs/equations.md, Statistical models. */
#ifndef CONTACT_ASPERITY_H
#define CONTACT_ASPERITY_H

#include "material/material.h"
#include <stdbool.h>

/** An asperity of radius R in a material: everything that does not depend on the interference. */
struct asperity {
    double radius_m;
    double effective_modulus_Pa;
    double critical_interference_m; /* omega_c (4.31); INFINITY for Hertz's law */
    double critical_load_N;         /* P_c (4.34) */
    double area_exponent;           /* B (4.35) */
    double yield_coefficient;       /* C */
};

struct asperity_contact {
    double area_m2;
    double load_N;
    double radius_m; /* of the contact spot: sqrt(D R omega) (4.45) */
};

extern const double asperity_yield_onset;         /* 1.9: omega/omega_c up to which JG is Hertz's law (4.32) */
extern const double asperity_fitted_radius_ratio; /* 0.41: a/R up to which JG was fitted */

/** An asperity of radius R by Hertz's law or, if `plastic`, by Jackson and Green's: omega_c (4.31), P_c (4.34), B
 * (4.35) of e_y (4.36). */
struct asperity asperity_make(double radius_m, const struct material_pair *pair, bool plastic);

/** Contact at interference omega >= 0 [m]. Hertz 1882: A = pi R omega (4.27), P = (4/3) E' sqrt(R) omega^(3/2) (4.28),
 * a = sqrt(R omega). Jackson and Green 2005, 2006: the same below 1.9 omega_c; else (4.32*), (4.33*), with a/R of
 * (4.38*). */
struct asperity_contact asperity_press(const struct asperity *asperity, double interference_m);

/** Interference [m] at which the elastic-plastic contact radius reaches `ratio` R (not below 1.9 omega_c), from
 * a/R = sqrt[(omega/R)(omega/1.9 omega_c)^B] (4.38*). INFINITY for Hertz's law. */
double asperity_interference_at(const struct asperity *asperity, double ratio);

#endif
