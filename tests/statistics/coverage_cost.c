/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coverage.h"

#include "base/clock.h"
#include "spectrum/multitaper.h"
#include "spectrum/power_law_band.h"
#include "spectrum/simulated_record.h"
#include <math.h>
#include <stdlib.h>

void coverage_cost(FILE *out, size_t sets)
{
    enum { RUNS = 50 };
    static const size_t points[] = {1000, 8000, 7993, 64000};
    const struct coverage_surface surface = {.gamma = 1.4, .roll_off = 300, .white_from = 10};
    gsl_rng *random = coverage_random(7);
    struct status status = {0};
    (void)sets;
    fprintf(out, "\nCost, least of %d runs, ms: multitaper, band and fit, one simulated record\n", RUNS);
    for (size_t p = 0; p < sizeof points / sizeof *points; p++) {
        double *height = coverage_allocate(points[p], sizeof *height);
        double *square = coverage_allocate(points[p], sizeof *square);
        struct power_law_band *band = coverage_allocate(1, sizeof *band);
        double least[3] = {INFINITY, INFINITY, INFINITY};
        coverage_draw(height, points[p], 1, &surface, random);
        for (int run = 0; run < RUNS; run++) {
            struct simulated_record simulated;
            double start = clock_seconds();
            coverage_must(multitaper_square(square, height, points[p], &status), &status);
            double taken = clock_seconds();
            struct power_law_band_spectrum spectrum = {square, multitaper_count(points[p]), (double)points[p], 1, 0};
            coverage_must(power_law_band_find(band, &spectrum, &status), &status);
            double fitted = clock_seconds();
            coverage_must(simulated_record_prepare(&simulated, square, points[p], &status), &status);
            double prepared = clock_seconds();
            coverage_must(simulated_record_draw(height, &simulated, 1, &status), &status);
            least[2] = fmin(least[2], clock_seconds() - prepared);
            simulated_record_free(&simulated);
            least[0] = fmin(least[0], taken - start);
            least[1] = fmin(least[1], fitted - taken);
        }
        fprintf(out, "%6zu points: %7.3f %7.3f %7.3f\n", points[p], 1e3 * least[0], 1e3 * least[1], 1e3 * least[2]);
        free(height);
        free(square);
        free(band);
    }
    gsl_rng_free(random);
}
