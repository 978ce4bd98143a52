/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/constriction.h"
#include "model_support.h"

static struct material copper_like(double conductivity, double resistivity, double sound_speed)
{
    struct material material = material_unknown("test");
    material.youngs_modulus_Pa = 1e11;
    material.poisson_ratio = 0.3;
    material.yield_strength_Pa = 1e8;
    material.resistivity_ohm_m = resistivity;
    material.conductivity_W_per_mK = conductivity;
    material.density_kg_per_m3 = 8000;
    material.specific_heat_J_per_kgK = 400;
    material.sound_speed_m_per_s = sound_speed;
    return material;
}

/** Adds a scale of that area ratio. */
static void add(struct constriction_sum *sum, double area_ratio, double frequency_per_m, double area_above)
{
    constriction_add_scale(sum, area_ratio, 1 - area_ratio, frequency_per_m, area_above);
}

/* (4.39), (4.42*) written out for one scale on the whole nominal area: n = 2f² spots a unit area, all in parallel. */
TEST_CASE(test_one_scale)
{
    const struct material tin = *material_find("tin");
    const struct material_pair pair = material_pair(&tin, MATERIAL_COUNTERFACE_RIGID, NULL);
    const struct constriction spot = constriction_make(&pair);
    const double mean_free_path_m =
        3 * tin.conductivity_W_per_mK / (tin.density_kg_per_m3 * tin.sound_speed_m_per_s * tin.specific_heat_J_per_kgK);
    for (double area = 1e-6; area < 1; area *= 3)
        for (double frequency = 1e3; frequency < 1e9; frequency *= 10) {
            struct constriction_sum sum = {0};
            add(&sum, area, frequency, 1);
            double radius_m = sqrt(area / (2 * M_PI * frequency * frequency)), spots = 2 * frequency * frequency;
            double factor = pow(1 - sqrt(area), 1.5) / spots;
            double tcr = factor / (2 * tin.conductivity_W_per_mK * radius_m);
            assert_near(constriction_electrical(&spot, &sum), factor * 2 * tin.resistivity_ohm_m / (4 * radius_m),
                        1e-12);
            assert_near(constriction_thermal(&spot, &sum), tcr, 1e-12);
            assert_near(constriction_thermal_scale_dependent(&spot, &sum),
                        tcr * (1 + 8 / (3 * M_PI) * mean_free_path_m / radius_m), 1e-12);
        }
}

/* Half the area above: half the spots, twice the resistance; scales add; a full scale adds nothing. */
TEST_CASE(test_scales_in_series)
{
    struct constriction_sum one = {0}, half = {0}, both = {0};
    add(&one, 0.3, 1e5, 1);
    add(&half, 0.3, 1e5, 0.5);
    assert_near(half.by_radius, 2 * one.by_radius, 1e-14);
    assert_near(half.by_radius_squared, 2 * one.by_radius_squared, 1e-14);
    struct constriction_sum other = {0};
    add(&other, 0.1, 7e5, 0.3);
    add(&both, 0.3, 1e5, 1);
    add(&both, 0.1, 7e5, 0.3);
    assert_near(both.by_radius, one.by_radius + other.by_radius, 1e-14);
    assert_near(both.by_radius_squared, one.by_radius_squared + other.by_radius_squared, 1e-14);
    struct constriction_sum before = both;
    add(&both, 1, 3e6, 0.03);
    assert_near(both.by_radius, before.by_radius, 0);
    assert_near(both.by_radius_squared, before.by_radius_squared, 0);
}

/* Two materials: each side gives half the constriction, with its own conductivity and mean free path. */
TEST_CASE(test_two_materials)
{
    const struct material sides[2] = {copper_like(400, 2e-8, 4000), copper_like(20, 5e-7, 1500)};
    const struct material_pair pair = material_pair(&sides[0], MATERIAL_COUNTERFACE_ELASTIC, &sides[1]);
    const struct constriction spot = constriction_make(&pair);
    struct constriction_sum sum = {0};
    const double frequency = 2e7, radius_m = sqrt(0.02 / (2 * M_PI)) / frequency;
    add(&sum, 0.02, frequency, 0.4);
    const double factor = pow(1 - sqrt(0.02), 1.5) / (2 * frequency * frequency * 0.4);
    double ecr = 0, tcr = 0, scale_dependent = 0;
    for (int s = 0; s < 2; s++) {
        double mean_free_path_m = 3 * sides[s].conductivity_W_per_mK / (8000 * 400 * sides[s].sound_speed_m_per_s);
        double half = factor / (4 * sides[s].conductivity_W_per_mK * radius_m);
        ecr += factor * sides[s].resistivity_ohm_m / (4 * radius_m);
        tcr += half;
        scale_dependent += half * (1 + 8 / (3 * M_PI) * mean_free_path_m / radius_m);
    }
    assert_near(constriction_electrical(&spot, &sum), ecr, 1e-12);
    assert_near(constriction_thermal(&spot, &sum), tcr, 1e-12);
    assert_near(constriction_thermal_scale_dependent(&spot, &sum), scale_dependent, 1e-12);
    assert_true(scale_dependent > 1.01 * tcr);

    const struct material_pair turned = material_pair(&sides[1], MATERIAL_COUNTERFACE_ELASTIC, &sides[0]);
    const struct constriction swapped = constriction_make(&turned);
    assert_near(constriction_thermal_scale_dependent(&swapped, &sum), scale_dependent, 1e-14);
}

TEST_CASE(test_unknown_properties_give_nothing)
{
    struct material material = copper_like(400, 2e-8, 4000);
    material.sound_speed_m_per_s = NAN;
    material.resistivity_ohm_m = NAN;
    const struct material_pair pair = material_pair(&material, MATERIAL_COUNTERFACE_RIGID, NULL);
    const struct constriction spot = constriction_make(&pair);
    struct constriction_sum sum = {0};
    add(&sum, 0.02, 1e6, 1);
    assert_true(isnan(constriction_electrical(&spot, &sum)));
    assert_true(isfinite(constriction_thermal(&spot, &sum)));
    assert_true(isnan(constriction_thermal_scale_dependent(&spot, &sum)));
}
