#include "base/program.h"
#include "base/clock.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern char **environ;

static volatile sig_atomic_t stop; /* a signal handler can reach nothing but a global */

bool program_find(char *out, size_t size, const char *name)
{
    const char *path = getenv("PATH");
    while (path && *path) {
        size_t length = strcspn(path, ":");
        int written = snprintf(out, size, "%.*s/%s", (int)length, path, name);
        struct stat info;
        if (*path == '/' && written > 0 && (size_t)written < size && access(out, X_OK) == 0 && stat(out, &info) == 0 &&
            S_ISREG(info.st_mode))
            return true;
        path += length + (path[length] == ':');
    }
    return false;
}

void program_stop(void)
{
    stop = 1;
}

static sigset_t ending_signals(void)
{
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    sigaddset(&signals, SIGHUP);
    return signals;
}

void program_hold_signals(bool hold)
{
    sigset_t signals = ending_signals();
    pthread_sigmask(hold ? SIG_BLOCK : SIG_UNBLOCK, &signals, NULL);
}

static bool is_asked_to_stop(void)
{
    sigset_t pending;
    return stop || (sigpending(&pending) == 0 &&
                    (sigismember(&pending, SIGINT) || sigismember(&pending, SIGTERM) || sigismember(&pending, SIGHUP)));
}

/* The environment with another HOME; the other strings stay environ's. NULL: out of memory. */
static char **environment_with(char *home)
{
    size_t count = 0, kept = 0;
    while (environ[count])
        count++;
    char **own = calloc(count + 2, sizeof *own);
    if (!own)
        return NULL;
    for (size_t i = 0; i < count; i++)
        if (strncmp(environ[i], "HOME=", 5) != 0)
            own[kept++] = environ[i];
    own[kept] = home;
    return own;
}

/* A process group of its own, so that what it starts ends with it. Returns 0 or the errno that says why not. */
static int spawn(pid_t *process, char *const *arguments, const char *directory, char *const *environment)
{
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    sigset_t none, usual = ending_signals();
    sigemptyset(&none);
    sigaddset(&usual, SIGPIPE);
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    int error = posix_spawn_file_actions_addchdir_np(&actions, directory);
    if (!error)
        error = posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (!error)
        error = posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    if (!error)
        error = posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    if (!error)
        error = posix_spawnattr_setpgroup(&attributes, 0);
    if (!error)
        error = posix_spawnattr_setsigmask(&attributes, &none);
    if (!error)
        error = posix_spawnattr_setsigdefault(&attributes, &usual);
    if (!error)
        error = posix_spawnattr_setflags(&attributes,
                                         POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    if (!error)
        error = posix_spawn(process, arguments[0], &actions, &attributes, arguments, environment);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

/* Waits until it ends, or for as long as it may run; its id stays taken. Has it ended by itself? */
static bool await(pid_t process, double until)
{
    const struct timespec pause = {0, 5000000};
    for (;;) {
        siginfo_t info = {.si_pid = 0};
        int failed = waitid(P_PID, (id_t)process, &info, WEXITED | WNOHANG | WNOWAIT);
        if (!failed && info.si_pid == process)
            return true;
        if ((failed && errno != EINTR) || is_asked_to_stop() || clock_seconds() > until)
            return false;
        nanosleep(&pause, NULL);
    }
}

enum status_code program_run(char *const *arguments, const char *directory, double seconds, struct status *status)
{
    pid_t process;
    int how = 0, error = ENOMEM;
    char *home = NULL;
    if (asprintf(&home, "HOME=%s", directory) < 0)
        return status_memory(status);
    char **environment = environment_with(home);
    if (environment)
        error = spawn(&process, arguments, directory, environment);
    free(environment);
    free(home);
    if (error)
        return status_fail(status, STATUS_IO, "cannot start '%s': %s", arguments[0], strerror(error));
    const char *slash = strrchr(arguments[0], '/'), *name = slash ? slash + 1 : arguments[0];
    bool ended = await(process, clock_seconds() + seconds);
    kill(-process, SIGKILL); /* and what it may have left running */
    while (waitpid(process, &how, 0) < 0 && errno == EINTR)
        ;
    if (!ended && is_asked_to_stop())
        return status_fail(status, STATUS_INTERRUPTED, "'%s' was stopped by a signal", name);
    if (!ended)
        return status_fail(status, STATUS_IO, "'%s' took more than %g s", name, seconds);
    if (!WIFEXITED(how) || WEXITSTATUS(how) != 0)
        return status_fail(status, STATUS_IO, "'%s' failed", name);
    return STATUS_OK;
}
