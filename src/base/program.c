/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/program.h"
#include "base/clock.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum { PAUSE_MS = 2 };

static atomic_bool stop;

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
    stop = true;
}

/** By vfork(), since posix_spawn() cannot kill the child with its parent. The child shares its parent's memory, where
 * other threads may hold locks, so it makes system calls only. *error says why it did not run. */
__attribute__((noinline)) static pid_t divide(const struct program_task *task, char *const *environment,
                                              volatile int *error)
{
    static const int usual[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ, SIGCHLD};
    const struct sigaction action = {.sa_handler = SIG_DFL};
    pid_t parent = getpid(), process = vfork();
    if (process != 0) {
        *error = process < 0 ? errno : *error;
        return process;
    }
    for (size_t i = 0; i < sizeof usual / sizeof *usual; i++)
        sigaction(usual[i], &action, NULL);
    if (setpgid(0, 0) == 0 && prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 && getppid() == parent &&
        chdir(task->directory) == 0 && dup2(task->output, STDERR_FILENO) >= 0 && dup2(task->input, STDIN_FILENO) >= 0 &&
        dup2(task->output, STDOUT_FILENO) >= 0 && sigprocmask(SIG_SETMASK, &action.sa_mask, NULL) == 0)
        execve(task->path, task->arguments, environment);
    *error = errno;
    _exit(127);
}

int program_start(pid_t *process, const struct program_task *task)
{
    volatile int error = 0;
    sigset_t all, before;
    char locale[] = "LC_ALL=C.UTF-8", *path;
    if (asprintf(&path, "PATH=%s", getenv("PATH")) < 0)
        return ENOMEM;
    *process = -1;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before); /* no handler of ours may run in the child */
    if (stop)
        error = ECANCELED;
    else
        *process = divide(task, (char *[]){path, locale, NULL}, &error);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    free(path);
    if (error && *process > 0)
        program_end(*process);
    return error;
}

static bool has_ended(pid_t process)
{
    siginfo_t info = {.si_pid = 0};
    int failed = waitid(P_PID, (id_t)process, &info, WEXITED | WNOHANG | WNOWAIT); /* its id stays taken */
    return (failed && errno != EINTR) || info.si_pid == process;
}

enum program_state program_wait(pid_t process, double until)
{
    for (;;) {
        if (has_ended(process))
            return PROGRAM_ENDED;
        if (stop)
            return PROGRAM_STOPPED;
        if (clock_seconds() > until)
            return PROGRAM_LATE;
        poll(NULL, 0, PAUSE_MS);
    }
}

int program_end(pid_t process)
{
    int how = 0;
    kill(-process, SIGKILL); /* with all that it may have left running */
    while (waitpid(process, &how, 0) < 0 && errno == EINTR)
        ;
    return how;
}
