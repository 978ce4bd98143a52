/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Electrons' mean free path in metals. Ashcroft and Mermin 1976, Solid State Physics. */
#ifndef JOINT_ELECTRON_H
#define JOINT_ELECTRON_H

/** l = (rho l)/rho [m], rho l = hbar (3 pi²)^(1/3)/(e² n^(2/3)) of n free electrons per m³ (Drude's formula, spherical
 * Fermi surface). The length of (4.52) is one of phonons: in a metal electrons carry the heat. */
double electron_mean_free_path(double density_per_m3, double resistivity_ohm_m);

#endif
