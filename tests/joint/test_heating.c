/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Holm's voltage-temperature relation against tests/data/golden/models/holm.csv. */
#include "joint/heating.h"
#include "support.h"

static const struct {
    const char *symbol, *name;
} names[] = {{"Sn", "tin"}, {"Ag", "silver"}, {"Au", "gold"}, {"Cu", "copper"}, {"Ni", "nickel"}, {"Al", "aluminium"}};

static const struct heating_metal *metal_of(const char *symbol)
{
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        if (strcmp(names[i].symbol, symbol) == 0)
            return heating_metal_find(names[i].name);
    return NULL;
}

TEST_CASE(matches_reference)
{
    struct table table = table_read("golden/models/holm.csv");
    for (size_t i = 0; i < table.rows; i++) {
        double body_K = table_number(&table, i, "T0_K"), hottest_K = table_number(&table, i, "Tmax_K");
        assert_cell(heating_lorenz_number(), table, i, "lorenz_V2_per_K2", 1e-14);
        double voltage_V = table_number(&table, i, "voltage_V");
        assert_near(body_K + heating_rise(voltage_V, body_K), hottest_K, 1e-13);
        assert_near(heating_rise(voltage_V, body_K), hottest_K - body_K, 1e-10);
        const struct heating_metal *metal = metal_of(table_text(&table, i, "metal"));
        assert_non_null(metal);
        assert_cell(metal->melting_K, table, i, "melting_K", 1e-15);
        assert_cell(heating_voltage(metal->melting_K, body_K), table, i, "melting_voltage_V", 1e-12);
    }
}

/** Small voltages: V²/(8 L T_0), to the last digit; there and back; the softening of Holm's table lies at the
 * temperatures known for it. */
TEST_CASE(limits)
{
    assert_near(heating_rise(1e-9, 300), 1e-18 / (8 * heating_lorenz_number() * 300), 1e-14);
    assert_within(heating_rise(0, 300), 0, 0);
    assert_near(heating_rise(1e-3, 0), 1e-3 / (2 * sqrt(heating_lorenz_number())), 1e-14);
    for (double voltage = 1e-6; voltage < 1; voltage *= 3)
        assert_near(heating_voltage(300 + heating_rise(voltage, 300), 300), voltage,
                    1e-4 * fmin(1, 1e-6 / voltage) + 1e-9);
    assert_within(298.15 + heating_rise(heating_metal_find("tin")->softening_voltage_V, 298.15), 373, 0.5);
    assert_within(298.15 + heating_rise(heating_metal_find("gold")->softening_voltage_V, 298.15), 393, 0.9);
    assert_within(298.15 + heating_rise(heating_metal_find("Silver")->softening_voltage_V, 298.15), 415, 0.9);
    assert_within(298.15 + heating_rise(heating_metal_find("copper")->softening_voltage_V, 298.15), 486, 0.9);
    for (size_t i = 0; i < heating_metal_count; i++)
        assert_true(isnan(heating_metals[i].softening_voltage_V) ||
                    heating_metals[i].softening_voltage_V < heating_voltage(heating_metals[i].melting_K, 298.15));
    assert_null(heating_metal_find("wood"));
}
