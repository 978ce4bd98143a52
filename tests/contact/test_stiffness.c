/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contact stiffness k = -dP/d separation: in closed form, against the slopes of the separations, and by Barber. */
#include "contact/gaussian.h"
#include "model_support.h"

enum { LOADS = 41 };

static struct model_task task_of(const struct spectrum *spectrum, const struct asperities *asperities,
                                 const struct material_pair *pair, const double *loads)
{
    struct model_task task = model_support_task(spectrum, pair, loads, LOADS);
    task.asperities = asperities;
    task.wanted |= QUANTITY_BIT(QUANTITY_STIFFNESS);
    return task;
}

/** GW: P ~ F_3/2(d), of which F' = -3/2 F_1/2 and d separation = sigma_s dd: k = 3/2 P F_1/2/(F_3/2 sigma_s). */
TEST_CASE(of_greenwood_and_williamson_in_closed_form)
{
    const struct asperities asperities = model_support_asperities(1e-12, 0.01, 1e9);
    const struct material_pair tin = model_support_tin();
    double load[LOADS];
    struct contact_point points[LOADS + 1];
    model_support_loads(load, LOADS, 1e-7, 1e-3);
    const struct model_task task = task_of(NULL, &asperities, &tin, load);
    struct model_curve curve = model_support_run(points, "gw", &task);
    assert_int_equal(curve.count, LOADS);
    for (size_t i = 0; i < LOADS; i++) {
        double d = (points[i].value[QUANTITY_SEPARATION] - asperities.offset_m) / asperities.sigma_s_m;
        struct gaussian_integrals f = gaussian_integrals(d);
        double k = 1.5 * load[i] * tin.effective_modulus_Pa * f.half / f.three_halves / asperities.sigma_s_m;
        assert_near(points[i].value[QUANTITY_STIFFNESS], k, 1e-6);
    }
}

/** Every model's is the slope of its separation between loads 2 % apart. */
TEST_CASE(is_the_slope_of_the_separation)
{
    static const char *const models[] = {
        "gw", "jg", "multiscale-elastic", "multiscale-plastic", "corrected-persson", "corrected-persson-plastic",
        "cmy"};
    const struct asperities asperities = model_support_asperities(1e-12, 0.01, 1e9);
    const struct material_pair tin = model_support_tin();
    struct spectrum spectrum = model_support_law(1e-3, 0.01, 1.6, 40);
    double load[LOADS];
    struct contact_point points[LOADS + 1];
    model_support_loads(load, LOADS, 1e-5, 1e-5 * pow(1.01, LOADS - 1));
    const struct model_task task = task_of(&spectrum, &asperities, &tin, load);
    for (size_t m = 0; m < sizeof models / sizeof *models; m++) {
        struct model_curve curve = model_support_run(points, models[m], &task);
        assert_int_equal(curve.count, LOADS);
        for (size_t i = 1; i + 1 < LOADS; i++) {
            double fall_m = points[i - 1].value[QUANTITY_SEPARATION] - points[i + 1].value[QUANTITY_SEPARATION];
            double slope = (load[i + 1] - load[i - 1]) * tin.effective_modulus_Pa / fall_m;
            assert_near(points[i].value[QUANTITY_STIFFNESS], slope, 5e-4);
        }
    }
}

/** Barber, Proc. R. Soc. A 459 (2003) 53: conductance and stiffness of elastic contact are the same number,
 * k = E' rho/ECR. */
TEST_CASE(of_elastic_contact_goes_with_its_conductance)
{
    const struct material_pair tin = model_support_tin();
    struct spectrum spectrum = model_support_law(1e-3, 0.01, 1.6, 40);
    double load[LOADS];
    struct contact_point points[LOADS + 1];
    model_support_loads(load, LOADS, 1e-6, 1e-2);
    struct model_task task = task_of(&spectrum, NULL, &tin, load);
    struct model_curve curve = model_support_run(points, "corrected-persson", &task);
    assert_true(curve.count > LOADS / 2);
    for (size_t i = 0; i < curve.count; i++)
        assert_near(points[i].value[QUANTITY_STIFFNESS] * points[i].value[QUANTITY_ECR],
                    tin.effective_modulus_Pa * tin.resistivity_ohm_m, 1e-12);
    task.wanted = MODEL_EVERYTHING;
    curve = model_support_run(points, "multiscale-elastic", &task);
    for (size_t i = 0; i < curve.count; i++)
        assert_true(isnan(points[i].value[QUANTITY_STIFFNESS]));
}
