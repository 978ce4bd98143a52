/* SPDX-License-Identifier: GPL-3.0-or-later */
/* OUT is complete or unchanged, whatever ends the run. */
#include "cli/process.h"
#include "hard_case.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>

HARD_CASES("Runs that do not end by themselves")

/** A scene whose run takes seconds: one scan under many names. */
static void write_slow_scene(const char *place)
{
    struct text *scene = support_text();
    text_add(scene, "tolerance: 1e-12\nsurfaces:\n");
    for (int i = 0; i < 3000; i++)
        text_add(scene, "  - {name: s%d, file: a.csv}\n", i);
    workspace_scan(place, "slow/a.csv", 2000, 1);
    workspace_write(place, "slow/scene.yaml", text_string(scene));
}

/** A good report to be kept: out/slow. */
static void write_report(const char *place)
{
    workspace_scan(place, "good/a.csv", 200, 1);
    run_to_exit(place, 0, "report", "--no-cost", "good", "-o", "out/slow", "-m", "tin", "-e", "plasticity");
}

/** Starts the slow run and sends it `signal_number` while it works, once its hidden folder holds a report. */
static struct process interrupt(const char *place, int signal_number)
{
    struct process_running running = process_start(place, "report", "slow");
    for (int i = 0; i < 2000 && workspace_count(place, "export") == 0; i++)
        support_pause();
    support_pause();
    assert_true(workspace_count(place, ".roughcontact-") > 0);
    assert_int_equal(kill(running.pid, signal_number), 0);
    return process_end(running);
}

TEST_IN_WORKSPACE(test_signals)
{
    write_slow_scene(place);
    write_report(place);
    char *before = workspace_digest(place, ".");
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
        expect_failed(interrupt(place, signals[i]), 128 + signals[i], 1,
                      "roughcontact: stopped by a signal; 'out/slow' is as it was before\n");
        char *after = workspace_digest(place, ".");
        hard_case("SIGINT, SIGTERM or SIGHUP while it works", "half a report over the one before",
                  "the report before stays, the status says by what it was stopped", "trees that differ",
                  strcmp(before, after) != 0, 0);
    }
}

TEST_IN_WORKSPACE(test_kill)
{
    write_slow_scene(place);
    write_report(place);
    char *before = workspace_digest(place, "out/slow");
    struct process process = interrupt(place, SIGKILL);
    assert_int_equal(process.status, 128 + SIGKILL);
    expect_digest(place, "out/slow", before);
    /* what is left behind disturbs no later run, which removes it */
    assert_int_equal(workspace_count(place, ".roughcontact-"), 1);
    write_report(place);
    expect_digest(place, "out/slow", before);
    hard_case("kill -9, and then a run", "hidden folders that stay", "the next run removes what was left",
              "folders left", (double)workspace_count(place, ".roughcontact-"), 0);
}

/** Puts a gnuplot first in PATH that never ends and takes no signal; its id is then in the file `hangs`. Returns PATH
 * as it was. */
static char *hang_gnuplot(const char *place)
{
    const char *script = lasting("#!/bin/sh\ntrap '' INT TERM HUP\necho $$ > %s/new; mv %s/new %s/hangs\nsleep 1000\n",
                                 place, place, place);
    return workspace_program(place, "gnuplot", script);
}

/** Has the process with this id a descriptor of the hidden directory, which is its lock? */
static bool holds_staging(const char *id)
{
    char leads[512];
    bool found = false;
    DIR *open = opendir(filled("/proc/%ld/fd", strtol(id, NULL, 10)));
    assert_non_null(open);
    for (const struct dirent *entry; (entry = readdir(open));) {
        ssize_t length = readlinkat(dirfd(open), entry->d_name, leads, sizeof leads - 1);
        leads[length > 0 ? length : 0] = '\0';
        const char *hidden = strstr(leads, "/.roughcontact-");
        found |= hidden && !strchr(hidden + 1, '/');
    }
    closedir(open);
    return found;
}

TEST_IN_WORKSPACE(test_a_hanging_gnuplot)
{
    write_report(place);
    char *before = workspace_digest(place, "out"), *path = hang_gnuplot(place);
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    assert_int_equal(prctl(PR_SET_CHILD_SUBREAPER, 1), 0);
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
        struct process_running running = process_start(place, "report", "--no-cost", "good", "-o", "out/slow");
        while (!workspace_has(place, "hangs"))
            support_pause();
        char *id = workspace_read(place, "hangs");
        assert_false(holds_staging(id));
        assert_int_equal(kill(running.pid, signals[i]), 0);
        expect_failed(process_end(running), 128 + signals[i], 1,
                      "roughcontact: stopped by a signal; 'out/slow' is as it was before\n");
        assert_int_equal(workspace_count(place, ".roughcontact-"), 0);
        assert_int_equal(unlink(directory_path(place, "hangs")), 0);
        while (waitpid(-1, NULL, 0) > 0) /* all that it had started comes to this process, and is gone */
            ;
        assert_int_equal(kill((pid_t)strtol(id, NULL, 10), 0), -1);
        assert_int_equal(errno, ESRCH);
    }
    workspace_take_back(path);
    expect_digest(place, "out", before);
}

