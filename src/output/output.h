/* OUT is complete or untouched: a report is made in a hidden directory beside it and takes its place in one step. */
#ifndef OUTPUT_OUTPUT_H
#define OUTPUT_OUTPUT_H

#include "base/status.h"
#include <limits.h>
#include <stddef.h>

struct output {
    char target[PATH_MAX];  /* OUT */
    char staging[PATH_MAX]; /* where it is being made; "" when none */
    size_t made;            /* length of the first missing parent of `target` that was made; 0: none */
};

/** Makes the staging directory with data/ and figures/ beside `target` (and target's missing parents). What stands at
 * `target` must be an earlier report, an empty directory or nothing: anything else is refused, so that no file of the
 * user's is lost. Errors: STATUS_USAGE (`target` is "", . or ..), STATUS_IO. */
MUST_CHECK enum status_code output_begin(struct output *out, const char *target, struct status *status);

/** Puts the finished report in place and removes the one before. Error: STATUS_IO; then the earlier report still
 * stands. */
MUST_CHECK enum status_code output_commit(struct output *out, struct status *status);

/** Removes what an output that was not committed has made: the staging directory and the target's parents. Clears
 * `target` of one that had parents made. */
void output_abandon(struct output *out);

#endif
