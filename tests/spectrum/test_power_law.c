/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/power_law.h"
#include "support.h"

#include <gsl/gsl_randist.h>

static const double all_m[2] = {0, INFINITY};

/* Amplitudes for one test; the last harmonic is no Nyquist one. */
static struct {
    double amplitude_m[20000];
    struct spectrum spectrum;
} sample;

static struct spectrum *sample_law(size_t count, double length_m, double alpha, double gamma)
{
    sample.spectrum = (struct spectrum){.amplitude_m = sample.amplitude_m, .count = count, .length_m = length_m};
    for (size_t i = 0; i < count; i++)
        sample.amplitude_m[i] = alpha * pow(length_m / (double)(i + 1), gamma);
    return &sample.spectrum;
}

static void scatter(gsl_rng *random, double decades)
{
    for (size_t i = 0; i < sample.spectrum.count; i++)
        sample.amplitude_m[i] *= pow(10, gsl_ran_gaussian(random, decades));
}

static double wavelength_m(const struct spectrum *spectrum, size_t i)
{
    return spectrum->length_m / (double)(i + 1);
}

TEST_CASE(test_an_exact_law_comes_back)
{
    static const struct {
        double alpha, gamma, length_m;
        size_t count;
    } laws[] = {
        {0.13, 1.6, 3.1e-4, 620}, {0.085, 1.5, 3e-4, 600}, {0.037, 1.4, 6.7e-4, 1340}, {0.006, 1, 1.07e-3, 2140},
        {1e-6, 0, 1e-3, 50},      {1e3, 2.5, 1e-2, 20000}, {1e-9, -0.5, 1e-3, 3},
    };
    for (size_t l = 0; l < sizeof laws / sizeof *laws; l++) {
        struct spectrum *spectrum = sample_law(laws[l].count, laws[l].length_m, laws[l].alpha, laws[l].gamma);
        struct power_law law = power_law_fit(spectrum, all_m);
        assert_near(law.alpha, laws[l].alpha, 1e-10);
        assert_within(law.gamma, laws[l].gamma, 1e-10);
        assert_within(law.misfit_decades, 0, 1e-6); /* the root of a sum that rounds at 1e-14 */
        assert_within(law.gamma_error, 0, 1e-6);
        assert_within(power_law_error_decades(&law, 1), 0, 1e-5);
        assert_int_equal(law.harmonics, laws[l].count);
        assert_near(law.band_m[0], laws[l].length_m / (double)laws[l].count, 1e-14);
        assert_near(law.band_m[1], laws[l].length_m, 1e-14);
        assert_true(isnan(law.knee_m) && isnan(law.gamma_above) && isnan(law.gamma_below));
        assert_near(power_law_amplitude(&law, 5e-6), laws[l].alpha * pow(5e-6, laws[l].gamma), 1e-9);
    }
}

/* The textbook formulas for a straight line y = a + b x, centred, in long double, on natural logarithms instead of
 * decimal ones. */
static void assert_textbook_line(const struct power_law *law, const struct spectrum *spectrum, size_t first,
                                 size_t last)
{
    long double n = (long double)(last - first + 1), x_mean = 0, y_mean = 0, xx = 0, xy = 0, squares = 0;
    for (size_t i = first; i <= last; i++) {
        x_mean += logl(wavelength_m(spectrum, i)) / n;
        y_mean += logl(spectrum->amplitude_m[i]) / n;
    }
    for (size_t i = first; i <= last; i++) {
        long double x = logl(wavelength_m(spectrum, i)) - x_mean;
        xx += x * x;
        xy += x * (logl(spectrum->amplitude_m[i]) - y_mean);
    }
    long double slope = xy / xx, intercept = y_mean - slope * x_mean;
    for (size_t i = first; i <= last; i++) {
        long double residual = logl(spectrum->amplitude_m[i]) - intercept - slope * logl(wavelength_m(spectrum, i));
        squares += residual * residual;
    }
    long double variance = squares / (n - 2);
    assert_near(law->gamma, (double)slope, 1e-10);
    assert_near(law->alpha, (double)expl(intercept), 1e-9);
    assert_near(law->gamma_error, (double)sqrtl(variance / xx), 1e-9);
    double lever = log(law->wavelength_m) - (double)x_mean;
    assert_near(law->amplitude_error_decades * M_LN10,
                sqrt((double)variance * (1 / (double)n + lever * lever / (double)xx)), 1e-9);
    assert_near(law->amplitude_m, (double)expl(intercept + slope * logl(law->wavelength_m)), 1e-9);
    assert_near(law->misfit_decades, (double)(sqrtl(squares / n) / logl(10)), 1e-9);
    assert_int_equal(law->harmonics, last - first + 1);
}

TEST_CASE(test_standard_errors)
{
    gsl_rng *random = support_random();
    for (size_t count = 3; count < 20000; count = 3 * count + 1) {
        struct spectrum *spectrum = sample_law(count, 3e-4, 0.085, 1.5);
        scatter(random, 0.28);
        struct power_law law = power_law_fit(spectrum, all_m);
        assert_textbook_line(&law, spectrum, 0, count - 1);
    }
}

