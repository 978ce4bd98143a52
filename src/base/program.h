/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs other programs: found in PATH, without a shell, ended when they take too long or this program is to stop. */
#ifndef BASE_PROGRAM_H
#define BASE_PROGRAM_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

/** Finds the program `name` in the absolute elements of PATH (a child may run in another directory). False: none. */
bool program_find(char *out, size_t size, const char *name);

/** How a program is started. */
struct program_task {
    char *const *arguments; /* the last is NULL */
    const char *path;       /* of the program */
    const char *directory;  /* where it runs */
    int input, output;      /* descriptors, beyond 2, of its standard input and of both its outputs */
};

/** Starts it in a process group of its own, with default signals and only PATH of the environment, since a user's
 * settings could change its output. It is killed when the thread that started it ends first. Returns 0 or an errno
 * (ECANCELED: this program is to stop). End it with program_end(). */
int program_start(pid_t *process, const struct program_task *task);

enum program_state { PROGRAM_ENDED, PROGRAM_LATE, PROGRAM_STOPPED };

/** Waits until it ends, clock_seconds() passes `until`, or program_stop() is called. */
enum program_state program_wait(pid_t process, double until);

/** Kills it and what it started if they still run. Returns how it ended, as waitpid() does. */
int program_end(pid_t process);

/** Makes every running program stop, and later ones not start. */
void program_stop(void);

#endif
