/* A growing text: report pages, CSV rows, messages. Owned by whoever declared it; text_free() ends it. */
#ifndef BASE_TEXT_H
#define BASE_TEXT_H

#include "base/status.h"
#include <stdbool.h>
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
/** Bytes of the character at `s` when it is valid UTF-8 that a terminal, HTML and XML may show, else 0. */
size_t text_character(const char *s);
/** Adds `string` as it may be shown: control characters and bytes that are no UTF-8 as '?'. */
void text_add_shown(struct text *text, const char *string);
/** The same, with the characters that mean something in Markdown or HTML escaped. */
void text_add_markdown(struct text *text, const char *string);
/** Adds `size` bytes of plain text for HTML, in an element or a quoted value: what has a meaning there is escaped;
 * control characters and bytes that are no UTF-8 become '?'. `bytes` ends with a whole character or before a NUL. */
void text_add_html(struct text *out, const char *bytes, size_t size);
/** Adds `string` as one CSV field: quoted, with quotes doubled, when it holds a comma, a quote or a line end. */
void text_add_csv(struct text *text, const char *string);
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

#endif
