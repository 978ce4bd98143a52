/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/command.h"

#include "base/program.h"
#include "base/temporary.h"
#include "base/threads.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

/* Of the process, as its signals are. */
static atomic_bool stop, told;
static atomic_int taken, grace_ms = 200; /* time for a running program to be ended with all that it started */
static pthread_mutex_t end_lock = PTHREAD_MUTEX_INITIALIZER; /* whoever has it ends the program */

const atomic_bool *signals_stop(int milliseconds)
{
    grace_ms = milliseconds;
    return &stop;
}

bool signals_first_word(void)
{
    return !atomic_exchange(&told, true);
}

/** One line on stderr, unless nobody reads it there. */
static void tell(const char *note)
{
    OWNED(text_free) struct text shown = {0};
    struct pollfd err = {.fd = STDERR_FILENO, .events = POLLOUT};
    text_add_shown(&shown, note);
    if (signals_first_word() && poll(&err, 1, 0) > 0)
        dprintf(STDERR_FILENO, "%sroughcontact: stopped by a signal%s%s\n", isatty(STDERR_FILENO) ? "\r\033[K" : "",
                *note ? "; " : "", text_string(&shown));
}

/** Ends the program by the signal that was taken. */
_Noreturn static void end_by_signal(void)
{
    sigset_t signals;
    pthread_mutex_lock(&end_lock);
    signal(SIGPIPE, SIG_IGN);
    tell(temporary_end());
    signal(taken, SIG_DFL);
    sigemptyset(&signals);
    sigaddset(&signals, taken);
    pthread_sigmask(SIG_UNBLOCK, &signals, NULL);
    raise(taken);
    _exit(128 + taken); /* the first process of a container does not die of signals */
}

struct program {
    command_run *body;
    int argc;
    char **argv;
};

static void *run_body(void *context)
{
    struct program *program = context;
    int exit_status = program->body(program->argc, program->argv);
    if (taken)
        end_by_signal();
    exit(exit_status);
}

/** Else the next opened file would get the number of a closed stream, and what is printed. */
static void open_standard_streams(void)
{
    for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++)
        if (fcntl(fd, F_GETFD) < 0 && errno == EBADF)
            (void)!open("/dev/null", fd == STDOUT_FILENO ? O_RDONLY : O_WRONLY); /* the wrong way: use is an error */
}

int signals_run(command_run *body, int argc, char **argv)
{
    static const int ending[] = {SIGINT, SIGTERM, SIGHUP};
    struct program program = {body, argc, argv};
    pthread_t thread;
    sigset_t signals;
    sigemptyset(&signals);
    for (size_t i = 0; i < sizeof ending / sizeof *ending; i++) {
        struct sigaction action; /* the caller may want it ignored, as nohup does */
        if (sigaction(ending[i], NULL, &action) == 0 && action.sa_handler != SIG_IGN)
            sigaddset(&signals, ending[i]);
    }
    open_standard_streams();
    signal(SIGXFSZ, SIG_IGN); /* write() then says EFBIG */
    signal(SIGCHLD, SIG_DFL); /* if ignored, how programs end would be lost and their ids reused */
    pthread_sigmask(SIG_BLOCK, &signals, NULL);
    if (!thread_start(&thread, run_body, &program)) { /* then on this one, with default signals */
        pthread_sigmask(SIG_UNBLOCK, &signals, NULL);
        return body(argc, argv);
    }
    int number;
    while ((number = sigwaitinfo(&signals, NULL)) < 0)
        ;
    taken = number;
    stop = true;
    program_stop();
    const struct timespec most = {grace_ms / 1000, grace_ms % 1000 * 1000000L}; /* or until one more comes */
    while (sigtimedwait(&signals, NULL, &most) < 0 && errno == EINTR)
        ;
    end_by_signal();
}
