/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The one criterion of heights that are not Gaussian: its limits, and chance where a scan has few long waves. */
#include "spectrum/height_law.h"
#include "spectrum/simulated_record.h"
#include "support.h"

enum { MOST = 511 };

static struct roughness with(double skewness, double kurtosis)
{
    return (struct roughness){.m0_m2 = 4e-14, .cube_m3 = skewness * 8e-21, .fourth_m4 = kurtosis * 16e-28};
}

/** Of amplitude n^-slope, `count` harmonics. */
static struct height_law find(double skewness, double kurtosis, size_t count, double slope, double scans)
{
    double amplitude_m[MOST];
    struct spectrum spectrum = {amplitude_m, count, 1e-3, false};
    struct roughness roughness = with(skewness, kurtosis);
    struct height_law law;
    struct status status = {0};
    for (size_t n = 1; n <= count; n++)
        amplitude_m[n - 1] = 1e-7 * pow((double)n, -slope);
    assert_int_equal(height_law_find(&law, &roughness, &spectrum, scans, LEVEL_LINE, &status), STATUS_OK);
    return law;
}

/* White heights of 1024 points scatter little: there the limits are the verdict, to the digit. */
TEST_CASE(the_limits)
{
    static const struct {
        double skewness, kurtosis;
        bool within;
    } cases[] = {{0, 3, true},     {0.499, 3, true}, {0.5, 3, false},   {-0.499, 3, true},
                 {-0.5, 3, false}, {0, 2.5, true},   {0, 2.45, false},  {0, 4, true},
                 {0, 4.01, false}, {0.499, 4, true}, {-1.2, 4.1, false}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct height_law law = find(cases[i].skewness, cases[i].kurtosis, MOST, 0, 1);
        assert_int_equal(law.verdict, cases[i].within ? HEIGHTS_GAUSSIAN : HEIGHTS_NOT_GAUSSIAN);
        for (int k = 0; k < 2; k++) /* nothing was simulated within them */
            assert_true(isnan(law.chance[k]) == cases[i].within);
    }
}

/* Rsk of N independent Gaussian heights has variance 6/N: 0.6 of 64 is 1.96 of its deviations, 5 % two-sided; and half
 * the variance with two scans. */
TEST_CASE(chance_is_that_of_the_scatter)
{
    struct height_law one = find(0.6, 3, 31, 0, 1), two = find(0.6, 3, 31, 0, 2);
    assert_within(one.chance[0], erfc(0.6 / sqrt(2 * 6 / 64.0)), 0.04);
    assert_within(two.chance[0], erfc(0.6 / sqrt(2 * 3 / 64.0)), 0.02);
    assert_true(one.chance[1] > 0.5 && two.chance[1] > 0.5);
    assert_int_equal(one.verdict, HEIGHTS_CANNOT_TELL);
    assert_int_equal(two.verdict, HEIGHTS_NOT_GAUSSIAN);
}

/* A scan whose longest waves are as long as itself has few independent heights; many such scans have many. */
TEST_CASE(few_long_waves_cannot_tell)
{
    struct height_law alone = find(0.6, 2.4, 60, 1.5, 1), again = find(0.6, 2.4, 60, 1.5, 1);
    assert_int_equal(alone.verdict, HEIGHTS_CANNOT_TELL);
    assert_true(alone.chance[0] > 0.1 && alone.chance[1] > 0.1);
    assert_near(again.chance[0], alone.chance[0], 0);
    assert_near(again.chance[1], alone.chance[1], 0);
    assert_int_equal(find(0.6, 2.4, 60, 1.5, 64).verdict, HEIGHTS_NOT_GAUSSIAN);
    assert_int_equal(find(3, 14, 60, 1.5, 1).verdict, HEIGHTS_NOT_GAUSSIAN);
}

