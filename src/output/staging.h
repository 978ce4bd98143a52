/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The hidden directory beside OUT, `.roughcontact-XXXXXX`, in which a report is made. It holds
 *   lock    locked for as long as the process that made it lives
 *   run     a link to nowhere, whose text names the program, the start of its system and OUT: how it knows its own
 *   report  the report in the making; renamed to
 *   done    once it is complete: the report before is there after the exchange
 *   before  the report before, on file systems that cannot exchange
 *   aside   what is looked at before it is removed
 * so that a later run can tell what a killed one has left behind, and clear it away as that would have done. */
#ifndef OUTPUT_STAGING_H
#define OUTPUT_STAGING_H

#include "base/status.h"
#include <limits.h>
#include <stdbool.h>

struct staging {
    char path[PATH_MAX]; /* "" when none */
    int lock;            /* its descriptor; -1: none */
};

/** Makes it beside `target`, with no report in it yet. Error: STATUS_IO. */
MUST_CHECK enum status_code staging_make(struct staging *out, const char *target, struct status *status);

/** Writes the path of the part `name` of it, such as "report". */
void staging_part(char out[static PATH_MAX], const struct staging *staging, const char *name);

/** Removes it with all in it (`whole`), or what is the program's once nothing else is in it. */
void staging_remove(struct staging *staging, bool whole);

/** Leaves it to the next run, with what is in it. */
void staging_leave(struct staging *staging);

/** Removes the report before, now `done` or `before` in the directory `staging`, once nothing in it is the user's:
 * entries that its manifest names or that the report at `target` holds too are removed, others are moved there, in the
 * place of nothing. False when something has to stay. */
bool staging_clear_before(const char *staging, const char *part, const char *target);

/** Clears away what runs that are no more have left beside `target`. It touches nothing that the program did not make,
 * that another user made, whose process may live (on file systems that machines share: that was not made since this
 * one started), or that holds what the program does not know. */
void staging_clear_stale(const char *target);

#endif
