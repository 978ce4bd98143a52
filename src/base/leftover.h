/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What must not outlive the program, however it ends: directories that are in the making, and what is true of OUT then.
 * Safe from any thread; costs nothing until the program is made to end. */
#ifndef BASE_LEFTOVER_H
#define BASE_LEFTOVER_H

#include <stdbool.h>
#include <stddef.h>

/** Notes a directory that goes, with all in it, should the program be made to end. Returns its number for
 * leftover_forget(); 0: it could not be noted. */
size_t leftover_add(const char *directory);
void leftover_forget(size_t number);

/** Makes a directory as mkdtemp() does and notes it, so that no end of the program comes between. False: errno. */
bool leftover_make(char *directory, size_t *number);

/** Removes a file or a directory with all in it, as far as that can be; follows no link, put there when it may be. */
void leftover_remove(const char *path);

/** What to tell when the program is made to end, such as "'out' is as it was before"; "": nothing. Between
 * leftover_hold() and leftover_release() only. */
void leftover_note(const char *note);

/** Between these two nothing is cleared away: what is done there is done whole, or not begun. May be nested. */
void leftover_hold(void);
void leftover_release(void);

/** Removes every noted directory, while others may still be writing there, and returns the note. Holds, and never
 * releases: the program has to end now. */
const char *leftover_clear(void);

#endif
