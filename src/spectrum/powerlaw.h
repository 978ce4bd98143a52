/* The power law Delta = alpha lambda^gamma through a spectrum (physics §1; thesis 4.53). */
#ifndef SPECTRUM_POWERLAW_H
#define SPECTRUM_POWERLAW_H

#include "spectrum/spectrum.h"

/** Scatter of log10 amplitude that a Gaussian random surface has by itself: pi/sqrt(24)/ln 10 decades. */
extern const double powerlaw_gaussian_scatter_decades;

/** Least squares of log10 Delta on log10 lambda, lambda in metres. A fit that cannot be made has gamma = NaN. */
struct powerlaw {
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

/** Fits the harmonics whose wavelength lies in band_m = {shortest, longest}; amplitudes of zero are left out.
 * Fewer than 3 harmonics in the band, or an alpha beyond the range of double: every number NaN. */
struct powerlaw powerlaw_fit(const struct spectrum *spectrum, const double band_m[2]);

/** Amplitude of the law at a wavelength [m]. */
double powerlaw_amplitude(const struct powerlaw *law, double wavelength_m);

#endif
