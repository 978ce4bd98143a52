/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "condition_support.h"

enum { MOST = 4001 };

/* The scan that a test fills. */
static double x_m[MOST], z_m[MOST];

static double smooth(double x)
{
    return 1e-6 * (sin(2 * M_PI * x / 1e-4) + 0.5 * cos(2 * M_PI * x / 3.7e-5));
}

/* Of the first `points` of x_m (NULL where not `with_x`) and z_m. */
static struct scan sample(size_t points, bool with_x)
{
    struct scan scan = scan_on(x_m, z_m, points, 0);
    scan.x_m = with_x ? x_m : NULL;
    return scan;
}

static struct profile make(struct scan scan, enum level level)
{
    struct profile profile = profile_good(&scan, &(struct profile_options){.level = level});
    assert_int_equal(profile.points, scan.nx);
    assert_near(profile.spacing_m, scan.dx_m, 0);
    return profile;
}

TEST_CASE(test_uniform_positions_are_taken_as_they_are)
{
    for (int with_x = 0; with_x < 2; with_x++)
        for (int origin = 0; origin < 2; origin++) {
            for (size_t i = 0; i < 1000; i++) {
                x_m[i] = origin * 0.02 + (double)i * 2.5e-7;
                z_m[i] = smooth(x_m[i]);
            }
            struct profile profile = make(sample(1000, with_x), LEVEL_NONE);
            assert_int_equal(profile.grid, PROFILE_UNIFORM);
            assert_memory_equal(profile.height_m, z_m, 1000 * sizeof(double));
            assert_near(profile.tilt, 0, 0);
            profile_free(&profile);
        }
}

/* Run-up and overtravel that a header names are left out, after the high-pass, whose ends need them. */
TEST_CASE(test_run_up_and_overtravel)
{
    enum { ALL = 3000, FIRST = 500, LAST = 300 };
    for (size_t i = 0; i < ALL; i++) {
        x_m[i] = (double)i * 1e-6;
        z_m[i] = smooth(x_m[i]) + (i < FIRST || i >= ALL - LAST ? 5e-6 : 0);
    }
    struct scan scan = scan_on(NULL, z_m, ALL, 1e-6), inner = scan_on(NULL, z_m + FIRST, ALL - FIRST - LAST, 1e-6);
    scan.margin_m[0] = FIRST * 1e-6;
    scan.margin_m[1] = LAST * 1e-6;
    struct profile cut = profile_good(&scan, &profile_defaults), own = profile_good(&inner, &profile_defaults);
    assert_int_equal(cut.points, own.points);
    assert_memory_equal(cut.height_m, own.height_m, own.points * sizeof(double));
    expect_note(cut, "run-up of 0.5 mm and overtravel of 0.3 mm are left out", true);
    expect_note(own, "run-up", false);
    scan.x_m = x_m; /* with positions, too */
    cut = profile_good(&scan, &(struct profile_options){.level = LEVEL_NONE});
    assert_int_equal(cut.points, ALL - FIRST - LAST);
    assert_memory_equal(cut.height_m, z_m + FIRST, cut.points * sizeof(double));
    profile_free(&cut);
    struct profile_options high = profile_defaults;
    high.lambda_c_m = 8e-4;
    struct scan whole = scan_on(NULL, z_m, ALL, 1e-6);
    struct profile filtered = profile_good(&whole, &high);
    scan.x_m = NULL;
    cut = profile_good(&scan, &high);
    assert_int_equal(cut.points, ALL - FIRST - LAST);
    assert_memory_equal(cut.height_m, filtered.height_m + FIRST, cut.points * sizeof(double));
    profile_free(&cut);
    profile_free(&filtered);
    scan.margin_m[1] = 3e-3;
    assert_profile_refused(&scan, &profile_defaults, "leave nothing of the record");
}

