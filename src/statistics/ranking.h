/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which surface is better, and whether more scans would say the same. */
#ifndef STATISTICS_RANKING_H
#define STATISTICS_RANKING_H

#include "statistics/interval.h"

enum ranking_verdict { RANKING_NOT_TOLD_APART, RANKING_FIRST_LOWER, RANKING_FIRST_HIGHER };

/** Two surfaces by the logarithms of an answer. */
struct ranking {
    double difference, s, degrees; /* mean of the first less that of the second, its standard error */
    double t, p;                   /* two-sided; t is finite: +-DBL_MAX where neither surface's values differ */
    double ratio, low, high;       /* exp(difference) and its interval at the level asked for */
};

/** Welch's test of two means, unequal spreads (Welch 1947, doi:10.1093/biomet/34.1-2.28), from interval_scans() of
 * each: t = (a - b)/sqrt(s_a² + s_b²), degrees = (s_a² + s_b²)²/(s_a⁴/f_a + s_b⁴/f_b). Where neither spreads, p is 0,
 * or 1 when the means are the same. */
struct ranking ranking_welch(const struct interval *a, const struct interval *b, double level);

/** RANKING_NOT_TOLD_APART for p > 1 - level, p adjusted where there are several pairs; else which has less. */
enum ranking_verdict ranking_verdict(double difference, double p, double level);

/** Holm's step-down adjustment of `count` p values, so that any false verdict among them is as rare as p says:
 * p_(r) -> max over q <= r of min(1, (count - q + 1) p_(q)), r = 1 ... by size (Holm 1979, Scand. J. Stat. 6, 65).
 * adjusted may be p. Errors: STATUS_SCAN for p outside 0 ... 1; STATUS_MEMORY. */
MUST_CHECK enum status_code ranking_holm(double *adjusted, const double *p, size_t count, struct status *status);

/** Index of the pair i < j among the count (count - 1)/2: 01 02 ... 12 13 ... */
size_t ranking_pair(size_t i, size_t j, size_t count);

/** Groups of surfaces that are not told apart: two surfaces share a group exactly when apart[ranking_pair()] is
 * false, and no group can be left out. Each group is as large as may be; one group more is made for a surface that is
 * told apart from all others. The compact letter display of Piepho 2004 (doi:10.1198/1061860043515), by cliques instead
 * of sweeping. Owned: ranking_groups_free(). */
struct ranking_groups {
    size_t surfaces, groups;
    bool *member; /* [group * surfaces + surface], groups in the order of their first surfaces */
};

/** Surfaces in the order they are ranked in. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code ranking_groups_make(struct ranking_groups *out, const bool *apart, size_t surfaces,
                                                struct status *status);
void ranking_groups_free(struct ranking_groups *groups);

enum { RANKING_LETTERS = 52 };

/** Writes a surface's letters, a ... z, then A ... Z, one a group. out has room for RANKING_LETTERS + 1; groups
 * beyond have no letter: the last one written is then '*'. */
void ranking_groups_letters(char *out, const struct ranking_groups *groups, size_t surface);

#endif
