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

/** The law by either method, lambda in metres. One that cannot be fitted or is not found has gamma = NaN. */
struct power_law {
    enum power_law_band_class found; /* of the thesis's method: LAW where there is a fit */
    double alpha;                    /* m^(1-gamma), derived: the amplitude at 1 m */
    double gamma;
    double gamma_error;             /* standard error */
    double amplitude_m;             /* of the law at wavelength_m, the band's middle; auto: rms amplitude */
    double amplitude_error_decades; /* standard error of its log10 */
    double wavelength_m;
    double psd_m3; /* amplitude² L/2: does not depend on the length of the scan */
    double
        misfit_decades; /* auto: lack of fit beyond a Gaussian surface's scatter; thesis, and scattered: RMS residual */
    double band_m[2];   /* shortest and longest wavelength used */
    size_t harmonics;   /* thesis: how many were used */
    double knee_m;      /* wavelength at which two slopes fit clearly better than one; NaN: one will do */
    double gamma_below, gamma_above; /* slopes on the short and the long side of the knee */
};

/** Fits (4.53) to the harmonics whose wavelength lies in band_m = {shortest, longest}; amplitudes of zero are left out.
 * Fewer than 3 harmonics in the band, or an alpha beyond the range of double: every number NaN. */
struct power_law power_law_fit(const struct spectrum *spectrum, const double band_m[2]);

/** The law of a band that was found; of none: every number NaN. Of a scattered one (4.53) in that band of `spectrum`,
 * the amplitudes that contact models have, with errors from the scatter seen. */
struct power_law power_law_of_band(const struct power_law_band *band, const struct spectrum *spectrum);

/** May it be carried on, ranked, and put at the head of a report? Not one of under a decade, nor a scattered one. */
bool power_law_holds(const struct power_law *law);

/** Amplitude of the law at a wavelength [m] (4.53). */
double power_law_amplitude(const struct power_law *law, double wavelength_m);

/** Standard error of log10 of it (4.53): that at the middle of the band and what the slope's adds, in quadrature. */
double power_law_error_decades(const struct power_law *law, double wavelength_m);

#endif
