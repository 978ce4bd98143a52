/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Constants of nature, exact by the definition of the SI (BIPM, The International System of Units, 9th edition 2019).
 */
#ifndef BASE_CONSTANTS_H
#define BASE_CONSTANTS_H

static const double constant_boltzmann_J_per_K = 1.380649e-23;    /* k_B */
static const double constant_electron_charge_C = 1.602176634e-19; /* e */
static const double constant_planck_J_s = 6.62607015e-34;         /* h */
static const double constant_avogadro_per_mol = 6.02214076e23;    /* N_A */
static const double constant_stefan_boltzmann = 5.670374419e-8;   /* sigma [W/m²/K^4] */

#endif
