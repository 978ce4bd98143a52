/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "selftest/selftest_compute.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static selftest_compute *find_compute(const char *group)
{
    static const struct {
        const char *group;
        selftest_compute *compute;
    } computes[] = {{"softgauges", selftest_softgauge},
                    {"spectrum", selftest_spectrum},
                    {"models", selftest_model},
                    {"direct", selftest_direct}};
    for (size_t i = 0; i < sizeof computes / sizeof computes[0]; i++)
        if (strcmp(computes[i].group, group) == 0)
            return computes[i].compute;
    return selftest_plain;
}

double selftest_error(const struct selftest_reference *reference, double value)
{
    double allowed = reference->tolerance * fabs(reference->expected);
    return isfinite(value) ? fabs(value - reference->expected) / allowed : INFINITY;
}

enum status_code selftest_run(struct selftest_result *out, const struct selftest_table *table,
                              const struct selftest_group *group, struct status *status)
{
    *out = (struct selftest_result){.values = calloc(group->count, sizeof *out->values)};
    if (!out->values)
        return status_memory(status);
    for (size_t i = 0; i < group->count; i++) {
        const struct selftest_reference *reference = &group->references[i];
        out->values[i] = NAN;
        if (find_compute(reference->group)(&out->values[i], reference, table, &out->problem) != STATUS_OK) {
            if (out->problem.code == STATUS_IO)
                return status_fail(status, STATUS_IO, "%s", out->problem.message);
            out->wrong = group->count;
            out->worst = INFINITY;
            return STATUS_OK;
        }
        double error = selftest_error(reference, out->values[i]);
        out->wrong += !(error <= 1);
        if (error > out->worst) {
            out->worst = error;
            out->worst_place = i;
        }
    }
    return STATUS_OK;
}

void selftest_result_free(struct selftest_result *result)
{
    free(result->values);
    *result = (struct selftest_result){0};
}
