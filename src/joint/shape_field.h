/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What stands over the nominal area in place of a bulge: a measured gap, pressures from elsewhere, or bolts. */
#ifndef JOINT_SHAPE_FIELD_H
#define JOINT_SHAPE_FIELD_H

#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>

/** Gap of the unloaded parts [m], or pressure [Pa]. Owned: shape_field_free(). */
struct shape_field {
    size_t nx, ny; /* cells; ny 0: nx parts of the area that have no place */
    double *value; /* of cell i in row j at j nx + i */
    double *share; /* of the nominal area, where they have no place: by falling pressure; else NULL */
    double mean;   /* over the nominal area */
};
void shape_field_free(struct shape_field *field);

/** Values at ascending places x_m and y_m from a corner of the area: of place i in row j at j count[0] + i. */
struct shape_grid {
    const double *at_m[2];
    size_t count[2];
    const double *value;
    bool cells[2]; /* each holds half way to its neighbours; else it is straight between them, the outermost beyond */
};

/** Means of a grid over each cell of the field, exact, so that nothing of it is lost or added. Errors: STATUS_MEMORY;
 * fewer than 2 places a side: STATUS_MODEL. */
MUST_CHECK enum status_code shape_field_grid(struct shape_field *out, const struct shape_grid *grid,
                                             const double side_m[2], struct status *status);

/** Bolts that are alike. */
struct shape_bolts {
    double (*middle_m)[2]; /* from a corner of the area */
    size_t count;
    double force_N; /* of each */
    double hole_m;  /* radius of the hole, */
    double reach_m; /* and of what the pressed cone has at the joint */
};

/** Pressure [Pa] at the distance r [m] from the middle of one bolt, of Fernlund 1961 (Trans. Chalmers Univ. Technol.
 * 245): a polynomial of order four from the hole b, where its slope is 0, to the reach c, where it ends with its slope
 * and curvature, so p = 5F/(pi (c-b)^5 (c+3b)) (c-r)³ (3r+c-4b). Reach: Rötscher 1927 (Die Maschinenelemente),
 * a cone of 45° from under the head through the thinner part. */
double shape_bolt_pressure(const struct shape_bolts *bolts, double r_m);
/** All bolts: each with its whole force, of which none leaves the area. Errors: STATUS_MODEL: one that presses on no
 * cell; STATUS_MEMORY. */
MUST_CHECK enum status_code shape_field_bolts(struct shape_field *out, const struct shape_bolts *bolts,
                                              const double side_m[2], struct status *status);

/** Pressures `out` [Pa] of field[0]'s cells or parts under the mean one: the field's, of several (of rising mean and
 * the same cells) between their logarithms' neighbours, and the outermost's beyond, grown with the load. */
void shape_field_press(double *out, const struct shape_field *field, size_t count, double mean_Pa);

#endif
