/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A subrecord of a profile: levelled and windowed by whether it closes on itself. */
#include "members/ensemble.h"
#include "profile/profile.h"
#include "support.h"

enum { POINTS = 64 };
static const double amplitude_m = 1e-6, spacing_m = 5e-7;

static double height_m[POINTS];
static struct ensemble set;
static struct spectrum spectrum; /* the member's */
static struct roughness roughness;

static void describe(double waves, const struct record_conditioning *how)
{
    for (int i = 0; i < POINTS; i++)
        height_m[i] = amplitude_m * sin(2 * M_PI * waves * i / POINTS);
    ensemble_free(&set);
    expect_ok(ensemble_add, &set, 0, &(struct record_heights){height_m, POINTS, spacing_m}, how);
    spectrum = set.members[0].spectrum;
    roughness = set.members[0].roughness;
    assert_int_equal(spectrum.count, POINTS / 2);
    assert_near(spectrum.length_m, POINTS * spacing_m, 1e-12);
}

/* A whole number of waves: one harmonic, or under the window (1 - cos)/2 of factor w, w/2 of it and w/4 beside it. */
static void assert_window(bool windowed)
{
    double share = windowed ? record_window_hann_factor / 2 : 1;
    assert_near(spectrum.amplitude_m[2], share * amplitude_m, 1e-9);
    for (int side = -1; side <= 1; side += 2)
        assert_within(spectrum.amplitude_m[2 + side], windowed ? share / 2 * amplitude_m : 0, 1e-9 * amplitude_m);
}

TEST_CASE(the_window_of_a_subrecord)
{
    static const struct {
        enum spectrum_window window;
        bool periodic, windowed; /* the scan that it is of */
    } cases[] = {
        {SPECTRUM_WINDOW_AUTO, true, false}, {SPECTRUM_WINDOW_AUTO, false, true}, {SPECTRUM_WINDOW_NONE, false, false},
        {SPECTRUM_WINDOW_NONE, true, false}, {SPECTRUM_WINDOW_HANN, true, true},  {SPECTRUM_WINDOW_HANN, false, true},
    };
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        const struct record_conditioning how = {
            LEVEL_NONE, true, cases[c].periodic, cases[c].window, ROUGHNESS_MOMENTS_DIFFERENCE, false};
        describe(3, &how);
        assert_window(cases[c].windowed);
        assert_near(roughness.rq_m, amplitude_m * M_SQRT1_2, 1e-9); /* of the heights, not of the windowed ones */
    }
}

/* A subrecord of a periodic scan that does not close is windowed and levelled as the scene has it; moments of the
 * spectrum are those of the windowed one. */
TEST_CASE(a_subrecord_that_does_not_close)
{
    struct record_conditioning how = {LEVEL_LINE, true, true, SPECTRUM_WINDOW_AUTO, ROUGHNESS_MOMENTS_SPECTRAL, false};
    struct levelling levelling;
    struct spectrum expected;
    describe(3.25, &how);
    expect_ok(level_remove, &levelling, height_m, NULL, POINTS, spacing_m, LEVEL_LINE);
    expect_ok(spectrum_compute, &expected, height_m, POINTS, spacing_m, SPECTRUM_WINDOW_HANN);
    for (size_t i = 0; i < expected.count; i++)
        assert_near(spectrum.amplitude_m[i], expected.amplitude_m[i], 1e-12);
    assert_near(roughness.m2, spectrum_moment(&expected, 1), 1e-9);
    spectrum_free(&expected);
}

/* A line through a subrecord that closes would make a step: the mean is taken out, unless the scene states its
 * levelling.
 */
TEST_CASE(levelling_of_a_subrecord_that_closes)
{
    struct scene scene = {.level = LEVEL_LINE, .window = SPECTRUM_WINDOW_AUTO};
    struct record_conditioning how = record_conditioning_of(&scene, true);
    describe(3, &how);
    assert_window(false);
    assert_near(roughness.rq_m, amplitude_m * M_SQRT1_2, 1e-9);
    scene.level_given = true;
    how = record_conditioning_of(&scene, true);
    describe(3, &how);
    /* the line of a sine of n waves has about the slope -6/(pi n) amplitudes a record, and so 6/(pi n)^2 of its power
     */
    double left = 2 * pow(roughness.rq_m / amplitude_m, 2);
    assert_within(left, 1 - 6 / pow(M_PI * 3, 2), 0.01);
}

static int end(void **state)
{
    (void)state;
    ensemble_free(&set);
    return 0;
}

TEST_GROUP(NULL, end)
