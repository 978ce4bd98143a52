/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Answers of the direct solution found in two ways. */
#ifndef TEST_DIRECT_POINTS_H
#define TEST_DIRECT_POINTS_H

#include "direct/direct_quantities.h"
#include "support.h"

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
