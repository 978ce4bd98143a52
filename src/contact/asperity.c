/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/asperity.h"

#include <math.h>

const double asperity_yield_onset = 1.9;
const double asperity_fitted_radius_ratio = 0.41;

/** H_G/S_y = 2.84 - 0.92 (1 - cos(pi a/R)) (4.37), a/R clamped to 1. */
static double hardness_ratio(double radius_ratio)
{
    return 2.84 - 0.92 * (1 - cos(M_PI * fmin(1, radius_ratio)));
}

struct asperity_contact asperity_press(const struct asperity *asperity, double interference_m)
{
    double ratio = interference_m / asperity->critical_interference_m; /* omega* */
    double square = asperity->radius_m * interference_m;
    if (!(ratio >= asperity_yield_onset)) {
        double load_N = 4.0 / 3 * asperity->effective_modulus_Pa * sqrt(square) * interference_m;
        return (struct asperity_contact){M_PI * square, load_N, sqrt(square)};
    }
    double ln_ratio = log(ratio);
    square *= exp(asperity->area_exponent * (ln_ratio - log(asperity_yield_onset))); /* D (4.45) */
    double elastic = exp(-0.25 * exp(5.0 / 12 * ln_ratio)) * ratio * sqrt(ratio);
    double flow = 4 * hardness_ratio(sqrt(square) / asperity->radius_m) / asperity->yield_coefficient;
    double plastic = -flow * expm1(-exp(5.0 / 9 * ln_ratio) / 25) * ratio;
    return (struct asperity_contact){M_PI * square, asperity->critical_load_N * (elastic + plastic), sqrt(square)};
}

struct asperity asperity_make(double radius_m, const struct material_pair *pair, bool plastic)
{
    struct asperity asperity = {
        .radius_m = radius_m,
        .effective_modulus_Pa = pair->effective_modulus_Pa,
        .critical_interference_m = INFINITY,
    };
    if (!plastic)
        return asperity;
    double modulus = pair->effective_modulus_Pa, flow_Pa = pair->yield_coefficient * pair->yield_strength_Pa;
    double contact_slope = M_PI * flow_Pa / (2 * modulus); /* sqrt(omega_c/R) */
    asperity.critical_interference_m = contact_slope * contact_slope * radius_m;
    /* P_c = (4/3)(R/E')²(C pi S_y/2)³ (4.34) */
    asperity.critical_load_N = 4.0 / 3 * radius_m * radius_m * modulus * contact_slope * contact_slope * contact_slope;
    asperity.area_exponent = 0.14 * exp(23 * pair->yield_strength_Pa / modulus);
    asperity.yield_coefficient = pair->yield_coefficient;
    return asperity;
}

double asperity_interference_at(const struct asperity *asperity, double ratio)
{
    if (!isfinite(asperity->critical_interference_m))
        return INFINITY;
    double onset = asperity_yield_onset * asperity->critical_interference_m, b = asperity->area_exponent;
    /* ratio² = (omega/R)(omega/onset)^B */
    double ln_interference = (2 * log(ratio) + log(asperity->radius_m) + b * log(onset)) / (1 + b);
    return fmax(onset, exp(ln_interference));
}
