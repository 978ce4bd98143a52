/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The view: one JSON tree of worded numbers, flags and rows, which the templates are filled from (docs/templates.md).
 * No sentence stands here but what messages are made of elsewhere: those are the templates'. */
#ifndef REPORT_VIEW_H
#define REPORT_VIEW_H

#include "chart/figures.h"
#include "output/record.h"
#include "results/asked.h"
#include "results/comparison.h"
#include <jansson.h>

/** What the view is made from. */
struct view_source {
    const struct results *results;
    const struct comparison *comparison;
    struct words *words;
    const struct surface_record *baseline;
    size_t leading;
    struct asked asked;
    json_t *headline;
    json_t *claims; /* claims.h */
};

/** The tree of a run, new, with its claims and its headline. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code view_make(json_t **out, const struct results *results, const struct comparison *comparison,
                                      json_t *headline, json_t *claims, const struct figures *figures,
                                      struct words *words, struct status *status);

/* Its parts: each adds what its section needs, or nothing. Private to src/report. */
void view_first_page(json_t *out, const struct view_source *source);
void view_surfaces(json_t *out, const struct view_source *source);
void view_models(json_t *out, const struct view_source *source);
void view_joint(json_t *out, const struct view_source *source);
void view_direct(json_t *out, const struct view_source *source);
void view_accuracy(json_t *out, const struct view_source *source);
void view_findings(json_t *out, const struct view_source *source);
void view_inputs(json_t *out, const struct view_source *source);
/** Behind a program that is given its tables in mm. */
extern const char view_export_mm[];
void view_export(json_t *out, const struct view_source *source);

/** Rows that a table shows at most; data/ has all. */
enum { VIEW_ROWS = 100 };

/** Sets a text, as it may be shown. */
void view_text(json_t *out, const char *name, const char *string);
/** Sets a number as printed: `digits` significant ones, with its unit behind it ("": none); nothing where it is not
 * finite. */
void view_number(json_t *out, const char *name, double value, int digits, const char *unit);
/** Sets two numbers, `least` and `most`, for templates to word; nothing where one is not finite. */
void view_range(json_t *out, const char *name, double least, double most);
/** Sets `interval`, "0.15–1.1" or "≥ 0.15"; false: nothing, as no end is known or both read alike. */
bool view_interval(json_t *out, double low, double high, int digits, const char *between);
/** Sets a count; nothing of 0. */
void view_some(json_t *out, const char *name, size_t count);
/** A new object with `count` and whether it is `one`, which `only` (NULL: it has no name) is the `surface` of; nothing
 * of 0. */
void view_counted(json_t *out, const char *name, size_t count, const char *only);
void view_flag(json_t *out, const char *name, bool flag);
/** A new object of that name. */
json_t *view_part(json_t *out, const char *name);
/** A new object at the end of an array, or of the array `name` of an object, which is made if need be. */
json_t *view_item(json_t *array);
json_t *view_list(json_t *out, const char *name);
/** The item of a list that is, or whose `part` is, the same as another; NULL: none. */
json_t *view_alike(const json_t *list, const char *part, const json_t *other);
/** `gamma` with its standard error and `alpha` of a law; nothing where there is none. */
void view_law(json_t *out, const struct power_law *law);
/** A load of a surface as the user has it: "0.40 N". */
void view_load(json_t *out, const char *name, const struct view_source *source, size_t surface, double load);
/** Name of a surface, as given. */
const char *view_name(const struct view_source *source, size_t surface);
const struct surface_summary *view_summary(const struct view_source *source, size_t surface);

/** Adds a line for each surface that misses a limit, else for each of which it is undecided or not known; returns how
 * many. */
size_t view_limits_of(struct text *out, const struct results *results, struct words *words, bool missed);

#endif
