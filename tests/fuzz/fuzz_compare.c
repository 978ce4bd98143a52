/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz.h"

#include "directory.h"
#include "report/report.h"

void fuzz_compare(const uint8_t *data, size_t length)
{
    const char *bytes = (const char *)data, *between = length > 0 ? memchr(bytes, '\f', length) : NULL;
    const char *place = fuzz_place();
    size_t first = between ? (size_t)(between - bytes) : length, second = between ? first + 1 : 0;
    char a[256], b[256], *paths[] = {a, b};
    json_t *view;
    OWNED(text_free) struct text shown = {0};
    struct status status = {0};
    snprintf(a, sizeof a, "%s/a", place);
    snprintf(b, sizeof b, "%s/b", place);
    (void)mkdir(a, 0700), (void)mkdir(b, 0700);
    FUZZ_REQUIRE(text_write_file(directory_path(a, "results.json"), bytes, first, &status) == STATUS_OK);
    FUZZ_REQUIRE(text_write_file(directory_path(b, "results.json"), bytes + second, length - second, &status) ==
                 STATUS_OK);
    enum status_code code = report_compare(&view, paths, 2, &status);
    FUZZ_REQUIRE(code == STATUS_OK || code == STATUS_IO || code == STATUS_SCAN);
    FUZZ_REQUIRE(code == STATUS_OK || (*status.message && !strchr(status.message, '\n')));
    if (code == STATUS_OK) {
        FUZZ_REQUIRE(report_terminal(&shown, "compare", view, PROJECT_SOURCE "/templates", false, &status) ==
                     STATUS_OK);
        FUZZ_REQUIRE(shown.length > 0);
    }
    json_decref(view);
    fuzz_count("compare", code == STATUS_OK);
}
