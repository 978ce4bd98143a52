/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the surfaces say, held against each other at the operating load: which is better, and by how much. */
#ifndef RESULTS_COMPARISON_H
#define RESULTS_COMPARISON_H

#include "results/results.h"
#include "statistics/ranking.h"

/** How two surfaces compare, by Welch's test. */
struct comparison_pair {
    double ratio, low, high; /* of the better one's answer to the other's, and its 95 % interval, of this pair alone */
    double p;                /* after Holm's adjustment over all pairs */
};

enum { COMPARISON_RANKED_MOST = 100 /* surfaces; a report ranks no more, and more have no groups */ };

/** The surfaces ranked by the criterion in the leading model at the operating load, and tests of its logarithm. A
 * surface whose scatter is unknown has no place. */
struct comparison {
    enum quantity criterion; /* that asked for of film, plating and shape; else ECR, else TCR, else area */
    size_t count;            /* places; 0 where there are more than COMPARISON_RANKED_MOST surfaces with an answer */
    size_t *surface;         /* their indices, the best first; owned, as are: */
    struct comparison_pair *pairs; /* [ranking_pair(i, j, count)], i and j places in `surface` */
    struct ranking_groups groups;  /* of places: those that share one are not told apart */
};

/** End it with comparison_free() whatever comes back. Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code comparison_make(struct comparison *out, const struct results *results,
                                            struct status *status);
void comparison_free(struct comparison *comparison);

/** Tests the surfaces of a ranking, whose `count` is set, each against each: makes its pairs and, of no more than
 * COMPARISON_RANKED_MOST, its groups. End it with comparison_free(). Errors: those of ranking_holm(). */
MUST_CHECK enum status_code comparison_test(struct comparison *ranking, const struct estimate *const *estimates,
                                            struct status *status);

/** Two answers held against each other, `a` over `b`, by the estimates of their logarithms, the scatter alone; p as it
 * is. */
struct comparison_pair comparison_of_two(const struct estimate *a, const struct estimate *b);
const struct comparison_pair *comparison_pair_of(const struct comparison *ranking, size_t i, size_t j);
/** Was a difference between the two found that more scans would show again? */
bool comparison_told_apart(const struct comparison_pair *pair);

/** What a model says of a surface at the operating load; quantity_nothing() where it has no point. */
struct contact_point comparison_middle(const struct results *results, size_t model, size_t surface);
/** ECR of the leading model over that of its `gaussian` at the surface's operating load: what the heights do; NaN: one
 * of them has none. */
double comparison_heights_factor(const struct results *results, size_t surface);
/** Does a model's contact there bear more than the hardness (model_is_overloaded())? */
bool comparison_overloaded(const struct results *results, size_t model, size_t surface);
/** Value of a quantity of a model's point, as tables and charts show it. */
double comparison_value(const struct contact_point *point, enum quantity quantity, size_t model, double sigma_m);

/** Has a sweep's curve converged: does the last halving of the wavelength change the area by less than 0.1 %? */
bool comparison_converges(const struct results *results, enum convergence_sweep sweep, size_t model, size_t value);

#endif
