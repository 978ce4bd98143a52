/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/program.h"
#include "chart/gnuplot.h"
#include "directory.h"

#include <fcntl.h>
#include <signal.h>

#define PLACED(name) TEST_WITH(name, directory_setup, directory_teardown)

/* Sends `commands` to one gnuplot and returns how it ended. */
static enum status_code run(const struct directory *place, const char *commands, struct status *status)
{
    struct gnuplot gnuplot;
    enum status_code code = gnuplot_start(&gnuplot, place->path, status);
    if (code)
        return code;
    gnuplot_send(&gnuplot, commands);
    gnuplot_send(&gnuplot, "\n");
    return gnuplot_finish(&gnuplot, status);
}

static void run_well(const struct directory *place, const char *commands)
{
    struct status status = {0};
    if (run(place, commands, &status) != STATUS_OK)
        fail_msg("%s\nafter: %s", status.message, commands);
}

PLACED(test_a_missing_gnuplot_names_the_package)
{
    char *path = lasting("%s", getenv("PATH"));
    const char *const without[] = {"", ":", ".:bin", "/nonexistent"};
    for (size_t i = 0; i < sizeof without / sizeof *without; i++) {
        struct status started = {0};
        struct gnuplot gnuplot;
        assert_int_equal(setenv("PATH", without[i], 1), 0);
        enum status_code start = gnuplot_start(&gnuplot, ((struct directory *)*state)->path, &started);
        assert_int_equal(setenv("PATH", path, 1), 0);
        assert_int_equal(start, STATUS_CHART);
        assert_non_null(strstr(started.message, "gnuplot-nox"));
    }
}

TEST_CASE(test_a_missing_directory_is_an_error)
{
    struct gnuplot gnuplot;
    expect_fails(STATUS_IO, "/nonexistent/charts", gnuplot_start, &gnuplot, "/nonexistent/charts");
}

/* commands, what the message has to say */
static const struct complaint {
    const char *commands, *message;
} complaints[] = {
    {"load 'bad.gp'", "gnuplot: \"bad.gp\" line 2: undefined variable: nothing_here"},
    {"load 'syntax.gp'", "gnuplot: \"syntax.gp\" line 1: "},
    {"load 'missing.gp'", "gnuplot: Cannot load input from 'missing.gp'"},
    {"plot 'missing.csv'", "missing.csv"},
    {"set terminal dumb\nset output 'x'\nplot [0:1] [0:1] 'none.csv'",
     "warning: Skipping data file with no valid points"},
    {"print 'a word'", "gnuplot: a word"},
    {"exit status 3", "status 3"},
};

PLACED(test_any_complaint_is_a_failure)
{
    directory_write(*state, "bad.gp", "x = 1\nplot nothing_here\n");
    directory_write(*state, "syntax.gp", "plot sin(x\n");
    directory_write(*state, "none.csv", "# nothing\n");
    for (size_t i = 0; i < sizeof complaints / sizeof *complaints; i++) {
        struct status status = {0};
        assert_int_equal(run(*state, complaints[i].commands, &status), STATUS_CHART);
        if (!strstr(status.message, complaints[i].message))
            fail_msg("'%s' does not say '%s'", status.message, complaints[i].message);
        assert_null(strpbrk(status.message, "\r\n\033"));
    }
}

PLACED(test_a_process_that_ended_early_is_reported_not_deadly)
{
    const struct sigaction before = {.sa_handler = SIG_DFL};
    struct sigaction after;
    assert_int_equal(sigaction(SIGPIPE, &before, NULL), 0);
    struct gnuplot gnuplot;
    expect_ok(gnuplot_start, &gnuplot, ((struct directory *)*state)->path);
    gnuplot_send(&gnuplot, "exit\n");
    assert_int_equal(program_wait(gnuplot.process, INFINITY), PROGRAM_ENDED);
    gnuplot_send(&gnuplot, "x = 1\n");
    expect_fails(STATUS_CHART, "before it had read all commands", gnuplot_finish, &gnuplot);
    sigset_t pending;
    assert_int_equal(sigpending(&pending), 0);
    assert_int_equal(sigismember(&pending, SIGPIPE), 0);
    assert_int_equal(sigaction(SIGPIPE, NULL, &after), 0);
    assert_ptr_equal(before.sa_handler, after.sa_handler);
}

