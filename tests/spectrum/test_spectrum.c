/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/spectrum.h"
#include "support.h"

static const double spacing_m = 2.5e-7;

/* cos(2 pi n j/N + phase) with the angle reduced in whole numbers first. */
static double wave(size_t n, size_t j, size_t points, double phase)
{
    return cos(2 * M_PI * (double)(n * j % points) / (double)points + phase);
}

static struct spectrum compute(const double *height_m, size_t points, enum spectrum_window window)
{
    struct spectrum spectrum;
    expect_ok(spectrum_compute, &spectrum, height_m, points, spacing_m, window);
    test_owns(spectrum.amplitude_m, free);
    assert_int_equal(spectrum.count, points / 2);
    assert_int_equal(spectrum.has_nyquist, points % 2 == 0);
    assert_near(spectrum.length_m, (double)points * spacing_m, 1e-15);
    return spectrum;
}

static double total_power(const struct spectrum *spectrum)
{
    long double sum = 0;
    for (size_t i = 0; i < spectrum->count; i++)
        sum += spectrum_power(spectrum, i);
    return (double)sum;
}

static double mean_square(const double *height_m, size_t points)
{
    long double mean = 0, sum = 0;
    for (size_t i = 0; i < points; i++)
        mean += (long double)height_m[i] / (long double)points;
    for (size_t i = 0; i < points; i++)
        sum += (height_m[i] - mean) * (height_m[i] - mean) / (long double)points;
    return (double)sum;
}

/* Each harmonic by itself, at a phase of its own: its amplitude in its bin, nothing in the others. */
TEST_CASE(test_single_harmonics)
{
    static const size_t lengths[] = {3, 4, 5, 6, 7, 16, 17, 101, 120};
    const double amplitude_m = 3.7e-7;
    double height_m[120];
    for (size_t l = 0; l < sizeof lengths / sizeof *lengths; l++)
        for (size_t n = 1; n <= lengths[l] / 2; n++) {
            size_t points = lengths[l];
            bool nyquist = 2 * n == points; /* only its cosine part can be sampled */
            for (size_t j = 0; j < points; j++)
                height_m[j] = 1e-6 + amplitude_m * wave(n, j, points, nyquist ? 0 : 0.1 + (double)n);
            struct spectrum spectrum = compute(height_m, points, SPECTRUM_WINDOW_NONE);
            for (size_t i = 0; i < spectrum.count; i++)
                assert_within(spectrum.amplitude_m[i], i + 1 == n ? amplitude_m : 0, 1e-13 * amplitude_m);
            assert_near(spectrum_power(&spectrum, n - 1), amplitude_m * amplitude_m / (nyquist ? 1 : 2), 1e-12);
            assert_near(spectrum_frequency(&spectrum, n - 1), (double)n / ((double)points * spacing_m), 1e-15);
        }
}

/* A ramp of step s has Delta_n = s/sin(pi n/N), and half of that at Nyquist: a geometric sum. */
TEST_CASE(test_a_ramp)
{
    double height_m[1000];
    for (size_t points = 999; points <= 1000; points++) {
        for (size_t j = 0; j < points; j++)
            height_m[j] = 1e-9 * (double)j;
        struct spectrum spectrum = compute(height_m, points, SPECTRUM_WINDOW_NONE);
        for (size_t n = 1; n <= points / 2; n++)
            assert_near(spectrum.amplitude_m[n - 1],
                        1e-9 / sin(M_PI * (double)n / (double)points) / (2 * n == points ? 2 : 1), 1e-11);
        struct spectrum hann = compute(height_m, points, SPECTRUM_WINDOW_HANN);
        for (size_t n = 50; n <= points / 2; n++) /* the window takes the tail away that the jump leaks */
            assert_true(hann.amplitude_m[n - 1] < 1e-3 * spectrum.amplitude_m[n - 1]);
    }
}

