/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coverage.h"

#include "statistics/interval.h"
#include <math.h>
#include <stdlib.h>

enum { POINTS = 1024, LONGER = 8 };

static const struct coverage_surface surfaces[] = {
    {.gamma = 1.0, .roll_off = POINTS / 10}, {.gamma = 1.4, .roll_off = POINTS / 10}, {.gamma = 1.0}, {.gamma = 1.4}};
enum { SURFACES = sizeof surfaces / sizeof *surfaces };

/** Least and most of several shares. */
struct range {
    double least, most;
};

static void widen(struct range *range, double value)
{
    range->least = fmin(range->least, value);
    range->most = fmax(range->most, value);
}

/** Shares of sets of M scans whose interval holds the mean over all scans, and whose prediction the next scan. */
static void cover(struct range range[3], const double *answer, size_t scans, size_t m)
{
    double truth = coverage_mean(answer, scans), sets = 0, inside[3] = {0};
    for (size_t first = 0; first + m < scans; first += m + 1, sets++) {
        struct interval low, high;
        expect_ok(interval_scans, &low, answer + first, NULL, m, 0.68);
        expect_ok(interval_scans, &high, answer + first, NULL, m, 0.95);
        inside[0] += truth >= low.low && truth <= low.high;
        inside[1] += truth >= high.low && truth <= high.high;
        inside[2] += fabs(answer[first + m] - high.mean) <= interval_next_half_width(&high);
    }
    for (int i = 0; i < 3; i++)
        widen(&range[i], inside[i] / sets);
}

static void scans_of_one_length(FILE *out, size_t scans, gsl_rng *random)
{
    static const size_t counts[] = {2, 3, 5, 10, 20};
    static const char *const published[] = {".67-.70 .94-.96 .94-.96", ".65-.71 .94-.96 .94-.96",
                                            ".65-.71 .94-.96 .93-.96", ".63-.71 .93-.96 .93-.97",
                                            ".62-.76 .92-.97 .91-.99"};
    double height[POINTS], *answer = coverage_allocate(SURFACES * COVERAGE_ANSWERS * scans, sizeof *answer);
    for (size_t k = 0; k < SURFACES; k++)
        for (size_t i = 0; i < scans; i++) {
            double value[COVERAGE_ANSWERS];
            coverage_draw(height, POINTS, LONGER, &surfaces[k], random);
            coverage_answers(value, height, POINTS);
            for (size_t a = 0; a < COVERAGE_ANSWERS; a++)
                answer[(k * COVERAGE_ANSWERS + a) * scans + i] = value[a];
        }
    fprintf(out, "\nScans (D): t on ln m0, m2, m4 of 4 surfaces, %zu scans each: 68 %%, 95 %%, next scan 95 %%\n",
            scans);
    for (size_t c = 0; c < sizeof counts / sizeof *counts; c++) {
        struct range range[3] = {{1, 0}, {1, 0}, {1, 0}};
        for (size_t k = 0; k < SURFACES * COVERAGE_ANSWERS; k++)
            cover(range, answer + k * scans, scans, counts[c]);
        fprintf(out, "M %2zu ", counts[c]);
        for (int i = 0; i < 3; i++)
            fprintf(out, " %.2f-%.2f", range[i].least, range[i].most);
        fprintf(out, "   %s\n", published[c]);
    }
    free(answer);
}

/** Lengths 512 ... 2560: whole scans against pieces of 512, the truth being that of 512. */
static void scans_of_several_lengths(FILE *out, size_t sets, gsl_rng *random)
{
    enum { SCANS = 5, SHORTEST = 512, LONGEST = SCANS * SHORTEST, TRUTHS = 4000 };
    double height[LONGEST];
    struct range whole = {1, 0}, pieces = {1, 0}, unweighted = {1, 0};
    for (size_t k = 0; k < SURFACES; k++) {
        double truth[COVERAGE_ANSWERS] = {0}, inside[3][COVERAGE_ANSWERS] = {{0}};
        for (size_t i = 0; i < TRUTHS; i++) {
            double value[COVERAGE_ANSWERS];
            coverage_draw(height, SHORTEST, 40, &surfaces[k], random);
            coverage_answers(value, height, SHORTEST);
            for (size_t a = 0; a < COVERAGE_ANSWERS; a++)
                truth[a] += value[a] / TRUTHS;
        }
        for (size_t set = 0; set < sets; set++) {
            double all[COVERAGE_ANSWERS][SCANS], mean[COVERAGE_ANSWERS][SCANS] = {{0}}, weight[SCANS];
            for (size_t scan = 0; scan < SCANS; scan++) {
                size_t points = (scan + 1) * SHORTEST, count = interval_subrecords(points, SHORTEST);
                double value[COVERAGE_ANSWERS], longer[LONGEST];
                weight[scan] = (double)count;
                coverage_draw(longer, LONGEST, 8, &surfaces[k], random);
                coverage_answers(value, longer, points);
                for (size_t a = 0; a < COVERAGE_ANSWERS; a++)
                    all[a][scan] = value[a];
                for (size_t p = 0; p < count; p++) {
                    coverage_answers(value, longer + interval_subrecord_first(points, SHORTEST, p), SHORTEST);
                    for (size_t a = 0; a < COVERAGE_ANSWERS; a++)
                        mean[a][scan] += value[a] / (double)count;
                }
            }
            for (size_t a = 0; a < COVERAGE_ANSWERS; a++) {
                struct interval out_of[3];
                expect_ok(interval_scans, &out_of[0], all[a], NULL, SCANS, 0.95);
                expect_ok(interval_scans, &out_of[1], mean[a], weight, SCANS, 0.95);
                expect_ok(interval_scans, &out_of[2], mean[a], NULL, SCANS, 0.95);
                for (int i = 0; i < 3; i++)
                    inside[i][a] += (truth[a] >= out_of[i].low && truth[a] <= out_of[i].high) / (double)sets;
            }
        }
        for (size_t a = 0; a < COVERAGE_ANSWERS; a++) {
            widen(&whole, inside[0][a]);
            widen(&pieces, inside[1][a]);
            widen(&unweighted, inside[2][a]);
        }
    }
    fprintf(out, "lengths 512 to 2560, 95 %%: whole %.2f-%.2f, pieces weighted %.2f-%.2f, unweighted %.2f-%.2f   ",
            whole.least, whole.most, pieces.least, pieces.most, unweighted.least, unweighted.most);
    fprintf(out, "whole .68-.97, weighted .94-.97, unweighted .94-.97\n");
}

void coverage_scans(FILE *out, size_t sets)
{
    gsl_rng *random = support_random();
    gsl_rng_set(random, 3);
    scans_of_one_length(out, 10 * sets, random);
    scans_of_several_lengths(out, sets, random);
}
