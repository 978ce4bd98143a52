/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/unit.h"
#include "support.h"

enum { ALL = (1 << 22) - 1 };

TEST_CASE(units_have_their_factor)
{
    static const struct {
        const char *text;
        unsigned quantity;
        double factor;
    } rows[] = {
        {"ohm", UNIT_RESISTANCE, 1},
        {"OHM", UNIT_RESISTANCE, 1},
        {"ohms", UNIT_RESISTANCE, 1},
        {"\xCE\xA9", UNIT_RESISTANCE, 1},
        {"\xE2\x84\xA6", UNIT_RESISTANCE, 1},
        {"m\xCE\xA9", UNIT_RESISTANCE, 1e-3},
        {" mOhm ", UNIT_RESISTANCE, 1e-3},
        {"Milliohms", UNIT_RESISTANCE, 1e-3},
        {"MOhm", UNIT_RESISTANCE, 1e6},
        {"\xC2\xB5\xCE\xA9", UNIT_RESISTANCE, 1e-6},
        {"\xCE\xBC\xE2\x84\xA6", UNIT_RESISTANCE, 1e-6},
        {"\xB5Ohm", UNIT_RESISTANCE, 1e-6}, /* latin-1 */
        {"microhm", UNIT_RESISTANCE, 1e-6},
        {"kilohm", UNIT_RESISTANCE, 1e3},
        {"V/A", UNIT_RESISTANCE, 1},
        {"\xCE\xA9\xC2\xB7m\xC2\xB2", UNIT_RESISTANCE_AREA, 1},
        {"\xCE\xA9m\xC2\xB2", UNIT_RESISTANCE_AREA, 1},
        {"ohm m2", UNIT_RESISTANCE_AREA, 1},
        {"ohm*m^2", UNIT_RESISTANCE_AREA, 1},
        {"m\xCE\xA9 mm\xC2\xB2", UNIT_RESISTANCE_AREA, 1e-9},
        {"K/W", UNIT_THERMAL_RESISTANCE, 1},
        {"K W^-1", UNIT_THERMAL_RESISTANCE, 1},
        {"K W\xE2\x81\xBB\xC2\xB9", UNIT_THERMAL_RESISTANCE, 1},
        {"K m\xC2\xB2/W", UNIT_THERMAL_RESISTANCE_AREA, 1},
        {"mm2K/W", UNIT_THERMAL_RESISTANCE_AREA, 1e-6},
        {"K_m2_per_W", UNIT_THERMAL_RESISTANCE_AREA, 1},
        {"K/(W/m2)", UNIT_THERMAL_RESISTANCE_AREA, 1},
        {"mN", UNIT_FORCE, 1e-3},
        {"cN", UNIT_FORCE, 1e-2},
        {"MN", UNIT_FORCE, 1e6},
        {"newtons", UNIT_FORCE, 1},
        {"gf", UNIT_FORCE, 9.80665e-3},
        {"lbf", UNIT_FORCE, 4.4482216152605},
        {"kg m/s2", UNIT_FORCE, 1},
        {"Pa", UNIT_PRESSURE, 1},
        {"MPa", UNIT_PRESSURE, 1e6},
        {"mPa", UNIT_PRESSURE, 1e-3},
        {"GPa", UNIT_PRESSURE, 1e9},
        {"hPa", UNIT_PRESSURE, 1e2},
        {"bar", UNIT_PRESSURE, 1e5},
        {"psi", UNIT_PRESSURE, 4.4482216152605 / (0.0254 * 0.0254)},
        {"N/mm\xC2\xB2", UNIT_PRESSURE, 1e6},
        {"kgf/cm2", UNIT_PRESSURE, 98066.5},
        {"atm", UNIT_PRESSURE, 101325},
        {"torr", UNIT_PRESSURE, 101325. / 760},
        {"mm", UNIT_DISTANCE, 1e-3},
        {"\xC2\xB5m", UNIT_DISTANCE, 1e-6},
        {"\xC3\x85", UNIT_DISTANCE, 1e-10},
        {"in", UNIT_DISTANCE, 0.0254},
        {"uin", UNIT_DISTANCE, 2.54e-8},
        {"mil", UNIT_DISTANCE, 2.54e-5},
        {"mm2", UNIT_AREA, 1e-6},
        {"cm^2", UNIT_AREA, 1e-4},
        {"ms", UNIT_TIME, 1e-3},
        {"min", UNIT_TIME, 60},
        {"h", UNIT_TIME, 3600},
        {"km/s", UNIT_SPEED, 1e3},
        {"K", UNIT_TEMPERATURE, 1},
        {"kA", UNIT_CURRENT, 1e3},
        {"mV", UNIT_VOLTAGE, 1e-3},
        {"g/cm3", UNIT_DENSITY, 1e3},
        {"kJ/kg/K", UNIT_SPECIFIC_HEAT, 1e3},
        {"J/(g K)", UNIT_SPECIFIC_HEAT, 1e3},
        {"W/m/K", UNIT_CONDUCTIVITY, 1},
        {"W/cm/K", UNIT_CONDUCTIVITY, 100},
        {"uohm cm", UNIT_RESISTIVITY, 1e-8},
        {"ohm mm2/m", UNIT_RESISTIVITY, 1e-6},
        {"mW/K", UNIT_CONDUCTANCE, 1e-3},
        {"kW/m2/K", UNIT_CONDUCTANCE_AREA, 1e3},
        {"W/(cm2 degC)", UNIT_CONDUCTANCE_AREA, 1e4}, /* a difference */
        {"mW", UNIT_POWER, 1e-3},
        {"%", UNIT_PERCENT, 0.01},
        {"1", UNIT_NUMBER, 1},
        {"-", UNIT_NUMBER, 1},
        {"dimensionless", UNIT_NUMBER, 1},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct unit unit;
        if (!unit_read(&unit, rows[i].text, strlen(rows[i].text)))
            fail_msg("'%s' is not read", rows[i].text);
        if (unit_of(&unit, ALL) != rows[i].quantity)
            fail_msg("'%s' is a unit of %u, not %u", rows[i].text, unit_of(&unit, ALL), rows[i].quantity);
        if (!(fabs(unit.factor / rows[i].factor - 1) < 1e-15))
            fail_msg("'%s' is %.17g", rows[i].text, unit.factor);
        assert_int_equal(unit_of(&unit, ALL & ~rows[i].quantity), 0);
    }
}

