/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "validation/height_laws.h"

#include <math.h>

static double as_is(double u)
{
    return u;
}

static double plateau(double u)
{
    return u < 0 ? u : 0.15 * u;
}

static double pits(double u)
{
    return u < -1 ? u + 3 * (u + 1) : u;
}

static double peaks(double u)
{
    return -pits(-u);
}

static double lognormal(double u)
{
    return exp(0.5 * u);
}

static double valleys(double u)
{
    return -lognormal(-u);
}

static double clipped(double u)
{
    return fmin(u, 0.3) + 0.01 * u;
}

static double bimodal(double u)
{
    return 1.5 * tanh(3 * u) + 0.3 * u;
}

static double heavy(double u)
{
    return sinh(0.8 * u);
}

const struct height_law_row height_laws[HEIGHT_LAWS] = {
    [HEIGHTS_GAUSSIAN] = {"Gaussian", as_is},       [HEIGHTS_PLATEAU] = {"plateau-honed", plateau},
    [HEIGHTS_PITS] = {"deep pits", pits},           [HEIGHTS_PEAKS] = {"peaks", peaks},
    [HEIGHTS_LOGNORMAL] = {"lognormal", lognormal}, [HEIGHTS_VALLEYS] = {"lognormal, upside down", valleys},
    [HEIGHTS_WORN] = {"ground flat", clipped},      [HEIGHTS_BIMODAL] = {"bimodal", bimodal},
    [HEIGHTS_HEAVY] = {"heavy tails", heavy},
};
