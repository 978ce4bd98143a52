/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Persson's theory of elastic contact between a Gaussian, isotropic surface and a flat (equations: Persson): the load
 * and the resistance that go with an area. Persson 2001, J. Chem. Phys. 115, 3840; Persson 2007, Phys. Rev. Lett. 99,
 * 125502; Almqvist, Campana, Prodanov and Persson 2011, J. Mech. Phys. Solids 59, 2355; Barber 2003, Proc. R. Soc.
 * A 459, 53. */
#ifndef CONTACT_PERSSON_H
#define CONTACT_PERSSON_H

#include "base/status.h"
#include "spectrum/spectrum.h"

/** g = 0.45 (Almqvist et al. 2011); others give 0.42 and 5/9. */
extern const double persson_energy_factor;

/** p = P/(A_n E') at an area ratio (0...1) of a surface of mean-square profile slope m2: erf^-1(A) sqrt(m2 (g + (1-g)
 * A)). */
double persson_load(double area_ratio, double m2);

/** erf^-1(y), 0 <= y <= 1, to rounding. */
double persson_erf_inverse(double y);

/** The waves of a surface: ring n has mean square height D_n²/2 at the wave number q_n = sqrt2 2 pi f_n, so that m0 and
 * m2 are the profile's; Y_n² is the mean-square slope of the waves up to n. Each ring is divided among nodes evenly
 * spaced in ln y. Owned: persson_free(). */
struct persson {
    double m0_m2, m2;
    size_t count;
    struct persson_node {
        double slope, weight_m; /* y, ascending; (1/sqrt(pi)) (1/q_n - 1/q_{n+1}) of the rings about it */
    } * node;
};

/** Mean square height of the wave, twice as long as the record, that levelling takes out with mean and tilt: the mean
 * of the harmonics 1 ... 3. */
double persson_lost_wave(const struct spectrum *spectrum);

/** Prepares the waves of `spectrum` and that lost wave of mean square height lost_m2 (0: none). Error: STATUS_MEMORY.
 */
MUST_CHECK enum status_code persson_make(struct persson *out, const struct spectrum *spectrum, double lost_m2,
                                         struct status *status);
void persson_free(struct persson *persson);

/** I_2(x) = int_x^inf f(t)/t² dt, f(t) = [g + 3(1-g) erf² t] exp(-t²), 0 < x < 9; relative error below 1e-12.
 * Only once persson_make() was called. */
double persson_integral(double x);

/** l_0 = (1/sqrt(pi)) sum_n [I_2(p/Y_n) - I_2(p/Y_{n-1})]/q_n, summed by parts, at 0 < p = P/(A_n E') < 5 sqrt(m2):
 * R A_n = (rho_1 + rho_2) l_0. Relative error below 1e-7 up to A = 0.97 (tests). */
double persson_constriction(const struct persson *persson, double load);

#endif
