/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/cmy.h"

#include "contact/constriction.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

double cmy_slope(double m2)
{
    return sqrt(2 * m2 / M_PI);
}

bool cmy_press(struct cmy_contact *out, const struct cmy *surface, double pressure_over_hardness)
{
    if (!(pressure_over_hardness > 0 && pressure_over_hardness < 1))
        return false;
    double l = gsl_cdf_ugaussian_Qinv(pressure_over_hardness), bell = exp(-l * l / 2);
    double steepness = surface->slope / surface->sigma_m;
    double alleviation = constriction_alleviation(pressure_over_hardness, 1 - pressure_over_hardness);
    *out = (struct cmy_contact){
        .separation_over_sigma = l,
        .spot_density_per_m2 = steepness * steepness * bell * (bell / pressure_over_hardness) / 32,
        .spot_radius_m = sqrt(8 / M_PI) / steepness * 2 * (pressure_over_hardness / bell),
        .conductance = bell / (2 * sqrt(2 * M_PI) * alleviation),
    };
    return true;
}

/** Diagonal of a Vickers indent with the area of a spot. */
static double diagonal_m(const struct cmy *surface, double ratio)
{
    struct cmy_contact contact;
    return cmy_press(&contact, surface, ratio) ? sqrt(2 * M_PI) * contact.spot_radius_m : NAN;
}

double cmy_indent_m(const struct cmy *surface, double ratio)
{
    return diagonal_m(surface, ratio) / 7;
}

double cmy_spot_hardness(const struct cmy *surface, double ratio, double c1_Pa, double c2)
{
    return c1_Pa * pow(diagonal_m(surface, ratio) / 1e-6, c2);
}

double cmy_microhardness(const struct cmy *surface, double pressure_Pa, double c1_Pa, double c2)
{
    /* bisects ln(P/H): ratio H(ratio) rises with the ratio, since H falls more slowly */
    double low = log(1e-300), high = log(0.5);
    if (!(exp(high) * cmy_spot_hardness(surface, exp(high), c1_Pa, c2) > pressure_Pa))
        return NAN;
    for (double middle; middle = low + (high - low) / 2, middle > low && middle < high;)
        *(exp(middle) * cmy_spot_hardness(surface, exp(middle), c1_Pa, c2) < pressure_Pa ? &low : &high) = middle;
    return cmy_spot_hardness(surface, exp(high), c1_Pa, c2);
}
