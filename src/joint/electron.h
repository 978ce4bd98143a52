/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mean free path of electrons in metals. Ashcroft and Mermin 1976, Solid State Physics. */
#ifndef JOINT_ELECTRON_H
#define JOINT_ELECTRON_H

/** l = (rho l)/rho [m], rho l = hbar (3 pi²)^(1/3)/(e² n^(2/3)) of n free electrons per m³ (Drude's formula, spherical
 * Fermi surface). In a metal electrons carry the heat; (4.52) is for phonons. */
double electron_mean_free_path(double density_per_m3, double resistivity_ohm_m);

#endif
