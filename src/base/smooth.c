/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/smooth.h"

#include <math.h>
#include <stdlib.h>

static const double reach = 4; /* in widths, where the weight is 3e-4 */

bool smooth_lines(double *value, size_t count, size_t stride, double width)
{
    const long most = (long)ceil(reach * width), last = (long)count - 1;
    double *before = width > 0 ? malloc((count + 1) * sizeof *before) : NULL;
    if (!before)
        return !(width > 0);
    for (size_t i = 0; i < count; i++)
        before[i] = value[i * stride];
    for (long i = 0; i <= last; i++) {
        double w0 = 0, w1 = 0, w2 = 0, y0 = 0, y1 = 0; /* moments of the weights, and of the values */
        for (long k = i < most ? -i : -most; k <= most && i + k <= last; k++) {
            const double x = (double)k / width, weight = exp(-x * x / 2), y = before[i + k];
            w0 += weight;
            w1 += weight * x;
            w2 += weight * x * x;
            y0 += weight * y;
            y1 += weight * x * y;
        }
        const double spread = w0 * w2 - w1 * w1;
        value[(size_t)i * stride] = spread > 0 ? (w2 * y0 - w1 * y1) / spread : before[i];
    }
    free(before);
    return true;
}
