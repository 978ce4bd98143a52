/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Small samples for the readers, all of the heights below (NaN where the sample has a missing point): a profile of six
 * points 0.5 um apart, or a map of three columns and two rows 2 um apart. */
#ifndef TEST_SAMPLE_SUPPORT_H
#define TEST_SAMPLE_SUPPORT_H

#include "base/text.h"
#include "scan_support.h"

enum { SAMPLE_POINTS = 6, SAMPLE_COLUMNS = 3, SAMPLE_ROWS = 2 };

static const double sample_um[SAMPLE_POINTS] = {0.5, -1.25, 2.75, 0.125, 8.0, -3.5};

/* The `count` lowest bytes of `value`, little-endian. */
static inline void put_bytes(struct text *text, uint64_t value, size_t count)
{
    for (; count > 0; count--, value >>= 8) {
        char byte = (char)(value & 0xff);
        text_add_bytes(text, &byte, 1);
    }
}

/* Values, each with its number of bytes: PUT(&text, {1, 2}, {7, 4}). */
#define PUT(text, ...)                                                                                                 \
    do {                                                                                                               \
        const uint64_t fields[][2] = {__VA_ARGS__};                                                                    \
        for (size_t field = 0; field < sizeof fields / sizeof *fields; field++)                                        \
            put_bytes(text, fields[field][0], fields[field][1]);                                                       \
    } while (0)

static inline void put_f32(struct text *text, double value)
{
    float single = (float)value;
    uint32_t bits;
    memcpy(&bits, &single, sizeof bits);
    put_bytes(text, bits, sizeof bits);
}

static inline void put_f64(struct text *text, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    put_bytes(text, bits, sizeof bits);
}

/* `string` in a field of `count` bytes, filled up with NUL. */
static inline void put_field(struct text *text, const char *string, size_t count)
{
    size_t length = strlen(string);
    text_add_bytes(text, string, length);
    for (; length < count; length++)
        text_add_bytes(text, "\0", 1);
}

static inline void put_copy(struct text *text, const struct text *other)
{
    text_add_bytes(text, text_string(other), other->length);
}

/* Reads `sample` and compares it with the heights; `missing` is the point that is missing, SAMPLE_POINTS: none. */
static inline void assert_sample(const struct text *sample, const char *format, enum scan_kind kind, size_t missing,
                                 const struct scan_options *options)
{
    struct scan scan;
    struct status status = {0};
    if (read_bytes(&scan, text_string(sample), sample->length, options, &status) != STATUS_OK)
        fail_msg("%s refused: %s", format, status.message);
    assert_sound(&scan);
    assert_string_equal(scan.format, format);
    assert_int_equal(scan.kind, kind);
    assert_int_equal(scan.nx, kind == SCAN_AREAL ? SAMPLE_COLUMNS : SAMPLE_POINTS);
    assert_int_equal(scan.ny, kind == SCAN_AREAL ? SAMPLE_ROWS : 1);
    assert_near(scan.dx_m, 0.5e-6, 1e-6);
    assert_near(scan.dy_m, kind == SCAN_AREAL ? 2e-6 : 0.0, 1e-6);
    assert_int_equal(scan.missing, missing < SAMPLE_POINTS ? 1 : 0);
    for (size_t i = 0; i < SAMPLE_POINTS; i++) {
        if (i == missing)
            assert_true(isnan(scan.z_m[i]));
        else
            assert_within(scan.z_m[i], sample_um[i] * 1e-6, 1e-12);
    }
    scan_free(&scan);
}

/* The same of a sample that is freed. */
static inline void expect_sample(struct text sample, const char *format, enum scan_kind kind, size_t missing,
                                 const struct scan_options *options)
{
    assert_sample(&sample, format, kind, missing, options);
    text_free(&sample);
}

/* Bytes, which are freed, that are refused with these words. */
static inline void refuse_text(struct text text, const struct scan_options *options, const char *expected)
{
    assert_refused_bytes(text_string(&text), text.length, options, expected);
    text_free(&text);
}

/* As a text: a sample that is a string. */
static inline void assert_text_sample(const char *string, const char *format, enum scan_kind kind, size_t missing,
                                      const struct scan_options *options)
{
    struct text text = {(char *)string, strlen(string), 0, false};
    assert_sample(&text, format, kind, missing, options);
}

#endif
