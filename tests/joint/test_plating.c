/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plating factor against tests/data/golden/models/layer.csv, its Hankel integral, and its limits. */
#include "joint/joint.h"
#include "support.h"

TEST_CASE(matches_reference)
{
    struct table table = table_read("golden/models/layer.csv");
    for (size_t i = 0; i < table.rows; i++) {
        double ratio = table_number(&table, i, "rho_layer_over_substrate");
        assert_cell(plating_factor(table_number(&table, i, "thickness_over_a"), ratio, 1), table, i,
                    "R_over_layer_holm", 1e-10);
    }
}

/** The series as it stands, until its terms no longer count. */
static double plain_sum(double thickness, double ratio)
{
    double q = (1 - ratio) / (1 + ratio), power = 1, sum = 0;
    for (int n = 1; fabs(power) > 1e-18; n++) {
        double u = n * thickness;
        power *= q;
        sum += power * (atan(1 / u) - u / 2 * log1p(1 / (u * u)));
    }
    return 1 + 4 / M_PI * sum;
}

/** The accelerated sum is the sum, also where that takes 10^5 terms. */
TEST_CASE(acceleration_is_exact)
{
    for (double thickness = 1e-5; thickness < 200; thickness *= 3)
        for (double ratio = 1e-3; ratio < 1e3; ratio *= 2.3)
            assert_near(plating_factor(thickness, ratio, 1), plain_sum(thickness, ratio), 1e-12 * fmax(ratio, 1));
}

/** No plating: the body's resistance; a thick one: its own; alike metals: 1; between, monotone; extreme ratios finite.
 */
TEST_CASE(limits)
{
    for (double ratio = 1e-12; ratio < 1e13; ratio *= 10) {
        double none = plating_factor(0, ratio, 1);
        assert_near(none, 1 / ratio, 1e-13 * fmax(ratio, 1));
        assert_near(plating_factor(1e-300, ratio, 1), none, 1e-13 * fmax(ratio, 1));
        assert_near(plating_factor(1e9, ratio, 1), 1, 1e-7);
        double before = none;
        for (double thickness = 1e-6; thickness < 1e3; thickness *= 2) {
            double now = plating_factor(thickness, ratio, 1);
            assert_true(ratio < 1 ? now <= before * (1 + 1e-14) && now >= 1 : now >= before - 1e-14 && now <= 1);
            before = now;
        }
    }
    assert_within(plating_factor(0.3, 2, 2) - 1, 0, 0);
    assert_near(plating_factor(0.3, 1e-8, 4e-8), plating_factor(0.3, 1, 4), 1e-14);
}
