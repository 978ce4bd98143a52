/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parameters: closed forms, and the values that instruments and NIST print, to their last digit. */
#include "profile/profile.h"
#include "scan/scan_support.h"
#include "spectrum/parameters.h"

enum { POINTS = 20000 };

static double z[POINTS];

struct expected {
    const char *name;
    double value, atol; /* atol of printed values: their last digit */
};

static void assert_value(const struct parameters *parameters, const char *name, double expected, double atol)
{
    double value = parameter_named(parameters, name);
    if (!(fabs(value - expected) <= atol))
        print_error("%c%s\n", parameters->letter, name);
    assert_within(value, expected, atol);
}

/** Compares with rows {name, value, atol}, lengths in m. */
#define assert_values(parameters, ...)                                                                                 \
    do {                                                                                                               \
        const struct expected rows[] = {__VA_ARGS__};                                                                  \
        for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)                                                        \
            assert_value((parameters), rows[i].name, rows[i].value, rows[i].atol);                                     \
    } while (0)

TEST_CASE(test_a_sine)
{
    double k = 2 * M_PI / 400; /* 50 waves of 100 um */
    for (size_t i = 0; i < POINTS; i++)
        z[i] = 2e-6 * sin(k * ((double)i + 0.25));
    struct parameters p = parameters_compute('P', z, POINTS, 2.5e-7, 1);
    assert_values(&p, {"a", 4e-6 / M_PI, 1e-10}, {"q", 2e-6 / sqrt(2), 1e-14}, {"p", 2e-6, 1e-10}, {"v", 2e-6, 1e-10},
                  {"z", 4e-6, 1e-10}, {"t", 4e-6, 1e-10}, {"sk", 0, 1e-9}, {"ku", 1.5, 1e-9}, {"sm", 1e-4, 1e-10},
                  {"dq", 2e-6 * 2 * M_PI / 1e-4 / sqrt(2), 2e-5}); /* six points of 20000 have no slope */
    assert_near(p.evaluation_length_m, 5e-3, 1e-12);
}

/* Quantiles of a Gaussian (Newton on erfc), in any order: skewness 0, kurtosis 3, Ra/Rq = sqrt(2/pi). */
TEST_CASE(test_a_gaussian_has_a_kurtosis_of_3)
{
    double x = -4;
    for (size_t i = 0; i < POINTS; i++) {
        for (int step = 0; step < 30; step++)
            x -= (0.5 * erfc(-x / sqrt(2)) - ((double)i + 0.5) / POINTS) * sqrt(2 * M_PI) * exp(x * x / 2);
        z[i] = 1e-6 * x;
    }
    struct parameters p = parameters_compute('P', z, POINTS, 1e-6, 1);
    assert_values(&p, {"ku", 3, 0.01}, {"sk", 0, 1e-9}, {"q", 1e-6, 1e-10}, {"a", 1e-6 * sqrt(2 / M_PI), 1e-10});
}

/* The 7-point formula is exact for polynomials up to the 6th power. */
TEST_CASE(test_slope_formula)
{
    double sum = 0;
    for (size_t i = 0; i < 40; i++) {
        double x = (double)i * 0.05 - 1;
        z[i] = 1 + x * (2 + x * (-1 + x * (0.5 + x * (3 + x * (-2 + x)))));
        double slope = 2 + x * (-2 + x * (1.5 + x * (12 + x * (-10 + x * 6))));
        sum += i >= 3 && i < 37 ? slope * slope : 0;
    }
    struct parameters p = parameters_compute('P', z, 40, 0.05, 1);
    assert_value(&p, "dq", sqrt(sum / 34), 1e-12);
    p = parameters_compute('P', z, 6, 0.05, 1);
    assert_true(isnan(parameter_named(&p, "dq")));
}

/* Five parts with waves of 1, 2, 3, 4, 5 um: p, v, z, a, q are means, t is the tallest part's. */
TEST_CASE(test_means_over_sampling_lengths)
{
    for (size_t i = 0; i < POINTS; i++)
        z[i] = (double)(i / (POINTS / 5) + 1) * 1e-6 * sin(2 * M_PI * ((double)i + 0.5) / 200);
    struct parameters p = parameters_compute('P', z, POINTS, 1e-6, 5);
    assert_values(&p, {"p", 3e-6, 1e-9}, {"v", 3e-6, 1e-9}, {"z", 6e-6, 1e-9}, {"t", 10e-6, 2e-9},
                  {"q", 3e-6 / sqrt(2), 1e-12}, {"a", 6e-6 / M_PI, 1e-9}, {"ku", 1.5, 1e-9});
    assert_int_equal(p.sampling_lengths, 5);
}

/* Ripples that cross the line are no elements; hills that stay under 10 % of the highest are none either. */
TEST_CASE(test_profile_elements)
{
    for (size_t i = 0; i < POINTS; i++)
        z[i] = 1e-6 * (sin(2 * M_PI * (double)i / 1000) + 0.05 * sin(2 * M_PI * (double)i / 37));
    struct parameters p = parameters_compute('P', z, POINTS, 1e-6, 1);
    assert_value(&p, "sm", 1e-3, 2e-6);
    for (size_t i = 0; i < POINTS; i++) { /* every other wave is 8 % as high: an element is two waves wide */
        double wave = sin(2 * M_PI * ((double)i + 0.5) / 1000);
        z[i] = 1e-6 * wave * ((i / 1000) % 2 ? 0.08 : 1);
    }
    p = parameters_compute('P', z, POINTS, 1e-6, 1);
    assert_value(&p, "sm", 2e-3, 2e-5);
    for (size_t i = 0; i < POINTS; i++)
        z[i] = 1e-6 + 1e-9 * (double)i; /* never below the line */
    p = parameters_compute('P', z, POINTS, 1e-6, 1);
    assert_true(isnan(parameter_named(&p, "sm")));
}

