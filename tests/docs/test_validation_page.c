/* SPDX-License-Identifier: GPL-3.0-or-later */
/* docs/validation.md as it was made last: every truth is there, and no number beyond the bound beside it. */
#include "base/text.h"
#include "support.h"

static const char *const truths[] = {"Software gauges",   "elastic sinusoid (figure 4.2)",
                                     "Westergaard",       "Hertz",
                                     "Greenwood",         "GFMD",
                                     "6.1 to 6.3",        "direct solutions",
                                     "What is to be met", "95 % intervals",
                                     "made of scans",     "coverage"};

TEST_CASE(every_truth_is_held)
{
    struct text *page = support_text();
    size_t bounded = 0;
    expect_ok(text_read_file, page, PROJECT_SOURCE "/docs/validation.md");
    for (size_t i = 0; i < sizeof truths / sizeof *truths; i++)
        if (!strstr(page->data, truths[i]))
            fail_msg("the page says nothing of '%s'", truths[i]);
    for (char *at = page->data; (at = strstr(at, " (≤ ")); at++, bounded++) {
        char *start = at;
        while (start > page->data && start[-1] != '|')
            start--;
        double value = strtod(start, NULL), bound = strtod(at + strlen(" (≤ "), NULL);
        if (!(value <= bound) || !(bound > 0))
            fail_msg("%.40s", start);
    }
    assert_true(bounded > 50);
}
