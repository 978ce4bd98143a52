/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rows of docs/hard-cases.md, each beside the assertion that holds its number. */
#ifndef TEST_HARD_CASE_H
#define TEST_HARD_CASE_H

#include "support.h"

/** A row: the case, what could go wrong, what the program does, and what the number is. */
struct hard_case {
    const char *words[4];
    double worst, bound;
    bool met;
};

/** Heading of the section that the hard cases of this file make: once in it. */
#define HARD_CASES(heading)                                                                                            \
    __attribute__((constructor)) static void hard_cases_of_file(void)                                                  \
    {                                                                                                                  \
        hard_cases_section(heading, __FILE__);                                                                         \
    }

/** Fails unless 0 <= number <= bound; the page has the largest number that was met here and the bound. */
#define hard_case(what, danger, does, measure, number, bound)                                                          \
    do {                                                                                                               \
        static struct hard_case hard_case_row = {.words = {(what), (danger), (does), (measure)}};                      \
        hard_case_met(&hard_case_row, (number), (bound), __FILE__, __LINE__);                                          \
    } while (0)

void hard_cases_section(const char *heading, const char *file);
void hard_case_met(struct hard_case *row, double number, double bound, const char *file, int line);
/** After all tests of a file (the end of its path): whether the page's section has these rows to the byte and each
 * number within a factor of three; or, with ROUGHCONTACT_WRITE_DOCS set, makes it so. Returns 0 or 1, an exit status.
 */
int hard_cases_hold(const char *file);

/** |actual / expected - 1|; NaN, which no bound allows, where one of them is no number. */
static inline double off_by(double actual, double expected)
{
    return actual == expected ? 0 : fabs(actual / expected - 1);
}

#endif
