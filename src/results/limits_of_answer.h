/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the leading model's answer hangs on, one thing changed at a time, and what to measure to be surer. */
#ifndef RESULTS_LIMITS_OF_ANSWER_H
#define RESULTS_LIMITS_OF_ANSWER_H

#include "results/comparison.h"

/** A thing that is not known well: one row each in doubt.c. */
struct limit_of_answer_row {
    const char *what;    /* "scan length" */
    const char *changed; /* how far: "halved" */
    const char *next;    /* what to measure to know it better */
    bool either_way;     /* the answer may be off by the factor or by its inverse */
    /** Answer changed / answer as it is, of surface `surface` in the leading model at its operating load, by
     * `quantity`, the run's criterion; either way: 1 and up. NaN: no number. */
    double (*factor)(const struct results *results, const struct comparison *comparison, enum quantity quantity,
                     size_t surface);
};

struct limit_of_answer {
    const struct limit_of_answer_row *row;
    double factor;    /* of all usable surfaces' the farthest from 1 */
    size_t surface;   /* whose it is */
    const char *next; /* what to measure: the row's, or what is left of it */
    bool alike;       /* every surface that has a number has this one */
};

enum { LIMITS_OF_ANSWER_MOST = 12 };

/** Fills `out` with those that have a number, the largest |ln factor| first, and returns how many. */
size_t limits_of_answer(struct limit_of_answer out[LIMITS_OF_ANSWER_MOST], const struct results *results, const struct comparison *comparison);

/** What resistivity and conductivity are taken to be known within: 0.05. */
extern const double limit_of_answer_tolerance;

#endif
