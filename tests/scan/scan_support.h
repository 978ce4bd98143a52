/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shared by the tests of the readers: reading from text in memory, the real scans. */
#ifndef TEST_SCAN_SUPPORT_H
#define TEST_SCAN_SUPPORT_H

#include "scan/scan.h"
#include "support.h"

#include <stdio.h>
#include <sys/stat.h>

static const struct scan_options no_units = {.x_unit = "", .z_unit = ""};

/* A copy on the heap, so that AddressSanitizer sees every read beyond bytes[length]. */
static inline struct scan_bytes bytes_copy(const char *bytes, size_t length)
{
    char *copy = malloc(length + 1);
    assert_non_null(copy);
    memcpy(copy, bytes, length);
    copy[length] = '\0';
    return (struct scan_bytes){copy, length, "file"};
}

static inline enum status_code read_bytes(struct scan *scan, const char *bytes, size_t length,
                                          const struct scan_options *options, struct status *status)
{
    struct scan_bytes file = bytes_copy(bytes, length);
    enum status_code code = scan_read_bytes(scan, &file, options, status);
    free((char *)file.bytes);
    return code;
}

/* What scan.h promises about a scan that was read. */
static inline void assert_sound(const struct scan *scan)
{
    assert_non_null(scan->format);
    assert_true(scan->nx >= 3 && scan->ny >= 1);
    assert_true(isfinite(scan->dx_m) && scan->dx_m > 0);
    for (size_t i = 1; scan->x_m && i < scan->nx; i++)
        assert_true(isfinite(scan->x_m[i]) && scan->x_m[i] > scan->x_m[i - 1]);
    size_t missing = 0;
    for (size_t i = 0; i < scan->nx * scan->ny; i++) {
        assert_true(!isinf(scan->z_m[i]));
        missing += isnan(scan->z_m[i]) ? 1U : 0U;
    }
    assert_int_equal(missing, scan->missing);
    assert_true(scan->warning_count <= SCAN_WARNINGS);
}

/* Reads text that has to be a scan. */
static inline struct scan read_with(const char *text, const struct scan_options *options)
{
    struct scan scan;
    struct status status = {0};
    if (read_bytes(&scan, text, strlen(text), options, &status) != STATUS_OK)
        fail_msg("'%s' refused: %s", text, status.message);
    assert_sound(&scan);
    return scan;
}

static inline struct scan read_good(const char *text, const char *x_unit, const char *z_unit)
{
    return read_with(text, &(struct scan_options){.x_unit = x_unit, .z_unit = z_unit});
}

/* Reads bytes that have to be refused as no scan with a message that holds `expected`. */
static inline void assert_refused_bytes(const char *bytes, size_t length, const struct scan_options *options,
                                        const char *expected)
{
    struct scan scan;
    struct status status = {0};
    assert_int_equal(read_bytes(&scan, bytes, length, options, &status), STATUS_SCAN);
    if (!strstr(status.message, expected) || strchr(status.message, '\n'))
        fail_msg("message '%s' should hold '%s' in one line", status.message, expected);
    scan_free(&scan);
}

static inline void refuse_with(const char *text, const struct scan_options *options, const char *expected)
{
    assert_refused_bytes(text, strlen(text), options, expected);
}

static inline void assert_refused(const char *text, const char *expected)
{
    refuse_with(text, &(struct scan_options){.x_unit = "mm", .z_unit = "um"}, expected);
}

static inline double scan_x(const struct scan *scan, size_t i)
{
    return scan->x_m ? scan->x_m[i] : (double)i * scan->dx_m;
}

#define REAL_SCANS PROJECT_SOURCE "/../shared/scans"

static inline bool real_scans_exist(void)
{
    struct stat info;
    return stat(REAL_SCANS, &info) == 0;
}

/* Leaves the test, visibly, where the collection of real scans is not beside the project. */
#define NEED_REAL_SCANS()                                                                                              \
    do {                                                                                                               \
        if (!real_scans_exist()) {                                                                                     \
            print_message("skipped: no real scans at %s\n", REAL_SCANS);                                               \
            skip();                                                                                                    \
        }                                                                                                              \
    } while (0)

#endif
