/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "profile/profile.h"

#include <assert.h>
#include <math.h>

const double record_window_hann_factor = 1.632993161855452; /* sqrt(8/3) */

static const double most_rms = 3;

static double second_difference(const double *z, size_t before, size_t at, size_t after)
{
    return (z[after] - z[at]) - (z[at] - z[before]);
}

bool record_window_is_periodic(const double *raw_height_m, size_t points)
{
    assert(points >= 3);
    const double *z = raw_height_m;
    double first = 0, second = 0;
    for (size_t t = 1; t < points; t++)
        first += (z[t] - z[t - 1]) * (z[t] - z[t - 1]);
    for (size_t t = 2; t < points; t++) {
        double bend = second_difference(z, t - 2, t - 1, t);
        second += bend * bend;
    }
    double most_step = most_rms * sqrt(first / (double)(points - 1));
    double most_bend = most_rms * sqrt(second / (double)(points - 2));
    return fabs(z[0] - z[points - 1]) <= most_step &&
           fabs(second_difference(z, points - 2, points - 1, 0)) <= most_bend &&
           fabs(second_difference(z, points - 1, 0, 1)) <= most_bend;
}

void record_window_hann(double *height_m, size_t points)
{
    for (size_t t = 0; 2 * t < points; t++) { /* the same from either end */
        double weight = record_window_hann_factor * (1 - cos(2 * M_PI * ((double)t + 0.5) / (double)points)) / 2;
        height_m[t] *= weight;
        if (points - 1 - t != t)
            height_m[points - 1 - t] *= weight;
    }
}
