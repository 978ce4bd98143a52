/* SPDX-License-Identifier: GPL-3.0-or-later */
/* docs/validation.md as it was made last: every truth is there, and no number beyond the bound beside it. */
#include "directory.h"

static const char *const truths[] = {"Software gauges",   "elastic sinusoid (figure 4.2)",
                                     "Westergaard",       "Hertz",
                                     "Greenwood",         "GFMD",
                                     "6.1 to 6.3",        "direct solutions",
                                     "What is to be met", "95 % intervals",
                                     "made of scans",     "coverage"};

TEST_CASE(every_truth_is_held)
{
    char *page = directory_read(PROJECT_SOURCE, "docs/validation.md");
    size_t bounded = 0;
    for (size_t i = 0; i < sizeof truths / sizeof *truths; i++)
        if (!strstr(page, truths[i]))
            fail_msg("the page says nothing of '%s'", truths[i]);
    for (char *at = page; (at = strstr(at, " (≤ ")); at++, bounded++) {
        char *start = at;
        while (start > page && start[-1] != '|')
            start--;
        double value = strtod(start, NULL), bound = strtod(at + strlen(" (≤ "), NULL);
        if (!(value <= bound) || !(bound > 0))
            fail_msg("%.40s", start);
    }
    assert_true(bounded > 50);
}

/** The README's table: errors of the leading answer, and how many of its intervals hold. */
TEST_CASE(the_readme_has_the_pages_figures)
{
    static const char *const scans[] = {"\n| 5 scans, 4 waves | ", "\n| 1 scan, 4 waves | ",
                                        "\n| 5 scans, 0.6 waves | "};
    struct text *page = support_text(), *readme = support_text();
    double error[3][3], beyond[3];
    expect_ok(text_read_file, page, PROJECT_SOURCE "/docs/validation.md");
    expect_ok(text_read_file, readme, PROJECT_SOURCE "/README.md");
    const char *all = strstr(strstr(page->data, "\n| leading answer "), "\n| all | ");
    assert_int_equal(sscanf(all, "\n| all | %lf %lf %lf | %lf %lf %lf | %*f %*f %*f | %lf %lf %lf", &error[0][0],
                            &error[0][1], &error[0][2], &error[1][0], &error[1][1], &error[1][2], &error[2][0],
                            &error[2][1], &error[2][2]),
                     9);
    for (int i = 0; i < 3; i++) {
        const char *at = strstr(strstr(page->data, "\n## 95 % intervals"), scans[i]);
        for (int q = 0; q < 3; q++) {
            at = strchr(at + 2, '|');
            beyond[q] = strtod(at + 1, NULL);
        }
        expect_parts(readme->data,
                     filled("| %.2f | %.2f | %.2f | %.0f, %.0f, %.0f %% |\n", error[i][0], error[i][1], error[i][2],
                            100 * (1 - beyond[0]), 100 * (1 - beyond[1]), 100 * (1 - beyond[2])));
    }
}
