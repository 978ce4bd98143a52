/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How hot a contact gets under current (equations: heating). Kohlrausch 1900; Holm 1967, Electric Contacts, 4th
 * edition. */
#ifndef JOINT_HEATING_H
#define JOINT_HEATING_H

#include <stddef.h>

/** L = pi² k_B²/(3 e²) = 2.4430e-8 V²/K² (Wiedemann, Franz and Lorenz). */
double heating_lorenz_number(void);

/** T_max - T_0 [K] of a contact of any shape with a voltage V between bodies at T_0: T_max² = T_0² + V²/(4L). */
double heating_rise(double voltage_V, double body_temperature_K);

/** The voltage at which T_max is `temperature_K` >= body_temperature_K. */
double heating_voltage(double temperature_K, double body_temperature_K);

/** Limits of a metal. */
struct heating_metal {
    const char *name;           /* as in the material table */
    double softening_voltage_V; /* measured (Holm's table); NaN: not in it */
    double melting_K;           /* fixed points of the ITS-90 (Sn, Al, Ag, Au, Cu); nickel: handbook */
};
#define HEATING_SOLID_MOST_K 3695.0 /* tungsten: no metal melts higher (CRC handbook) */
extern const struct heating_metal heating_metals[];
extern const size_t heating_metal_count;

/** The row of that name (case-insensitive), NULL when there is none. */
const struct heating_metal *heating_metal_find(const char *name);

#endif
