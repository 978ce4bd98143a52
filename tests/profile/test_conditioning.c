/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Making a profile as a whole: header spacings, filters in their order, and the warnings. */
#include "condition_support.h"
#include "scan/scan.h"

enum { POINTS = 8192 };

/* The scan that a test fills. */
static double x[POINTS], z[POINTS];

/* A smooth record: waves of 64.37 um and 1 um at 1 um spacing; no two heights are alike. */
#define WAVE 64.37
/* ISO 16610-21: share of the amplitude that the low-pass lets through. */
static double transmission(double wavelength_m, double cutoff_m)
{
    return pow(2, -pow(cutoff_m / wavelength_m, 2));
}

static void make_smooth(void)
{
    for (size_t i = 0; i < POINTS; i++)
        z[i] = 1e-6 * sin(2 * M_PI * ((double)i + 0.5) / WAVE);
}

static struct profile condition(double spacing_m, struct profile_options options)
{
    struct scan scan = scan_on(NULL, z, POINTS, spacing_m);
    return profile_good(&scan, &options);
}

/* Dektak prints x to 0.1 um and the spacing in the header, which is used if it fits. */
TEST_CASE(test_header_spacing_of_rounded_positions)
{
    static const struct {
        double nominal_m, expected_m;
        const char *note;
    } rows[] = {{0.156e-6, 0.156e-6, "the header's spacing of 0.156 um"},
                {0, 0.15625e-6, "its mean spacing of 0.1562"},
                {0.5e-6, 0.15625e-6, "its mean spacing of 0.1562"}};
    make_smooth();
    for (size_t i = 0; i < POINTS; i++)
        x[i] = round((double)i * 1.5625) * 1e-7;
    for (size_t r = 0; r < 3; r++) {
        struct scan scan = scan_on(x, z, POINTS, 0);
        scan.nominal_dx_m = rows[r].nominal_m;
        struct profile profile = profile_good(&scan, &profile_defaults);
        assert_int_equal(profile.grid, PROFILE_ROUNDED);
        assert_near(profile.spacing_m, rows[r].expected_m, 1e-4);
        assert_note(&profile, rows[r].note);
        profile_free(&profile);
    }
}

/* The filters multiply a wave by their transmissions. */
TEST_CASE(test_filters)
{
    make_smooth();
    struct profile_options options = {.lambda_s_m = 40e-6, .lambda_c_m = 100e-6};
    struct profile profile = condition(1e-6, options);
    double left = transmission(WAVE * 1e-6, 40e-6) * (1 - transmission(WAVE * 1e-6, 100e-6));
    for (size_t i = 300; i < POINTS - 300; i++)
        assert_within(profile.height_m[i], left * z[i], 1e-14);
    assert_note(&profile, "low-pass lambda_s = 40 um");
    assert_note(&profile, "high-pass lambda_c = 100 um");
    profile_free(&profile);
    const double whole_m = POINTS * 1e-6; /* and the scan is as long, but for rounding */
    expect_note(condition((1 - 4e-16) * 1e-6, (struct profile_options){.lambda_c_m = whole_m}), "high-pass", true);
    struct scan scan = scan_on(NULL, z, POINTS, 1e-6);
    assert_profile_refused(&scan, &(struct profile_options){.lambda_c_m = 0.01},
                           "lambda_c is 0.01 m, longer than the scan");
    scan = scan_on(NULL, z, POINTS, 1e-12);
    assert_profile_refused(&scan, &(struct profile_options){.lambda_s_m = 1e3},
                           "lambda_s is 1000 m, longer than the scan");
    assert_profile_refused(&scan, &(struct profile_options){.lambda_c_m = 1e-15}, "no roughness is left between");
    for (size_t i = 0; i < POINTS; i++) /* such as a row of a map whose other rows are rough */
        z[i] *= 1e-300;
    assert_profile_refused(&scan, &(struct profile_options){.lambda_s_m = 0}, "differ by no more than");
}

/* Uneven points are kept as measured, unless a filter changes them. */
TEST_CASE(test_measured_points)
{
    uint64_t seed = 1;
    make_smooth();
    for (size_t i = 0; i < POINTS; i++)
        x[i] = ((double)i + 0.3 * noise(&seed)) * 1e-6;
    struct scan scan = scan_on(x, z, POINTS, 0);
    struct profile profile = profile_good(&scan, &(struct profile_options){.level = LEVEL_NONE});
    assert_memory_equal(profile.measured_x_m, x, sizeof x);
    assert_memory_equal(profile.measured_z_m, z, sizeof z);
    assert_note(&profile, "x is uneven");
    profile_free(&profile);
    profile = profile_good(&scan, &(struct profile_options){.lambda_s_m = 8e-6});
    assert_null(profile.measured_x_m);
    assert_null(profile.measured_z_m);
    profile_free(&profile);
}

TEST_CASE(test_a_good_profile_needs_no_note)
{
    make_smooth();
    struct profile_options options = profile_defaults;
    options.tip_radius_m = 2e-6;
    struct profile profile = condition(1e-6, options);
    assert_int_equal(profile.note_count, 0);
    profile_free(&profile);
}

