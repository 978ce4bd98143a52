/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parts of a text in memory: views, lines, the cells of a line. Nothing is copied. */
#ifndef SCAN_STRING_VIEW_H
#define SCAN_STRING_VIEW_H

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

/** The characters start..end-1; not terminated. */
struct string_view {
    const char *start, *end;
};

static inline size_t string_view_length(struct string_view view)
{
    return (size_t)(view.end - view.start);
}

static inline struct string_view string_view_of(const char *string)
{
    return (struct string_view){string, string + strlen(string)};
}

static inline bool string_view_is_blank_char(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

/** `view` without blanks at both ends. */
struct string_view string_view_trim(struct string_view view);
/** Do the first characters of `view` equal `prefix` (ASCII case ignored)? */
bool string_view_starts(struct string_view view, const char *prefix);
/** Does `view` equal `word` (ASCII case ignored)? */
bool string_view_equals(struct string_view view, const char *word);
/** Does it equal one of `words`, which blanks separate? */
bool string_view_is_one_of(struct string_view view, const char *words);

/** Lines that end in LF, CRLF or, in a file without any LF, CR. */
struct lines {
    const char *next, *end;
    char stop;     /* '\n' or '\r' */
    size_t number; /* of the last line taken, from 1 */
};

struct lines lines_begin(struct string_view text);
/** Takes the next line without its end; false behind the last one. */
bool lines_next(struct lines *lines, struct string_view *line);

/** Cuts the next cell, trimmed, off `rest`; false when nothing is left. With `delimiter` ' ' any number of blanks
 * separates, but not before '[' or '(', so that `x [mm] z [um]` are two cells. */
bool cell_next(struct string_view *rest, char delimiter, struct string_view *cell);

/* Decimal numbers, correctly rounded whatever the locale. */

enum { NUMBER_POINT = 1, NUMBER_COMMA = 2 }; /* decimal signs */

/** Reads a number (sign, digits, decimal sign, digits, exponent with e, E, d or D) from the start of `text` and returns
 * its end; NULL: there is none (NaN and inf are none). `allowed` are the decimal signs that count; the one found is
 * added to *met (NULL: not asked). A decimal comma needs digits on both sides. *value is the nearest double, infinite
 * on overflow. */
const char *number_scan(struct string_view text, unsigned allowed, unsigned *met, double *value);

/** The whole of `text`, trimmed, as a finite number with a decimal point. */
bool number_read(struct string_view text, double *value);
/** The same for an integer >= 0, without sign, decimal sign or exponent. */
bool number_read_size(struct string_view text, size_t *value);

#endif
