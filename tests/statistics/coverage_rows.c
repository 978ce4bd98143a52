/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coverage.h"

#include "statistics/interval.h"
#include <fftw3.h>
#include <gsl/gsl_randist.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 256, ROWS = 16, LONGER = 4, ALL = SIDE * LONGER };

/** An isotropic map whose profiles fall as wavelength^gamma: density of the plane ~ q^-(2 gamma + 1). */
static void draw_map(double *map, fftw_complex *wave, double *height, fftw_plan plan, double gamma, double roll_off,
                     gsl_rng *random)
{
    for (int y = 0; y < ALL; y++)
        for (int x = 0; x <= ALL / 2; x++) {
            double q = hypot(y < ALL / 2 ? y : y - ALL, x) / ALL;
            q = roll_off > 0 ? fmax(q, 1 / roll_off) : q;
            double deviation = q > 0 ? pow(q, -gamma - 0.5) : 0;
            for (int part = 0; part < 2; part++)
                wave[y * (ALL / 2 + 1) + x][part] = gsl_ran_gaussian_ziggurat(random, deviation);
        }
    wave[0][0] = wave[0][1] = 0;
    fftw_execute(plan);
    for (int y = 0; y < SIDE; y++)
        memcpy(map + y * SIDE, height + y * ALL, SIDE * sizeof *map);
}

/** Answers of a map: all rows, 16 rows evenly spaced, 16 means of blocks of rows. */
struct answers {
    double row[COVERAGE_ANSWERS][SIDE];
};

static void run(FILE *out, double gamma, double roll_off, size_t sets, const char *published, gsl_rng *random)
{
    double *map = coverage_allocate(SIDE * SIDE, sizeof *map), *height = fftw_alloc_real((size_t)ALL * ALL);
    fftw_complex *wave = fftw_alloc_complex((size_t)ALL * (ALL / 2 + 1));
    struct answers *answers = coverage_allocate(sets, sizeof *answers);
    fftw_plan plan = fftw_plan_dft_c2r_2d(ALL, ALL, wave, height, FFTW_ESTIMATE);
    struct status status = {0};
    double truth[COVERAGE_ANSWERS] = {0};
    for (size_t set = 0; set < sets; set++) {
        draw_map(map, wave, height, plan, gamma, roll_off, random);
        for (size_t y = 0; y < SIDE; y++) {
            double value[COVERAGE_ANSWERS];
            coverage_answers(value, map + y * SIDE, SIDE);
            for (size_t a = 0; a < COVERAGE_ANSWERS; a++) {
                answers[set].row[a][y] = value[a];
                truth[a] += value[a] / (double)(SIDE * sets);
            }
        }
    }
    fprintf(out, "%.1f %-5s", gamma,
            roll_off > SIDE / 2   ? "n"
            : roll_off > SIDE / 8 ? "n/4"
            : roll_off > 0        ? "n/10"
                                  : "none");
    double least[4] = {1, 1, 1, 1}, most[4] = {0};
    for (size_t a = 0; a < COVERAGE_ANSWERS; a++) {
        double inside[4] = {0};
        for (size_t set = 0; set < sets; set++) {
            const double *row = answers[set].row[a];
            double some[ROWS], block[ROWS];
            struct interval of[4];
            for (size_t b = 0; b < ROWS; b++) {
                some[b] = row[b * SIDE / ROWS + SIDE / ROWS / 2];
                block[b] = coverage_mean(row + b * SIDE / ROWS, SIDE / ROWS);
            }
            coverage_must(interval_scans(&of[0], row, NULL, SIDE, 0.95, &status), &status);
            coverage_must(interval_scans(&of[1], some, NULL, ROWS, 0.95, &status), &status);
            coverage_must(interval_rows(&of[2], some, ROWS, 0.95, &status), &status);
            coverage_must(interval_rows(&of[3], block, ROWS, 0.95, &status), &status);
            for (int i = 0; i < 4; i++)
                inside[i] += (truth[a] >= of[i].low && truth[a] <= of[i].high) / (double)sets;
        }
        for (int i = 0; i < 4; i++) {
            least[i] = fmin(least[i], inside[i]);
            most[i] = fmax(most[i], inside[i]);
        }
    }
    for (int i = 0; i < 4; i++)
        fprintf(out, "  %.2f-%.2f", least[i], most[i]);
    fprintf(out, "   %s\n", published);
    fftw_destroy_plan(plan);
    fftw_free(wave);
    fftw_free(height);
    free(answers);
    free(map);
}

void coverage_rows(FILE *out, size_t sets)
{
    gsl_rng *random = coverage_random(4);
    fprintf(out,
            "\nRows of isotropic 256 x 256 maps (D), ln m0, m2, m4 of a row, 95 %%: all rows, 16 rows, 16 rows AR, "
            "16 blocks AR (published: contact answers)\n");
    run(out, 1.4, SIDE / 10.0, sets, ".46-.55 .95-.96 .96-.98 .94-.98", random);
    run(out, 1.4, SIDE / 4.0, sets, ".32-.42 .90-.94 .94-.96 .94-.96", random);
    run(out, 1.4, SIDE, sets, ".14-.27 .59-.88 .93-.95 .92-.96", random);
    run(out, 1.0, 0, sets, ".17-.49 .62-.94 .89-.96 .90-.95", random);
    run(out, 1.6, 0, sets, ".07-.15 .42-.64 .88-.94 .90-.94", random);
    gsl_rng_free(random);
}
