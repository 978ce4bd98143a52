/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pressure and flux over the nominal area of parts that are not flat: a grid of nx x ny cells, in each of which gap and
 * conductance follow the local pressure as they do on the flat surface.
 *
 * One operator serves pressure and heat (Barber 2003, Proc. R. Soc. Lond. A 459, 53: conductance is incremental
 * stiffness), S[v] = DCT^-1(DCT(v)/|q|), |q| = pi sqrt((i/L_x)² + (j/L_y)²), without the mean: half spaces mirrored at
 * the edges of the area, so that no pressure peaks at an edge and no heat leaves through the sides.
 *   mechanics   u(p) = g0 + (2/E') S[p] - d, mean p = P/A_n    (Johnson 1985, Contact Mechanics, sec. 13.2)
 *   heat        q/h(p) + (1/k_1 + 1/k_2) S[q] = T,  R = T/sum q dA
 * u: the surface's gap under p, d: approach, g0: gap of the unloaded parts. Current: the same, with resistivities for
 * 1/k. A body of thickness t whose far side has one temperature has tanh(|q| t)/|q| in place of 1/|q|. */
#ifndef JOINT_SHAPE_H
#define JOINT_SHAPE_H

#include "base/status.h"
#include <fftw3.h>
#include <gsl/gsl_interp.h>
#include <stddef.h>

extern const double shape_largest_area;  /* area ratio above which a model's curves are not used: all is close to 0 */
extern const double shape_yielding_most; /* share of the load in cells at the hardness; above it there is no answer */

/** A property of the surface at uniform pressure, over ln p: monotone between its points (Steffen 1990, Astron.
 * Astrophys. 239, 443), straight beyond them. Owned: shape_curve_free(). */
struct shape_curve {
    double *ln_pressure, *value; /* p in Pa */
    size_t count;
    double below, above; /* slopes before the first point and after the last */
    double most_Pa;      /* the hardness, the largest pressure; INFINITY: none */
    gsl_interp *between;
    gsl_interp_accel *nearest;
};

/** The gap [m] at `count` rising pressures. It is made to fall everywhere by at least a thousandth of its mean slope,
 * by which alone it falls after the last point. Errors: STATUS_MODEL: fewer than 3 points below the hardness (INFINITY:
 * none), one that is not finite; STATUS_MEMORY. */
MUST_CHECK enum status_code shape_curve_gap(struct shape_curve *out, const double *pressure_Pa, const double *gap_m,
                                            size_t count, double hardness_Pa, struct status *status);
/** ln of a conductance, constant after the last point. Errors: the same. */
MUST_CHECK enum status_code shape_curve_conductance(struct shape_curve *out, const double *pressure_Pa,
                                                    const double *conductance, size_t count, struct status *status);
void shape_curve_free(struct shape_curve *curve);
/** Value and slope; the slope of a gap is never 0. */
double shape_curve_value(double *slope, const struct shape_curve *curve, double ln_pressure);

/** A grid and the last solution on it. Owned: shape_free(). */
struct shape {
    size_t nx, ny, cells;
    double side_m[2];
    double *pressure_Pa, *ln_pressure; /* of cell i in row j at j nx + i, its middle at (i + 1/2) L_x/nx, ... */
    double *level;                     /* the unknown, ln(p/(1 - p/H)) */
    double mean_Pa;                    /* mean of the pressures; 0: none yet */
    double *table;                     /* the factors of the operator, one a cosine, in the same order */
    double *room;                      /* working fields of the solvers, and the four above */
    fftw_complex *pair;                /* two fields to transform, in the order of `place` */
    size_t *place;
    double (*turns)[4]; /* cos and sin of the angle that makes a Fourier mode a cosine, and those of n_x - i */
    fftw_plan forth, back;
    size_t steps; /* of Newton's method that the last shape_press() took */
};

/** Two cells a side at least. FFTW_ESTIMATE makes the result the same in every thread and run. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code shape_make(struct shape *out, size_t nx, size_t ny, const double side_m[2],
                                       struct status *status);
void shape_free(struct shape *shape);

/** Solves for the pressures of mean mean_Pa, starting from those of the last call; gap_m is g0. No pressure exceeds the
 * hardness, where the gap closes as far as it must. Errors: STATUS_MODEL: no convergence, mean pressure not below the
 * hardness; STATUS_MEMORY. */
MUST_CHECK enum status_code shape_press(struct shape *shape, const double *gap_m, const struct shape_curve *gap,
                                        double effective_modulus_Pa, double mean_Pa, struct status *status);

/** How one of the two bodies conducts. */
struct shape_body {
    double resistivity; /* 1/k [m K/W] or rho [ohm m] */
    double thickness_m; /* INFINITY: a half space */
};

/** Resistance [K/W or ohm] at these pressures, of micro- and macroscopic constriction together, without that of uniform
 * flow through the bodies. `spots`: the share of the spots, -d ln R/d ln h for one relative change of h everywhere.
 * Error: STATUS_MODEL: no convergence; STATUS_MEMORY. */
MUST_CHECK enum status_code shape_resistance(double *out, double *spots, struct shape *shape,
                                             const struct shape_curve *conductance, const struct shape_body bodies[2],
                                             struct status *status);

/** How the load is spread. */
struct shape_spread {
    double largest_Pa;
    double area;          /* least share of the nominal area that carries 90 % of the load */
    double yielding_load; /* share of the load in cells at the hardness */
};
struct shape_spread shape_spread(struct shape *shape, double hardness_Pa);

#endif
