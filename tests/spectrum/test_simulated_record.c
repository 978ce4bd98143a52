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
    struct status status = {0};
    assert_int_equal(simulated_record_prepare(&spectrum, square_m2, points, &status), STATUS_OK);
    return spectrum;
}

static void draw(double *height_m, const struct simulated_record *spectrum, unsigned long seed)
{
    struct status status = {0};
    assert_int_equal(simulated_record_draw(height_m, spectrum, seed, &status), STATUS_OK);
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
    struct status status = {0};
    for (unsigned long r = 0; r < RECORDS; r++) {
        draw(height_m, &spectrum, r);
        assert_int_equal(multitaper_square(again, height_m, POINTS, &status), STATUS_OK);
        for (size_t n = 10; n <= multitaper_count(POINTS); n++)
            mean[n] += again[n - 1] / square_m2[n - 1] / RECORDS;
    }
    for (size_t n = 10; n <= multitaper_count(POINTS); n++)
        assert_within(mean[n], 1, 0.13); /* 5 sqrt(0.2/400), and a bias of 1 % */
    simulated_record_free(&spectrum);
}

/** The first heights of a record as they are defined, from the generator. */
static void draw_by_hand(double *height_m, const struct simulated_record *spectrum, unsigned long seed)
{
    size_t longer = spectrum->points * SIMULATED_RECORD_LONGER, waves = longer / 2;
    double *record = fftw_alloc_real(longer);
    fftw_complex *wave = fftw_alloc_complex(waves + 1);
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    assert_true(record && wave && random);
    gsl_rng_set(random, seed);
    for (size_t k = 1; k <= waves; k++) {
        wave[k][0] = gsl_ran_gaussian_ziggurat(random, spectrum->deviation_m[k]) / 2;
        wave[k][1] = gsl_ran_gaussian_ziggurat(random, spectrum->deviation_m[k]) / 2;
    }
    wave[0][0] = wave[0][1] = wave[waves][1] = 0;
    wave[waves][0] *= M_SQRT2;
    fft_backward(record, wave, longer);
    memcpy(height_m, record, spectrum->points * sizeof *height_m);
    fftw_free(record);
    fftw_free(wave);
    gsl_rng_free(random);
}

/* Numbers are kept from record to record: of whatever length, in whatever order, a seed's are the generator's. */
TEST_CASE(test_what_is_kept_changes_nothing)
{
    static const size_t points[] = {64, 20, 4096, 16, 65};
    static const unsigned long seeds[] = {3, 511, 512, 100000}; /* the latter two are not kept */
    static double square_m2[4096], height_m[4096], by_hand[4096];
    for (size_t p = 0; p < sizeof points / sizeof *points; p++)
        for (size_t s = 0; s < sizeof seeds / sizeof *seeds; s++) {
            law(square_m2, points[p], 1.2);
            struct simulated_record spectrum = prepare(square_m2, points[p]);
            draw(height_m, &spectrum, seeds[s]);
            draw_by_hand(by_hand, &spectrum, seeds[s]);
            assert_memory_equal(height_m, by_hand, points[p] * sizeof *height_m);
            simulated_record_free(&spectrum);
        }
    law(square_m2, 4096, 1.2); /* more seeds than there is room for numbers of such records */
    struct simulated_record spectrum = prepare(square_m2, 4096);
    for (unsigned long seed = 0; seed < 80; seed++) {
        draw(height_m, &spectrum, seed);
        draw_by_hand(by_hand, &spectrum, seed);
        assert_memory_equal(height_m, by_hand, sizeof height_m);
    }
    simulated_record_free(&spectrum);
}

TEST_CASE(test_what_cannot_be_simulated)
{
    double square_m2[POINTS];
    struct simulated_record spectrum;
    memset(square_m2, 0, sizeof square_m2); /* constant heights */
    struct status status = {0};
    assert_int_equal(simulated_record_prepare(&spectrum, square_m2, POINTS, &status), STATUS_SCAN);
    assert_non_null(strstr(status.message, "no power"));
    assert_false(simulated_record_possible(square_m2, POINTS));
    law(square_m2, POINTS, 1);
    assert_true(simulated_record_possible(square_m2, POINTS));
    assert_true(simulated_record_possible(square_m2, SIMULATED_RECORD_LEAST_POINTS));
    assert_false(simulated_record_possible(square_m2, SIMULATED_RECORD_LEAST_POINTS - 1));
}