/* What is within its limit is no evidence, however unlikely: Rku below its limit by chance, beside a small Rsk. */
TEST_CASE(only_what_is_beyond_counts)
{
    double amplitude_m[60], kurtosis[] = {2.49, 2.4, 2.2};
    struct spectrum spectrum = {amplitude_m, 60, 1e-3, false};
    struct status status = {0};
    size_t telling = 0;
    for (int n = 1; n <= 60; n++) /* a narrow band: Rsk next to 0, Rku anywhere above 1.5 */
        amplitude_m[n - 1] = n == 8 || n == 9 ? 1e-6 : 1e-9;
    for (size_t i = 0; i < sizeof kurtosis / sizeof *kurtosis; i++) {
        struct roughness roughness = with(0.49, kurtosis[i]);
        struct height_law law;
        assert_int_equal(height_law_find(&law, &roughness, &spectrum, 1, LEVEL_LINE, &status), STATUS_OK);
        telling += law.chance[0] < 0.025 && law.chance[1] > 0.025;
        assert_int_equal(law.verdict, law.chance[1] < 0.025 ? HEIGHTS_NOT_GAUSSIAN : HEIGHTS_CANNOT_TELL);
    }
    assert_true(telling > 0);
}

/* Without enough harmonics, or power in them, the limits alone decide. */
TEST_CASE(the_limits_alone)
{
    struct height_law short_one = find(0.6, 3, 6, 0, 1);
    assert_int_equal(short_one.verdict, HEIGHTS_NOT_GAUSSIAN);
    assert_true(isnan(short_one.chance[0]) && isnan(short_one.chance[1]));
    assert_int_equal(find(0.4, 3, 6, 0, 1).verdict, HEIGHTS_GAUSSIAN);
    assert_true(isfinite(find(0.6, 3, 7, 0, 1).chance[0]));
    double nothing_m[60] = {0};
    struct spectrum flat = {nothing_m, 60, 1e-3, false};
    struct roughness roughness = with(0.6, 3);
    struct height_law law;
    struct status status = {0};
    assert_int_equal(height_law_find(&law, &roughness, &flat, 1, LEVEL_LINE, &status), STATUS_OK);
    assert_int_equal(law.verdict, HEIGHTS_NOT_GAUSSIAN);
}

/** Share of 256 records of 31 harmonics, levelled one by one, that are as far from the median as `own`, two-sided. */
static double chance_by_hand(const struct simulated_record *record, enum level level, double own, bool kurtosis)
{
    int below = 0, above = 0;
    for (unsigned long seed = 1; seed <= 256; seed++) {
        double height_m[64];
        struct levelling levelling;
        struct status status = {0};
        assert_int_equal(simulated_record_draw(height_m, record, seed, &status), STATUS_OK);
        assert_int_equal(level_remove(&levelling, height_m, NULL, 64, 1, level, &status), STATUS_OK);
        struct roughness roughness = roughness_of_heights(height_m, 64, 1);
        double value = kurtosis ? roughness_kurtosis(&roughness) : roughness_skewness(&roughness);
        below += value <= own;
        above += value >= own;
    }
    return fmin(1, 2 * (below < above ? below : above) / 256.0);
}

/* Long waves, of which levels take out much: the chances are those of records levelled one by one, at every level. */
TEST_CASE(records_are_levelled_like_the_scan)
{
    double amplitude_m[31], square_m2[31], before = 0;
    struct spectrum spectrum = {amplitude_m, 31, 1e-3, false};
    struct simulated_record record;
    struct status status = {0};
    for (int n = 1; n <= 31; n++) {
        amplitude_m[n - 1] = 1e-7 * pow(n, -1.5);
        square_m2[n - 1] = amplitude_m[n - 1] * amplitude_m[n - 1];
    }
    assert_int_equal(simulated_record_prepare(&record, square_m2, 64, &status), STATUS_OK);
    for (int level = LEVEL_NONE; level < LEVEL_COUNT; level++) {
        struct roughness own = with(0.55, 2.4);
        struct height_law law;
        enum level taken = level == LEVEL_CIRCLE ? LEVEL_PARABOLA : (enum level)level;
        assert_int_equal(height_law_find(&law, &own, &spectrum, 1, (enum level)level, &status), STATUS_OK);
        assert_true(law.chance[0] == chance_by_hand(&record, taken, roughness_skewness(&own), false));
        assert_true(law.chance[1] == chance_by_hand(&record, taken, roughness_kurtosis(&own), true));
        assert_true(law.chance[0] + law.chance[1] != before || level == LEVEL_CIRCLE); /* it tells levels apart */
        before = law.chance[0] + law.chance[1];
    }
    simulated_record_free(&record);
}
