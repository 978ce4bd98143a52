/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "chart/gnuplot.h"
#include "base/clock.h"
#include "base/program.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

const double gnuplot_most_seconds = 120;

static enum status_code gnuplot_need(char *program, size_t size, struct status *status)
{
    if (program_find(program, size, "gnuplot"))
        return STATUS_OK;
    return status_fail(status, STATUS_CHART, "no gnuplot in PATH to draw the charts: install the package gnuplot-nox");
}

enum status_code gnuplot_check(struct status *status)
{
    char program[4096];
    return gnuplot_need(program, sizeof program, status);
}

/* Runs `gnuplot -d` (no start-up files) in `directory`. Returns 0 or the errno that says why not. */
static int gnuplot_spawn(pid_t *process, const char *program, const char *directory, int input, int output)
{
    static char name[] = "gnuplot", defaults[] = "-d";
    char *const arguments[] = {name, defaults, NULL};
    return program_start(process, &(struct program_task){arguments, program, directory, NULL, input, output});
}

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

enum status_code gnuplot_start(struct gnuplot *out, const char *directory, struct status *status)
{
    *out = (struct gnuplot){.input = -1, .most_seconds = gnuplot_most_seconds};
    char program[4096];
    enum status_code code = gnuplot_need(program, sizeof program, status);
    if (code)
        return code;
    int ends[2] = {-1, -1};
    int log = gnuplot_log();
    int error = log < 0 || pipe2(ends, O_CLOEXEC) != 0 || fcntl(ends[1], F_SETFL, O_NONBLOCK) != 0 ||
                        !(out->complaints = fdopen(log, "r"))
                    ? errno
                    : 0;
    if (!error)
        error = gnuplot_spawn(&out->process, program, directory, ends[0], log);
    if (ends[0] >= 0)
        close(ends[0]);
    out->input = ends[1];
    if (!error)
        return STATUS_OK;

    if (ends[1] >= 0)
        close(ends[1]);
    if (out->complaints)
        fclose(out->complaints);
    else if (log >= 0)
        close(log);
    *out = (struct gnuplot){.input = -1};
    if (error == ECANCELED)
        return status_fail(status, STATUS_INTERRUPTED, "gnuplot was stopped by a signal");
    return status_fail(status, STATUS_IO, "cannot start gnuplot in '%s': %s", directory, strerror(error));
}

/* A write to a process that has ended raises SIGPIPE, whose default would end this one. It is held back on this thread
 * while writing, and taken off the queue if it came from here; the program's own handling of it stays as it was. */
struct pipe_guard {
    sigset_t before;
    bool pending;
};

static void pipe_guard_begin(struct pipe_guard *guard)
{
    sigset_t broken, waiting;
    sigpending(&waiting);
    guard->pending = sigismember(&waiting, SIGPIPE) == 1;
    sigemptyset(&broken);
    sigaddset(&broken, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &broken, &guard->before);
}

static void pipe_guard_end(const struct pipe_guard *guard)
{
    const struct timespec at_once = {0};
    sigset_t broken;
    sigemptyset(&broken);
    sigaddset(&broken, SIGPIPE);
    if (!guard->pending)
        while (sigtimedwait(&broken, NULL, &at_once) < 0 && errno == EINTR)
            ;
    pthread_sigmask(SIG_SETMASK, &guard->before, NULL);
}

/* Writes what the pipe takes now. False when there is nobody to read it. */
static bool gnuplot_push(struct gnuplot *gnuplot)
{
    struct pipe_guard guard;
    bool alive = true;
    pipe_guard_begin(&guard);
    while (alive && gnuplot->sent < gnuplot->unsent.length) {
        ssize_t written =
            write(gnuplot->input, gnuplot->unsent.data + gnuplot->sent, gnuplot->unsent.length - gnuplot->sent);
        if (written < 0 && errno == EAGAIN)
            break;
        if (written >= 0)
            gnuplot->sent += (size_t)written;
        else
            alive = errno == EINTR;
    }
    pipe_guard_end(&guard);
    return alive;
}

void gnuplot_send(struct gnuplot *gnuplot, const char *format, ...)
{
    if (gnuplot->seconds == 0.0)
        gnuplot->seconds = clock_seconds(); /* the moment of the first command, until gnuplot_finish() */
    char *line;
    va_list args;
    va_start(args, format);
    int length = vasprintf(&line, format, args);
    va_end(args);
    if (length < 0) {
        gnuplot->unsent.failed = true;
        return;
    }
    text_add_bytes(&gnuplot->unsent, line, (size_t)length);
    text_add_bytes(&gnuplot->unsent, "\n", 1);
    free(line);
    (void)gnuplot_push(gnuplot); /* gnuplot_finish() looks whether all was read */
}

/* gnuplot repeats the offending command with a caret below before it says what is wrong ("file" line 3: ...); that line
 * is the one to report, else the first with anything on it. */
static void gnuplot_first_complaint(char *out, size_t size, FILE *complaints)
{
    char *line = NULL;
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
    free(line);
    for (char *c = out; *c; c++)
        if ((unsigned char)*c < 0x20 || *c == 0x7f)
            *c = '?';
}

/* Sends the rest and waits for the end. */
static enum program_state gnuplot_wait(struct gnuplot *gnuplot, bool *lost)
{
    double until = clock_seconds() + gnuplot->most_seconds;
    enum program_state state = PROGRAM_RUNS;
    *lost = !gnuplot_push(gnuplot);
    while (state == PROGRAM_RUNS && !*lost && gnuplot->sent < gnuplot->unsent.length) {
        state = program_wait(gnuplot->process, until, gnuplot->input);
        if (state == PROGRAM_RUNS)
            *lost = !gnuplot_push(gnuplot);
    }
    *lost |= gnuplot->sent < gnuplot->unsent.length;
    close(gnuplot->input);
    return state == PROGRAM_RUNS ? program_wait(gnuplot->process, until, -1) : state;
}

enum status_code gnuplot_finish(struct gnuplot *gnuplot, struct status *status)
{
    bool lost, whole = !gnuplot->unsent.failed;
    double most = gnuplot->most_seconds;
    enum program_state state = gnuplot_wait(gnuplot, &lost);
    int end = program_end(gnuplot->process);
    double seconds = gnuplot->seconds > 0.0 ? clock_seconds() - gnuplot->seconds : 0.0;
    char complaint[512];
    gnuplot_first_complaint(complaint, sizeof complaint, gnuplot->complaints);
    fclose(gnuplot->complaints);
    text_free(&gnuplot->unsent);
    *gnuplot = (struct gnuplot){.input = -1, .seconds = seconds};

    if (!whole)
        return status_memory(status);
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
    struct text drawn = {0};
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
    text_free(&drawn);
    return code == STATUS_OK && out->failed ? status_memory(status) : code;
}
