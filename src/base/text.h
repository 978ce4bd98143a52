/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A growing text: report pages, CSV rows, messages. Owned by whoever declared it; text_free() ends it. */
#ifndef BASE_TEXT_H
#define BASE_TEXT_H

#include "base/status.h"
#include <stddef.h>
#include <stdio.h>

struct text {
    char *data;      /* NUL-terminated once something was added, else NULL */
    size_t length;   /* bytes without the NUL */
    size_t capacity; /* bytes allocated */
    bool failed;     /* an allocation failed: further additions do nothing */
};

void text_add(struct text *text, const char *format, ...) PRINTF_LIKE(2, 3);
void text_add_bytes(struct text *text, const char *bytes, size_t length);
/* Text from outside, escaped: one rule for what may not be shown. Control characters, bytes that are no UTF-8, and
 * characters that are not seen or that turn those around them (bidirectional controls, zero widths, fillers, tags) are
 * written out: a byte or ASCII character as \x1b, another character as \u202e or \U000e0041. A backslash that could be
 * taken for the beginning of such a thing is doubled, so that two texts that differ still do. */

/** Bytes of the character at `s` when it is valid UTF-8 that a terminal, HTML and XML may show, else 0. */
size_t text_character(const char *s);
/** The most bytes of `string`, up to `most`, that do not end inside a character. */
size_t text_fit(const char *string, size_t most);
/** What is shown for the character (or byte) at `s`, which is not the final NUL, and how many bytes it has there. */
struct text_shown {
    char text[12];
    size_t bytes;
};
struct text_shown text_show(const char *s);
/** Adds `string` as it may be shown. */
void text_add_shown(struct text *text, const char *string);
/** Adds what is shown already, with the characters that mean something in Markdown or HTML escaped. */
void text_add_markdown_shown(struct text *text, const char *string);
/** Adds what is shown already, so that text_strip_marks() leaves it as it is. */
void text_add_unmarked(struct text *text, const char *string);
/** Takes the marks of Markdown (* and `) out of a text. */
void text_strip_marks(struct text *text);
/** Adds `size` bytes of plain text for HTML, in an element or a quoted value: what has a meaning there is escaped; line
 * ends and tabs stay; what else may not be shown is written out, but no backslash doubled, as most of it was shown
 * before. `bytes` ends with a whole character or before a NUL. */
void text_add_html(struct text *out, const char *bytes, size_t size);
/** Adds `string` as one CSV field, as it may be shown, an apostrophe before what a spreadsheet would take for a
 * formula, also behind a semicolon; quoted, with quotes doubled, when it holds a comma, a semicolon or a quote. */
void text_add_csv(struct text *text, const char *string);
/** Characters of the first `length` bytes, or of a whole string, as UTF-8. */
int text_width(const char *string, size_t length);
int text_characters(const char *string);
/** Adds `string`, broken at blanks into lines of at most `width` characters; all but the first begin `indent` in. */
void text_add_wrapped(struct text *text, const char *string, int width, int indent);
/** Leaves one empty line where several stand, none at the beginning, and no blanks at the ends of lines. */
void text_squeeze(struct text *text);
/** The text so far, never NULL. */
const char *text_string(const struct text *text);
void text_free(struct text *text);

/** Reads all that is left of `file`, which messages call `name`, up to LIMIT_FILE_BYTES. Error: STATUS_IO with name and
 * reason. */
MUST_CHECK enum status_code text_read_stream(struct text *text, FILE *file, const char *name, struct status *status);
/** Reads a whole regular file (NUL allowed) into `text`; a pipe, a device or a directory is refused, and never waited
 * for. Error: STATUS_IO with path and reason. */
MUST_CHECK enum status_code text_read_file(struct text *text, const char *path, struct status *status);
/** Writes `length` bytes to a new file at `path` and checks that they arrived. Error: STATUS_IO. */
MUST_CHECK enum status_code text_write_file(const char *path, const char *bytes, size_t length, struct status *status);
/** Writes a text to the file whose path is given like text_add()'s. Errors: the same, STATUS_MEMORY. */
MUST_CHECK enum status_code text_save(const struct text *text, struct status *status, const char *format, ...)
    PRINTF_LIKE(3, 4);

#endif
