/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/fft.h"
#include "spectrum/multitaper.h"
#include "spectrum/simulated_record.h"
#include "support.h"
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

enum { POINTS = 512 };

static void law(double *square_m2, size_t points, double gamma)
{
    for (size_t n = 1; n <= multitaper_count(points); n++)
        square_m2[n - 1] = pow(1e-7 * pow((double)n, -gamma), 2);
}

static struct simulated_record prepare(const double *square_m2, size_t points)
{
    struct simulated_record spectrum;
    expect_ok(simulated_record_prepare, &spectrum, square_m2, points);
    return spectrum;
}

static void draw(double *height_m, const struct simulated_record *spectrum, unsigned long seed)
{
    expect_ok(simulated_record_draw, height_m, spectrum, seed);
}

/* Every frequency of an exact law has the law's density: at k/(4L), a quarter of the square; that of harmonic 1 below.
 */
TEST_CASE(test_density_of_an_exact_law)
{
    for (size_t points = 16; points <= POINTS; points += 31)
        for (double gamma = -1; gamma <= 3; gamma += 0.4) {
            double square_m2[POINTS];
            law(square_m2, points, gamma);
            struct simulated_record spectrum = prepare(square_m2, points);
            assert_int_equal(spectrum.points, points);
            double most = (double)multitaper_count(points);
            for (size_t k = 1; k <= 2 * points; k++) {
                double n = fmin(fmax((double)k / 4, 1), most), expected = pow(1e-7 * pow(n, -gamma), 2) / 4;
                assert_near(2 * pow(spectrum.deviation_m[k], 2), expected, 1e-9);
            }
            simulated_record_free(&spectrum);
        }
}

/** A roll-off inside the scan stays one: a law of harmonics 5 and on is not carried on below them. */
TEST_CASE(test_a_roll_off_is_kept)
{
    double square_m2[POINTS];
    law(square_m2, POINTS, 1.5);
    for (size_t n = 1; n < 5; n++)
        square_m2[n - 1] = square_m2[4];
    struct simulated_record spectrum = prepare(square_m2, POINTS);
    for (size_t k = 1; k <= 20; k++)
        assert_near(8 * pow(spectrum.deviation_m[k], 2), square_m2[4], 1e-12);
    simulated_record_free(&spectrum);
}

TEST_CASE(test_a_gap_in_the_spectrum_is_bridged)
{
    double square_m2[POINTS];
    law(square_m2, POINTS, 1);
    square_m2[99] = 0;
    struct simulated_record spectrum = prepare(square_m2, POINTS);
    assert_within(spectrum.deviation_m[400], 0, 0);
    assert_near(2 * pow(spectrum.deviation_m[398], 2), square_m2[98] / 8, 1e-12);
    simulated_record_free(&spectrum);
}

/* The multitaper spectrum of simulated records is that they were drawn from. */
TEST_CASE(test_the_spectrum_comes_back)
{
    enum { RECORDS = 400 };
    double square_m2[POINTS], height_m[POINTS], again[POINTS], mean[POINTS] = {0};
    law(square_m2, POINTS, 1.2);
    struct simulated_record spectrum = prepare(square_m2, POINTS);
    for (unsigned long r = 0; r < RECORDS; r++) {
        draw(height_m, &spectrum, r);
        expect_ok(multitaper_square, again, height_m, POINTS);
        for (size_t n = 10; n <= multitaper_count(POINTS); n++)
            mean[n] += again[n - 1] / square_m2[n - 1] / RECORDS;
    }
    for (size_t n = 10; n <= multitaper_count(POINTS); n++)
        assert_within(mean[n], 1, 0.13); /* 5 sqrt(0.2/400), and a bias of 1 % */
    draw(again, &spectrum, RECORDS - 1); /* a seed's record is the same whatever was drawn before */
    assert_memory_equal(again, height_m, sizeof height_m);
    draw(again, &spectrum, 0);
    assert_memory_not_equal(again, height_m, sizeof height_m);
    simulated_record_free(&spectrum);
}

TEST_CASE(test_what_cannot_be_simulated)
{
    double square_m2[POINTS];
    struct simulated_record spectrum;
    memset(square_m2, 0, sizeof square_m2); /* constant heights */
    expect_fails(STATUS_SCAN, "no power", simulated_record_prepare, &spectrum, square_m2, POINTS);
    assert_false(simulated_record_possible(square_m2, POINTS));
    law(square_m2, POINTS, 1);
    assert_true(simulated_record_possible(square_m2, POINTS));
    assert_true(simulated_record_possible(square_m2, SIMULATED_RECORD_LEAST_POINTS));
    assert_false(simulated_record_possible(square_m2, SIMULATED_RECORD_LEAST_POINTS - 1));
}
