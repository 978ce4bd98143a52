/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/multitaper.h"
#include "spectrum/power_law.h"
#include "support.h"

#include <gsl/gsl_randist.h>

enum { MOST = 20000 };

/* What a test looks at. */
static struct {
    double amplitude_m[MOST];
    struct power_law_band_spectrum spectrum;
    struct power_law_band band, other;
} sample;

static void sample_read(const char *name)
{
    struct table table = table_read(filled("statistics/%s.csv", name));
    for (size_t i = 0; i < table.rows; i++)
        sample.amplitude_m[i] = sqrt(table_number(&table, i, "square_m2"));
    sample.spectrum = (struct power_law_band_spectrum){sample.amplitude_m, table.rows, 1e-3, 1,
                                                       0}; /* length_m is set by the caller */
}

static void sample_law(size_t count, double length_m, double alpha, double gamma)
{
    for (size_t n = 1; n <= count; n++)
        sample.amplitude_m[n - 1] = alpha * pow(length_m / (double)n, gamma);
    sample.spectrum = (struct power_law_band_spectrum){sample.amplitude_m, count, length_m, 1, 0};
}

/* Multiplies each square by a mean of `of` exponential variables of mean 1. */
static void scatter(gsl_rng *random, double of)
{
    for (size_t i = 0; i < sample.spectrum.count; i++)
        sample.amplitude_m[i] *= sqrt(gsl_ran_gamma(random, of, 1 / of));
}

static const struct power_law_band *find(void)
{
    power_law_band_find(&sample.band, &sample.spectrum);
    return &sample.band;
}

/* Compares with numbers separated by spaces; "-" is none of them. */
static void assert_list(const char *list, const double *value, size_t count, double rtol)
{
    size_t found = 0;
    for (char *end; *list && strcmp(list, "-") != 0; list = end + (*end == ' '), found++) {
        double expected = strtod(list, &end);
        assert_true(found < count);
        assert_near(value[found], expected, rtol);
    }
    assert_int_equal(found, count);
}

static size_t lines_of(const struct power_law_band *band, double *line_m)
{
    size_t lines = 0;
    for (size_t j = 0; j < band->bins; j++)
        if (band->use[j] == POWER_LAW_BAND_LINE)
            line_m[lines++] = pow(10, band->bin[j].x);
    return lines;
}

TEST_CASE(test_reference_values)
{
    struct table table = table_read("statistics/power_law_band.csv");
    for (size_t r = 0; r < table.rows; r++) {
        sample_read(table_text(&table, r, "spectrum"));
        sample.spectrum.length_m = table_number(&table, r, "length_m");
        sample.spectrum.scans = table_number(&table, r, "scans");
        sample.spectrum.shortest_m = table_number(&table, r, "shortest_m");
        for (size_t n = 58; n <= 62 && n < sample.spectrum.count; n++)
            sample.amplitude_m[n - 1] = hypot(sample.amplitude_m[n - 1], sqrt(table_number(&table, r, "added_m2")));
        const struct power_law_band *band = find();
        assert_cell(band->fit.gamma, table, r, "gamma", 1e-12);
        assert_cell(band->fit.gamma_s, table, r, "gamma_s", 1e-12);
        assert_cell(band->fit.log10_amplitude, table, r, "log10_amplitude", 1e-12);
        assert_cell(band->fit.log10_amplitude_s, table, r, "log10_amplitude_s", 1e-12);
        assert_cell(log10(band->fit.wavelength_m), table, r, "log10_wavelength", 1e-12);
        assert_within(band->fit.misfit_decades, table_number(&table, r, "misfit"), 1e-12);
        assert_cell(band->fit.band_m[0], table, r, "shortest_band_m", 1e-12);
        assert_cell(band->fit.band_m[1], table, r, "longest_band_m", 1e-12);
        assert_string_equal(power_law_band_class_names[band->law], table_text(&table, r, "class"));

        double line_m[LOG_BIN_MOST];
        assert_list(table_text(&table, r, "knees_m"), band->knee_m, band->pieces - 1, 1e-12);
        assert_list(table_text(&table, r, "lines_m"), line_m, lines_of(band, line_m), 1e-12);
    }
}

