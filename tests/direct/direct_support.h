/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the tests of the direct solution share. */
#ifndef DIRECT_SUPPORT_H
#define DIRECT_SUPPORT_H

#include "direct/direct_quantities.h"
#include "direct/direct_surface.h"
#include "support.h"

/** P(i, j) in proportion to max(r², 4)^-1.8, r² = i² + j² <= 256, scaled to an rms gradient of 1 in a cell of length 1.
 */
double recipe_variance(double r, const void *scale);
/** The scale for it. */
double recipe_scale(void);
/** The recipe surface, seed 1. To be freed. */
double *recipe_surface(size_t n);

/** A wave along x, ny rows of nx points, its crest off them. To be freed. */
double *wave_of(size_t nx, size_t ny, double amplitude);
/** A paraboloid of radius 1 amid n x n points, its apex off them, and its mean height. To be freed. */
double *paraboloid_of(size_t n, double *mean);

/** Root mean square gradient of a periodic square, by central differences. */
double gradient_of(const double *height, size_t n, double spacing);

/** A contact of ny rows of nx heights, cell length 1 along x; fails the test when it cannot be made. */
struct direct_contact contact_of(const double *height, size_t nx, size_t ny);

/** A load without warm start. */
struct direct_contact_load load_of(double mean_pressure, double hardness, double tolerance);

/** Solves and takes the quantities; fails the test when it cannot. */
struct direct_quantities solved(struct direct_contact *contact, const struct direct_contact_load *load);

/** Constriction length of a contact just solved. */
double constriction_of(struct direct_contact *contact, double tolerance);

/** Constriction length of n x n points drawn, 1 in contact, in a cell of length 1; how many iterations to 1e-9. */
double constriction_of_drawing(const uint8_t *drawing, size_t n, size_t *iterations);

/** The same of the twenty spots of golden/direct/greenwood_spots.csv. */
double twenty_spots_of(size_t n);

double largest_pressure(const struct direct_contact *contact);

/** Points at the hardness, and the mean gap where what overlaps counts, just after a solution. */
struct overlap {
    size_t capped_points;
    double plane_gap_m;
};
struct overlap overlap_of(const struct direct_contact *contact, double hardness);

/** Largest violation of the conditions of contact, by a gap computed anew with the pixel's sums left to FFTW alone: the
 * pressure's bounds and mean, and the gap's sign on each side, as a share of the heights' rms. */
double violation_of(const struct direct_contact *contact, const struct direct_contact_load *load);

#endif
