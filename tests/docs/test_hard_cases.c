/* SPDX-License-Identifier: GPL-3.0-or-later */
/* docs/hard-cases.md as a whole: each section has its test, no number is beyond its bound, the cases that have to be
 * there are, and README.md has their count. The test that runs a row checks its words. */
#include "base/text.h"
#include "support.h"

#include <glob.h>
#include <stdio.h>

static struct text document(const char *name)
{
    struct text text = {0};
    expect_ok(text_read_file, &text, filled("%s/%s", PROJECT_SOURCE, name));
    return text;
}

static const char *const wanted[] = {
    "cancels",     "contact closes", "γ = 1 ",     "D → 0",      "5e-324",       "1e300",       "one point in contact",
    "λ ≪ spacing", "0.5 |",          "H ≪ E",      "H > E",      "11 points",    "10^7 points", "10^12 times",
    "periodic",    "constant",       "two-valued", "one spike",  "steps",        "missing",     "3000 scans",
    "10^6 loads",  "1e100 apart",    "delimiters", "last place", "results.json", "30 headers",  "a scan named -o",
    "SIGTERM",     "kill -9",        "archive",    "pipes",      "full"};

/** Cases on the page, as rows with a bound. */
static size_t count_cases(const struct text *page)
{
    size_t cases = 0;
    for (const char *at = page->data; (at = strstr(at, " (≤ ")); at++, cases++) {
        const char *start = at;
        while (start > page->data && start[-1] != ' ')
            start--;
        double number = strtod(start, NULL), bound = strtod(at + strlen(" (≤ "), NULL);
        if (!(number >= 0 && number <= 1.05 * bound)) /* two digits are printed */
            fail_msg("%.*s is beyond its bound", 60, start);
    }
    return cases;
}

TEST_CASE(the_page_is_whole)
{
    struct text page = document("docs/hard-cases.md"), readme = document("README.md");
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++)
        if (!strstr(page.data, wanted[i]))
            fail_msg("no hard case with '%s'", wanted[i]);
    size_t cases = count_cases(&page);
    assert_true(cases >= 60);
    if (!strstr(readme.data, filled("[%zu hard cases](docs/hard-cases.md)", cases)))
        fail_msg("README.md should say that there are %zu hard cases", cases);
    text_free(&page);
    text_free(&readme);
}

/** A heading of the page for each HARD_CASES() of tests/, and none besides. */
TEST_CASE(sections_are_of_tests)
{
    struct text page = document("docs/hard-cases.md");
    size_t sections = 0, sources = 0;
    glob_t files;
    for (const char *at = page.data; (at = strstr(at, "\n## ")); at++)
        sections++;
    assert_int_equal(glob(PROJECT_SOURCE "/tests/*/test_*.c", 0, NULL, &files), 0);
    for (size_t i = 0; i < files.gl_pathc; i++) {
        const char *path = files.gl_pathv[i] + sizeof PROJECT_SOURCE;
        struct text source = document(path);
        const char *macro = strstr(source.data, "\nHARD_CASES(\"");
        if (macro) {
            macro += strlen("\nHARD_CASES(\"");
            const char *heading =
                filled("\n## %.*s\n\nRun by [%s](../%s).\n", (int)strcspn(macro, "\""), macro, path, path);
            if (!strstr(page.data, heading))
                fail_msg("docs/hard-cases.md has no%s", heading);
            sources++;
        }
        text_free(&source);
    }
    globfree(&files);
    assert_int_equal(sections, sources);
    text_free(&page);
}
