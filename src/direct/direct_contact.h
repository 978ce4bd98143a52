/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contact of an elastic half space with a rigid rough surface, periodic, frictionless, without adhesion, by boundary
 * elements: conjugate gradients on the set of points in contact, projected onto the bounds of the pressure.
 *
 * h height of the roughness, p pressure, u = K p displacement (direct_kernel.h), g = u - h - lambda gap, lambda
 * constant. All pressures are over the effective modulus E'. For a mean pressure p̄ the solution meets elastic: p >= 0,
 * g >= 0, p g = 0, mean p = p̄; with a hardness:  0 <= p <= H; g >= 0 where p = 0, g = 0 where 0 < p < H, g <= 0 where p
 * = H (what overlaps has flowed; Almqvist, Sahlin, Larsson and Glavatskih, Tribol. Int. 40 (2007) 574). Both are the
 * conditions of min 1/2 <p, K p> - <p, h> over 0 <= p <= H, mean p = p̄, strictly convex: the solution on a grid is
 * unique.
 */
#ifndef DIRECT_CONTACT_H
#define DIRECT_CONTACT_H

#include "direct/direct_kernel.h"

#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

/** A surface and the state of its contact. Fields have the rows and the stride of the kernel: the point (i along x, j
 * along y) is at j stride + i. About 67 bytes a point, and while patches are counted 4 a point with its mirror images,
 * while constriction is solved 8 a point in contact. Owned: direct_contact_free(). */
struct direct_contact {
    struct direct_kernel kernel;
    double *height_m;
    double *pressure;              /* p/E' */
    double *gap_m;                 /* g; negative where the surface has flowed */
    double *direction;             /* search direction of the solver */
    double *response;              /* of a strip: d(pressure)/d(mean pressure) when last found; else NULL */
    uint32_t *set;                 /* the points the solver works on: their places in a field, ascending */
    uint8_t *taken;                /* of one row: whether a point's pressure and gap put it into the set */
    uint8_t *member;               /* whether a point is in the set; between solutions, whether it is in contact */
    uint8_t *rows;                 /* whether a row has points of the set */
    struct direct_contact *coarse; /* every second point of every second row; NULL: too few points */
    size_t set_count;
    double rms_m;                    /* root mean square of the height about its mean */
    bool solved;                     /* pressure and gap_m hold a solution from which the next may start */
    bool capped;                     /* that solution reaches its hardness */
    size_t iterations, convolutions; /* of the last load, with its constriction */
};

/** What to solve for. */
struct direct_contact_load {
    double mean_pressure;    /* p̄/E' */
    double hardness;         /* H/E'; INFINITY: elastic */
    double tolerance;        /* largest violation of the conditions, as a share of rms_m: 1e-6 finds the right set */
    bool warm;               /* start from the last solution if there is one */
    const atomic_bool *stop; /* non-zero: end early; NULL: never. Looked at once an iteration */
};

/** Takes a copy of the heights at a grid's points. Errors: those of direct_kernel_make(); STATUS_MODEL: a height that
 * is not finite, or a flat surface. */
MUST_CHECK enum status_code direct_contact_make(struct direct_contact *out, const double *height_m,
                                                const struct direct_grid *grid, struct status *status);
void direct_contact_free(struct direct_contact *contact);

/** Solves for one load. Method: Polonsky and Keer, Wear 231 (1999) 206, with points that violate a condition in one set
 * with the others and, for elastic contact, the preconditioner |q|E'/2 on the set. Elastic contact starts from the
 * solution on the coarse grid, contact with a hardness from the elastic one. Errors: STATUS_MODEL: p̄ >= H (complete
 * contact, which the hardness does not define), a load that is no positive number, no convergence; STATUS_INTERRUPTED.
 */
MUST_CHECK enum status_code direct_contact_solve(struct direct_contact *contact, const struct direct_contact_load *load,
                                                 struct status *status);

/** Empties the kernel's field, for values on the set that are then stiffened. */
void direct_contact_clear(struct direct_contact *contact);
/** Multiplies values on the set (the field, 0 elsewhere) by about the inverse of the compliance on the set: |q| on the
 * set. In a strip the values are first continued linearly from edge to edge across what lies between (E), and E
 * transposed |q| E is taken: without jumps at the edges, which |q| would turn into spikes. */
void direct_contact_stiffen(struct direct_contact *contact);

/** Makes the set: the points under pressure, or all. */
void direct_contact_select(struct direct_contact *contact, bool all);

/** Whether the bodies touch (p > 0), ny rows of nx; belongs to the contact, until it is solved again. */
const uint8_t *direct_contact_touching(struct direct_contact *contact);

#endif
