/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/fft.h"
#include "spectrum/multitaper.h"
#include "spectrum/power_law_scans.h"
#include "statistics/interval.h"
#include "support.h"

#include <gsl/gsl_randist.h>

enum { POINTS = 1024 };
static const double spacing_m = 1e-6;

/* Gaussian heights whose squared amplitudes have the mean (1e-9 (POINTS/n)^gamma)². */
static void draw(double *height_m, double gamma, gsl_rng *random)
{
    memset(height_m, 0, POINTS * sizeof *height_m);
    for (size_t n = 1; n < POINTS / 2; n++) {
        double size = 1e-9 * pow((double)POINTS / (double)n, gamma) / sqrt(2);
        double cosine = gsl_ran_gaussian(random, size), sine = gsl_ran_gaussian(random, size);
        for (size_t t = 0; t < POINTS; t++) {
            double angle = 2 * M_PI * (double)(n * t % POINTS) / POINTS;
            height_m[t] += cosine * cos(angle) + sine * sin(angle);
        }
    }
}

static void add(struct power_law_scans *scans, const double *height_m, double step_m)
{
    expect_ok(power_law_scans_add, scans, height_m, POINTS, spacing_m, step_m);
    power_law_scans_end_file(scans, 1, false);
}

static struct power_law_band fit(const struct power_law_scans *scans, double lambda_s_m, const double *band_m)
{
    struct power_law_band band;
    power_law_scans_fit(&band, scans, lambda_s_m, band_m);
    return band;
}

static size_t bins_used(const struct power_law_band *band, enum power_law_band_use use, double *longest_m)
{
    size_t count = 0;
    for (size_t j = 0; j < band->bins; j++)
        if (band->use[j] == use) {
            *longest_m = count == 0 ? pow(10, band->bin[j].x) : *longest_m;
            count++;
        }
    return count;
}

TEST_CASE(test_powers_are_averaged)
{
    double first_m[POINTS], second_m[POINTS], square_m2[2][POINTS];
    struct power_law_scans scans = {0};
    gsl_rng *random = support_random();
    draw(first_m, 1.3, random);
    draw(second_m, 1.3, random);
    add(&scans, first_m, 0);
    struct power_law_band one = fit(&scans, 0, NULL);
    add(&scans, second_m, 0);
    struct power_law_band two = fit(&scans, 0, NULL);
    expect_ok(multitaper_square, square_m2[0], first_m, POINTS);
    expect_ok(multitaper_square, square_m2[1], second_m, POINTS);
    assert_int_equal(scans.mean.count, multitaper_count(POINTS));
    for (size_t i = 0; i < scans.mean.count; i++)
        assert_near(scans.mean.amplitude_m[i] * scans.mean.amplitude_m[i], (square_m2[0][i] + square_m2[1][i]) / 2,
                    1e-12);
    assert_near(scans.independent, 2, 0);
    assert_near(two.bin[12].variance, one.bin[12].variance * 0.475, 0.03); /* psi'(10)/psi'(5) */
    assert_within(two.fit.gamma, 1.3, 3 * two.fit.gamma_s);

    struct power_law_band alone; /* in the band of the mean, with the error of one */
    power_law_scans_fit_alone(&alone, &scans, 1, 0, &two);
    assert_near(alone.fit.band_m[0], two.fit.band_m[0], 1e-9);
    assert_near(alone.fit.band_m[1], two.fit.band_m[1], 1e-9);
    assert_true(alone.fit.gamma != two.fit.gamma && alone.fit.gamma_s > two.fit.gamma_s);
    power_law_scans_free(&scans);
}

/* Waves below twice lambda_s, and those a digitiser's step hides, have no part. */
TEST_CASE(test_the_shortest_wave)
{
    double height_m[POINTS], longest_m = 0;
    const double step_m = 1e-7;
    struct power_law_scans scans = {0}, stepped = {0};
    gsl_rng *random = support_random();
    draw(height_m, 1.3, random);
    add(&scans, height_m, 0);
    struct power_law_band band = fit(&scans, 0, NULL);
    assert_int_equal(bins_used(&band, POWER_LAW_BAND_SHORT, &longest_m), 0);
    band = fit(&scans, 10e-6, NULL);
    assert_true(bins_used(&band, POWER_LAW_BAND_SHORT, &longest_m) >= 8);
    assert_true(longest_m < 20e-6 && longest_m > 20e-6 / pow(10, 0.1));
    assert_true(band.fit.band_m[0] >= 15e-6 && band.fit.band_m[0] < 25e-6);

    add(&stepped, height_m, step_m);
    band = fit(&stepped, 0, NULL);
    double below = 0; /* power of the harmonics whose bins are left out, against step²/6 */
    assert_true(bins_used(&band, POWER_LAW_BAND_SHORT, &longest_m) >= 4);
    for (size_t n = stepped.mean.count; n > 0 && stepped.mean.length_m / (double)n < longest_m; n--)
        below += stepped.mean.amplitude_m[n - 1] * stepped.mean.amplitude_m[n - 1] / 2;
    assert_true(below < 1.3 * step_m * step_m / 6 && below > 0.5 * step_m * step_m / 6);
    power_law_scans_free(&scans);
    power_law_scans_free(&stepped);
}

/** What the transform of a smooth record with open ends leaves at short waves, 1e-5 of its height and less, is as
 * straight as a law. */
