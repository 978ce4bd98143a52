/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/cmy.h"

#include <math.h>

struct truncation cmy_plastic(double sigma_m, double slope, double hardness_Pa)
{
    return (struct truncation){sigma_m, slope, hardness_Pa, 1};
}

struct truncation cmy_elastic(double sigma_m, double slope, double effective_modulus_Pa)
{
    return (struct truncation){sigma_m, slope, effective_modulus_Pa * slope / M_SQRT2, 0.5};
}

double cmy_plastic_correlation(double pressure_over_hardness)
{
    return 1.25 * pow(pressure_over_hardness, 0.95);
}

double cmy_elastic_correlation(double pressure_over_hardness)
{
    return 1.55 * pow(pressure_over_hardness, 0.94);
}

/** H(a) of the spots at P/H = ratio. */
static double spot_hardness(const struct truncation *law, double ratio, double c1_Pa, double c2)
{
    struct truncation_contact contact;
    if (!truncation_press(&contact, law, ratio))
        return NAN;
    return c1_Pa * pow(sqrt(2 * M_PI) * contact.spot_radius_m / 1e-6, c2);
}

double cmy_microhardness(double sigma_m, double slope, double pressure_Pa, double c1_Pa, double c2)
{
    const struct truncation law = cmy_plastic(sigma_m, slope, 0);
    /* ratio = P/H(ratio) by bisection of its logarithm: ratio H(ratio) rises with the ratio, H falling more slowly */
    double low = log(1e-300), high = log(0.5);
    if (!(exp(high) * spot_hardness(&law, exp(high), c1_Pa, c2) > pressure_Pa))
        return NAN;
    for (int i = 0; i < 200; i++) {
        double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high)
            break;
        if (exp(middle) * spot_hardness(&law, exp(middle), c1_Pa, c2) < pressure_Pa)
            low = middle;
        else
            high = middle;
    }
    return spot_hardness(&law, exp(high), c1_Pa, c2);
}
