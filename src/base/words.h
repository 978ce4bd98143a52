/* SPDX-License-Identifier: GPL-3.0-or-later */
/* templates/words.txt: what axes, panels, legends and marks are called, what is asked for, why effects run, what is
 * noted. What several threads note is told as words_add() takes it, and said by one. */
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

/** Words that are told like printf: their name, and a line for each of what fills them in: a name, a blank and its
 * text, or the name alone of what is so. Behind a name and a tab all that follows is its text, line ends too: what
 * comes from outside stands there, still to be shown as such. Texts of one name that comes again are a list. Good as
 * long as `words` lives; NULL: "". */
const char *words_say(struct words *words, const char *format, ...) PRINTF_LIKE(2, 3);
/** Adds the words that `later` tells so, with what fills them in escaped (NULL: as it is). False: not, and the words'
 * status says why. */
bool words_add(struct text *out, struct words *words, const char *later,
               void (*escape)(struct text *out, const char *string));

/** Adds a text in `most` characters: of a longer one the middle is cut, as names often differ at their end. */
void words_cut(struct text *out, const char *string, size_t length, int most);

#endif
