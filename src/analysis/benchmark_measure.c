/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/benchmark.h"

#include "base/clock.h"

enum status_code benchmark_measure(struct benchmark *out, const struct benchmark_task *task, struct status *status)
{
    double started = clock_seconds();
    *out = (struct benchmark){0};
    enum status_code rc = benchmark_direct(out, task, status);
    if (rc == STATUS_OK)
        rc = benchmark_integrals(out, task, status);
    if (rc == STATUS_OK)
        rc = benchmark_curves(out, task, status);
    out->seconds = clock_seconds() - started;
    return rc;
}