TEST_CASE(test_bias_and_variance_of_log_amplitudes)
{
    struct table table = table_read("statistics/bias.csv");
    for (size_t r = 0; r < table.rows; r++) {
        double squares = table_number(&table, r, "squares");
        assert_cell(log_bin_bias(squares), table, r, "bias", 1e-12);
        /* harmonic 7 is a bin by itself */
        sample_law(7, 1, 1, 1);
        struct log_bin bin[LOG_BIN_MOST];
        double scans = squares / MULTITAPER_TAPERS;
        if (scans >= 1) {
            assert_int_equal(log_bin_fill(bin, sample.amplitude_m, 7, 1, scans, NULL), 2);
            assert_cell(bin[1].variance, table, r, "variance", 1e-12);
            assert_near(bin[1].y, log10(1 / 7.0) - table_number(&table, r, "bias"), 1e-12);
        }
    }
}

/* The sum of the definition, pair by pair. */
TEST_CASE(test_covariance_is_the_double_sum)
{
    const struct log_bin bins[] = {{.first = 5, .last = 6},   {.first = 7, .last = 7},   {.first = 8, .last = 12},
                                   {.first = 13, .last = 40}, {.first = 41, .last = 90}, {.first = 99, .last = 100}};
    for (size_t i = 0; i < 6; i++)
        for (size_t j = 0; j < 6; j++) {
            double sum = 0, pairs = 0;
            for (size_t a = bins[i].first; a <= bins[i].last; a++)
                for (size_t b = bins[j].first; b <= bins[j].last; b++, pairs++)
                    sum += multitaper_correlation(a > b ? a - b : b - a);
            assert_within(log_bin_covariance(&bins[i], &bins[j], 2), 0.0049589002603539480 * sum / pairs, 1e-15);
        }
}

TEST_CASE(test_bins_hold_every_harmonic_once)
{
    struct log_bin bin[LOG_BIN_MOST];
    sample_law(MOST, 1, 1, 1);
    const size_t split[2] = {10, 301};
    for (int s = 0; s < 2; s++)
        for (size_t count = 0; count <= MOST; count = count < 50 ? count + 1 : 3 * count) {
            size_t bins = log_bin_fill(bin, sample.amplitude_m, count, 1, 1, s ? split : NULL), next = 5;
            for (size_t j = 0; j < bins; j++) {
                assert_int_equal(bin[j].first, next);
                assert_true(bin[j].last >= bin[j].first);
                assert_int_equal(floor(10 * log10((double)bin[j].first / 5) + 1e-9),
                                 floor(10 * log10((double)bin[j].last / 5) + 1e-9));
                assert_true(
                    !s || ((bin[j].first >= 10) == (bin[j].last >= 10) && (bin[j].first > 301) == (bin[j].last > 301)));
                next = bin[j].last + 1;
            }
            assert_int_equal(next, count < 5 ? 5 : count + 1);
            assert_true(s || bins < 2 ||
                        floor(10 * log10((double)bin[1].first / 5) + 1e-9) !=
                            floor(10 * log10((double)bin[0].first / 5) + 1e-9));
        }
}

TEST_CASE(test_an_exact_law_comes_back)
{
    for (double gamma = 0.5; gamma < 2.3; gamma += 0.25) {
        gamma = gamma == 0.5 ? 0.55 : gamma;
        sample_law(2000, 4e-3, 3e-3, gamma);
        const struct power_law_band *band = find();
        double bias = pow(10, -log_bin_bias(MULTITAPER_TAPERS)); /* an exact law has no scatter to correct for */
        assert_int_equal(band->law, POWER_LAW_BAND_LAW);
        assert_int_equal(band->pieces, 1);
        assert_within(band->fit.gamma, gamma, 1e-10);
        struct power_law law = power_law_of_band(band, NULL);
        assert_near(law.alpha, 3e-3 * bias, 1e-9);
        assert_near(power_law_amplitude(&law, 7e-6), 3e-3 * bias * pow(7e-6, gamma), 1e-9);
        assert_near(band->psd_m3, pow(3e-3 * bias * pow(band->fit.wavelength_m, gamma), 2) * 2e-3, 1e-9);
        assert_near(law.amplitude_m, pow(10, band->fit.log10_amplitude), 1e-12);
        assert_within(band->fit.misfit_decades, 0, 0);
        assert_near(band->fit.band_m[0], 4e-3 / 2000, 1e-12);
        assert_near(band->fit.band_m[1], 4e-3 / (gamma > 1.75 ? 8 : 5), 1e-12); /* steep ones leak at the long end */
        for (size_t j = 0; j < band->bins; j++) {
            assert_int_equal(band->use[j], gamma > 1.75 && j < 2 ? POWER_LAW_BAND_OUTSIDE : POWER_LAW_BAND_USED);
        }
    }
}

