/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One gnuplot process. */
#ifndef CHART_GNUPLOT_H
#define CHART_GNUPLOT_H

#include "base/text.h"
#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>

struct gnuplot {
    pid_t process;       /* 0: none */
    int input;           /* its standard input, a socket */
    bool lost;           /* it did not take all commands */
    FILE *complaints;    /* unnamed file that takes its stderr and stdout */
    double most_seconds; /* that gnuplot_finish() waits */
};

enum { GNUPLOT_PATH = 4096 };
/** gnuplot's path, found in PATH. Error: STATUS_CHART, which names the package. */
MUST_CHECK enum status_code gnuplot_find(char program[GNUPLOT_PATH], struct status *status);

/** Starts gnuplot (no shell) with `directory` as its working directory.
 * Errors: that of gnuplot_find(), STATUS_IO, STATUS_INTERRUPTED. */
MUST_CHECK enum status_code gnuplot_start(struct gnuplot *out, const char *directory, struct status *status);

/** Sends command lines, such as "load 'area.gp'\n", which it carries out while this program goes on. Never waits; what
 * does not go, as to a process that has ended, gnuplot_finish() reports. No SIGPIPE. */
void gnuplot_send(struct gnuplot *gnuplot, const char *commands);

/** Ends the input, waits, and checks: any exit status but 0 and any word on stderr is a failure. It is killed when it
 * takes longer than most_seconds from here on, and when a signal asks to stop (base/program.h).
 * Errors: STATUS_CHART with the first complaint; STATUS_INTERRUPTED. Always releases the process. */
MUST_CHECK enum status_code gnuplot_finish(struct gnuplot *gnuplot, struct status *status);

/** Kills what is not to be finished, and returns how it ended, as waitpid() says; nothing to do: 0. */
int gnuplot_end(struct gnuplot *gnuplot);

/** Adds to `out` a chart that was drawn as text to the file `path`, without the blanks at the ends of its lines
 * (gnuplot fills them up, and beyond the width where a line has letters of several bytes), and removes the file.
 * Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code gnuplot_take_text(struct text *out, const char *path, struct status *status);

#endif
