/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The band of wavelengths in which a surface follows a power law Delta = alpha lambda^gamma. It is found in the
 * multitaper spectrum; the law is fitted there by generalised least squares, with standard errors. Outside the band lie
 * the roll-off to a plateau, the flank of a filter and the noise of the instrument. */
#ifndef SPECTRUM_POWER_LAW_BAND_H
#define SPECTRUM_POWER_LAW_BAND_H

#include "spectrum/log_bin.h"

enum { POWER_LAW_BAND_PIECES = 6 };

/** A narrow or scattered law is kept out of headlines, rankings and convergence studies. */
enum power_law_band_class {
    POWER_LAW_BAND_NONE,      /* no power law found */
    POWER_LAW_BAND_SCATTERED, /* a line through amplitudes that scatter more than those of a Gaussian surface */
    POWER_LAW_BAND_NARROW,    /* under a decade of wavelength */
    POWER_LAW_BAND_LAW
};

/** "no power law found", "scattered", "narrow", "law" */
extern const char *const power_law_band_class_names[];

/** What became of a bin. */
enum power_law_band_use {
    POWER_LAW_BAND_OUTSIDE, /* outside the band */
    POWER_LAW_BAND_USED,    /* in the fit */
    POWER_LAW_BAND_LINE,    /* a spectral line: periodic marks */
    POWER_LAW_BAND_BESIDE,  /* next to a line */
    POWER_LAW_BAND_SHORT,   /* shorter than shortest_m */
    POWER_LAW_BAND_EMPTY    /* holds a harmonic without power */
};

/** A multitaper spectrum. */
struct power_law_band_spectrum {
    const double *amplitude_m; /* Delta_n, n = 1 ... count: roots of multitaper_square(), or of the mean of several */
    size_t count;
    double length_m;   /* L: harmonic n has wavelength L/n */
    double scans;      /* M >= 1: how many independent scans were averaged; a row of a map counts as less than one */
    double shortest_m; /* bins of a shorter mean wavelength are left out; 0: none */
};

/** The law in one band; NaN where the class is NONE. */
struct power_law_band_fit {
    double gamma, gamma_s;                       /* exponent and its standard error */
    double log10_amplitude, log10_amplitude_s;   /* of the rms amplitude [m] at wavelength_m; error in decades */
    double gamma_bias_s, log10_amplitude_bias_s; /* their parts from misfit and knees, which more scans do not reduce */
    double wavelength_m;                         /* the band's middle, sqrt(shortest longest) */
    double misfit_decades;                       /* tau: lack of fit beyond the scatter of a Gaussian random surface */
    double band_m[2];                            /* shortest and longest wavelength */
    size_t first_harmonic, last_harmonic;        /* the same: L/band_m[1], L/band_m[0] */
};

/** All that a report prints and draws. Arrays by bin run from long to short waves. */
struct power_law_band {
    enum power_law_band_class law;
    struct power_law_band_fit fit;
    double psd_m3; /* amplitude² L/2: the one-sided spectral density, which does not depend on the scan's length */
    double slope_share; /* share of the mean square slope m2 that the band's harmonics carry */

    size_t pieces;                            /* straight ones, of power_law_band_find(); 0: too few bins */
    double knee_m[POWER_LAW_BAND_PIECES - 1]; /* between piece i and i + 1 */

    size_t bins;
    struct log_bin bin[LOG_BIN_MOST];
    enum power_law_band_use use[LOG_BIN_MOST];
};

/** Looks for the band.
 * 1. log_bin_fill() of the harmonics n >= 5.
 * 2. Spectral lines: runs of at most 3 bins that stand above the median of (y_{j-m} + y_{j+m})/2, m = 2, 3, 4, by more
 *    than max(0.2, z sqrt(2 v_j)), or lie between two such bins without a valley of 0.2. The highest harmonic of one of
 *    them must also stand above the pieces of step 3 through the other bins at its place (above their mean where they
 *    are steeper than 2.28), above those on its left and above those on its right, by normal quantiles of 0.02 over all
 *    harmonics (on one side 0.05 over those of the bin; Bonferroni), and above the bin after the run by 0.3 more than
 *    any law does. z is the quantile of 0.02 over the bins. At most 2 % of files without lines then have one, whatever
 *    their scans and cut-offs. Lines are left out, and the bin on either side.
 * 3. At most 6 straight pieces of at least 3 bins each, by dynamic programming: least sum of w r² + 4 ln J per piece, J
 *    bins, w = 1/(v + 0.05²) (Bellman 1961, doi:10.1145/366573.366611, with a penalty on pieces).
 * 4. A piece loses 2 bins at an end that is a knee (1 or 0 where less than 0.5 decade or 4 bins would stay). The long
 *    end of a piece with gamma > 1.75 counts as a knee: waves longer than the record leak in there.
 * 5. Candidates: at least 0.5 decade and 4 bins, 0.5 <= gamma <= 2.28. The widest with tau <= 0.1 decades wins.
 * 6. The fit: w = 1/(v + tau²), tau² >= 0 such that sum w r² = n - 2 (Mandel & Paule 1970, doi:10.1021/ac60293a019);
 *    s² = a'(Sigma + tau² I)a for the estimate a'y. A knee adds, in quadrature, by how much leaving out 2 more bins
 *    there changes the estimate, and once 0.04 (gamma) and 0.02 decades (amplitude). More scans reduce neither this nor
 *    tau² a'a.
 * 7. If there is none, or a narrow one with an error of gamma above 0.35: steps 3 to 5 again with 7.5 v in place of v,
 *    any tau and one bin off at knees. The widest candidate that holds the middle of the narrow one is SCATTERED: its
 *    band reaches to L where no knee ends it, and s² = a'(phi Sigma)a, phi = sum r²/(v (n - 2)), at least 1.
 *    power_law_of_band() fits the line through the single harmonics there.
 * Nothing found is class NONE. */
void power_law_band_find(struct power_law_band *out, const struct power_law_band_spectrum *spectrum);

/** Step 6 in a given band_m = {shortest, longest}, without lines and short bins: the user's band, or that of the mean
 * of scans for each of them. Bins are divided at its ends. Class NONE when fewer than 4 bins are left. */
void power_law_band_fit_in(struct power_law_band *out, const struct power_law_band_spectrum *spectrum,
                           const double band_m[2]);

/** Wavelengths of the spectral lines, longest first: of each run of bins that of the highest. Returns how many. */
size_t power_law_band_lines(double wavelength_m[LOG_BIN_MOST], const struct power_law_band *band);

#endif
