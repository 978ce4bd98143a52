/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A directory for another program: its own for as long as it lives; what a killed process left goes with the next. */
#include "base/clock.h"
#include "base/temporary.h"
#include "directory.h"

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <sys/wait.h>
#include <time.h>

static char *usual; /* TMPDIR outside the test */

/* The name of a directory below the place. */
static const char *name_of(const char *path)
{
    assert_true(strncmp(path, directory_here.path, strlen(directory_here.path)) == 0);
    return path + strlen(directory_here.path) + 1;
}

static void end_process(pid_t process)
{
    int how;
    kill(process, SIGKILL);
    assert_int_equal(waitpid(process, &how, 0), process);
}

/* Makes one and removes it, as another run does that has what to clear away. */
static void make_and_remove(void)
{
    struct temporary made;
    expect_ok(temporary_make, &made, NULL, NULL);
    temporary_remove(&made);
}

/* A process of its own makes one with a file in a folder, tells its path, and is killed while it waits. */
static void leave(char path[static PATH_MAX], bool killed, pid_t *process)
{
    int ends[2];
    assert_int_equal(pipe(ends), 0);
    *process = fork();
    assert_true(*process >= 0);
    if (*process == 0) {
        struct temporary made;
        struct status status = {0};
        char inner[PATH_MAX + 16];
        if (temporary_make(&made, NULL, NULL, &status) != STATUS_OK)
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
    if (killed)
        end_process(*process);
}

static int make(void **state)
{
    usual = getenv("TMPDIR") ? strdup(getenv("TMPDIR")) : NULL;
    directory_setup(state);
    return setenv("TMPDIR", directory_here.path, 1);
}

static int end(void **state)
{
    directory_teardown(state);
    int failed = usual ? setenv("TMPDIR", usual, 1) : unsetenv("TMPDIR");
    free(usual);
    return failed;
}

#define PLACED(name) TEST_WITH(name, make, end)

PLACED(test_it_is_made_and_removed)
{
    struct temporary made, other;
    struct stat info;
    char file[PATH_MAX + 16];
    expect_ok(temporary_make, &made, NULL, NULL);
    assert_int_equal(stat(made.path, &info), 0);
    assert_int_equal(info.st_mode & 0777, 0700);
    name_of(made.path);
    snprintf(file, sizeof file, "%s/file", made.path);
    assert_int_equal(mkdir(file, 0700), 0);
    expect_ok(temporary_make, &other, NULL, NULL); /* what lives in this process stays, too */
    assert_int_equal(access(file, F_OK), 0);
    temporary_remove(&other);
    temporary_remove(&made);
    assert_int_equal(access(made.path, F_OK), -1);
    assert_int_equal(access(other.path, F_OK), -1);
    struct temporary none;
    assert_int_equal(setenv("TMPDIR", directory_path(&directory_here, "no such place"), 1), 0);
    expect_fails(STATUS_IO, "no such place", temporary_make, &none, NULL, NULL);
}

PLACED(test_what_the_dead_left_goes)
{
    char dead[PATH_MAX], alive[PATH_MAX];
    pid_t first, second;
    struct temporary made;
    leave(dead, true, &first);
    assert_true(directory_has(&directory_here, name_of(dead)));
    leave(alive, false, &second); /* which clears the first away, whose name it may have then */
    assert_int_equal(directory_entries(&directory_here, ""), 1);
    leave(dead, true, &first);
    assert_int_equal(directory_entries(&directory_here, ""), 2);
    expect_ok(temporary_make, &made, NULL, NULL);
    assert_int_equal(directory_entries(&directory_here, ""), 2);
    assert_true(directory_has(&directory_here, name_of(alive)));
    end_process(second);
    temporary_remove(&made);
    assert_true(directory_has(&directory_here, name_of(alive)));
    expect_ok(temporary_make, &made, NULL, NULL);
    assert_int_equal(directory_entries(&directory_here, ""), 1);
    assert_int_equal(directory_entries(&directory_here, name_of(made.path)), 0);
    temporary_remove(&made);
}

/* Whatever lacks the mode or the name is somebody's. */
PLACED(test_nobody_elses_is_touched)
{
    enum { OPEN_MODE, SHORT, OTHER_NAME, MADE, LINKED, EMPTY, KINDS };
    static const char *const names[KINDS] = {"",
                                             "roughcontact-abcde",
                                             "other-thing-abcdefg",
                                             "roughcontact-abcdef",
                                             "roughcontact-linked",
                                             "roughcontact-of-somebody"};
    char dead[KINDS][PATH_MAX];
    pid_t process[KINDS];
    for (int i = 0; i < MADE; i++) /* what the dead have left but for that; the living clear nothing away */
        leave(dead[i], false, &process[i]);
    for (int i = 0; i < MADE; i++) {
        if (i == OPEN_MODE)
            assert_int_equal(chmod(dead[i], 0750), 0);
        else
            assert_int_equal(rename(dead[i], directory_path(&directory_here, names[i])), 0);
        end_process(process[i]);
    }
    assert_int_equal(mkdir(directory_path(&directory_here, names[MADE]), 0700), 0);
    directory_write(&directory_here, "roughcontact-abcdef/lock", "");
    assert_int_equal(mkdir(directory_path(&directory_here, names[EMPTY]), 0700), 0);
    assert_int_equal(symlink(names[OTHER_NAME], directory_path(&directory_here, names[LINKED])), 0);
    make_and_remove();
    for (int i = 0; i < EMPTY; i++)
        assert_int_equal(directory_entries(&directory_here, i == OPEN_MODE ? name_of(dead[i]) : names[i]), 1);
    assert_true(directory_has(&directory_here, names[EMPTY]));
}

/* Even root, who could, lets another user's be. */
PLACED(test_another_users_stays)
{
    enum { NOBODY = 65534 };
    char dead[PATH_MAX];
    pid_t process;
    if (geteuid() != 0)
        skip();
    leave(dead, true, &process);
    assert_int_equal(chown(dead, NOBODY, NOBODY), 0);
    make_and_remove();
    assert_true(directory_has(&directory_here, name_of(dead)));
}

/* temporary_end() in a process of its own, as it never lets go; exits with 0 when the note is `expected`. */
static void end_all(const char *expected)
{
    int how;
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0)
        _exit(strcmp(temporary_end(), expected) == 0 ? 0 : 1);
    assert_int_equal(waitpid(child, &how, 0), child);
    assert_int_equal(how, 0);
}

