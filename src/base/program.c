/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/program.h"
#include "base/clock.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern char **environ;

enum { MOST = 256, WAIT_MS = 50, PAUSE_MS = 2, STACK_BYTES = 8 << 20 };
static const double last_seconds = 0.2; /* for a killed program to be gone */

static atomic_bool stop;
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER; /* guards: */
static pid_t running[MOST];                              /* those not yet waited for, whose ids are thus theirs */

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

void program_ending_signals(sigset_t *out)
{
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    sigemptyset(out);
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
        struct sigaction action;
        if (sigaction(signals[i], NULL, &action) == 0 && action.sa_handler != SIG_IGN)
            sigaddset(out, signals[i]);
    }
}

void program_hold_signals(sigset_t *before)
{
    sigset_t signals;
    program_ending_signals(&signals);
    pthread_sigmask(SIG_BLOCK, &signals, before);
}

void program_let_signals(const sigset_t *before)
{
    pthread_sigmask(SIG_SETMASK, before, NULL);
}

void program_stop(void)
{
    stop = true;
}

static bool is_asked_to_stop(void)
{
    sigset_t pending, signals, both;
    program_ending_signals(&signals);
    return stop || (sigpending(&pending) == 0 && sigandset(&both, &pending, &signals) == 0 && !sigisemptyset(&both));
}

/* What the child needs of its parent, whose memory it shares until it is another program. */
struct child {
    const struct program_task *task;
    pid_t parent;
    int report; /* takes the errno that says why it is none */
};

static void give_stack(void)
{
    struct rlimit limit; /* `ulimit -s 64` is enough for this program, perhaps not for others */
    if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= STACK_BYTES)
        return;
    struct rlimit usual = {STACK_BYTES, limit.rlim_max > STACK_BYTES ? limit.rlim_max : STACK_BYTES};
    if (setrlimit(RLIMIT_STACK, &usual) == 0)
        return;
    limit.rlim_cur = limit.rlim_max < STACK_BYTES ? limit.rlim_max : STACK_BYTES;
    setrlimit(RLIMIT_STACK, &limit);
}

static bool give_descriptor(int from, int to)
{
    return from == to ? fcntl(to, F_SETFD, 0) == 0 : dup2(from, to) == to;
}

/* Becomes the program. System calls alone: other threads of the parent may hold any lock. */
_Noreturn static void become(const struct child *child)
{
    static const int usual[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ, SIGCHLD};
    const struct program_task *task = child->task;
    struct sigaction action = {.sa_handler = SIG_DFL};
    sigset_t none;
    sigemptyset(&none);
    for (size_t i = 0; i < sizeof usual / sizeof *usual; i++)
        sigaction(usual[i], &action, NULL);
    give_stack();
    if (setpgid(0, 0) == 0 && prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 && getppid() == child->parent &&
        chdir(task->directory) == 0 && give_descriptor(task->output, STDERR_FILENO) &&
        give_descriptor(task->input, STDIN_FILENO) && give_descriptor(task->output, STDOUT_FILENO) &&
        sigprocmask(SIG_SETMASK, &none, NULL) == 0)
        execve(task->path, task->arguments, task->environment);
    int error = errno;
    (void)!write(child->report, &error, sizeof error);
    _exit(127);
}

/* vfork(): posix_spawn() can do all of this but bind the child's life to ours; fork() copies the tables of all memory.
 */
__attribute__((noinline)) static pid_t divide(const struct child *child)
{
    pid_t process = vfork();
    if (process == 0)
        become(child);
    return process;
}

int program_start(pid_t *process, const struct program_task *task)
{
    int ends[2], error = 0;
    sigset_t all, before;
    size_t place = 0;
    if (pipe2(ends, O_CLOEXEC) != 0)
        return errno;
    const struct child child = {task, getpid(), ends[1]};
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before); /* no handler of ours may run in the child */
    pthread_mutex_lock(&lock);
    while (place < MOST && running[place])
        place++;
    pid_t started = -1;
    if (stop || place == MOST)
        error = stop ? ECANCELED : EAGAIN;
    else if ((started = divide(&child)) < 0)
        error = errno;
    else
        running[place] = started;
    pthread_mutex_unlock(&lock);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    close(ends[1]);
    if (!error && read(ends[0], &error, sizeof error) != sizeof error)
        error = 0;
    close(ends[0]);
    if (error && started > 0)
        program_end(started);
    *process = started;
    return error;
}

