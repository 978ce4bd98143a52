/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers that one call gives: integrals, intervals, one sinusoidal scale, what lies in and around the spots. */
#include "contact/gaussian.h"
#include "contact/sinusoid.h"
#include "joint/heating.h"
#include "joint/joint.h"
#include "joint/plating.h"
#include "selftest/selftest.h"
#include "statistics/interval.h"

#include <math.h>
#include <string.h>

typedef struct selftest_reference reference;

static double gaussian_integral(const reference *r)
{
    struct gaussian_integrals f = gaussian_integrals(r->at[0]);
    double plain = strcmp(r->quantity, "F_1/2") == 0 ? f.half
                   : strcmp(r->quantity, "F_1") == 0 ? f.one
                                                     : f.three_halves;
    return plain * exp(f.log_factor);
}

/** One sinusoidal scale of tin, elastic or elastic-plastic. */
static double sinusoid(const reference *r)
{
    struct material_pair pair = material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    struct sinusoid_scale scale = sinusoid_scale(r->at[0], r->at[1], &pair, strcmp(r->of, "elastic") != 0);
    struct sinusoid_cell cell;
    sinusoid_press(&cell, &scale, &sinusoid_fits[SINUSOID_FIT_THESIS], r->at[2], true);
    return strcmp(r->quantity, "area ratio") == 0 ? cell.area_ratio : cell.gap_ratio * r->at[0];
}

/** The interval of five scans. */
static enum status_code interval_of_scans(double *value, const reference *r, const double *scans, struct status *status)
{
    struct interval interval;
    if (interval_scans(&interval, scans, NULL, SELFTEST_SCANS, 0.95, status) != STATUS_OK)
        return status->code;
    *value = strcmp(r->quantity, "mean") == 0  ? interval.mean
             : strcmp(r->quantity, "low") == 0 ? interval.low
                                               : interval.high;
    return STATUS_OK;
}

static bool is(const reference *r, const char *of, const char *quantity)
{
    return strcmp(r->of, of) == 0 && strcmp(r->quantity, quantity) == 0;
}

enum status_code selftest_plain(double *value, const reference *r, const struct selftest_table *table,
                                struct status *status)
{
    const double *at = r->at;
    const struct gas *gas = gas_find(r->of);
    if (strcmp(r->of, "F_n") == 0)
        *value = gaussian_integral(r);
    else if (strcmp(r->of, "elastic") == 0 || strcmp(r->of, "plastic") == 0)
        *value = sinusoid(r);
    else if (strcmp(r->of, "five scans") == 0)
        return interval_of_scans(value, r, table->scans, status);
    else if (is(r, "Student", "t"))
        *value = interval_quantile(at[1], at[0]);
    else if (is(r, "gap", "integral"))
        *value = gas_gap_integral(at[0], at[1], 1e-12);
    else if (is(r, "plating", "factor"))
        *value = plating_factor(at[0], at[1], 1);
    else if (is(r, "heating", "rise"))
        *value = heating_rise(at[0], at[1]);
    else if (is(r, "heating", "melting voltage of tin"))
        *value = heating_voltage(at[0], at[1]);
    else if (is(r, "film", "resistance"))
        *value = joint_film(at[0], at[1], at[2]);
    else if (gas && strcmp(r->quantity, "jump length") == 0)
        *value = gas_jump_length(gas, 300, 101325, 0.87, 0.87);
    else
        return STATUS_OK;
    return STATUS_OK;
}
