/* SPDX-License-Identifier: GPL-3.0-or-later */
/* results.json: everything, streamed surface by surface so that memory does not grow with their number. */
#ifndef OUTPUT_JSON_H
#define OUTPUT_JSON_H

#include "output/record.h"
#include "results/comparison.h"

/** Writes results.json (docs/results.schema.json) into `directory`. Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code json_write(const struct results *results, const struct comparison *comparison,
                                       const json_t *claims, const char *directory, struct status *status);

/** In short, for a script, as in results.json: `refused`, `answers`, `limits`, and the `missed_limits` and
 * `undecided_limits` (or without a value) among them. To be released with json_decref(); NULL: out of memory. */
json_t *json_outline(const struct results *results);

/* Parts of it that the report words too; new. */
json_t *json_material(const struct material *material);
/** What the scene says lies in and around the spots, of the effects that run. */
json_t *json_joint(const struct results *results);

#endif
