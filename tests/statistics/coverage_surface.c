/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coverage.h"

#include "base/fft.h"
#include <gsl/gsl_randist.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

double coverage_law(const struct coverage_surface *surface, double wavelength, double length)
{
    double amplitude = pow(wavelength / 10, surface->gamma);
    if (surface->second_from > 0 && wavelength > surface->second_from)
        amplitude *= pow(wavelength / surface->second_from, -0.7);
    return amplitude / sqrt(length);
}

/** What a Gaussian filter lets through: one half at the cut-off. */
static double gaussian(double cut_off, double wavelength)
{
    return exp2(-pow(cut_off / wavelength, 2));
}

double coverage_amplitude(const struct coverage_surface *surface, double wavelength, double length)
{
    double in_law = surface->roll_off > 0 ? fmin(wavelength, surface->roll_off) : wavelength;
    double amplitude = coverage_law(surface, in_law, length);
    if (surface->low_pass > 0)
        amplitude *= gaussian(surface->low_pass, wavelength);
    if (surface->high_pass > 0)
        amplitude *= 1 - gaussian(surface->high_pass, wavelength);
    return surface->white_from > 0 ? hypot(amplitude, coverage_law(surface, surface->white_from, length)) : amplitude;
}

void coverage_draw(double *height, size_t points, size_t longer, const struct coverage_surface *surface,
                   gsl_rng *random)
{
    size_t all = points * longer;
    double *record = fftw_alloc_real(all);
    fftw_complex *wave = fftw_alloc_complex(all / 2 + 1);
    if (!record || !wave)
        coverage_must(STATUS_MEMORY, NULL);
    memset(wave, 0, (all / 2 + 1) * sizeof *wave);
    for (size_t n = 1; n < (all + 1) / 2; n++) {
        double deviation = coverage_amplitude(surface, (double)all / (double)n, (double)all) / sqrt(2);
        for (int part = 0; part < 2; part++)
            wave[n][part] = gsl_ran_gaussian_ziggurat(random, deviation) / 2;
    }
    if (!fft_backward(record, wave, all))
        coverage_must(STATUS_MEMORY, NULL);
    memcpy(height, record, points * sizeof *height);
    fftw_free(record);
    fftw_free(wave);
}

void coverage_level(double *height, size_t points)
{
    double mean = coverage_mean(height, points), along = 0, norm = 0;
    for (size_t i = 0; i < points; i++) {
        double x = (double)i - (double)(points - 1) / 2;
        along += x * (height[i] - mean);
        norm += x * x;
    }
    for (size_t i = 0; i < points; i++)
        height[i] -= mean + along / norm * ((double)i - (double)(points - 1) / 2);
}

void coverage_answers(double answer[COVERAGE_ANSWERS], const double *height, size_t points)
{
    OWNED(memory_free) double *level = coverage_allocate(points, sizeof *level);
    double sum[COVERAGE_ANSWERS] = {0};
    memcpy(level, height, points * sizeof *level);
    coverage_level(level, points);
    for (size_t i = 0; i < points; i++) {
        double slope = i > 0 ? level[i] - level[i - 1] : 0;
        double curvature = i > 1 ? slope - level[i - 1] + level[i - 2] : 0;
        sum[0] += level[i] * level[i];
        sum[1] += slope * slope;
        sum[2] += curvature * curvature;
    }
    for (size_t a = 0; a < COVERAGE_ANSWERS; a++)
        answer[a] = log(sum[a] / (double)(points - a));
}

double coverage_mean(const double *value, size_t count)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += value[i];
    return sum / (double)count;
}

double coverage_sd(const double *value, size_t count)
{
    double mean = coverage_mean(value, count), sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += (value[i] - mean) * (value[i] - mean);
    return sqrt(sum / (double)(count - 1));
}

void *coverage_allocate(size_t count, size_t size)
{
    void *memory = calloc(count, size);
    if (!memory)
        coverage_must(STATUS_MEMORY, NULL);
    return memory;
}

void coverage_must(enum status_code code, const struct status *status)
{
    if (code == STATUS_OK)
        return;
    fprintf(stderr, "coverage: %s\n", status ? status->message : "out of memory");
    exit(1);
}
