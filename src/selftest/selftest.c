/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "selftest/selftest.h"

#include <math.h>
#include <stdlib.h>

#define GROUPS(X)                                                                                                      \
    X(softgauges)                                                                                                      \
    X(spectrum)                                                                                                        \
    X(integrals)                                                                                                       \
    X(statistics)                                                                                                      \
    X(sinusoid)                                                                                                        \
    X(models)                                                                                                          \
    X(direct)                                                                                                          \
    X(joint)

#define DECLARE(name) extern const struct selftest_group selftest_##name;
#define ENTRY(name)   &selftest_##name,

GROUPS(DECLARE)

const struct selftest_group *const selftest_groups[] = {GROUPS(ENTRY)};
const size_t selftest_group_count = sizeof selftest_groups / sizeof selftest_groups[0];

double selftest_error(const struct selftest_reference *reference, double value)
{
    double allowed = reference->tolerance * fabs(reference->expected);
    return isfinite(value) ? fabs(value - reference->expected) / allowed : INFINITY;
}

enum status_code selftest_run(struct selftest_result *out, const struct selftest_group *group, struct status *status)
{
    *out = (struct selftest_result){.values = calloc(group->count, sizeof *out->values)};
    if (!out->values)
        return status_memory(status);
    if (group->compute(out->values, group->references, group->count, &out->problem) != STATUS_OK) {
        out->wrong = group->count;
        out->worst = INFINITY;
        return STATUS_OK;
    }
    for (size_t i = 0; i < group->count; i++) {
        double error = selftest_error(&group->references[i], out->values[i]);
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
