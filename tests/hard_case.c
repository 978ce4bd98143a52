/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "hard_case.h"

#include "base/text.h"

#include <stdio.h>
#include <sys/file.h>
#include <unistd.h>

#define PAGE PROJECT_SOURCE "/docs/hard-cases.md"

static struct section {
    const char *heading, *file;
} sections[16], section;
static size_t section_count;
static struct hard_case *rows[64];
static size_t row_count;

void hard_cases_section(const char *heading, const char *file)
{
    if (section_count == sizeof sections / sizeof *sections)
        abort();
    for (const char *at = file; (at = strstr(at, "tests/")); at++)
        sections[section_count] = (struct section){heading, at};
    section_count++;
}

void hard_case_met(struct hard_case *row, double number, double bound, const char *file, int line)
{
    if (!(number >= 0 && number <= bound)) {
        print_error("%s: %s is %.17g, allowed %g\n", row->words[0], row->words[3], number, bound);
        _fail(file, line);
    }
    if (!row->met) {
        for (int i = 0; i < 4; i++)
            assert_null(strchr(row->words[i], '|'));
        assert_true(row_count < sizeof rows / sizeof *rows);
        rows[row_count++] = row;
        row->bound = bound;
        row->met = true;
    }
    assert_true(row->bound == bound);
    row->worst = fmax(row->worst, number);
}

/** A count in full, anything else in two digits. */
static const char *number_text(double number)
{
    return filled(number == round(number) && number < 1e7 ? "%.0f" : "%.2g", number + 0.0); /* no -0 */
}

/** What the page says before the number of a row, and behind it. */
static const char *before_number(const struct hard_case *row)
{
    return filled("| %s | %s | %s | %s: ", row->words[0], row->words[1], row->words[2], row->words[3]);
}

static const char *behind_number(const struct hard_case *row)
{
    return filled(" (≤ %g) |\n", row->bound);
}

static const char *section_start(void)
{
    return filled("## %s\n\nRun by [%s](../%s).\n\n"
                  "| case | what could go wrong | what the program does | number and bound |\n|---|---|---|---|\n",
                  section.heading, section.file, section.file);
}

/** Are they the same number, but for another processor's rounding? */
static bool alike(double met, double printed)
{
#if defined __SANITIZE_ADDRESS__ || defined __SANITIZE_THREAD__ /* grids are coarser, memory is larger */
    return met >= 0 && printed >= 0;
#else
    return (met <= 1e-12 && printed <= 1e-12) || (met <= 3 * printed && printed <= 3 * met);
#endif
}

/** Whether `at` begins with `words`; moves behind them. */
static bool skip_words(const char **at, const char *words)
{
    size_t length = strlen(words);
    bool there = strncmp(*at, words, length) == 0;
    if (there)
        *at += length;
    else
        print_error("docs/hard-cases.md has\n%.300s\nwhere this test has\n%s\n", *at, words);
    return there;
}

static bool section_holds(const char *at)
{
    if (!skip_words(&at, section_start()))
        return false;
    for (size_t i = 0; i < row_count; i++) {
        if (!skip_words(&at, before_number(rows[i])))
            return false;
        char *end;
        double printed = strtod(at, &end);
        if (end == at || !alike(rows[i]->worst, printed)) {
            print_error("%s: docs/hard-cases.md has %g, this test %g\n", rows[i]->words[0], printed, rows[i]->worst);
            return false;
        }
        at = end;
        if (!skip_words(&at, behind_number(rows[i])))
            return false;
    }
    return *at == '\0' || skip_words(&at, "\n## ");
}

/** The page with this section in its place, or at the end. */
static void write_section(const struct text *page, const char *start, const char *end)
{
    struct text *all = support_text();
    struct status status = {0};
    text_add_bytes(all, page->data, (size_t)(start - page->data));
    text_add(all, "%s%s", *start ? "" : "\n", section_start());
    for (size_t i = 0; i < row_count; i++)
        text_add(all, "%s%s%s", before_number(rows[i]), number_text(rows[i]->worst), behind_number(rows[i]));
    text_add(all, "%s", end);
    if (text_write_file(PAGE, all->data, all->length, &status) != STATUS_OK)
        print_error("%s\n", status.message);
}

int hard_cases_hold(const char *file)
{
    for (size_t i = 0; i < section_count; i++)
        if (test_in_file(sections[i].file, file))
            section = sections[i];
    if (!section.heading)
        return row_count > 0;
    bool writes = getenv("ROUGHCONTACT_WRITE_DOCS"), holds = true;
    FILE *lock = writes ? fopen(PROJECT_SOURCE "/docs", "r") : NULL; /* programs write one after the other */
    struct text *page = support_text();
    struct status status = {0};
    if (lock)
        (void)flock(fileno(lock), LOCK_EX);
    if (text_read_file(page, PAGE, &status) != STATUS_OK) {
        print_error("%s\n", status.message);
        return 1;
    }
    const char *start = strstr(page->data, filled("\n## %s\n", section.heading)),
               *end = start ? strstr(start + 1, "\n## ") : NULL, *last = page->data + page->length;
    start = start ? start + 1 : last;
    if (writes)
        write_section(page, start, end ? end : last);
    else
        holds = section_holds(start);
    if (!holds)
        print_error("run this test with ROUGHCONTACT_WRITE_DOCS=1 and look at what it changes\n");
    if (lock)
        fclose(lock);
    return holds ? 0 : 1;
}
