/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "joint/gas.h"

#include "base/constants.h"
#include "base/integral.h"

#include <math.h>
#include <strings.h>

const double gas_table_temperature_K = 300, gas_table_pressure_Pa = 101325;
const double gas_accommodation = 0.87;

#define INCROPERA "Incropera and DeWitt, Fundamentals of Heat and Mass Transfer, table A.4"
#define HANDBOOK  "handbook values; they meet Eucken's relation k = mu c_v (9 gamma - 5)/4 within 1 %"
const struct gas gas_table[] = {
    {"air", 0.0263, 18.46e-6, 1007, 0.028965, 1.4, INCROPERA},
    {"nitrogen", 0.0259, 17.82e-6, 1041, 0.028013, 1.4, INCROPERA},
    {"helium", 0.1567, 19.93e-6, 5193, 0.0040026, 1.6667, HANDBOOK},
    {"argon", 0.0177, 22.72e-6, 520.3, 0.039948, 1.6667, HANDBOOK},
};
const size_t gas_count = sizeof gas_table / sizeof gas_table[0];

const struct gas *gas_find(const char *name)
{
    for (size_t i = 0; i < gas_count; i++)
        if (strcasecmp(gas_table[i].name, name) == 0)
            return &gas_table[i];
    return NULL;
}

double gas_prandtl(const struct gas *gas)
{
    return gas->viscosity_Pa_s * gas->specific_heat_J_per_kgK / gas->conductivity_W_per_mK;
}

double gas_mean_free_path(const struct gas *gas, double temperature_K, double pressure_Pa)
{
    double molecule_kg = gas->molar_mass_kg / constant_avogadro_per_mol;
    double at_table = gas->viscosity_Pa_s / gas_table_pressure_Pa *
                      sqrt(M_PI * constant_boltzmann_J_per_K * gas_table_temperature_K / (2 * molecule_kg));
    return at_table * (temperature_K / gas_table_temperature_K) * (gas_table_pressure_Pa / pressure_Pa);
}

double gas_jump_length(const struct gas *gas, double temperature_K, double pressure_Pa, double accommodation_1,
                       double accommodation_2)
{
    double alpha = (2 - accommodation_1) / accommodation_1 + (2 - accommodation_2) / accommodation_2;
    double beta = 2 * gas->heat_ratio / (gas_prandtl(gas) * (gas->heat_ratio + 1));
    return alpha * beta * gas_mean_free_path(gas, temperature_K, pressure_Pa);
}

/** Y/sigma and M/sigma. */
struct gap {
    double mean, jump;
};

/** Over t - Y. */
static double over_deviation(double deviation, void *context)
{
    const struct gap *gap = context;
    return exp(-deviation * deviation / 2) / (gap->mean + deviation + gap->jump);
}

/** Over ln(t + M): the pole at t = -M, however near, does no harm. */
static double over_logarithm(double w, void *context)
{
    const struct gap *gap = context;
    double deviation = exp(w) - gap->jump - gap->mean;
    return exp(-deviation * deviation / 2);
}

double gas_gap_integral(double separation_over_sigma, double jump_over_sigma, double tolerance)
{
    struct gap gap = {separation_over_sigma, jump_over_sigma};
    double reach = sqrt(2 * (8 - log(fmax(tolerance, 1e-15)))); /* beyond, exp(-t²/2) counts no more */
    double lowest = fmax(0, gap.mean - reach) + gap.jump, base = gap.mean + gap.jump;
    double whole = lowest > 1 ? integral(over_deviation, &gap, -fmin(gap.mean, reach), reach, tolerance)
                              : integral(over_logarithm, &gap, log(lowest), log(base + reach), tolerance);
    return whole / sqrt(2 * M_PI);
}

double gas_conductance(const struct gas *gas, double sigma_m, double separation_m, double jump_length_m,
                       double area_ratio, double tolerance)
{
    double gap_m = fmax(separation_m, 0), open = fmax(1 - area_ratio, 0);
    if (isinf(jump_length_m))
        return 0;
    if (!(sigma_m > 0))
        return open * gas->conductivity_W_per_mK / (gap_m + jump_length_m);
    double whole = gas_gap_integral(gap_m / sigma_m, jump_length_m / sigma_m, tolerance);
    return open * gas->conductivity_W_per_mK / sigma_m * whole;
}
