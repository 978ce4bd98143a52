/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Directories of the program's own, which go when it is made to end, and those of a killed one with the next. Its name,
 * `roughcontact-INODE-DEVICE-HOST-XXXXXX`, says where it was made, so that no archive and no copy is taken for one; it
 * is locked for as long as its process lives. */
#ifndef BASE_TEMPORARY_H
#define BASE_TEMPORARY_H

#include "base/status.h"
#include <limits.h>

struct temporary {
    char path[PATH_MAX];    /* "": none */
    int directory;          /* its descriptor, which holds the lock */
    struct temporary *next; /* of those that go when the program is made to end */
};

/** Makes one of mode 0700 in TMPDIR or, with a dot before its name, in `parent`; it is not to be moved in memory.
 * Before, clear() takes out what processes of this user that are no more have left in theirs (NULL: all goes), which
 * then go if they are empty, else lose the dot that hides them. Error: STATUS_IO, with errno. */
MUST_CHECK enum status_code temporary_make(struct temporary *out, const char *parent, void (*clear)(int directory),
                                           struct status *status);
/** Removes it if nothing is in it; else it stays, also when the program is made to end. */
void temporary_close(struct temporary *temporary);
/** Removes it with all in it. */
void temporary_remove(struct temporary *temporary);
/** Removes an entry of the open directory, with all in it; follows no link. */
void temporary_remove_entry(int directory, const char *name);

/** The open directory `name` in `parent`, reached through no link; -1: errno says why not. */
int temporary_open(int parent, const char *name);

/** What to tell when the program is made to end, such as "'out' is as it was before" of `what`. */
void temporary_note(const char *before, const char *what, const char *after);
/** Between these two the program is not made to end, but where they take too long. May be nested. */
void temporary_hold(void);
void temporary_release(void);
/** Removes all of them, while others may still be writing there, and returns the note. Holds, and never releases: the
 * program has to end now. */
const char *temporary_end(void);

#endif
