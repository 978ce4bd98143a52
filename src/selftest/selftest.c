/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "selftest/selftest.h"

#include <math.h>
#include <string.h>

enum status_code selftest_value(double *value, const struct selftest_reference *reference,
                                const struct selftest_table *table, struct status *status)
{
    static const struct {
        const char *group;
        selftest_compute *compute;
    } computes[] = {{"softgauges", selftest_softgauge},
                    {"spectrum", selftest_spectrum},
                    {"models", selftest_model},
                    {"direct", selftest_direct}};
    *value = NAN;
    for (size_t i = 0; i < sizeof computes / sizeof computes[0]; i++)
        if (strcmp(computes[i].group, reference->group) == 0)
            return computes[i].compute(value, reference, table, status);
    return selftest_plain(value, reference, table, status);
}

double selftest_error(const struct selftest_reference *reference, double value)
{
    double allowed = reference->tolerance * fabs(reference->expected);
    return isfinite(value) ? fabs(value - reference->expected) / allowed : INFINITY;
}
