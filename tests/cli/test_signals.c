/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whatever the program is doing when a signal comes, it ends, with all that it has started and made. */
#include "base/clock.h"
#include "base/program.h"
#include "base/temporary.h"
#include "cli/signals.h"
#include "directory.h"

#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>

static struct directory place;

static void wait_a_little(void)
{
    const struct timespec pause = {.tv_nsec = 5000000};
    nanosleep(&pause, NULL);
}

static void sleep_for(double seconds)
{
    for (double until = clock_seconds() + seconds; clock_seconds() < until;)
        wait_a_little();
}

/* Starts a program that no signal but SIGKILL ends. Returns its id. */
static pid_t start_stubborn(void)
{
    char shell[] = "/bin/sh", option[] = "-c", lines[] = "trap '' INT TERM HUP; exec sleep 1000";
    char *const arguments[] = {shell, option, lines, NULL};
    int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
    pid_t process = 0;
    struct program_task task = {arguments, shell, place.path, (const char *const[]){NULL}, NULL, nothing, nothing};
    if (program_start(&process, &task) != 0)
        _exit(70);
    return process;
}

static void begin(pid_t process)
{
    char id[32];
    snprintf(id, sizeof id, "%d", (int)process);
    directory_write(&place, "begun.new", id);
    if (rename(directory_path(&place, "begun.new"), directory_path(&place, "begun")) != 0)
        _exit(71);
}

/* Never looks at what it is asked, and goes on writing. */
static int deaf(int argc, char **argv)
{
    (void)argc, (void)argv;
    (void)signals_stop(100);
    struct temporary staging;
    struct status status = {0};
    if (temporary_make(&staging, place.path, NULL, &status) != STATUS_OK ||
        mkdirat(staging.directory, "data", 0700) != 0)
        return 72;
    temporary_note("'out' is as it was before");
    begin(start_stubborn());
    for (int i = 0;; i = (i + 1) % 100) {
        char path[300];
        snprintf(path, sizeof path, "data/%d", i);
        int file = openat(staging.directory, path, O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
        if (file >= 0)
            close(file);
    }
}

/* Ends in order when it is asked. */
static int orderly(int argc, char **argv)
{
    (void)argc, (void)argv;
    const atomic_bool *stop = signals_stop(100000);
    begin(0);
    while (!*stop)
        wait_a_little();
    directory_write(&place, "finished", "");
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
    directory_write(&place, "finished", "");
    temporary_note("the report is in 'out'");
    temporary_release();
    while (clock_seconds() > 0)
        wait_a_little();
    return 73;
}

/* Asks for nothing and never ends. */
static int hangs(int argc, char **argv)
{
    (void)argc, (void)argv;
    begin(0);
    while (clock_seconds() > 0)
        wait_a_little();
    return 73;
}

/* Has asked for far more time than anybody waits. */
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
    (void)argc, (void)argv;
    char shell[] = "/bin/sh", option[] = "-c", lines[] = "exit 3";
    char *const arguments[] = {shell, option, lines, NULL};
    int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
    pid_t process = 0;
    struct program_task task = {arguments, shell, place.path, (const char *const[]){NULL}, NULL, nothing, nothing};
    if (program_start(&process, &task) != 0 || program_wait(process, INFINITY, -1) != PROGRAM_ENDED)
        return 70;
    begin(0);
    int how = program_end(process);
    return WIFEXITED(how) ? WEXITSTATUS(how) : 71;
}

/* Runs `body` in a process of its own and sends it `signal_number` `times`. Returns what waitpid() says of it; of what
 * it wrote to stderr as well as the id in `begun`. */
static int run(int (*body)(int argc, char **argv), int signal_number, int times, char *said, pid_t *other)
{
    int errors[2], state;
    assert_int_equal(pipe2(errors, O_CLOEXEC), 0);
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        dup2(errors[1], STDERR_FILENO);
        close(errors[1]);
        exit(signals_run(body, 0, NULL));
    }
    close(errors[1]);
    while (!directory_has(&place, "begun"))
        wait_a_little();
    struct text id = directory_read(&place, "begun");
    *other = (pid_t)strtol(text_string(&id), NULL, 10);
    text_free(&id);
    double before = clock_seconds();
    for (int i = 0; i < times; i++) {
        assert_int_equal(kill(child, signal_number), 0);
        sleep_for(0.05);
    }
    ssize_t length = read(errors[0], said, 200);
    said[length > 0 ? length : 0] = '\0';
    assert_int_equal(waitpid(child, &state, 0), child);
    assert_true(clock_seconds() - before < 60); /* it would never end */
    close(errors[0]);
    remove(directory_path(&place, "begun"));
    return state;
}

static void assert_signalled(int state, int signal_number)
{
    assert_true(WIFSIGNALED(state));
    assert_int_equal(WTERMSIG(state), signal_number);
}

static void test_what_does_not_listen_is_ended(void **state)
{
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    char said[256];
    pid_t other;
    (void)state;
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
        assert_signalled(run(deaf, signals[i], 1, said, &other), signals[i]);
        assert_string_equal(said, "roughcontact: stopped by a signal; 'out' is as it was before\n");
        assert_int_equal(directory_entries(&place, ""), 0);
        int end;
        assert_int_equal(waitpid(other, &end, 0), other); /* orphans come to this process: make() */
        assert_signalled(end, SIGKILL);
        assert_int_equal(waitpid(-1, &end, WNOHANG), -1); /* nothing else is left */
    }
}

