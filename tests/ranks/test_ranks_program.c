/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The program over several processes: the plain program's report, its errors and its exit statuses. */
#include "cli/process.h"

#include <signal.h>
#include <stdio.h>
#include <time.h>

#define EFFECTS "effects: [plasticity, separation, electrical, thermal]\n"

static void write_scene(const char *place, const char *text)
{
    char scene[512];
    snprintf(scene, sizeof scene, "material: tin\nsurfaces: [{name: a, file: a.csv}]\n%s", text);
    workspace_scan(place, "d/a.csv", 400, 3);
    workspace_write(place, "d/scene.yaml", scene);
}

/** Starts the program over `ranks` processes. */
#define start(place, ranks, ...)                                                                                       \
    process_start_list((place), (const char *const[]){MPIEXEC, "-q", "-n", (ranks), PROGRAM_MPI, __VA_ARGS__, NULL},   \
                       NULL)
#define expect_ranks(place, status, ranks, ...)                                                                        \
    process_expect(process_end(start(place, ranks, __VA_ARGS__)), status, __FILE__, __LINE__)

static struct table data(const char *place, const char *out)
{
    char full[512];
    snprintf(full, sizeof full, "%s/%s/data/direct.csv", place, out);
    return table_read_path(full);
}

/** The same table, numbers to 1e-9 and the rest to the letter. */
static void expect_same(const char *place, const char *one, const char *two)
{
    struct table a = data(place, one), b = data(place, two);
    assert_true(a.rows > 0 && a.columns > 8);
    assert_int_equal(a.rows, b.rows);
    assert_int_equal(a.columns, b.columns);
    for (size_t i = 0; i < a.rows; i++)
        for (size_t c = 0; c < a.columns; c++) {
            const char *name = a.cell[c], *left = table_text(&a, i, name), *right = table_text(&b, i, name);
            char *end;
            double value = strtod(left, &end);
            if (*left == '\0' || *end != '\0')
                assert_string_equal(left, right);
            else
                assert_near(table_number(&b, i, name), value, 1e-9);
        }
    table_free(&a);
    table_free(&b);
}

/** How many lines of `text` begin with "roughcontact: ". */
static size_t complaints(const char *text)
{
    size_t count = 0;
    for (const char *at = text; (at = strstr(at, "roughcontact: ")); at++)
        count++;
    return count;
}

TEST_IN_WORKSPACE(same_report)
{
    write_scene(place, EFFECTS "direct: {grid: 64, seeds: 3, loads: [1e-3, 4e-3, 1e-2], hardness: 4 GPa}\n");
    struct process run = expect_exit(place, 0, "direct", "d", "-o", "plain", "--no-cost");
    process_free(&run);
    static const char *const ranks[] = {"1", "2", "4"};
    for (size_t k = 0; k < 3; k++) {
        run = expect_ranks(place, 0, ranks[k], "direct", "d", "-o", ranks[k], "--no-cost");
        expect_part(run.out, "/report.html\n");
        expect_same(place, "plain", ranks[k]);
        process_free(&run);
    }
}

/** Without a direct solution the report has the bytes that one process writes, and the messages come once. */
TEST_IN_WORKSPACE(same_bytes)
{
    write_scene(place, EFFECTS);
    workspace_write(place, "d/text.csv", "no,unit\n1,2\n");
    workspace_write(place, "d/scene.yaml",
                    "material: tin\nsurfaces: [{name: a, file: a.csv}, {name: b, file: text.csv}]\n" EFFECTS);
    struct process one = expect_exit(place, 1, "report", "d", "-o", "plain", "--no-cost");
    struct process run = expect_ranks(place, 1, "3", "report", "d", "-o", "shared", "--no-cost");
    char *reference = workspace_digest(place, "plain"), *digest = workspace_digest(place, "shared");
    assert_string_equal(digest, reference);
    assert_int_equal(complaints(run.err), complaints(one.err));
    free(digest);
    free(reference);
    process_free(&one);
    process_free(&run);
}

/** One process here and one in the folder `where`, which has `what` to do there. */
static struct process two_places(const char *place, const char *where, const char *what)
{
    return process_end(process_start_list(place,
                                          (const char *const[]){MPIEXEC, "-q", "-n", "1", PROGRAM_MPI, "direct", "d",
                                                                "--no-cost", ":", "-n", "1", "-wdir", where,
                                                                PROGRAM_MPI, "direct", what, "--no-cost", NULL},
                                          NULL));
}

/** Only the first process reads the scene; but another scene, asked for by another, is an error. */
TEST_IN_WORKSPACE(other_places)
{
    write_scene(place, EFFECTS "direct: {grid: 64, seeds: 1, loads: [1e-3]}\n");
    workspace_folder(place, "nowhere");
    struct process run = two_places(place, ".", "e");
    process_expect(run, 2, __FILE__, __LINE__);
    expect_part(run.err, "started with different arguments");
    assert_int_equal(complaints(run.err), 1);
    assert_false(workspace_has(place, "out/d/report.md"));
    process_free(&run);
    run = two_places(place, "nowhere", "d");
    process_expect(run, 0, __FILE__, __LINE__);
    process_free(&run);
    run = expect_exit(place, 0, "direct", "d", "-o", "plain", "--no-cost");
    expect_same(place, "plain", "out/d");
    process_free(&run);
}

TEST_IN_WORKSPACE(errors)
{
    write_scene(place, "direct: {grid: 63}\n");
    struct process run = expect_ranks(place, 3, "3", "direct", "d");
    expect_part(run.err, "'grid' is 63");
    assert_int_equal(complaints(run.err), 1);
    process_free(&run);
    run = expect_ranks(place, 2, "3", "direct", "d", "--jobs", "0");
    expect_part(run.err, "--jobs must be 1 to 64");
    process_free(&run);
    run = expect_ranks(place, 2, "2", "no-such-command");
    assert_int_equal(complaints(run.err), 1);
    process_free(&run);
    run = expect_ranks(place, 0, "2", "--help");
    expect_part(run.out, "roughcontact direct");
    process_free(&run);
}

/** mpirun passes a signal on to all ranks; none stays behind and OUT is untouched. */
TEST_IN_WORKSPACE(stopped)
{
    write_scene(place, EFFECTS "direct: {grid: 256, seeds: 1000, loads: [1e-4, 1e-3, 4e-3, 1e-2]}\n");
    struct process_running running = start(place, "3", "direct", "d", "--no-cost");
    const struct timespec pause = {.tv_nsec = 50000000};
    for (int i = 0; i < 400 && workspace_count(place, ".roughcontact-") == 0; i++)
        nanosleep(&pause, NULL);
    assert_true(workspace_count(place, ".roughcontact-") > 0);
    for (int i = 0; i < 20; i++)
        nanosleep(&pause, NULL);
    assert_int_equal(kill(running.pid, SIGTERM), 0);
    struct process run = process_end(running);
    assert_int_not_equal(run.status, 0);
    assert_false(workspace_has(place, "out/d/report.md"));
    process_free(&run);
}
