/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "profile/profile.h"
#include "support.h"

#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

enum { MOST = 1024 };

TEST_CASE(test_the_factor_keeps_the_mean_square)
{
    assert_near(record_window_hann_factor, sqrt(8.0 / 3), 1e-15);
    for (size_t points = 3; points <= 1000; points += 37) {
        double height_m[1000], sum = 0;
        for (size_t t = 0; t < points; t++)
            height_m[t] = 1;
        record_window_hann(height_m, points);
        for (size_t t = 0; t < points; t++)
            sum += height_m[t] * height_m[t] / (double)points;
        assert_near(sum, 1, 1e-12);
        for (size_t t = 0; t < points; t++)
            assert_near(height_m[t], height_m[points - 1 - t], 1e-9);
    }
}

/* A sum of harmonics of random phase, amplitude n^-gamma. */
static void draw(double *height_m, size_t points, double gamma, gsl_rng *random)
{
    memset(height_m, 0, points * sizeof *height_m);
    for (size_t n = 1; n < points / 2; n++) {
        double amplitude = gsl_ran_rayleigh(random, 1) * pow((double)n, -gamma),
               phase = 2 * M_PI * gsl_rng_uniform(random);
        for (size_t t = 0; t < points; t++)
            height_m[t] += amplitude * cos(2 * M_PI * (double)(n * t % points) / (double)points + phase);
    }
}

/* The whole of a periodic record is periodic, half of it is not; whatever its unit, height and place. */
TEST_CASE(test_periodic_and_cut_records)
{
    enum { RECORDS = 60 };
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    size_t whole = 0, cut = 0;
    for (size_t r = 0; r < RECORDS; r++) {
        double height_m[MOST];
        draw(height_m, MOST, 1 + 0.2 * (double)(r % 4), random);
        whole += record_window_is_periodic(height_m, MOST);
        cut += record_window_is_periodic(height_m + r, MOST / 2);
        bool before = record_window_is_periodic(height_m, MOST);
        for (size_t t = 0; t < MOST; t++)
            height_m[t] = 1e-9 * height_m[t] + 1e-6;
        assert_true(record_window_is_periodic(height_m, MOST) == before);
    }
    gsl_rng_free(random);
    assert_true(whole >= RECORDS * 95 / 100);
    assert_true(cut <= RECORDS * 10 / 100);
}

TEST_CASE(test_each_condition_by_itself)
{
    double height_m[200];
    for (size_t t = 0; t < 200; t++)
        height_m[t] = sin(2 * M_PI * 3 * (double)t / 200);
    assert_true(record_window_is_periodic(height_m, 200));
    assert_false(record_window_is_periodic(height_m, 180)); /* ends at another height */
    assert_false(record_window_is_periodic(height_m, 167)); /* at the same height, on the way down */
    for (int way = 0; way < 2; way++) { /* half a wave: a kink at the first height, or at the last */
        double half_m[200];
        for (size_t t = 0; t < 200; t++)
            half_m[way ? 199 - t : t] = -sin(M_PI * (double)t / 200);
        assert_false(record_window_is_periodic(half_m, 200));
    }
    for (size_t t = 0; t < 200; t++)
        height_m[t] += 1e-3 * (double)t; /* a line opens it: hence raw heights */
    assert_false(record_window_is_periodic(height_m, 200));
}

/* Differences of -1 and 1 have the rms 1: a step of 2.9 passes, one of 3.1 does not, up or down. */
TEST_CASE(test_the_threshold_is_three)
{
    const double signs[] = {1, -1};
    for (size_t s = 0; s < 2; s++) {
        /* second differences have the rms 2 and allow 6 */
        double height_m[MOST];
        size_t points = 0;
        for (; points < MOST; points++)
            height_m[points] = signs[s] * (double)(points % 2);
        height_m[points - 1] = signs[s] * 2.9;
        assert_true(record_window_is_periodic(height_m, points));
        height_m[points - 1] = signs[s] * 3.1;
        assert_false(record_window_is_periodic(height_m, points));
    }
}

TEST_CASE(test_small_and_constant_records)
{
    const double constant[8] = {2, 2, 2, 2, 2, 2, 2, 2}, ramp[8] = {1, 2, 3, 4, 5, 6, 7, 8}, three[3] = {0, 1, 0};
    assert_true(record_window_is_periodic(constant, 8));
    assert_false(record_window_is_periodic(ramp, 8));
    assert_true(record_window_is_periodic(three, 3));
}
