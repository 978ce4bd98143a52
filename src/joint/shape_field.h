/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A field over the nominal area in place of a bulge: a measured gap, pressures from elsewhere, or bolts. */
#ifndef JOINT_SHAPE_FIELD_H
#define JOINT_SHAPE_FIELD_H

#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>

/** Gap of the unloaded parts [m], or pressure [Pa]. Owned: shape_field_free(). */
struct shape_field {
    size_t nx, ny; /* cells; ny = 0: nx parts of the area whose places are not known */
    double *value; /* of cell i in row j at j nx + i */
    double *share; /* of parts without a place: share of the nominal area, by falling pressure; else NULL */
    double mean;   /* over the nominal area */
};
void shape_field_free(struct shape_field *field);

/** Values at ascending x and y from a corner of the area: that of column i in row j at j count[0] + i. */
struct shape_grid {
    const double *at_m[2];
    size_t count[2];
    const double *value;
    bool cells[2]; /* constant half way to the neighbours; else straight between them and constant beyond the outermost
                    */
};

/** The exact mean of a grid over each cell of the field. Errors: STATUS_MEMORY; fewer than 2 places a side:
 * STATUS_MODEL. */
MUST_CHECK enum status_code shape_field_grid(struct shape_field *out, const struct shape_grid *grid,
                                             const double side_m[2], struct status *status);

/** Bolts of one kind. */
struct shape_bolts {
    double (*middle_m)[2]; /* from a corner of the area */
    size_t count;
    double force_N; /* of each */
    double hole_m;  /* radius of the hole */
    double reach_m; /* radius of the pressure cone at the joint */
};

/** Pressure [Pa] at the distance r [m] from the middle of one bolt (Fernlund 1961, Trans. Chalmers Univ. Technol. 245):
 * a polynomial of order four, with slope 0 at the hole b and value, slope and curvature 0 at the reach c: p = 5F/(pi
 * (c-b)^5 (c+3b)) (c-r)³ (3r+c-4b). Reach: a cone of 45° from under the head through the thinner part (Rötscher 1927,
 * Die Maschinenelemente). */
double shape_bolt_pressure(const struct shape_bolts *bolts, double r_m);
/** The pressures of all bolts, each with its whole force inside the area. Errors: STATUS_MODEL: one that presses on no
 * cell; STATUS_MEMORY. */
MUST_CHECK enum status_code shape_field_bolts(struct shape_field *out, const struct shape_bolts *bolts,
                                              const double side_m[2], struct status *status);

/** Pressures [Pa] of cells or parts at a mean pressure: those of the field, scaled; of several fields (rising mean,
 * same cells) shares interpolated over ln of the mean, beyond the outermost those of that one. */
void shape_field_press(double *out, const struct shape_field *field, size_t count, double mean_Pa);

#endif
