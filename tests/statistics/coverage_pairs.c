/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coverage.h"

#include "statistics/ranking.h"
#include <gsl/gsl_randist.h>

static struct interval draw(size_t scans, double mean, double sd, gsl_rng *random)
{
    double value[16];
    struct interval out;
    for (size_t i = 0; i < scans; i++)
        value[i] = mean + sd * gsl_ran_gaussian_ziggurat(random, 1);
    expect_ok(interval_scans, &out, value, NULL, scans, 0.95);
    return out;
}

static double share(size_t first, size_t second, double ratio, double first_sd, double second_sd, size_t sets,
                    gsl_rng *random)
{
    double told = 0;
    for (size_t set = 0; set < sets; set++) {
        struct interval a = draw(first, log(ratio), first_sd, random), b = draw(second, 0, second_sd, random);
        struct ranking welch = ranking_welch(&a, &b, 0.95);
        told += welch.p <= 0.05;
    }
    return told / (double)sets;
}

/** Any false verdict among four surfaces that are the same, unadjusted and by Holm. */
static void four(FILE *out, size_t scans, size_t sets, const char *published, gsl_rng *random)
{
    enum { SURFACES = 4, PAIRS = SURFACES * (SURFACES - 1) / 2 };
    double plain = 0, holm = 0;
    for (size_t set = 0; set < sets; set++) {
        struct interval surface[SURFACES];
        double p[PAIRS], least = 1, least_adjusted = 1;
        for (size_t i = 0; i < SURFACES; i++)
            surface[i] = draw(scans, 0, 0.11, random);
        for (size_t i = 0; i < SURFACES; i++)
            for (size_t j = i + 1; j < SURFACES; j++)
                p[ranking_pair(i, j, SURFACES)] = ranking_welch(&surface[i], &surface[j], 0.95).p;
        for (size_t k = 0; k < PAIRS; k++)
            least = fmin(least, p[k]);
        expect_ok(ranking_holm, p, p, PAIRS);
        for (size_t k = 0; k < PAIRS; k++)
            least_adjusted = fmin(least_adjusted, p[k]);
        plain += (least < 0.05) / (double)sets;
        holm += (least_adjusted < 0.05) / (double)sets;
    }
    fprintf(out, "four alike, %zu scans: any p < .05 unadjusted %.3f, Holm %.3f   %s\n", scans, plain, holm, published);
}

void coverage_pairs(FILE *out, size_t sets)
{
    static const struct {
        size_t first, second;
        const char *published;
    } rows[] = {{2, 2, ".02 / .09 .28 .54  and .05 .16 .34"},
                {3, 3, ".035 / .29 .85 1.0  and .14 .55 .92"},
                {5, 5, ".045-.05 / .63 1.0 1.0  and .33 .93 1.0"},
                {10, 10, ".045 / .95  and .66"},
                {3, 10, ".055-.07"}};
    gsl_rng *random = support_random();
    gsl_rng_set(random, 6);
    sets *= 20;
    fprintf(out, "\nTwo surfaces (F), Welch: size / power at x1.2 x1.5 x2 for a scan's SD of .11, then of .16\n");
    for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
        fprintf(out, "%2zu and %2zu:", rows[r].first, rows[r].second);
        for (int k = 0; k < 2; k++) {
            double sd = k ? 0.16 : 0.11;
            const double ratio[] = {1, 1.2, 1.5, 2};
            for (size_t i = (size_t)k; i < 4; i++)
                fprintf(out, i == 0 ? " %.3f /" : " %.2f",
                        share(rows[r].first, rows[r].second, ratio[i], sd, sd, sets, random));
            fprintf(out, k ? "   " : "  and");
        }
        fprintf(out, "%s\n", rows[r].published);
    }
    fprintf(out, "3 of SD .385 and 10 of .11: size %.3f   .045-.07\n", share(3, 10, 1, 0.385, 0.11, sets, random));
    four(out, 3, sets, ".15, .024", random);
    four(out, 5, sets, ".17, .029", random);
}
