/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Levelling: polynomials, arcs, robust lines, uneven positions. */
#include "condition_support.h"
#include "profile/level.h"

enum { POINTS = 4001, ROUGH = 501 };

static struct levelling level(double *z, const double *x, size_t points, double spacing_m, enum level how)
{
    struct levelling levelling;
    expect_ok(level_remove, &levelling, z, x, points, spacing_m, how);
    return levelling;
}

static const size_t degrees[LEVEL_COUNT] = {[LEVEL_MEAN] = 0, [LEVEL_LINE] = 1, [LEVEL_PARABOLA] = 2};

/* Random heights of a micrometre or so, never level by themselves. */
static void make_rough(double *height_m, size_t points)
{
    uint64_t seed = points;
    for (size_t j = 0; j < points; j++)
        height_m[j] = 1e-6 * (noise(&seed) + 0.3 * sin(0.01 * (double)j));
}

/* What is left is orthogonal to the powers of u that were taken out, and to no others. */
TEST_CASE(test_what_is_left_is_orthogonal)
{
    double height_m[ROUGH];
    for (int how = 0; how <= LEVEL_PARABOLA; how++) {
        make_rough(height_m, ROUGH);
        level(height_m, NULL, ROUGH, 1, (enum level)how);
        for (size_t power = 0; power <= 2; power++) {
            long double product = 0;
            for (size_t j = 0; j < ROUGH; j++)
                product += height_m[j] * powl((long double)j / ROUGH, (long double)power) / ROUGH;
            if (how != LEVEL_NONE && power <= degrees[how])
                assert_within((double)product, 0, 1e-6 * 1e-14);
            else if (how == LEVEL_NONE || power == degrees[how] + 1)
                assert_true(fabsl(product) > 1e-10);
        }
    }
}

/* What was taken out is a polynomial of that degree: with orthogonality, this is the least-squares fit. */
TEST_CASE(test_what_is_taken_out_is_a_polynomial)
{
    double before_m[ROUGH], after_m[ROUGH], difference_m[ROUGH];
    make_rough(before_m, ROUGH);
    for (int how = LEVEL_MEAN; how <= LEVEL_PARABOLA; how++) {
        memcpy(after_m, before_m, sizeof after_m);
        level(after_m, NULL, ROUGH, 1, (enum level)how);
        for (size_t j = 0; j < ROUGH; j++)
            difference_m[j] = before_m[j] - after_m[j];
        for (size_t order = 0; order <= degrees[how]; order++)
            for (size_t j = 0; j + 1 < ROUGH; j++)
                difference_m[j] = difference_m[j + 1] - difference_m[j];
        for (size_t j = 0; j + 1 + degrees[how] < ROUGH; j++)
            assert_within(difference_m[j], 0, 1e-6 * 1e-14);
    }
    memcpy(after_m, before_m, sizeof after_m);
    assert_near(level(after_m, NULL, ROUGH, 1, LEVEL_NONE).tilt, 0, 0);
    assert_memory_equal(after_m, before_m, sizeof after_m);
}

/* An added mean, line or parabola, larger than the roughness, is taken out to its rounding. */
TEST_CASE(test_an_added_polynomial_changes_nothing)
{
    static const double added_m[3] = {1e-3, 2e-4, -5e-4}; /* of u = 0...1 */
    for (size_t points = 3; points <= ROUGH; points += 83)
        for (int how = LEVEL_MEAN; how <= LEVEL_PARABOLA; how++) {
            double plain_m[ROUGH], bent_m[ROUGH];
            make_rough(plain_m, points);
            for (size_t j = 0; j < points; j++) {
                double u = (double)j / (double)(points - 1);
                bent_m[j] = plain_m[j];
                for (size_t power = 0; power <= degrees[how]; power++)
                    bent_m[j] += added_m[power] * pow(u, (double)power);
            }
            double slope = level(plain_m, NULL, points, 1, (enum level)how).tilt;
            double bent_slope = level(bent_m, NULL, points, 1, (enum level)how).tilt;
            for (size_t j = 0; j < points; j++)
                assert_within(bent_m[j], plain_m[j], 1e-3 * 2e-15);
            double added = how == LEVEL_MEAN ? 0 : added_m[1] + (how == LEVEL_PARABOLA ? added_m[2] : 0);
            assert_within((bent_slope - slope) * (double)(points - 1), added, 1e-3 * 1e-14);
        }
}

