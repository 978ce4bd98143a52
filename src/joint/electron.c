/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "joint/electron.h"

#include "base/constants.h"

#include <math.h>
#include <strings.h>

/** Ashcroft and Mermin 1976, Solid State Physics, table 1.1. */
static const struct electron_metal electron_metals[] = {
    {"copper", 8.47e28},    {"silver", 5.86e28}, {"gold", 5.90e28},
    {"aluminium", 18.1e28}, {"tin", 14.8e28},    {"indium", 11.5e28},
};
static const size_t electron_metal_count = sizeof electron_metals / sizeof electron_metals[0];

const struct electron_metal *electron_metal_find(const char *name)
{
    for (size_t i = 0; i < electron_metal_count; i++)
        if (strcasecmp(electron_metals[i].name, name) == 0)
            return &electron_metals[i];
    return NULL;
}

double electron_mean_free_path(double density_per_m3, double resistivity_ohm_m)
{
    double charge = constant_electron_charge_C, reduced_planck = constant_planck_J_s / (2 * M_PI);
    double product = reduced_planck / charge * cbrt(3 * M_PI * M_PI) / charge / pow(density_per_m3, 2.0 / 3);
    return product / resistivity_ohm_m;
}
