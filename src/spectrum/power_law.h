/* The power law Delta = alpha lambda^gamma through a spectrum (4.53); docs/equations.md, From scan to spectrum. */
#ifndef SPECTRUM_POWER_LAW_H
#define SPECTRUM_POWER_LAW_H

#include "spectrum/spectrum.h"

/** Scatter of log10 amplitude that a Gaussian random surface has by itself: pi/sqrt(24)/ln 10 decades. */
extern const double power_law_gaussian_scatter_decades;

/** Least squares of log10 Delta on log10 lambda, lambda in metres. A fit that cannot be made has gamma = NaN. */
struct power_law {
    double alpha;       /* m^(1-gamma) */
    double alpha_error; /* standard error, m^(1-gamma) */
    double gamma;
    double gamma_error;              /* standard error */
    double rms_decades;              /* RMS residual of log10 Delta */
    double band_m[2];                /* shortest and longest wavelength used */
    size_t harmonics;                /* how many were used */
    double knee_m;                   /* wavelength at which two slopes fit clearly better than one; NaN: one will do */
    double gamma_below, gamma_above; /* slopes on the short and the long side of the knee */
};

/** Fits (4.53) to the harmonics whose wavelength lies in band_m = {shortest, longest}; amplitudes of zero are left out.
 * Fewer than 3 harmonics in the band, or an alpha beyond the range of double: every number NaN. */
struct power_law power_law_fit(const struct spectrum *spectrum, const double band_m[2]);

/** Amplitude of the law at a wavelength [m] (4.53). */
double power_law_amplitude(const struct power_law *law, double wavelength_m);

#endif
