/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/output.h"
#include "pipeline.h"

static int place_setup(void **state)
{
    static struct directory place;
    place = directory_make();
    mkdir(directory_path(&place, "in"), 0777);
    pipeline_rough(&place, "in/b.csv", 90, 0.1, 1);
    pipeline_rough(&place, "in/a.csv", 91, 1, 2);
    pipeline_rough(&place, "in/c.csv", 64, 20, 3);
    *state = &place;
    return 0;
}

static struct run_options options_to(const char *target)
{
    return (struct run_options){.output = target, .templates = PROJECT_SOURCE "/templates", .jobs = 1, .no_cost = true};
}

/* Are the trees of two directories the same, names and bytes? */
static void assert_same_tree(const struct directory *place, const char *a, const char *b, size_t *files)
{
    assert_int_equal(directory_entries(place, a), directory_entries(place, b));
    DIR *open = opendir(directory_path(place, a));
    assert_non_null(open);
    for (const struct dirent *entry; (entry = readdir(open));) {
        char one[512], two[512];
        struct stat info;
        if (entry->d_name[0] == '.')
            continue;
        snprintf(one, sizeof one, "%s/%s", a, entry->d_name);
        snprintf(two, sizeof two, "%s/%s", b, entry->d_name);
        assert_int_equal(stat(directory_path(place, one), &info), 0);
        if (S_ISDIR(info.st_mode)) {
            assert_same_tree(place, one, two, files);
            continue;
        }
        struct text first = directory_read(place, one), second = directory_read(place, two);
        if (first.length != second.length || memcmp(first.data, second.data, first.length) != 0)
            fail_msg("%s and %s differ", one, two);
        text_free(&first);
        text_free(&second);
        ++*files;
    }
    closedir(open);
}

#define PLACED(name) TEST_WITH(name, place_setup, directory_teardown)

/* Same input, same bytes; also with more threads, and with a report to replace. */
PLACED(test_runs_repeat_to_the_byte)
{
    size_t files = 0;
    directory_write(*state, "in/scene.yaml",
                    "material: tin\nload: {from: 1e-6, to: 1, points: 9}\nconvergence: {scales: 20}\n");
    assert_int_equal(pipeline_run(*state, "in", "one", 1), 0);
    assert_int_equal(pipeline_run(*state, "in", "two", 1), 0);
    assert_same_tree(*state, "one", "two", &files);
    assert_true(files > 3 * 9 + 12); /* csv, gp and svg of every figure, and the rest */
    assert_int_equal(pipeline_run(*state, "in", "two", 2), 0);
    assert_same_tree(*state, "one", "two", &files);
    assert_int_equal(directory_entries(*state, ""), 3);
}

/* One scan that is none: named, with why; the others are reported as if it were not there. */
PLACED(test_a_refused_scan_does_not_stop_the_others)
{
    struct run_outcome outcome;
    struct status status = {0};
    char target[4096];
    directory_write(*state, "in/scene.yaml", "effects: [electrical]\nmaterial: tin\n");
    assert_int_equal(pipeline_run(*state, "in", "without", 1), 0);
    directory_write(*state, "in/aa.csv", "1,1\n2,1\n3,1\n4,1\n");
    snprintf(target, sizeof target, "%s", directory_path(*state, "with"));
    assert_int_equal(pipeline_try(&outcome, *state, "in", options_to(target), &status), STATUS_OK);
    assert_int_equal(outcome.surfaces, 3);
    assert_int_equal(outcome.refused, 1);
    assert_non_null(strstr(text_string(&outcome.messages), "surface 'aa' refused: "));
    assert_non_null(strstr(outcome.path, "/with/report.html"));
    struct text with = directory_read(*state, "with/data/contact.csv"),
                without = directory_read(*state, "without/data/contact.csv");
    assert_string_equal(text_string(&with), text_string(&without));
    expect_in_file(*state, "with/report.md", "aa");
    text_free(&with);
    text_free(&without);
    run_outcome_free(&outcome);
}

/* Runs that end early leave OUT and what is around it as they were. */
static void assert_untouched(const struct directory *place, struct run_options options, enum status_code expected,
                             const char *words)
{
    struct run_outcome outcome;
    struct status status = {0};
    char target[4096];
    size_t entries = directory_entries(place, "");
    snprintf(target, sizeof target, "%s", directory_path(place, "out"));
    options.output = target;
    assert_int_equal(pipeline_try(&outcome, place, "in", options, &status), expected);
    if (!strstr(status.message, words))
        fail_msg("'%s' without '%s'", status.message, words);
    assert_null(outcome.path);
    run_outcome_free(&outcome);
    assert_int_equal(directory_entries(place, ""), entries);
    struct text text = directory_read(place, "out/report.md");
    assert_string_equal(text_string(&text), "before");
    text_free(&text);
    assert_int_equal(directory_entries(place, "out"), 3);
}

