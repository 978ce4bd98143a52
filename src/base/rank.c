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
