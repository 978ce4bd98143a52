/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Other programs: found in PATH, run without a shell, ended when they take too long or this one is asked to stop. */
#ifndef BASE_PROGRAM_H
#define BASE_PROGRAM_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

/** Writes the path of the program `name` to `out`, from the absolute elements of PATH only (a child may run in another
 * directory). Is there one? */
bool program_find(char *out, size_t size, const char *name);

/** How a program is started. */
struct program_task {
    char *const *arguments; /* the last is NULL */
    const char *path;       /* of the program */
    const char *directory;  /* where it runs */
    int input, output;      /* descriptors, beyond 2, of its standard input and of both its outputs */
};

/** Starts it in a process group of its own, with the usual signals, and of the environment with PATH alone, as a user's
 * settings would change what it does. It is killed when the thread that started it ends before it. Returns 0 or the
 * errno that says why not (ECANCELED: it was asked to stop). To be ended by program_end(). */
int program_start(pid_t *process, const struct program_task *task);

enum program_state { PROGRAM_ENDED, PROGRAM_LATE, PROGRAM_STOPPED };

/** Waits until it ends by itself, clock_seconds() passes `until`, or program_stop() was called. */
enum program_state program_wait(pid_t process, double until);

/** Kills what still runs of it and of what it started, and returns how it ended, as waitpid() says. */
int program_end(pid_t process);

/** Asks every program that runs to stop, and those to come. */
void program_stop(void);

#endif
