/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "statistics/single_scan.h"

#include <assert.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>

static const double errors_95 = 2.3;
static const double quarters_95 = 3.18; /* Student's t, 3 degrees of freedom */

static enum status_code check(const double *value, size_t count, const char *what, struct status *status)
{
    for (size_t i = 0; i < count; i++)
        if (!isfinite(value[i]))
            return status_fail(status, STATUS_SCAN, "the answer of %s %zu of %zu is not a finite number", what, i + 1,
                               count);
    return STATUS_OK;
}

enum status_code single_scan_uncertainty(struct single_scan *out, const double *simulated, size_t records,
                                         const double quarter[SINGLE_SCAN_QUARTERS], const double *simulated_quarter,
                                         struct status *status)
{
    assert(records >= 2);
    if (check(simulated, records, "simulated record", status) != STATUS_OK)
        return status->code;
    *out = (struct single_scan){.s = gsl_stats_sd(simulated, 1, records)};
    out->half_width = single_scan_half_width(out->s);
    if (!quarter)
        return STATUS_OK;
    if (check(quarter, SINGLE_SCAN_QUARTERS, "quarter", status) != STATUS_OK ||
        check(simulated_quarter, records * SINGLE_SCAN_QUARTERS, "simulated quarter", status) != STATUS_OK)
        return status->code;
    out->quarters_sd = gsl_stats_sd(quarter, 1, SINGLE_SCAN_QUARTERS);
    for (size_t b = 0; b < records; b++)
        out->simulated_sd = fmax(out->simulated_sd,
                                 gsl_stats_sd(simulated_quarter + b * SINGLE_SCAN_QUARTERS, 1, SINGLE_SCAN_QUARTERS));
    out->heterogeneous = out->quarters_sd > out->simulated_sd;
    if (out->heterogeneous)
        out->half_width = fmax(out->half_width, quarters_95 * out->quarters_sd);
    return STATUS_OK;
}

double single_scan_half_width(double s)
{
    return errors_95 * s;
}

double single_scan_s_at(double ln_load, const double *node_ln_load, const double *node_s, size_t nodes)
{
    assert(nodes > 0);
    if (ln_load <= node_ln_load[0])
        return node_s[0];
    for (size_t i = 1; i < nodes; i++)
        if (ln_load <= node_ln_load[i]) {
            double share = (ln_load - node_ln_load[i - 1]) / (node_ln_load[i] - node_ln_load[i - 1]);
            return node_s[i - 1] + share * (node_s[i] - node_s[i - 1]);
        }
    return node_s[nodes - 1];
}
