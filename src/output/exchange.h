/* SPDX-License-Identifier: GPL-3.0-or-later */
/* OUT is complete or untouched: a report is made in a hidden directory beside it and takes its place in one step. */
#ifndef OUTPUT_EXCHANGE_H
#define OUTPUT_EXCHANGE_H

#include "base/temporary.h"
#include <stddef.h>

/** Names the files of the report, one a line; only these are ever replaced or removed. */
#define OUTPUT_MANIFEST "manifest.txt"
/** Its first line, by which it is told from a file of the user's. */
#define OUTPUT_MANIFEST_HEADER "# the files of this report by roughcontact, which its next run replaces; no others\n"

struct exchange {
    char target[PATH_MAX];   /* OUT */
    char staging[PATH_MAX];  /* where it is being made; "" when none */
    struct temporary hidden; /* which that is a part of: `report`, and `done` once it is complete */
    size_t made;             /* length of the first missing parent of `target` that was made; 0: none */
};

/** Makes the staging directory with data/, figures/ and export/ (which goes if it stays empty) beside `target` (and
 * target's missing parents). What stands at `target` must be nothing, a directory with no more than hidden files, or a
 * report whose manifest.txt names its files. Other files beside those are the user's and stay in OUT. Refused, by name
 * and before any work: a directory of the user's, what is no regular file in the place of one of the report, a mount
 * point. What killed runs have left there is cleared away before.
 * Errors: STATUS_USAGE (`target` is "", . or ..), STATUS_IO. */
MUST_CHECK enum status_code exchange_begin(struct exchange *out, const char *target, struct status *status);

/** Writes the manifest, has the disk take the report, looks at OUT again as exchange_begin() did, gives the report
 * OUT's modes and extended attributes, puts it in place in one step and removes of the one before what its manifest
 * names. The user's files are in both meanwhile, as hard links, so that none is lost at any instant. Error: STATUS_IO;
 * then the earlier report still stands. The one exception: what came to OUT in the instant of the exchange is left in
 * OUT.kept-XXXXXX; the message names it. */
MUST_CHECK enum status_code exchange_commit(struct exchange *out, struct status *status);

/** For temporary_make(): takes out what a killed run has left in its hidden directory; nothing of it comes to OUT. */
void exchange_clear(int hidden);

/** Removes what an output that was not committed has made: the staging directory and the target's parents. Clears
 * `target` of one that had parents made. */
void exchange_abandon(struct exchange *out);

#endif