static bool has_ended(pid_t process)
{
    siginfo_t info = {.si_pid = 0};
    int failed = waitid(P_PID, (id_t)process, &info, WEXITED | WNOHANG | WNOWAIT); /* its id stays taken */
    return (failed && errno != EINTR) || info.si_pid == process;
}

enum program_state program_wait(pid_t process, double until, int descriptor)
{
    int ending = (int)syscall(SYS_pidfd_open, process, 0); /* readable when it ends; an older kernel has none */
    struct pollfd looked[] = {{.fd = ending, .events = POLLIN}, {.fd = descriptor, .events = POLLOUT}};
    enum program_state state = PROGRAM_RUNS;
    do {
        if (has_ended(process))
            state = PROGRAM_ENDED;
        else if (is_asked_to_stop())
            state = PROGRAM_STOPPED;
        else if (clock_seconds() > until)
            state = PROGRAM_LATE;
        else if (poll(looked, 2, ending >= 0 ? WAIT_MS : PAUSE_MS) > 0 && looked[1].revents)
            break;
    } while (state == PROGRAM_RUNS);
    if (ending >= 0)
        close(ending);
    return state;
}

int program_end(pid_t process)
{
    siginfo_t info;
    int how = 0;
    kill(-process, SIGKILL); /* and what it may have left running */
    kill(process, SIGKILL);
    while (waitid(P_PID, (id_t)process, &info, WEXITED | WNOWAIT) != 0 && errno == EINTR)
        ;
    pthread_mutex_lock(&lock); /* from here on its id may be another's */
    for (size_t i = 0; i < MOST; i++)
        if (running[i] == process)
            running[i] = 0;
    while (waitpid(process, &how, 0) < 0 && errno == EINTR)
        ;
    pthread_mutex_unlock(&lock);
    return how;
}

void program_kill(void)
{
    const struct timespec pause = {0, PAUSE_MS * 1000000L};
    double until = clock_seconds() + last_seconds;
    pthread_mutex_lock(&lock);
    for (size_t i = 0; i < MOST; i++)
        if (running[i]) {
            kill(-running[i], SIGKILL);
            kill(running[i], SIGKILL);
        }
    for (size_t i = 0; i < MOST; i++)
        while (running[i] && !has_ended(running[i]) && clock_seconds() < until)
            nanosleep(&pause, NULL);
    pthread_mutex_unlock(&lock);
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

enum status_code program_run(char *const *arguments, const char *directory, double seconds, struct status *status)
{
    pid_t process;
    int error = ENOMEM, nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
    char *home = NULL;
    if (nothing < 0)
        return status_fail(status, STATUS_IO, "cannot open '/dev/null': %s", strerror(errno));
    if (asprintf(&home, "HOME=%s", directory) < 0) {
        close(nothing);
        return status_memory(status);
    }
    char **environment = environment_with(home);
    if (environment)
        error = program_start(
            &process, &(struct program_task){arguments, arguments[0], directory, environment, nothing, nothing});
    free(environment);
    free(home);
    close(nothing);
    const char *slash = strrchr(arguments[0], '/'), *name = slash ? slash + 1 : arguments[0];
    if (error == ECANCELED)
        return status_fail(status, STATUS_INTERRUPTED, "'%s' was stopped by a signal", name);
    if (error)
        return status_fail(status, STATUS_IO, "cannot start '%s': %s", arguments[0], strerror(error));
    enum program_state state = program_wait(process, clock_seconds() + seconds, -1);
    int how = program_end(process);
    if (state == PROGRAM_STOPPED)
        return status_fail(status, STATUS_INTERRUPTED, "'%s' was stopped by a signal", name);
    if (state == PROGRAM_LATE)
        return status_fail(status, STATUS_IO, "'%s' took more than %g s", name, seconds);
    if (!WIFEXITED(how) || WEXITSTATUS(how) != 0)
        return status_fail(status, STATUS_IO, "'%s' failed", name);
    return STATUS_OK;
}
