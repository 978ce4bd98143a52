/* SPDX-License-Identifier: GPL-3.0-or-later */
/* docs/hard-cases.md as a whole: each section has its test, no number is beyond its bound, the cases that have to be
 * there are, and README.md has their count. The test that runs a row checks its words. */
#include "directory.h"

#include <glob.h>

static const char *const wanted[] = {
    "cancels",     "contact closes", "γ = 1 ",     "D → 0",      "5e-324",       "1e300",       "one point in contact",
    "λ ≪ spacing", "0.5 |",          "H ≪ E",      "H > E",      "11 points",    "10^7 points", "10^12 times",
    "periodic",    "constant",       "two-valued", "one spike",  "steps",        "missing",     "3000 scans",
    "10^6 loads",  "1e100 apart",    "delimiters", "last place", "results.json", "30 headers",  "a scan named -o",
    "SIGTERM",     "kill -9",        "archive",    "pipes",      "full"};

/** Cases on the page, as rows with a bound. */
static size_t count_cases(const char *page)
{
    size_t cases = 0;
    for (const char *at = page; (at = strstr(at, " (≤ ")); at++, cases++) {
        const char *start = at;
        while (start > page && start[-1] != ' ')
            start--;
        double number = strtod(start, NULL), bound = strtod(at + strlen(" (≤ "), NULL);
        if (!(number >= 0 && number <= 1.05 * bound)) /* two digits are printed */
            fail_msg("%.*s is beyond its bound", 60, start);
    }
    return cases;
}

TEST_CASE(the_page_is_whole)
{
    const char *page = directory_read(PROJECT_SOURCE, "docs/hard-cases.md"),
               *readme = directory_read(PROJECT_SOURCE, "README.md");
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++)
        if (!strstr(page, wanted[i]))
            fail_msg("no hard case with '%s'", wanted[i]);
    size_t cases = count_cases(page);
    assert_true(cases >= 60);
    if (!strstr(readme, filled("[%zu hard cases](docs/hard-cases.md)", cases)))
        fail_msg("README.md should say that there are %zu hard cases", cases);
}

/** A heading of the page for each HARD_CASES() of tests/, and none besides. */
TEST_CASE(sections_are_of_tests)
{
    const char *page = directory_read(PROJECT_SOURCE, "docs/hard-cases.md");
    size_t sections = times(page, "\n## "), sources = 0;
    glob_t files;
    assert_int_equal(glob(PROJECT_SOURCE "/tests/*/test_*.c", 0, NULL, &files), 0);
    for (size_t i = 0; i < files.gl_pathc; i++) {
        const char *path = files.gl_pathv[i] + sizeof PROJECT_SOURCE;
        const char *macro = strstr(directory_read(PROJECT_SOURCE, path), "\nHARD_CASES(\"");
        if (macro) {
            macro += strlen("\nHARD_CASES(\"");
            const char *heading =
                filled("\n## %.*s\n\nRun by [%s](../%s).\n", (int)strcspn(macro, "\""), macro, path, path);
            if (!strstr(page, heading))
                fail_msg("docs/hard-cases.md has no%s", heading);
            sources++;
        }
    }
    globfree(&files);
    assert_int_equal(sections, sources);
}
