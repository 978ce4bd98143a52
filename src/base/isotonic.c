/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/isotonic.h"

void isotonic(double *value, size_t count, size_t step, bool falls)
{
    double sign = falls ? -1 : 1;
    for (size_t i = 1; i < count; i++) {
        double sum = value[i * step], pooled = 1;
        size_t first = i;
        for (; first > 0 && sign * value[(first - 1) * step] > sign * sum / pooled; first--, pooled++)
            sum += value[(first - 1) * step];
        for (size_t k = first; first < i && k <= i; k++)
            value[k * step] = sum / pooled;
    }
}