static size_t open_files(void)
{
    size_t n = 0;
    DIR *directory = opendir("/proc/self/fd");
    assert_non_null(directory);
    while (readdir(directory))
        n++;
    closedir(directory);
    return n;
}

TEST_IN_DIRECTORY(test_the_user_s_setup_has_no_say)
{
    directory_write(place, ".gnuplot", "print 'start-up file'\n");
    const char *home = getenv("HOME");
    OWNED(memory_free) char *kept = home ? strdup(home) : NULL;
    setenv("HOME", place->path, 1);
    setenv("GNUTERM", "nonsense", 1);
    setenv("GNUPLOT_LIB", place->path, 1);
    struct status status = {0};
    enum status_code code =
        run(place, "if (strlen(system('echo $GNUTERM$GNUPLOT_LIB'))) { exit error 'set' }", &status);
    unsetenv("GNUTERM");
    unsetenv("GNUPLOT_LIB");
    if (kept)
        setenv("HOME", kept, 1);
    if (code)
        fail_msg("%s", status.message);
}

PLACED(test_no_descriptor_is_left_open)
{
    size_t before = open_files();
    run_well(*state, "x = 1");
    struct gnuplot gnuplot;
    expect_fails(STATUS_CHART, "", run, *state, "plot nothing_here");
    expect_fails(STATUS_IO, "", gnuplot_start, &gnuplot, "/nonexistent");
    assert_int_equal(open_files(), before);

    /* and a process started meanwhile by others does not hold the pipe open */
    expect_ok(gnuplot_start, &gnuplot, "/");
    assert_true(fcntl(gnuplot.input, F_GETFD) & FD_CLOEXEC);
    assert_true(fcntl(fileno(gnuplot.complaints), F_GETFD) & FD_CLOEXEC);
    expect_ok(gnuplot_finish, &gnuplot);
}

/* Starts a gnuplot of these lines. */
static struct gnuplot start_other(const struct directory *place, const char *lines)
{
    struct gnuplot gnuplot;
    struct status status = {0};
    char path[1024], *before = lasting("%s", getenv("PATH"));
    directory_write(place, "gnuplot", lines);
    snprintf(path, sizeof path, "%s/gnuplot", place->path);
    assert_int_equal(chmod(path, 0755), 0);
    assert_int_equal(setenv("PATH", place->path, 1), 0);
    enum status_code started = gnuplot_start(&gnuplot, place->path, &status);
    assert_int_equal(setenv("PATH", before, 1), 0);
    assert_int_equal(started, STATUS_OK);
    return gnuplot;
}

/* What it says is kept to some size, as it lies in memory. */
PLACED(test_endless_messages_are_cut)
{
    struct status status = {0};
    struct stat info;
    struct gnuplot gnuplot =
        start_other(*state, "#!/bin/sh\necho 'line 7: wrong'\n/usr/bin/head -c 30000000 /dev/zero\n");
    assert_int_equal(program_wait(gnuplot.process, INFINITY), PROGRAM_ENDED);
    assert_int_equal(fstat(fileno(gnuplot.complaints), &info), 0);
    assert_true(info.st_size <= 1 << 20);
    assert_int_equal(gnuplot_finish(&gnuplot, &status), STATUS_CHART);
    assert_string_equal(status.message, "gnuplot: line 7: wrong");
}

/* One that neither reads nor ends: it is not waited for longer than its time, nor when asked to stop. The last test:
 * nothing starts after it. */
PLACED(test_a_gnuplot_that_hangs_is_ended)
{
    for (int asked = 0; asked < 2; asked++) {
        struct gnuplot gnuplot = start_other(*state, "#!/bin/sh\ntrap '' INT TERM HUP\n/bin/sleep 1000\n");
        assert_true(gnuplot.most_seconds >= 60); /* for the slowest of machines */
        for (int i = 0; i < 100000; i++)
            gnuplot_send(&gnuplot, "x = 1\n");
        if (asked) {
            program_stop();
            expect_fails(STATUS_INTERRUPTED, "", gnuplot_finish, &gnuplot);
        } else {
            gnuplot.most_seconds = 0.2;
            expect_fails(STATUS_CHART, "gnuplot did not end within 0.2 s and was stopped", gnuplot_finish, &gnuplot);
        }
    }
}
