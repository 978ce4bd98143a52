/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coverage.h"

#include "spectrum/multitaper.h"
#include "spectrum/simulated_record.h"
#include "statistics/estimate.h"
#include "statistics/interval.h"
#include <math.h>
#include <string.h>

enum { POINTS = 2048, LONGER = 8, RECORDS = SINGLE_SCAN_RECORDS, QUARTERS = SINGLE_SCAN_QUARTERS };

static void run(FILE *out, double gamma, double roll_off, size_t sets, gsl_rng *random)
{
    enum { TRUTHS = 4000 };
    const struct coverage_surface surface = {.gamma = gamma, .roll_off = roll_off};
    double height[POINTS], square[POINTS], truth[COVERAGE_ANSWERS] = {0};
    double inside[COVERAGE_ANSWERS] = {0}, total = (double)sets, t = interval_quantile(0.95, SINGLE_SCAN_DEGREES);
    for (size_t i = 0; i < TRUTHS; i++) {
        double value[COVERAGE_ANSWERS];
        coverage_draw(height, POINTS, LONGER, &surface, random);
        coverage_answers(value, height, POINTS);
        for (size_t a = 0; a < COVERAGE_ANSWERS; a++)
            truth[a] += value[a] / TRUTHS;
    }
    for (size_t set = 0; set < sets; set++) {
        struct simulated_record spectrum;
        double scan[COVERAGE_ANSWERS], record[RECORDS][COVERAGE_ANSWERS], quarters[QUARTERS][COVERAGE_ANSWERS];
        coverage_draw(height, POINTS, LONGER, &surface, random);
        coverage_answers(scan, height, POINTS);
        for (size_t q = 0; q < QUARTERS; q++)
            coverage_answers(quarters[q], height + q * POINTS / QUARTERS, POINTS / QUARTERS);
        expect_ok(multitaper_square, square, height, POINTS);
        expect_ok(simulated_record_prepare, &spectrum, square, POINTS);
        for (size_t b = 0; b < RECORDS; b++) {
            expect_ok(simulated_record_draw, height, &spectrum, set * RECORDS + b);
            coverage_answers(record[b], height, POINTS);
        }
        simulated_record_free(&spectrum);
        for (size_t a = 0; a < COVERAGE_ANSWERS; a++) {
            double simulated[RECORDS], quarter[QUARTERS];
            for (size_t b = 0; b < RECORDS; b++)
                simulated[b] = record[b][a];
            for (size_t q = 0; q < QUARTERS; q++)
                quarter[q] = quarters[q][a];
            inside[a] += (fabs(scan[a] - truth[a]) < t * single_scan_s(simulated, RECORDS, quarter, QUARTERS)) / total;
        }
    }
    fprintf(out, "%.1f %-4s  %.2f %.2f %.2f\n", gamma, roll_off > 0 ? "N/10" : "none", inside[0], inside[1], inside[2]);
}

void coverage_single(FILE *out, size_t sets)
{
    gsl_rng *random = support_random();
    gsl_rng_set(random, 5);
    fprintf(out, "\nOne scan (E), %d records and four quarters, ln m0 m2 m4: within 2.78 s\n", RECORDS);
    run(out, 1.0, POINTS / 10.0, sets, random);
    run(out, 1.4, POINTS / 10.0, sets, random);
    run(out, 1.0, 0, sets, random);
    run(out, 1.4, 0, sets, random);
}