/* gamma 1.4 between a plateau longer than harmonic 30 and noise shorter than harmonic 1500. */
static void knees(void)
{
    sample_law(8000, 1e-2, 1e-3, 1.4);
    for (size_t n = 1; n <= 8000; n++) {
        double level = 1e-3 * pow(1e-2 / 30, 1.4), noise = 1e-3 * pow(1e-2 / 1500, 1.4);
        sample.amplitude_m[n - 1] = n < 30 ? level : n > 1500 ? noise : sample.amplitude_m[n - 1];
    }
}

TEST_CASE(test_knees_bound_the_band)
{
    gsl_rng *random = support_random();
    for (int k = 0; k < 20; k++) {
        knees();
        scatter(random, 5);
        const struct power_law_band *band = find();
        assert_int_equal(band->law, POWER_LAW_BAND_LAW);
        assert_within(band->fit.gamma, 1.4, 4 * band->fit.gamma_s);
        assert_true(band->fit.gamma_s >= 0.04); /* a knee's share */
        assert_true(band->fit.log10_amplitude_s >= 0.02);
        double bias_s = band->fit.gamma_bias_s, amplitude_bias_s = band->fit.log10_amplitude_bias_s;
        assert_true(bias_s >= 0.04 && bias_s < band->fit.gamma_s);
        assert_true(amplitude_bias_s >= 0.02 && amplitude_bias_s < band->fit.log10_amplitude_s);
        assert_int_equal(band->pieces, 3);
        assert_within(log2(band->knee_m[0] / (1e-2 / 30)), 0, 1);
        assert_within(log2(band->knee_m[1] / (1e-2 / 1500)), 0, 1);
        assert_true(band->fit.band_m[1] < band->knee_m[0] && band->fit.band_m[0] > band->knee_m[1]);
        double inside = 0, all = 0;
        for (size_t n = 1; n <= 8000; n++) {
            double wavelength_m = 1e-2 / (double)n, part = pow(sample.amplitude_m[n - 1] / wavelength_m, 2);
            all += part;
            if (wavelength_m > band->fit.band_m[0] * 0.999999 && wavelength_m < band->fit.band_m[1] * 1.000001)
                inside += part;
        }
        assert_near(band->slope_share, inside / all, 1e-9);
    }
}

/* Lengths in other units, heights in other units: the exponent and the errors stay, bands and amplitudes follow. */
TEST_CASE(test_units_do_not_matter)
{
    gsl_rng *random = support_random();
    knees();
    scatter(random, 5);
    sample.other = *find();
    sample.spectrum.length_m *= 1e6;
    for (size_t i = 0; i < sample.spectrum.count; i++)
        sample.amplitude_m[i] *= 1e-9;
    const struct power_law_band *band = find(), *before = &sample.other;
    assert_int_equal(band->law, before->law);
    assert_near(band->fit.gamma, before->fit.gamma, 1e-11);
    assert_near(band->fit.gamma_s, before->fit.gamma_s, 1e-11);
    assert_near(band->fit.log10_amplitude_s, before->fit.log10_amplitude_s, 1e-11);
    assert_within(band->fit.log10_amplitude, before->fit.log10_amplitude - 9, 1e-11);
    assert_near(band->fit.wavelength_m, 1e6 * before->fit.wavelength_m, 1e-11);
    assert_near(band->slope_share, before->slope_share, 1e-11);
    for (size_t k = 0; k + 1 < band->pieces; k++)
        assert_near(band->knee_m[k], 1e6 * before->knee_m[k], 1e-11);
}

static void assert_none(const struct power_law_band *band)
{
    assert_int_equal(band->law, POWER_LAW_BAND_NONE);
    assert_true(isnan(band->fit.gamma) && isnan(band->fit.log10_amplitude) && isnan(band->slope_share));
    assert_true(isnan(band->fit.gamma_s) && isnan(band->psd_m3) && isnan(power_law_of_band(band, NULL).alpha));
    for (size_t j = 0; j < band->bins; j++)
        assert_true(band->use[j] != POWER_LAW_BAND_USED);
}

TEST_CASE(test_white_noise_is_no_law)
{
    gsl_rng *random = support_random();
    for (int k = 0; k < 50; k++) {
        sample_law(1000, 1e-3, 1e-8, 0);
        scatter(random, 5);
        assert_none(find());
    }
}

