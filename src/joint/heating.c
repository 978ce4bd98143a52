/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "joint/heating.h"

#include "base/constants.h"

#include <math.h>
#include <strings.h>

const struct heating_metal heating_metals[] = {
    {"tin", 0.07, 505.078},    {"gold", 0.08, 1337.33},  {"silver", 0.09, 1234.93},
    {"copper", 0.12, 1357.77}, {"nickel", 0.22, 1728.3}, {"aluminium", NAN, 933.473},
};
const size_t heating_metal_count = sizeof heating_metals / sizeof heating_metals[0];

const struct heating_metal *heating_metal_find(const char *name)
{
    for (size_t i = 0; i < heating_metal_count; i++)
        if (strcasecmp(heating_metals[i].name, name) == 0)
            return &heating_metals[i];
    return NULL;
}

double heating_lorenz_number(void)
{
    double volt_per_kelvin = M_PI * constant_boltzmann_J_per_K / constant_electron_charge_C;
    return volt_per_kelvin * volt_per_kelvin / 3;
}

double heating_rise(double voltage_V, double body_temperature_K)
{
    double hottest = voltage_V / (2 * sqrt(heating_lorenz_number())); /* of a contact between bodies at 0 K */
    return hottest * (hottest / (body_temperature_K + hypot(body_temperature_K, hottest)));
}

double heating_voltage(double temperature_K, double body_temperature_K)
{
    double rise = temperature_K - body_temperature_K, sum = temperature_K + body_temperature_K;
    return 2 * sqrt(heating_lorenz_number() * rise * sum);
}
