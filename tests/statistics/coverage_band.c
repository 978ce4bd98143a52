/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coverage.h"

#include "spectrum/power_law_scans.h"
#include <math.h>
#include <stdlib.h>

/** A kind of surface and what is published of it. */
struct kind {
    const char *name, *published;
    size_t points, longer;           /* longer 0: 8, cut out */
    struct coverage_surface surface; /* gamma is drawn */
    double cut_off;                  /* lambda_s, where the instrument states it */
    double step_from;                /* rounded to steps whose noise is as high as the law at this wavelength; 0: not */
    double turned;                   /* feed of a turned surface, of three lines; 0: none */
    enum { GAMMA, EITHER_GAMMA, NO_GAMMA } expected;
    bool level;
};

/* The kinds are made again from descriptions of a line each: where these leave a wavelength or a size open it is chosen
 * here. */
static const struct kind kinds[] = {
    {"pure, cut from 8 times longer (4096)", "1.00 +.001 .014 .014 .69/.94 .68/.92", .points = 4096},
    {"periodic, levelled (4096)", "1.00 +.001 .015 .014 .68/.93 .66/.94", .points = 4096, .longer = 1, .level = true},
    {"short (512)", "0.99 +.011 .044 .043 .69/.94 .68/.93", .points = 512},
    {"Gaussian low-pass 12h (4096)", "0.93 +.042 .065 .077 .62/.94 .75/.98", .points = 4096, .surface.low_pass = 12},
    {"white noise from 24h (4096)", "0.93 -.029 .069 .099 .79/.97 .79/.99", .points = 4096, .surface.white_from = 24},
    {"quantised, step as law at 10h (4096)", "0.92  .000 .087 .077 .69/.96 .63/.95", .points = 4096, .step_from = 10},
    {"roll-off at 300h (4096)", "1.00 -.005 .018 .043 .88/.94 .88/.94", .points = 4096, .surface.roll_off = 300},
    {"roll-off + low-pass + noise (8192)", "0.97 -.008 .075 .071 .70/.98 .68/.94", .points = 8192,
     .surface = {.roll_off = 600, .low_pass = 10, .white_from = 12}},
    {"roll-off + low-pass (1024)", "0.86 +.015 .082 .100 .80/.99 .73/.94", .points = 1024,
     .surface = {.roll_off = 160, .low_pass = 4}},
    {"lambda_c 1600h, lambda_s 8h (8192)", "0.94 -.021 .072 .070 .66/.94 .61/.94", .points = 8192,
     .surface = {.low_pass = 8, .high_pass = 1600}},
    {"oversampled x40 + noise (8192)", "0.77 +.066 .099 .121 .69/.96 .80/.98", .points = 8192,
     .surface = {.low_pass = 40, .white_from = 20}, .cut_off = 40},
    {"turned, 3 lines, + low-pass (4096)", "0.68 +.044 .154 .204 .76/.92 .75/.97", .points = 4096,
     .surface.low_pass = 12, .turned = 100},
    {"two slopes (4096)", "0.99 +.002 .012 .042 .99/1.0 .99/1.0", .points = 4096, .surface.second_from = 60,
     .expected = EITHER_GAMMA},
    {"roll-off + low-pass (22400)", "0.99 -.002 .040 .051 .80/.99 .80/.99", .points = 22400,
     .surface = {.roll_off = 1500, .low_pass = 12}},
    {"white only: none (4096)", "1.00", .points = 4096, .surface.roll_off = 1e-3, .expected = NO_GAMMA},
    {"plateau, Gaussian flank, noise: none", "0.72", .points = 4096,
     .surface = {.roll_off = 1e-3, .low_pass = 40, .white_from = 3e-5}, .expected = NO_GAMMA},
};

/** Rounds to steps of white noise step²/12 as high as the law at `wavelength`; returns the step. */
static double quantise(double *height, const struct kind *kind, const struct coverage_surface *surface)
{
    double length = (double)kind->points, level = coverage_law(surface, kind->step_from, length);
    double step = sqrt(3 * length) * level; /* 4 step²/12/N = level² */
    for (size_t i = 0; i < kind->points; i++)
        height[i] = step * round(height[i] / step);
    return step;
}

