/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Harmonics in bins of equal width in log wavelength: mean logarithms of their amplitudes, which no slope biases and a
 * single line hardly moves, with their covariance on Gaussian random heights. */
#ifndef SPECTRUM_LOG_BIN_H
#define SPECTRUM_LOG_BIN_H

#include <stddef.h>

enum {
    LOG_BIN_PER_DECADE = 10,
    LOG_BIN_MOST = 96 /* up to harmonic 1e9, and two more where the ends of a band divide bins */
};

/** Harmonics first ... last. */
struct log_bin {
    size_t first, last;
    double x;              /* mean log10 wavelength, wavelength in m */
    double y;              /* mean log10 rms amplitude, amplitude in m; -INFINITY where a harmonic has none */
    double peak_x, peak_y; /* the same of its highest harmonic alone */
    double variance;       /* of y, decades² */
};

/** Bins the amplitudes (finite, not negative) amplitude_m[n-1] = Delta_n, n = MULTITAPER_FIRST ... count, of a
 * multitaper spectrum, the mean over `scans` M >= 1 (not always whole) independent records of length_m L:
 * harmonic n is in bin floor(10 log10(n/5) + 1e-9), x = mean log10(L/n), y = mean log10(Delta_n) - b(K M), b(M) =
 * (psi(M) - ln M)/(2 ln 10). Bins are divided so that harmonics split[0] ... split[1] fill whole bins (NULL: not).
 * Returns how many bins. Abramowitz & Stegun 6.3 (psi), 6.4 (its derivative). */
size_t log_bin_fill(struct log_bin bin[LOG_BIN_MOST], const double *amplitude_m, size_t count, double length_m,
                    double scans, const size_t split[2]);

/** b(M) in decades: the mean of log10 sqrt(mean of M exponential variables of mean 1). */
double log_bin_bias(double squares);

/** Variance of the log10 amplitude of one harmonic, psi'(K M)/(4 ln² 10), decades². */
double log_bin_variance(double scans);

/** cov(y_i, y_j) = psi'(K M)/(4 ln² 10) sum_{a in i, b in j} rho(|a-b|)/(n_i n_j), decades². */
double log_bin_covariance(const struct log_bin *i, const struct log_bin *j, double scans);

#endif
