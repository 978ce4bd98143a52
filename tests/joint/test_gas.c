/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gas in the gaps against tests/data/golden/models/gas.csv and gap.csv, and in its limits. */
#include "joint/gas.h"
#include "support.h"

TEST_CASE(table_matches_reference)
{
    struct table table = table_read("golden/models/gas.csv");
    for (size_t i = 0; i < table.rows; i++) {
        const struct gas *gas = gas_find(table_text(&table, i, "gas"));
        assert_non_null(gas);
        double temperature_K = table_number(&table, i, "T_K"), pressure_Pa = table_number(&table, i, "p_Pa");
        double accommodation = table_number(&table, i, "accommodation");
        assert_near(gas->conductivity_W_per_mK, table_number(&table, i, "k_W_per_mK"), 1e-15);
        assert_near(gas_prandtl(gas), table_number(&table, i, "Prandtl"), 1e-12);
        assert_near(gas_mean_free_path(gas, temperature_K, pressure_Pa), table_number(&table, i, "mean_free_path_m"),
                    1e-12);
        assert_near(gas_jump_length(gas, temperature_K, pressure_Pa, accommodation, accommodation),
                    table_number(&table, i, "M_m"), 1e-12);
    }
    table_free(&table);
}

/** Eucken's relation k = mu c_v (9 gamma - 5)/4 holds within 4.1 % (air), 3 % (nitrogen), 1 % (helium, argon): no row
 * has a slip of the pen. Each names its source. */
TEST_CASE(rows_are_consistent)
{
    static const double within[] = {0.041, 0.03, 0.01, 0.01};
    assert_int_equal(gas_count, 4);
    for (size_t i = 0; i < gas_count; i++) {
        const struct gas *gas = &gas_table[i];
        double heat = gas->specific_heat_J_per_kgK / gas->heat_ratio;
        assert_near(gas->viscosity_Pa_s * heat * (9 * gas->heat_ratio - 5) / 4, gas->conductivity_W_per_mK, within[i]);
        double gas_constant = 8.314462618 / gas->molar_mass_kg; /* c_p - c_v of an ideal gas */
        assert_near(gas->specific_heat_J_per_kgK - heat, gas_constant, 0.01);
        assert_true(strlen(gas->source) > 0);
        assert_ptr_equal(gas_find(gas->name), gas);
    }
    assert_ptr_equal(gas_find("Argon"), &gas_table[3]);
    assert_null(gas_find("xenon"));
}

TEST_CASE(integral_matches_reference)
{
    struct table table = table_read("golden/models/gap.csv");
    for (size_t i = 0; i < table.rows; i++) {
        double y = table_number(&table, i, "Y_over_sigma"), m = table_number(&table, i, "M_over_sigma");
        double reference = table_number(&table, i, "integral");
        assert_near(gas_gap_integral(y, m, 1e-12), reference, 1e-10);
        assert_near(gas_gap_integral(y, m, 1e-6), reference, 1e-6);
    }
    table_free(&table);
}

/** Wide gaps or long jumps: 1/(Y + M), with the variance of the gaps; a vanishing jump: its logarithm, phi(Y) ln(1/M);
 * it falls with Y (from 2 sigma on) and with M; no jump is too short or long. */
TEST_CASE(integral_limits)
{
    for (double y = 30; y < 1e6; y *= 7)
        assert_near(gas_gap_integral(y, 0.1, 1e-12), (1 + 1 / ((y + 0.1) * (y + 0.1))) / (y + 0.1),
                    4 / (y * y * y * y) + 1e-12);
    assert_near(gas_gap_integral(8, 1e9, 1e-12), 1e-9, 1e-8);
    assert_near(gas_gap_integral(0, 1e9, 1e-12), 0.5e-9, 1e-8);
    double slope = (gas_gap_integral(1, 1e-14, 1e-12) - gas_gap_integral(1, 1e-12, 1e-12)) / log(100);
    assert_near(slope, exp(-0.5) / sqrt(2 * M_PI), 1e-9);
    for (double m = 1e-9; m < 1e6; m *= 3) {
        assert_true(gas_gap_integral(1.5, m, 1e-9) > gas_gap_integral(1.5, 1.5 * m, 1e-9));
        for (double y = 0; y < 40; y += 0.7) {
            assert_true(gas_gap_integral(y, m, 1e-9) > 0);
            assert_true(y < 2 || m > 1 || gas_gap_integral(y, m, 1e-9) > gas_gap_integral(y + 0.7, m, 1e-9));
        }
    }
}

/** The part that touches has no gap; negative separations count as none; a smooth gap is k/(Y + M); vacuum is nothing;
 * half the pressure doubles the jump. */
TEST_CASE(conductance)
{
    const struct gas *air = gas_find("air");
    double jump_m = gas_jump_length(air, 300, 101325, 0.87, 0.87);
    double h = gas_conductance(air, 1e-6, 3e-6, jump_m, 0, 1e-10);
    assert_near(h, 0.0263 / 1e-6 * gas_gap_integral(3, jump_m / 1e-6, 1e-12), 1e-9);
    assert_near(gas_conductance(air, 1e-6, 3e-6, jump_m, 0.25, 1e-10), 0.75 * h, 1e-12);
    assert_near(gas_conductance(air, 1e-6, -3e-6, jump_m, 0, 1e-10), gas_conductance(air, 1e-6, 0, jump_m, 0, 1e-10),
                0);
    assert_near(gas_conductance(air, 0, 3e-6, jump_m, 0, 1e-10), 0.0263 / (3e-6 + jump_m), 1e-14);
    assert_near(gas_conductance(air, 1e-12, 3e-6, jump_m, 0, 1e-10), 0.0263 / (3e-6 + jump_m), 1e-9);
    assert_within(gas_conductance(air, 1e-6, 3e-6, gas_jump_length(air, 300, 0, 0.87, 0.87), 0, 1e-10), 0, 0);
    assert_within(gas_conductance(air, 1e-6, 3e-6, jump_m, 1, 1e-10), 0, 0);
    assert_near(gas_jump_length(air, 300, 101325.0 / 2, 0.87, 0.87), 2 * jump_m, 1e-14);
    assert_near(gas_jump_length(air, 600, 101325, 0.87, 0.87), 2 * jump_m, 1e-14);
}
