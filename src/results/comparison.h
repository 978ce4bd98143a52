/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the curves say when they are held against each other: the figures behind the report's checks. One pass over the
 * surfaces from smoothest to roughest. */
#ifndef RESULTS_COMPARISON_H
#define RESULTS_COMPARISON_H

#include "results/results.h"
#include "statistics/ranking.h"

/** How the cases of a question came out. Values that differ by no more than the run's tolerance are ties: they speak
 * neither for nor against. */
struct comparison_tally {
    size_t agreeing, opposed, ties;
};

/** A plastic model against its elastic partner, load by load where not both are in full contact. */
struct comparison_plastic {
    struct comparison_tally changes[QUANTITY_COUNT]; /* plastic area the larger; gap as shown, resistance the smaller */
    double least, most;                              /* ratio of the areas; both 0: not compared */
    struct comparison_tally sooner;                  /* plastic full contact at the lower load; one case a surface */
};

/** Multiscale against statistical model of one material law on one surface, over their common loads; NaN: not both
 * computed. */
struct comparison_gap {
    double area, ecr;       /* mean |log10 ratio| */
    double plain, adjusted; /* mean distance of delta, and of delta_ADJ (4.54), from the multiscale H; in sigma */
    double separation;      /* mean |log10(H/delta_ADJ)| */
    double stiffness;       /* mean log10 of the multiscale stiffness over the statistical one */
};

/** Least and largest value over the surfaces that have one. */
struct comparison_extent {
    double least, most;
    size_t count; /* 0: none, and the rest says nothing */
};

/** What the surfaces have in common at a load. */
enum comparison_spread { COMPARISON_AREAS, COMPARISON_RESISTANCES, COMPARISON_SPREADS };

/** What one model adds to the comparison. The arrays are the comparison's. */
struct comparison_model {
    struct comparison_tally rank[QUANTITY_COUNT]; /* neighbours in roughness, load by load: the smoother one has the
                                                     larger area, the smaller shown separation/sigma and resistance */
    struct comparison_tally smoothest[QUANTITY_COUNT];       /* those of them of the two smoothest surfaces */
    struct comparison_tally high_rank[QUANTITY_COUNT];       /* those in the last decade of load before one is full */
    struct comparison_plastic plastic;                       /* against its elastic partner */
    struct comparison_gap *gaps;                             /* against its counterpart, one a surface of the scene */
    struct comparison_extent extremes[QUANTITY_COUNT];       /* of the surfaces, at the middle load */
    struct comparison_extent (*extents)[COMPARISON_SPREADS]; /* one a load of the list, of those in partial contact */
    double *steps; /* mean log10 of the resistance of the (k+1)-th smoothest surface over the k-th's, over their common
                      loads of partial contact; one a pair of neighbours; NaN: none */
};

/** How two surfaces compare, by Welch's test. */
struct comparison_pair {
    enum ranking_verdict verdict;
    double ratio, low, high; /* of the better one's answer to the other's, and its 95 % interval, of this pair alone */
    double p;                /* after Holm's adjustment over all pairs */
};

enum { COMPARISON_RANKED_MOST = 100 /* surfaces; more are not ranked */ };

/** Which surface is better in the leading model at the middle load, by ln of the criterion. Surfaces of which nothing
 * is known of how far another scan would be off are not tested, and have no place. */
struct comparison_ranking {
    enum quantity criterion; /* ECR, else TCR, else area */
    size_t count;            /* places; 0 where there are more than COMPARISON_RANKED_MOST surfaces with an answer */
    size_t *surface;         /* their indices, the best first; owned, as are: */
    struct comparison_pair *pairs; /* [ranking_pair(i, j, count)], i and j places in `surface` */
    struct ranking_groups groups;  /* of places: those that share one are not told apart */
};

struct comparison {
    struct comparison_ranking ranking;
    struct comparison_model *models; /* model_count of them; owned */
    size_t leading;                  /* the model the summary speaks of: the running one of the greatest precedence */
    struct comparison_gap *gaps;     /* the models' arrays, one after another; owned, as are: */
    struct comparison_extent (*extents)[COMPARISON_SPREADS];
    double *steps;
};

/** End it with comparison_free() whatever comes back. Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code comparison_make(struct comparison *out, const struct results *results,
                                            struct status *status);
void comparison_free(struct comparison *comparison);

/** Two answers held against each other, `a` over `b`, by the estimates of their logarithms, the scatter alone; p as it
 * is. */
struct comparison_pair comparison_of_two(const struct estimate *a, const struct estimate *b);
/** Places i < j of a ranking. */
const struct comparison_pair *comparison_pair_of(const struct comparison_ranking *ranking, size_t i, size_t j);
/** Was a difference between the two found that more scans would show again? */
bool comparison_told_apart(const struct comparison_pair *pair);

/** What a model says of a surface at the middle load; quantity_nothing() where it has no point. */
struct contact_point comparison_middle(const struct results *results, size_t model, size_t surface);
/** A quantity of the leading model over that of its `gaussian` at the surface's operating load: what the heights do;
 * NaN: one of them has none. */
double comparison_heights_factor(const struct results *results, size_t surface, enum quantity quantity);
/** Value of a quantity of a model's point, as tables and charts show it. */
double comparison_value(const struct contact_point *point, enum quantity quantity, size_t model, double sigma_m);

/** Mean log10(most/least) over the surfaces, over the loads at which all of them are in partial contact in model `a`
 * and in model `b`; NaN where there is no such load. */
double comparison_mean_spread(const struct results *results, const struct comparison_model *a,
                              const struct comparison_model *b, enum comparison_spread of);
/** The largest of most/least over the loads at which all surfaces are in partial contact; NaN where there is none. */
double comparison_largest_spread(const struct results *results, const struct comparison_model *model,
                                 enum comparison_spread of);

/** Has a sweep's curve converged: does the last halving of the wavelength change the area by less than 0.1 %? */
bool comparison_converges(const struct results *results, enum convergence_sweep sweep, size_t model, size_t value);

#endif
