/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/roughness.h"
#include "support.h"

/* A sine of k periods in N points, closed forms: central differences give A cos(theta) sin(kh)/h, second differences
 * -4 sin²(kh/2)/h² z; the two end points, which have no neighbours, are taken out of the sums of cos² and sin². */
TEST_CASE(test_a_sine_wave)
{
    enum { POINTS = 4096, PERIODS = 4 };
    const double amplitude_m = 3e-7, spacing_m = 2e-7, step = 2 * M_PI * PERIODS / POINTS;
    double height_m[POINTS];
    for (size_t j = 0; j < POINTS; j++)
        height_m[j] = amplitude_m * sin(step * (double)j);
    struct roughness r = roughness_of_heights(height_m, POINTS, spacing_m);
    assert_near(r.rq_m, amplitude_m / sqrt(2), 1e-13);
    assert_near(r.m0_m2, amplitude_m * amplitude_m / 2, 1e-13);
    assert_near(r.ra_m, amplitude_m * 2 * PERIODS / (POINTS * tan(step / 2)), 1e-13); /* -> 2A/pi */
    assert_near(r.ra_m, amplitude_m * 2 / M_PI, 1e-5);
    assert_near(r.pv_m, 2 * amplitude_m, 1e-13);
    double slope = amplitude_m * sin(step) / spacing_m, curvature = amplitude_m * pow(2 * sin(step / 2) / spacing_m, 2);
    double cosines = POINTS / 2.0 - 1 - pow(cos(step), 2), sines = POINTS / 2.0 - pow(sin(step), 2);
    assert_near(r.m2, slope * slope * cosines / (POINTS - 2), 1e-12);
    assert_near(r.m4_per_m2, curvature * curvature * sines / (POINTS - 2), 1e-9);
    double wave_number = step / spacing_m; /* -> A²k²/2, A²k⁴/2 */
    assert_near(r.m2, amplitude_m * amplitude_m / 2 * pow(wave_number, 2), 1e-3);
    assert_near(r.m4_per_m2, amplitude_m * amplitude_m / 2 * pow(wave_number, 4), 1e-3);
}

/* A parabola over uneven positions has its one curvature, and on even ones both functions agree. */
TEST_CASE(test_uneven_points)
{
    double x_m[64], even_m[64], height_m[64], slopes = 0;
    for (int j = 0; j < 64; j++) {
        x_m[j] = (j + 0.4 * sin(j)) * 1e-6;
        even_m[j] = j * 1e-6;
        height_m[j] = 0.5 * 1024 * x_m[j] * x_m[j];
    }
    for (int j = 1; j < 63; j++)
        slopes += pow(1024 * (x_m[j + 1] + x_m[j - 1]) / 2, 2) / 62;
    struct roughness r = roughness_of_points(x_m, height_m, 64);
    assert_near(r.m4_per_m2, 1024.0 * 1024, 1e-9);
    assert_near(r.m2, slopes, 1e-12);
    r = roughness_of_points(even_m, height_m, 64);
    struct roughness uniform = roughness_of_heights(height_m, 64, 1e-6);
    assert_near(r.m4_per_m2, uniform.m4_per_m2, 1e-9);
    assert_near(r.m2, uniform.m2, 1e-12);
    assert_near(r.rq_m, uniform.rq_m, 0);
}

TEST_CASE(test_three_points)
{
    const double height_m[3] = {1e-6, -2e-6, 4e-6};
    struct roughness r = roughness_of_heights(height_m, 3, 1e-6);
    assert_near(r.m0_m2, 7e-12, 1e-14);
    assert_near(r.ra_m, 7e-6 / 3, 1e-14);
    assert_near(r.m2, 1.5 * 1.5, 1e-14);
    assert_near(r.m4_per_m2, 81e12, 1e-14);
    assert_near(r.pv_m, 6e-6, 1e-14);
}

TEST_CASE(test_moments_of_the_spectrum)
{
    double amplitude_m[] = {4e-7, 0, 1e-8};
    struct spectrum spectrum = {amplitude_m, 3, 6e-6, true};
    struct roughness r = {.rq_m = 1, .ra_m = 2, .pv_m = 3};
    roughness_from_spectrum(&r, &spectrum);
    double first = 2 * M_PI / 6e-6, last = 3 * first;
    assert_near(r.m0_m2, 0.5 * 16e-14 + 1e-16, 1e-14);
    assert_near(r.m2, 0.5 * 16e-14 * pow(first, 2) + 1e-16 * pow(last, 2), 1e-14);
    assert_near(r.m4_per_m2, 0.5 * 16e-14 * pow(first, 4) + 1e-16 * pow(last, 4), 1e-14);
    assert_true(r.rq_m == 1 && r.ra_m == 2 && r.pv_m == 3);
}

