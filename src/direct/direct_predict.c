/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_predict.h"

#include <math.h>

enum { POINTS, ELASTIC, CAPPED, CONSTRICTION, ELASTIC_SECONDS, CAPPED_SECONDS, SYNTHESIS_SECONDS, COLUMNS };

/** Convolutions a load, seconds a convolution with everything between (of which a hardness has more), and seconds to
 * make a surface with given heights, by points a side. */
static const double table[][COLUMNS] = {
    {64, 29, 13, 10, 4.0e-5, 6.5e-5, 7e-3},   {128, 33, 15, 12.5, 1.3e-4, 2.3e-4, 0.03},
    {256, 44, 17, 16, 5.8e-4, 1.2e-3, 0.14},  {512, 57, 19, 20, 2.6e-3, 4.0e-3, 0.7},
    {1024, 76, 21, 22, 1.15e-2, 1.8e-2, 4.4},
};

/* What a measured map takes more, mean of four maps on 100 to 800 points a side: heights that are not Gaussian, with a
 * hardness more convolutions, and loads up to full contact, where a convolution has more points between. */
static const double map_time = 1.35, map_capped = 1.5;
enum { ROWS = sizeof table / sizeof table[0] };

/** A column at n points a side, by a power of n between two rows and beyond the ends. */
static double column_at(double n, int column)
{
    size_t row = 0;
    while (row + 2 < ROWS && table[row + 1][POINTS] < n)
        row++;
    const double *low = table[row], *high = table[row + 1];
    return low[column] * pow(high[column] / low[column], log(n / low[POINTS]) / log(high[POINTS] / low[POINTS]));
}

/** One surface's ladder. */
static double ladder(const struct direct_predict_def *def, double n, double *seconds)
{
    double contact = column_at(n, def->capped ? CAPPED : ELASTIC) * (double)def->loads;
    contact *= def->map && def->capped ? map_capped : 1;
    double constriction = def->resistance ? column_at(n, CONSTRICTION) * (double)def->loads : 0;
    *seconds = contact * column_at(n, def->capped ? CAPPED_SECONDS : ELASTIC_SECONDS) +
               constriction * column_at(n, ELASTIC_SECONDS);
    *seconds *= def->map ? map_time : 1;
    return contact + constriction;
}

struct direct_prediction direct_predict(const struct direct_predict_def *def)
{
    static const double bytes_a_point = 80;
    double n = (double)def->n, times = def->fine_times > 1 ? (double)def->fine_times : 0, seeds = (double)def->seeds;
    double coarse_seconds, fine_seconds = 0, synthesis = def->heights ? column_at(n, SYNTHESIS_SECONDS) : 0;
    struct direct_prediction out = {.convolutions = seeds * ladder(def, n, &coarse_seconds),
                                    .bytes = fmax(1, times * times) * bytes_a_point * n * n};
    if (times > 0)
        out.convolutions += ladder(def, n * times, &fine_seconds);
    out.seconds = fine_seconds + seeds * coarse_seconds + (seeds + (times > 0)) * synthesis;
    return out;
}
