/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is noted goes, all of it, and nothing else; what is held is waited for. */
#include "base/leftover.h"
#include "directory.h"

#include <errno.h>
#include <pthread.h>
#include <stdatomic.h>
#include <sys/wait.h>
#include <time.h>

static struct directory place;

static void fill(const char *name)
{
    char path[600];
    for (int i = 0; i < 3; i++) {
        static const char *const folders[] = {"", "/deep", "/deep/deeper"};
        snprintf(path, sizeof path, "%s%s", name, folders[i]);
        mkdir(directory_path(&place, path), 0700);
        strcat(path, "/file");
        directory_write(&place, path, "x");
    }
}

/* leftover_clear() in a process of its own, as it never lets go; exits with 0 when the note is `expected`. */
static void clear(const char *expected)
{
    int state;
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0)
        _exit(strcmp(leftover_clear(), expected) == 0 ? 0 : 1);
    assert_int_equal(waitpid(child, &state, 0), child);
    assert_int_equal(state, 0);
}

static void test_what_is_noted_goes(void **state)
{
    (void)state;
    fill("noted");
    fill("forgotten");
    fill("other");
    size_t noted = leftover_add(directory_path(&place, "noted")),
           forgotten = leftover_add(directory_path(&place, "forgotten"));
    assert_true(noted > 0 && forgotten > 0 && noted != forgotten);
    assert_int_equal(leftover_add(directory_path(&place, "nothing there")), 0);
    leftover_forget(forgotten);
    leftover_forget(0);
    clear("");
    assert_false(directory_has(&place, "noted"));
    assert_true(directory_has(&place, "forgotten/deep/deeper/file"));
    assert_true(directory_has(&place, "other/deep/deeper/file"));
    assert_int_equal(leftover_add(directory_path(&place, "forgotten")), forgotten); /* the number is free again */
    leftover_note("one");
    leftover_note("two");
    clear("two");
    assert_false(directory_has(&place, "forgotten"));
    leftover_forget(noted);
    leftover_forget(forgotten);
    leftover_note("");
}

static void test_no_link_is_followed(void **state)
{
    (void)state;
    fill("mine");
    fill("noted");
    assert_int_equal(symlink("../mine", directory_path(&place, "noted/link")), 0);
    assert_int_equal(symlink("../../mine/file", directory_path(&place, "noted/deep/link")), 0);
    size_t number = leftover_add(directory_path(&place, "noted"));
    clear("");
    leftover_forget(number);
    assert_false(directory_has(&place, "noted"));
    assert_true(directory_has(&place, "mine/deep/deeper/file"));

    fill("noted"); /* nor where one has taken the place of the directory */
    number = leftover_add(directory_path(&place, "noted"));
    assert_int_equal(rename(directory_path(&place, "noted"), directory_path(&place, "moved")), 0);
    assert_int_equal(symlink("mine", directory_path(&place, "noted")), 0);
    clear("");
    leftover_forget(number);
    assert_true(directory_has(&place, "mine/deep/deeper/file"));
    leftover_remove(directory_path(&place, "nothing there"));
    leftover_remove(directory_path(&place, "mine"));
    assert_false(directory_has(&place, "mine"));
}

static void test_a_directory_is_made_and_noted(void **state)
{
    (void)state;
    char path[300], nowhere[300];
    size_t number, none = 7;
    snprintf(path, sizeof path, "%s/made-XXXXXX", place.path);
    snprintf(nowhere, sizeof nowhere, "%s/no/made-XXXXXX", place.path);
    assert_false(leftover_make(nowhere, &none));
    assert_int_equal(errno, ENOENT);
    assert_int_equal(none, 0);
    assert_true(leftover_make(path, &number));
    assert_true(number > 0);
    assert_int_equal(access(path, F_OK), 0);
    clear("");
    assert_int_equal(access(path, F_OK), -1);
    leftover_forget(number);
}

static void test_too_many_are_not_noted(void **state)
{
    enum { MANY = 200 };
    size_t numbers[MANY], noted = 0;
    (void)state;
    for (size_t i = 0; i < MANY; i++) {
        numbers[i] = leftover_add(place.path);
        noted += numbers[i] > 0;
    }
    assert_in_range(noted, 64, MANY - 1);
    for (size_t i = 0; i < MANY; i++)
        leftover_forget(numbers[i]);
}

static atomic_bool waits, cleared;

static void *clear_here(void *context)
{
    (void)context;
    waits = true;
    (void)leftover_clear();
    cleared = true;
    return NULL;
}

static void test_what_is_held_is_waited_for(void **state)
{
    const struct timespec pause = {.tv_nsec = 50000000};
    int how;
    (void)state;
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        pthread_t thread;
        fill("noted");
        leftover_hold();
        leftover_hold();
        size_t number = leftover_add(directory_path(&place, "noted"));
        leftover_release();
        if (number == 0 || pthread_create(&thread, NULL, clear_here, NULL) != 0)
            _exit(1);
        while (!waits)
            ;
        nanosleep(&pause, NULL);
        if (cleared || !directory_has(&place, "noted/file"))
            _exit(2);
        leftover_release();
        pthread_join(thread, NULL);
        _exit(cleared && !directory_has(&place, "noted") ? 0 : 3);
    }
    assert_int_equal(waitpid(child, &how, 0), child);
    assert_int_equal(how, 0);
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
#define TEST(function) cmocka_unit_test_setup_teardown(function, make, end)
    const struct CMUnitTest tests[] = {
        TEST(test_what_is_noted_goes),
        TEST(test_no_link_is_followed),
        TEST(test_a_directory_is_made_and_noted),
        TEST(test_too_many_are_not_noted),
        TEST(test_what_is_held_is_waited_for),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
