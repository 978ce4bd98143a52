/* SPDX-License-Identifier: GPL-3.0-or-later */
/* main() of every test program whose tests are written with TEST_CASE(). */
#include "hard_case.h"

#include <stdio.h>

static struct CMUnitTest tests[64];
static size_t count;
static CMFixtureFunction before_all, after_all;

void test_add(const char *name, CMUnitTestFunction run, CMFixtureFunction before, CMFixtureFunction after)
{
    if (count == sizeof tests / sizeof *tests) {
        fprintf(stderr, "more than %zu tests in one program: make main.c's table larger\n", count);
        abort();
    }
    tests[count++] = (struct CMUnitTest){name, run, before, after, NULL};
}

void test_group(CMFixtureFunction before, CMFixtureFunction after)
{
    before_all = before;
    after_all = after;
}

static int begin_all(void **state)
{
    int rc = before_all ? before_all(state) : 0;
    test_keep();
    return rc;
}

int main(void)
{
    return count == 0 || _cmocka_run_group_tests("tests", tests, count, begin_all, after_all) || hard_cases_hold();
}
