/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/log_bin.h"

#include "spectrum/multitaper.h"
#include <assert.h>
#include <gsl/gsl_sf_psi.h>
#include <math.h>
#include <stdlib.h>

double log_bin_bias(double squares)
{
    return (gsl_sf_psi(squares) - log(squares)) / (2 * M_LN10);
}

static long bin_number(size_t n)
{
    return (long)floor(LOG_BIN_PER_DECADE * log10((double)n / MULTITAPER_FIRST) + 1e-9);
}

/** Last harmonic of the bin that begins at `first`. */
static size_t bin_last(size_t first, size_t count, const size_t split[2])
{
    const long number = bin_number(first);
    size_t last = first;
    while (last < count && bin_number(last + 1) == number &&
           !(split && (last + 1 == split[0] || (last == split[1] && first >= split[0]))))
        last++;
    return last;
}

size_t log_bin_fill(struct log_bin bin[LOG_BIN_MOST], const double *amplitude_m, size_t count, double length_m,
                    double scans, const size_t split[2])
{
    assert(scans >= 1 && length_m > 0);
    size_t bins = 0;
    double bias = log_bin_bias(MULTITAPER_TAPERS * scans);
    for (size_t first = MULTITAPER_FIRST; first <= count; first = bin[bins++].last + 1) {
        assert(bins < LOG_BIN_MOST);
        size_t last = bin_last(first, count, split);
        double members = (double)(last - first + 1), x = 0, y = 0;
        for (size_t n = first; n <= last; n++) {
            double square_m2 = amplitude_m[n - 1] * amplitude_m[n - 1];
            double log_wavelength = log10(length_m / (double)n), log_amplitude = log10(square_m2) / 2;
            x += log_wavelength;
            y += log_amplitude;
            if (n == first || log_amplitude - bias > bin[bins].peak_y) {
                bin[bins].peak_x = log_wavelength;
                bin[bins].peak_y = log_amplitude - bias;
            }
        }
        bin[bins].first = first;
        bin[bins].last = last;
        bin[bins].x = x / members;
        bin[bins].y = y / members - bias;
        bin[bins].variance = log_bin_covariance(&bin[bins], &bin[bins], scans);
    }
    return bins;
}

double log_bin_variance(double scans)
{
    return gsl_sf_psi_1(MULTITAPER_TAPERS * scans) / (4 * M_LN10 * M_LN10);
}

/** Pairs of a harmonic of i and one of j that is `apart` higher. */
static double pairs(const struct log_bin *i, const struct log_bin *j, long apart)
{
    long low = (long)j->first - apart, high = (long)j->last - apart;
    low = low > (long)i->first ? low : (long)i->first;
    high = high < (long)i->last ? high : (long)i->last;
    return high >= low ? (double)(high - low + 1) : 0;
}

double log_bin_covariance(const struct log_bin *i, const struct log_bin *j, double scans)
{
    if (i->first > j->last + MULTITAPER_CORRELATED || j->first > i->last + MULTITAPER_CORRELATED)
        return 0;
    double sum = 0, i_members = (double)(i->last - i->first + 1), j_members = (double)(j->last - j->first + 1);
    for (long apart = -MULTITAPER_CORRELATED; apart <= MULTITAPER_CORRELATED; apart++)
        sum += pairs(i, j, apart) * multitaper_correlation((size_t)labs(apart));
    return log_bin_variance(scans) * sum / (i_members * j_members);
}
