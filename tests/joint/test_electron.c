/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Electrons' mean free path and small spots against tests/data/golden/models/electron.csv and sharvin_wexler.csv. */
#include "base/constants.h"
#include "joint/electron.h"
#include "support.h"

TEST_CASE(paths_match_reference)
{
    static const char *const names[] = {"Cu", "copper", "Ag", "silver", "Au", "gold", "Al", "aluminium", "Sn", "tin"};
    struct table table = table_read("golden/models/electron.csv");
    for (size_t i = 0; i < table.rows; i++) {
        const char *name = NULL;
        for (size_t k = 0; k < sizeof names / sizeof names[0]; k += 2)
            if (strcmp(names[k], table_text(&table, i, "metal")) == 0)
                name = names[k + 1];
        const struct electron_metal *metal = electron_metal_find(name);
        assert_non_null(metal);
        assert_near(metal->density_per_m3, table_number(&table, i, "electrons_per_m3"), 1e-15);
        /* the reference took hbar to ten digits, 1.054571817e-34 J s; it is h/(2 pi) exactly */
        double hbar = constant_planck_J_s / (2 * M_PI) / 1.054571817e-34;
        assert_near(electron_resistivity_path(metal->density_per_m3),
                    table_number(&table, i, "rho_lambda_ohm_m2") * hbar, 1e-12);
        assert_near(electron_mean_free_path(metal->density_per_m3, table_number(&table, i, "rho_ohm_m")),
                    table_number(&table, i, "lambda_m") * hbar, 1e-12);
    }
    assert_null(electron_metal_find("ice"));
    table_free(&table);
}

TEST_CASE(spots_match_reference)
{
    struct table table = table_read("golden/models/sharvin_wexler.csv");
    for (size_t i = 0; i < table.rows; i++) {
        double rho = table_number(&table, i, "rho_ohm_m"), path = table_number(&table, i, "mean_free_path_m");
        double radius = table_number(&table, i, "a_m"), resistance = electron_spot_resistance(rho, path, radius);
        assert_near(resistance, table_number(&table, i, "R_wexler_ohm"), 1e-12);
        double plain = table_number(&table, i, "maxwell_ohm") + table_number(&table, i, "sharvin_ohm");
        assert_near(plain, table_number(&table, i, "R_gamma1_ohm"), 1e-12);
        assert_true(resistance < plain && plain < 1.135 * resistance); /* Gamma = 1 is at most 13 % more */
    }
    table_free(&table);
}

/** Large spots: Holm's rho/(2a); small ones: Sharvin's, plus 0.624 of Holm's. */
TEST_CASE(limits)
{
    assert_near(electron_spot_resistance(2e-8, 4e-8, 1), 1e-8, 1e-6);
    assert_near(electron_spot_resistance(2e-8, 0, 1e-6), 1e-2, 1e-15);
    assert_near(electron_spot_resistance(2e-8, 4e-8, 1e-12) - 4 * 2e-8 * 4e-8 / (3 * M_PI * 1e-24), 0.83 / 1.33 * 1e4,
                1e-3);
}