/* Positions printed with few decimals: their mean spacing is used, and the heights stay. */
TEST_CASE(test_rounded_positions_are_recognised)
{
    static const double spacings_m[] = {2.5037e-7, 3.333333e-7, 5.77e-8, 1.4142136e-7};
    for (size_t s = 0; s < sizeof spacings_m / sizeof *spacings_m; s++)
        for (int origin = 0; origin < 2; origin++) {
            double digit_m = 1e-8;
            for (size_t i = 0; i < 1500; i++) {
                x_m[i] = round((origin * 1.23e-3 + (double)i * spacings_m[s]) / digit_m) * digit_m;
                z_m[i] = smooth((double)i * spacings_m[s]);
            }
            struct profile profile = make(sample(1500, true), LEVEL_NONE);
            assert_int_equal(profile.grid, PROFILE_ROUNDED);
            assert_memory_equal(profile.height_m, z_m, 1500 * sizeof(double));
            assert_near(profile.spacing_m, spacings_m[s], digit_m / (1499 * spacings_m[s]));
            profile_free(&profile);
        }
}

/* Positions that alternate are none that were rounded: what is said of both is what both are. */
TEST_CASE(test_alternating_positions)
{
    for (size_t i = 0; i < 400; i++) {
        x_m[i] = ((double)i + 0.2 * (double)(i % 2)) * 5e-7;
        z_m[i] = smooth(x_m[i]);
    }
    struct profile profile = make(sample(400, true), LEVEL_NONE);
    assert_null(find_note(&profile, "x is rounded"));
    expect_note(profile, "x has steps of a few lengths, as if rounded; its mean spacing of 0.5", true);
}

/* Rows that are missing do not make the positions rounded: the heights are interpolated. */
TEST_CASE(test_missing_rows_are_no_rounding)
{
    static const size_t missing[] = {1, 2, 10};
    for (size_t m = 0; m < 3; m++) {
        for (size_t i = 0; i < 400; i++) {
            x_m[i] = (double)(i < 60 ? i : i + missing[m]) * 5e-7;
            z_m[i] = smooth(x_m[i]);
        }
        struct profile profile = make(sample(400, true), LEVEL_NONE);
        assert_int_equal(profile.grid, PROFILE_RESAMPLED);
        assert_near(profile.height_m[300], smooth(x_m[0] + 300 * profile.spacing_m), 1e-2);
        profile_free(&profile);
    }
}

/* Fills x with steps that grow steadily from 1 to 3 (times a tenth of a micrometre or so) and z with `height`. */
static void make_uneven(size_t points, double (*height)(double))
{
    for (size_t i = 0; i < points; i++) {
        double u = (double)i / (double)(points - 1);
        x_m[i] = 1e-3 + 3e-4 * (0.5 * u + 0.5 * u * u);
        z_m[i] = height(x_m[i]);
    }
}

static double rising(double x)
{
    return 1e-6 * exp((x - 1e-3) / 1e-4);
}

/* On heights that only rise, half the spacing makes the error at least 7 times smaller; straight lines: 4 times. */
TEST_CASE(test_interpolation_is_smooth)
{
    double error[2] = {0};
    for (int k = 0; k < 2; k++) {
        size_t points = k == 0 ? 201 : 401;
        make_uneven(points, rising);
        struct profile profile = make(sample(points, true), LEVEL_NONE);
        for (size_t i = points / 10; i < points - points / 10; i++) {
            double exact = rising(x_m[0] + (double)i * profile.spacing_m);
            error[k] = fmax(error[k], fabs(profile.height_m[i] / exact - 1));
        }
        profile_free(&profile);
    }
    assert_true(error[1] > 0 && error[1] < error[0] / 7);
}

static double stairs(double x)
{
    return fmod(x, 8e-5) < 4e-5 ? 1e-6 : 3e-6;
}

static double coarse(double x)
{
    return 1e-6 * sin(x / 1.1e-6); /* a few points a wave */
}

