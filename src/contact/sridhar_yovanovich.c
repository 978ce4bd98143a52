/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/sridhar_yovanovich.h"

#include <math.h>

double sridhar_yovanovich_strain(double effective_modulus_Pa, double flow_stress_Pa, double slope)
{
    return 1.67 * (effective_modulus_Pa / flow_stress_Pa) * slope;
}

struct truncation sridhar_yovanovich(double sigma_m, double slope, double effective_modulus_Pa, double flow_stress_Pa)
{
    double strain = sridhar_yovanovich_strain(effective_modulus_Pa, flow_stress_Pa, slope);
    double softening = hypot(1, 6.5 / strain);
    return (struct truncation){
        .sigma_m = sigma_m,
        .slope = slope,
        .hardness_Pa = 2.76 * flow_stress_Pa / softening,
        .fraction = softening / pow(1 + pow(13 / strain, 1.2), 1 / 1.2),
    };
}

double sridhar_yovanovich_correlation(double pressure_over_hardness, double strain)
{
    if (strain <= 5)
        return 1.54 * pow(pressure_over_hardness, 0.94);
    double b1 = pow(1 + 46690 / pow(strain, 2.49), 1.0 / 30), b2 = pow(1 + 2086.9 / pow(strain, 1.842), -1.0 / 600);
    return 1.245 * b1 * pow(pressure_over_hardness, 0.95 * b2);
}
