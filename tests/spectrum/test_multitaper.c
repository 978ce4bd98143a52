/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/multitaper.h"
#include "support.h"

#include <complex.h>
#include <gsl/gsl_randist.h>

/* The definition with its tapers, in long double. */
static void by_definition(double *square_m2, const double *height_m, size_t points)
{
    long double tilt = ((long double)height_m[points - 1] - height_m[0]) / (long double)(points - 1);
    for (size_t n = 1; n <= multitaper_count(points); n++) {
        long double sum = 0;
        for (size_t k = 1; k <= MULTITAPER_TAPERS; k++) {
            long double real = 0, imaginary = 0;
            for (size_t t = 1; t < points; t++) {
                long double difference = (long double)height_m[t] - height_m[t - 1] - tilt;
                long double taper = sqrtl(2.0L / (long double)points) *
                                    sinl((long double)M_PIl * (long double)(k * t) / (long double)points);
                long double angle = 2 * M_PIl * (long double)(n * t % points) / (long double)points;
                real += taper * difference * cosl(angle);
                imaginary -= taper * difference * sinl(angle);
            }
            sum += (real * real + imaginary * imaginary) / MULTITAPER_TAPERS;
        }
        long double whitening = 2 * sinl(M_PIl * (long double)n / (long double)points);
        square_m2[n - 1] = (double)(4 * sum / ((long double)points * whitening * whitening));
    }
}

static void compute(double *square_m2, const double *height_m, size_t points)
{
    expect_ok(multitaper_square, square_m2, height_m, points);
}

static void random_walk(double *height_m, size_t points, unsigned long seed)
{
    gsl_rng *random = support_random();
    gsl_rng_set(random, seed);
    for (size_t i = 0; i < points; i++)
        height_m[i] = (i > 0 ? height_m[i - 1] : 0) + gsl_ran_gaussian(random, 1e-7);
}

TEST_CASE(test_reference_values)
{
    struct table table = table_read("statistics/multitaper.csv");
    double height_m[64], square_m2[31];
    assert_int_equal(table.rows, 64);
    for (size_t i = 0; i < 64; i++)
        height_m[i] = table_number(&table, i, "height_m");
    compute(square_m2, height_m, 64);
    for (size_t n = 1; n <= 31; n++)
        assert_near(square_m2[n - 1], table_number(&table, n - 1, "square_m2"), 1e-12);
}

TEST_CASE(test_one_transform_is_the_definition)
{
    double height_m[301], square_m2[150], expected[150];
    for (size_t points = 3; points <= 301; points += points < 20 ? 1 : 47) {
        random_walk(height_m, points, points);
        compute(square_m2, height_m, points);
        by_definition(expected, height_m, points);
        for (size_t n = 1; n <= multitaper_count(points); n++)
            assert_near(square_m2[n - 1], expected[n - 1], 1e-11);
    }
}

TEST_CASE(test_counts)
{
    assert_int_equal(multitaper_count(3), 1);
    assert_int_equal(multitaper_count(8), 3);
    assert_int_equal(multitaper_count(9), 4);
}

/* A line a thousand times as high as the roughness, and any offset, leave the spectrum as it is. */
TEST_CASE(test_tilt_and_offset_do_not_matter)
{
    double height_m[500], tilted[500], square_m2[249], square_tilted[249];
    random_walk(height_m, 500, 7);
    for (size_t i = 0; i < 500; i++)
        tilted[i] = height_m[i] + 1e-3 * (double)i / 500 - 0.02;
    compute(square_m2, height_m, 500);
    compute(square_tilted, tilted, 500);
    for (size_t n = 0; n < 249; n++)
        assert_near(square_tilted[n], square_m2[n], 1e-6);
}

/* The mean over many white records is Delta² = 4 sigma²/N at every harmonic n >= 5, and the spread that of 5 squares.
 */
TEST_CASE(test_white_noise)
{
    enum { RECORDS = 2000, POINTS = 128 };
    double height_m[POINTS], square_m2[63], mean = 0, spread = 0;
    gsl_rng *random = support_random();
    for (int r = 0; r < RECORDS; r++) {
        for (size_t i = 0; i < POINTS; i++)
            height_m[i] = gsl_ran_gaussian(random, 1);
        compute(square_m2, height_m, POINTS);
        mean += square_m2[29] * POINTS / 4 / RECORDS;
        spread += pow(square_m2[29] * POINTS / 4 - 1, 2) / RECORDS;
    }
    assert_within(mean, 1, 0.05); /* 5 sqrt(0.2/2000) */
    assert_within(spread, 0.2, 0.05);
}

/* integral_0^1 2 sin(pi k t) sin(pi l t) exp(2 pi i m t) dt, from those of exp(i pi q t) */
static double complex overlap(int k, int l, int m)
{
    double complex sum = 0;
    const int q[4] = {2 * m + k - l, 2 * m - k + l, 2 * m + k + l, 2 * m - k - l};
    for (int i = 0; i < 4; i++) {
        double complex integral = q[i] == 0 ? 1 : q[i] % 2 == 0 ? 0 : -2 / (I * M_PI * q[i]);
        sum += (i < 2 ? 0.5 : -0.5) * integral;
    }
    return sum;
}

TEST_CASE(test_correlation_is_the_closed_form)
{
    for (int m = 0; m <= MULTITAPER_CORRELATED; m++) {
        double sum = 0;
        for (int k = 1; k <= MULTITAPER_TAPERS; k++)
            for (int l = 1; l <= MULTITAPER_TAPERS; l++)
                sum += pow(cabs(overlap(k, l, m)), 2) / MULTITAPER_TAPERS;
        assert_near(multitaper_correlation((size_t)m), sum, 1e-13);
    }
    assert_within(multitaper_correlation(MULTITAPER_CORRELATED + 1), 0, 0);
}

TEST_CASE(test_constant_heights_have_no_power)
{
    double height_m[8] = {3.7, 3.7, 3.7, 3.7, 3.7, 3.7, 3.7, 3.7}, square_m2[3];
    compute(square_m2, height_m, 8);
    for (size_t n = 0; n < 3; n++)
        assert_within(square_m2[n], 0, 0);
}

TEST_CASE(test_heights_that_are_no_numbers_are_refused)
{
    double square_m2[4];
    const double bad[] = {NAN, INFINITY, -INFINITY};
    for (size_t b = 0; b < 3; b++) {
        double height_m[9] = {1, 2, 1, 3, 1, 2, bad[b], 2, 1};
        struct status status = {0};
        assert_int_equal(multitaper_square(square_m2, height_m, 9, &status), STATUS_SCAN);
        assert_string_equal(status.message, "height 7 of 9 is not a finite number");
    }
    double huge[9] = {1e200, 0, 1e200, 0, 0, 1e200, 0, 0, 1};
    expect_fails(STATUS_SCAN, "", multitaper_square, square_m2, huge, 9);
}
