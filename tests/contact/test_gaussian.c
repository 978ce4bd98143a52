/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/gaussian.h"
#include "support.h"

TEST_CASE(matches_reference)
{
    struct table table = table_read("golden/gaussian_integrals.csv");
    for (size_t i = 0; i < table.rows; i++) {
        struct gaussian_integrals f = gaussian_integrals(table_number(&table, i, "h"));
        double factor = exp(f.log_factor);
        assert_near(f.half * factor, table_number(&table, i, "F_half"), 1e-12);
        assert_near(f.one * factor, table_number(&table, i, "F_one"), 1e-12);
        assert_near(f.three_halves * factor, table_number(&table, i, "F_three_halves"), 1e-12);
    }
}

/** At the borders of all panels and within each, and far to both sides. */
TEST_CASE(panels_match_reference)
{
    struct table table = table_read("golden/gaussian_panels.csv");
    assert_true(table.rows > 140);
    for (size_t i = 0; i < table.rows; i++) {
        double h = table_number(&table, i, "h");
        struct gaussian_integrals f = gaussian_integrals(h);
        assert_true(f.log_factor == (h < 1 ? 0 : -h * h / 2));
        assert_near(f.zero, table_number(&table, i, "F_zero"), 1e-13);
        assert_near(f.half, table_number(&table, i, "F_half"), 1e-13);
        assert_near(f.one, table_number(&table, i, "F_one"), 1e-13);
        assert_near(f.three_halves, table_number(&table, i, "F_three_halves"), 1e-13);
    }
}

/** Far out the ratios stay right though the integrals are below 10^-300: F_{3/2}/F_{1/2} -> 1.5/h (1 - 3/h² ...). */
TEST_CASE(ratios_survive_underflow)
{
    for (double h = 20; h < 1e4; h *= 1.7) {
        struct gaussian_integrals f = gaussian_integrals(h);
        double x = 1 / (h * h);
        /* int u^n e^{-u - u² x/2} du to third order in x, n = 3/2 over n = 1/2 */
        double upper = 1 - 35.0 / 8 * x + 3465.0 / 128 * x * x, lower = 1 - 15.0 / 8 * x + 945.0 / 128 * x * x;
        assert_near(f.three_halves / f.half * h, 1.5 * upper / lower, 400 * x * x * x + 1e-13);
        assert_true(f.log_factor == -h * h / 2);
    }
}