TEST_CASE(test_slope_and_width_make_the_class)
{
    static const struct {
        size_t harmonics;
        double gamma;
        enum power_law_band_class law;
    } rows[] = {{1000, 2.29, POWER_LAW_BAND_NONE}, {1000, 2.27, POWER_LAW_BAND_LAW}, /* as those of 2.2 may be found */
                {1000, 0.49, POWER_LAW_BAND_NONE}, {1000, 0.51, POWER_LAW_BAND_LAW},
                {49, 1.3, POWER_LAW_BAND_NARROW},  {50, 1.3, POWER_LAW_BAND_LAW},
                {15, 1.3, POWER_LAW_BAND_NONE},    {16, 1.3, POWER_LAW_BAND_NARROW}}; /* 0.48 decades */
    for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
        sample_law(rows[r].harmonics, 1e-3, 1, rows[r].gamma);
        if (find()->law != rows[r].law)
            fail_msg("row %zu", r);
        if (rows[r].law == POWER_LAW_BAND_NONE)
            assert_none(find());
    }
}

/* Harmonics raised by factors: lines are left out with the bin on either side, and the law comes back. */
TEST_CASE(test_lines_are_left_out)
{
    static const struct {
        double gamma;
        struct {
            size_t first, last;
            double factor;
        } raised[2];
        size_t lines;
    } rows[] = {
        {1.5, {{95, 103, 1e4}}, 2},              /* a bin ends with 99 */
        {1, {{40, 49, 6}, {50, 62, 1e3}}, 2},    /* a flank of 0.39 decades, which would bend the law */
        {1, {{50, 62, 15.8}, {63, 79, 1}}, 1},   /* a valley on its right */
        {1, {{50, 62, 15.8}, {63, 79, 2.5}}, 0}, /* none: it falls no faster than a law may */
        {1.5, {{100, 199, 1e4}}, 3},             /* a hump of 3 bins */
        {1.5, {{100, 251, 1e4}}, 0},             /* one of 4 is a knee */
    };
    for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
        double line_m[LOG_BIN_MOST];
        sample_law(2000, 1e-2, 1e-3, rows[r].gamma);
        for (size_t n = 1; n <= 2000; n++)
            for (int k = 0; k < 2; k++)
                sample.amplitude_m[n - 1] *=
                    n >= rows[r].raised[k].first && n <= rows[r].raised[k].last ? sqrt(rows[r].raised[k].factor) : 1;
        const struct power_law_band *band = find();
        if (lines_of(band, line_m) != rows[r].lines)
            fail_msg("row %zu: %zu lines", r, lines_of(band, line_m));
        size_t first = rows[r].raised[0].first, last = rows[r].raised[rows[r].raised[1].last > 0].last;
        for (size_t l = 0; l < rows[r].lines; l++)
            assert_true(line_m[l] < 1.1e-2 / (double)first && line_m[l] > 0.9e-2 / (double)last);
        if (rows[r].lines > 0)
            assert_within(band->fit.gamma, rows[r].gamma, 1e-9);
        for (size_t j = 0; j + 1 < band->bins; j++) {
            bool line = band->use[j] == POWER_LAW_BAND_LINE, next = band->use[j + 1] == POWER_LAW_BAND_LINE;
            assert_true(line == next || band->use[line ? j + 1 : j] == POWER_LAW_BAND_BESIDE);
        }
    }
}

TEST_CASE(test_few_and_empty_harmonics)
{
    for (size_t count = 0; count < 12; count++) {
        sample_law(count, 1e-3, 1, 1.3);
        assert_none(find()); /* 3 harmonics: 8 points */
    }
    memset(sample.amplitude_m, 0, sizeof sample.amplitude_m);
    sample.spectrum.count = 1000; /* constant heights */
    assert_none(find());
    for (size_t j = 0; j < sample.band.bins; j++)
        assert_int_equal(sample.band.use[j], POWER_LAW_BAND_EMPTY);
    sample_law(1000, 1e-3, 1, 1.3);
    sample.amplitude_m[99] = 0;
    const struct power_law_band *band = find();
    assert_within(band->fit.gamma, 1.3, 1e-10);
    size_t empty = 0;
    for (size_t j = 0; j < band->bins; j++)
        empty += band->use[j] == POWER_LAW_BAND_EMPTY;
    assert_int_equal(empty, 1);
}

