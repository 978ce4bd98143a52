/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The quantity that the user asks for, in the user's unit: what the first page and its charts speak of; and what is
 * known of it, where what was measured stands above what a model says. */
#ifndef RESULTS_ASKED_H
#define RESULTS_ASKED_H

#include "results/results.h"

/** Limits that the first page has a column for; claims tell the others. */
enum { ASKED_LIMIT_COLUMNS = 2 };

struct asked {
    const struct scene_asked *target; /* the first; NULL: none, and what follows is chosen */
    enum quantity quantity;
    bool reciprocal; /* its inverse is shown: 1/TCR is a conductance */
    bool more_is_better;
    double scale;  /* what is shown is scale * quantity, or scale / quantity */
    char name[64]; /* its words' in templates/words.txt */
    char unit[64]; /* may come from the scene; "": a ratio */
};

/** Of results_asked_quantity(); in the scene's unit, else in mohm, K/W where the nominal area is known. */
struct asked asked_of(const struct results *results);
/** A value of its quantity as it is shown. */
double asked_shown(const struct asked *asked, double value);

/** Ends of an interval of its quantity, low first, as shown, low first. */
void asked_ends(double out[2], const struct asked *asked, const double of[2]);
/** The unit of loads: the scene's (of `load`, else of `operating_load`), else N with a nominal area, else MPa, else
 * P/(A_n E'). */
struct asked_load {
    char unit[64]; /* "": P/(A_n E') */
    double scale;  /* P/(A_n E') times it is the number shown */
    bool force;    /* else a pressure */
};
struct asked_load asked_load_of(const struct results *results, size_t surface);

/** The first of the running models that handbooks print; model_count: none runs. */
size_t asked_textbook(const struct results *results);
/** The direct solution of the baseline, of the leading model's material law. */
struct asked_solved {
    double load;         /* P/(A_n E') */
    double value, error; /* relative standard error */
    double ratio;        /* of the leading model, on the surface solved, to it */
};
/** At a load of the baseline, straight in the logarithms between solved loads, else at the nearest; NaN: none. */
struct asked_solved asked_direct(const struct results *results, enum quantity quantity, double load);
/** A unit as people print it: "mohm" as "mΩ", "W/m2/K" as "W/(m²·K)". */
void asked_unit(char *out, size_t size, const char *unit);
/** `unit` with the prefix with which a value in it is between 1 and 1000; returns what the prefix stands for. */
double asked_prefix(char *out, size_t size, const char *unit, double value);
/** A number with its unit as people print it: "1 mohm" as "1 mΩ". */
void asked_text(char *out, size_t size, const char *text);

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
    bool beyond;      /* of these the second: the test does not have it */
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
/** Judges the limits of a surface by its measurement, where it has one of their quantity, and takes the load of a
 * target from it where it reaches that: spots are in proportion to load. */
void known_take_measured(struct results *results, size_t surface);
/** The load at which a target is met, by the leading model or the measurement. */
struct known known_load(const struct results *results, const struct scene_asked *target, size_t surface);

#endif