TEST_CASE(test_units_that_cannot_be)
{
    make_smooth();
    expect_note(condition(1e-12, profile_defaults), "is above the length of the scan", true);
    expect_note(condition(1e-9, profile_defaults), "the steepest slope is 97.6 (89 degrees)", true);
}

/* Heights rounded to q: found whatever the offset, and noted where q²/(2 h^4) is a fifth of m4. */
TEST_CASE(test_digitising)
{
    static const double offsets_m[] = {0, 3e-3, -7e-2};
    for (size_t o = 0; o < 3; o++) {
        make_smooth();
        for (size_t i = 0; i < POINTS; i++) /* a 12.9 nm converter, printed to 1 nm */
            z[i] = offsets_m[o] + round(round(z[i] / 12.9e-9) * 12.9) * 1e-9;
        assert_near(profile_digitiser_step(z, POINTS), 12.9e-9, 0.02);
        expect_note(condition(1e-6, profile_defaults), "heights come in steps of 12.", true);
    }
    make_smooth();
    assert_near(profile_digitiser_step(z, POINTS), 0, 0);
    for (size_t i = 0; i < POINTS; i++)
        z[i] = round(z[i] / 1e-9) * 1e-9; /* seen, but it makes 1 % of m4 */
    expect_note(condition(1e-6, profile_defaults), "steps of", false);
    for (size_t i = 0; i < POINTS; i++)
        z[i] = 5e-7 * sin(2 * M_PI * (double)i / 200); /* its slopes at the crests are multiples of one */
    expect_note(condition(2.5e-7, profile_defaults), "steps of", false);
    uint64_t seed = 3;
    for (size_t i = 0; i < POINTS; i++)
        z[i] = 1e-6 * noise(&seed);
    assert_near(profile_digitiser_step(z, POINTS), 0, 0);
}

/* A steep tilt makes all differences of neighbours alike, which is no digitiser; one that the instrument took out after
 * digitising shifts them all by the same amount, and the step is found all the same. */
TEST_CASE(test_digitising_under_a_tilt)
{
    static const double tilts_m[] = {0, 7.7e-9, -4.3e-7, 5e-6}; /* for each point */
    for (size_t t = 0; t < sizeof tilts_m / sizeof *tilts_m; t++) {
        make_smooth();
        for (size_t i = 0; i < POINTS; i++)
            z[i] = z[i] * 1.001 + tilts_m[t] * (double)i;
        assert_near(profile_digitiser_step(z, POINTS), 0, 0);
        make_smooth();
        for (size_t i = 0; i < POINTS; i++) /* tilted, then digitised */
            z[i] = 12.9e-9 * round((z[i] + tilts_m[t] * (double)i) / 12.9e-9);
        assert_near(profile_digitiser_step(z, POINTS), 12.9e-9, 1e-6);
        make_smooth();
        for (size_t i = 0; i < POINTS; i++) /* digitised, then a tilt taken out */
            z[i] = 12.9e-9 * round(z[i] / 12.9e-9) - tilts_m[t] * (double)i;
        assert_near(profile_digitiser_step(z, POINTS), 12.9e-9, 1e-6);
    }
}

/* White noise of 10 nm under the waves: m4 falls nearly 16 times with every other point; a filter ends the warning. */
TEST_CASE(test_noise)
{
    uint64_t seed = 2;
    make_smooth();
    for (size_t i = 0; i < POINTS; i++)
        z[i] += 1e-7 * noise(&seed);
    struct profile profile = condition(1e-6, profile_defaults);
    const char *note = find_note(&profile, "m4 is noise of the shortest wavelengths: ");
    assert_non_null(note);
    double ratio = strtod(note + strlen("m4 is noise of the shortest wavelengths: "), NULL);
    assert_true(ratio > 14 && ratio < 16);
    assert_null(find_note(&profile, "lambda_s_m")); /* the scene's key is lambda_s */
    expect_note(profile, "give lambda_s", true);
    expect_note(condition(1e-6, (struct profile_options){.lambda_s_m = 8e-6}), "m4 is noise", false);
}

/* Waves of 64.37 um and 1 um: RMS radius of curvature sqrt(2) (64.37/2 pi)² = 148 um. */
TEST_CASE(test_tip_radius)
{
    make_smooth();
    static const struct {
        double tip_m;
        bool warns;
    } rows[] = {{0, false}, {140e-6, false}, {150e-6, true}};
    for (size_t r = 0; r < 3; r++)
        expect_note(condition(1e-6, (struct profile_options){.tip_radius_m = rows[r].tip_m}),
                    "the RMS radius of curvature, 149 um, is below the tip radius", rows[r].warns);
}

TEST_CASE(test_few_points)
{
    make_smooth();
    struct scan scan = scan_on(NULL, z, 63, 1e-6);
    expect_note(profile_good(&scan, &profile_defaults), "only 63 points: the spectrum is coarse", true);
    scan.nx = 64;
    expect_note(profile_good(&scan, &profile_defaults), "points;", false);
}
