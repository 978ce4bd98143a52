/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "joint/gas.h"

#include "base/constants.h"
#include "base/integral.h"

#include <math.h>

const double gas_table_temperature_K = 300, gas_table_pressure_Pa = 101325;

#define INCROPERA "Incropera and DeWitt, Fundamentals of Heat and Mass Transfer, tables A.4 to A.6"
#define HANDBOOK  "handbook values; they meet Eucken's relation k = mu c_v (9 gamma - 5)/4 within 1 %"
#define CRC       "CRC Handbook of Chemistry and Physics, thermal conductivity and viscosity of gases"
#define OVER      "; over temperature: CRC Handbook"
#define SONG      "; accommodation: Song and Yovanovich 1987, 25 %"
const struct gas gas_table[] = {
    {"air", 0.0263, 0.849, -0.079, 100, 600, 18.46e-6, 1007, 0.028965, 1.4, 0.87, INCROPERA OVER},
    {"nitrogen", 0.0259, 0.805, -0.07, 100, 600, 17.82e-6, 1041, 0.028013, 1.4, 0.87, INCROPERA OVER},
    {"helium", 0.1567, 0.678, 0.013, 100, 600, 19.93e-6, 5193, 0.0040026, 1.6667, 0.36, HANDBOOK OVER SONG},
    {"argon", 0.0177, 0.855, -0.09, 100, 600, 22.72e-6, 520.3, 0.039948, 1.6667, 0.87, HANDBOOK OVER},
    {"hydrogen", 0.1869, 0.799, -0.104, 100, 600, 8.9e-6, 14310, 0.002016, 1.405, 0.28, CRC SONG},
    {"carbon dioxide", 0.0168, 1.367, -0.066, 200, 600, 15e-6, 846, 0.04401, 1.288, 0.88, CRC SONG},
    {"SF6", 0.013, 1.688, -0.438, 225, 600, 15.3e-6, 665, 0.146056, 1.094, 0.94,
     CRC "; below 300 K Assael and others 2012; c_p: NIST SRD 134" SONG},
    {"neon", 0.0498, 0.686, -0.041, 100, 600, 31.9e-6, 1030, 0.02018, 1.6667, 0.73, CRC SONG},
    {"krypton", 0.0095, 0.899, -0.061, 121, 600, 25.5e-6, 248, 0.083798, 1.6667, 0.91, CRC SONG},
};
const size_t gas_count = sizeof gas_table / sizeof gas_table[0];
const struct gas gas_liquids[] = {
    {"water", 0.6103, 0.809, -1.454, 273.15, 373.15, .source = "Perry's Chemical Engineers' Handbook, table 2-135"},
    {"oil", 0.145, -0.228, -0.137, 273.15, 430, .source = INCROPERA ", unused engine oil; mineral oils vary by 10 %"},
    {"glycerin", 0.289, 0.1, 0, 291.3, 413, .source = INCROPERA " and VDI Heat Atlas, 1.5 % from either"},
};
const size_t gas_liquid_count = sizeof gas_liquids / sizeof gas_liquids[0];

double gas_conductivity(const struct gas *gas, double temperature_K)
{
    double x = log(temperature_K / gas_table_temperature_K);
    return gas->conductivity_W_per_mK * exp(gas->exponent * x + gas->bend * x * x);
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

/** Integrand over t - Y. */
static double over_deviation(double deviation, void *context)
{
    const struct gap *gap = context;
    return exp(-deviation * deviation / 2) / (gap->mean + deviation + gap->jump);
}

/** Integrand over ln(t + M), in which the pole at t = -M, however near, does no harm. */
static double over_logarithm(double w, void *context)
{
    const struct gap *gap = context;
    double deviation = exp(w) - gap->jump - gap->mean;
    return exp(-deviation * deviation / 2);
}

double gas_gap_integral(double separation_over_sigma, double jump_over_sigma, double tolerance)
{
    struct gap gap = {separation_over_sigma, jump_over_sigma};
    double reach = sqrt(2 * (8 - log(fmax(tolerance, 1e-15)))); /* beyond it exp(-t²/2) is negligible */
    double lowest = fmax(0, gap.mean - reach) + gap.jump, base = gap.mean + gap.jump;
    double whole = lowest > 1 ? integral(over_deviation, &gap, -fmin(gap.mean, reach), reach, tolerance)
                              : integral(over_logarithm, &gap, log(lowest), log(base + reach), tolerance);
    return whole / sqrt(2 * M_PI);
}

double gas_conductance(double conductivity_W_per_mK, double sigma_m, double separation_m, double jump_length_m,
                       double area_ratio, double tolerance)
{
    double gap_m = fmax(separation_m, 0), open = fmax(1 - area_ratio, 0);
    if (!(sigma_m > 0))
        return open * conductivity_W_per_mK / (gap_m + jump_length_m);
    double whole = gas_gap_integral(gap_m / sigma_m, jump_length_m / sigma_m, tolerance);
    return open * conductivity_W_per_mK / sigma_m * whole;
}