/** Runs the program by a shell that sets the stage, with `arguments` besides DIR. */
#define staged(place, lines, ...)                                                                                      \
    process_end(process_start_list(                                                                                    \
        place, (const char *const[]){"sh", "-c", lines " exec \"$0\" \"$@\"", PROGRAM, __VA_ARGS__, NULL}, NULL))

/** Without standard output the report is still written, and stderr says so. */
TEST_IN_WORKSPACE(test_no_standard_output)
{
    static const char *const reasons[] = {"No space left on device", "Bad file descriptor", "Broken pipe"};
    workspace_scan(place, "good/a.csv", 200, 1);
    run_to_exit(place, 0, "report", "--no-cost", "good", "-o", "out/other");
    char *other = workspace_digest(place, "out/other");
    for (int i = 0; i < 3; i++) {
        struct process process;
        if (i == 0)
            process = staged(place, "exec >/dev/full;", "report", "--no-cost", "good", "-o", "out/slow");
        else if (i == 1)
            process = staged(place, "exec >&-;", "report", "--no-cost", "good", "-o", "out/slow");
        else {
            struct process_running running = process_start(place, "report", "--no-cost", "good", "-o", "out/slow");
            close(running.out); /* who reads it goes, as head does */
            running.out = open("/dev/null", O_RDONLY | O_CLOEXEC);
            process = process_end(running);
        }
        expect_part(process.err, filled("cannot write to standard output: %s; the report is written, in "
                                        "'out/slow/report.html'\n",
                                        reasons[i]));
        hard_case("standard output full, closed, or left by its reader", "the report is lost, or the end is 0",
                  "the report is written; the status is 4", "another status", process.status != 4, 0);
        assert_string_equal(process.out, "");
        expect_digest(place, "out/slow", other); /* nothing meant for the terminal is in it */
    }
    static const char *const commands[][3] = {{"materials"},
                                              {"--help"},
                                              {"synth"},
                                              {"inspect", "--json", "good/a.csv"},
                                              {"materials", "--json"},
                                              {"models", "--json"},
                                              {"plan", "good", "--json"}};
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
        const char *const *words = commands[i];
        expect_failed(staged(place, "exec >/dev/full;", words[0], words[1], words[2]), 4, 1,
                      "cannot write to standard output: No space left on device\n");
    }
}

/** It runs on the least stack that a system gives. */
TEST_IN_WORKSPACE(test_little_stack)
{
    workspace_scan(place, "good/a.csv", 2000, 1);
    workspace_write(place, "good/scene.yaml", "material: tin\ndirect: {grid: 32, seeds: 2, loads: [1e-3, 1e-2]}\n");
    struct process process = staged(place, "ulimit -s 64;", "direct", "good", "-o", "out/slow", "--show");
    hard_case("64 kB of stack", "arrays of a solution on it", "solved all the same", "exit status", process.status, 0);
}

/** As on a full disk, every write beyond some size fails. */
TEST_IN_WORKSPACE(test_no_room)
{
#ifdef __SANITIZE_THREAD__
    skip(); /* its run time writes files of its own, before the program can say that it may not */
#endif
    write_report(place);
    workspace_scan(place, "good/b.csv", 200, 2);
    char *before = workspace_digest(place, ".");
    struct rlimit usual, small;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &usual), 0);
    static const rlim_t sizes[] = {0, 100, 4000, 30000, 100000};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        small = (struct rlimit){sizes[i], usual.rlim_max};
        assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
        struct process_running running = process_start(place, "report", "--no-cost", "good", "-o", "out/slow");
        assert_int_equal(setrlimit(RLIMIT_FSIZE, &usual), 0);
        expect_failed(process_end(running), 4, 1, "ulimit -f");
        expect_digest(place, ".", before);
    }
}

/** Where the new file is too large, the former one stays. */
TEST_IN_WORKSPACE(test_no_room_for_a_scan)
{
    workspace_write(place, "a.csv", "before\n");
    char *before = workspace_digest(place, ".");
    static const char *const files[] = {"a.csv", "b.csv"};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        expect_failed(staged(place, "ulimit -f 1;", "synth", "-o", files[i]), 4, 1, "ulimit -f");
        char *after = workspace_digest(place, ".");
        hard_case("a disk that is full within a file", "half a scan over the one before", "the file before stays",
                  "trees that differ", strcmp(before, after) != 0, 0);
    }
    run_to_exit(place, 0, "synth", "-o", "a.csv");
    expect_in_file(place, "a.csv", "x [um],z [um]\n");
    assert_int_equal(workspace_count(place, ".roughcontact-"), 0);
}

TEST_GROUP(support_take_signals, NULL)
