/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_quantities.h"
#include "output/exchange.h"
#include "pipeline.h"

static int place_setup(void **state)
{
    static struct directory place;
    place = directory_make();
    pipeline_rough(&place, "in/b.csv", 90, 0.1, 1);
    pipeline_rough(&place, "in/a.csv", 91, 1, 2);
    pipeline_rough(&place, "in/c.csv", 64, 20, 3);
    *state = &place;
    return 0;
}

#define PLACED(name) TEST_WITH(name, place_setup, directory_teardown)

static void write_report_before(const struct directory *place)
{
    directory_write(place, "out/report.md", "before");
    directory_write(place, "out/results.json", "{}");
    directory_write(place, "out/manifest.txt", OUTPUT_MANIFEST_HEADER "manifest.txt\nreport.md\nresults.json\n");
}

/* A run that fails leaves OUT and its surroundings as they were. */
static void assert_untouched(const struct directory *place, struct run_options options, enum status_code expected,
                             const char *words)
{
    struct status status = {0};
    size_t entries = directory_entries(place, "");
    assert_null(pipeline_into(place, "in", "out", options, &status)->path);
    assert_int_equal(status.code, expected);
    expect_parts(status.message, words);
    assert_int_equal(directory_entries(place, ""), entries);
    directory_holds(place, "out/report.md", "before");
    assert_int_equal(directory_entries(place, "out"), 3);
}

PLACED(test_a_run_that_fails_leaves_the_report_before)
{
    static const char *const scans[] = {"in/a.csv", "in/b.csv", "in/c.csv"};
    const struct directory *place = *state;
    const atomic_bool stop = true;
    write_report_before(place);
    assert_untouched(place, (struct run_options){.stop = &stop}, STATUS_INTERRUPTED, "stopped");
    assert_untouched(place, (struct run_options){.templates = directory_path(place, "no templates here")}, STATUS_IO,
                     "no templates here");
    for (int i = 0; i < 3; i++)
        directory_write(place, scans[i], "no numbers\n");
    assert_untouched(place, (struct run_options){0}, STATUS_SCAN, "no usable surface");
    for (int i = 0; i < 3; i++)
        unlink(directory_path(place, scans[i]));
    assert_untouched(place, (struct run_options){0}, STATUS_SCAN, "no scan in");
}

/* A signal comes while surfaces are evaluated. */
static atomic_bool stop_soon;
static double evaluated;

static void ask_to_stop(const char *stage, const char *name, double done, double all)
{
    (void)stage, (void)name;
    assert_near(all, 3, 0);
    evaluated = done;
    stop_soon = done > 0;
}

PLACED(test_a_signal_halfway_stops_the_run)
{
    write_report_before(*state);
    assert_untouched(*state, (struct run_options){.stop = &stop_soon, .progress = ask_to_stop}, STATUS_INTERRUPTED,
                     "stopped");
    assert_near(evaluated, 1, 0); /* no other surface was begun */
}

/* Progress is reported by one thread at a time. */
static atomic_int telling;
static atomic_bool at_once;
static double told;

static void tell_slowly(const char *stage, const char *name, double done, double all)
{
    (void)stage, (void)name;
    at_once |= atomic_fetch_add(&telling, 1) > 0 || !(done == 0 || done > told || done == all);
    told = done;
    usleep(50000);
    telling--;
}

PLACED(test_threads_tell_one_at_a_time)
{
    pipeline_outcome(*state, "in", "out", (struct run_options){.jobs = 3, .progress = tell_slowly});
    assert_near(told, 3, 0);
    assert_false(at_once);
}

PLACED(test_the_baseline_and_the_order_do_not_depend_on_file_names)
{
    pipeline_report(*state, "in", "out", "material: tin\neffects: [electrical]\n");
    expect_in_file(*state, "out/report.md", "*a* at "); /* the second smoothest */
    pipeline_report(*state, "in", "out", "material: tin\neffects: [electrical]\nbaseline: c\n");
    expect_in_file(*state, "out/report.md", "*c* at ");
}

/* In place of direct_ladder_run() (ld --wrap, tests/CMakeLists.txt): none converges. */
enum status_code __wrap_direct_ladder_run(struct direct_point *out, struct direct_contact *contact,
                                          const struct direct_ladder_def *def, struct status *status);
enum status_code __wrap_direct_ladder_run(struct direct_point *out, struct direct_contact *contact,
                                          const struct direct_ladder_def *def, struct status *status)
{
    (void)out, (void)contact, (void)def;
    return status_fail(status, STATUS_MODEL, "the direct solution does not converge at p/E' = 0.01");
}

/* Without convergence of the direct solution the rest of the report stays. */
PLACED(test_no_convergence_leaves_the_report)
{
    pipeline_report(*state, "in", "out",
                    "material: tin\neffects: [electrical]\nbaseline: b\ndirect: {grid: 64, seeds: 1, loads: 3}\n");
    expect_in_file(*state, "out/report.md", "## The models against the direct solution\n\n*b* is not solved: ",
                   "does not converge at p/E' = 0.01", "*b* at ");
    expect_not_in_file(*state, "out/report.md", "figures/direct");
    assert_false(directory_has(*state, "out/data/direct.csv"));
}
