/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz.h"

#include "scan/format.h"
#include "scan/zip_support.h"

enum { MOST_PARTS = 8, MOST_MEMBERS = 16, MOST_NAME = 1024 };

/* What scan.h promises of a scan. */
static void require_sound(const struct scan *scan)
{
    size_t missing = 0;
    FUZZ_REQUIRE(scan->format && scan->nx >= 3 && scan->ny >= 1);
    FUZZ_REQUIRE(isfinite(scan->dx_m) && scan->dx_m > 0);
    FUZZ_REQUIRE(scan->kind == SCAN_PROFILE || (isfinite(scan->dy_m) && scan->dy_m > 0));
    for (size_t i = 1; scan->x_m && i < scan->nx; i++)
        FUZZ_REQUIRE(isfinite(scan->x_m[i]) && scan->x_m[i] > scan->x_m[i - 1]);
    for (size_t i = 0; i < scan->nx * scan->ny; i++) {
        FUZZ_REQUIRE(!isinf(scan->z_m[i]));
        missing += isnan(scan->z_m[i]) ? 1 : 0;
    }
    FUZZ_REQUIRE(missing == scan->missing && missing + 3 <= scan->nx * scan->ny);
    FUZZ_REQUIRE(scan->warning_count <= SCAN_WARNINGS);
    for (size_t i = 0; i < scan->warning_count; i++)
        FUZZ_REQUIRE(*scan->warnings[i] && !strchr(scan->warnings[i], '\n'));
}

/* A zip archive of members, each a line `=name` and its bytes up to the next such line: a mutation of the archive
 * itself would break its checksums, and nothing in it be read. */
static struct text pack_zip(const char *at, const char *end)
{
    struct packed members[MOST_MEMBERS];
    char names[MOST_MEMBERS][MOST_NAME] = {{0}};
    size_t count = 0;
    for (; at < end && *at == '=' && count < MOST_MEMBERS; count++) {
        const char *stop = memchr(at, '\n', (size_t)(end - at)), *content = stop ? stop + 1 : end;
        const char *next = memmem(content, (size_t)(end - content), "\n=", 2);
        snprintf(names[count], MOST_NAME, "%.*s", (int)((stop ? stop : end) - at - 1), at + 1);
        members[count] = pack(names[count], content, (size_t)((next ? next : end) - content), false);
        at = next ? next + 1 : end;
    }
    struct text text = zip_of(members, count);
    while (count > 0)
        text_free(&members[--count].bytes);
    return text;
}

char *fuzz_file(const char *bytes, size_t *length)
{
    OWNED(text_free) struct text packed = {0};
    if (*length > 4 && memcmp(bytes, "zip:", 4) == 0)
        packed = pack_zip(bytes + 4, bytes + *length);
    else if (*length > 3 && memcmp(bytes, "gz:", 3) == 0)
        packed = gzip(bytes + 3, *length - 3);
    const char *from = packed.length > 0 ? packed.data : bytes;
    *length = packed.length > 0 ? packed.length : *length;
    char *copy = malloc(*length + 1);
    FUZZ_REQUIRE(copy && !packed.failed);
    if (*length > 0)
        memcpy(copy, from, *length);
    copy[*length] = '\0';
    return copy;
}

void fuzz_scan(const uint8_t *bytes, size_t length)
{
    /* the file's length decides what the scene says of it */
    struct scan_options options = {.x_unit = "mm", .z_unit = "um"};
    if (length % 8 == 6) {
        options.x_column = 1;
        options.z_column = 2;
    }
    const char *only = getenv("ROUGHCONTACT_FUZZ_FORMAT"); /* one reader alone */
    OWNED(memory_free) char *copy = fuzz_file((const char *)bytes, &length);
    const struct scan_bytes file = {copy, length, "file.dat"};
    const char *format = format_of(&(struct scan_file){.bytes = copy, .length = length, .path = file.path}, true).name;
    bool any = false;
    size_t parts = 0;
    if (only && (!format || strcmp(format, only) != 0))
        return;
    (void)scan_is_other(&file, true);
    do {
        struct scan scan;
        struct status status = {0};
        size_t entry = options.entry;
        enum status_code code = scan_read_bytes(&scan, &file, &options, &status);
        if (code == STATUS_OK) {
            any = true;
            require_sound(&scan);
            FUZZ_REQUIRE(scan_transpose(&scan, &status) == STATUS_OK);
        } else {
            FUZZ_REQUIRE(code == STATUS_SCAN && *status.message && !strchr(status.message, '\n'));
        }
        options.entry = scan.next_entry;
        FUZZ_REQUIRE(options.entry == 0 || options.entry > entry); /* an archive has an end */
        scan_free(&scan);
    } while (options.entry > 0 && ++parts < MOST_PARTS);
    fuzz_count(format ? format : "none", any);
}
