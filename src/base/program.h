/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Other programs: found in PATH, run without a shell, ended when they take too long or a signal asks to stop. */
#ifndef BASE_PROGRAM_H
#define BASE_PROGRAM_H

#include "base/status.h"
#include <signal.h>
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
    char *const *environment;
    int input, output; /* descriptors of its standard input and of both its outputs */
};

/** Starts it in a process group of its own, with the usual signals and, where the limits allow, the usual stack. It is
 * killed when the thread that started it ends before it. Returns 0 or the errno that says why not (ECANCELED: it was
 * asked to stop). To be ended by program_end(). */
int program_start(pid_t *process, const struct program_task *task);

enum program_state { PROGRAM_RUNS, PROGRAM_ENDED, PROGRAM_LATE, PROGRAM_STOPPED };

/** Waits until it ends by itself, clock_seconds() passes `until`, or it is asked to stop. With a `descriptor` (else -1)
 * it comes back, with PROGRAM_RUNS, as soon as that can be written too. */
enum program_state program_wait(pid_t process, double until, int descriptor);

/** Kills what still runs of it and of what it started, and returns how it ended, as waitpid() says. */
int program_end(pid_t process);

/** Runs `arguments` (the first is the program's path, the last NULL) in `directory`, which is its HOME too, without
 * input; what it prints is dropped. It is killed, with what it started, after `seconds` and when one of
 * program_ending_signals() is pending or program_stop() was called. Errors: STATUS_IO: it cannot start, ended with an
 * exit status but 0, or took too long; STATUS_INTERRUPTED. */
MUST_CHECK enum status_code program_run(char *const *arguments, const char *directory, double seconds,
                                        struct status *status);

/** Asks every program that runs to stop, and those to come. */
void program_stop(void);

/** Kills every program that runs, at once, and waits a moment for them to be gone. After program_stop(). */
void program_kill(void);

/** The signals by which a program is asked to end: SIGINT, SIGTERM, SIGHUP, but those that whoever started this one
 * wants ignored (as nohup does). */
void program_ending_signals(sigset_t *out);

/** Holds them back in this thread until program_let_signals(before): what was made for a program to run can be removed
 * before. */
void program_hold_signals(sigset_t *before);
void program_let_signals(const sigset_t *before);

#endif
