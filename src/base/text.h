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
/* One rule for text from outside: control characters, bytes that are no UTF-8, and characters that are invisible or
 * reorder others (bidirectional controls, zero widths, fillers, tags) are written out, as \x1b, \u202e or \U000e0041. A
 * backslash that would look like one of these is doubled, so that texts that differ are shown differently. */

/** Bytes of the character at `s` if it is valid UTF-8 that may be shown, else 0. */
size_t text_character(const char *s);
/** How many bytes of `string`, up to `most`, end with a whole character. */
size_t text_fit(const char *string, size_t most);
/** What is shown for the character (or byte) at `s`, not the final NUL, and how many bytes it has there. */
struct text_shown {
    char text[12];
    size_t bytes;
};
struct text_shown text_show(const char *s);
/** Adds `string` as it may be shown. */
void text_add_shown(struct text *text, const char *string);
/** Adds a shown text with the characters escaped that have a meaning in Markdown or HTML. */
void text_add_markdown_shown(struct text *text, const char *string);
/** Adds a shown text so that text_strip_marks() leaves it as it is. */
void text_add_unmarked(struct text *text, const char *string);
/** Removes the marks of Markdown (* and `). */
void text_strip_marks(struct text *text);
/** Adds `size` bytes of plain text for an element or a quoted value of HTML. Line ends and tabs stay; what else may not
 * be shown is written out, but no backslash is doubled. `bytes` ends with a whole character or before a NUL. */
void text_add_html(struct text *out, const char *bytes, size_t size);
/** Adds `string`, as it may be shown, as one CSV field: an apostrophe before what a spreadsheet would calculate, also
 * behind a semicolon; quoted where it holds a comma, a semicolon or a quote. */
void text_add_csv(struct text *text, const char *string);
/** How many characters of UTF-8 the first `length` bytes, or a whole string, have. */
int text_width(const char *string, size_t length);
int text_characters(const char *string);
/** Adds `string` in lines of at most `width` characters, the second and later ones indented. */
void text_add_wrapped(struct text *text, const char *string, int width, int indent);
/** Removes repeated empty lines, those at the beginning, and blanks at line ends. */
void text_squeeze(struct text *text);
/** The text so far, never NULL. */
const char *text_string(const struct text *text);
void text_free(struct text *text);

/** Reads the rest of `file`, called `name` in messages, up to LIMIT_FILE_BYTES. Error: STATUS_IO. */
MUST_CHECK enum status_code text_read_stream(struct text *text, FILE *file, const char *name, struct status *status);
/** Reads a whole regular file (NUL allowed); a pipe, a device or a directory is refused without waiting. Error:
 * STATUS_IO with path and reason. */
MUST_CHECK enum status_code text_read_file(struct text *text, const char *path, struct status *status);
/** Writes `length` bytes to the file at `path`. Error: STATUS_IO. */
MUST_CHECK enum status_code text_write_file(const char *path, const char *bytes, size_t length, struct status *status);
/** Writes a text to the file whose path is given as by printf(). Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code text_save(const struct text *text, struct status *status, const char *format, ...)
    PRINTF_LIKE(3, 4);

#endif
