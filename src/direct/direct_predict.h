/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a direct solution will cost, before it is begun. */
#ifndef DIRECT_PREDICT_H
#define DIRECT_PREDICT_H

#include <stdbool.h>
#include <stddef.h>

/** A ladder of loads over several surfaces, as direct_ensemble.h solves it. */
struct direct_predict_def {
    size_t n, fine_times, loads, seeds; /* fine_times 0 or 1: no finer grid */
    bool capped;                        /* with a hardness */
    bool resistance;                    /* constriction too */
    bool heights;                       /* the surfaces are given heights */
    bool map;                           /* it is a measured map */
};

struct direct_prediction {
    double convolutions, seconds; /* of all surfaces, on one processor */
    double bytes;                 /* held at once */
};

/** From counts and times measured on a power law with lambda_s = 6 dx over loads from 1e-5 to 1e-2 E' (2026, one core
 * of an Intel Xeon with AVX), interpolated between grids. Counts hold to a factor 1.5 on other surfaces and 2 on maps,
 * but not where deep pits leave a plateau (under a hardness 5 times as many there); times as far as the processor is
 * alike.
 */
struct direct_prediction direct_predict(const struct direct_predict_def *def);

#endif
