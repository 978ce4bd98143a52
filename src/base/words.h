/* SPDX-License-Identifier: GPL-3.0-or-later */
/* templates/words.txt: names of axes, panels and legends, reasons of effects, notes. Threads note what words_add()
 * takes; one thread makes the text of it. */
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

/** The text of a line of words.txt. The format is as printf's: the line's name, then a line for each value that fills
 * it in: name, blank, text; a name alone is true. Behind a name and a tab all the rest is its text, line ends too: text
 * from outside stands there. A name that comes again makes a list. Lives as long as `words`; NULL: "". */
const char *words_say(struct words *words, const char *format, ...) PRINTF_LIKE(2, 3);
/** Adds the text of `later`, in the same form, its values escaped (NULL: not). False: the words' status says why. */
bool words_add(struct text *out, struct words *words, const char *later,
               void (*escape)(struct text *out, const char *string));

/** The same of a name, which a line may end, and the view it is filled from. */
bool words_fill(struct text *out, struct words *words, const char *name, const json_t *view,
                void (*escape)(struct text *out, const char *string));

/** Adds a text in `most` characters. Of a longer one the middle is cut, since names often differ at their end. */
void words_cut(struct text *out, const char *string, size_t length, int most);

#endif
