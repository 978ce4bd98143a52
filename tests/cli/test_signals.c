/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whatever the program does when a signal comes, it ends, and so does all that it started; what it made is removed. */
#include "base/clock.h"
#include "base/program.h"
#include "base/temporary.h"
#include "cli/command.h"
#include "directory.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>

static void sleep_for(double seconds)
{
    for (double until = clock_seconds() + seconds; clock_seconds() < until;)
        support_pause();
}

/* Starts a shell with these lines. Returns its id. */
static pid_t start(char *lines)
{
    char shell[] = "/bin/sh", option[] = "-c";
    char *const arguments[] = {shell, option, lines, NULL};
    int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
    pid_t process = 0;
    struct program_task task = {arguments, shell, directory_here.path, nothing, nothing};
    if (program_start(&process, &task) != 0)
        _exit(70);
    return process;
}

static void begin(pid_t process)
{
    directory_write(&directory_here, "begun.new", filled("%d", (int)process));
    if (rename(directory_path(&directory_here, "begun.new"), directory_path(&directory_here, "begun")) != 0)
        _exit(71);
}

/* Ignores the request to stop, and goes on writing. */
static int deaf(int argc, char **argv)
{
    char stubborn[] = "trap '' INT TERM HUP; exec sleep 1000"; /* no signal but SIGKILL ends it */
    (void)argc, (void)argv;
    (void)signals_stop(100);
    struct temporary staging;
    struct status status = {0};
    if (temporary_make(&staging, directory_here.path, NULL, &status) != STATUS_OK ||
        mkdirat(staging.directory, "data", 0700) != 0)
        return 72;
    temporary_note("", "out", " is as it was before");
    begin(start(stubborn));
    for (int i = 0;; i = (i + 1) % 100) {
        int file = openat(staging.directory, filled("data/%d", i), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
        if (file >= 0)
            close(file);
        support_pause(); /* what comes without end is never all removed */
    }
}

/* Ends in order when it is asked to. */
static int orderly(int argc, char **argv)
{
    (void)argc, (void)argv;
    const atomic_bool *stop = signals_stop(100000);
    begin(0);
    while (!*stop)
        support_pause();
    directory_write(&directory_here, "finished", "");
    return 5;
}

/* Does something that must not be done by halves. */
static int holds(int argc, char **argv)
{
    (void)argc, (void)argv;
    (void)signals_stop(0);
    temporary_hold();
    begin(0);
    sleep_for(0.2);
    directory_write(&directory_here, "finished", "");
    temporary_note("the report is in ", "out", "");
    temporary_release();
    while (clock_seconds() > 0)
        support_pause();
    return 73;
}

/* Asks for nothing and never ends. */
static int hangs(int argc, char **argv)
{
    (void)argc, (void)argv;
    begin(0);
    while (clock_seconds() > 0)
        support_pause();
    return 73;
}

/* Asks for more time than anybody waits. */
static int slow(int argc, char **argv)
{
    (void)signals_stop(1000000);
    return hangs(argc, argv);
}

static int ends(int argc, char **argv)
{
    (void)argc, (void)argv;
    begin(0);
    return 5;
}

/* Ends as the program that it runs. */
static int follows(int argc, char **argv)
{
    char lines[] = "exit 3";
    (void)argc, (void)argv;
    pid_t process = start(lines);
    if (program_wait(process, INFINITY) != PROGRAM_ENDED)
        return 70;
    begin(0);
    int how = program_end(process);
    return WIFEXITED(how) ? WEXITSTATUS(how) : 71;
}

/* How a process ended: what waitpid() says of it, what it wrote to stderr, and the id in `begun`. */
struct end {
    int state;
    char said[256];
    pid_t other;
};

/* Runs `body` in a process of its own, whose stderr is `errors`, until it has begun. */
static pid_t start_body(int (*body)(int argc, char **argv), int errors)
{
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        dup2(errors, STDERR_FILENO);
        exit(signals_run(body, 0, NULL));
    }
    close(errors);
    while (!directory_has(&directory_here, "begun"))
        support_pause();
    return child;
}

/* The same, to its end; sends it `signal_number` `times`. */
static struct end run(int (*body)(int argc, char **argv), int signal_number, int times)
{
    int errors[2];
    struct end end = {0};
    assert_int_equal(pipe2(errors, O_CLOEXEC), 0);
    pid_t child = start_body(body, errors[1]);
    char *id = directory_read(&directory_here, "begun");
    end.other = (pid_t)strtol(id, NULL, 10);
    double before = clock_seconds();
    for (int i = 0; i < times; i++) {
        assert_int_equal(kill(child, signal_number), 0);
        sleep_for(0.05);
    }
    assert_true(read(errors[0], end.said, sizeof end.said - 1) >= 0);
    assert_int_equal(waitpid(child, &end.state, 0), child);
    assert_true(clock_seconds() - before < 60); /* it would never end */
    close(errors[0]);
    remove(directory_path(&directory_here, "begun"));
    return end;
}

