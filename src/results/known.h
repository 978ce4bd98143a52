/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is known of a surface's asked quantity: what was measured stands above what a model says. */
#ifndef RESULTS_KNOWN_H
#define RESULTS_KNOWN_H

#include "results/asked.h"

enum known_kind {
    KNOWN_NOTHING,
    KNOWN_VALUE,
    KNOWN_AT_MOST,  /* that, or less: what physics allows, the lightest load of the report */
    KNOWN_MORE_THAN /* that, or more: a target that is not met up to there */
};

/** SI; a load is P/(A_n E'). */
struct known {
    enum known_kind kind;
    double value;
    double low, high; /* 95 % interval, low first; NaN: not known */
    bool measured;    /* of the surface's own measurement, or of the model by the factor that it carries */
    bool overloaded;  /* of an elastic model whose contact bears more than the hardness */
    bool short_loads; /* the interval's end lies beyond the loads of the report, and wider ones would close it */
};

/** A quantity where the summary stands. */
struct known known_value(const struct results *results, enum quantity quantity, size_t surface);
/** In the units that the user has: the load that a target needs, or without one the asked quantity. */
struct known known_shown(const struct results *results, const struct asked *asked, const struct scene_asked *target,
                         size_t surface);
/** Digits of a value as shown: two where the interval beside it is wider than ×÷ 1.2, else three. */
int known_digits(const struct known *known);
/** Judges the limits of a surface by its measurement, where it has one of their quantity, and takes the load of a target
 * from it where it reaches that: spots are in proportion to load. */
void known_take_measured(struct results *results, size_t surface);
/** The load at which a target is met, by the leading model or the measurement. */
struct known known_load(const struct results *results, const struct scene_asked *target, size_t surface);

#endif