TEST_CASE(test_sampling_lengths_that_fit)
{
    static const struct {
        size_t points, sampling_lengths, used;
    } rows[] = {{4000, 4, 4000}, {3999, 4, 3999}, {3900, 3, 3000}, {1000, 1, 1000}, {995, 1, 995}, {1999, 2, 1999}};
    struct parameters p;
    for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
        size_t n = rows[r].points, out = (n - rows[r].used) / 2;
        for (size_t i = 0; i < n; i++) /* what lies outside is higher than anything inside */
            z[i] = i >= out && i < out + rows[r].used ? 1e-6 * sin((double)i) : 1;
        expect_ok(parameters_of_roughness, &p, z, n, 1e-6, 1e-3, NULL);
        assert_int_equal(p.letter, 'R');
        assert_int_equal(p.sampling_lengths, rows[r].sampling_lengths);
        assert_near(p.evaluation_length_m, (double)rows[r].used * 1e-6, 1e-12);
        assert_value(&p, "t", 2e-6, 1e-10);
    }
    expect_fails(STATUS_SCAN, "", parameters_of_roughness, &p, z, 900, 1e-6, 1e-3, NULL);
    expect_fails(STATUS_SCAN, "", parameters_of_roughness, &p, z, 900, 1e-6, 2e-6, NULL);
}

/* The filter runs in on half a sampling length at either end, or on what was left out there before. */
TEST_CASE(test_the_filter_runs_in)
{
    static const struct {
        size_t points;
        double margin_m[2];
        size_t sampling_lengths, first;
    } rows[] = {{5000, {0, 0}, 4, 500},          {4995, {0, 0}, 4, 500},    {4900, {0, 0}, 3, 950},
                {5000, {0.5e-3, 0.5e-3}, 5, 0},  {5000, {2e-3, 0}, 4, 250}, {2000, {0, 0}, 1, 500},
                {4800, {0.3e-3, 0.5e-3}, 4, 500}};
    struct parameters p;
    for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
        const size_t n = rows[r].points, end = rows[r].first + rows[r].sampling_lengths * 1000;
        for (size_t i = 0; i < n; i++) /* what lies outside is higher than anything inside */
            z[i] = i >= rows[r].first && i < end ? 1e-6 * sin((double)i) : 1;
        expect_ok(parameters_of_roughness, &p, z, n, 1e-6, 1e-3, rows[r].margin_m);
        assert_int_equal(p.sampling_lengths, rows[r].sampling_lengths);
        assert_within(p.first_m, (double)rows[r].first * 1e-6, 1e-12);
        assert_value(&p, "t", 2e-6, 1e-10);
    }
    const double none[2] = {0, 0};
    expect_fails(STATUS_SCAN, "half of one at either end", parameters_of_roughness, &p, z, 1900, 1e-6, 1e-3, none);
}

static struct profile real_profile(const char *name, enum level level)
{
    struct scan scan;
    struct profile profile;
    expect_ok(scan_read, &scan, filled("%s/%s", REAL_SCANS, name), &no_units);
    expect_ok(profile_make, &profile, &scan, 0, &(struct profile_options){.level = level});
    scan_free(&scan);
    return profile;
}

/* Compares with values as printed, lengths in um. */
static void assert_printed(const struct parameters *parameters, const struct expected *printed, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        double unit = strstr("sk ku dq", printed[i].name) && printed[i].name[1] ? 1 : 1e-6;
        assert_value(parameters, printed[i].name, printed[i].value * unit, 0.5000001 * printed[i].atol * unit);
    }
}

/* NIST's algorithm testing system on the NPL EDM softgauge. */
TEST_CASE(test_nist_edm)
{
    NEED_REAL_SCANS();
    static const struct expected printed[] = {{"a", .46434, 1e-5},   {"q", .55994, 1e-5}, {"sk", -.13265, 1e-5},
                                              {"ku", 2.36461, 1e-5}, {"t", 2.8623, 1e-4}, {"p", 1.39459, 1e-5},
                                              {"v", 1.4677, 1e-4},   {"dq", .10536, 1e-5}};
    static const char *const files[] = {"nist_npl_edm.xml", "npl_edm.prf", "npl_edm.sdf", "npl_edm.smd"};
    for (size_t f = 0; f < 4; f++)
        for (int level = LEVEL_NONE; level <= LEVEL_LINE; level++) { /* it has no line to lose */
            struct profile profile = real_profile(files[f], (enum level)level);
            struct parameters p = parameters_compute('P', profile.height_m, profile.points, profile.spacing_m, 1);
            assert_printed(&p, printed, sizeof printed / sizeof *printed);
            profile_free(&profile);
        }
}

/* An R profile as the instrument exports it: lambda_c 2.5 mm, four sampling lengths, nothing more to take out. */
TEST_CASE(test_mitutoyo)
{
    NEED_REAL_SCANS();
    static const struct expected printed[] = {{"a", 3.308, 1e-3},  {"q", 3.959, 1e-3}, {"t", 22.233, 1e-3},
                                              {"z", 18.485, 1e-3}, {"p", 8.244, 1e-3}, {"v", 10.240, 1e-3},
                                              {"dq", 0.157, 1e-3}};
    struct profile profile = real_profile("mitutoyo_sj_2.csv", LEVEL_NONE);
    struct parameters p;
    expect_ok(parameters_of_roughness, &p, profile.height_m, profile.points, profile.spacing_m, 2.5e-3, NULL);
    assert_int_equal(p.sampling_lengths, 4);
    assert_printed(&p, printed, sizeof printed / sizeof *printed);
    profile_free(&profile);
}
