/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A directory for another program: its own for as long as it lives; what a killed process left goes with the next. */
#include "base/temporary.h"
#include "directory.h"

#include <signal.h>
#include <sys/wait.h>

static struct directory place;
static char *usual; /* TMPDIR outside the test */

/* The name of a directory below the place. */
static const char *name_of(const char *path)
{
    assert_true(strncmp(path, place.path, strlen(place.path)) == 0);
    return path + strlen(place.path) + 1;
}

/* A process of its own makes one with a file in a folder, tells its path, and is killed while it waits. */
static void leave(char path[static PATH_MAX], bool killed, pid_t *process)
{
    int ends[2], how;
    assert_int_equal(pipe(ends), 0);
    *process = fork();
    assert_true(*process >= 0);
    if (*process == 0) {
        struct temporary made;
        struct status status = {0};
        char inner[PATH_MAX + 16];
        if (temporary_make(&made, &status) != STATUS_OK)
            _exit(1);
        snprintf(inner, sizeof inner, "%s/folder", made.path);
        if (mkdir(inner, 0700) != 0 || symlink("/", strcat(inner, "/link")) != 0 ||
            write(ends[1], made.path, sizeof made.path) != sizeof made.path)
            _exit(1);
        alarm(60); /* should the test fail */
        for (;;)
            pause();
    }
    close(ends[1]);
    ssize_t told = read(ends[0], path, PATH_MAX);
    close(ends[0]);
    assert_int_equal(told, PATH_MAX);
    if (killed) {
        kill(*process, SIGKILL);
        assert_int_equal(waitpid(*process, &how, 0), *process);
    }
}

static void test_it_is_made_and_removed(void **state)
{
    (void)state;
    struct temporary made, other;
    struct status status = {0};
    struct stat info;
    char file[PATH_MAX + 16];
    assert_int_equal(temporary_make(&made, &status), STATUS_OK);
    assert_int_equal(stat(made.path, &info), 0);
    assert_int_equal(info.st_mode & 0777, 0700);
    name_of(made.path);
    snprintf(file, sizeof file, "%s/file", made.path);
    assert_int_equal(mkdir(file, 0700), 0);
    assert_int_equal(temporary_make(&other, &status), STATUS_OK); /* what lives in this process stays, too */
    assert_int_equal(access(file, F_OK), 0);
    temporary_remove(&other);
    temporary_remove(&made);
    assert_int_equal(access(made.path, F_OK), -1);
    assert_int_equal(access(other.path, F_OK), -1);
    struct temporary none;
    assert_int_equal(setenv("TMPDIR", directory_path(&place, "no such place"), 1), 0);
    assert_int_equal(temporary_make(&none, &status), STATUS_IO);
    assert_non_null(strstr(status.message, "no such place"));
}

static void test_what_the_dead_left_goes(void **state)
{
    (void)state;
    char dead[PATH_MAX], alive[PATH_MAX];
    pid_t first, second;
    int how;
    struct temporary made;
    struct status status = {0};
    leave(dead, true, &first);
    assert_true(directory_has(&place, name_of(dead)));
    leave(alive, false, &second); /* which clears the first away */
    assert_false(directory_has(&place, name_of(dead)));
    leave(dead, true, &first);
    assert_int_equal(temporary_make(&made, &status), STATUS_OK);
    assert_false(directory_has(&place, name_of(dead)));
    assert_true(directory_has(&place, name_of(alive)));
    kill(second, SIGKILL);
    assert_int_equal(waitpid(second, &how, 0), second);
    temporary_remove(&made);
    assert_true(directory_has(&place, name_of(alive)));
    assert_int_equal(temporary_make(&made, &status), STATUS_OK);
    assert_false(directory_has(&place, name_of(alive)));
    temporary_remove(&made);
}

/* Whatever lacks the lock, the mode or the name is somebody's. */
static void test_nobody_elses_is_touched(void **state)
{
    (void)state;
    static const char *const names[] = {"roughcontact-abcdef", "roughcontact-ABCDEF", "roughcontact-abcde",
                                        "roughcontact-report", "other-thing-abcdefg", "roughcontact-linked"};
    enum { NO_LOCK, OPEN_MODE, SHORT, FULL_LOCK, OTHER_NAME, LINKED, KINDS };
    struct temporary made;
    struct status status = {0};
    char path[64];
    for (int i = 0; i < KINDS; i++) {
        if (i == LINKED) {
            assert_int_equal(symlink("other-thing-abcdefg", directory_path(&place, names[i])), 0);
            continue;
        }
        assert_int_equal(mkdir(directory_path(&place, names[i]), 0700), 0);
        snprintf(path, sizeof path, "%s/lock", names[i]);
        if (i != NO_LOCK)
            directory_write(&place, path, i == FULL_LOCK ? "my own" : "");
        if (i == OPEN_MODE)
            assert_int_equal(chmod(directory_path(&place, names[i]), 0750), 0);
    }
    assert_int_equal(temporary_make(&made, &status), STATUS_OK);
    temporary_remove(&made);
    for (int i = 0; i < KINDS; i++)
        assert_true(directory_has(&place, names[i]));
}

/* Even root, who could, lets another user's be. */
static void test_another_users_stays(void **state)
{
    enum { NOBODY = 65534 };
    (void)state;
    char dead[PATH_MAX];
    pid_t process;
    struct temporary made;
    struct status status = {0};
    if (geteuid() != 0)
        skip();
    leave(dead, true, &process);
    assert_int_equal(chown(dead, NOBODY, NOBODY), 0);
    assert_int_equal(temporary_make(&made, &status), STATUS_OK);
    temporary_remove(&made);
    assert_true(directory_has(&place, name_of(dead)));
}

static int make(void **state)
{
    (void)state;
    usual = getenv("TMPDIR") ? strdup(getenv("TMPDIR")) : NULL;
    place = directory_make();
    return setenv("TMPDIR", place.path, 1);
}

static int end(void **state)
{
    (void)state;
    directory_remove(&place);
    int failed = usual ? setenv("TMPDIR", usual, 1) : unsetenv("TMPDIR");
    free(usual);
    return failed;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_it_is_made_and_removed, make, end),
        cmocka_unit_test_setup_teardown(test_what_the_dead_left_goes, make, end),
        cmocka_unit_test_setup_teardown(test_nobody_elses_is_touched, make, end),
        cmocka_unit_test_setup_teardown(test_another_users_stays, make, end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
