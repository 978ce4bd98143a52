/* Pieces of a text file in memory: spans, the lines of a file, the cells of a line. Nothing is copied. */
#ifndef SCAN_SPAN_H
#define SCAN_SPAN_H

#include <stdbool.h>
#include <stddef.h>

/** The characters start..end-1; not terminated. */
struct span {
    const char *start, *end;
};

static inline size_t span_length(struct span span)
{
    return (size_t)(span.end - span.start);
}

static inline bool span_is_blank_char(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

/** `span` without blanks at both ends. */
struct span span_trim(struct span span);
/** Do the first characters of `span` equal `prefix` (ASCII case ignored)? */
bool span_starts(struct span span, const char *prefix);
/** Does `span` equal `word` (ASCII case ignored)? */
bool span_equals(struct span span, const char *word);

/** Walks over lines that end in LF, CRLF or, in a file without any LF, CR. */
struct lines {
    const char *next, *end;
    char stop;     /* '\n' or '\r' */
    size_t number; /* of the line handed out last, from 1 */
};

struct lines lines_begin(struct span text);
/** Hands out the next line without its end; false behind the last one. */
bool lines_next(struct lines *lines, struct span *line);

/** Cuts the next cell, trimmed, off `rest`; false when nothing is left. With `delimiter` ' ' any run of blanks
 * separates, but not before '[' or '(', so that `x [mm] z [um]` is two cells. */
bool cell_next(struct span *rest, char delimiter, struct span *cell);

#endif
