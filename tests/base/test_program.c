/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/clock.h"
#include "base/program.h"
#include "directory.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>

extern char **environ;

static struct directory place;

/* Runs these lines by a shell in the directory, for at most `seconds`. */
static enum status_code run(char *lines, double seconds, struct status *status)
{
    char shell[] = "/bin/sh", option[] = "-c";
    char *const arguments[] = {shell, option, lines, NULL};
    return program_run(arguments, place.path, seconds, status);
}

static void test_find(void **state)
{
    (void)state;
    char path[4096], *before = strdup(getenv("PATH")), *with = NULL;
    directory_write(&place, "tool", "#!/bin/sh\n");
    assert_true(asprintf(&with, "relative::%s:%s", place.path, before) > 0);
    assert_int_equal(setenv("PATH", with, 1), 0);
    assert_false(program_find(path, sizeof path, "tool")); /* no program yet */
    assert_int_equal(chmod(directory_path(&place, "tool"), 0700), 0);
    assert_true(program_find(path, sizeof path, "tool"));
    assert_string_equal(path, directory_path(&place, "tool"));
    assert_false(program_find(path, strlen(place.path), "tool"));
    assert_false(program_find(path, sizeof path, "no-such-tool"));
    assert_int_equal(setenv("PATH", before, 1), 0);
    free(before);
    free(with);
}

static void test_run(void **state)
{
    (void)state;
    struct status status = {0};
    char home[] = "pwd > where; echo \"$HOME\" >> where; echo loud; read line || echo no input >> where";
    assert_int_equal(run(home, 60, &status), STATUS_OK);
    struct text where = directory_read(&place, "where");
    char expected[600];
    snprintf(expected, sizeof expected, "%s\n%s\nno input\n", place.path, place.path);
    assert_string_equal(text_string(&where), expected);
    text_free(&where);
    char fails[] = "exit 3", dies[] = "kill -9 $$", *const none[] = {expected, NULL};
    assert_int_equal(run(fails, 60, &status), STATUS_IO);
    assert_non_null(strstr(status.message, "'sh' failed"));
    status = (struct status){0};
    assert_int_equal(run(dies, 60, &status), STATUS_IO);
    status = (struct status){0};
    assert_int_equal(program_run(none, place.path, 60, &status), STATUS_IO);
    assert_non_null(strstr(status.message, "cannot start"));
}

/* Waits for what `task` starts; the file `said` has what it printed. */
static void run_task(const struct program_task *task, const char *expected)
{
    pid_t process;
    assert_int_equal(program_start(&process, task), 0);
    enum program_state state = program_wait(process, clock_seconds() + 60, -1);
    int how = program_end(process);
    assert_int_equal(state, PROGRAM_ENDED);
    assert_int_equal(how, 0);
    struct text said = directory_read(&place, "said");
    assert_string_equal(text_string(&said), expected);
    text_free(&said);
}

/* It gets both outputs, a process group of its own, the usual signals though this program holds them back and ignores
 * some, and the usual stack though this program has little. */
static void test_what_it_gets(void **state)
{
    (void)state;
    char shell[] = "/bin/sh", option[] = "-c",
         lines[] = "echo output; echo complaint >&2; read line; echo \"$line\"\n"
                   "[ $(cut -d' ' -f5 /proc/$$/stat) = $$ ] && echo its own group\n"
                   "grep SigIgn /proc/self/status; ulimit -S -s";
    char *const arguments[] = {shell, option, lines, NULL};
    struct rlimit before, little;
    sigset_t signals, held;
    assert_int_equal(getrlimit(RLIMIT_STACK, &before), 0);
    little = before;
    little.rlim_cur = 256 << 10;
    assert_int_equal(setrlimit(RLIMIT_STACK, &little), 0);
    void (*pipes)(int) = signal(SIGPIPE, SIG_IGN);
    sigemptyset(&signals);
    sigaddset(&signals, SIGUSR1);
    pthread_sigmask(SIG_BLOCK, &signals, NULL);
    program_hold_signals(&held);
    directory_write(&place, "input", "given\n");
    directory_write(&place, "said", "");
    int input = open(directory_path(&place, "input"), O_RDONLY | O_CLOEXEC),
        said = open(directory_path(&place, "said"), O_RDWR | O_APPEND | O_CLOEXEC);
    assert_true(input >= 0 && said >= 0);
    run_task(&(struct program_task){arguments, shell, place.path, environ, input, said},
             "output\ncomplaint\ngiven\nits own group\nSigIgn:\t0000000000000000\n8192\n");
    assert_int_equal(ftruncate(said, 0), 0);
    char grep[] = "/bin/grep", what[] = "SigBlk", where[] = "/proc/self/status"; /* a shell lets signals in itself */
    char *const looks[] = {grep, what, where, NULL};
    run_task(&(struct program_task){looks, grep, place.path, environ, input, said}, "SigBlk:\t0000000000000000\n");
    close(input);
    close(said);
    program_let_signals(&held);
    pthread_sigmask(SIG_UNBLOCK, &signals, NULL);
    signal(SIGPIPE, pipes);
    assert_int_equal(setrlimit(RLIMIT_STACK, &before), 0);
}

