/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "chart/gnuplot.h"
#include "base/clock.h"
#include "base/program.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

/* The charts of a report take a fraction of a second; beyond this, it hangs. */
static const double most_seconds = 120;

/* An unnamed file that takes so many bytes of messages and no more; what was not written is 0. */
static int gnuplot_log(void)
{
    enum { MOST_BYTES = 1 << 16 };
    int log = memfd_create("gnuplot", MFD_CLOEXEC | MFD_ALLOW_SEALING);
    if (log >= 0 && ftruncate(log, MOST_BYTES) == 0 && fcntl(log, F_ADD_SEALS, F_SEAL_GROW) == 0)
        return log;
    if (log >= 0)
        close(log);
    return -1;
}

enum status_code gnuplot_find(char program[GNUPLOT_PATH], struct status *status)
{
    return program_find(program, GNUPLOT_PATH, "gnuplot")
               ? STATUS_OK
               : status_fail(status, STATUS_CHART,
                             "no gnuplot in PATH to draw the charts: install the package gnuplot-nox");
}

enum status_code gnuplot_start(struct gnuplot *out, const char *directory, struct status *status)
{
    *out = (struct gnuplot){.input = -1, .most_seconds = most_seconds};
    static char name[] = "gnuplot", defaults[] = "-d"; /* no start-up files */
    char program[GNUPLOT_PATH], *const arguments[] = {name, defaults, NULL};
    if (gnuplot_find(program, status) != STATUS_OK)
        return status->code;
    int ends[2] = {-1, -1};
    int log = gnuplot_log();
    int error = log < 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0 ||
                        !(out->complaints = fdopen(log, "r"))
                    ? errno
                    : 0;
    if (!error)
        error = program_start(&out->process, &(struct program_task){arguments, program, directory, ends[0], log});
    if (ends[0] >= 0)
        close(ends[0]);
    out->input = ends[1];
    if (!error)
        return STATUS_OK;

    if (log >= 0 && !out->complaints)
        close(log);
    gnuplot_end(out);
    if (error == ECANCELED)
        return status_fail(status, STATUS_INTERRUPTED, "gnuplot was stopped by a signal");
    return status_fail(status, STATUS_IO, "cannot start gnuplot in '%s': %s", directory, status_reason(error));
}

void gnuplot_send(struct gnuplot *gnuplot, const char *command)
{
    size_t left = strlen(command);
    while (left > 0 && !gnuplot->lost) {
        ssize_t sent = send(gnuplot->input, command, left, MSG_NOSIGNAL | MSG_DONTWAIT);
        gnuplot->lost = sent < 0 && errno != EINTR;
        command += sent > 0 ? sent : 0;
        left -= sent > 0 ? (size_t)sent : 0;
    }
}

/* gnuplot repeats the offending command with a caret below before it says what is wrong ("file" line 3: ...); that line
 * is the one to report, else the first with anything on it. */
static void gnuplot_first_complaint(char *out, size_t size, FILE *complaints)
{
    OWNED(memory_free) char *line = NULL;
    size_t capacity = 0;
    out[0] = '\0';
    rewind(complaints);
    while (getline(&line, &capacity, complaints) > 0) {
        const char *text = line + strspn(line, " \t");
        size_t length = strcspn(text, "\r\n");
        const char *where = strstr(text, "line ");
        bool telling = where && strspn(where + 5, "0123456789") > 0;
        if (strncmp(text, "line 0: ", 8) == 0) { /* a command from here, not from a file */
            text += 8;
            length -= 8;
        }
        if (telling || (out[0] == '\0' && length > 0 && *text != '^'))
            snprintf(out, size, "%.*s", (int)length, text);
        if (telling)
            break;
    }
    for (char *c = out; *c; c++)
        if ((unsigned char)*c < 0x20 || *c == 0x7f)
            *c = '?';
}

int gnuplot_end(struct gnuplot *gnuplot)
{
    int how = gnuplot->process > 0 ? program_end(gnuplot->process) : 0;
    if (gnuplot->input >= 0)
        close(gnuplot->input);
    if (gnuplot->complaints)
        fclose(gnuplot->complaints);
    *gnuplot = (struct gnuplot){.input = -1};
    return how;
}

enum status_code gnuplot_finish(struct gnuplot *gnuplot, struct status *status)
{
    double most = gnuplot->most_seconds;
    bool lost = gnuplot->lost;
    shutdown(gnuplot->input, SHUT_WR);
    enum program_state state = program_wait(gnuplot->process, clock_seconds() + most);
    char complaint[512];
    gnuplot_first_complaint(complaint, sizeof complaint, gnuplot->complaints);
    int end = gnuplot_end(gnuplot);
    if (state == PROGRAM_STOPPED)
        return status_fail(status, STATUS_INTERRUPTED, "gnuplot was stopped by a signal");
    if (state == PROGRAM_LATE)
        return status_fail(status, STATUS_CHART,
                           "gnuplot did not end within %g s and was stopped: see whether it runs by itself ('gnuplot "
                           "-d')",
                           most);
    if (complaint[0])
        return status_fail(status, STATUS_CHART, "gnuplot: %s", complaint);
    if (WIFSIGNALED(end) && WTERMSIG(end) == SIGXFSZ)
        return status_fail(status, STATUS_CHART, "gnuplot may not write a file this large (see 'ulimit -f')");
    if (WIFSIGNALED(end))
        return status_fail(status, STATUS_CHART, "gnuplot was ended by signal %d", WTERMSIG(end));
    if (end != 0)
        return status_fail(status, STATUS_CHART, "gnuplot ended with status %d", WEXITSTATUS(end));
    if (lost)
        return status_fail(status, STATUS_CHART, "gnuplot ended before it had read all commands");
    return STATUS_OK;
}

enum status_code gnuplot_take_text(struct text *out, const char *path, struct status *status)
{
    OWNED(text_free) struct text drawn = {0};
    enum status_code code = text_read_file(&drawn, path, status);
    unlink(path);
    for (const char *line = text_string(&drawn); *line;) {
        line += *line == '\f'; /* it ends a page, on a printer */
        size_t length = strcspn(line, "\n"), kept = length;
        while (kept > 0 && line[kept - 1] == ' ')
            kept--;
        text_add_bytes(out, line, kept);
        text_add_bytes(out, "\n", 1);
        line += length + (line[length] == '\n');
    }
    return code;
}
