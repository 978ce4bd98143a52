/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Heat through the gas in the gaps of a joint (equations: gas in the gaps). Yovanovich, DeVaal and Hegazy 1982, AIAA
 * 82-0888 (integral over the gaps); Kennard 1938, Kinetic Theory of Gases (temperature jump, accommodation). */
#ifndef JOINT_GAS_H
#define JOINT_GAS_H

#include <stddef.h>

/** A gas at 300 K and 101325 Pa, or a liquid at 300 K, of which only the conductivity is known. */
struct gas {
    const char *name; /* scene spelling */
    double conductivity_W_per_mK;
    double exponent, bend;  /* k = k_300 exp(exponent x + bend x²), x = ln(T/300 K), */
    double least_K, most_K; /* between these: range of the data, a gas above its boiling point, a liquid below it */
    double viscosity_Pa_s;
    double specific_heat_J_per_kgK; /* c_p */
    double molar_mass_kg;           /* of a mole */
    double heat_ratio;              /* gamma = c_p/c_v */
    double accommodation;           /* on engineering metals, about 300 K */
    const char *source;
};

extern const struct gas gas_table[], gas_liquids[];
extern const size_t gas_count, gas_liquid_count;
extern const double gas_table_temperature_K, gas_table_pressure_Pa;

/** k [W/m/K] between least_K and most_K. */
double gas_conductivity(const struct gas *gas, double temperature_K);
/** Pr = mu c_p/k. */
double gas_prandtl(const struct gas *gas);

/** Mean free path L = (mu/p) sqrt(pi k_B T/(2m)) [m] at the table's state, elsewhere L (T/T_0)(p_0/p). */
double gas_mean_free_path(const struct gas *gas, double temperature_K, double pressure_Pa);

/** M = alpha beta L [m], by which a gap conducts as if it were wider: alpha = (2-a_1)/a_1 + (2-a_2)/a_2 with the
 * accommodation coefficients of both sides, beta = 2 gamma/(Pr (gamma+1)). Infinite in vacuum. */
double gas_jump_length(const struct gas *gas, double temperature_K, double pressure_Pa, double accommodation_1,
                       double accommodation_2);

/** h_g sigma/k_g = (1/sqrt(2 pi)) int_0^inf exp(-(Y/sigma - t)²/2)/(t + M/sigma) dt: Gaussian heights, a gap t sigma
 * conducting k_g/(t sigma + M). M > 0; relative `tolerance`. */
double gas_gap_integral(double separation_over_sigma, double jump_over_sigma, double tolerance);

/** h_g [W/m²/K] of a gas at mean separation Y (below 0: taken as 0): k_g/sigma times the integral, times the share 1 -
 * A/A_n of the area that does not touch. Without roughness (sigma = 0) k_g/(Y + M); in vacuum 0. */
double gas_conductance(double conductivity_W_per_mK, double sigma_m, double separation_m, double jump_length_m,
                       double area_ratio, double tolerance);

#endif