TEST_CASE(test_averages)
{
    const struct roughness scans[3] = {
        {.rq_m = 1, .ra_m = 1, .pv_m = 5, .m0_m2 = 1, .m2 = 10, .m4_per_m2 = 100},
        {.rq_m = 2, .ra_m = 2, .pv_m = 9, .m0_m2 = 4, .m2 = 20, .m4_per_m2 = 300},
        {.rq_m = 4, .ra_m = 6, .pv_m = 7, .m0_m2 = 16, .m2 = 60, .m4_per_m2 = 800},
    };
    struct roughness mean = scans[0];
    roughness_average(&mean, &scans[1], 1);
    roughness_average(&mean, &scans[2], 2);
    assert_near(mean.m0_m2, 7, 1e-14);
    assert_near(mean.rq_m, sqrt(7), 1e-14);
    assert_near(mean.ra_m, 3, 1e-14);
    assert_near(mean.m2, 30, 1e-14);
    assert_near(mean.m4_per_m2, 400, 1e-14);
    assert_near(mean.pv_m, 9, 0);
}

/* sigma_s² = m0 (1 - limit/Nayak), limit = 3.717e-4 (6 pi sqrt3/0.375)²/pi, from eta and R written out. */
TEST_CASE(test_the_least_nayak_parameter)
{
    const double limit = 3.717e-4 * pow(6 * sqrt(3) / 0.375, 2) * M_PI;
    assert_within(limit, 0.8968, 5e-5);
    struct roughness r = {.m0_m2 = 1e-12, .m2 = 0.01};
    for (int e = 1; e <= 9; e++) {
        struct asperities a;
        r.m4_per_m2 = limit * (1 + pow(10, -e)) * r.m2 * r.m2 / r.m0_m2;
        if (e <= 3) {
            expect_ok(roughness_asperities, &a, &r);
            assert_near(a.sigma_s_m, sqrt(r.m0_m2 * pow(10, -e)), pow(10, -e) + 1e-6);
        } else { /* what is left is the rounding of the printed 3.717e-4 */
            expect_fails(STATUS_MODEL, "", roughness_asperities, &a, &r);
        }
        r.m4_per_m2 = limit * (1 - pow(10, -e)) * r.m2 * r.m2 / r.m0_m2;
        expect_fails(STATUS_MODEL, "", roughness_asperities, &a, &r);
        assert_true(isnan(a.sigma_s_m));
        assert_near(a.nayak, limit * (1 - pow(10, -e)), 1e-12);
        assert_true(a.density_per_m2 > 0 && a.radius_m > 0 && a.offset_m > 0 && a.sigma_m > 0);
    }
    struct asperities a;
    struct status status = {0};
    r.m4_per_m2 = 0.5 * r.m2 * r.m2 / r.m0_m2;
    assert_int_equal(roughness_asperities(&a, &r, &status), STATUS_MODEL);
    assert_non_null(strstr(status.message, "Nayak parameter 0.5 is not above 0.897"));
    assert_non_null(strstr(status.message, "models: [multiscale]")); /* the remedy */
}

TEST_CASE(test_a_flat_profile_has_no_asperities)
{
    static const double heights_m[][4] = {{0, 0, 0, 0}, {-3e-9, -1e-9, 1e-9, 3e-9}}; /* level, and without curvature */
    for (int k = 0; k < 2; k++) {
        struct asperities a;
        struct roughness r = roughness_of_heights(heights_m[k], 4, 1e-6);
        r.m4_per_m2 = r.m4_per_m2 < 1e-6 ? 0 : r.m4_per_m2; /* rounding of the second differences */
        expect_fails(STATUS_MODEL, "flat", roughness_asperities, &a, &r);
        assert_true(isnan(a.density_per_m2) && isnan(a.radius_m) && isnan(a.nayak));
        assert_near(a.sigma_m, r.rq_m, 1e-15);
    }
}

/* Central differences of +1, -1, +1 ... are 0, or what is left of rounding after a line was taken out. */
TEST_CASE(test_no_slope_but_rounding)
{
    static const double m2[] = {0, 1e-33, 1e-28};
    for (int k = 0; k < 3; k++) {
        struct asperities a;
        struct roughness r = {.m0_m2 = 1e-12, .m2 = m2[k], .m4_per_m2 = 1e13};
        assert_true(isnan(roughness_nayak(&r)));
        expect_fails(STATUS_MODEL, "rises nowhere", roughness_asperities, &a, &r);
    }
    struct roughness some = {.m0_m2 = 1e-12, .m2 = 1e-10, .m4_per_m2 = 1e13};
    assert_near(roughness_nayak(&some), 1e21, 1e-14);
}
