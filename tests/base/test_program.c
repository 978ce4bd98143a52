/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/clock.h"
#include "base/program.h"
#include "directory.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>

/* Starts a shell with these lines in the directory; what it says goes to the file `said`. */
static int start(pid_t *process, char *lines, const char *directory)
{
    char shell[] = "/bin/sh", option[] = "-c";
    char *const arguments[] = {shell, option, lines, NULL};
    int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC),
        said = open(directory_path(&directory_here, "said"), O_RDWR | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0600);
    assert_true(nothing > 2 && said > 2);
    int error = program_start(process, &(struct program_task){arguments, shell, directory, nothing, said});
    close(nothing);
    close(said);
    return error;
}

/* Runs them for at most `seconds`. */
static enum program_state run(char *lines, double seconds, int *how)
{
    pid_t process;
    assert_int_equal(start(&process, lines, directory_here.path), 0);
    enum program_state state = program_wait(process, clock_seconds() + seconds);
    *how = program_end(process);
    return state;
}

#define PLACED(name) TEST_WITH(name, directory_setup, directory_teardown)

PLACED(test_find)
{
    char path[4096], *before = lasting("%s", getenv("PATH"));
    directory_write(&directory_here, "tool", "#!/bin/sh\n");
    assert_int_equal(setenv("PATH", filled("relative::%s:%s", directory_here.path, before), 1), 0);
    assert_false(program_find(path, sizeof path, "tool")); /* no program yet */
    assert_int_equal(chmod(directory_path(&directory_here, "tool"), 0700), 0);
    assert_true(program_find(path, sizeof path, "tool"));
    assert_string_equal(path, directory_path(&directory_here, "tool"));
    assert_false(program_find(path, strlen(directory_here.path), "tool"));
    assert_false(program_find(path, sizeof path, "no-such-tool"));
    assert_int_equal(setenv("PATH", before, 1), 0);
}

/* It gets both outputs, its directory, no input, a process group of its own, of the environment only PATH, and the
 * default signals, though this program blocks and ignores some. */
PLACED(test_what_it_gets)
{
    int how;
    char first[] = "pwd; echo \"$HOME $LC_ALL $KEPT $PATH\"; echo complaint >&2; read line || echo no input\n"
                   "[ $(cut -d' ' -f5 /proc/$$/stat) = $$ ] && echo its own group\n"
                   "grep SigIgn /proc/self/status",
         second[] = "exec grep SigBlk /proc/self/status"; /* a shell lets signals in itself */
    sigset_t signals;
    void (*pipes)(int) = signal(SIGPIPE, SIG_IGN);
    sigfillset(&signals);
    pthread_sigmask(SIG_BLOCK, &signals, NULL);
    assert_int_equal(setenv("LC_ALL", "C", 1) + setenv("KEPT", "kept", 1), 0);
    char *path = lasting("%s", getenv("PATH"));
    assert_int_equal(setenv("PATH", "/usr/bin:/bin:/kept", 1), 0);
    assert_int_equal(run(first, 60, &how), PROGRAM_ENDED);
    assert_int_equal(how, 0);
    directory_holds(&directory_here, "said",
                    filled("%s\n C.UTF-8  /usr/bin:/bin:/kept\ncomplaint\nno input\nits own group\n"
                           "SigIgn:\t0000000000000000\n",
                           directory_here.path));
    assert_int_equal(run(second, 60, &how), PROGRAM_ENDED);
    directory_holds(&directory_here, "said", "SigBlk:\t0000000000000000\n");
    pthread_sigmask(SIG_UNBLOCK, &signals, NULL);
    signal(SIGPIPE, pipes);
    assert_int_equal(setenv("PATH", path, 1), 0);
}

PLACED(test_how_it_ends)
{
    int how;
    pid_t process;
    char fails[] = "exit 3", dies[] = "kill -9 $$", path[] = "/no/such/program", *const none[] = {path, NULL};
    assert_int_equal(run(fails, 60, &how), PROGRAM_ENDED);
    assert_true(WIFEXITED(how) && WEXITSTATUS(how) == 3);
    assert_int_equal(run(dies, 60, &how), PROGRAM_ENDED);
    assert_true(WIFSIGNALED(how) && WTERMSIG(how) == SIGKILL);
    assert_int_equal(start(&process, fails, "/no/such/place"), ENOENT);
    int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
    const struct program_task task = {none, path, "/", nothing, nothing};
    assert_int_equal(program_start(&process, &task), ENOENT);
    close(nothing);
    assert_int_equal(waitpid(-1, &how, 0), -1); /* nothing is left of them */
}

/* It does not outlive this program, however that ends. */
PLACED(test_it_ends_with_its_parent)
{
    int how;
    assert_int_equal(prctl(PR_SET_CHILD_SUBREAPER, 1), 0);
    pid_t parent = fork();
    assert_true(parent >= 0);
    if (parent == 0) {
        char lines[] = "exec sleep 1000";
        pid_t process;
        if (start(&process, lines, "/") != 0)
            _exit(1);
        directory_write(&directory_here, "number", filled("%d", (int)process));
        raise(SIGKILL);
    }
    assert_int_equal(waitpid(parent, &how, 0), parent);
    assert_true(WIFSIGNALED(how) && WTERMSIG(how) == SIGKILL);
    pid_t process = (pid_t)atoi(directory_read(&directory_here, "number")), gone = 0;
    assert_true(process > 0);
    for (double until = clock_seconds() + 60; gone == 0 && clock_seconds() < until;)
        gone = waitpid(process, &how, WNOHANG); /* it is this one's child now */
    if (gone == 0)
        kill(process, SIGKILL);
    assert_int_equal(gone, process);
    assert_true(WIFSIGNALED(how) && WTERMSIG(how) == SIGKILL);
}

/* Too slow, or asked to stop: it ends at once. Without that these would take minutes. */
PLACED(test_stop)
{
    int how;
    pid_t process;
    char slow[] = "sleep 1000", mark[] = "echo > begun";
    assert_int_equal(run(slow, 0.05, &how), PROGRAM_LATE);
    assert_true(WIFSIGNALED(how));
    assert_int_equal(start(&process, slow, directory_here.path), 0);
    program_stop();
    assert_int_equal(program_wait(process, clock_seconds() + 1000), PROGRAM_STOPPED);
    assert_true(WIFSIGNALED(program_end(process)));
    assert_int_equal(start(&process, mark, directory_here.path), ECANCELED);
    assert_false(directory_has(&directory_here, "begun")); /* it is not even begun */
}
