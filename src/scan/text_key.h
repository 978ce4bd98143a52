/* Keys with values in the lines above the numbers: spacing, size and units. */
#ifndef SCAN_TEXT_KEY_H
#define SCAN_TEXT_KEY_H

#include "scan/text_header.h"

/** Takes over what `line` says, as the members of struct text_header describe it. Does a key of it name a unit, or what
 * is measured? */
bool text_key_read(struct text_header *header, struct span line);

/** The unit of length or of slope that `word` is, as the program prints it; NULL when it is none. */
const char *text_key_unit(struct span word);

/** Cuts the next word off `rest`; *before is the separator in front of it that says most: a bracket or a slash, else
 * the first that is no blank, else a blank or 0. */
bool text_key_word(struct span *rest, struct span *word, char *before);
/** Does `word` begin with a number? */
bool text_key_number(struct span word);

#endif
