/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One asperity at its limits: where it starts to yield, and pressed so far that a/R would exceed 1. */
#include "contact/asperity.h"
#include "hard_support.h"

HARD_CASES("One asperity, from none of it to ten radii")

static const double radius_m = 2e-5;

static struct asperity_contact press(const struct asperity *asperity, double interference_m)
{
    struct asperity_contact contact = asperity_press(asperity, interference_m);
    assert_true(isfinite(contact.area_m2) && contact.area_m2 >= 0);
    assert_true(isfinite(contact.load_N) && contact.load_N >= 0);
    assert_true(isfinite(contact.radius_m) && contact.radius_m >= 0);
    return contact;
}

/** omega = 1.9 omega_c (1 +- 1e-12): area and radius never fall, in any material; the published load steps, for
 * tin by -0.75 to -0.8 %, within 1.6 % for metals' nu, and as nu goes to 0 or 0.5 by +7.5 % or -5 %. */
TEST_CASE(yield_onset_from_both_sides)
{
    for (int y = -1; y < HARD_YIELD_RATIOS; y++)
        for (int n = 0; n < HARD_NUS; n++) {
            struct material_pair pair = y < 0 ? model_support_tin() : hard_pair(hard_yield_ratios[y], hard_nus[n]);
            struct asperity asperity = asperity_make(radius_m, &pair, true);
            double onset = asperity_yield_onset * asperity.critical_interference_m;
            struct asperity_contact below = press(&asperity, onset * (1 - 1e-12));
            struct asperity_contact at = press(&asperity, onset);
            struct asperity_contact above = press(&asperity, onset * (1 + 1e-12));
            assert_true(below.area_m2 <= at.area_m2 && at.area_m2 <= above.area_m2);
            assert_true(below.radius_m <= at.radius_m && at.radius_m <= above.radius_m);
            hard_case("onset of yielding, ω = 1.9 ω_c (1 ± 1e-12), 21 materials", "the area jumps from law to law",
                      "area and radius of both laws meet", "area, relative", off_by(above.area_m2, below.area_m2),
                      1e-11);
            double step = above.load_N / below.load_N - 1;
            if (y < 0)
                assert_true(step > -0.0080 && step < -0.0074);
            bool usual =
                pair.poisson_ratio >= 0.25 && pair.poisson_ratio <= 0.4 && hard_yield_ratios[y < 0 ? 0 : y] < 0.01;
            if (usual)
                hard_case("the JG load at the onset, ν = 0.25 to 0.4", "the published load steps there",
                          "steps as published, within what it can do", "step of the load", fabs(step), 0.016);
            else
                hard_case("the JG load at the onset, ν = 0 and 0.5 or S_y/E' = 0.05", "the same, farther from metals",
                          "a larger step, and none beyond", "step of the load", fabs(step), 0.0755);
            assert_true(step > -0.05);
        }
}

/** From no interference to ten radii, a/R far beyond 1: finite, and area, load and radius never fall but at the onset.
 */
TEST_CASE(never_falls)
{
    for (int y = 0; y < HARD_YIELD_RATIOS; y++)
        for (int n = 0; n < HARD_NUS; n++)
            for (int plastic = 0; plastic < 2; plastic++) {
                struct material_pair pair = hard_pair(hard_yield_ratios[y], hard_nus[n]);
                struct asperity asperity = asperity_make(radius_m, &pair, plastic);
                struct asperity_contact before = press(&asperity, 0);
                assert_true(before.area_m2 == 0 && before.load_N == 0 && before.radius_m == 0);
                double last = 1e-30 * radius_m, onset = asperity_yield_onset * asperity.critical_interference_m;
                for (double omega = last; omega < 10 * radius_m; omega *= omega < 1e-16 * radius_m ? 100 : 1.003) {
                    struct asperity_contact contact = press(&asperity, omega);
                    bool across = last < onset && omega >= onset;
                    hard_case("pressed by 1e-30 to 10 radii, a/R far beyond 1", "the fit of a hardness turns back",
                              "area and radius never fall", "fall of area or radius",
                              fmax(0, fmax(before.area_m2 - contact.area_m2, before.radius_m - contact.radius_m)), 0);
                    assert_true(contact.area_m2 >= before.area_m2 && contact.radius_m >= before.radius_m);
                    assert_true(across || contact.load_N >= before.load_N);
                    before = contact;
                    last = omega;
                }
                assert_true(before.radius_m > radius_m);
            }
}

/** Beyond a/R = 1 the hardness stays at that of a/R = 1: H_G = S_y (2.84 - 2 * 0.92), so the load is linear in omega.
 */
TEST_CASE(hardness_is_clamped)
{
    struct material_pair pair = hard_pair(1e-6, 0.36);
    struct asperity asperity = asperity_make(radius_m, &pair, true);
    double border = asperity_interference_at(&asperity, 1);
    for (double factor = 1; factor < 1e3; factor *= 3) {
        struct asperity_contact contact = press(&asperity, border * factor * (1 + 1e-12));
        assert_true(contact.radius_m >= radius_m);
        double flow = 4 * (2.84 - 2 * 0.92) / pair.yield_coefficient * asperity.critical_load_N;
        hard_case("a/R = 1 to 30", "the hardness of the fit goes to 0 and below",
                  "stays at that of a/R = 1, and is counted", "load, relative",
                  off_by(contact.load_N, flow * border * factor / asperity.critical_interference_m), 1e-11);
    }
}
