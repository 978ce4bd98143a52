/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rough surfaces to solve the contact of, made from what a profile tells.
 *
 * Wave numbers are counted as harmonics of the cell: the mode (i, j) of an L x L surface has r = sqrt(i² + j²) waves in
 * L. v(i, j) is the variance of a complex mode; a row of the surface has at harmonic m >= 1 the mean square
 *     P1(m) = Delta_m²/2 = 2 sum_j v(m, j).
 * A row also contains the modes (0, j) as its mean, so the surface is rougher than its rows: Sq > Rq.
 */
#ifndef DIRECT_SURFACE_H
#define DIRECT_SURFACE_H

#include "base/status.h"
#include <stddef.h>
#include <stdint.h>

/** Variance [m²] of a complex mode with r > 0 waves in the cell. */
typedef double direct_variance(double r, const void *context);

/** Delta = alpha lambda^gamma between lambda_s and L/roll_off, constant for longer waves; shorter waves fall as
 * exp(-ln2 ((lambda_s/lambda)² - 1)), the Gaussian filter of ISO 16610-21 relative to its value at lambda_s. */
struct direct_law {
    double alpha; /* m^(1-gamma) */
    double gamma;
    double lambda_s_m;
    double length_m; /* L */
    double roll_off; /* waves in L; 1 or less: none */
};

/** Number of harmonics up to where the cut-off leaves less than 2e-3 of the amplitude: 3.2 L/lambda_s. */
size_t direct_law_harmonics(const struct direct_law *law);
/** Delta_m [m], m = 1, 2, ... */
double direct_law_amplitude(const struct direct_law *law, size_t m);

/** The law with the cut-off lambda_s whose rows have the moments m_k = sum (2 pi m/L)^k Delta_m²/2, k = 0, 1, 2. A fit
 * through the logarithms of a measured spectrum does not have them (the mean logarithm of the power of a Gaussian
 * surface is that of exp(-0.577) of its mean power). m0 governs separation, m2 the area at low load, m1 (elastic
 * energy) the gap near closing. Gamma, within -2 ... 8, follows from m2/m0 for each roll-off, the roll-off, within 1
 * ... L/(1.5 lambda_s), from m1; if none fits, the nearest. Error: STATUS_MODEL: no such law. */
MUST_CHECK enum status_code direct_law_match(struct direct_law *out, const double moments[3], double length_m,
                                             double lambda_s_m, struct status *status);

/** Isotropic: v(r) = w(r) max(r, roll_off)^-(2 gamma + 1), w linear between w_1 ... w_M at whole r and 0 from M + 1 on
 * (w_1 below r = 1, which no mode has). Owned: direct_spectrum_free(). */
struct direct_spectrum {
    double *weight_m2; /* w_r at index r - 1 */
    size_t count;      /* M */
    double exponent;   /* 2 gamma + 1 */
    double roll_off;
};

/** The surface with a law's rows: the discrete counterpart of C2(q) = -1/pi int_q^inf C1'(k)/sqrt(k² - q²) dk (Nayak,
 * Wear 26 (1973) 305), triangular and solved from the shortest wave down. gamma and roll_off set only the shape between
 * whole r; the rows come out exactly whatever they are. To be freed whatever comes back. Errors: STATUS_MEMORY;
 * STATUS_MODEL: no isotropic surface has them. */
MUST_CHECK enum status_code direct_spectrum_of_law(struct direct_spectrum *out, const struct direct_law *law,
                                                   struct status *status);
void direct_spectrum_free(struct direct_spectrum *spectrum);
/** v(r) of a struct direct_spectrum: a direct_variance. */
double direct_spectrum_variance(double r, const void *spectrum);

/** Recipe of a surface. */
struct direct_recipe {
    direct_variance *variance;
    const void *context;   /* its */
    const double *given_m; /* heights whose distribution the surface takes; NULL: Gaussian */
    size_t given_count;
};

/** Fills n x n heights, n even. Gaussian (given_m NULL): each pair of modes +-(i, j), |i|, |j| < n/2, gets the
 * amplitude sqrt(4 v) and a phase hashed from seed, i and j alone. So every seed has the same row spectrum, and a seed
 * is the same surface on every grid that holds its modes. Else with the same spectrum and, as nearly as that allows,
 * the distribution of the `given` heights (their quantiles, shifted and scaled to the spectrum's mean square): the
 * iterated amplitude-adjusted Fourier transform (Schreiber and Schmitz, Phys. Rev. Lett. 77 (1996) 635), rounds
 * from a shuffle hashed from the seed until one moves the heights by 0.3 % of their rms, 60 at most, ending with the
 * exact spectrum. Equal heights rank by their place. Errors:
 * STATUS_MEMORY; STATUS_MODEL: a variance negative or not finite; fewer than 2 given heights, all equal, or one not
 * finite. */
MUST_CHECK enum status_code direct_surface_make(double *height_m, size_t n, const struct direct_recipe *recipe,
                                                uint64_t seed, struct status *status);

/** A number in 0 ... 1 (without 1) that depends on seed and index alone, on every machine. */
double direct_random(uint64_t seed, uint64_t index);

/** The same surface on a grid of `times` n points a side (n even): `fine_m` interpolates the heights by their Fourier
 * series, without the modes at n/2. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code direct_surface_refine(double *fine_m, size_t times, const double *height_m, size_t n,
                                                  struct status *status);

#endif