static void assert_ended(int state, int exit_status)
{
    assert_true(WIFEXITED(state));
    assert_int_equal(WEXITSTATUS(state), exit_status);
}

static void assert_signalled(int state, int signal_number)
{
    assert_true(WIFSIGNALED(state));
    assert_int_equal(WTERMSIG(state), signal_number);
}

static int make(void **state)
{
    directory_setup(state);
    return prctl(PR_SET_CHILD_SUBREAPER, 1);
}

#define SIGNAL_TEST(name) TEST_WITH(name, make, directory_teardown)

SIGNAL_TEST(what_does_not_listen_is_ended)
{
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
        struct end end = run(deaf, signals[i], 1);
        assert_signalled(end.state, signals[i]);
        assert_string_equal(end.said, "roughcontact: stopped by a signal; 'out' is as it was before\n");
        assert_int_equal(directory_entries(&directory_here, ""), 0);
        int other;
        assert_int_equal(waitpid(end.other, &other, 0), end.other); /* orphans come to this process: make() */
        assert_signalled(other, SIGKILL);
        assert_int_equal(waitpid(-1, &other, WNOHANG), -1); /* nothing else is left */
    }
}

/* A program that listens ends in order; a second signal ends it at once; what must not be half done is finished; a
 * program that asked for no time ends at once. */
SIGNAL_TEST(each_has_the_time_it_asked_for)
{
    static const struct {
        int (*body)(int argc, char **argv);
        int signal_number, times;
        bool finishes;
        const char *said;
    } cases[] = {{orderly, SIGTERM, 1, true, "roughcontact: stopped by a signal\n"},
                 {slow, SIGINT, 2, false, "roughcontact: stopped by a signal\n"},
                 {holds, SIGTERM, 3, true, "roughcontact: stopped by a signal; the report is in 'out'\n"},
                 {hangs, SIGHUP, 1, false, "roughcontact: stopped by a signal\n"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct end end = run(cases[i].body, cases[i].signal_number, cases[i].times);
        assert_signalled(end.state, cases[i].signal_number);
        assert_string_equal(end.said, cases[i].said);
        assert_int_equal(directory_has(&directory_here, "finished"), cases[i].finishes);
        remove(directory_path(&directory_here, "finished"));
    }
}

SIGNAL_TEST(the_status_is_that_of_a_body_that_ends)
{
    struct end end = run(ends, 0, 0);
    assert_ended(end.state, 5);
    assert_string_equal(end.said, "");
}

/* A parent may leave SIGCHLD ignored. Then it would be lost how a program ended, and its id could be reused. */
SIGNAL_TEST(what_was_started_is_known_to_have_ended)
{
    int end;
    assert_true(signal(SIGCHLD, SIG_IGN) != SIG_ERR);
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0)
        exit(signals_run(follows, 0, NULL));
    assert_true(signal(SIGCHLD, SIG_DFL) != SIG_ERR);
    assert_int_equal(waitpid(child, &end, 0), child);
    assert_ended(end, 3);
    remove(directory_path(&directory_here, "begun"));
    assert_ended(run(follows, 0, 0).state, 3);
}

/* As under nohup. */
SIGNAL_TEST(an_ignored_signal_stays_ignored)
{
    int end;
    assert_true(signal(SIGHUP, SIG_IGN) != SIG_ERR);
    pid_t child = start_body(orderly, dup(STDERR_FILENO));
    assert_int_equal(kill(child, SIGHUP), 0);
    sleep_for(0.2);
    assert_int_equal(waitpid(child, NULL, WNOHANG), 0);
    assert_false(directory_has(&directory_here, "finished"));
    assert_int_equal(kill(child, SIGTERM), 0);
    assert_int_equal(waitpid(child, &end, 0), child);
    assert_signalled(end, SIGTERM);
    remove(directory_path(&directory_here, "begun"));
    assert_true(signal(SIGHUP, SIG_DFL) != SIG_ERR);
    assert_signalled(run(orderly, SIGHUP, 1).state, SIGHUP);
}

/* kill -9 leaves no time for anything; what it had started ends all the same. */
SIGNAL_TEST(a_killed_program_takes_others_with_it)
{
    struct end end = run(deaf, SIGKILL, 1);
    assert_signalled(end.state, SIGKILL);
    int other;
    assert_int_equal(waitpid(end.other, &other, 0), end.other);
    assert_signalled(other, SIGKILL);
}

TEST_GROUP(support_take_signals, NULL)
