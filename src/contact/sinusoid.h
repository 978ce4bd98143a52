/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One scale of a rough surface pressed flat: a double-sinusoidal surface Delta cos(2 pi f x) cos(2 pi f y) against a
 * flat (4.3-4.18); docs/equations.md, One sinusoidal scale. Area ratio is real area / cell area, 0...1. */
#ifndef CONTACT_SINUSOID_H
#define CONTACT_SINUSOID_H

#include "material/material.h"
#include <stdbool.h>

/** Area and gap of one cell at one pressure. */
struct sinusoid_cell {
    double area_ratio;      /* a */
    double area_complement; /* 1 - a, without cancellation as a -> 1 */
    double gap_ratio;       /* mean gap / amplitude G, 1...0 */
    bool limited;           /* the published plastic area (4.17) was cut off at 1, or raised to the elastic area */
};

enum sinusoid_fit_id { SINUSOID_FIT_THESIS, SINUSOID_FIT_NUMERIC, SINUSOID_FIT_COUNT };

/** A law for the elastic cell ("closure"): x = mean pressure / p*. */
struct sinusoid_fit {
    const char *name;    /* scene spelling */
    bool floors_plastic; /* (4.17), made to meet closure thesis, may fall below this closure's elastic area */
    void (*area)(struct sinusoid_cell *cell, double x); /* area ratio and complement alone, x > 0 */
    double (*gap)(double x);                            /* gap ratio, x > 0 */
};

/** Closure `numeric`. */
void sinusoid_numeric_area(struct sinusoid_cell *cell, double x);
double sinusoid_numeric_gap(double x);

extern const struct sinusoid_fit sinusoid_fits[SINUSOID_FIT_COUNT]; /* indexed by enum sinusoid_fit_id */

/** One scale: everything that does not depend on the load. */
struct sinusoid_scale {
    double amplitude_m;              /* Delta >= 0 */
    double frequency_per_m;          /* f > 0 */
    double full_pressure_Pa;         /* p* (4.7) */
    double critical_pressure_Pa;     /* p_c (4.14); INFINITY: elastic at any load */
    double plastic_full_pressure_Pa; /* p_p (4.18) */
    double plastic_area_log;         /* ln a_p (4.15) at p_p; elsewhere (p/p_p)^(q/(1+q)) times it */
    double plastic_area_exponent;    /* q/(1+q) (4.16) */
};

/** p* = sqrt2 pi E' Delta f [Pa] (4.7*). */
double sinusoid_full_pressure(double amplitude_m, double frequency_per_m, double effective_modulus_Pa);

/** Delta_c = sqrt2 S_y exp(2 nu/3) / (3 pi E' f) [m] (with 4.18): up to it a scale is elastic at any load. */
double sinusoid_critical_amplitude(double frequency_per_m, const struct material_pair *pair);

/** Prepares a scale: p* (4.7*); p_c (4.14*, from the critical load 4.12*); factor and exponent of a_p (4.15) from A_c
 * (4.13*) and q (4.16); p_p (4.18). Elastic at any load unless `plastic`. */
struct sinusoid_scale sinusoid_scale(double amplitude_m, double frequency_per_m, const struct material_pair *pair,
                                     bool plastic);

/** Lowest mean pressure [Pa] at which the scale is closed: area ratio 1 and gap 0 (p* or p_p). */
double sinusoid_closed_pressure(const struct sinusoid_scale *scale);

/** Mean pressure [Pa] above which elastic-plastic scales close in the order of their slopes Delta f: p* and p_p depend
 * on the slope alone and rise with it. p_c falls with it, but wherever it matters (p_c < p*) it is below this pressure,
 * and so is p* of the scales that are elastic at any load. */
double sinusoid_ordered_pressure(const struct material_pair *pair);

/** Lowest mean pressure [Pa] with area ratio 1. Elastic: p*. Plastic: the published area (4.17) may reach 1 below p_p,
 * while a gap is left. */
double sinusoid_full_area_pressure(const struct sinusoid_scale *scale);

/** Area (and, when `with_gap`, gap) at mean pressure p > 0 [Pa]; returns whether the scale yields. Elastic: (4.5),
 * (4.6), (4.10); plastic: (4.17*) with (4.15), at most 1 and, with closure `numeric`, at least the elastic area, since
 * yield adds contact. The area never falls with p, except by 0.05 % at p/p* = 0.8 in closure `thesis`, as published. */
bool sinusoid_press(struct sinusoid_cell *cell, const struct sinusoid_scale *scale, const struct sinusoid_fit *closure,
                    double pressure_Pa, bool with_gap);

#endif
