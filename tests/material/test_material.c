/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "material/material.h"
#include "support.h"

static const double k_tin_effective_modulus = 47528722426.470588; /* Pa */

static const struct material *known(const char *name)
{
    const struct material *material = material_find(name);
    assert_non_null(material);
    return material;
}

TEST_CASE(test_tin_is_table_6_1)
{
    static const double values[] = {41.369e9, 0.36, 14e6, 11.5e-8, 66.8, 7310, 227, 2730}; /* E_Pa, nu, Sy_Pa, ... */
    for (size_t p = 0; p < sizeof values / sizeof *values; p++)
        assert_near(material_value(known("tin"), &material_properties[p]), values[p], 0);
}

TEST_CASE(test_tin_against_a_rigid_flat)
{
    struct material_pair pair = material_pair(known("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    assert_near(pair.yield_coefficient, 1.6878755972587788, 1e-14);
    assert_near(pair.effective_modulus_Pa, k_tin_effective_modulus, 1e-14);
    assert_near(pair.mean_free_path_m[0], 4.4237628381008097e-8, 1e-14);
    assert_near(pair.mean_free_path_m[1], pair.mean_free_path_m[0], 0);
    assert_near(pair.yield_strength_Pa, 14e6, 0);
    assert_near(pair.poisson_ratio, 0.36, 0);
    assert_near(pair.resistivity_ohm_m, 11.5e-8, 0); /* the flat conducts like the tin */
    assert_near(pair.conductivity_W_per_mK, 66.8, 0);
    assert_near(pair.side_conductivity_W_per_mK[1], 66.8, 0);
}

TEST_CASE(test_same_metal_is_half_as_stiff)
{
    for (size_t i = 0; i < material_table_count; i++) {
        const struct material *metal = &material_table[i];
        if (isnan(metal->youngs_modulus_Pa))
            continue; /* it bears no load */
        struct material_pair rigid = material_pair(metal, MATERIAL_COUNTERFACE_RIGID, NULL);
        struct material_pair same = material_pair(metal, MATERIAL_COUNTERFACE_ELASTIC, metal);
        assert_near(same.effective_modulus_Pa, rigid.effective_modulus_Pa / 2, 1e-15);
        if (!isnan(metal->resistivity_ohm_m)) {
            assert_near(same.conductivity_W_per_mK, rigid.conductivity_W_per_mK, 0);
            assert_near(same.resistivity_ohm_m, rigid.resistivity_ohm_m, 0);
        }
        if (!isnan(metal->yield_strength_Pa))
            assert_near(same.yield_coefficient, rigid.yield_coefficient, 0);
    }
}

TEST_CASE(test_two_metals)
{
    const struct material *tin = known("tin"), *copper = known("copper");
    struct material_pair pair = material_pair(copper, MATERIAL_COUNTERFACE_ELASTIC, tin);
    double expected = 1 / ((1 - 0.36 * 0.36) / 41.369e9 +
                           (1 - copper->poisson_ratio * copper->poisson_ratio) / copper->youngs_modulus_Pa);
    assert_near(pair.effective_modulus_Pa, expected, 1e-15);
    assert_near(pair.yield_strength_Pa, 14e6, 0); /* tin is the softer */
    assert_near(pair.poisson_ratio, 0.36, 0);
    assert_near(pair.yield_coefficient, 1.6878755972587788, 1e-14);
    assert_near(pair.resistivity_ohm_m, (11.5e-8 + copper->resistivity_ohm_m) / 2, 1e-15);
    double k = copper->conductivity_W_per_mK;
    assert_near(pair.conductivity_W_per_mK, 2 * 66.8 * k / (66.8 + k), 1e-15);
    assert_near(pair.mean_free_path_m[1], 4.4237628381008097e-8, 1e-14);
    assert_true(pair.mean_free_path_m[0] != pair.mean_free_path_m[1]);
    assert_near(pair.side_conductivity_W_per_mK[0], k, 0);

    struct material_pair turned = material_pair(tin, MATERIAL_COUNTERFACE_ELASTIC, copper);
    assert_near(turned.effective_modulus_Pa, pair.effective_modulus_Pa, 1e-15);
    assert_near(turned.conductivity_W_per_mK, pair.conductivity_W_per_mK, 1e-15);
    assert_near(turned.yield_strength_Pa, 14e6, 0);
}

TEST_CASE(test_what_is_missing_is_nan)
{
    struct material some = material_unknown("some");
    assert_string_equal(some.name, "some");
    for (size_t i = 0; i < material_property_count; i++)
        assert_true(isnan(material_value(&some, &material_properties[i])));
    some.youngs_modulus_Pa = 1e9;
    some.poisson_ratio = 0;
    struct material_pair pair = material_pair(&some, MATERIAL_COUNTERFACE_RIGID, NULL);
    assert_near(pair.effective_modulus_Pa, 1e9, 0);
    assert_near(pair.yield_coefficient, 1.295, 0); /* needs nu alone */
    assert_true(isnan(pair.yield_strength_Pa) && isnan(pair.mean_free_path_m[0]));
    assert_true(isnan(pair.resistivity_ohm_m) && isnan(pair.conductivity_W_per_mK));

    /* Which body is softer is not known. */
    pair = material_pair(known("tin"), MATERIAL_COUNTERFACE_ELASTIC, &some);
    assert_near(pair.effective_modulus_Pa, 1 / (1 / k_tin_effective_modulus + 1e-9), 1e-15);
    assert_true(isnan(pair.yield_strength_Pa) && isnan(pair.yield_coefficient));
    assert_true(isnan(pair.poisson_ratio) && isnan(pair.resistivity_ohm_m));
    assert_near(pair.mean_free_path_m[0], 4.4237628381008097e-8, 1e-14);
    assert_true(isnan(pair.mean_free_path_m[1]));
}

/* A given hardness and path of the heat carriers are taken, that of the softer body; else 2.84 S_y and 3k/(...). */
TEST_CASE(test_given_instead_of_derived)
{
    struct material tin = *known("tin"), copper = *known("copper");
    assert_near(material_pair(&tin, MATERIAL_COUNTERFACE_RIGID, NULL).hardness_Pa, 2.84 * 14e6, 1e-15);
    tin.hardness_Pa = 1e8;
    tin.mean_free_path_m = 4e-9;
    struct material_pair pair = material_pair(&copper, MATERIAL_COUNTERFACE_ELASTIC, &tin);
    assert_near(pair.hardness_Pa, 1e8, 0);
    assert_near(pair.mean_free_path_m[1], 4e-9, 0);
    assert_true(pair.mean_free_path_m[0] > 1e-8);
    copper.hardness_Pa = 1; /* but not the softer by its yield strength */
    assert_near(material_pair(&copper, MATERIAL_COUNTERFACE_ELASTIC, &tin).hardness_Pa, 1e8, 0);
}

TEST_CASE(test_no_material)
{
    struct material_pair none = material_pair_unknown();
    assert_true(none.unknown && isnan(none.yield_strength_Pa) && isnan(none.resistivity_ohm_m));
    assert_near(none.effective_modulus_Pa, 1, 0);
    assert_true(isnan(material_pair_pressure(&none, 1e-3)));
    struct material_pair tin = material_pair(known("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    assert_false(tin.unknown);
    assert_near(material_pair_pressure(&tin, 1e-3), 1e-3 * k_tin_effective_modulus, 1e-15);
}

TEST_CASE(test_names)
{
    static const char *const others[][2] = {{"CuSn6", "bronze"},
                                            {"c17200", "beryllium-copper"},
                                            {"C7025", "copper-nickel-silicon"},
                                            {"aluminum", "aluminium"},
                                            {"304", "steel"},
                                            {"Sn63Pb37", "solder"}};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        assert_ptr_equal(known(others[i][0]), known(others[i][1]));
    assert_ptr_equal(material_find("TIN"), known("tin"));
    assert_null(material_find("unobtainium"));
    assert_null(material_find(""));
    for (size_t i = 0; i < material_table_count; i++)
        assert_ptr_equal(material_find(material_table[i].name), &material_table[i]); /* no name twice */
}

/* |value/law - 1| <= share, where both are known. */
static void assert_law(double value, double law, double share)
{
    if (!isnan(value) && !isnan(law))
        assert_near(value, law, share);
}

/* A wrong power of ten or two exchanged columns would break these laws of metals. */
TEST_CASE(test_the_table_is_plausible)
{
    assert_true(material_table_count >= 9);
    for (size_t i = 0; i < material_table_count; i++) {
        const struct material *metal = &material_table[i];
        assert_true(strlen(metal->source) > 20);
        for (size_t p = 0; p < material_property_count; p++) {
            double value = material_value(metal, &material_properties[p]);
            assert_true(isnan(value) ||
                        (value >= material_properties[p].least && value <= material_properties[p].most));
        }
        /* Wiedemann-Franz: 2.44e-8 W·Ω/K²; the lattice carries a good part of the heat in stainless steel */
        assert_law(metal->conductivity_W_per_mK * metal->resistivity_ohm_m / 293, 2.8e-8, 0.43);
        /* longitudinal waves: v² = E(1-nu)/((1+nu)(1-2nu) density) */
        double nu = metal->poisson_ratio;
        double modulus = metal->youngs_modulus_Pa * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
        assert_law(metal->sound_speed_m_per_s, sqrt(modulus / metal->density_kg_per_m3), 0.13);
        /* Dulong and Petit for densities: heat per volume of all metals is 1.6...4 MJ/(m³ K) */
        assert_law(metal->density_kg_per_m3 * metal->specific_heat_J_per_kgK, 2.8e6, 0.47);
        assert_true(!(metal->yield_strength_Pa >= metal->youngs_modulus_Pa / 100));
        /* a hardness is 2.84 S_y, more where the metal hardens */
        if (!isnan(metal->hardness_Pa) && !isnan(metal->yield_strength_Pa))
            assert_true(metal->hardness_Pa > 2.5 * metal->yield_strength_Pa &&
                        metal->hardness_Pa < 6 * metal->yield_strength_Pa);
    }
}

TEST_CASE(test_property_rows)
{
    static const char *const keys[] = {"E_Pa", "nu", "Sy_Pa", "resistivity_ohm_m", "conductivity_W_per_mK"};
    for (size_t p = 0; p < material_property_count; p++) {
        if (p < sizeof keys / sizeof *keys)
            assert_string_equal(material_properties[p].key, keys[p]);
        assert_ptr_equal(material_property_find(material_properties[p].key), &material_properties[p]);
        assert_true(strlen(material_properties[p].symbol) > 0 && strlen(material_properties[p].meaning) > 0);
        for (size_t other = 0; other < p; other++)
            assert_true(material_properties[p].offset != material_properties[other].offset);
    }
}
