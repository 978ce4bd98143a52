/* results.json: everything, streamed surface by surface so that memory does not grow with their number. */
#ifndef OUTPUT_JSON_H
#define OUTPUT_JSON_H

#include "results/results.h"

/** Writes results.json into `directory`. Errors: STATUS_IO, STATUS_MEMORY, STATUS_NUMBER. */
MUST_CHECK enum status_code json_write(const struct results *results, const char *directory, struct status *status);

#endif