/* Of exact arcs nothing is left: nearly flat to steep, crowns and hollows, off the record's middle. */
TEST_CASE(test_an_arc_is_taken_out_whole)
{
    static const double radii_m[] = {1e4, 10, 0.05, 3e-3, 1.6e-3};
    static double z[POINTS];
    for (size_t r = 0; r < sizeof radii_m / sizeof *radii_m; r++)
        for (int crown = 0; crown < 2; crown++) {
            double half_m = 1e-3, spacing_m = 2 * half_m / (POINTS - 1), middle_m = 0.2e-3;
            for (size_t i = 0; i < POINTS; i++) {
                double x = -half_m + (double)i * spacing_m - middle_m;
                double depth = x * x / (radii_m[r] + sqrt(radii_m[r] * radii_m[r] - x * x));
                z[i] = 3e-3 + (crown ? -depth : depth);
            }
            struct levelling levelling = level(z, NULL, POINTS, spacing_m, LEVEL_CIRCLE);
            for (size_t i = 0; i < POINTS; i++)
                assert_within(z[i], 0, 2e-15);
            double expected = crown ? -radii_m[r] : radii_m[r];
            assert_near(levelling.radius_m, expected, radii_m[r] > 1e3 ? 1e-4 : 1e-7);
            double slope = -middle_m / radii_m[r] / sqrt(1 - pow(middle_m / radii_m[r], 2));
            assert_within(levelling.tilt, crown ? -slope : slope, 1e-9);
        }
}

/* Two points have no arc. The error is the record's: a map goes on without such a row. */
TEST_CASE(test_too_few_points_for_an_arc)
{
    struct levelling levelling;
    struct status status = {0};
    double z[] = {1e-6, 2e-6};
    assert_int_equal(level_remove(&levelling, z, NULL, 2, 1e-6, LEVEL_CIRCLE, &status), STATUS_SCAN);
    assert_string_equal(status.message, "no arc fits 2 points; take a longer scan");
}

/* What is left of any record is orthogonal to the arc's derivatives; for a flat one these are 1, x, x². */
TEST_CASE(test_an_arc_is_a_least_squares_fit)
{
    static double z[POINTS];
    uint64_t seed = 8;
    for (size_t i = 0; i < POINTS; i++)
        z[i] = 1e-7 * noise(&seed) + 1e-9 * (double)i * 1e-3;
    level(z, NULL, POINTS, 1e-6, LEVEL_CIRCLE);
    double product[3] = {0};
    for (size_t i = 0; i < POINTS; i++) {
        double u = (double)i / POINTS - 0.5;
        product[0] += z[i] / POINTS, product[1] += u * z[i] / POINTS, product[2] += u * u * z[i] / POINTS;
    }
    for (int p = 0; p < 3; p++)
        assert_within(product[p], 0, 1e-7 * 1e-6);
}

