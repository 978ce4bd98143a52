/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/scene_joint.h"

#include <assert.h>

enum { GASES_MOST = 16 };

bool scene_joint_gap(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    struct joint *joint = key->field;
    const char *names[GASES_MOST]; /* those of the table, then none */
    unsigned gas = 0;
    assert(gas_count < GASES_MOST);
    for (size_t i = 0; i < gas_count; i++)
        names[i] = gas_table[i].name;
    names[gas_count] = "vacuum";
    struct scene_key keys[] = {
        {"gas", scene_source_choice, .field = &gas, .choices = names, .choice_count = gas_count + 1},
        {"pressure", SCENE_QUANTITY(joint->pressure_Pa, UNIT_PRESSURE, 0.0, 1e9)},
        {"accommodation", SCENE_NUMBER(joint->accommodation, 1e-3, 1.0)},
        {"temperature", SCENE_QUANTITY(joint->temperature_K, UNIT_TEMPERATURE, 1.0, 1e4)},
        {"conductivity", SCENE_QUANTITY(joint->conductivity_W_per_mK, UNIT_CONDUCTIVITY, 1e-6, 1e4)},
    };
    if (!scene_source_mapping(source, value, key->name, keys, SCENE_COUNT(keys)))
        return false;
    bool medium = scene_source_line_of(keys, "conductivity") > 0;
    for (size_t k = 0; k < 3 && medium; k++)
        if (keys[k].line > 0)
            return scene_source_fail(source, keys[k].line,
                                     "'%s' stands beside 'conductivity', which is of what fills the gaps; remove one",
                                     keys[k].name);
    joint->gas = gas < gas_count ? &gas_table[gas] : NULL;
    joint->fill = medium ? JOINT_MEDIUM : joint->gas ? JOINT_GAS : JOINT_VACUUM;
    return true;
}

bool scene_joint_plating(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value)
{
    static const char *const sides[] = {"one", "both"};
    struct joint *joint = key->field;
    unsigned both = joint->both_plated;
    struct scene_key keys[] = {
        {"thickness", SCENE_QUANTITY(joint->plating_thickness_m, UNIT_DISTANCE, 1e-12, 1.0)},
        {"resistivity", SCENE_QUANTITY(joint->plating_ohm_m, UNIT_RESISTIVITY, 1e-12, 1e10)},
        {"sides", SCENE_CHOICE(both, sides)},
    };
    if (!scene_source_mapping(source, value, key->name, keys, SCENE_COUNT(keys)))
        return false;
    for (size_t k = 0; k < 2; k++)
        if (keys[k].line == 0)
            return scene_source_fail(source, scene_source_line(value), "'%s' has no '%s'; add it", key->name,
                                     keys[k].name);
    joint->both_plated = both;
    return true;
}