TEST_CASE(test_what_is_left_of_a_smooth_record_is_no_law)
{
    double height_m[POINTS] = {0};
    struct power_law_scans scans = {0};
    gsl_rng *random = support_random();
    for (double waves = 0.3; waves < 20; waves += 0.7) {
        double size = 1e-6 * exp(-pow(waves / 8, 2)), phase = 2 * M_PI * gsl_rng_uniform(random);
        for (size_t t = 0; t < POINTS; t++)
            height_m[t] += size * cos(2 * M_PI * waves * (double)t / POINTS + phase);
    }
    add(&scans, height_m, 0);
    struct power_law_band band = fit(&scans, 0, NULL);
    assert_int_equal(band.law, POWER_LAW_BAND_NONE);
    const double tail_m[] = {3e-6, 15e-6}; /* asked for by name, nothing is there either */
    band = fit(&scans, 0, tail_m);
    assert_int_equal(band.law, POWER_LAW_BAND_NONE);
    power_law_scans_free(&scans);
}

TEST_CASE(test_a_given_band)
{
    double height_m[POINTS];
    const double band_m[2] = {10e-6, 150e-6};
    struct power_law_scans scans = {0};
    struct power_law_band none = fit(&scans, 0, NULL);
    assert_int_equal(none.law, POWER_LAW_BAND_NONE);
    gsl_rng *random = support_random();
    draw(height_m, 1.1, random);
    add(&scans, height_m, 0);
    struct power_law_band band = fit(&scans, 0, band_m);
    assert_int_equal(band.law, POWER_LAW_BAND_LAW);
    assert_true(band.fit.band_m[0] >= 10e-6 && band.fit.band_m[0] < 10.1e-6);
    assert_true(band.fit.band_m[1] <= 150e-6 && band.fit.band_m[1] > 125e-6);
    struct power_law law = power_law_of_band(&band, NULL);
    assert_true(power_law_holds(&law));
    assert_near(power_law_amplitude(&law, law.wavelength_m), law.amplitude_m, 1e-12);
    power_law_scans_free(&scans);
}

TEST_CASE(test_lines_are_runs_of_bins)
{
    double height_m[POINTS], line_m[LOG_BIN_MOST];
    struct power_law_scans scans = {0};
    gsl_rng *random = support_random();
    draw(height_m, 1.1, random);
    for (size_t t = 0; t < POINTS; t++) /* harmonic 64 */
        height_m[t] += 1e-6 * cos(2 * M_PI * (double)t / 16);
    add(&scans, height_m, 0);
    struct power_law_band band = fit(&scans, 0, NULL);
    assert_int_equal(power_law_band_lines(line_m, &band), 1);
    assert_within(log10(line_m[0] / 16e-6), 0, 0.1); /* a bin is a tenth of a decade wide */
    power_law_scans_free(&scans);
}

enum { LONG = 4096, SCANS = 6, SURFACES = 40 };

/** Gaussian heights of a law of amplitude (wavelength/10)^gamma, and marks every 100 points: three waves seven times as
 * high. Micrometres. */
static void draw_marked(double *height_m, double gamma, struct fft_room *room, gsl_rng *random)
{
    memset(room->transform, 0, (LONG / 2 + 1) * sizeof *room->transform);
    for (size_t n = 1; n < LONG / 2; n++)
        for (int part = 0; part < 2; part++)
            room->transform[n][part] = gsl_ran_gaussian(random, 1e-6 * pow(LONG / 10.0 / (double)n, gamma) / sqrt(8));
    assert_true(fft_backward(room->record, room->transform, LONG));
    memcpy(height_m, room->record, LONG * sizeof *height_m);
    for (int line = 1; line <= 3; line++) {
        double phase = 2 * M_PI * gsl_rng_uniform(random);
        for (size_t i = 0; i < LONG; i++)
            height_m[i] += 7e-6 * pow(10.0 / line, gamma) * cos(2 * M_PI * line * (double)i / 100 + phase);
    }
}

/** What marks leave in the spectrum beside their lines is the same in all scans: the interval of gamma over scans holds
 * it nevertheless. By the scans' scatter alone it would hold gamma of 16 of these 40 surfaces, with it 36. */
TEST_CASE(test_marks_are_in_the_interval_over_scans)
{
    gsl_rng *random = support_random();
    double *height_m = support_room(LONG * sizeof *height_m);
    struct fft_room room;
    size_t holds = 0;
    assert_true(height_m && fft_room_make(&room, LONG));
    for (int k = 0; k < SURFACES; k++) {
        double gamma = 0.8 + 0.8 * k / SURFACES, own[SCANS];
        struct power_law_scans scans = {0};
        struct interval interval;
        for (int i = 0; i < SCANS; i++) {
            draw_marked(height_m, gamma, &room, random);
            expect_ok(power_law_scans_add, &scans, height_m, LONG, spacing_m, 0);
            power_law_scans_end_file(&scans, 1, false);
        }
        struct power_law_band band = fit(&scans, 0, NULL), alone;
        assert_int_not_equal(band.law, POWER_LAW_BAND_NONE);
        for (size_t i = 0; i < SCANS; i++) {
            power_law_scans_fit_alone(&alone, &scans, i, 0, &band);
            own[i] = alone.fit.gamma;
        }
        expect_ok(interval_scans, &interval, own, NULL, SCANS, 0.95);
        double both = hypot(interval.s, band.fit.gamma_bias_s), degrees = interval.degrees * pow(both / interval.s, 4);
        holds += fabs(interval.mean - gamma) < interval_quantile(0.95, degrees) * both; /* as estimate_end() */
        power_law_scans_free(&scans);
    }
    assert_true(holds >= 34);
    fft_room_free(&room);
}
