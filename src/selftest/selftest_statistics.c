/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Student's quantiles, which every interval of the report stands on, and the interval of five scans. */
#include "selftest/selftest.h"
#include "statistics/interval.h"

#include <string.h>

/* As tables print them, to three decimals (NIST/SEMATECH e-Handbook of Statistical Methods, 1.3.6.7.2). */
static const struct selftest_reference references[] = {
    {"Student", "t", {1, 0.95}, 12.706, 0.00050001 / 12.706}, {"Student", "t", {2, 0.95}, 4.303, 0.00050001 / 4.303},
    {"Student", "t", {5, 0.95}, 2.571, 0.00050001 / 2.571},   {"Student", "t", {10, 0.95}, 2.228, 0.00050001 / 2.228},
    {"Student", "t", {30, 0.95}, 2.042, 0.00050001 / 2.042},  {"Student", "t", {4, 0.99}, 4.604, 0.00050001 / 4.604},
    {"five scans", "mean", {0}, -20.69279358925738, 1e-13},   {"five scans", "low", {0}, -20.77184684511254, 1e-12},
    {"five scans", "high", {0}, -20.61374033340222, 1e-12},
};

static enum status_code compute(double *values, const struct selftest_reference *all, size_t count,
                                struct status *status)
{
    static const double scans[] = {-20.77558717944168, -20.658707937015897, -20.637709158123215, -20.645272818277334,
                                   -20.74669085342877};
    struct interval interval;
    if (interval_scans(&interval, scans, NULL, 5, 0.95, status) != STATUS_OK)
        return status->code;
    for (size_t i = 0; i < count; i++)
        values[i] = strcmp(all[i].of, "t") == 0      ? interval_quantile(all[i].at[1], all[i].at[0])
                    : strcmp(all[i].of, "mean") == 0 ? interval.mean
                    : strcmp(all[i].of, "low") == 0  ? interval.low
                                                     : interval.high;
    return STATUS_OK;
}

const struct selftest_group selftest_statistics = {
    .name = "statistics",
    .source = "printed tables of Student's t; a plain loop over the definitions",
    .references = references,
    .count = sizeof references / sizeof references[0],
    .compute = compute,
};
