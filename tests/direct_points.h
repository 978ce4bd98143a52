/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rough surfaces to be solved, and answers of the direct solution found in two ways. */
#ifndef TEST_DIRECT_POINTS_H
#define TEST_DIRECT_POINTS_H

#include "direct/direct_quantities.h"
#include "direct/direct_surface.h"
#include "support.h"

/* Variance of modes: flat up to band[0] waves in the cell, falling as r^-band[2] (3.6: Hurst exponent 0.8) up to
 * band[1], and none above. */
static inline double band_variance(double r, const void *context)
{
    const double *band = context;
    return r > band[1] ? 0 : pow(fmax(r, band[0]), -band[2]);
}

/* n x n heights of rms 1 with that variance. The test's. */
static inline double *band_surface(size_t n, const double band[3], uint64_t seed)
{
    double *height = support_room(n * n * sizeof *height), square = 0;
    expect_ok(direct_surface_make, height, n, &(struct direct_recipe){band_variance, band, NULL, 0}, seed);
    for (size_t k = 0; k < n * n; k++)
        square += height[k] * height[k] / (double)(n * n);
    for (size_t k = 0; k < n * n; k++)
        height[k] /= sqrt(square);
    return height;
}

/* The same contact at each of `count` loads: points counted alike, numbers but for rounding. */
static inline void expect_same(const struct direct_point *found, const struct direct_point *expected, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const struct direct_quantities *a = &found[i].quantities, *b = &expected[i].quantities;
        assert_int_equal(found[i].exists, expected[i].exists);
        if (!expected[i].exists)
            continue;
        assert_int_equal(a->contact_points, b->contact_points);
        assert_int_equal(a->perimeter_faces, b->perimeter_faces);
        assert_int_equal(found[i].patches, expected[i].patches);
        assert_near(a->area_ratio, b->area_ratio, 1e-12);
        assert_near(a->gap_m, b->gap_m, 1e-9);
        assert_near(found[i].constriction_m, expected[i].constriction_m, 1e-9);
    }
}

#endif
