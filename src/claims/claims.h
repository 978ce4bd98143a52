/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the report says in sentences. Each statement is a row of one table, said where it is so, in words of
 * templates/words.txt; page, terminal and results.json print this list and say nothing else. */
#ifndef CLAIMS_CLAIMS_H
#define CLAIMS_CLAIMS_H

#include "base/words.h"
#include "results/asked.h"
#include "results/comparison.h"

/** The claims of a run, new: objects of `key`, `level`, `surface` (null: of several, or of none), `numbers` (SI),
 * `text`, and `markdown`, the same with its marks and with names escaped. Level after level; within one the largest
 * factor first. Errors: the words' (STATUS_USAGE), STATUS_MEMORY. */
MUST_CHECK enum status_code claims_make(json_t **out, const struct results *results,
                                        const struct comparison *comparison, struct words *words,
                                        struct status *status);

/** The one sentence that answers what was asked: an object of the same kind, new. */
MUST_CHECK enum status_code claims_headline(json_t **out, const struct results *results,
                                            const struct comparison *comparison, struct words *words,
                                            struct status *status);

#endif
