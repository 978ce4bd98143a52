/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/rank.h"

#include <stdlib.h>

static int by_value(const void *left, const void *right, void *values)
{
    const double *value = values;
    uint64_t a = *(const uint64_t *)left, b = *(const uint64_t *)right;
    if (value[a] != value[b])
        return value[a] < value[b] ? -1 : 1;
    return (a > b) - (a < b);
}

void rank_ascending(uint64_t *order, const double *value, size_t count)
{
    for (size_t k = 0; k < count; k++)
        order[k] = k;
    qsort_r(order, count, sizeof *order, by_value, (void *)value);
}

enum status_code rank_descending(size_t *order, const double *value, size_t count, struct status *status)
{
    uint64_t *rising = malloc((count + 1) * sizeof *rising);
    double *turned = malloc((count + 1) * sizeof *turned);
    if (rising && turned) {
        for (size_t k = 0; k < count; k++)
            turned[k] = -value[k];
        rank_ascending(rising, turned, count);
        for (size_t k = 0; k < count; k++)
            order[k] = rising[k];
    } else {
        (void)status_memory(status);
    }
    free(rising);
    free(turned);
    return status->code;
}
