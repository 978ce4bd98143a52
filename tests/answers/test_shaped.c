/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a usual flatness costs: tests/data/golden/joint/shape.csv's plates with a bulge of 2 um, and where it is nothing
 * or is not known. */
#include "answers/shaped.h"
#include "support.h"

enum { POINTS = 61 };

/** Plates whose gap is -u ln(p/0.3 GPa) and whose conductance is 0.05 p^0.95, over 1 kPa to `most_Pa`, at 1 MPa. */
static double factor_of(double u_m, double side_m, double most_Pa, double hardness_Pa, int way)
{
    const struct material_pair pair = {.effective_modulus_Pa = 3.9e10,
                                       .hardness_Pa = hardness_Pa,
                                       .side_conductivity_W_per_mK = {170, 170},
                                       .side_resistivity_ohm_m = {1.0 / 170, 1.0 / 170}};
    const struct model_row row = {.plastic = isfinite(hardness_Pa)};
    const struct joint nothing = joint_default();
    const struct joint_task joint = {.joint = &nothing, .pair = &pair, .nominal_area_m2 = side_m * side_m};
    struct contact_point points[POINTS];
    for (int i = 0; i < POINTS; i++) {
        double pressure_Pa = 1e3 * pow(most_Pa / 1e3, (double)i / (POINTS - 1));
        points[i].value[QUANTITY_LOAD] = pressure_Pa / pair.effective_modulus_Pa;
        points[i].value[QUANTITY_AREA] = 1e-9 * pressure_Pa;
        points[i].value[QUANTITY_SEPARATION] = -u_m * log(pressure_Pa / 3e8);
        points[i].value[QUANTITY_TCR] = points[i].value[QUANTITY_ECR] = 1 / (0.05 * pow(pressure_Pa, 0.95));
    }
    const struct model_curve curve = {.exists = true, .points = points, .count = POINTS};
    return shaped_usual_factor(&curve, &row, &joint, 1e6 / pair.effective_modulus_Pa, way);
}

TEST_CASE(as_a_shape_that_is_given)
{
    assert_near(shaped_usual_flatness * 0.02, 2e-6, 1e-15);
    assert_near(factor_of(0.3e-6, 0.02, 1e8, INFINITY, JOINT_HEAT), 1.8580507634439836, 1e-6);
    assert_near(factor_of(0.3e-6, 0.02, 1e8, INFINITY, JOINT_CURRENT), 1.8580507634439836, 1e-6);
    assert_true(factor_of(0.3e-6, 0.04, 1e8, INFINITY, JOINT_HEAT) > 2.5);
}

/** With a compliant gap, or on a small part, the bulge makes no difference. */
TEST_CASE(where_it_is_nothing)
{
    assert_near(factor_of(30e-6, 0.02, 1e8, INFINITY, JOINT_HEAT), 1, 0.03);
    assert_near(factor_of(0.3e-6, 0.001, 1e8, INFINITY, JOINT_HEAT), 1, 0.03);
}

/** The largest pressure of the first is 4.2 MPa. */
TEST_CASE(where_it_is_not_known)
{
    assert_true(isfinite(factor_of(0.3e-6, 0.02, 4.3e6, INFINITY, JOINT_HEAT)));
    assert_true(isnan(factor_of(0.3e-6, 0.02, 4e6, INFINITY, JOINT_HEAT)));
    assert_true(isfinite(factor_of(0.3e-6, 0.02, 1e8, 1e8, JOINT_HEAT)));
    assert_true(isnan(factor_of(0.3e-6, 0.02, 1e8, 2e6, JOINT_HEAT)));
    assert_true(isnan(factor_of(0.3e-6, 0.02, 1e8, 0.9e6, JOINT_HEAT)));
}
