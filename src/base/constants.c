/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/constants.h"

const double constant_boltzmann_J_per_K = 1.380649e-23;
const double constant_electron_charge_C = 1.602176634e-19;
const double constant_planck_J_s = 6.62607015e-34;
const double constant_avogadro_per_mol = 6.02214076e23;