TEST_CASE(test_parseval)
{
    static const size_t lengths[] = {3, 4, 5, 1000, 1001, 1009};
    uint64_t seed = 1;
    double height_m[1009];
    for (size_t l = 0; l < sizeof lengths / sizeof *lengths; l++) {
        for (size_t j = 0; j < lengths[l]; j++)
            height_m[j] = 1e-6 * (2 * support_uniform(&seed) - 1);
        struct spectrum spectrum = compute(height_m, lengths[l], SPECTRUM_WINDOW_NONE);
        assert_near(total_power(&spectrum), mean_square(height_m, lengths[l]), 1e-13);
        assert_near(spectrum_moment(&spectrum, 0), total_power(&spectrum), 1e-13);
        spectrum = compute(height_m, lengths[l], SPECTRUM_WINDOW_HANN); /* a constant factor, whatever the record */
        double mean = 0;
        for (size_t j = 0; j < lengths[l]; j++)
            mean += height_m[j] / (double)lengths[l];
        for (size_t j = 0; j < lengths[l]; j++)
            height_m[j] =
                (height_m[j] - mean) * sqrt(8.0 / 3) * pow(sin(M_PI * ((double)j + 0.5) / (double)lengths[l]), 2);
        assert_near(total_power(&spectrum), mean_square(height_m, lengths[l]), 1e-13);
    }
}

/* Auto asks the record; what is asked for by name stays. */
TEST_CASE(test_the_window_of_a_record)
{
    assert_int_equal(spectrum_window_for(SPECTRUM_WINDOW_AUTO, true), SPECTRUM_WINDOW_NONE);
    assert_int_equal(spectrum_window_for(SPECTRUM_WINDOW_AUTO, false), SPECTRUM_WINDOW_HANN);
    for (int periodic = 0; periodic < 2; periodic++) {
        assert_int_equal(spectrum_window_for(SPECTRUM_WINDOW_NONE, periodic), SPECTRUM_WINDOW_NONE);
        assert_int_equal(spectrum_window_for(SPECTRUM_WINDOW_HANN, periodic), SPECTRUM_WINDOW_HANN);
    }
}

/* The sum of a constant and roughness rounds to half a unit of the last place, 7e-18 m here; nothing else may be lost.
 */
TEST_CASE(test_a_large_offset_keeps_the_amplitudes)
{
    enum { POINTS = 1000 };
    const double offset_m = 0.1, amplitude_m = 1e-8;
    double plain_m[POINTS], lifted_m[POINTS];
    for (size_t j = 0; j < POINTS; j++) {
        plain_m[j] = amplitude_m * (wave(1, j, POINTS, 1) + wave(7, j, POINTS, 2) + wave(133, j, POINTS, 3));
        lifted_m[j] = offset_m + plain_m[j];
    }
    for (int window = SPECTRUM_WINDOW_NONE; window < SPECTRUM_WINDOW_COUNT; window++) {
        struct spectrum plain = compute(plain_m, POINTS, (enum spectrum_window)window);
        struct spectrum lifted = compute(lifted_m, POINTS, (enum spectrum_window)window);
        for (size_t i = 0; i < plain.count; i++)
            assert_within(lifted.amplitude_m[i], plain.amplitude_m[i], window == SPECTRUM_WINDOW_NONE ? 2e-18 : 1e-15);
    }
}

/* Hann of a whole harmonic: main line and its two neighbours at half of it (Harris 1978), scaled to keep the power. */
TEST_CASE(test_hann_lines)
{
    enum { POINTS = 256, LINE = 40 };
    double height_m[POINTS];
    for (size_t j = 0; j < POINTS; j++)
        height_m[j] = 1e-6 * wave(LINE, j, POINTS, 0.3);
    struct spectrum spectrum = compute(height_m, POINTS, SPECTRUM_WINDOW_HANN);
    double main_m = 1e-6 / sqrt(1.5); /* 1 + 2/4 of its square is the power kept */
    for (size_t n = 1; n <= spectrum.count; n++)
        assert_within(spectrum.amplitude_m[n - 1],
                      n == LINE                        ? main_m
                      : n == LINE - 1 || n == LINE + 1 ? main_m / 2
                                                       : 0,
                      1e-12 * 1e-6);
}

static struct spectrum random_spectrum(size_t points, uint64_t seed)
{
    double height_m[1000];
    for (size_t j = 0; j < points; j++)
        height_m[j] = 1e-6 * (2 * support_uniform(&seed) - 1);
    return compute(height_m, points, SPECTRUM_WINDOW_NONE);
}

