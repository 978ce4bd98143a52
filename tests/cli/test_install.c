/* An installed program finds its templates where it was installed, also after its prefix has moved. */
#include "cli/process.h"

#include <stdio.h>
#include <unistd.h>

static void run_installed(const char *place, const char *program, const char *output)
{
    const char *const arguments[] = {program, "report", "--no-cost", "d",          "-o", output,
                                     "-m",    "tin",    "-e",        "plasticity", NULL};
    struct process process =
        process_expect(process_end(process_start_list(place, arguments, NULL)), 0, __FILE__, __LINE__);
    process_free(&process);
}

static void test_install(void **state)
{
    const char *place = *state;
    char *prefix, *moved, *program, *links;
    assert_true(asprintf(&prefix, "%s/first", place) > 0);
    assert_true(asprintf(&moved, "%s/moved here", place) > 0);
    assert_true(asprintf(&links, "%s/roughcontact", place) > 0);
    const char *const install[] = {CMAKE_PROGRAM, "--install", BUILD_DIRECTORY, "--prefix", prefix, NULL};
    struct process process =
        process_expect(process_end(process_start_list(place, install, NULL)), 0, __FILE__, __LINE__);
    process_free(&process);
    assert_true(workspace_has(place, "first/share/roughcontact/templates/page.html"));

    assert_true(workspace_has(place, "first/share/man/man1/roughcontact.1"));
    assert_true(workspace_has(place, "first/share/bash-completion/completions/roughcontact"));

    workspace_scan(place, "d/a.csv", 200, 1);
    assert_true(asprintf(&program, "%s/bin/roughcontact", prefix) > 0);
    run_installed(place, program, "one");
    char *reference = workspace_digest(place, "one");
    free(program);

    assert_int_equal(rename(prefix, moved), 0);
    assert_true(asprintf(&program, "%s/bin/roughcontact", moved) > 0);
    run_installed(place, program, "two");
    assert_int_equal(symlink(program, links), 0);
    run_installed(place, links, "three");
    char *second = workspace_digest(place, "two"), *third = workspace_digest(place, "three");
    assert_string_equal(reference, second);
    assert_string_equal(reference, third);

    /* without its templates it says what to do */
    assert_true(rename(moved, prefix) == 0);
    char *templates;
    assert_true(asprintf(&templates, "%s/share/roughcontact/templates", prefix) > 0);
    assert_int_equal(rename(templates, moved), 0);
    free(program);
    assert_true(asprintf(&program, "%s/bin/roughcontact", prefix) > 0);
    const char *const report[] = {program, "report", "d", NULL};
    process_expect_failure(process_end(process_start_list(place, report, NULL)), 4, 1,
                           "first/share/roughcontact/templates'; install the program with cmake --install", __FILE__,
                           __LINE__);
    assert_false(workspace_has(place, "out"));
    free(reference);
    free(second);
    free(third);
    free(templates);
    free(program);
    free(links);
    free(moved);
    free(prefix);
}

int main(void)
{
    const struct CMUnitTest tests[] = {workspace_test(test_install)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
