/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/effect.h"
#include "material/material.h"
#include "support.h"

TEST_CASE(test_spellings)
{
    static const char *const names[EFFECT_COUNT] = {
        "plasticity", "separation", "electrical", "thermal", "scale-dependent", "convergence", "uncertainty",
        "unloading",  "direct",     "gap",        "film",    "plating",         "heating"};
    static const char *const keys[EFFECT_COUNT] = {[EFFECT_UNLOADING] = "unload_from",
                                                   [EFFECT_GAP] = "gap",
                                                   [EFFECT_FILM] = "film",
                                                   [EFFECT_PLATING] = "plating",
                                                   [EFFECT_HEATING] = "current"};
    for (int i = 0; i < EFFECT_COUNT; i++) {
        assert_string_equal(effect_rows[i].name, names[i]);
        assert_true(strlen(effect_rows[i].adds) > 0);
        assert_true(!effect_rows[i].key == !keys[i]);
        assert_true(effect_rows[i].only_listed == (i == EFFECT_UNLOADING));
        if (keys[i])
            assert_string_equal(effect_rows[i].key, keys[i]);
    }
}

TEST_CASE(test_what_they_need)
{
    static const size_t counts[EFFECT_COUNT] = {1, 0, 1, 1, 4, 0, 0, 1, 0, 1, 1, 1, 1};
    static const unsigned needs[EFFECT_COUNT] = {[EFFECT_SCALE_DEPENDENT] = EFFECT_BIT(EFFECT_THERMAL),
                                                 [EFFECT_UNLOADING] = EFFECT_BIT(EFFECT_PLASTICITY),
                                                 [EFFECT_GAP] =
                                                     EFFECT_BIT(EFFECT_SEPARATION) | EFFECT_BIT(EFFECT_THERMAL),
                                                 [EFFECT_FILM] = EFFECT_BIT(EFFECT_ELECTRICAL),
                                                 [EFFECT_PLATING] = EFFECT_BIT(EFFECT_ELECTRICAL),
                                                 [EFFECT_HEATING] = EFFECT_BIT(EFFECT_ELECTRICAL)};
    for (int i = 0; i < EFFECT_COUNT; i++) {
        size_t count = 0;
        for (const char *const *key = effect_rows[i].properties; *key; key++, count++) {
            size_t p = 0;
            while (p < material_property_count && strcmp(material_properties[p].key, *key) != 0)
                p++;
            assert_true(p < material_property_count);
        }
        assert_int_equal(count, counts[i]);
        assert_int_equal(effect_rows[i].needs_effects, needs[i]);
    }
    assert_string_equal(effect_rows[EFFECT_PLASTICITY].properties[0], "Sy_Pa");
    assert_string_equal(effect_rows[EFFECT_ELECTRICAL].properties[0], "resistivity_ohm_m");
    assert_string_equal(effect_rows[EFFECT_THERMAL].properties[0], "conductivity_W_per_mK");
}
