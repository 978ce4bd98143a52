/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Missing points: bridged, cut off, counted, refused. */
#include "condition_support.h"
#include "hard_case.h"

#include <stdio.h>

HARD_CASES("Missing points")

enum { POINTS = 2000 };
static const struct profile_options as_it_is = {.level = LEVEL_NONE, .max_missing = 0.1};

static void make_wave(double *z)
{
    for (size_t i = 0; i < POINTS; i++)
        z[i] = 1e-6 * sin(2 * M_PI * (double)i / 500);
}

/* Gaps of g points in a sinusoid: a straight bridge is off by (k w)²/8 of the amplitude at most, w = (g + 1) h. */
TEST_CASE(test_gaps_in_a_sinusoid)
{
    double z[POINTS], whole[POINTS];
    make_wave(whole);
    for (size_t gap = 1; gap <= 20; gap += 19) {
        make_wave(z);
        size_t missing = 0;
        for (size_t start = 100; start + gap < POINTS; start += 400)
            for (size_t i = 0; i < gap; i++, missing++)
                z[start + i] = NAN;
        struct scan scan = scan_on(NULL, z, POINTS, 1e-6);
        struct profile profile = profile_good(&scan, &as_it_is);
        double allowed = 1e-6 * pow(2 * M_PI / 500 * (double)(gap + 1), 2) / 8, worst = 0;
        for (size_t i = 0; i < POINTS; i++)
            worst = fmax(worst, fabs(profile.height_m[i] - whole[i]));
        assert_true(worst > 0);
        hard_case("missing points: 5 gaps of 1 and of 20 points in a wave of 500", "a hole is read as a height of 0",
                  "bridged by straight lines and counted in a note", "error over the chord's, (kw)²/8", worst / allowed,
                  1);
        assert_int_equal(profile.points, POINTS);
        assert_note(
            &profile,
            filled("missing points bridged by straight lines: %zu; gaps: 5; points in the longest: %zu", missing, gap));
        profile_free(&profile);
    }
}

/* A bridge over uneven positions follows them. */
TEST_CASE(test_gaps_over_uneven_positions)
{
    double x[100], z[100];
    uint64_t seed = 5;
    for (size_t i = 0; i < 100; i++) {
        x[i] = ((double)i + 0.4 * noise(&seed)) * 1e-6;
        z[i] = i < 50 ? 0.25 * x[i] : 0.25 * x[i] + 1e-7;
    }
    z[20] = z[21] = z[70] = NAN;
    struct scan scan = scan_on(x, z, 100, 0);
    struct profile profile = profile_good(&scan, &as_it_is);
    assert_int_equal(profile.grid, PROFILE_RESAMPLED);
    assert_near(profile.measured_z_m[20], 0.25 * x[20], 1e-12);
    assert_near(profile.measured_z_m[21], 0.25 * x[21], 1e-12);
    assert_near(profile.measured_z_m[70], 0.25 * x[70] + 1e-7, 1e-12);
    profile_free(&profile);
}

TEST_CASE(test_missing_ends_are_cut_off)
{
    double z[POINTS], x[POINTS];
    for (int with_x = 0; with_x < 2; with_x++) {
        make_wave(z);
        for (size_t i = 0; i < POINTS; i++)
            x[i] = (double)i * 1e-6;
        for (size_t i = 0; i < 30; i++)
            z[i] = NAN;
        for (size_t i = POINTS - 50; i < POINTS; i++)
            z[i] = NAN;
        struct scan scan = scan_on(with_x ? x : NULL, z, POINTS, 1e-6);
        struct profile profile = profile_good(&scan, &as_it_is);
        assert_int_equal(profile.points, POINTS - 80);
        assert_near(profile.spacing_m, 1e-6, 1e-12);
        assert_memory_equal(profile.height_m, z + 30, (POINTS - 80) * sizeof *z);
        assert_note(&profile, "missing points cut off at the ends: 80");
        assert_null(find_note(&profile, "bridged"));
        profile_free(&profile);
    }
}

/* A tenth may be missing, or more where the scene allows it. */
TEST_CASE(test_too_many_are_refused)
{
    double z[POINTS];
    make_wave(z);
    for (size_t i = 5; i < POINTS; i += 10)
        z[i] = NAN;
    struct scan scan = scan_on(NULL, z, POINTS, 1e-6);
    expect_note(profile_good(&scan, &as_it_is), "straight lines: 200", true); /* exactly 10 % */
    z[1] = NAN;
    struct profile many;
    hard_case("more than a tenth missing", "bridges are most of the roughness", "refused; `max_missing` allows more",
              "read", profile_make(&many, &scan, 0, &as_it_is, &(struct status){0}) == STATUS_OK, 0);
    profile_free(&many);
    assert_profile_refused(&scan, &as_it_is,
                           "201 of 2000 heights are missing, 10.1 % where 10 % may be; allow more with "
                           "`max_missing`");
    expect_note(profile_good(&scan, &(struct profile_options){.max_missing = 0.2}), "straight lines: 201; gaps: 201",
                true);
    for (size_t i = 0; i < POINTS - 2; i++)
        z[i] = NAN;
    assert_profile_refused(&scan, &(struct profile_options){.max_missing = 0.9},
                           "export the scan with the gaps filled");
    assert_profile_refused(&scan, &(struct profile_options){.max_missing = 1}, "only 2 heights are there");
    z[POINTS - 1] = z[POINTS - 2] = NAN;
    assert_profile_refused(&scan, &(struct profile_options){.max_missing = 1}, "only 0 heights are there");
}
