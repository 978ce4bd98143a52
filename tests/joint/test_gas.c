/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gas in the gaps against tests/data/golden/models/gas.csv and gap.csv, and in its limits. */
#include "joint/gas.h"
#include "support.h"

TEST_CASE(table_matches_reference)
{
    struct table table = table_read("golden/models/gas.csv");
    for (size_t i = 0; i < table.rows; i++) {
        const struct gas *gas = gas_named(table_text(&table, i, "gas"));
        assert_non_null(gas);
        double temperature_K = table_number(&table, i, "T_K"), pressure_Pa = table_number(&table, i, "p_Pa");
        double accommodation = table_number(&table, i, "accommodation");
        assert_cell(gas->conductivity_W_per_mK, table, i, "k_W_per_mK", 1e-15);
        assert_cell(gas_prandtl(gas), table, i, "Prandtl", 1e-12);
        assert_cell(gas_mean_free_path(gas, temperature_K, pressure_Pa), table, i, "mean_free_path_m", 1e-12);
        assert_cell(gas_jump_length(gas, temperature_K, pressure_Pa, accommodation, accommodation), table, i, "M_m",
                    1e-12);
    }
}

/** Eucken's relation k = mu c_v (9 gamma - 5)/4 holds within 4.1 % (air), 3 % (nitrogen), 1 % (of one atom), 7.5 %
 * (hydrogen), 4 % (carbon dioxide), 14 % (SF6, whose molecules vibrate): no row has a slip of the pen. Each names its
 * source. */
TEST_CASE(rows_are_consistent)
{
    static const double within[] = {0.041, 0.03, 0.01, 0.01, 0.075, 0.04, 0.14, 0.012, 0.01};
    assert_int_equal(gas_count, sizeof within / sizeof within[0]);
    for (size_t i = 0; i < gas_count; i++) {
        const struct gas *gas = &gas_table[i];
        double heat = gas->specific_heat_J_per_kgK / gas->heat_ratio;
        assert_near(gas->viscosity_Pa_s * heat * (9 * gas->heat_ratio - 5) / 4, gas->conductivity_W_per_mK, within[i]);
        double gas_constant = 8.314462618 / gas->molar_mass_kg; /* c_p - c_v of an ideal gas */
        assert_near(gas->specific_heat_J_per_kgK - heat, gas_constant, 0.01);
        assert_true(strlen(gas->source) > 0);
    }
}

/** Conductivities of a second hand: VDI Heat Atlas 2010, equations of section D3.1; of SF6 Assael and others 2012, J.
 * Phys. Chem. Ref. Data 41, 023104; of water Ramires and others 1995, J. Phys. Chem. Ref. Data 24, 1377; of oil Cengel,
 * Heat and Mass Transfer, table A-13. */
TEST_CASE(conductivities_of_a_second_source)
{
    static const struct {
        const struct gas *fluid;
        double at[2], conductivity[2];
    } rows[] = {
        {&gas_table[0], {300, 500}, {0.02651, 0.04015}},   {&gas_table[1], {300, 500}, {0.02556, 0.03894}},
        {&gas_table[2], {300, 500}, {0.15432, 0.22017}},   {&gas_table[3], {300, 400}, {0.01770, 0.02186}},
        {&gas_table[4], {300, 500}, {0.18148, 0.26704}},   {&gas_table[5], {300, 500}, {0.01670, 0.03283}},
        {&gas_table[6], {300, 600}, {0.01309, 0.03398}},   {&gas_table[6], {250, 400}, {0.00945, 0.02050}},
        {&gas_table[7], {300, 500}, {0.04917, 0.07060}},   {&gas_table[8], {300, 500}, {0.00962, 0.01481}},
        {&gas_liquids[0], {300, 350}, {0.6095, 0.6655}},   {&gas_liquids[1], {293.15, 353.15}, {0.1450, 0.1380}},
        {&gas_liquids[2], {300, 350}, {0.29196, 0.29770}},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
        for (int t = 0; t < 2; t++)
            assert_near(gas_conductivity(rows[i].fluid, rows[i].at[t]), rows[i].conductivity[t], 0.03);
    for (size_t i = 0; i < gas_count; i++) /* at the table's temperature the table's value, to the last digit */
        assert_near(gas_conductivity(&gas_table[i], 300), gas_table[i].conductivity_W_per_mK, 0);
}

/** Song and Yovanovich 1987, A correlation for the thermal accommodation coefficient on engineering surfaces, HTD-69;
 * the older rows' 0.87 is within 5 % of it. */
TEST_CASE(accommodation)
{
    for (size_t i = 0; i < gas_count; i++) {
        const double mass = 1e3 * gas_table[i].molar_mass_kg, ratio = mass / 56, e = exp(-0.57 * 27 / 273);
        const double weight = gas_table[i].heat_ratio > 1.6 ? mass : 1.4 * mass;
        const double a = e * weight / (6.8 + weight) + (1 - e) * 2.4 * ratio / ((1 + ratio) * (1 + ratio));
        assert_within(gas_table[i].accommodation, a, gas_table[i].accommodation == 0.87 ? 0.05 : 0.005);
    }
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
    const struct gas *air = gas_named("air");
    double jump_m = gas_jump_length(air, 300, 101325, 0.87, 0.87);
    double h = gas_conductance(0.0263, 1e-6, 3e-6, jump_m, 0, 1e-10);
    assert_near(h, 0.0263 / 1e-6 * gas_gap_integral(3, jump_m / 1e-6, 1e-12), 1e-9);
    assert_near(gas_conductance(0.0263, 1e-6, 3e-6, jump_m, 0.25, 1e-10), 0.75 * h, 1e-12);
    assert_near(gas_conductance(0.0263, 1e-6, -3e-6, jump_m, 0, 1e-10),
                gas_conductance(0.0263, 1e-6, 0, jump_m, 0, 1e-10), 0);
    assert_near(gas_conductance(0.0263, 0, 3e-6, jump_m, 0, 1e-10), 0.0263 / (3e-6 + jump_m), 1e-14);
    assert_near(gas_conductance(0.0263, 1e-12, 3e-6, jump_m, 0, 1e-10), 0.0263 / (3e-6 + jump_m), 1e-9);
    assert_within(gas_conductance(0.0263, 1e-6, 3e-6, gas_jump_length(air, 300, 0, 0.87, 0.87), 0, 1e-10), 0, 0);
    assert_within(gas_conductance(0.0263, 1e-6, 3e-6, jump_m, 1, 1e-10), 0, 0);
    assert_near(gas_jump_length(air, 300, 101325.0 / 2, 0.87, 0.87), 2 * jump_m, 1e-14);
    assert_near(gas_jump_length(air, 600, 101325, 0.87, 0.87), 2 * jump_m, 1e-14);
}
