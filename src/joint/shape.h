/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pressure and flux over the nominal area of parts that are not flat: a grid of cells of nx x ny over its sides, with
 * the surface's own curves at uniform pressure as the law in each cell.
 *
 * One operator serves twice (Barber 2003, Proc. R. Soc. Lond. A 459, 53: conductance is incremental stiffness), S[v] =
 * DCT^-1(DCT(v)/|q|), |q| = pi sqrt((i/L_x)² + (j/L_y)²), mean left out: the half space of parts that are mirrored at
 * their edges, so with neither the edge of a punch nor heat through their sides.
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

enum { SHAPE_SIDE_MOST = 1024 };         /* cells */
extern const double shape_largest_area;  /* beyond, a model's gap and resistance are close to 0, and stay */
extern const double shape_yielding_most; /* share of the load in cells at the hardness; beyond, there is no answer */

/** What the surface has at uniform pressure, against ln p: monotone between its points (Steffen 1990, Astron.
 * Astrophys. 239, 443), straight beyond them. Owned: shape_curve_free(). */
struct shape_curve {
    double *ln_pressure, *value; /* p in Pa */
    size_t count;
    double below, above; /* slopes before the first point and behind the last */
    double most_Pa;      /* the hardness, above which no pressure goes; INFINITY: any does */
    gsl_interp *between;
    gsl_interp_accel *nearest;
};

/** The gap [m] at `count` rising pressures. It is made to fall all over, and behind the last point it stays, but for a
 * thousandth of its mean slope. Errors: STATUS_MODEL: fewer than 3 points below the hardness (INFINITY: none), one that
 * is not finite; STATUS_MEMORY. */
MUST_CHECK enum status_code shape_curve_gap(struct shape_curve *out, const double *pressure_Pa, const double *gap_m,
                                            size_t count, double hardness_Pa, struct status *status);
/** ln of a conductance; behind the last point it stays. Errors: the same. */
MUST_CHECK enum status_code shape_curve_conductance(struct shape_curve *out, const double *pressure_Pa,
                                                    const double *conductance, size_t count, struct status *status);
void shape_curve_free(struct shape_curve *curve);
/** Its value, and its slope, which of a gap is never 0. */
double shape_curve_value(double *slope, const struct shape_curve *curve, double ln_pressure);

/** A grid and what was solved on it last. Owned: shape_free(). */
struct shape {
    size_t nx, ny, cells;
    double side_m[2];
    double *pressure_Pa, *ln_pressure; /* of cell i in row j at j nx + i, its middle at (i + 1/2) L_x/nx, ... */
    double *level;                     /* what pressures are solved for: ln(p/(1 - p/H)) */
    double mean_Pa;                    /* of these; 0: none yet */
    double *table;                     /* the operator on the cosines, in the same order */
    double *room;                      /* the fields that the solvers work in, and those above */
    fftw_complex *pair;                /* two fields to transform, in the order of `place` */
    size_t *place;
    double (*turns)[4]; /* cos, sin of what turns a wave's transform to its cosine, and one of n_x - i */
    fftw_plan forth, back;
    size_t steps, iterations; /* Newton's, and of conjugate gradients, that the last call took */
};

/** 2 to SHAPE_SIDE_MOST cells a side. Plans are made with FFTW_ESTIMATE: the same bytes in every thread and run.
 * Errors: STATUS_USAGE: other grids, a side that is no length; STATUS_MEMORY. */
MUST_CHECK enum status_code shape_make(struct shape *out, size_t nx, size_t ny, const double side_m[2],
                                       struct status *status);
void shape_free(struct shape *shape);

/** Fills the pressures under the mean one, beginning from those of the last call, of parts with the gap `gap_m` (g0)
 * when unloaded. None is above the curve's hardness, at which the gap closes as far as it has to. Errors:
 * STATUS_MODEL: it does not converge, the mean pressure is not below the hardness; STATUS_MEMORY. */
MUST_CHECK enum status_code shape_press(struct shape *shape, const double *gap_m, const struct shape_curve *gap,
                                        double effective_modulus_Pa, double mean_Pa, struct status *status);

/** One of the two bodies, as it conducts. */
struct shape_body {
    double resistivity; /* 1/k [m K/W] or rho [ohm m] */
    double thickness_m; /* INFINITY: a half space */
};

/** Resistance [K/W or ohm] through the pressures, of micro and macroscopic constriction together, less what the bodies
 * have themselves; `spots`: the share of it in the spots, -d ln R/d ln h with the same change of h all over. Error:
 * STATUS_MODEL: it does not converge; STATUS_MEMORY. */
MUST_CHECK enum status_code shape_resistance(double *out, double *spots, struct shape *shape,
                                             const struct shape_curve *conductance, const struct shape_body bodies[2],
                                             struct status *status);

/** How the load is spread. */
struct shape_spread {
    double largest_Pa;
    double area;          /* least share of the nominal area that carries 90 % of the load */
    size_t yielding;      /* cells at the hardness, */
    double yielding_load; /* which carry this share of the load */
};
struct shape_spread shape_spread(struct shape *shape, double hardness_Pa);

#endif
