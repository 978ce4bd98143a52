/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Records: what there is to say of a thing, a field a row of a const table, under one key whether it goes into a row of
 * data/ (tables.c) or into an object of JSON; and how JSON has a number, a text and what is missing. */
#ifndef OUTPUT_RECORD_H
#define OUTPUT_RECORD_H

#include "results/results.h"
#include <jansson.h>

enum record_kind {
    RECORD_NUMBER, /* double, SI; not finite: an empty cell, null */
    RECORD_COUNT,  /* size_t */
    RECORD_TEXT,   /* const char *, which may hold anything; NULL: an empty cell, null */
    /* in JSON alone: */
    RECORD_CHARACTERS, /* an array of char: a text */
    RECORD_PAIR,       /* two doubles one after another */
    RECORD_FLAG,       /* bool */
    RECORD_ESTIMATE    /* struct estimate */
};

/** Bits of a field's `when`: in which output it is, and under which conditions. */
enum {
    RECORD_CSV = 1,
    RECORD_JSON = 2,
    RECORD_ALWAYS = 3,
    RECORD_ASPERITIES = 4 /* a model works on them */,
    RECORD_MAPS = 8 /* some surface has one */
};

/** A table of fields ends with one that has no key. */
struct record_field {
    const char *key;
    enum record_kind kind;
    unsigned when;
    size_t offset;    /* in what the record is of */
    int digits;       /* in the report's table of such records; 0: it has no column there */
    const char *unit; /* it is shown in */
};

/** RECORD_FIELD(struct surface_summary, NUMBER, "points", points, ALWAYS) */
#define RECORD_FIELD(of, kind, key, member, when) RECORD_SHOWN(of, kind, key, member, when, 0, "")
/** RECORD_SHOWN(struct surface_summary, NUMBER, "rq_m", roughness.rq_m, ALWAYS, 3, "um"): it also heads a column, in
 * the words `column.rq_m`, and `compare` tells where it differs. */
#define RECORD_SHOWN(of, kind, key, member, when, digits, unit)                                                        \
    {                                                                                                                  \
        key, RECORD_##kind, RECORD_##when, offsetof(of, member), digits, unit                                          \
    }

/** One of the unit that a field is shown in, in SI. */
double record_unit(const struct record_field *field);

/** A value of that kind. */
json_t *record_value_json(enum record_kind kind, const void *at);
/** The fields that are in JSON, as an object. */
json_t *record_json(const struct record_field *fields, const void *of);

/** An estimate as it is told, with the 95 % intervals of the surface's mean and of another scan; the deviation is of
 * the logarithm where the mean is geometric. */
struct record_estimate {
    struct estimate estimate;
    double value, mean_95[2], next_95[2];
};
struct record_estimate record_estimate(const struct estimate *estimate);
extern const struct record_field record_estimate_fields[];
json_t *record_estimate_json(const struct estimate *estimate);

/* Parts of any JSON that is printed or written. */

/** Adds `json` as jansson prints it with 17 digits and an indent of one, in a third of the time: most of it goes into
 * numbers. False without memory. */
bool json_text(struct text *out, const json_t *json);
/** `hostile` as it may be shown: JSON is UTF-8, a file name need not be. NULL: null. */
json_t *json_shown(const char *hostile);
/** The lines of a text, each as it may be shown. */
json_t *json_lines(const char *lines);
/** A number; null for NaN, and for what is without end. */
json_t *json_finite(double value);
json_t *json_numbers(const double *values, size_t count);
void json_set(json_t *object, const char *key, double value);
void json_set_count(json_t *object, const char *key, size_t count);
void json_set_all(json_t *object, const char *key, const double *values, size_t count);

#endif