/** Harmonics are known down to a cut-off, to what rounding leaves, and to 1e-4 of Rq. */
TEST_CASE(what_is_known_of_a_spectrum)
{
    double amplitude_m[400];
    struct spectrum spectrum = {amplitude_m, 400, 1e-3, false};
    for (size_t i = 0; i < 400; i++)
        amplitude_m[i] = 1e-3 * pow(1e-3 / (double)(i + 1), 1.2);
    assert_int_equal(spectrum_known(&spectrum, 0, 0), 400);
    assert_int_equal(spectrum_known(&spectrum, 1e-3 / 50, 0), 50);
    assert_int_equal(spectrum_known(&spectrum, 1e-3 / 49.9, 0), 49);
    assert_int_equal(spectrum_known(&spectrum, 2e-3, 0), 0);
    double shorter_m2 = 0; /* of harmonic 71 and above */
    for (size_t i = 400; i-- > 70;)
        shorter_m2 += spectrum_power(&spectrum, i);
    assert_int_equal(spectrum_known(&spectrum, 0, sqrt(6 * shorter_m2) * (1 - 1e-9)), 71);
    assert_int_equal(spectrum_known(&spectrum, 0, sqrt(6 * shorter_m2) * (1 + 1e-9)), 70);
    assert_int_equal(spectrum_known(&spectrum, 0, 1), 0); /* a step beyond all heights */
    for (double size = 1e-9; size < 1e9; size *= 1e3) {   /* without a step, whatever the unit */
        for (int n = 1; n <= 400; n++)
            spectrum.amplitude_m[n - 1] = size * (n == 1 ? 1 : n <= 30 ? 4.5e-5 : 1e-7);
        assert_int_equal(spectrum_known(&spectrum, 0, 0), 30);
        for (int n = 2; n <= 30; n++) /* 29 waves are 4.04e-5 of Rq, and 1e-4/sqrt(6) is 4.08e-5 */
            spectrum.amplitude_m[n - 1] = size * 7.5e-6;
        assert_int_equal(spectrum_known(&spectrum, 0, 0), 1);
    }
}

/* The mean over scans is one of powers, with a Nyquist harmonic and without. */
TEST_CASE(test_averages_are_means_of_powers)
{
    for (size_t points = 999; points <= 1000; points++) {
        struct spectrum scans[3], mean;
        for (size_t k = 0; k < 3; k++) {
            scans[k] = random_spectrum(points, k + 1);
            expect_ok(grid_average, &mean, &scans[k], k);
        }
        test_owns(mean.amplitude_m, free);
        assert_int_equal(mean.count, scans[0].count);
        assert_near(mean.length_m, scans[0].length_m, 0);
        for (size_t i = 0; i < mean.count; i++)
            assert_near(spectrum_power(&mean, i),
                        (spectrum_power(&scans[0], i) + spectrum_power(&scans[1], i) + spectrum_power(&scans[2], i)) /
                            3,
                        1e-13);
    }
}

/** Half of the mean square height: of one wave, in the middle of its own harmonic; of a plateau, in its middle. */
TEST_CASE(test_longest_waves)
{
    enum { COUNT = 64 };
    double amplitude_m[COUNT] = {0};
    struct spectrum spectrum = {.amplitude_m = amplitude_m, .count = COUNT, .length_m = 1};
    assert_within(spectrum_longest_waves(&spectrum), 0, 0);
    for (size_t n = 1; n <= COUNT; n++) {
        amplitude_m[n - 1] = 2e-6;
        assert_near(spectrum_longest_waves(&spectrum), ((double)n + 1) / 2, 1e-12);
    }
    for (size_t n = 1; n <= COUNT; n++) {
        memset(amplitude_m, 0, sizeof amplitude_m);
        amplitude_m[n - 1] = 2e-6;
        assert_near(spectrum_longest_waves(&spectrum), (double)n, 1e-12);
    }
    amplitude_m[3] = 1e-6; /* a quarter of the power, in harmonic 4, before that of harmonic 64 */
    assert_near(spectrum_longest_waves(&spectrum), 64 - 0.5 + 0.375, 1e-12);
}
