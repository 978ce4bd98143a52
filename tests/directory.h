/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Temporary directories and the trees in them. */
#ifndef TEST_DIRECTORY_H
#define TEST_DIRECTORY_H

#include "base/text.h"
#include "support.h"

#include <dirent.h>
#include <ftw.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

struct directory {
    char path[128];
};

/* What follows takes a directory, or its path: `place`. */

static inline struct directory directory_make(void)
{
    struct directory directory;
    const char *temporary = getenv("TMPDIR");
    snprintf(directory.path, sizeof directory.path, "%s/roughcontact-test-XXXXXX", temporary ? temporary : "/tmp");
    assert_non_null(mkdtemp(directory.path));
    return directory;
}

static inline int directory_unlink(const char *path, const struct stat *info, int kind, struct FTW *walk)
{
    (void)info, (void)kind, (void)walk;
    return remove(path);
}

static inline void directory_remove(const struct directory *directory)
{
    assert_int_equal(nftw(directory->path, directory_unlink, 16, FTW_DEPTH | FTW_PHYS), 0);
}

static struct directory directory_here; /* of the fixture */

/* A fixture: *state is an empty directory, directory_here, removed with all that came into it. */
static inline int directory_setup(void **state)
{
    directory_here = directory_make();
    *state = &directory_here;
    return 0;
}

static inline int directory_teardown(void **state)
{
    directory_remove(*state);
    return 0;
}

/* A test with that fixture, or one of its group's (TEST_CASE), which has it as `place`. */
#define TEST_IN_DIRECTORY(name) TEST_OF_PLACE(name, directory_setup, directory_teardown)
#define TEST_OF_PLACE(name, before, after)                                                                             \
    static void name##_in(const struct directory *place);                                                              \
    TEST_WITH(name, before, after)                                                                                     \
    {                                                                                                                  \
        name##_in(*state);                                                                                             \
    }                                                                                                                  \
    static void name##_in(__attribute__((unused)) const struct directory *place)
#define TEST_IN_PLACE(name) TEST_OF_PLACE(name, NULL, NULL)

/* Path of `name` below it; good until the next 8 calls. */
static inline const char *directory_path(const void *place, const char *name)
{
    static char paths[8][4096];
    static unsigned next;
    char *path = paths[next++ % 8];
    snprintf(path, sizeof paths[0], "%s/%s", (const char *)place, name);
    return path;
}

/* Makes a directory and those on the way to it. */
static inline void directory_folder(const void *place, const char *name)
{
    char part[256];
    struct stat info;
    for (const char *slash = name; (slash = strchr(slash, '/')); slash++) {
        snprintf(part, sizeof part, "%.*s", (int)(slash - name), name);
        mkdir(directory_path(place, part), 0777);
    }
    mkdir(directory_path(place, name), 0777);
    assert_true(stat(directory_path(place, name), &info) == 0 && S_ISDIR(info.st_mode));
}

/* Makes the directories on the way, too. */
static inline void directory_write(const void *place, const char *name, const char *content)
{
    char folder[256];
    const char *slash = strrchr(name, '/');
    if (slash) {
        snprintf(folder, sizeof folder, "%.*s", (int)(slash - name), name);
        directory_folder(place, folder);
    }
    expect_ok(text_write_file, directory_path(place, name), content, strlen(content));
}

/* The file's text, the test's; fails it when there is none. */
static inline char *directory_read(const void *place, const char *name)
{
    struct text *text = support_text();
    expect_ok(text_read_file, text, directory_path(place, name));
    text_add(text, "%s", "");
    return text->data;
}

/* The JSON value in the file, the test's. */
static inline json_t *directory_json(const void *place, const char *name)
{
    return support_json(directory_read(place, name));
}

/* expect_parts() and expect_no_parts() of a file. */
static inline void directory_expect(const void *place, const char *name, const char *const *parts, bool there,
                                    const char *file, int line)
{
    support_parts(directory_read(place, name), parts, there, file, line);
}

#define expect_in_file(place, name, ...)                                                                               \
    directory_expect((place), (name), (const char *const[]){__VA_ARGS__, NULL}, true, __FILE__, __LINE__)
#define expect_not_in_file(place, name, ...)                                                                           \
    directory_expect((place), (name), (const char *const[]){__VA_ARGS__, NULL}, false, __FILE__, __LINE__)

static inline void directory_expect_same(const void *place, const char *a, const char *b)
{
    struct text *first = support_text(), *second = support_text();
    expect_ok(text_read_file, first, directory_path(place, a));
    expect_ok(text_read_file, second, directory_path(place, b));
    assert_true(first->length > 0);
    assert_int_equal(first->length, second->length);
    assert_memory_equal(first->data, second->data, first->length);
}

/* The file has this text, to the byte. */
static inline void directory_holds(const void *place, const char *name, const char *content)
{
    assert_string_equal(directory_read(place, name), content);
}

static inline struct table directory_table(const void *place, const char *name)
{
    return table_read_path(directory_path(place, name));
}

static inline bool directory_has(const void *place, const char *name)
{
    struct stat info;
    return lstat(directory_path(place, name), &info) == 0;
}

/* How many entries `name` has, hidden ones too. */
static inline size_t directory_entries(const void *place, const char *name)
{
    size_t entries = 0;
    DIR *open = opendir(directory_path(place, name));
    assert_non_null(open);
    for (const struct dirent *entry; (entry = readdir(open));)
        entries += strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0;
    closedir(open);
    return entries;
}

#endif
