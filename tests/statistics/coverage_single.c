/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coverage.h"

#include "spectrum/multitaper.h"
#include "spectrum/simulated_record.h"
#include "statistics/single_scan.h"
#include <math.h>
#include <string.h>

enum { POINTS = 2048, LONGER = 8, RECORDS = SINGLE_SCAN_RECORDS, QUARTERS = SINGLE_SCAN_QUARTERS };

/** Answers of a record and of its quarters. */
struct answers {
    double whole[COVERAGE_ANSWERS];
    double quarter[QUARTERS][COVERAGE_ANSWERS];
};

static void evaluate(struct answers *answers, const double *height)
{
    coverage_answers(answers->whole, height, POINTS);
    for (size_t q = 0; q < QUARTERS; q++)
        coverage_answers(answers->quarter[q], height + q * POINTS / QUARTERS, POINTS / QUARTERS);
}

static void run(FILE *out, double gamma, double roll_off, size_t sets, const char *published, gsl_rng *random)
{
    enum { TRUTHS = 4000 };
    const struct coverage_surface surface = {.gamma = gamma, .roll_off = roll_off};
    double height[POINTS], square[POINTS], truth[COVERAGE_ANSWERS] = {0};
    double inside[COVERAGE_ANSWERS][4] = {{0}}, total = (double)sets;
    struct status status = {0};
    for (size_t i = 0; i < TRUTHS; i++) {
        double value[COVERAGE_ANSWERS];
        coverage_draw(height, POINTS, LONGER, &surface, random);
        coverage_answers(value, height, POINTS);
        for (size_t a = 0; a < COVERAGE_ANSWERS; a++)
            truth[a] += value[a] / TRUTHS;
    }
    for (size_t set = 0; set < sets; set++) {
        struct simulated_record spectrum;
        struct answers scan, record[RECORDS];
        coverage_draw(height, POINTS, LONGER, &surface, random);
        evaluate(&scan, height);
        coverage_must(multitaper_square(square, height, POINTS, &status), &status);
        coverage_must(simulated_record_prepare(&spectrum, square, POINTS, &status), &status);
        for (size_t b = 0; b < RECORDS; b++) {
            coverage_must(simulated_record_draw(height, &spectrum, set * RECORDS + b, &status), &status);
            evaluate(&record[b], height);
        }
        simulated_record_free(&spectrum);
        for (size_t a = 0; a < COVERAGE_ANSWERS; a++) {
            double simulated[RECORDS], quarter[QUARTERS], quarters[RECORDS * QUARTERS];
            struct single_scan single;
            for (size_t b = 0; b < RECORDS; b++) {
                simulated[b] = record[b].whole[a];
                for (size_t q = 0; q < QUARTERS; q++) {
                    quarter[q] = scan.quarter[q][a];
                    quarters[b * QUARTERS + q] = record[b].quarter[q][a];
                }
            }
            coverage_must(single_scan_uncertainty(&single, simulated, RECORDS, quarter, quarters, &status), &status);
            double error = fabs(scan.whole[a] - truth[a]);
            inside[a][0] += (error < 1.96 * single.s) / total;
            inside[a][1] += (error < 2.3 * single.s) / total;
            inside[a][2] += (error < single.half_width) / total;
            inside[a][3] += single.heterogeneous / total;
        }
    }
    fprintf(out, "%.1f %-4s", gamma, roll_off > 0 ? "N/10" : "none");
    for (int i = 0; i < 4; i++)
        fprintf(out, "  %.2f %.2f %.2f", inside[0][i], inside[1][i], inside[2][i]);
    fprintf(out, "   %s\n", published);
}

void coverage_single(FILE *out, size_t sets)
{
    static const char rolled[] = ".95-.99 .96-1.0 .96-1.0 .03-.08", open[] = ".90-.96 .94-.99 .94-.99 .03-.08";
    gsl_rng *random = coverage_random(5);
    fprintf(out,
            "\nOne scan (E), B = 32, ln m0 m2 m4: within 1.96 s, 2.3 s, with the heterogeneity rule; false flags\n");
    run(out, 1.0, POINTS / 10.0, sets, rolled, random);
    run(out, 1.4, POINTS / 10.0, sets, rolled, random);
    run(out, 1.0, 0, sets, open, random);
    run(out, 1.4, 0, sets, open, random);
    gsl_rng_free(random);
}