/* Beyond the quantities that are named: the dimension is right. */
TEST_CASE(quotients_divide)
{
    static const char *const same[] = {"W/m2/K", "W/(m2 K)", "W/(m^2*K)", "W m-2 K-1", "W/m\xC2\xB2/K", "1/(K m2/W)"};
    struct unit first, unit;
    for (size_t i = 0; i < sizeof same / sizeof *same; i++) {
        if (!unit_read(i ? &unit : &first, same[i], strlen(same[i])))
            fail_msg("'%s' is not read", same[i]);
        assert_true(i == 0 || unit_equal(&first, &unit));
    }
    assert_int_equal(first.power[UNIT_METRE], 0);
    assert_int_equal(first.power[UNIT_KILOGRAM], 1);
    assert_int_equal(first.power[UNIT_SECOND], -3);
    assert_int_equal(first.power[UNIT_KELVIN], -1);
    assert_int_equal(unit_of(&first, ALL), UNIT_CONDUCTANCE_AREA);
    assert_int_equal(unit_of(&first, ALL & ~UNIT_CONDUCTANCE_AREA), 0);
}

TEST_CASE(what_is_no_unit_is_not_read)
{
    char texts[] = "| |foo|KN|kn|mpa|MOHM|mOm|N/|/N|N N/|Nm|W/m2 K|m|N/kN|K/W*m2|ohm_|(N|N)|()|m^|m22|m0|kkgf|"
                   "\xC3\xB2|mohm,|N\xFF|((((((((((((((((((((((((((((((((((((((((((((((N|"
                   "ohm ohm ohm ohm ohm ohm ohm ohm ohm ohm ohm ohm ohm";
    struct unit unit;
    for (char *rest = texts, *text; (text = strsep(&rest, "|"));)
        if (unit_read(&unit, text, strlen(text)) && unit_of(&unit, ALL & ~UNIT_DISTANCE))
            fail_msg("'%s' is read", text);
    assert_false(unit_read(&unit, "N\0m", 3));
    assert_true(unit_read(&unit, "Nonsense", 1)); /* no more than it is told */
}

/* What a message offers is what unit_read() reads, and of that quantity. */
TEST_CASE(known_units_are_read)
{
    for (unsigned bit = 1; bit < ALL; bit *= 2) {
        struct unit_known known = unit_known(bit);
        assert_true(known.text[0]);
        for (char *rest = known.text, *word; (word = strsep(&rest, ","));) {
            struct unit unit;
            char *open = strchr(word, '(');
            size_t length = open ? (size_t)(open - word) : strlen(word);
            if (!unit_read(&unit, word, length) || unit_of(&unit, ALL) != bit)
                fail_msg("'%s'", word);
            if (open)
                assert_true(unit_read(&unit, open + 1, strlen(open) - 2) && unit_of(&unit, ALL) == bit);
        }
    }
}

/* What is shown of a unit is UTF-8. */
TEST_CASE(test_shown)
{
    char shown[UNIT_LENGTH];
    assert_true(unit_shown(shown, "\xc2\xb5m", 3));
    assert_string_equal(shown, "\xc2\xb5m");
    assert_true(unit_shown(shown, "\xb5m", 2));
    assert_string_equal(shown, "um");
}
