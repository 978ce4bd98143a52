/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Simulated coverage of the statistical estimators, beside the figures they were published to have. Slow, and random to
 * the extent that each figure says; hence no test. cmake --workflow --preset validation */
#ifndef TESTS_STATISTICS_COVERAGE_H
#define TESTS_STATISTICS_COVERAGE_H

#include "support.h"
#include <stdio.h>

/** A surface's rms amplitude in a record as long as itself: heights and lengths in units of the spacing. */
struct coverage_surface {
    double gamma;
    double roll_off;            /* longest wavelength of the law; 0: none */
    double low_pass, high_pass; /* Gaussian filters' cut-offs; 0: none */
    double white_from;          /* wavelength at which white noise is as high as the law; 0: none */
    double second_from;         /* above this wavelength the exponent is gamma - 0.7; 0: no such */
};

/** Draws `points` heights out of a periodic Gaussian record `longer` times as long. */
void coverage_draw(double *height, size_t points, size_t longer, const struct coverage_surface *surface,
                   gsl_rng *random);
/** Amplitude of the law alone, of the longer record of `length`, as found in a record of that length. */
double coverage_law(const struct coverage_surface *surface, double wavelength, double length);
/** The same with filters and noise. */
double coverage_amplitude(const struct coverage_surface *surface, double wavelength, double length);
/** Takes the least-squares line out. */
void coverage_level(double *height, size_t points);

enum { COVERAGE_ANSWERS = 3 };
/** ln mean square height, slope (differences) and curvature (second differences) of levelled heights: stand-ins for
 * what contact models make of them; heights stay as they are. */
void coverage_answers(double answer[COVERAGE_ANSWERS], const double *height, size_t points);

double coverage_mean(const double *value, size_t count);
double coverage_sd(const double *value, size_t count);
void *coverage_allocate(size_t count, size_t size);
/** Ends the program where something failed. */
void coverage_must(enum status_code code, const struct status *status);

/** Sections; `sets` simulated sets each, printed to `out`. */
void coverage_band(FILE *out, size_t sets);
void coverage_fit(FILE *out, size_t sets);
void coverage_scans(FILE *out, size_t sets);
void coverage_single(FILE *out, size_t sets);
void coverage_pairs(FILE *out, size_t sets);

#endif
