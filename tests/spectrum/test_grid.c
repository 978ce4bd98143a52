/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/spectrum.h"
#include "support.h"

static struct spectrum make(size_t count, double length, bool nyquist)
{
    struct spectrum spectrum = {support_room(count * sizeof(double)), count, length, nyquist};
    for (size_t i = 0; i < count; i++)
        spectrum.amplitude_m[i] = 1e-6 * pow((double)(i + 1), -1.5) * (1 + 0.3 * sin(7.0 * (double)i));
    return spectrum;
}

static struct spectrum on_grid(const struct spectrum *in, double length, size_t count)
{
    struct spectrum out;
    expect_ok(grid_spectrum, &out, in, length, count);
    test_owns(out.amplitude_m, free);
    return out;
}

/** The same grid gives the same spectrum back. */
TEST_CASE(same_grid_is_the_identity)
{
    struct spectrum in = make(50, 1e-3, false), out = on_grid(&in, 1e-3, 50);
    for (size_t i = 0; i < 50; i++)
        assert_near(out.amplitude_m[i], in.amplitude_m[i], 1e-12);
}

/** All power that lies within the new grid's bands arrives, whatever the lengths. */
TEST_CASE(power_is_kept)
{
    for (int nyquist = 0; nyquist < 2; nyquist++)
        for (double length = 0.31e-3; length < 0.99e-3; length *= 1.17) {
            struct spectrum in = make(400, 1e-3, nyquist);
            struct spectrum out = on_grid(&in, length, (size_t)(420 * length / 1e-3));
            double first = 0.5 * 1e-3 / length; /* harmonics of `in` below the new grid's first band are out of it */
            double expected = 0;
            for (size_t i = 0; i < in.count; i++) {
                double low = (double)i + 0.5, high = nyquist && i + 1 == in.count ? (double)i + 1 : (double)i + 1.5;
                expected += spectrum_power(&in, i) * fmax(0, high - fmax(low, first)) / (high - low);
            }
            assert_near(spectrum_moment(&out, 0), expected, 1e-12);
        }
}

/** Of two spectra on one grid squares add. */
TEST_CASE(sum_of_two_adds_squares)
{
    struct spectrum a = make(60, 1e-3, true), b = make(60, 1e-3, true), sum = make(60, 1e-3, true);
    for (size_t i = 0; i < 60; i++)
        b.amplitude_m[i] = 2e-7;
    expect_ok(grid_add, &sum, &b);
    for (size_t i = 0; i + 2 < 60; i++) /* up to the Nyquist band, whose halves meet */
        assert_near(sum.amplitude_m[i], hypot(a.amplitude_m[i], b.amplitude_m[i]), 1e-12);
    assert_near(spectrum_moment(&sum, 0), spectrum_moment(&a, 0) + spectrum_moment(&b, 0), 1e-12);
}

/** Records of any two lengths: the mean's power is the mean of both, each on the shorter one's grid. */
TEST_CASE(average_of_unlike_records)
{
    for (int k = 0; k < 3; k++) {
        double length = k == 0 ? 1e-3 : k == 1 ? 0.93e-3 : 1.08e-3, shorter = fmin(length, 1e-3);
        struct spectrum first = make(100, 1e-3, false), other = make(k == 2 ? 90 : 100, length, false), mean;
        size_t count = (size_t)(shorter * fmin(100 / 1e-3, spectrum_frequency(&other, other.count - 1)) * (1 + 1e-9));
        struct spectrum one = on_grid(&first, shorter, count), two = on_grid(&other, shorter, count);
        expect_ok(spectrum_copy, &mean, &first);
        expect_ok(grid_average, &mean, &other, 3);
        assert_int_equal(mean.count, count);
        for (size_t i = 0; i < count; i++)
            assert_near(spectrum_power(&mean, i), 0.75 * spectrum_power(&one, i) + 0.25 * spectrum_power(&two, i),
                        1e-12);
        spectrum_free(&mean);
    }
}