/* It does not outlive this program, however that ends. */
static void test_it_ends_with_its_parent(void **state)
{
    (void)state;
    int how;
    char number[32] = "";
    assert_int_equal(prctl(PR_SET_CHILD_SUBREAPER, 1), 0);
    pid_t parent = fork();
    assert_true(parent >= 0);
    if (parent == 0) {
        char program[] = "/bin/sleep", seconds[] = "1000";
        char *const arguments[] = {program, seconds, NULL};
        pid_t process;
        int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
        if (program_start(&process, &(struct program_task){arguments, program, "/", environ, nothing, nothing}) != 0)
            _exit(1);
        snprintf(number, sizeof number, "%d", (int)process);
        directory_write(&place, "number", number);
        raise(SIGKILL);
    }
    assert_int_equal(waitpid(parent, &how, 0), parent);
    assert_true(WIFSIGNALED(how) && WTERMSIG(how) == SIGKILL);
    struct text text = directory_read(&place, "number");
    pid_t process = (pid_t)atoi(text_string(&text)), gone = 0;
    text_free(&text);
    assert_true(process > 0);
    for (double until = clock_seconds() + 60; gone == 0 && clock_seconds() < until;)
        gone = waitpid(process, &how, WNOHANG); /* it is this one's child now */
    if (gone == 0)
        kill(process, SIGKILL);
    assert_int_equal(gone, process);
    assert_true(WIFSIGNALED(how) && WTERMSIG(how) == SIGKILL);
}

/* Too slow, or asked to stop: it ends at once. Without that these would take minutes. */
static void test_stop(void **state)
{
    (void)state;
    struct status status = {0};
    char slow[] = "sleep 1000";
    assert_int_equal(run(slow, 0.05, &status), STATUS_IO);
    assert_non_null(strstr(status.message, "took more than 0.05 s"));
    status = (struct status){0};
    sigset_t before;
    program_hold_signals(&before);
    raise(SIGTERM);
    assert_int_equal(run(slow, 1000, &status), STATUS_INTERRUPTED);
    signal(SIGTERM, SIG_IGN); /* takes it off */
    program_let_signals(&before);
    signal(SIGTERM, SIG_DFL);
    status = (struct status){0};
    program_stop();
    assert_int_equal(run(slow, 1000, &status), STATUS_INTERRUPTED);
    char shell[] = "/bin/sh", option[] = "-c", mark[] = "echo > begun";
    char *const arguments[] = {shell, option, mark, NULL};
    pid_t process;
    assert_int_equal(program_start(&process, &(struct program_task){arguments, shell, place.path, environ, 0, 1}),
                     ECANCELED);
    assert_false(directory_has(&place, "begun")); /* it is not even begun */
}

static int make(void **state)
{
    (void)state;
    place = directory_make();
    return 0;
}

static int end(void **state)
{
    (void)state;
    directory_remove(&place);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_find, make, end),
        cmocka_unit_test_setup_teardown(test_run, make, end),
        cmocka_unit_test_setup_teardown(test_what_it_gets, make, end),
        cmocka_unit_test_setup_teardown(test_it_ends_with_its_parent, make, end),
        cmocka_unit_test_setup_teardown(test_stop, make, end), /* last: nothing starts after it */
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
