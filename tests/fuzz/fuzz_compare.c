/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz.h"

#include "directory.h"
#include "report/report.h"

static size_t runs, good;

size_t fuzz_compare_good(void)
{
    return good;
}

void fuzz_compare_counts(void)
{
    fprintf(stderr, "runs %9zu, good ones %9zu\n", runs, good);
}

static struct directory place;

static void remove_place(void)
{
    directory_remove(&place);
}

void fuzz_compare(const uint8_t *data, size_t length)
{
    const char *bytes = (const char *)data, *between = length > 0 ? memchr(bytes, '\f', length) : NULL;
    if (!place.path[0]) {
        if (!getenv("TMPDIR") && access("/dev/shm", W_OK) == 0)
            setenv("TMPDIR", "/dev/shm", 1);
        place = directory_make();
        atexit(remove_place);
        directory_write(&place, "a/results.json", "");
        directory_write(&place, "b/results.json", "");
    }
    size_t first = between ? (size_t)(between - bytes) : length, second = between ? first + 1 : 0;
    char a[sizeof place.path + 2], b[sizeof a], *paths[] = {a, b};
    json_t *view;
    struct text shown = {0};
    struct status status = {0};
    snprintf(a, sizeof a, "%s/a", place.path);
    snprintf(b, sizeof b, "%s/b", place.path);
    FUZZ_REQUIRE(text_write_file(directory_path(&place, "a/results.json"), bytes, first, &status) == STATUS_OK);
    FUZZ_REQUIRE(text_write_file(directory_path(&place, "b/results.json"), bytes + second, length - second, &status) ==
                 STATUS_OK);
    enum status_code code = report_compare(&view, paths, 2, &status);
    FUZZ_REQUIRE(code == STATUS_OK || code == STATUS_IO || code == STATUS_SCAN);
    FUZZ_REQUIRE(code == STATUS_OK || (*status.message && !strchr(status.message, '\n')));
    if (code == STATUS_OK) {
        FUZZ_REQUIRE(report_terminal(&shown, "compare", view, PROJECT_SOURCE "/templates", false, &status) ==
                     STATUS_OK);
        FUZZ_REQUIRE(shown.length > 0);
    }
    text_free(&shown);
    json_decref(view);
    runs++;
    good += code == STATUS_OK;
}