static void turn(double *height, const struct kind *kind, const struct coverage_surface *surface, gsl_rng *random)
{
    for (int line = 1; line <= 3; line++) {
        double wavelength = kind->turned / line, phase = 2 * M_PI * gsl_rng_uniform(random);
        double size = 7 * coverage_law(surface, wavelength, (double)kind->points);
        for (size_t i = 0; i < kind->points; i++)
            height[i] += size * cos(2 * M_PI * (double)i / wavelength + phase);
    }
}

/** Sums over the sets of a kind. */
struct tally {
    size_t right, found, gamma_68, gamma_95, amplitude_68, amplitude_95;
    double error, square, s;
};

static void count(struct tally *tally, const struct kind *kind, const struct coverage_surface *surface,
                  const struct power_law_band *band)
{
    if (kind->expected == NO_GAMMA || band->law == POWER_LAW_BAND_NONE) {
        tally->right += kind->expected == NO_GAMMA && band->law == POWER_LAW_BAND_NONE;
        return;
    }
    double error = band->fit.gamma - surface->gamma;
    if (kind->expected == EITHER_GAMMA && fabs(error + 0.7) < fabs(error))
        error += 0.7;
    double law = log10(coverage_law(surface, band->fit.wavelength_m, (double)kind->points));
    double off = (band->fit.log10_amplitude - law) / band->fit.log10_amplitude_s, sigma = error / band->fit.gamma_s;
    tally->right += fabs(error) < 0.15;
    if (fabs(error) > 0.5)
        return;
    tally->found++;
    tally->error += error;
    tally->square += error * error;
    tally->s += band->fit.gamma_s;
    tally->gamma_68 += fabs(sigma) < 1;
    tally->gamma_95 += fabs(sigma) < 1.96;
    tally->amplitude_68 += fabs(off) < 1;
    tally->amplitude_95 += fabs(off) < 1.96;
}

static double run(FILE *out, const struct kind *kind, size_t sets, gsl_rng *random)
{
    OWNED(memory_free) double *height = coverage_allocate(kind->points, sizeof *height);
    OWNED(memory_free) struct power_law_band *band = coverage_allocate(1, sizeof *band);
    struct tally tally = {0};
    for (size_t set = 0; set < sets; set++) {
        struct coverage_surface surface = kind->surface;
        surface.gamma = 0.8 + gsl_rng_uniform(random);
        coverage_draw(height, kind->points, kind->longer > 0 ? kind->longer : 8, &surface, random);
        if (kind->turned > 0)
            turn(height, kind, &surface, random);
        if (kind->level)
            coverage_level(height, kind->points);
        double step = kind->step_from > 0 ? quantise(height, kind, &surface) : 0;
        struct power_law_scans scans = {0};
        expect_ok(power_law_scans_add, &scans, height, kind->points, 1, step);
        power_law_scans_fit(band, &scans, kind->cut_off, NULL);
        power_law_scans_free(&scans);
        count(&tally, kind, &surface, band);
    }
    double all = (double)sets, found = (double)tally.found, right = (double)tally.right / all;
    fprintf(out, "%-40s %4.2f", kind->name, right);
    if (kind->expected != NO_GAMMA) {
        double bias = tally.error / found;
        fprintf(out, " %+.3f %.3f %.3f %.2f/%.2f %.2f/%.2f", bias, sqrt(fmax(0, tally.square / found - bias * bias)),
                tally.s / found, (double)tally.gamma_68 / found, (double)tally.gamma_95 / found,
                (double)tally.amplitude_68 / found, (double)tally.amplitude_95 / found);
    }
    fprintf(out, "%*s%s\n", kind->expected == NO_GAMMA ? 49 : 7, "", kind->published);
    return right;
}

void coverage_band(FILE *out, size_t sets)
{
    gsl_rng *random = support_random();
    gsl_rng_set(random, 1);
    double right = 0;
    size_t count_kinds = sizeof kinds / sizeof *kinds;
    fprintf(
        out,
        "\nBand found (A). Success |gamma error| < 0.15, bias, sd, stated s, coverage 68/95 of gamma, of amplitude\n");
    fprintf(out, "%-40s %-47s %s\n", "kind", "measured", "published");
    for (size_t k = 0; k < count_kinds; k++)
        right += run(out, &kinds[k], sets, random);
    fprintf(out, "%-40s %4.2f%49s%s\n", "mean", right / (double)count_kinds, "", "0.92");
}