PLACED(test_a_run_that_fails_leaves_the_report_before)
{
    const struct directory *place = *state;
    const atomic_bool stop = true;
    struct run_options options = options_to(NULL);
    mkdir(directory_path(place, "out"), 0777);
    directory_write(place, "out/report.md", "before");
    directory_write(place, "out/results.json", "{}");
    directory_write(place, "out/manifest.txt", OUTPUT_MANIFEST_HEADER "manifest.txt\nreport.md\nresults.json\n");
    options.stop = &stop;
    assert_untouched(place, options, STATUS_INTERRUPTED, "stopped");
    options = options_to(NULL);
    options.templates = directory_path(place, "no templates here");
    assert_untouched(place, options, STATUS_IO, "no templates here");
    for (const char *name = "abc"; *name; name++) {
        char file[16];
        snprintf(file, sizeof file, "in/%c.csv", *name);
        directory_write(place, file, "no numbers\n");
    }
    assert_untouched(place, options_to(NULL), STATUS_SCAN, "no readable scan");
    for (const char *name = "abc"; *name; name++) {
        char file[16];
        snprintf(file, sizeof file, "in/%c.csv", *name);
        unlink(directory_path(place, file));
    }
    assert_untouched(place, options_to(NULL), STATUS_SCAN, "no scan in");
}

/* The signal comes while surfaces are being evaluated. */
static atomic_bool stop_soon;
static size_t evaluated;

static void ask_to_stop(size_t done, size_t total, const char *name)
{
    (void)name;
    assert_int_equal(total, 3);
    evaluated = done;
    stop_soon = true;
}

PLACED(test_a_signal_halfway_stops_the_run)
{
    const struct directory *place = *state;
    struct run_options options = options_to(NULL);
    mkdir(directory_path(place, "out"), 0777);
    directory_write(place, "out/report.md", "before");
    directory_write(place, "out/results.json", "{}");
    directory_write(place, "out/manifest.txt", OUTPUT_MANIFEST_HEADER "manifest.txt\nreport.md\nresults.json\n");
    options.stop = &stop_soon;
    options.progress = ask_to_stop;
    assert_untouched(place, options, STATUS_INTERRUPTED, "stopped");
    assert_int_equal(evaluated, 1); /* no other surface was begun */
}

PLACED(test_the_baseline_and_the_order_do_not_depend_on_file_names)
{
    struct run_outcome outcome;
    struct status status = {0};
    char target[4096];
    directory_write(*state, "in/scene.yaml", "material: tin\neffects: [electrical]\n");
    snprintf(target, sizeof target, "%s", directory_path(*state, "out"));
    assert_int_equal(pipeline_try(&outcome, *state, "in", options_to(target), &status), STATUS_OK);
    struct text report = directory_read(*state, "out/report.md");
    assert_non_null(strstr(text_string(&report), "*a* at ")); /* the second smoothest */
    text_free(&report);
    run_outcome_free(&outcome);
    directory_write(*state, "in/scene.yaml", "material: tin\neffects: [electrical]\nbaseline: c\n");
    assert_int_equal(pipeline_run(*state, "in", "out", 1), 0);
    report = directory_read(*state, "out/report.md");
    assert_non_null(strstr(text_string(&report), "*c* at "));
    text_free(&report);
}

static enum status_code fail_to_converge(const struct direct_team *team, size_t n, double spacing_m,
                                         const struct direct_ladder_def *def, struct status *status)
{
    (void)team, (void)n, (void)spacing_m, (void)def;
    return status_fail(status, STATUS_MODEL, "the direct solution does not converge at p/E' = 0.01");
}

/* A direct solution that does not converge gives no number and takes none of the report away. */
PLACED(test_no_convergence_leaves_the_report)
{
    struct run_outcome outcome;
    struct status status = {0};
    char target[4096];
    const struct direct_team team = {.size = 1, .call = fail_to_converge};
    directory_write(*state, "in/scene.yaml",
                    "material: tin\neffects: [electrical]\nbaseline: b\ndirect: {grid: 64, seeds: 1, loads: 3}\n");
    snprintf(target, sizeof target, "%s", directory_path(*state, "out"));
    struct run_options options = options_to(target);
    options.team = &team;
    assert_int_equal(pipeline_try(&outcome, *state, "in", options, &status), STATUS_OK);
    run_outcome_free(&outcome);
    expect_in_file(*state, "out/report.md", "## How true\n\nNo direct solution: ", "does not converge at p/E' = 0.01",
                   "*b* at ");
    expect_not_in_file(*state, "out/report.md", "figures/direct");
    char path[4096];
    snprintf(path, sizeof path, "%s", directory_path(*state, "out/data/direct.csv"));
    assert_int_equal(access(path, F_OK), -1);
}
