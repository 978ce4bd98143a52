/* Other programs: found in PATH, run without a shell, ended when they take too long or a signal asks to stop. */
#ifndef BASE_PROGRAM_H
#define BASE_PROGRAM_H

#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>

/** Writes the path of the program `name` to `out`, from the absolute elements of PATH only (a child may run in another
 * directory). Is there one? */
bool program_find(char *out, size_t size, const char *name);

/** Runs `arguments` (the first is the program's path, the last NULL) in `directory`, which is its HOME too, without
 * input; what it prints is dropped. It is killed, with what it started, after `seconds` and when one of
 * program_signals() is pending or program_stop() was called. Errors: STATUS_IO: it cannot start, ended with an exit
 * status but 0, or took too long; STATUS_INTERRUPTED. */
MUST_CHECK enum status_code program_run(char *const *arguments, const char *directory, double seconds,
                                        struct status *status);

/** Asks every program that runs to stop, and those to come; may be called by a signal handler. */
void program_stop(void);

/** Holds back the signals that end the program by default (SIGINT, SIGTERM, SIGHUP), in this thread, until they are
 * let through again: what was made for a program to run can be removed before. */
void program_hold_signals(bool hold);

#endif
