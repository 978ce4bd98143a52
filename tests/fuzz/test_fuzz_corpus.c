/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The committed corpus of the fuzz drivers, through the same functions: what once crashed or was hard to reach stays
 * tested with every compiler. A broken promise aborts. */
#include "fuzz/fuzz.h"

#include "base/text.h"
#include "scan/reader.h"
#include "support.h"
#include <dirent.h>
#include <stdio.h>
#include <sys/stat.h>

static size_t replay(const char *path, void (*target)(const uint8_t *bytes, size_t length))
{
    struct dirent **entries = NULL;
    int count = scandir(path, &entries, NULL, alphasort);
    size_t files = 0;
    assert_true(count >= 0);
    for (int i = 0; i < count; i++) {
        char name[1024];
        struct stat info;
        snprintf(name, sizeof name, "%s/%s", path, entries[i]->d_name);
        bool hidden = entries[i]->d_name[0] == '.';
        free(entries[i]);
        if (hidden)
            continue;
        assert_int_equal(stat(name, &info), 0);
        if (S_ISDIR(info.st_mode)) {
            files += replay(name, target);
            continue;
        }
        struct text bytes = {0};
        struct status status = {0};
        assert_int_equal(text_read_file(&bytes, name, &status), STATUS_OK);
        fprintf(stderr, "%s\n", strrchr(name, '/') + 1); /* the last of these is the one that aborted */
        target((const uint8_t *)text_string(&bytes), bytes.length);
        files++;
        text_free(&bytes);
    }
    free(entries);
    return files;
}

#define CORPUS PROJECT_SOURCE "/tests/fuzz/corpus/"

TEST_CASE(test_scan)
{
    assert_true(replay(CORPUS "scan", fuzz_scan) > 150);
#define FORMAT_NAME(prefix, name) name,
    static const char *const formats[] = {SCAN_FORMATS(FORMAT_NAME) "zip", "gz"};
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (fuzz_scan_good(formats[i]) == 0)
            fail_msg("no scan of format %s in the corpus: add one", formats[i]);
}

TEST_CASE(test_scene)
{
    assert_true(replay(CORPUS "scene", fuzz_scene) > 20);
}

TEST_CASE(test_measured)
{
    assert_true(replay(CORPUS "measured", fuzz_measured) > 20);
}