TEST_CASE(test_the_band_is_kept)
{
    gsl_rng *random = support_random();
    struct spectrum *spectrum = sample_law(600, 3e-4, 0.085, 1.5);
    scatter(random, 0.2);
    for (size_t i = 0; i < 600; i++)
        if (i < 4 || i > 299)
            spectrum->amplitude_m[i] = 1;            /* rubbish outside */
    const double band_m[2] = {3e-4 / 300, 3e-4 / 5}; /* borders on a harmonic belong to it */
    struct power_law law = power_law_fit(spectrum, band_m);
    assert_textbook_line(&law, spectrum, 4, 299);
    assert_near(law.band_m[0], band_m[0], 1e-12);
    assert_near(law.band_m[1], band_m[1], 1e-12);
    const double narrower_m[2] = {band_m[0] * 1.0001, band_m[1] * 0.9999};
    law = power_law_fit(spectrum, narrower_m);
    assert_textbook_line(&law, spectrum, 5, 298);
}

TEST_CASE(test_amplitudes_of_zero_are_left_out)
{
    struct spectrum *spectrum = sample_law(100, 3e-4, 0.085, 1.5);
    for (size_t i = 0; i < 100; i += 3)
        spectrum->amplitude_m[i] = 0;
    struct power_law law = power_law_fit(spectrum, all_m);
    assert_int_equal(law.harmonics, 66);
    assert_near(law.gamma, 1.5, 1e-10);
    assert_near(law.alpha, 0.085, 1e-10);
}

static void assert_no_fit(const struct spectrum *spectrum, const double band_m[2], size_t harmonics)
{
    struct power_law law = power_law_fit(spectrum, band_m);
    assert_int_equal(law.harmonics, harmonics);
    assert_true(isnan(law.alpha) && isnan(law.amplitude_m) && isnan(law.gamma) && isnan(law.gamma_error));
    assert_true(isnan(law.misfit_decades) && isnan(law.knee_m) && isnan(power_law_amplitude(&law, 1e-5)));
}

TEST_CASE(test_fewer_than_three_harmonics_give_no_fit)
{
    const double two_m[2] = {3e-4 / 11.5, 3e-4 / 9.5}, none_m[2] = {1, 2};
    assert_no_fit(sample_law(2, 3e-4, 0.085, 1.5), all_m, 2);
    assert_no_fit(sample_law(100, 3e-4, 0.085, 1.5), two_m, 2);
    assert_no_fit(sample_law(100, 3e-4, 0.085, 1.5), none_m, 0);
    assert_no_fit(sample_law(100, 3e-4, 0, 1.5), all_m, 0);
}

/* Two laws that meet at 20 um, 30 harmonics above it and 570 below: with little scatter the knee is found where it is,
 * with that of a Gaussian surface within a factor of 3. */
TEST_CASE(test_a_knee_is_found)
{
    const double knee_m = 2e-5;
    gsl_rng *random = support_random();
    for (int k = 0; k < 40; k++) {
        double decades = k % 2 ? 0.03 : 0.278, factor = k % 2 ? 1.2 : 3;
        struct spectrum *spectrum = sample_law(600, 6e-4, 0.05, 1.5);
        for (size_t i = 0; i < 600; i++)
            if (wavelength_m(spectrum, i) < knee_m)
                spectrum->amplitude_m[i] *= pow(wavelength_m(spectrum, i) / knee_m, 1.5); /* gamma 3 below */
        scatter(random, decades);
        struct power_law law = power_law_fit(spectrum, all_m);
        assert_true(law.knee_m > knee_m / factor && law.knee_m < knee_m * factor);
        assert_within(law.gamma_above, 1.5, 2 * decades);
        assert_within(law.gamma_below, 3, 0.5 * decades);
    }
}

/* log10 of a Rayleigh amplitude: what a harmonic of a Gaussian random surface has. */
static double rayleigh_decades(gsl_rng *random)
{
    return log10(gsl_ran_rayleigh(random, 1));
}

TEST_CASE(test_no_knee_in_one_law_with_gaussian_scatter)
{
    enum { SURFACES = 200 };
    gsl_rng *random = support_random();
    size_t knees = 0;
    for (size_t k = 0; k < SURFACES; k++) {
        struct spectrum *spectrum = sample_law(40 + 10 * k, 3e-4, 0.085, 1.5);
        for (size_t i = 0; i < spectrum->count; i++)
            spectrum->amplitude_m[i] *= pow(10, k % 2 ? rayleigh_decades(random) : gsl_ran_gaussian(random, 0.4));
        struct power_law law = power_law_fit(spectrum, all_m);
        assert_true(!isnan(law.knee_m) == !isnan(law.gamma_above) && !isnan(law.knee_m) == !isnan(law.gamma_below));
        knees += isnan(law.knee_m) ? 0 : 1;
    }
    assert_true(knees <= 2);
}

/* Delta = 1e-6 (lambda/L)^20 over 1e-25 m: alpha is 1e494. */
TEST_CASE(test_an_alpha_beyond_double_is_no_fit)
{
    struct spectrum *spectrum = sample_law(40, 1, 1e-6, 20);
    assert_near(power_law_fit(spectrum, all_m).alpha, 1e-6, 1e-9);
    spectrum->length_m = 1e-25;
    struct power_law law = power_law_fit(spectrum, all_m);
    assert_int_equal(law.harmonics, 40);
    assert_true(isnan(law.alpha) && isnan(law.amplitude_m) && isnan(law.gamma) && isnan(law.misfit_decades));
    spectrum = sample_law(40, 1, 1e-6, -20);
    spectrum->length_m = 1e-25; /* 1e-506 */
    law = power_law_fit(spectrum, all_m);
    assert_true(isnan(law.alpha) && isnan(law.gamma));
}
