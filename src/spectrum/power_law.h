/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The power law Delta = alpha lambda^gamma through a spectrum (4.53); docs/equations.md, From scan to spectrum. */
#ifndef SPECTRUM_POWER_LAW_H
#define SPECTRUM_POWER_LAW_H

#include "spectrum/power_law_band.h"
#include "spectrum/spectrum.h"

/** How the law is fitted. */
enum power_law_method {
    POWER_LAW_AUTO,   /* in the band found in the multitaper spectrum: power_law_band.h, power_law_of_band() */
    POWER_LAW_THESIS, /* least squares over all harmonics of the periodogram: power_law_fit() */
    POWER_LAW_METHOD_COUNT
};
extern const char *const power_law_method_names[POWER_LAW_METHOD_COUNT]; /* as a scene spells them */

/** The law by either method, lambda in metres; gamma = NaN where none is found or fitted. */
struct power_law {
    enum power_law_band_class found; /* of the thesis's method: LAW where there is a fit */
    double alpha;                    /* m^(1-gamma), derived: the amplitude at 1 m */
    double gamma;
    double gamma_error;             /* standard error */
    double amplitude_m;             /* of the law at wavelength_m, the middle of the band; auto: rms amplitude */
    double amplitude_error_decades; /* standard error of its log10 */
    double wavelength_m;
    double psd_m3;         /* amplitude² L/2: does not depend on the length of the scan */
    double misfit_decades; /* auto: lack of fit beyond the scatter of a Gaussian surface; else RMS residual */
    double band_m[2];      /* shortest and longest wavelength used */
    size_t harmonics;      /* thesis: how many were used */
    double knee_m;         /* wavelength at which two slopes fit clearly better than one; NaN: one slope is enough */
    double gamma_below, gamma_above; /* slopes on the short and the long side of the knee */
};

/** Fits (4.53) to the harmonics whose wavelength lies in band_m = {shortest, longest}; amplitudes of zero are left out.
 * Fewer than 3 harmonics in the band, or an alpha beyond the range of double: every number NaN. */
struct power_law power_law_fit(const struct spectrum *spectrum, const double band_m[2]);

/** The law of a band that was found (NONE: every number NaN). Of a scattered one (4.53) fitted in that band of
 * `spectrum`, whose amplitudes the contact models use, with errors from their scatter. */
struct power_law power_law_of_band(const struct power_law_band *band, const struct spectrum *spectrum);

/** May it be extrapolated, ranked and shown in a headline? Not if it is scattered or under a decade wide. */
bool power_law_holds(const struct power_law *law);

/** Amplitude of the law at a wavelength [m] (4.53). */
double power_law_amplitude(const struct power_law *law, double wavelength_m);

/** Standard error of its log10: that at the middle of the band and that of the slope, in quadrature. */
double power_law_error_decades(const struct power_law *law, double wavelength_m);

#endif
