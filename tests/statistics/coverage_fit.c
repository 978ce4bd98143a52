/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coverage.h"

#include "spectrum/multitaper.h"
#include "spectrum/power_law_band.h"
#include <math.h>
#include <stdlib.h>

static void run(FILE *out, size_t points, double gamma, size_t scans, size_t sets, const char *published,
                gsl_rng *random)
{
    OWNED(memory_free)
    double *height = coverage_allocate(points, sizeof *height), *error = coverage_allocate(sets, sizeof *error);
    OWNED(memory_free)
    double *square = coverage_allocate(points, sizeof *square), *mean = coverage_allocate(points, sizeof *mean);
    OWNED(memory_free) struct power_law_band *band = coverage_allocate(1, sizeof *band);
    const struct coverage_surface surface = {.gamma = gamma};
    const double all_m[2] = {0, INFINITY};
    double s = 0, amplitude = 0, total = (double)sets, inside[4] = {0};
    for (size_t set = 0; set < sets; set++) {
        for (size_t scan = 0; scan < scans; scan++) {
            coverage_draw(height, points, 8, &surface, random);
            expect_ok(multitaper_square, square, height, points);
            for (size_t i = 0; i < multitaper_count(points); i++)
                mean[i] = hypot(scan > 0 ? mean[i] : 0, sqrt(square[i] / (double)scans));
        }
        struct power_law_band_spectrum spectrum = {mean, multitaper_count(points), (double)points, (double)scans, 0};
        power_law_band_fit_in(band, &spectrum, all_m);
        double law = log10(coverage_law(&surface, band->fit.wavelength_m, (double)points));
        double off = band->fit.log10_amplitude - law;
        error[set] = band->fit.gamma - gamma;
        s += band->fit.gamma_s / total;
        amplitude += off / total;
        inside[0] += (fabs(error[set]) < band->fit.gamma_s) / total;
        inside[1] += (fabs(error[set]) < 1.96 * band->fit.gamma_s) / total;
        inside[2] += (fabs(off) < band->fit.log10_amplitude_s) / total;
        inside[3] += (fabs(off) < 1.96 * band->fit.log10_amplitude_s) / total;
    }
    fprintf(out, "N %4zu gamma %.1f M %2zu  %+.3f %.4f %.4f  %.2f/%.2f  %+.3f  %.2f/%.2f   %s\n", points, gamma, scans,
            coverage_mean(error, sets), coverage_sd(error, sets), s, inside[0], inside[1], amplitude, inside[2],
            inside[3], published);
}

void coverage_fit(FILE *out, size_t sets)
{
    gsl_rng *random = support_random();
    gsl_rng_set(random, 2);
    fprintf(out,
            "\nFixed band, exact law (C). gamma: bias, sd, stated s, coverage; amplitude: bias in decades, coverage\n");
    run(out, 1024, 1.5, 1, sets, "+.006 .030 .029 .66/.96 +.003 .72/.96", random);
    run(out, 1024, 1.5, 3, sets, "      .0166 .0161 .67/.95 +.003 .65/.95", random);
    run(out, 1024, 1.5, 10, sets, "      .0086 .0087 .67/.95 +.003 .64/.93", random);
    run(out, 256, 1.5, 1, sets, "      .066 .065 .67/.95 +.005", random);
    run(out, 4096, 1.8, 1, sets, "      .015 .014 .68/.96 +.003", random);
}
