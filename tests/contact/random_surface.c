/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "random_surface.h"

#include "support.h"

double random_surface(struct spectrum *out, double hurst, double longest, double shortest, bool plateau)
{
    size_t count = (size_t)shortest;
    *out = (struct spectrum){calloc(count, sizeof(double)), count, 1, false};
    assert_non_null(out->amplitude_m);
    int most = (int)count;
    double gradient = 0, areal = 0;
    for (int i = -most; i <= most; i++)
        for (int j = -most; j <= most; j++) {
            double r = hypot(i, j);
            if (!(r <= shortest) || r < (plateau ? 1 : longest))
                continue;
            double v = pow(fmax(r, longest), -2 - 2 * hurst);
            gradient += 4 * M_PI * M_PI * r * r * v;
            areal += v;
            if (i > 0)
                out->amplitude_m[i - 1] += 2 * v; /* modes (i, j) and (-i, -j) */
        }
    for (size_t i = 0; i < count; i++)
        out->amplitude_m[i] = sqrt(2 * out->amplitude_m[i] / gradient);
    return areal / gradient;
}