/* All go in the end but what was closed, and no link is followed. */
PLACED(test_the_end)
{
    struct temporary first, second, third;
    char kept[PATH_MAX];
    directory_write(&directory_here, "mine", "mine");
    assert_int_equal(mkdir(directory_path(&directory_here, "deep"), 0700), 0);
    directory_write(&directory_here, "deep/mine", "mine");
    expect_ok(temporary_make, &first, NULL, NULL);
    expect_ok(temporary_make, &second, NULL, NULL);
    expect_ok(temporary_make, &third, directory_here.path, NULL);
    assert_int_equal(strncmp(name_of(third.path), ".roughcontact-", 14), 0);
    assert_int_equal(mkdirat(first.directory, "a", 0700) + mkdirat(first.directory, "a/b", 0700), 0);
    assert_int_equal(symlinkat("../mine", first.directory, "link") + symlinkat("../deep", first.directory, "deep"), 0);
    assert_int_equal(linkat(AT_FDCWD, directory_path(&directory_here, "mine"), first.directory, "a/b/mine", 0), 0);
    assert_int_equal(mkdirat(second.directory, "mine", 0700), 0);
    snprintf(kept, sizeof kept, "%s", second.path);
    temporary_close(&second);
    temporary_note("in ", "one", "");
    temporary_note("in ", "two", " there");
    end_all("in 'two' there");
    assert_int_equal(access(first.path, F_OK), -1);
    assert_int_equal(access(third.path, F_OK), -1);
    assert_int_equal(access(kept, F_OK), 0);
    assert_true(directory_has(&directory_here, "mine") && directory_has(&directory_here, "deep/mine"));
    assert_int_equal(directory_entries(&directory_here, ""), 3);
    temporary_remove(&third);
    temporary_remove(&first);
}

/* Whole copies, as out of an archive, have the name of another directory. */
PLACED(test_a_copy_is_nobodys)
{
    char dead[PATH_MAX];
    pid_t process;
    leave(dead, true, &process);
    assert_int_equal(system(filled("cp -a %s %s/copy; rm -r %s; mv %s/copy %s", dead, directory_here.path, dead,
                                   directory_here.path, dead)),
                     0);
    make_and_remove();
    assert_int_equal(directory_entries(&directory_here, name_of(dead)), 1);
}

static atomic_bool waits, ended;

static void *end_here(void *context)
{
    (void)context;
    waits = true;
    (void)temporary_end();
    ended = true;
    return NULL;
}

PLACED(test_what_is_held_is_waited_for)
{
    const struct timespec pause = {.tv_nsec = 50000000};
    int how;
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        pthread_t thread;
        struct temporary made;
        struct status status = {0};
        temporary_hold();
        if (temporary_make(&made, NULL, NULL, &status) != STATUS_OK || /* holds and releases */
            pthread_create(&thread, NULL, end_here, NULL) != 0)
            _exit(1);
        double before = clock_seconds();
        while (!waits)
            ;
        nanosleep(&pause, NULL);
        bool early = ended || access(made.path, F_OK) != 0;
        double waited = clock_seconds() - before; /* it does not wait for long, should this process have to */
        temporary_release();
        pthread_join(thread, NULL);
        bool gone = ended && access(made.path, F_OK) != 0;
        _exit(waited > 0.2 ? 0 : early ? 2 : gone ? 0 : 3);
    }
    assert_int_equal(waitpid(child, &how, 0), child);
    assert_int_equal(how, 0);
}
