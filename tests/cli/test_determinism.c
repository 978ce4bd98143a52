/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The same input gives the same bytes: whatever the threads, the directory one stands in, the locale, the time zone. */
#include "base/hash.h"
#include "cli/process.h"
#include "hard_case.h"

#include <locale.h>

HARD_CASES("The same bytes")

static void expect_same(const char *place, const char *reference, const char *report)
{
    char *digits = workspace_digest(place, report);
    hard_case(
        "1, 2 and 7 threads, other directories, locales with a comma, time zones, terminals, over a former report",
        "a last digit that hangs on who was first", "the same bytes", "reports that differ",
        strcmp(digits, reference) != 0, 0);
}

static void run(const char *place, const char *output, const char *extra)
{
    run_to_exit(place, 0, "report", "d", "--no-cost", "-o", output, extra);
}

static void write_scans(const char *place)
{
    workspace_scans(place, "d", 2, 400, 1);
    workspace_scan(place, "d/c.csv", 500, 3);
    workspace_scan(place, "d/d.csv", 600, 4);
}

TEST_IN_WORKSPACE(test_same_bytes)
{
    write_scans(place);
    workspace_write(place, "d/scene.yaml",
                    "models: [multiscale, strip]\ndirect: {grid: 64, seeds: 2, loads: [1e-3, 4e-3]}\n");
    run(place, "one", "--jobs=1");
    char *reference = workspace_digest(place, "one");
    run(place, "one", "--jobs=2"); /* over the former report */
    expect_same(place, reference, "one");
    workspace_folder(place, "empty");
    run(place, "empty/", "--jobs=7"); /* into an empty directory, with a slash */
    expect_same(place, reference, "empty");

    static const char *const variables[][2] = {{"TZ", "Asia/Kathmandu"}, {"LC_ALL", "de_DE.UTF-8"},
                                               {"LANG", "de_DE.UTF-8"},  {"COLUMNS", "43"},
                                               {"GNUTERM", "png"},       {"HOME", "/nowhere"}};
    if (!setlocale(LC_ALL, "de_DE.UTF-8"))
        print_message("[  NOTE    ] no locale de_DE.UTF-8 here: its number format is not tested\n");
    setlocale(LC_ALL, "C");
    char *usual[sizeof variables / sizeof *variables];
    for (size_t i = 0; i < sizeof variables / sizeof *variables; i++) {
        usual[i] = getenv(variables[i][0]) ? lasting("%s", getenv(variables[i][0])) : NULL;
        assert_int_equal(setenv(variables[i][0], variables[i][1], 1), 0);
    }
    run(place, "deep/er/two", "--jobs=2");
    for (size_t i = 0; i < sizeof variables / sizeof *variables; i++)
        assert_int_equal(usual[i] ? setenv(variables[i][0], usual[i], 1) : unsetenv(variables[i][0]), 0);
    expect_same(place, reference, "deep/er/two");
}

/* results.json has the hash of the file, which is so large that another thread hashes it while it is read. */
static void expect_hash(const char *place, const char *path, const char *file)
{
    char *bytes = workspace_read(place, file), digits[65];
    struct hash hash = hash_start();
    assert_true(strlen(bytes) > 1 << 20);
    hash_add(&hash, bytes, strlen(bytes));
    hash_finish(&hash, digits);
    expect_in_file(place, path, filled("\"sha256\": \"%s\"", digits));
}

/* One large scan by some models, and a smaller one by all. Its strips take seconds, so they are solved only twice, and
 * not at all under sanitizers, which see those of small scans. */
TEST_IN_WORKSPACE(test_one_large_scan)
{
    static const char *const scenes[] = {
        "material: tin\nmodels: [multiscale, gw]\n",
#if !defined __SANITIZE_ADDRESS__ && !defined __SANITIZE_THREAD__ /* minutes; its threads are test_same_bytes' */
        "material: tin\n",
#endif
    };
    for (size_t s = 0; s < sizeof scenes / sizeof *scenes; s++) {
        workspace_scan(place, "d/a.csv", s == 0 ? 70000 : 20000, 5);
        workspace_write(place, "d/scene.yaml", scenes[s]);
        run(place, "one", "--jobs=1");
        char *reference = workspace_digest(place, "one");
        run(place, "two", "--jobs=2");
        expect_same(place, reference, "two");
        if (s == 0) {
            expect_hash(place, "one/results.json", "d/a.csv");
            run(place, "seven", "--jobs=7");
            expect_same(place, reference, "seven");
        }
    }
}

TEST_IN_WORKSPACE(test_other_directories)
{
    write_scans(place);
    expect_output(expect_exit(place, 0, "report", "--no-cost", "d"), "\nout/d/report.html\n");
    char *reference = workspace_digest(place, "out/d");

    expect_output(expect_exit(place, 0, "report", "--no-cost", "./d///", "-o", "slashes///"),
                  "\nslashes/report.html\n");
    expect_same(place, reference, "slashes");

    char *below = lasting("%s/e/f", place), *absolute = lasting("%s/d", place),
         *elsewhere = lasting("%s/elsewhere", place);
    workspace_folder(place, "e/f");
    run_to_exit(below, 0, "report", "--no-cost", "../../d");
    expect_same(place, reference, "e/f/out/d");
    run_to_exit("/", 0, "report", "--no-cost", absolute, "-o", elsewhere);
    expect_same(place, reference, "elsewhere");
    run_to_exit(absolute, 0, "report", "--no-cost", ".", "-o", elsewhere);
    expect_same(place, reference, "elsewhere");
}