/* Every twentieth point is a spike upwards: the least-squares line tilts and rises, the robust one does not. */
TEST_CASE(test_outliers_do_not_move_the_robust_line)
{
    static double clean[POINTS], z[POINTS], plain[POINTS];
    uint64_t seed = 4;
    for (size_t i = 0; i < POINTS; i++) {
        clean[i] = 1e-7 * (noise(&seed) + noise(&seed) + noise(&seed));
        plain[i] = z[i] = clean[i] + 2e-3 * (double)i * 1e-6 + (i % 20 == 7 ? 4e-5 * (double)i / POINTS : 0);
    }
    struct levelling robust = level(z, NULL, POINTS, 1e-6, LEVEL_ROBUST);
    struct levelling line = level(plain, NULL, POINTS, 1e-6, LEVEL_LINE);
    struct levelling own = level(clean, NULL, POINTS, 1e-6, LEVEL_LINE);
    double error = fabs(robust.tilt - own.tilt - 2e-3);
    assert_true(error < 1e-6); /* 4 nm over the 4 mm; Rq is 100 nm */
    assert_true(fabs(line.tilt - own.tilt - 2e-3) > 100 * error);
    assert_true(robust.outliers >= 190 && robust.outliers <= 201); /* the smallest spikes are no outliers */
    assert_int_equal(line.outliers, 0);
    double worst = 0;
    for (size_t i = 0; i < POINTS; i++)
        worst = i % 20 == 7 ? worst : fmax(worst, fabs(z[i] - clean[i]));
    assert_true(worst < 1e-8);
}

/* Without outliers it is nearly the least-squares line; of an exact line with spikes it is that line. */
TEST_CASE(test_robust_line_of_clean_records)
{
    static double z[POINTS], plain[POINTS];
    uint64_t seed = 6;
    for (size_t i = 0; i < POINTS; i++)
        plain[i] = z[i] = 1e-7 * noise(&seed) - 1e-9 * (double)i;
    struct levelling robust = level(z, NULL, POINTS, 1e-6, LEVEL_ROBUST);
    assert_near(robust.tilt, level(plain, NULL, POINTS, 1e-6, LEVEL_LINE).tilt, 1e-3);
    assert_int_equal(robust.outliers, 0);
    for (size_t i = 0; i < 100; i++)
        z[i] = 0.25 * (double)i + (i % 10 == 3 ? 1000 : 0);
    robust = level(z, NULL, 100, 1, LEVEL_ROBUST);
    assert_near(robust.tilt, 0.25, 1e-12);
    assert_int_equal(robust.outliers, 10);
    assert_within(z[50], 0, 1e-12);
}

/* Exact polynomials over positions with steps of 1 to 3 vanish, as they would not over uniform ones. */
TEST_CASE(test_uneven_positions_count)
{
    static double x[POINTS], z[POINTS];
    for (int degree = 1; degree <= 2; degree++) {
        for (size_t i = 0; i < POINTS; i++) {
            double u = (double)i / POINTS;
            x[i] = 1e-2 + 1e-3 * (u + u * u);
            z[i] = 1e-3 + 0.02 * x[i] + (degree == 2 ? 5 * x[i] * x[i] : 0);
        }
        struct levelling levelling = level(z, x, POINTS, 0, degree == 2 ? LEVEL_PARABOLA : LEVEL_LINE);
        for (size_t i = 0; i < POINTS; i++)
            assert_within(z[i], 0, 1e-17);
        if (degree == 1)
            assert_near(levelling.tilt, 0.02, 1e-9);
    }
}

/* The notes say what was taken out. */
TEST_CASE(test_levelling_is_noted)
{
    static double z[POINTS];
    uint64_t seed = 9;
    for (size_t i = 0; i < POINTS; i++) {
        double x = ((double)i - 2000) * 1e-6;
        z[i] = 1e-7 * noise(&seed) - x * x / 2 / 0.025 + (i == 77 ? 1e-3 : 0);
    }
    struct scan scan = scan_on(NULL, z, POINTS, 1e-6);
    expect_note(profile_good(&scan, &(struct profile_options){.level = LEVEL_ROBUST}), "robust line was taken out; ",
                true);
    z[77] = z[76];
    struct profile profile = profile_good(&scan, &(struct profile_options){.level = LEVEL_CIRCLE});
    assert_note(&profile, "an arc of radius 25");
    assert_note(&profile, "mm (crown) was taken out");
    profile_free(&profile);
}
