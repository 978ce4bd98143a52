/* SPDX-License-Identifier: GPL-3.0-or-later */
/* templates/words.txt: what axes, panels, legends and marks are called, what is asked for, why effects run. */
#ifndef BASE_WORDS_H
#define BASE_WORDS_H

#include "base/text.h"
#include <jansson.h>

/** A line a name: its words. Owned: words_free(). */
struct words {
    struct text file;
    json_t *said; /* keeps what words_say() gave out */
    struct status *status;
};

/** Reads the words of a folder of templates. Errors, here and later in `status`: STATUS_IO, STATUS_USAGE (a name that
 * is not there, words that are no template), STATUS_MEMORY. End it with words_free() whatever comes back. */
MUST_CHECK enum status_code words_read(struct words *out, const char *templates, struct status *status);
void words_free(struct words *words);

/** The words of `name`, filled in from names and texts in turn, the last NULL: as long as `words` lives. What came
 * from outside is still to be shown as such. Where there are none, `words` NULL, the name stands for them. */
const char *words_say(struct words *words, const char *name, ...) __attribute__((sentinel));
/** A number to fill in, as printf writes it. */
struct words_number {
    char text[32];
};
struct words_number words_number(const char *format, ...) PRINTF_LIKE(1, 2);

/** Characters of a text. */
int words_width(const char *string, size_t length);
/** Adds a text in `most` characters: of a longer one the middle is cut, as names often differ at their end. */
void words_cut(struct text *out, const char *string, size_t length, int most);

#endif
