/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "statistics/single_scan.h"

#include <assert.h>
#include <math.h>

static const double unknown_quarters = 0.5;

/** Standard deviation of those that are finite; NaN: fewer than `least`. */
static double deviation(const double *value, size_t count, size_t least)
{
    double mean = 0, square = 0, finite = 0;
    for (size_t i = 0; i < count; i++) {
        if (!isfinite(value[i]))
            continue;
        double step = value[i] - mean;
        mean += step / ++finite;
        square += step * (value[i] - mean);
    }
    return finite >= (double)least ? sqrt(square / (finite - 1)) : NAN;
}

double single_scan_s(const double *record, size_t records, const double *quarter, size_t quarters)
{
    double own = deviation(quarter, quarters, SINGLE_SCAN_QUARTERS - 1);
    assert(records >= 4);
    return hypot(deviation(record, records, records / 2), M_SQRT1_2 * (isnan(own) ? unknown_quarters : own));
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
