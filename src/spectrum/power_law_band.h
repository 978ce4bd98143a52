/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The band of wavelengths in which a surface obeys a power law Delta = alpha lambda^gamma: found in its multitaper
 * spectrum, fitted there by generalised least squares, with standard errors that hold. Outside of it lie the roll-off
 * to a plateau, a filter's flank and the instrument's noise. */
#ifndef SPECTRUM_POWER_LAW_BAND_H
#define SPECTRUM_POWER_LAW_BAND_H

#include "base/status.h"
#include "spectrum/log_bin.h"

enum { POWER_LAW_BAND_PIECES = 6 };

/** How much of a law it is. A narrow or scattered one belongs in no headline, ranking or convergence study. */
enum power_law_band_class {
    POWER_LAW_BAND_NONE,      /* no power law found */
    POWER_LAW_BAND_SCATTERED, /* a line through amplitudes that scatter more than a Gaussian surface's */
    POWER_LAW_BAND_NARROW,    /* under a decade of wavelength */
    POWER_LAW_BAND_LAW
};

/** "no power law found", "scattered", "narrow", "law" */
extern const char *const power_law_band_class_names[];

/** What became of a bin. */
enum power_law_band_use {
    POWER_LAW_BAND_OUTSIDE, /* of the band */
    POWER_LAW_BAND_USED,    /* in the fit */
    POWER_LAW_BAND_LINE,    /* a line of the spectrum: periodic marks */
    POWER_LAW_BAND_BESIDE,  /* next to one */
    POWER_LAW_BAND_SHORT,   /* shorter than the shortest wavelength that says something about the surface */
    POWER_LAW_BAND_EMPTY    /* a harmonic in it has no power at all */
};

/** A multitaper spectrum. */
struct power_law_band_spectrum {
    const double *square_m2; /* Delta_n², n = 1 ... count: multitaper_square(), or the mean of several */
    size_t count;
    double length_m;   /* L: harmonic n has wavelength L/n */
    double scans;      /* M: how many independent scans were averaged, >= 1; rows of a map count less */
    double shortest_m; /* bins of a shorter mean wavelength are left out; 0: none */
};

/** The law in one band. NaN where the class is NONE. */
struct power_law_band_fit {
    double gamma, gamma_s;                       /* exponent and its standard error */
    double log10_amplitude, log10_amplitude_s;   /* of the rms amplitude [m] at wavelength_m; error in decades */
    double gamma_bias_s, log10_amplitude_bias_s; /* of these, what misfit and knees add: more scans do not lessen it */
    double wavelength_m;                         /* the band's middle, sqrt(shortest longest) */
    double misfit_decades;                       /* tau: lack of fit beyond the scatter of a Gaussian random surface */
    double band_m[2];                            /* shortest and longest wavelength */
    size_t first_harmonic, last_harmonic;        /* the same: L/band_m[1], L/band_m[0] */
    size_t bins;                                 /* used */
};

/** A straight piece of the segmented spectrum. */
struct power_law_band_piece {
    double gamma;
    double band_m[2]; /* shortest and longest wavelength */
};

/** All that a report prints and draws. Arrays by bin run from long to short waves. */
struct power_law_band {
    enum power_law_band_class law;
    struct power_law_band_fit fit;
    double amplitude_m; /* 10^log10_amplitude, at fit.wavelength_m */
    double psd_m3; /* amplitude² L/2: the one-sided spectral density, which does not depend on the scan's length */
    double alpha;  /* m^(1-gamma), derived: amplitude/wavelength^gamma */
    double slope_share; /* share of the mean square slope m2 that the band's harmonics carry */

    size_t pieces; /* of a found band: none when too few bins are left to look */
    struct power_law_band_piece piece[POWER_LAW_BAND_PIECES];
    double knee_m[POWER_LAW_BAND_PIECES - 1]; /* between piece i and i + 1 */

    size_t bins;
    struct log_bin bin[LOG_BIN_MOST];
    enum power_law_band_use use[LOG_BIN_MOST];
};

/** Looks for the band.
 * 1. log_bin_fill() of the harmonics n >= 5.
 * 2. Lines: runs of at most 3 bins above the median of (y_{j-m} + y_{j+m})/2, m = 2, 3, 4, by more than max(0.2,
 *    z sqrt(2 v_j)), or between two such and no valley of 0.2, of which one's highest harmonic also stands above the
 *    pieces of step 3 through the rest (of one steeper than 2.28, above its mean): at its place, and of those on its
 * left and right alone, by normal quantiles (Bonferroni) of 0.02 over all harmonics, on one side of 0.05 over the
 * bin's, and above the bin after the run by 0.3 more than any law: of files without lines at most 2 % have one,
 * whatever the scans and cut-offs. z: of 0.02 over the bins. Lines are left out, and the bin on either side.
 * 3. At most 6 straight pieces of at least 3 bins each, by dynamic programming: least sum of w r² + 4 ln J per piece, J
 *    bins, w = 1/(v + 0.05²) (Bellman 1961, doi:10.1145/366573.366611, with a penalty on pieces).
 * 4. A piece's end that is a knee loses 2 bins (1, 0 where less than 0.5 decade or 4 bins would stay). So does the long
 *    end of any piece of gamma > 1.75, where waves longer than the record leak.
 * 5. Candidates: at least 0.5 decade and 4 bins, 0.5 <= gamma <= 2.28. The widest with tau <= 0.1 decades wins.
 * 6. The fit: w = 1/(v + tau²), tau² >= 0 such that sum w r² = n - 2 (Mandel & Paule 1970, doi:10.1021/ac60293a019);
 *    s² = a'(Sigma + tau² I)a for the estimate a'y. A knee adds, in quadrature, what 2 bins more off that end change,
 *    and once 0.04 (gamma) and 0.02 decades (amplitude). More scans lessen neither that nor tau² a'a.
 * 7. Where that leaves none, or a narrow one whose gamma has an error above 0.35: steps 3 to 5 once more with 7.5 v in
 *    place of v, 1 bin off at knees and any tau. The widest candidate that holds the narrow one's middle is SCATTERED:
 *    its band reaches to L where no knee ends it, and s² = a'(phi Sigma)a, phi = sum r²/(v (n - 2)), 1 at least.
 *    power_law_of_band() puts the line of the single harmonics there.
 * Class NONE, and no error, when nothing is found. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code power_law_band_find(struct power_law_band *out,
                                                const struct power_law_band_spectrum *spectrum, struct status *status);

/** Step 6, with lines and short bins left out, in the given band, band_m = {shortest, longest}, at whose ends bins are
 * divided: for a band that the user states, or each scan in the band of their mean. Class NONE when fewer than 4 bins
 * are left. */
MUST_CHECK enum status_code power_law_band_fit_in(struct power_law_band *out,
                                                  const struct power_law_band_spectrum *spectrum,
                                                  const double band_m[2], struct status *status);

/** Wavelengths of the lines, longest first: of each run of bins that are one, the highest bin's. Returns how many. */
size_t power_law_band_lines(double wavelength_m[LOG_BIN_MOST], const struct power_law_band *band);

#endif
