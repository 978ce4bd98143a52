/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Names in messages: text from outside made printable, and the known name nearest to an unknown one. */
#ifndef SCENE_SCENE_WORDS_H
#define SCENE_SCENE_WORDS_H

#include "base/unit.h"
#include "scan/string_view.h"

/** Text for a one-line message: control characters become '?', a long text ends with "...". */
struct scene_words_shown {
    char text[84];
};
struct scene_words_shown scene_words_show(const char *text);
struct scene_words_shown scene_words_show_view(struct string_view text);

/** "did you mean 'x'?" when one of the `all` names is near `word`, else "allowed: a, b, c", the first `count`. */
struct scene_words_hint {
    char text[500];
};
struct scene_words_hint scene_words_hint(const char *word, const char *const *names, size_t count, size_t all);

/** The next word of a list separated by commas or blanks, advancing `*rest`; false at the end. */
bool scene_words_next(struct string_view *word, const char **rest);

/** Index of the name that is `word`, or `count` when none is. No view ({0}) is no name. */
size_t scene_words_find(struct string_view word, const char *const *names, size_t count);

/* A quantity as people write one: a number in SI, or a number with its unit. */

struct scene_quantity {
    double value;            /* in SI */
    enum unit_quantity kind; /* which of those allowed; of a number without a unit the first (lowest) of them */
    bool has_unit;
    struct unit unit;       /* as written; without one: 1 */
    char text[UNIT_LENGTH]; /* the same, its characters as text_character() allows; "": none */
};

/** Reads `4 mm2`, `2.5um`, `1e4 W/m2/K`, `20 degC`, `10 %` or a plain number in SI; `quantities`: the enum
 * unit_quantity bits that it may be. False: no number (an overflow gives infinity), or a unit of none. */
bool scene_quantity_read(struct scene_quantity *out, struct string_view text, unsigned quantities);

/** What to write for one, to end a message: "a number in Pa or one with its unit: Pa, kPa, ...". */
struct scene_quantity_help {
    char text[600];
};
struct scene_quantity_help scene_quantity_help(unsigned quantities);

#endif
