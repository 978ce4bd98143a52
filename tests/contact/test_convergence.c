#include "contact/convergence.h"
#include "contact/sinusoid.h"
#include "support.h"

static struct material_pair tin(void)
{
    return material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
}

/** Chapter 6.2: gamma >= 1 settles (the second half of the scales changes nothing), elastic gamma < 1 keeps
 * falling. */
static void gamma_decides(void **state)
{
    (void)state;
    struct material_pair pair = tin();
    double area[4096];
    uint64_t evaluations = 0;
    for (int plastic = 0; plastic < 2; plastic++)
        for (double gamma = 0; gamma <= 2; gamma += 0.25) {
            struct convergence_law law = {0.085, gamma, 3e-4, 1e-3, 4096};
            convergence_areas(area, &law, &pair, plastic, &evaluations);
            if (gamma >= 1)
                assert_near(area[4095], area[2047], 1e-9);
            else if (!plastic)
                assert_true(area[4095] < 0.999 * area[2047]);
            else /* yield bounds the pressure that closes a scale, so the area may settle: never rise */
                assert_true(area[4095] <= area[2047]);
        }
    assert_int_equal(evaluations, 2 * 9 * 4096);
}

/** The shortcut for gamma < 1 against visiting every scale; the early stop for gamma >= 1 likewise. */
static void extension_matches_every_scale(void **state)
{
    (void)state;
    struct material_pair pair = tin();
    const struct sinusoid_fit *closure = &sinusoid_fits[SINUSOID_FIT_THESIS];
    for (int plastic = 0; plastic < 2; plastic++)
        for (double gamma = 0.6; gamma < 1.7; gamma += 0.2) {
            struct power_law law = {.alpha = 0.085 * pow(3e-6, 1.5 - gamma), .gamma = gamma};
            double length = 3e-5, shortest = 1e-6, area = 1, measured = 1, load = 1e-4;
            for (double n = 1; length / n >= convergence_atom_m; n++) {
                double amplitude = power_law_amplitude(&law, length / n);
                struct sinusoid_scale scale = sinusoid_scale(amplitude, n / length, &pair, plastic);
                struct sinusoid_cell cell;
                sinusoid_press(&cell, &scale, closure, load * pair.effective_modulus_Pa / area, false);
                area *= cell.area_ratio;
                if (length / n >= shortest * (1 - 1e-9))
                    measured = area;
            }
            struct convergence_extension found = convergence_extend(&law, length, shortest, &pair, plastic, load);
            assert_near(found.area_measured, measured, 1e-12);
            assert_near(found.area_extended, area, 3e-3);
            assert_true(isfinite(found.settled_m) == (gamma >= 1));
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gamma_decides),
        cmocka_unit_test(extension_matches_every_scale),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
