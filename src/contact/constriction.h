/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Constriction resistance of contact spots (docs/equations.md, Contact resistance; 4.39-4.52): Holm's spot, the
 * alleviation factor of Cooper, Mikic and Yovanovich, and Prasher and Phelan's scale dependence. All results per
 * nominal area, R A_n. */
#ifndef CONTACT_CONSTRICTION_H
#define CONTACT_CONSTRICTION_H

#include "material/material.h"

/** The two bodies together. Unknown properties are NaN. */
struct constriction {
    double resistivity_ohm_m;     /* rho, mean of both sides */
    double conductivity_W_per_mK; /* k, harmonic mean of both sides */
    double knudsen_length_m;      /* (8/3pi) lambda_mfp, of both sides together */
};

/** Half the resistance is on each side, each with its own mean free path: lambda = (k/2)(lambda_1/k_1 + lambda_2/k_2).
 */
struct constriction constriction_make(const struct material_pair *pair);

/** Psi = (1 - sqrt(area_ratio))^(3/2) (4.41; of all asperities together 4.44). */
double constriction_alleviation(double area_ratio, double area_complement);

/** Sums over scales: sum Psi_i/(a_i n_i) [m] and sum Psi_i/(a_i² n_i) [1], n_i spots per nominal area. */
struct constriction_sum {
    double by_radius;
    double by_radius_squared;
};

/** Adds one scale in series (4.42): a_i = sqrt(A_i/(2 pi A_{i-1} f²)) (4.40), n_i = 2 f² A_{i-1}. `area_ratio` is
 * A_i/A_{i-1}, `area_complement` 1 - A_i/A_{i-1} without cancellation, `area_above` A_{i-1}/A_n. */
void constriction_add_scale(struct constriction_sum *sum, double area_ratio, double area_complement,
                            double frequency_per_m, double area_above);

/** ECR A_n = sum Psi_i rho/(2 a_i)/n_i [ohm m²] (4.39, 4.42*). */
double constriction_electrical(const struct constriction *spot, const struct constriction_sum *sum);
/** TCR A_n = sum Psi_i/(2 k a_i)/n_i [K m²/W] (4.47, 4.48*). */
double constriction_thermal(const struct constriction *spot, const struct constriction_sum *sum);
/** Each term times 1 + (8/3pi) lambda_mfp/a_i (4.51). */
double constriction_thermal_scale_dependent(const struct constriction *spot, const struct constriction_sum *sum);

#endif
