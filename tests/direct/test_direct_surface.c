/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct_support.h"

/** Mean square at harmonic m of the rows of n x n heights, averaged over the rows. */
static void row_powers(double *power, size_t count, const double *height, size_t n)
{
    for (size_t m = 1; m <= count; m++) {
        power[m - 1] = 0;
        for (size_t j = 0; j < n; j++) {
            double re = 0, im = 0;
            for (size_t i = 0; i < n; i++) {
                double angle = 2 * M_PI * (double)(m * i % n) / (double)n;
                re += height[j * n + i] * cos(angle) / (double)n;
                im += height[j * n + i] * sin(angle) / (double)n;
            }
            power[m - 1] += 2 * (re * re + im * im) / (double)n; /* Delta²/2 = 2 |Z/N|² */
        }
    }
}

/** The recipe surface at some points, its extremes and its rms, on three grids. */
TEST_CASE(recipe_heights)
{
    struct table table = table_read("golden/direct/random_heights.csv");
    for (size_t row = 0; row < table.rows; row++) {
        size_t n = (size_t)table_number(&table, row, "N");
        double *h = recipe_surface(n), most = -INFINITY, least = INFINITY, square = 0;
        for (size_t k = 0; k < n * n; k++) {
            most = fmax(most, h[k]);
            least = fmin(least, h[k]);
            square += h[k] * h[k] / (double)(n * n);
        }
        /* the table's first index is along y */
        assert_cell(h[0], table, row, "h_0_0", 1e-10);
        assert_cell(h[n + 2], table, row, "h_1_2", 1e-10);
        assert_cell(h[n / 2 * n + n / 4], table, row, "h_N2_N4", 1e-10);
        assert_cell(h[(n - 1) * n + 3], table, row, "h_N1_3", 1e-10);
        assert_cell(most, table, row, "max", 1e-10);
        assert_cell(least, table, row, "min", 1e-10);
        assert_cell(sqrt(square), table, row, "std", 1e-10);
    }
}

/** A law's rows come back from the synthesised surface, harmonic by harmonic, whatever the exponent; one that rises has
 * no isotropic surface. */
TEST_CASE(rows_have_the_law)
{
    enum { N = 128 };
    double *height = support_room(N * N * sizeof *height), power[N / 2];
    for (double gamma = 0.5; gamma <= 2; gamma += 0.25) {
        struct direct_law law = {1e-3, gamma, 3e-4 / 19, 3e-4, gamma < 1.2 ? 0 : 4.6}; /* without roll-off and with */
        struct direct_spectrum spectrum;
        size_t count = direct_law_harmonics(&law);
        assert_true(count == 60);
        expect_ok(direct_spectrum_of_law, &spectrum, &law);
        for (uint64_t seed = 1; seed < 3; seed++) {
            expect_ok(direct_surface_make, height, N,
                      &(struct direct_recipe){direct_spectrum_variance, &spectrum, NULL, 0}, seed);
            row_powers(power, count, height, N);
            for (size_t m = 1; m <= count; m++)
                assert_near(power[m - 1], pow(direct_law_amplitude(&law, m), 2) / 2, m < 40 ? 1e-10 : 1e-6);
        }
        direct_spectrum_free(&spectrum);
    }
    struct direct_law rising = {1e-3, -1, 3e-4 / 19, 3e-4, 0};
    struct direct_spectrum none;
    expect_fails(STATUS_MODEL, "", direct_spectrum_of_law, &none, &rising);
    direct_spectrum_free(&none);
}

/** In mid band the exact weights are those of the continuous inversion: B = alpha² L^(2 gamma)/4 Gamma(gamma +
 * 1/2)/(sqrt pi Gamma(gamma)). */
TEST_CASE(weights_near_the_integral)
{
    for (double gamma = 0.75; gamma < 1.7; gamma += 0.25) {
        struct direct_law law = {1e-3, gamma, 3e-4 / 200, 3e-4, 1};
        struct direct_spectrum spectrum;
        double b = pow(1e-3 * pow(3e-4, gamma), 2) / 4 * tgamma(gamma + 0.5) / (sqrt(M_PI) * tgamma(gamma));
        expect_ok(direct_spectrum_of_law, &spectrum, &law);
        for (size_t r = 8; r <= 16; r++)
            assert_near(spectrum.weight_m2[r - 1], b, 0.01);
        direct_spectrum_free(&spectrum);
    }
}

/** m0, m1, m2 of a law's rows. */
static void moments_of(double moments[3], const struct direct_law *law)
{
    moments[0] = moments[1] = moments[2] = 0;
    for (size_t m = 1; m <= direct_law_harmonics(law); m++)
        for (int k = 0; k < 3; k++)
            moments[k] += pow(2 * M_PI * (double)m / law->length_m, k) * pow(direct_law_amplitude(law, m), 2) / 2;
}

/** A law comes back from its moments, with a roll-off and without; one that would need another end of the range takes
 * the nearest; those of three surfaces as another program finds them. */
