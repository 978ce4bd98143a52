/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How a signal ends the program: in order where it soon comes to that, else at once, and never with anything left. */
#ifndef CLI_SIGNALS_H
#define CLI_SIGNALS_H

#include <stdatomic.h>
#include <stdbool.h>

/** Runs the program, `body`, on a thread of its own and returns its exit status. SIGINT, SIGTERM and SIGHUP (those that
 * are not ignored) are taken by the thread that calls, so that nothing the other does can delay them: on the first one
 * the other programs that run are stopped, and once the body has had the time that it asked for, or on the second one,
 * everything of base/temporary.h is removed, one line says so, and the program ends by that signal; so it does as well
 * where the body returns after one. Before: standard streams that are closed become ones that cannot be used, so that
 * no file takes their numbers, and files too large for the limits become errors. */
int signals_run(int (*body)(int argc, char **argv), int argc, char **argv);

/** Becomes true when a signal has come. Whoever asks for it looks at it, and gets `milliseconds` from then on to
 * end in order; else there are none. */
const atomic_bool *signals_stop(int milliseconds);

/** For the end of a body that must not return, as it has something to take down: the exit status that stands for
 * the signal that has come, else `exit_status`. */
int signals_status(int exit_status);

/** Is it for the caller to say that a signal has come? True once, false from then on. Of several processes, those that
 * are not to speak call it first. */
bool signals_first_word(void);

#endif
