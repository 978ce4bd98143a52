/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/effect.h"
#include "material/material.h"
#include "support.h"

/** Every effect has a name of its own, and needs only what materials and effects have. */
TEST_CASE(rows_are_whole)
{
    for (int i = 0; i < EFFECT_COUNT; i++) {
        assert_true(effect_rows[i].name && effect_rows[i].name[0]);
        assert_true(!effect_rows[i].key || effect_rows[i].key[0]);
        for (int j = 0; j < i; j++)
            assert_string_not_equal(effect_rows[i].name, effect_rows[j].name);
        for (const char *const *key = effect_rows[i].properties; *key; key++) {
            size_t p = 0;
            while (p < material_property_count && strcmp(material_properties[p].key, *key) != 0)
                p++;
            assert_true(p < material_property_count);
        }
        assert_true(effect_rows[i].needs_effects < EFFECT_BIT(EFFECT_COUNT));
        assert_false(effect_rows[i].needs_effects & EFFECT_BIT(i));
    }
    assert_string_equal(effect_rows[EFFECT_PLASTICITY].properties[0], "Sy_Pa");
    assert_string_equal(effect_rows[EFFECT_ELECTRICAL].properties[0], "resistivity_ohm_m");
    assert_string_equal(effect_rows[EFFECT_THERMAL].properties[0], "conductivity_W_per_mK");
}
