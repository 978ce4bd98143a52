/* Numbers and names as the report prints them. */
#ifndef REPORT_WORDS_H
#define REPORT_WORDS_H

#include "base/text.h"
#include "results/tables.h"

/** `value` with `digits` significant digits: plain between 0.001 and 10000, else as 1.2·10⁻⁵; "–" when not finite. */
void words_number(struct text *out, double value, int digits);
/** Name of surface `index`, escaped for Markdown. */
void words_surface(struct text *out, const struct results *results, size_t index);
/** "least to most", or one number when both are the same to the digits shown. */
void words_range(struct text *out, double least, double most, int digits);

#endif
