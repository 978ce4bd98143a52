/* SPDX-License-Identifier: GPL-3.0-or-later */
/* main() of the test program of a room: runs the tests of one of its files, `tests_contact test_strip`. */
#include "hard_case.h"

#include <stdio.h>

static struct CMUnitTest tests[512];
static const char *test_file[512]; /* in which each of them stands */
static size_t count;
static struct group {
    const char *file;
    CMFixtureFunction before, after;
} groups[32];
static size_t group_count;
static const struct group *chosen_group = &(struct group){0};

void test_add(const char *file, const char *name, CMUnitTestFunction run, CMFixtureFunction before,
              CMFixtureFunction after)
{
    if (count == sizeof tests / sizeof *tests) {
        fprintf(stderr, "more than %zu tests in one program: make main.c's table larger\n", count);
        abort();
    }
    test_file[count] = file;
    tests[count++] = (struct CMUnitTest){name, run, before, after, NULL};
}

void test_group(const char *file, CMFixtureFunction before, CMFixtureFunction after)
{
    if (group_count == sizeof groups / sizeof *groups)
        abort();
    groups[group_count++] = (struct group){file, before, after};
}

static int begin_all(void **state)
{
    int rc = chosen_group->before ? chosen_group->before(state) : 0;
    test_keep();
    return rc;
}

int main(int argc, char **argv)
{
    char file[100];
    size_t chosen = 0;
    snprintf(file, sizeof file, "/%s.c", argc == 2 ? argv[1] : "");
    for (size_t i = 0; i < count; i++)
        if (test_in_file(test_file[i], file))
            tests[chosen++] = tests[i];
    for (size_t i = 0; i < group_count; i++)
        if (test_in_file(groups[i].file, file))
            chosen_group = &groups[i];
    if (chosen == 0) {
        fprintf(stderr, "usage: %s FILE, one of its files with tests, such as %s\n", argv[0], test_file[0]);
        return 2;
    }
    return _cmocka_run_group_tests(argv[1], tests, chosen, begin_all, chosen_group->after) || hard_cases_hold(file);
}
