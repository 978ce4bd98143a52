/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/convergence.h"
#include "contact/sinusoid.h"
#include "model_support.h"

/** Chapter 6.2: gamma >= 1 settles (the second half of the scales changes nothing), elastic gamma < 1 keeps
 * falling. */
TEST_CASE(gamma_decides)
{
    struct material_pair pair = model_support_tin();
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

/** The tail is the law at the short end of what is known, whatever the long harmonics are and whatever is beyond. */
TEST_CASE(the_tail_is_the_short_end)
{
    for (double gamma = -0.5; gamma < 70; gamma = gamma * 3 + 2) { /* to the flank of a filter: it tells nothing */
        struct spectrum spectrum = model_support_law(1e-3, exp(10.4 * gamma) * 1e-9, gamma, 500);
        spectrum.amplitude_m[1] *= 100;
        struct convergence_tail tail = convergence_tail(&spectrum, 500);
        if (gamma > 3) {
            assert_true(isnan(tail.gamma));
            continue;
        }
        assert_near(tail.gamma, gamma, 1e-9);
        assert_near(convergence_tail_amplitude(&tail, 2e-6), spectrum.amplitude_m[499], 1e-9);
        assert_true(tail.wavelength_m > 2e-6 && tail.wavelength_m < 2e-6 * sqrt(10));
        for (int n = 1; n < 158; n++) /* below 500/sqrt(10) another law: it does not matter */
            spectrum.amplitude_m[n - 1] = 1e-9 * pow(n, -0.3);
        assert_near(convergence_tail(&spectrum, 500).gamma, gamma, 1e-9);
        spectrum.amplitude_m[499] = 1e-20; /* rounding */
        assert_near(convergence_tail(&spectrum, 499).gamma, gamma, 1e-9);
    }
    struct spectrum short_one = model_support_law(1e-5, 0.1, 1.5, 3); /* harmonics 1, 2, 3: two in the half decade */
    assert_near(convergence_tail(&short_one, 3).gamma, 1.5, 1e-9);
    short_one.amplitude_m[1] = 0;
    assert_true(isnan(convergence_tail(&short_one, 3).gamma));
}

/** The shortcut for gamma < 1 against visiting every scale; the early stop for gamma >= 1 likewise. The measured part
 * is the surface's own: one harmonic far off its law. */
TEST_CASE(extension_matches_every_scale)
{
    struct material_pair pair = model_support_tin();
    const struct sinusoid_fit *closure = &sinusoid_fits[SINUSOID_FIT_THESIS];
    for (int plastic = 0; plastic < 2; plastic++)
        for (double gamma = 0.65; gamma < 1.7; gamma += 0.2) {
            double length = 3e-5, area = 1, measured = 1, load = 1e-4, alpha = 0.085 * pow(3e-6, 1.5 - gamma);
            struct spectrum spectrum = model_support_law(length, alpha, gamma, 30);
            spectrum.amplitude_m[1] *= 5;
            struct convergence_tail tail = convergence_tail(&spectrum, 30);
            for (double n = 1; length / n >= convergence_atom_m; n++) {
                double amplitude = n <= 30 ? spectrum.amplitude_m[(size_t)n - 1] : alpha * pow(length / n, gamma);
                struct sinusoid_scale scale = sinusoid_scale(amplitude, n / length, &pair, plastic);
                struct sinusoid_cell cell;
                sinusoid_press(&cell, &scale, closure, load * pair.effective_modulus_Pa / area, false);
                area *= cell.area_ratio;
                if (n <= 30)
                    measured = area;
            }
            struct convergence_extension found = convergence_extend(&spectrum, &tail, &pair, plastic, load);
            assert_near(found.area_measured, measured, 1e-12);
            assert_near(found.area_extended, area, 3e-3);
        }
}