TEST_CASE(matched_law)
{
    struct direct_law found;
    struct table table = table_read("golden/strip/law3.csv");
    double moments[3];
    for (double gamma = 0.5; gamma <= 2; gamma += 0.5)
        for (double roll_off = 1; roll_off < 12; roll_off += 2.3) {
            struct direct_law law = {0.085, gamma, 8e-6, 3e-4, roll_off};
            moments_of(moments, &law);
            expect_ok(direct_law_match, &found, moments, 3e-4, 8e-6);
            assert_near(found.roll_off, roll_off, 1e-7);
            assert_near(found.gamma, gamma, 1e-7);
            assert_near(found.alpha, 0.085, 1e-6);
        }
    for (size_t row = 0; row < table.rows; row++) {
        static const char *const names[] = {"m0_m2", "m1_m", "m2"};
        for (int k = 0; k < 3; k++)
            moments[k] = table_number(&table, row, names[k]);
        expect_ok(direct_law_match, &found, moments, table_number(&table, row, "length_m"),
                  table_number(&table, row, "lambda_s_m"));
        assert_cell(found.gamma, table, row, "gamma", 1e-8);
        assert_cell(found.roll_off, table, row, "m_r", 1e-8);
    }
    for (int end = 0; end < 2; end++) { /* m0 and m2 stand whatever m1 says */
        double of_found[3], share = end ? 0.98 : 0.2;
        moments[1] = share * sqrt(moments[0] * moments[2]);
        expect_ok(direct_law_match, &found, moments, 5.12e-4, 8e-6);
        assert_true(end ? found.roll_off > 8 : found.roll_off == 1);
        moments_of(of_found, &found);
        assert_near(of_found[0], moments[0], 1e-9);
        assert_near(of_found[2], moments[2], 1e-9);
    }
    static const double none[][3] = {{1e-12, 1e-3, 1e9}, {1e-12, 1e-12, 1e-12}, {1e-12, 1e-8, NAN}, {1e-12, 0, 1e-4}};
    for (size_t k = 0; k < sizeof none / sizeof *none; k++)
        expect_fails(STATUS_MODEL, "", direct_law_match, &found, none[k], 3e-4, 8e-6);
}

/** A finer grid holds the same surface: point for point by interpolation as by synthesis. */
TEST_CASE(refined_surface)
{
    double *coarse = recipe_surface(64), *fine = recipe_surface(192),
           *refined = support_room(192 * 192 * sizeof *refined);
    expect_ok(direct_surface_refine, refined, 3, coarse, 64);
    for (size_t k = 0; k < 192 * 192; k++)
        assert_within(refined[k], fine[k], 1e-14);
}

static double moment(const double *values, size_t count, int power)
{
    double mean = 0, square = 0, sum = 0;
    for (size_t k = 0; k < count; k++)
        mean += values[k] / (double)count;
    for (size_t k = 0; k < count; k++) {
        square += pow(values[k] - mean, 2) / (double)count;
        sum += pow(values[k] - mean, power) / (double)count;
    }
    return sum / pow(square, power / 2.0);
}

/** Skewed heights: the surface has them to a few per cent of its moments and the spectrum exactly; the same seed the
 * same bytes, another seed another surface. */
TEST_CASE(surface_with_heights)
{
    enum { N = 128, GIVEN = 3000 };
    double *height = support_room(N * N * sizeof *height), *other = support_room(N * N * sizeof *other), given[GIVEN];
    double power[40], expected[40], scale = 1;
    for (size_t k = 0; k < GIVEN; k++) /* chi squared of 8 degrees of freedom, upside down: plateaus with pits */
        given[k] = 3 - pow(1 - 2.0 / 72 + sqrt(2.0 / 72) * 3 * cos(M_PI * ((double)k + 0.5) / GIVEN), 3);
    expect_ok(direct_surface_make, other, N, &(struct direct_recipe){recipe_variance, &scale, NULL, 0}, 1);
    row_powers(expected, 16, other, N);
    expect_ok(direct_surface_make, height, N, &(struct direct_recipe){recipe_variance, &scale, given, GIVEN}, 1);
    row_powers(power, 16, height, N);
    for (size_t m = 1; m <= 16; m++)
        assert_near(power[m - 1], expected[m - 1], 1e-10);
    assert_true(fabs(moment(other, N * N, 3)) < 0.3);
    assert_within(moment(height, N * N, 3), moment(given, GIVEN, 3), 0.1);
    assert_within(moment(height, N * N, 4), moment(given, GIVEN, 4), 0.2);
    expect_ok(direct_surface_make, other, N, &(struct direct_recipe){recipe_variance, &scale, given, GIVEN}, 1);
    assert_memory_equal(height, other, N * N * sizeof *height);
    expect_ok(direct_surface_make, other, N, &(struct direct_recipe){recipe_variance, &scale, given, GIVEN}, 2);
    assert_memory_not_equal(height, other, N * N * sizeof *height);
    given[5] = NAN;
    expect_fails(STATUS_MODEL, "", direct_surface_make, other, N,
                 &(struct direct_recipe){recipe_variance, &scale, given, GIVEN}, 2);
    expect_fails(STATUS_MODEL, "", direct_surface_make, other, N,
                 &(struct direct_recipe){recipe_variance, &scale, given, 1}, 2);
    given[0] = given[1] = 4;
    expect_fails(STATUS_MODEL, "", direct_surface_make, other, N,
                 &(struct direct_recipe){recipe_variance, &scale, given, 2}, 2);
}
