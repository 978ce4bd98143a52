/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Electrons' mean free path against tests/data/golden/models/electron.csv. */
#include "base/constants.h"
#include "material/material.h"
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
        const struct material *metal = material_find(name);
        assert_non_null(metal);
        assert_cell(metal->electrons_per_m3, table, i, "electrons_per_m3", 1e-15);
        /* the reference took hbar to ten digits, 1.054571817e-34 J s; it is h/(2 pi) exactly */
        double hbar = constant_planck_J_s / (2 * M_PI) / 1.054571817e-34;
        assert_near(electron_mean_free_path(metal->electrons_per_m3, table_number(&table, i, "rho_ohm_m")),
                    table_number(&table, i, "lambda_m") * hbar, 1e-12);
    }
    assert_true(material_find("steel")->electrons_per_m3 == 0);
}
