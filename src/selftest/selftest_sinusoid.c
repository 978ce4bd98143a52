/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One sinusoidal scale of tin, elastic and elastic-plastic. */
#include "contact/sinusoid.h"
#include "material/material.h"
#include "selftest/selftest.h"

#include <string.h>

/* at: amplitude [m], frequency [1/m] and mean pressure [Pa] */
static const struct selftest_reference references[] = {
    {"elastic", "area ratio", {1.0000000000000001e-09, 3000, 633.49364982309328}, 0.0080127056189657868, 1e-10},
    {"elastic", "gap", {1.0000000000000001e-09, 3000, 633.49364982309328}, 9.8817780907114665e-10, 1e-10},
    {"plastic", "area ratio", {1.0000000000000001e-09, 3000, 633.49364982309328}, 0.0080127056189657868, 1e-10},
    {"plastic", "gap", {1.0000000000000001e-09, 3000, 633.49364982309328}, 9.8817780907114665e-10, 1e-10},
    {"elastic", "area ratio", {1.0000000000000001e-09, 3000, 126698.72996461864}, 0.35344360800732499, 1e-10},
    {"elastic", "gap", {1.0000000000000001e-09, 3000, 126698.72996461864}, 2.1034186029808116e-10, 1e-10},
    {"plastic", "area ratio", {1.0000000000000001e-09, 3000, 126698.72996461864}, 0.35344360800732499, 1e-10},
    {"plastic", "gap", {1.0000000000000001e-09, 3000, 126698.72996461864}, 2.1034186029808116e-10, 1e-10},
    {"elastic", "area ratio", {1.0000000000000001e-09, 1000000, 211164.54994103109}, 0.0080127056189657868, 1e-10},
    {"elastic", "gap", {1.0000000000000001e-09, 1000000, 211164.54994103109}, 9.8817780907114665e-10, 1e-10},
    {"plastic", "area ratio", {1.0000000000000001e-09, 1000000, 211164.54994103109}, 0.011111072153224395, 1e-10},
    {"plastic", "gap", {1.0000000000000001e-09, 1000000, 211164.54994103109}, 9.624227141730763e-10, 1e-10},
    {"elastic", "area ratio", {2e-08, 1000000, 84465819.97641243}, 0.065064114317209168, 1e-10},
    {"elastic", "gap", {2e-08, 1000000, 84465819.97641243}, 1.5979865970055094e-08, 1e-10},
    {"plastic", "area ratio", {2e-08, 1000000, 84465819.97641243}, 0.84638702515369324, 1e-10},
    {"plastic", "gap", {2e-08, 1000000, 84465819.97641243}, 1.750316138767207e-09, 1e-10},
    {"elastic", "area ratio", {4.9999999999999998e-07, 50000, 1055822749.7051554}, 0.35344360800732499, 1e-10},
    {"elastic", "gap", {4.9999999999999998e-07, 50000, 1055822749.7051554}, 1.0517093014904058e-07, 1e-10},
    {"plastic", "area ratio", {4.9999999999999998e-07, 50000, 1055822749.7051554}, 1, 1e-10},
    {"elastic", "area ratio", {5.0000000000000004e-06, 3000, 1583734124.5577331}, 0.68155541290536792, 1e-10},
    {"elastic", "gap", {5.0000000000000004e-06, 3000, 1583734124.5577331}, 2.2849620730368388e-07, 1e-10},
    {"plastic", "area ratio", {5.0000000000000004e-06, 3000, 1583734124.5577331}, 1, 1e-10},
};

static enum status_code compute(double *values, const struct selftest_reference *all, size_t count,
                                struct status *status)
{
    struct material_pair pair = material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    (void)status;
    for (size_t i = 0; i < count; i++) {
        const double *at = all[i].at;
        struct sinusoid_scale scale = sinusoid_scale(at[0], at[1], &pair, strcmp(all[i].what, "elastic") != 0);
        struct sinusoid_cell cell;
        sinusoid_press(&cell, &scale, &sinusoid_fits[SINUSOID_FIT_THESIS], at[2], true);
        values[i] = strcmp(all[i].of, "area ratio") == 0 ? cell.area_ratio : cell.gap_ratio * at[0];
    }
    return STATUS_OK;
}

const struct selftest_group selftest_sinusoid = {
    .name = "sinusoid",
    .source = "the equations of the thesis evaluated in 30 digits",
    .references = references,
    .count = sizeof references / sizeof references[0],
    .compute = compute,
};
