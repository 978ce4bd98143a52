/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "profile/level.h"
#include "support.h"

/* With points one apart the slope is one per point. */
static double profile_level(double *height_m, size_t points, enum level level)
{
    struct levelling levelling;
    struct status status = {0};
    assert_int_equal(level_remove(&levelling, height_m, NULL, points, 1, level, &status), STATUS_OK);
    return levelling.tilt;
}

enum { POINTS = 501 };

static const size_t degrees[LEVEL_COUNT] = {[LEVEL_MEAN] = 0, [LEVEL_LINE] = 1, [LEVEL_PARABOLA] = 2};

/* Random heights of a micrometre or so, never level by themselves. */
static void make_rough(double *height_m, size_t points)
{
    uint64_t seed = points;
    for (size_t j = 0; j < points; j++) {
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        height_m[j] = 1e-6 * ((double)(int64_t)seed * 0x1p-63 + 0.3 * sin(0.01 * (double)j));
    }
}

/* What is left is orthogonal to 1, u, u², as far as the level goes, and not beyond. */
TEST_CASE(test_what_is_left_is_orthogonal)
{
    double height_m[POINTS];
    for (int level = 0; level <= LEVEL_PARABOLA; level++) {
        make_rough(height_m, POINTS);
        profile_level(height_m, POINTS, (enum level)level);
        for (size_t power = 0; power <= 2; power++) {
            long double product = 0;
            for (size_t j = 0; j < POINTS; j++)
                product += height_m[j] * powl((long double)j / POINTS, (long double)power) / POINTS;
            if (level != LEVEL_NONE && power <= degrees[level])
                assert_within((double)product, 0, 1e-6 * 1e-14);
            else if (level == LEVEL_NONE || power == degrees[level] + 1)
                assert_true(fabsl(product) > 1e-10);
        }
    }
}

/* What was taken out is a polynomial of that degree: with orthogonality, this is the least-squares fit. */
TEST_CASE(test_what_is_taken_out_is_a_polynomial)
{
    double before_m[POINTS], after_m[POINTS], difference_m[POINTS];
    make_rough(before_m, POINTS);
    for (int level = LEVEL_MEAN; level <= LEVEL_PARABOLA; level++) {
        memcpy(after_m, before_m, sizeof after_m);
        profile_level(after_m, POINTS, (enum level)level);
        for (size_t j = 0; j < POINTS; j++)
            difference_m[j] = before_m[j] - after_m[j];
        for (size_t order = 0; order <= degrees[level]; order++)
            for (size_t j = 0; j + 1 < POINTS; j++)
                difference_m[j] = difference_m[j + 1] - difference_m[j];
        for (size_t j = 0; j + 1 + degrees[level] < POINTS; j++)
            assert_within(difference_m[j], 0, 1e-6 * 1e-14);
    }
    memcpy(after_m, before_m, sizeof after_m);
    assert_near(profile_level(after_m, POINTS, LEVEL_NONE), 0, 0);
    assert_memory_equal(after_m, before_m, sizeof after_m);
}

/* An added mean, line or parabola, larger than the roughness, leaves no trace beyond its rounding. */
TEST_CASE(test_an_added_polynomial_changes_nothing)
{
    static const double added_m[3] = {1e-3, 2e-4, -5e-4}; /* of u = 0...1 */
    for (size_t points = 3; points <= POINTS; points += 83)
        for (int level = LEVEL_MEAN; level <= LEVEL_PARABOLA; level++) {
            double plain_m[POINTS], bent_m[POINTS];
            make_rough(plain_m, points);
            for (size_t j = 0; j < points; j++) {
                double u = (double)j / (double)(points - 1);
                bent_m[j] = plain_m[j];
                for (size_t power = 0; power <= degrees[level]; power++)
                    bent_m[j] += added_m[power] * pow(u, (double)power);
            }
            double slope = profile_level(plain_m, points, (enum level)level);
            double bent_slope = profile_level(bent_m, points, (enum level)level);
            for (size_t j = 0; j < points; j++)
                assert_within(bent_m[j], plain_m[j], 1e-3 * 2e-15);
            double added = level == LEVEL_MEAN ? 0 : added_m[1] + (level == LEVEL_PARABOLA ? added_m[2] : 0);
            assert_within((bent_slope - slope) * (double)(points - 1), added, 1e-3 * 1e-14);
        }
}

TEST_CASE(test_the_slope_is_that_of_the_line)
{
    double height_m[100];
    for (int level = 0; level <= LEVEL_PARABOLA; level++) {
        for (int j = 0; j < 100; j++)
            height_m[j] = 5 - 0.25 * j;
        double slope = profile_level(height_m, 100, (enum level)level);
        assert_near(slope, level >= LEVEL_LINE ? -0.25 : 0, 1e-14);
    }
}

TEST_CASE(test_levelling_twice_is_levelling_once)
{
    double once_m[POINTS], twice_m[POINTS];
    for (int level = 0; level <= LEVEL_PARABOLA; level++) {
        make_rough(once_m, POINTS);
        profile_level(once_m, POINTS, (enum level)level);
        memcpy(twice_m, once_m, sizeof twice_m);
        assert_within(profile_level(twice_m, POINTS, (enum level)level), 0, 1e-6 * 1e-16);
        for (size_t j = 0; j < POINTS; j++)
            assert_within(twice_m[j], once_m[j], 1e-6 * 1e-15);
    }
}
