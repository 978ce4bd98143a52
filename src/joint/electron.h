/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Electrons' mean free path in metals, and the resistance of spots as small (equations: small spots). Wexler 1966,
 * Proc. Phys. Soc. 89, 927; Sharvin 1965, Sov. Phys. JETP 21, 655. */
#ifndef JOINT_ELECTRON_H
#define JOINT_ELECTRON_H

#include <stddef.h>

/** A metal's free electrons. */
struct electron_metal {
    const char *name; /* as in the material table */
    double density_per_m3;
};
/** The row of that name (case-insensitive), NULL when there is none. */
const struct electron_metal *electron_metal_find(const char *name);

/** rho l = hbar (3 pi²)^(1/3)/(e² n^(2/3)) [ohm m²] of n free electrons per m³ (Drude's formula, spherical Fermi
 * surface). */
double electron_resistivity_path(double density_per_m3);

/** l = (rho l)/rho [m]. The length of (4.52) is one of phonons: in a metal electrons carry the heat. */
double electron_mean_free_path(double density_per_m3, double resistivity_ohm_m);

/** Resistance [ohm] of a spot of radius a: 4 rho l/(3 pi a²) + Gamma rho/(2a), Gamma(l/a) as fitted by Nikolic and
 * Allen 1999 (Phys. Rev. B 60, 3963), (1 + 0.83 K)/(1 + 1.33 K), 1...0.624; the source was not at hand, its limits
 * hold. Gamma = 1, as in (4.51), is at most 13 % more. */
double electron_spot_resistance(double resistivity_ohm_m, double mean_free_path_m, double radius_m);

#endif