/* Two and a half averaged scans: with their errors b(M) is right and s falls as the root of psi'(K M). */
TEST_CASE(test_averaged_scans)
{
    sample_law(1000, 1e-3, 1, 1.3);
    double s[3], amplitude[3];
    const double scans[3] = {1, 2.5, 10};
    for (int i = 0; i < 3; i++) {
        sample.spectrum.scans = scans[i];
        const struct power_law_band *band = find();
        s[i] = band->fit.gamma_s;
        amplitude[i] = band->fit.log10_amplitude + log_bin_bias(5 * scans[i]);
    }
    assert_near(s[0] / s[2], sqrt(0.22132295573711533 / 0.020201333226697125), 1e-9); /* psi'(5), psi'(50) */
    assert_true(s[1] < s[0] && s[1] > s[2]);
    assert_near(amplitude[0], amplitude[1], 1e-12);
    assert_near(amplitude[0], amplitude[2], 1e-12);
}

/* A fit in the band that was found is the same fit, less the share of knees. */
TEST_CASE(test_a_given_band)
{
    gsl_rng *random = support_random();
    sample_law(3000, 1e-3, 1, 1.3);
    scatter(random, 5);
    sample.other = *find();
    const struct power_law_band *found = &sample.other, *band = &sample.band;
    power_law_band_fit_in(&sample.band, &sample.spectrum, found->fit.band_m);
    assert_near(band->fit.gamma, found->fit.gamma, 1e-13);
    assert_near(band->fit.gamma_s, found->fit.gamma_s, 1e-13);
    assert_within(found->fit.gamma_bias_s, 0, 0); /* no knee */
    assert_within(band->fit.log10_amplitude, found->fit.log10_amplitude, 1e-12);
    assert_int_equal(band->law, found->law);

    /* bins are divided at its ends, plateaus outside do not matter */
    sample_law(3000, 1e-3, 1, 1.3);
    for (size_t n = 1; n <= 3000; n++)
        if (n < 17 || n > 911)
            sample.amplitude_m[n - 1] = sample.amplitude_m[n < 17 ? 16 : 910];
    const double given_m[2] = {1e-3 / 911, 1e-3 / 17};
    power_law_band_fit_in(&sample.band, &sample.spectrum, given_m);
    assert_int_equal(band->fit.first_harmonic, 17);
    assert_int_equal(band->fit.last_harmonic, 911);
    assert_within(band->fit.gamma, 1.3, 1e-10);
    assert_int_equal(band->pieces, 0);
    const double tiny_m[2] = {1e-3 / 911, 1e-3 / 900}, beyond_m[2] = {1, 2}, all_m[2] = {0, INFINITY};
    power_law_band_fit_in(&sample.band, &sample.spectrum, tiny_m);
    assert_none(band);
    power_law_band_fit_in(&sample.band, &sample.spectrum, beyond_m);
    assert_none(band);
    power_law_band_fit_in(&sample.band, &sample.spectrum, all_m);
    assert_int_equal(band->fit.first_harmonic, 5);
    assert_int_equal(band->fit.last_harmonic, 3000);
}

/* Bins that alternate about the law: no line, as every second is alike, and no pieces to follow them. */
TEST_CASE(test_lack_of_fit_has_a_limit)
{
    struct log_bin bin[LOG_BIN_MOST];
    for (double decades = 0.08; decades < 0.13; decades += 0.04) {
        sample_law(2000, 1e-3, 1, 1.3);
        size_t bins = log_bin_fill(bin, sample.amplitude_m, 2000, 1e-3, 1, NULL);
        for (size_t j = 0; j < bins; j++)
            for (size_t n = bin[j].first; n <= bin[j].last; n++)
                sample.amplitude_m[n - 1] *= pow(10, j % 2 ? decades : -decades);
        const struct power_law_band *band = find();
        assert_int_equal(band->pieces, 1);
        assert_int_equal(band->law, decades < 0.1 ? POWER_LAW_BAND_LAW : POWER_LAW_BAND_SCATTERED);
        assert_true(decades > 0.1 || band->fit.misfit_decades > 0.05);
    }
}

/* Between two plateaus, 5 bins: 0.498 decades of a law are none, 6 bins are. */
TEST_CASE(test_a_short_piece_is_no_candidate)
{
    for (size_t last = 315; last <= 397; last += 82) {
        sample_law(4000, 1e-3, 1, 1.2);
        for (size_t n = 1; n <= 4000; n++)
            sample.amplitude_m[n - 1] = sample.amplitude_m[(n < 100 ? 100 : n > last ? last : n) - 1];
        const struct power_law_band *band = find();
        assert_int_equal(band->pieces, 3);
        assert_int_equal(band->law, last == 315 ? POWER_LAW_BAND_NONE : POWER_LAW_BAND_NARROW);
    }
}
