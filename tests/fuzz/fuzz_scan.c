/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz.h"

#include "base/text.h"
#include "scan/format.h"
#include <math.h>
#include <zlib.h>

enum { FORMATS = 32, MOST_PARTS = 8, MOST_MEMBERS = 16 };

static struct {
    const char *format;
    size_t runs, scans; /* those that were a scan */
} counts[FORMATS];

static void count(const char *format, bool scan)
{
    size_t i = 0;
    while (i < FORMATS - 1 && counts[i].format && strcmp(counts[i].format, format) != 0)
        i++;
    counts[i].format = format;
    counts[i].runs++;
    counts[i].scans += scan;
}

size_t fuzz_scan_good(const char *format)
{
    size_t i = 0;
    while (i < FORMATS && counts[i].format && strcmp(counts[i].format, format) != 0)
        i++;
    return i < FORMATS && counts[i].format ? counts[i].scans : 0;
}

void fuzz_scan_counts(void)
{
    for (size_t i = 0; i < FORMATS && counts[i].format; i++)
        fprintf(stderr, "runs of %-9s %9zu, scans %9zu\n", counts[i].format, counts[i].runs, counts[i].scans);
}

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

static void put(struct text *out, uint32_t value, unsigned bytes)
{
    for (; bytes > 0; bytes--, value >>= 8) {
        char byte = (char)(value & 0xff);
        text_add_bytes(out, &byte, 1);
    }
}

/* A zip archive of the members, each a line with its name behind '=', then its bytes up to the next line that begins
 * so: what is inside an archive is read only where its checksum is right, which no mutation of the archive keeps. */
static void pack_zip(struct text *out, const char *at, const char *end)
{
    struct text directory = {0};
    uint32_t members = 0;
    while (at < end && *at == '=' && members < MOST_MEMBERS) {
        const char *name = at + 1, *stop = memchr(name, '\n', (size_t)(end - name));
        stop = stop ? stop : end;
        const char *content = stop < end ? stop + 1 : end, *next = memmem(content, (size_t)(end - content), "\n=", 2);
        next = next ? next : end;
        struct text common = {0};
        put(&common, 0, 2 + 4); /* stored, no time */
        put(&common, (uint32_t)crc32(0, (const Bytef *)content, (uInt)(next - content)), 4);
        put(&common, (uint32_t)(next - content), 4);
        put(&common, (uint32_t)(next - content), 4);
        put(&common, (uint32_t)(stop - name), 2);
        put(&common, 0, 2);
        text_add(&directory, "PK\001\002");
        put(&directory, 20, 2);
        put(&directory, 20, 4);
        text_add_bytes(&directory, common.data, common.length);
        put(&directory, 0, 4);
        put(&directory, 0, 4);
        put(&directory, 0, 2);
        put(&directory, (uint32_t)out->length, 4);
        text_add_bytes(&directory, name, (size_t)(stop - name));
        text_add(out, "PK\003\004");
        put(out, 20, 4);
        text_add_bytes(out, common.data, common.length);
        text_add_bytes(out, name, (size_t)(stop - name));
        text_add_bytes(out, content, (size_t)(next - content));
        text_free(&common);
        members++;
        at = next < end ? next + 1 : end;
    }
    uint32_t start = (uint32_t)out->length;
    text_add_bytes(out, text_string(&directory), directory.length);
    text_add(out, "PK\005\006");
    put(out, 0, 4);
    put(out, members, 2);
    put(out, members, 2);
    put(out, (uint32_t)directory.length, 4);
    put(out, start, 4);
    put(out, 0, 2);
    text_free(&directory);
}

static void pack_gzip(struct text *out, const char *at, const char *end)
{
    Bytef packed[1024];
    z_stream stream = {.next_in = (Bytef *)(uintptr_t)at, .avail_in = (uInt)(end - at)};
    FUZZ_REQUIRE(deflateInit2(&stream, 1, Z_DEFLATED, 16 + 9, 1, Z_DEFAULT_STRATEGY) == Z_OK);
    for (int code = Z_OK; code == Z_OK;) {
        stream.next_out = packed;
        stream.avail_out = sizeof packed;
        code = deflate(&stream, Z_FINISH);
        text_add_bytes(out, (const char *)packed, sizeof packed - stream.avail_out);
    }
    deflateEnd(&stream);
}

/* A file on the heap, so that AddressSanitizer sees every read beyond its end. Inputs that begin with "zip:" or "gz:"
 * are packed first. */
static char *file_of(const char *bytes, size_t *length)
{
    struct text packed = {0};
    if (*length > 4 && memcmp(bytes, "zip:", 4) == 0)
        pack_zip(&packed, bytes + 4, bytes + *length);
    else if (*length > 3 && memcmp(bytes, "gz:", 3) == 0)
        pack_gzip(&packed, bytes + 3, bytes + *length);
    const char *from = packed.length > 0 ? packed.data : bytes;
    *length = packed.length > 0 ? packed.length : *length;
    char *copy = malloc(*length + 1);
    FUZZ_REQUIRE(copy && !packed.failed);
    if (*length > 0)
        memcpy(copy, from, *length);
    copy[*length] = '\0';
    text_free(&packed);
    return copy;
}

void fuzz_scan(const uint8_t *bytes, size_t length)
{
    /* what the scene says of the file follows from its length */
    struct scan_options options = {.x_unit = "mm", .z_unit = length % 8 == 7 ? "urad" : "um"};
    options.quantity = length % 8 == 7 ? SCAN_SLOPE : SCAN_HEIGHT;
    if (length % 8 == 6) {
        options.x_column = "1";
        options.z_column = "2";
    }
    const char *only = getenv("ROUGHCONTACT_FUZZ_FORMAT"); /* one reader alone */
    char *copy = file_of((const char *)bytes, &length);
    const struct scan_bytes file = {copy, length, "file.dat"};
    const char *format = format_of(&(struct scan_file){.bytes = copy, .length = length, .path = file.path}, true).name;
    bool any = false;
    size_t parts = 0;
    if (only && (!format || strcmp(format, only) != 0)) {
        free(copy);
        return;
    }
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
    count(format ? format : "none", any);
    free(copy);
}
