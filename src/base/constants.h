/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Constants of nature, exact by the definition of the SI (BIPM, The International System of Units, 9th edition 2019).
 */
#ifndef BASE_CONSTANTS_H
#define BASE_CONSTANTS_H

extern const double constant_boltzmann_J_per_K; /* k_B */
extern const double constant_electron_charge_C; /* e */
extern const double constant_planck_J_s;        /* h */
extern const double constant_avogadro_per_mol;  /* N_A */

#endif
