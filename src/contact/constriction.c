/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/constriction.h"

#include <math.h>

static const double knudsen_factor = 8 / (3 * M_PI); /* Prasher and Phelan 2006, thesis (4.51) */

struct constriction constriction_make(const struct material_pair *pair)
{
    const double *length = pair->mean_free_path_m, *conductivity = pair->side_conductivity_W_per_mK;
    double mean_free_path_m =
        pair->conductivity_W_per_mK / 2 * (length[0] / conductivity[0] + length[1] / conductivity[1]);
    return (struct constriction){
        .resistivity_ohm_m = pair->resistivity_ohm_m,
        .conductivity_W_per_mK = pair->conductivity_W_per_mK,
        .knudsen_length_m = knudsen_factor * mean_free_path_m,
    };
}

double constriction_alleviation(double area_ratio, double area_complement)
{
    double open = area_complement / (1 + sqrt(area_ratio)); /* 1 - sqrt(A/A_n) without cancellation */
    return open * sqrt(open);
}

void constriction_add_scale(struct constriction_sum *sum, double area_ratio, double area_complement,
                            double frequency_per_m, double area_above)
{
    static const double sqrt_2pi = 2.5066282746310005; /* a_i = sqrt(A_i/A_{i-1})/(sqrt(2 pi) f) (4.40) */
    double per_radius = sqrt_2pi * frequency_per_m / sqrt(area_ratio); /* 1/a_i */
    double spots = 2 * frequency_per_m * frequency_per_m * area_above;
    double term = constriction_alleviation(area_ratio, area_complement) * per_radius / spots;
    sum->by_radius += term;
    sum->by_radius_squared += term * per_radius;
}

double constriction_electrical(const struct constriction *spot, const struct constriction_sum *sum)
{
    return spot->resistivity_ohm_m / 2 * sum->by_radius;
}

double constriction_thermal(const struct constriction *spot, const struct constriction_sum *sum)
{
    return sum->by_radius / (2 * spot->conductivity_W_per_mK);
}

double constriction_thermal_scale_dependent(const struct constriction *spot, const struct constriction_sum *sum)
{
    return (sum->by_radius + spot->knudsen_length_m * sum->by_radius_squared) / (2 * spot->conductivity_W_per_mK);
}
