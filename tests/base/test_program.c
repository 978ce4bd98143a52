/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/program.h"
#include "directory.h"

#include <errno.h>
#include <signal.h>
#include <time.h>

static struct directory place;

/* Runs these lines by a shell in the directory, for at most `seconds`. */
static enum status_code run(char *lines, double seconds, struct status *status)
{
    char shell[] = "/bin/sh", option[] = "-c";
    char *const arguments[] = {shell, option, lines, NULL};
    return program_run(arguments, place.path, seconds, status);
}

static void test_find(void **state)
{
    (void)state;
    char path[4096], *before = strdup(getenv("PATH")), *with = NULL;
    directory_write(&place, "tool", "#!/bin/sh\n");
    assert_true(asprintf(&with, "relative::%s:%s", place.path, before) > 0);
    assert_int_equal(setenv("PATH", with, 1), 0);
    assert_false(program_find(path, sizeof path, "tool")); /* no program yet */
    assert_int_equal(chmod(directory_path(&place, "tool"), 0700), 0);
    assert_true(program_find(path, sizeof path, "tool"));
    assert_string_equal(path, directory_path(&place, "tool"));
    assert_false(program_find(path, strlen(place.path), "tool"));
    assert_false(program_find(path, sizeof path, "no-such-tool"));
    assert_int_equal(setenv("PATH", before, 1), 0);
    free(before);
    free(with);
}

static void test_run(void **state)
{
    (void)state;
    struct status status = {0};
    char home[] = "pwd > where; echo \"$HOME\" >> where; echo loud; read line || echo no input >> where";
    assert_int_equal(run(home, 60, &status), STATUS_OK);
    struct text where = directory_read(&place, "where");
    char expected[600];
    snprintf(expected, sizeof expected, "%s\n%s\nno input\n", place.path, place.path);
    assert_string_equal(text_string(&where), expected);
    text_free(&where);
    char fails[] = "exit 3", dies[] = "kill -9 $$", *const none[] = {expected, NULL};
    assert_int_equal(run(fails, 60, &status), STATUS_IO);
    assert_non_null(strstr(status.message, "'sh' failed"));
    status = (struct status){0};
    assert_int_equal(run(dies, 60, &status), STATUS_IO);
    status = (struct status){0};
    assert_int_equal(program_run(none, place.path, 60, &status), STATUS_IO);
    assert_non_null(strstr(status.message, "cannot start"));
}

/* Too slow, or asked to stop: it ends at once. Without that these would take minutes. */
static void test_stop(void **state)
{
    (void)state;
    struct status status = {0};
    char slow[] = "sleep 1000";
    assert_int_equal(run(slow, 0.05, &status), STATUS_IO);
    assert_non_null(strstr(status.message, "took more than 0.05 s"));
    status = (struct status){0};
    sigset_t before;
    program_hold_signals(&before);
    raise(SIGTERM);
    assert_int_equal(run(slow, 1000, &status), STATUS_INTERRUPTED);
    signal(SIGTERM, SIG_IGN); /* takes it off */
    program_let_signals(&before);
    signal(SIGTERM, SIG_DFL);
    status = (struct status){0};
    program_stop();
    assert_int_equal(run(slow, 1000, &status), STATUS_INTERRUPTED);
}

static int make(void **state)
{
    (void)state;
    place = directory_make();
    return 0;
}

static int end(void **state)
{
    (void)state;
    directory_remove(&place);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_find, make, end),
        cmocka_unit_test_setup_teardown(test_run, make, end),
        cmocka_unit_test_setup_teardown(test_stop, make, end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
