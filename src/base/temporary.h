/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Temporary directories, removed when the program is made to end; those of a killed program by the next one. The name,
 * `roughcontact-INODE-DEVICE-HOST-XXXXXX`, tells the original from a copy; a lock tells that its process lives. */
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
 * Before, clear() empties those that dead processes of this user left (NULL: all of it); empty ones are then removed,
 * others lose the dot that hides them. Error: STATUS_IO, with errno. */
MUST_CHECK enum status_code temporary_make(struct temporary *out, const char *parent, void (*clear)(int directory),
                                           struct status *status);
/** Removes it if it is empty; else it stays, also when the program is made to end. */
void temporary_close(struct temporary *temporary);
/** Removes it with its contents. */
void temporary_remove(struct temporary *temporary);
/** Removes an entry of the open directory with its contents; follows no link. */
void temporary_remove_entry(int directory, const char *name);

/** Opens the directory `name` in `parent`, which may be no link; -1: errno says why not. */
int temporary_open(int parent, const char *name);

/** What is printed when the program is made to end, such as "'out' is as it was before" of `what`. */
void temporary_note(const char *before, const char *what, const char *after);
/** Between these two the program is not made to end unless they take too long. May be nested. */
void temporary_hold(void);
void temporary_release(void);
/** Removes all of them, even while others write there, and returns the note. It holds and never releases: the program
 * must end now. */
const char *temporary_end(void);

#endif
