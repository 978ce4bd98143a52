/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Short of memory the program says so in one line, and loses only what does not fit. */
#include "cli/process.h"

#ifdef __SANITIZE_ADDRESS__
#define NEEDS_LIMIT() skip() /* its shadow alone takes terabytes of addresses */
#else
#define NEEDS_LIMIT() (void)0
#endif

/** Runs the program, as `line` says, with so many MB of addresses. */
static struct process run_within(const char *place, int megabytes, const char *line)
{
    const char *script = filled("ulimit -v %d; exec \"$0\" %s", megabytes * 1000, line);
    return run_program(place, "sh", "-c", script, PROGRAM);
}

/** A scan that takes some 130 MB to be read. */
static void write_large(const char *place, const char *path)
{
    run_to_exit(place, 0, "synth", "-n", "2000000", "-l", "200mm", "-o", path);
}

/** However little there is, it is said in one line; 64 MB and less do not even hold gnuplot. */
TEST_IN_WORKSPACE(what_is_too_large_is_said)
{
    NEEDS_LIMIT();
    write_large(place, "a.csv");
    for (int megabytes = 30; megabytes <= 100; megabytes += 35)
        expect_failed(run_within(place, megabytes, "inspect a.csv"), 4, 1, "out of memory");
}

TEST_IN_WORKSPACE(a_surface_goes_aside)
{
    NEEDS_LIMIT();
    workspace_scan(place, "d/small.csv", 300, 1);
    write_large(place, "d/large.csv");
    struct process process = run_within(place, 100, "report d -o out --no-cost --brief -j1");
    assert_int_equal(process.status, 1);
    assert_string_equal(process.err, "surface 'large' refused: out of memory; thin its scans, or report it alone\n");
    expect_in_file(place, "out/results.json", "thin its scans", "\"small\"");
    expect_in_file(place, "out/data/contact.csv", "small");
}

TEST_IN_WORKSPACE(a_direct_solution_loses_its_section_only)
{
    NEEDS_LIMIT();
    workspace_scan(place, "d/a.csv", 300, 1);
    workspace_write(place, "d/scene.yaml", "material: tin\ndirect: {grid: 2048, seeds: 1, loads: [1e-3]}\n");
    for (int megabytes = 100; megabytes <= 200; megabytes += 50) {
        struct process process = run_within(place, megabytes, "report d -o out --no-cost -j2");
        assert_int_equal(process.status, 1);
        assert_string_equal(process.err, "surface 'a': no direct solution: out of memory on 2048 x 2048 points; take a "
                                         "smaller grid, or fewer threads (--jobs)\n");
        expect_in_file(place, "out/report.md", "is not solved: out of memory on 2048 x 2048 points");
        expect_in_file(place, "out/data/contact.csv", "multiscale");
    }
}
