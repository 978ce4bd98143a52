/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The Gaussian filter: transmission of sinusoids, constants up to the ends, a direct sum. */
#include "condition_support.h"

static void smooth(double *z, size_t points, double spacing_m, double cutoff_m)
{
    double *own = support_room(points * sizeof *own);
    memcpy(own, z, points * sizeof *own);
    const struct profile profile = {.height_m = own, .points = points, .spacing_m = spacing_m};
    expect_ok(filter_gaussian, z, &profile, cutoff_m);
}

/* Harmonics of a periodic record pass as the standard says, up to both ends: transforms of even, odd and prime length,
 * weights that reach over more than half of the record. */
TEST_CASE(test_harmonics_of_a_periodic_record)
{
    static const struct {
        size_t points;
        double cutoff; /* in spacings */
        int harmonic;
    } cases[] = {{100, 12, 9},  {100, 12, 1}, {1000, 100, 7}, {1009, 100, 1},
                 {499, 300, 1}, {15, 8, 1},   {100, 19, 4},   {100, 21, 4}};
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        size_t points = cases[c].points;
        double *z = support_room(2 * points * sizeof *z), *own = z + points;
        double passes = pow(2, -pow(cases[c].cutoff * cases[c].harmonic / (double)points, 2));
        for (size_t i = 0; i < points; i++)
            own[i] = 3e-6 + 1e-6 * cos(2 * M_PI * cases[c].harmonic * (double)i / (double)points + 1);
        const struct profile profile = {.height_m = own, .points = points, .spacing_m = 5e-7, .periodic = true};
        expect_ok(filter_gaussian, z, &profile, 5e-7 * cases[c].cutoff);
        for (size_t i = 0; i < points; i++)
            assert_within(z[i], 3e-6 + passes * (own[i] - 3e-6), 1e-14);
    }
}

TEST_CASE(test_constants_stay_up_to_both_ends)
{
    static const size_t points[] = {3, 7, 1000, 1001};
    static const double cutoffs_m[] = {1e-9, 1e-6, 1e-4, 1};
    for (size_t p = 0; p < 4; p++)
        for (size_t c = 0; c < 4; c++) {
            double z[1001];
            for (size_t i = 0; i < points[p]; i++)
                z[i] = 3e-3;
            smooth(z, points[p], 1e-6, cutoffs_m[c]);
            for (size_t i = 0; i < points[p]; i++)
                assert_near(z[i], 3e-3, 1e-12);
        }
}

/* The weights written out and summed point by point, normalised by those within the record. */
TEST_CASE(test_against_the_direct_sum)
{
    enum { POINTS = 301 };
    static const double cutoffs_m[] = {3e-6, 1.4e-5, 2.04e-5, 2.08e-5, 4.7e-5, 9e-4};
    double z[POINTS], filtered[POINTS];
    uint64_t seed = 3;
    for (size_t i = 0; i < POINTS; i++)
        z[i] = 1e-6 * noise(&seed);
    for (size_t c = 0; c < sizeof cutoffs_m / sizeof *cutoffs_m; c++) {
        memcpy(filtered, z, sizeof z);
        smooth(filtered, POINTS, 1e-6, cutoffs_m[c]);
        for (size_t i = 0; i < POINTS; i++) {
            double sum = 0, norm = 0;
            for (size_t j = 0; j < POINTS; j++) {
                double x = ((double)j - (double)i) * 1e-6 / (sqrt(M_LN2 / M_PI) * cutoffs_m[c]);
                double weight = exp(-M_PI * x * x);
                weight = weight < 1e-9 ? 0 : weight;
                sum += weight * z[j];
                norm += weight;
            }
            assert_within(filtered[i], sum / norm, 1e-18);
        }
    }
}
