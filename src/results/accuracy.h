/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far each model's answer may be off, and what it took: accuracy against time. */
#ifndef RESULTS_ACCURACY_H
#define RESULTS_ACCURACY_H

#include "results/results.h"

/** Of a quantity of a model on the baseline. */
struct accuracy {
    double sd;                           /* of ln the quantity: model_sd() and too few waves; of a map its grid's; NaN:
                                            not known; 0: the model does not run, or nothing was timed */
    double here;                         /* the factor it is off by from the direct solution of this very surface, the
                                            largest of all loads solved; NaN: not solved */
    double seconds[BENCHMARK_STEPS];     /* at each tolerance, what is solved for the model's ratios included */
    double total_error[BENCHMARK_STEPS]; /* 95 %, relative, with that of the tolerance in quadrature */
    size_t used;                         /* the step nearest to the run's tolerance */
};

/** Of a joint: of the resistance of its spots. */
struct accuracy accuracy_of(const struct results *results, size_t model, enum quantity quantity);

/** What too few of the longest waves in a surface's scans add to the error of ln a quantity, whatever the model, in
 * quadrature; 0: nothing. */
double accuracy_few_waves_sd(const struct results *results, size_t surface);

/** What an effect that runs makes of a quantity of the leading model where the summary stands, on the baseline: the
 * value with it over that without. NaN: it has none to change, or only another solution would tell. */
double accuracy_effect_factor(const struct results *results, enum effect effect, enum quantity quantity);

#endif
