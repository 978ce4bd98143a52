/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Do surfaces differ significantly, and which is better? */
#ifndef STATISTICS_RANKING_H
#define STATISTICS_RANKING_H

#include "statistics/interval.h"

/** Two surfaces by the logarithms of an answer. */
struct ranking {
    double difference, s, degrees; /* mean of the first less that of the second, its standard error */
    double t, p;                   /* two-sided; t is +-DBL_MAX where neither surface scatters */
    double ratio, low, high;       /* exp(difference) and its interval at the level asked for */
};

/** Welch's test of two means, unequal spreads (Welch 1947, doi:10.1093/biomet/34.1-2.28), from interval_scans() of
 * each: t = (a - b)/sqrt(s_a² + s_b²), degrees = (s_a² + s_b²)²/(s_a⁴/f_a + s_b⁴/f_b). Without scatter p is 0, or 1
 * where the means are equal. */
struct ranking ranking_welch(const struct interval *a, const struct interval *b, double level);

/** Holm's step-down adjustment of `count` p values, so that p limits the chance of any false verdict among them:
 * p_(r) -> max over q <= r of min(1, (count - q + 1) p_(q)), r = 1 ... by size (Holm 1979, Scand. J. Stat. 6, 65).
 * adjusted may be p. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code ranking_holm(double *adjusted, const double *p, size_t count, struct status *status);

/** Index of the pair i < j among the count (count - 1)/2: 01 02 ... 12 13 ... */
size_t ranking_pair(size_t i, size_t j, size_t count);

/** Groups of surfaces that do not differ significantly: two surfaces share a group exactly when apart[ranking_pair()]
 * is false. Groups are as large as possible and none is superfluous; a surface that differs from all others has its
 * own. The compact letter display of Piepho 2004 (doi:10.1198/1061860043515), by cliques. Owned: ranking_groups_free().
 */
struct ranking_groups {
    size_t surfaces, groups;
    bool *member; /* [group * surfaces + surface], groups in the order of their first surfaces */
};

/** Surfaces in the order they are ranked in. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code ranking_groups_make(struct ranking_groups *out, const bool *apart, size_t surfaces,
                                                struct status *status);
void ranking_groups_free(struct ranking_groups *groups);

enum { RANKING_LETTERS = 52 };

/** Writes a surface's letters, a ... z, then A ... Z, one per group, '*' for groups beyond. Room: RANKING_LETTERS + 1.
 */
void ranking_groups_letters(char *out, const struct ranking_groups *groups, size_t surface);

#endif
