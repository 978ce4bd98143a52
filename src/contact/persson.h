/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Persson's theory of elastic contact between a Gaussian, isotropic surface and a flat: area, mean separation and
 * conductance at any load (equations: Persson). Persson 2001, J. Chem. Phys. 115, 3840 (area); Persson 2007, Phys. Rev.
 * Lett. 99, 125502, Yang and Persson 2008, J. Phys.: Condens. Matter 20, 215214, and Almqvist, Campana, Prodanov and
 * Persson 2011, J. Mech. Phys. Solids 59, 2355 (separation). */
#ifndef CONTACT_PERSSON_H
#define CONTACT_PERSSON_H

#include "base/status.h"
#include "contact/persson_kernel.h"
#include "spectrum/spectrum.h"

/** g of the corrected form, 0.45 (Almqvist et al. 2011); 1 is the original. Others have 0.42 and 5/9. */
extern const double persson_energy_factor;

/** A/A_n at p = P/(A_n E') >= 0 of a surface whose profile has the mean-square slope m2:
 * A = erf(p/sqrt(m2 (g + (1-g) A))), one root in 0...1. A flat one (m2 = 0) is wholly in contact. */
double persson_area(double load, double m2, double energy_factor);

/** p at which persson_area() is area_ratio (0...1): p = erf^-1(A) sqrt(m2 (g + (1-g) A)). */
double persson_load(double area_ratio, double m2, double energy_factor);

/** erf^-1(y), 0 <= y <= 1, to rounding. */
double persson_erf_inverse(double y);

/** The waves of a surface, ready for any load: ring n of the surface has mean square height D_n²/2 at the wave number
 * q_n = sqrt2 2 pi f_n, so that m0 and m2 are the profile's. With y_n² the mean-square slope of the profile's waves up
 * to n, u = (2/sqrt(pi)) sum [S(y_n) - S(y_{n-1})]/q_n is summed by parts, without cancellation: u = (2/sqrt(pi)) sum
 * c_n y_n s(p/y_n), c_n = 1/q_n - 1/q_{n+1}. Where rings crowd they are grouped: those with y within a factor e^(1/2)
 * by the 10 nodes and weights of Gauss's rule for the measure c at ln y. Owned: persson_free(). */
struct persson {
    struct persson_kernel kernel;
    double m0_m2, m2;
    struct persson_nodes {
        size_t count;
        double *slope;     /* y, ascending; owns the other two's memory */
        double *logarithm; /* ln y */
        double *weight_m;  /* (2/sqrt(pi)) c */
    } rings, groups;
};

/** Prepares the waves of `spectrum`. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code persson_make(struct persson *out, const struct spectrum *spectrum, double energy_factor,
                                         struct status *status);
void persson_free(struct persson *persson);

/** Where the mean planes are, and how that changes with the load. */
struct persson_separation {
    double separation_m;   /* u(p) */
    double constriction_m; /* -du/dp: resistance R A_n = rho (-du/dp), rho half of both resistivities (Barber 2003,
                              Proc. R. Soc. A 459, 53); thermal: (-du/dp)/k */
};

/** At p = P/(A_n E') > 0. Relative error below 1e-11 (tests); p beyond about 27 sqrt(m2) gives 0, by underflow. A flat
 * surface has neither. */
struct persson_separation persson_separation(const struct persson *persson, double load);

#endif
