/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A number in SI or one with its unit. */
#include "scene/scene_words.h"
#include "support.h"

enum { ANY = (1 << 22) - 1 };

static struct scene_quantity read(const char *text, unsigned quantities)
{
    struct scene_quantity out;
    if (!scene_quantity_read(&out, string_view_of(text), quantities))
        fail_msg("'%s' is not read", text);
    return out;
}

TEST_CASE(values_are_si)
{
    static const struct {
        const char *text;
        unsigned kind;
        double value;
    } rows[] = {
        {"4 mm2", UNIT_AREA, 4e-6},
        {"2.5 um", UNIT_DISTANCE, 2.5e-6},
        {" 10 N ", UNIT_FORCE, 10},
        {"30 psi", UNIT_PRESSURE, 30 * 6894.757293168361},
        {"1e4 W/m2/K", UNIT_CONDUCTANCE_AREA, 1e4},
        {"20 degC", UNIT_TEMPERATURE, 293.15},
        {"-40 \xC2\xB0"
         "C",
         UNIT_TEMPERATURE, 233.15},
        {"212 degF", UNIT_TEMPERATURE, 373.15},
        {"10 %", UNIT_PERCENT, 0.1},
        {"0.5", UNIT_NUMBER, 0.5},
        {"+1.5e-6", UNIT_NUMBER, 1.5e-6},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct scene_quantity quantity = read(rows[i].text, ANY);
        assert_int_equal(quantity.kind, rows[i].kind);
        assert_near(quantity.value, rows[i].value, 1e-15);
        struct scene_quantity other;
        if (quantity.has_unit)
            assert_false(scene_quantity_read(&other, string_view_of(rows[i].text), ANY & ~rows[i].kind));
    }
    /* rounded once, so that it is the same double as in SI */
    assert_true(read("4 um", UNIT_DISTANCE).value == 4e-6 && read("0.3 mm", UNIT_DISTANCE).value == 0.3e-3);
}

TEST_CASE(without_a_unit_it_is_the_first)
{
    struct scene_quantity load = read("5", UNIT_LOADS), area = read("5", UNIT_AREA);
    assert_int_equal(load.kind, UNIT_NUMBER);
    assert_int_equal(area.kind, UNIT_AREA);
    assert_false(load.has_unit || area.has_unit);
    struct scene_quantity force = read("5 \xC2\xB5N", UNIT_LOADS);
    assert_string_equal(force.text, "\xC2\xB5N");
    assert_near(force.unit.factor, 1e-6, 0);
}

TEST_CASE(what_is_none_is_refused)
{
    static const char *const texts[] = {"",     "N",       "4 furlongs", "4 mm2 x", "0x10 N", "1,5 N", "inf N",
                                        "4 4",  "1d3 N",   "1 W/mK/",    "4 mm 2",  "N 4",    "--4 N", "4 degC/degC x",
                                        "4 'N", "4 N\001", "1e5N5"};
    struct scene_quantity out;
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        if (scene_quantity_read(&out, string_view_of(texts[i]), ANY & ~UNIT_POWER))
            fail_msg("'%s' is read", texts[i]);
    assert_true(scene_quantity_read(&out, string_view_of("1e999 N"), ANY) && isinf(out.value));
}