/* Between two points the heights stay between those of the two. */
TEST_CASE(test_interpolation_does_not_overshoot)
{
    static double (*const heights[])(double) = {stairs, coarse};
    for (int h = 0; h < 2; h++) {
        make_uneven(300, heights[h]);
        struct profile profile = make(sample(300, true), LEVEL_NONE);
        assert_int_equal(profile.grid, PROFILE_RESAMPLED);
        for (size_t i = 0, k = 0; i < 299; i++) {
            double x = x_m[0] + (double)i * profile.spacing_m;
            while (x_m[k + 1] < x)
                k++;
            double low_m = fmin(z_m[k], z_m[k + 1]), high_m = fmax(z_m[k], z_m[k + 1]);
            assert_true(profile.height_m[i] >= low_m - 1e-18 && profile.height_m[i] <= high_m + 1e-18);
        }
        profile_free(&profile);
    }
}

/* Jittered points are not rounded, nor is a record half at one spacing and half at another. */
TEST_CASE(test_what_is_no_rounding)
{
    uint64_t seed = 9;
    for (int jitter = 0; jitter < 2; jitter++) {
        for (size_t i = 0; i < 1000; i++) {
            double half = i < 500 ? (double)i : 500 + 2 * ((double)i - 500);
            x_m[i] = jitter ? 2.5e-7 * ((double)i + 0.2 * noise(&seed)) : 1e-7 * half;
            z_m[i] = smooth(x_m[i]);
        }
        struct profile profile = make(sample(1000, true), LEVEL_NONE);
        assert_int_equal(profile.grid, PROFILE_RESAMPLED);
        profile_free(&profile);
    }
}

TEST_CASE(test_the_tilt_of_a_step)
{
    for (size_t i = 0; i < 400; i++) { /* a step in the middle: its line has slope 1.5 s/N (1 - 1/N²)^-1 */
        x_m[i] = (double)i * 1e-6;
        z_m[i] = i < 200 ? 0 : 1e-6;
    }
    struct profile profile = make(sample(400, true), LEVEL_LINE);
    double slope_m = 1.5e-6 / 400 / (1 - 1.0 / 160000);
    assert_near(profile.tilt, slope_m / 1e-6, 1e-12);
    profile_free(&profile);
}

TEST_CASE(test_a_row_of_a_map)
{
    for (size_t i = 0; i < 30; i++) {
        x_m[i] = (double)i * 1e-6;
        z_m[i] = (double)(i * i) * 1e-9;
    }
    struct scan scan = sample(10, false);
    scan.ny = 3;
    struct profile profile;
    expect_ok(profile_make, &profile, &scan, 2, &(struct profile_options){.level = LEVEL_NONE});
    assert_memory_equal(profile.height_m, z_m + 20, 10 * sizeof(double));
    profile_free(&profile);
}

static void assert_flat(size_t points, enum level level, const char *words)
{
    struct scan scan = sample(points, true);
    assert_profile_refused(&scan, &(struct profile_options){.level = level}, words);
}

TEST_CASE(test_flat_scans_are_refused)
{
    for (size_t i = 0; i < 50; i++) {
        x_m[i] = (double)i * 1e-6;
        z_m[i] = 2.5e-6;
    }
    for (int level = 0; level < LEVEL_COUNT; level++)
        assert_flat(50, (enum level)level, "flat: every height is 2.5e-06 m");
}

/* A straight or parabolic scan is flat once levelled: rounding errors are no roughness. */
TEST_CASE(test_scans_without_roughness_are_refused)
{
    for (int bent = 0; bent < 2; bent++) {
        for (size_t i = 0; i < 1000; i++) {
            x_m[i] = (double)i * 1e-6;
            z_m[i] = 0.1 + 0.3 * x_m[i] + bent * 2.0 * x_m[i] * x_m[i];
        }
        assert_flat(1000, LEVEL_PARABOLA, "flat");
        if (!bent)
            assert_flat(1000, LEVEL_LINE, "flat");
        struct profile profile = make(sample(1000, true), bent ? LEVEL_LINE : LEVEL_MEAN);
        profile_free(&profile);
    }
}
