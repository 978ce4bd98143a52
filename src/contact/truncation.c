/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/truncation.h"

#include "contact/constriction.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

double truncation_slope(double m2)
{
    return sqrt(2 * m2 / M_PI);
}

bool truncation_press(struct truncation_contact *out, const struct truncation *law, double pressure_over_hardness)
{
    double tail = pressure_over_hardness / law->fraction; /* erfc(l/sqrt2)/2 */
    if (!(tail > 0 && tail < 1))
        return false;
    double l = gsl_cdf_ugaussian_Qinv(tail), bell = exp(-l * l / 2), steepness = law->slope / law->sigma_m;
    double alleviation = constriction_alleviation(pressure_over_hardness, 1 - pressure_over_hardness);
    *out = (struct truncation_contact){
        .separation_over_sigma = l,
        .area_ratio = pressure_over_hardness,
        .spot_density_per_m2 = steepness * steepness * bell * (bell / tail) / 32,
        .spot_radius_m = sqrt(law->fraction) * sqrt(8 / M_PI) / steepness * 2 * (tail / bell),
        .conductance = sqrt(law->fraction) * bell / (2 * sqrt(2 * M_PI) * alleviation),
    };
    return true;
}

double truncation_resistance(const struct truncation *law, const struct truncation_contact *contact, double resistivity)
{
    return resistivity * (law->sigma_m / law->slope) / contact->conductance;
}
