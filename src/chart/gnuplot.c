#include "chart/gnuplot.h"
#include "base/program.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern char **environ;

static double monotonic_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

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

/* Variables through which a user's setup would change charts or messages. */
static const char *const foreign_variables[] = {"GNU", "LC_", "LANG", "GDFONTPATH", "FIT_", "DUMB"};

static bool gnuplot_is_foreign(const char *variable)
{
    for (size_t i = 0; i < sizeof foreign_variables / sizeof *foreign_variables; i++)
        if (strncmp(variable, foreign_variables[i], strlen(foreign_variables[i])) == 0)
            return true;
    return false;
}

/* The environment without the foreign variables; the strings stay environ's. NULL when out of memory. */
static char **gnuplot_environment(void)
{
    static char locale[] = "LC_ALL=C.UTF-8";
    size_t count = 0, kept = 0;
    while (environ[count])
        count++;
    char **clean = calloc(count + 2, sizeof *clean);
    if (!clean)
        return NULL;
    for (size_t i = 0; i < count; i++)
        if (!gnuplot_is_foreign(environ[i]))
            clean[kept++] = environ[i];
    clean[kept] = locale;
    return clean;
}

/* Runs `program -d` (no start-up files) in `directory`. Returns 0 or the errno that says why not. */
static int gnuplot_spawn(pid_t *process, const char *program, const char *directory, int input, int output)
{
    char **environment = gnuplot_environment();
    if (!environment)
        return ENOMEM;
    char name[] = "gnuplot", defaults[] = "-d";
    char *const arguments[] = {name, defaults, NULL};
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    sigset_t none, usual;
    sigemptyset(&none);
    sigemptyset(&usual);
    sigaddset(&usual, SIGPIPE);

    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    int error = posix_spawn_file_actions_addchdir_np(&actions, directory);
    if (!error)
        error = posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    if (!error)
        error = posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    if (!error)
        error = posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
    if (!error)
        error = posix_spawnattr_setsigmask(&attributes, &none);
    if (!error)
        error = posix_spawnattr_setsigdefault(&attributes, &usual);
    if (!error)
        error = posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    if (!error)
        error = posix_spawn(process, program, &actions, &attributes, arguments, environment);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    free(environment);
    return error;
}

enum status_code gnuplot_start(struct gnuplot *out, const char *directory, struct status *status)
{
    *out = (struct gnuplot){0};
    char program[4096];
    enum status_code code = gnuplot_need(program, sizeof program, status);
    if (code)
        return code;
    int ends[2] = {-1, -1};
    int log = memfd_create("gnuplot", MFD_CLOEXEC);
    int error = log < 0 || pipe2(ends, O_CLOEXEC) != 0 ? errno : 0;
    if (!error)
        error = gnuplot_spawn(&out->process, program, directory, ends[0], log);
    if (ends[0] >= 0)
        close(ends[0]);
    if (!error && (!(out->commands = fdopen(ends[1], "w")) || !(out->complaints = fdopen(log, "r"))))
        error = errno;
    if (!error)
        return STATUS_OK;

    if (out->commands)
        fclose(out->commands);
    else if (ends[1] >= 0)
        close(ends[1]);
    if (log >= 0)
        close(log);
    if (out->process > 0)
        while (waitpid(out->process, NULL, 0) < 0 && errno == EINTR)
            ;
    *out = (struct gnuplot){0};
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

void gnuplot_send(struct gnuplot *gnuplot, const char *format, ...)
{
    if (gnuplot->seconds == 0.0)
        gnuplot->seconds = monotonic_seconds(); /* the moment of the first command, until gnuplot_finish() */
    struct pipe_guard guard;
    pipe_guard_begin(&guard);
    va_list args;
    va_start(args, format);
    vfprintf(gnuplot->commands, format, args);
    va_end(args);
    fputc('\n', gnuplot->commands);
    fflush(gnuplot->commands); /* it draws while the next line is made */
    pipe_guard_end(&guard);
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

enum status_code gnuplot_finish(struct gnuplot *gnuplot, struct status *status)
{
    struct pipe_guard guard;
    pipe_guard_begin(&guard);
    bool lost = ferror(gnuplot->commands) != 0;
    lost |= fclose(gnuplot->commands) != 0;
    pipe_guard_end(&guard);
    int end = 0;
    while (waitpid(gnuplot->process, &end, 0) < 0 && errno == EINTR)
        ;
    double seconds = gnuplot->seconds > 0.0 ? monotonic_seconds() - gnuplot->seconds : 0.0;
    char complaint[512];
    gnuplot_first_complaint(complaint, sizeof complaint, gnuplot->complaints);
    fclose(gnuplot->complaints);
    *gnuplot = (struct gnuplot){.seconds = seconds};

    if (complaint[0])
        return status_fail(status, STATUS_CHART, "gnuplot: %s", complaint);
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

/* `string` between two `mark`s; the characters `special` come out as `instead` at the same place. */
static void gnuplot_enclose(char *out, size_t size, const char *string, char mark, const char *special,
                            const char *const *instead)
{
    if (size < 3) { /* no room for the two marks */
        if (size > 0)
            out[0] = '\0';
        return;
    }
    size_t used = 0;
    out[used++] = mark;
    while (*string) {
        size_t length = text_character(string);
        const char *found = length == 1 ? strchr(special, *string) : NULL;
        const char *from = found ? instead[found - special] : length ? string : "?";
        size_t bytes = found ? strlen(from) : length ? length : 1;
        if (used + bytes + 2 > size)
            break;
        memcpy(out + used, from, bytes);
        used += bytes;
        string += length ? length : 1;
    }
    out[used++] = mark;
    out[used] = '\0';
}

void gnuplot_field(char *out, size_t size, const char *string)
{
    static const char *const instead[] = {"'", "\\\\"};
    gnuplot_enclose(out, size, string, '"', "\"\\", instead);
}
