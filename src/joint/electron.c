/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "joint/electron.h"

#include "base/constants.h"

#include <math.h>

double electron_mean_free_path(double density_per_m3, double resistivity_ohm_m)
{
    double charge = constant_electron_charge_C, reduced_planck = constant_planck_J_s / (2 * M_PI);
    double product = reduced_planck / charge * cbrt(3 * M_PI * M_PI) / charge / pow(density_per_m3, 2.0 / 3);
    return product / resistivity_ohm_m;
}
