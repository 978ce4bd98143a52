/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What lies in and around the spots: gas, films, platings, heat, electrons. */
#include "joint/electron.h"
#include "joint/gas.h"
#include "joint/heating.h"
#include "joint/joint.h"
#include "joint/plating.h"
#include "selftest/selftest.h"

#include <string.h>

/* gas: jump length at 300 K, 1 atm, accommodation 0.87; gap: integral at Y/sigma and M/sigma; plating: factor at t/a
 * and rho/rho; spot: 2 ohm of rho, path and radius; film: rho/(2a), s and A/A_n */
static const struct selftest_reference references[] = {
    {"air", "jump length", {0}, 2.87307215876860078714939238674e-7, 1e-12},
    {"helium", "jump length", {0}, 9.56760156193814169442175632648e-7, 1e-12},
    {"argon", "jump length", {0}, 3.41425082128731867640748497348e-7, 1e-12},
    {"gap", "integral", {1, 0.01}, 1.62450089450311099138485868794, 1e-10},
    {"gap", "integral", {1, 1}, 0.416098518686355975754594048760, 1e-10},
    {"gap", "integral", {2, 0.3}, 0.524708542678852754204952666348, 1e-10},
    {"plating", "factor", {0.01, 0.15}, 6.11899764622511257931698886488, 1e-10},
    {"plating", "factor", {0.03, 5}, 0.248275427212798267491049277448, 1e-10},
    {"heating", "rise", {0.05, 298.15}, 338.344017980162220879876697158 - 298.15, 1e-10},
    {"heating", "rise", {0.1, 298.15}, 437.294443723952825661535187433 - 298.15, 1e-10},
    {"heating", "melting voltage of tin", {505.078, 298.15}, 0.127444524039361606825787258074, 1e-12},
    {"spot", "resistance", {1.678e-8, 3.99e-8, 1e-9}, 289.448164350299836193068599527, 1e-12},
    {"spot", "resistance", {1.678e-8, 3.99e-8, 3e-8}, 0.528226425983746613720168707887, 1e-12},
    {"film", "resistance", {2e-9, 1e-12, 1e-3}, 3e-9, 1e-13},
};

static double value_of(const struct selftest_reference *r)
{
    const double *at = r->at;
    if (strcmp(r->what, "gap") == 0)
        return gas_gap_integral(at[0], at[1], 1e-12);
    if (strcmp(r->what, "plating") == 0)
        return plating_factor(at[0], at[1], 1);
    if (strcmp(r->what, "heating") == 0)
        return strcmp(r->of, "rise") == 0 ? heating_rise(at[0], at[1]) : heating_voltage(at[0], at[1]);
    if (strcmp(r->what, "spot") == 0)
        return electron_spot_resistance(at[0], at[1], at[2]);
    if (strcmp(r->what, "film") == 0)
        return joint_film(at[0], at[1], at[2]);
    return gas_jump_length(gas_find(r->what), 300, 101325, 0.87, 0.87);
}

static enum status_code compute(double *values, const struct selftest_reference *all, size_t count,
                                struct status *status)
{
    (void)status;
    for (size_t i = 0; i < count; i++)
        values[i] = value_of(&all[i]);
    return STATUS_OK;
}

const struct selftest_group selftest_joint = {
    .name = "joint",
    .source = "the same equations (Yovanovich, Holm, Wexler) evaluated in 30 digits",
    .references = references,
    .count = sizeof references / sizeof references[0],
    .compute = compute,
};
