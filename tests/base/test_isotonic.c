/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/isotonic.h"
#include "support.h"

/** Pooled neighbours by hand, both ways, among other values. */
TEST_CASE(pooled_neighbours)
{
    double value[] = {1, 9, 3, 9, 2, 9, 4, 9, 0, 9};
    static const double rising[] = {1, 9, 2.25, 9, 2.25, 9, 2.25, 9, 2.25, 9};
    isotonic(value, 5, 2, false);
    for (size_t k = 0; k < 10; k++)
        assert_near(value[k], rising[k], 1e-15);
    double other[] = {5, 6, 7, 1, 2, 0};
    static const double falling[] = {6, 6, 6, 1.5, 1.5, 0};
    isotonic(other, 6, 1, true);
    for (size_t k = 0; k < 6; k++)
        assert_near(other[k], falling[k], 1e-15);
}
