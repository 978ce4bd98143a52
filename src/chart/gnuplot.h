/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One gnuplot process. */
#ifndef CHART_GNUPLOT_H
#define CHART_GNUPLOT_H

#include "base/text.h"
#include <stdio.h>
#include <sys/types.h>

struct gnuplot {
    pid_t process;
    int input;           /* its standard input; takes what it can without waiting */
    struct text unsent;  /* commands that are still to go there */
    size_t sent;         /* bytes of those that went */
    FILE *complaints;    /* unnamed file that takes its stderr and stdout */
    double most_seconds; /* gnuplot_finish() waits for it; gnuplot_start() sets gnuplot_most_seconds */
    double seconds;      /* wall time from the first command to its end, set by gnuplot_finish() */
};

/** The charts of a report take a fraction of a second; beyond this, it hangs. */
extern const double gnuplot_most_seconds;

/** Is there a gnuplot in PATH? Error: STATUS_CHART with the package to install. */
MUST_CHECK enum status_code gnuplot_check(struct status *status);

/** Starts gnuplot (found in PATH, no shell) with `directory` as its working directory.
 * Errors: STATUS_CHART (not installed: names the package), STATUS_IO, STATUS_INTERRUPTED. */
MUST_CHECK enum status_code gnuplot_start(struct gnuplot *out, const char *directory, struct status *status);

/** Sends one line, e.g. gnuplot_send(g, "load '%s.gp'", name), and never waits. A dead process is reported by
 * gnuplot_finish() and raises no SIGPIPE. */
void gnuplot_send(struct gnuplot *gnuplot, const char *format, ...) PRINTF_LIKE(2, 3);

/** Ends the input, waits, and checks: any exit status but 0 and any word on stderr is a failure. It is killed when it
 * takes longer than most_seconds from here on, and when a signal asks to stop (base/program.h).
 * Errors: STATUS_CHART with the first complaint; STATUS_INTERRUPTED; STATUS_MEMORY. Always releases the process. */
MUST_CHECK enum status_code gnuplot_finish(struct gnuplot *gnuplot, struct status *status);

/** Adds to `out` a chart that was drawn as text to the file `path`, without the blanks at the ends of its lines
 * (gnuplot fills them up, and beyond the width where a line has letters of several bytes), and removes the file.
 * Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code gnuplot_take_text(struct text *out, const char *path, struct status *status);

#endif