static void test_what_listens_ends_in_order(void **state)
{
    char said[256];
    pid_t other;
    (void)state;
    assert_signalled(run(orderly, SIGTERM, 1, said, &other), SIGTERM);
    assert_true(directory_has(&place, "finished"));
    assert_string_equal(said, "roughcontact: stopped by a signal\n");
}

static void test_a_second_signal_ends_at_once(void **state)
{
    char said[256];
    pid_t other;
    (void)state;
    assert_signalled(run(slow, SIGINT, 2, said, &other), SIGINT);
    assert_string_equal(said, "roughcontact: stopped by a signal\n");
}

static void test_what_is_begun_is_finished(void **state)
{
    char said[256];
    pid_t other;
    (void)state;
    assert_signalled(run(holds, SIGTERM, 3, said, &other), SIGTERM);
    assert_true(directory_has(&place, "finished"));
    assert_string_equal(said, "roughcontact: stopped by a signal; the report is in 'out'\n");
}

static void test_nothing_asked_is_no_time(void **state)
{
    char said[256];
    pid_t other;
    (void)state;
    assert_signalled(run(hangs, SIGHUP, 1, said, &other), SIGHUP);
}

static void test_the_status_of_a_body_that_ends(void **state)
{
    char said[256];
    pid_t other;
    (void)state;
    int end = run(ends, 0, 0, said, &other);
    assert_true(WIFEXITED(end));
    assert_int_equal(WEXITSTATUS(end), 5);
    assert_string_equal(said, "");
}

/* Some leave SIGCHLD ignored to what they start; how a program ended would then be lost, and its id be another's. */
static void test_what_was_started_is_known_to_have_ended(void **state)
{
    char said[256];
    pid_t other;
    (void)state;
    assert_true(signal(SIGCHLD, SIG_IGN) != SIG_ERR);
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0)
        exit(signals_run(follows, 0, NULL));
    assert_true(signal(SIGCHLD, SIG_DFL) != SIG_ERR);
    int end;
    assert_int_equal(waitpid(child, &end, 0), child);
    assert_true(WIFEXITED(end));
    assert_int_equal(WEXITSTATUS(end), 3);
    end = run(follows, 0, 0, said, &other);
    assert_int_equal(WEXITSTATUS(end), 3);
}

/* As under nohup. */
static void test_an_ignored_signal_stays_ignored(void **state)
{
    char said[256];
    pid_t other;
    (void)state;
    assert_true(signal(SIGHUP, SIG_IGN) != SIG_ERR);
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0)
        exit(signals_run(orderly, 0, NULL));
    while (!directory_has(&place, "begun"))
        wait_a_little();
    assert_int_equal(kill(child, SIGHUP), 0);
    sleep_for(0.2);
    assert_int_equal(waitpid(child, NULL, WNOHANG), 0);
    assert_false(directory_has(&place, "finished"));
    assert_int_equal(kill(child, SIGTERM), 0);
    int end;
    assert_int_equal(waitpid(child, &end, 0), child);
    assert_signalled(end, SIGTERM);
    remove(directory_path(&place, "begun"));
    assert_true(signal(SIGHUP, SIG_DFL) != SIG_ERR);
    assert_signalled(run(orderly, SIGHUP, 1, said, &other), SIGHUP);
}

/* kill -9 leaves no time for anything; who was started goes all the same. */
static void test_a_killed_program_takes_others_with_it(void **state)
{
    char said[256];
    pid_t other;
    int end;
    (void)state;
    assert_signalled(run(deaf, SIGKILL, 1, said, &other), SIGKILL);
    assert_int_equal(waitpid(other, &end, 0), other);
    assert_signalled(end, SIGKILL);
}

static int make(void **state)
{
    (void)state;
    place = directory_make();
    return prctl(PR_SET_CHILD_SUBREAPER, 1);
}

static int end(void **state)
{
    (void)state;
    directory_remove(&place);
    return 0;
}

int main(void)
{
#define TEST(function) cmocka_unit_test_setup_teardown(function, make, end)
    const struct CMUnitTest tests[] = {
        TEST(test_what_does_not_listen_is_ended),
        TEST(test_what_listens_ends_in_order),
        TEST(test_a_second_signal_ends_at_once),
        TEST(test_what_is_begun_is_finished),
        TEST(test_nothing_asked_is_no_time),
        TEST(test_the_status_of_a_body_that_ends),
        TEST(test_what_was_started_is_known_to_have_ended),
        TEST(test_an_ignored_signal_stays_ignored),
        TEST(test_a_killed_program_takes_others_with_it),
    };
    static const int used[] = {SIGINT, SIGTERM, SIGHUP};
    for (size_t i = 0; i < sizeof used / sizeof *used; i++)
        if (signal(used[i], SIG_DFL) == SIG_ERR) /* also where these tests run in the background */
            return 1;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
