/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Binary instrument formats. */
#include "sample_support.h"

#include <zlib.h>

static struct text mahr_prf(size_t claimed)
{
    struct text text = {0};
    put_field(&text, "[p3dlin]\t", 0x14);
    put_bytes(&text, claimed, 4);
    put_field(&text, "settings", 64);
    put_field(&text, "[Trajec]", 49);
    for (size_t axis = 0; axis < 3; axis++)
        for (size_t i = 0; i < SAMPLE_POINTS; i++)
            put_f64(&text, axis == 0 ? 0.0005 * (double)i : axis == 1 ? 7.0 : sample_um[i] * 1e-3);
    put_field(&text, "", SAMPLE_POINTS * 4);
    return text;
}

TEST_CASE(test_mahr_prf)
{
    struct text text = mahr_prf(SAMPLE_POINTS);
    assert_sample(&text, "mahr-prf", SCAN_PROFILE, SAMPLE_POINTS, &no_units);
    assert_refused_bytes(text_string(&text), 60, &no_units, "no [Trajec] section");
    text_free(&text);
    refuse_text(mahr_prf(4000000000), &no_units, "the header says 4000000000 x 1 points");
    refuse_text(mahr_prf(0), &no_units, "nothing measured");
}

/* Data type `type` of ISO 25178-71 with point 1 missing where the type has a mark for that. */
static struct text sdf(unsigned type, size_t nx, size_t ny, size_t extra)
{
    struct text text = {0};
    put_field(&text, "bISO-1.0", 8 + 10 + 12 + 12);
    PUT(&text, {nx, 2}, {ny, 2});
    put_f64(&text, 0.5e-6);
    put_f64(&text, 2e-6);
    put_f64(&text, type == 3 || type == 7 ? 1e-6 : 0.125e-6);
    put_f64(&text, -1);
    PUT(&text, {0, 1}, {type, 1}, {0, 1}, {0x0000000100000005, extra});
    for (size_t i = 0; i < SAMPLE_POINTS; i++) {
        int64_t whole = (int64_t)(sample_um[i] * 8);
        if (type == 3)
            put_f32(&text, i == 1 ? NAN : sample_um[i]);
        else if (type == 7)
            put_f64(&text, i == 1 ? NAN : sample_um[i]);
        else if (type == 4)
            put_bytes(&text, (uint64_t)whole, 1);
        else if (type == 5)
            put_bytes(&text, i == 1 ? 0x8000 : (uint64_t)whole, 2);
        else
            put_bytes(&text, i == 1 ? 0x80000000 : (uint64_t)whole, 4);
    }
    return text;
}

TEST_CASE(test_sdf)
{
    for (unsigned type = 3; type < 8; type++) {
        expect_sample(sdf(type, SAMPLE_COLUMNS, SAMPLE_ROWS, 0), "sdf", SCAN_AREAL, type == 4 ? SAMPLE_POINTS : 1,
                      &no_units);
    }
    struct text text = sdf(5, SAMPLE_POINTS, 1, 8); /* as Olympus writes it */
    assert_sample(&text, "sdf", SCAN_PROFILE, 1, &no_units);
    assert_refused_bytes(text_string(&text), 50, &no_units, "the file ends within its header");
    text_free(&text);
    refuse_text(sdf(7, 65535, 65535, 0), &no_units, "the header says 65535 x 65535 points, the file ends");
    refuse_text(sdf(8, 3, 2, 0), &no_units, "data type 8 is none");
}

struct sur_sample {
    const char *magic;
    unsigned kind, bits, format, objects;
    bool map;
};

static struct text sur_heights(unsigned bits)
{
    struct text text = {0};
    for (size_t i = 0; i < SAMPLE_POINTS; i++)
        put_bytes(&text, (uint64_t)(int64_t)(i == 1 ? -30 : (sample_um[i] - 1) * 8), bits / 8);
    return text;
}

/* z = integer x 0.125 um + 1 um; the smallest is -28, so -30 is a missing point. */
static struct text sur(const struct sur_sample *sample)
{
    struct text text = {0};
    put_field(&text, sample->magic, 12);
    PUT(&text, {sample->format, 2}, {sample->objects, 2}, {1, 2}, {sample->kind, 2});
    put_field(&text, "name", 30 + 30 + 6);
    put_bytes(&text, 1, 2);
    put_field(&text, "", 10);
    PUT(&text, {sample->bits, 2}, {(uint64_t)-28, 4}, {100, 4}, {sample->map ? SAMPLE_COLUMNS : SAMPLE_POINTS, 4},
        {sample->map ? SAMPLE_ROWS : 1, 4}, {SAMPLE_POINTS, 4});
    put_f32(&text, 0.0005);
    put_f32(&text, 0.002);
    put_f32(&text, 0.125);
    for (size_t i = 0; i < 3; i++)
        put_field(&text, "axis", 16);
    put_field(&text, "mm              ", 16);
    put_field(&text, "mm", 16);
    put_field(&text, "\xB5m", 16);
    put_field(&text, "", 3 * 16 + 3 * 4 + 3 * 2 + 12 + 14 + 4 + 10);
    PUT(&text, {7, 2}, {2, 2});
    put_field(&text, "", 128 + 8);
    put_f32(&text, 1);
    put_field(&text, "", 34);
    assert_int_equal(text.length, 512);
    put_field(&text, "remarks", 9);
    return text;
}

TEST_CASE(test_sur)
{
    static const struct sur_sample samples[] = {
        {"DIGITAL SURF", 2, 16, 0, 1, true}, {"DIGITAL SURF", 2, 32, 0, 1, true}, {"DIGITAL SURF", 1, 16, 0, 1, false}};
    for (size_t i = 0; i < 3; i++) {
        struct text text = sur(&samples[i]), heights = sur_heights(samples[i].bits);
        put_copy(&text, &heights);
        assert_sample(&text, "sur", samples[i].map ? SCAN_AREAL : SCAN_PROFILE, 1, &no_units);
        assert_refused_bytes(text_string(&text), text.length - 1, &no_units, "the file ends after 5");
        assert_refused_bytes(text_string(&text), 300, &no_units, "the file ends within its header");
        text_free(&text);
        text_free(&heights);
    }
    static const struct {
        struct sur_sample sample;
        const char *message;
    } bad[] = {{{"DIGITAL SURF", 2, 16, 256, 1, true}, "old Macintosh"},
               {{"DIGITAL SURF", 5, 16, 0, 1, true}, "kind 5 is neither"},
               {{"DIGITAL SURF", 2, 8, 0, 1, true}, "8 bits a point"}};
    for (size_t i = 0; i < 3; i++) {
        refuse_text(sur(&bad[i].sample), &no_units, bad[i].message);
    }
}

TEST_CASE(test_sur_compressed)
{
    const struct sur_sample sample = {"DSCOMPRESSED", 2, 16, 0, 1, true};
    struct text text = sur(&sample), heights = sur_heights(16);
    Bytef packed[2][64];
    uLongf size[2] = {64, 64};
    for (size_t i = 0; i < 2; i++)
        assert_int_equal(compress(packed[i], &size[i], (const Bytef *)heights.data + i * 6, 6), Z_OK);
    put_bytes(&text, 2, 4);
    for (size_t i = 0; i < 2; i++) {
        PUT(&text, {6, 4}, {size[i], 4});
    }
    size_t streams = text.length;
    for (size_t i = 0; i < 2; i++)
        text_add_bytes(&text, (const char *)packed[i], size[i]);
    assert_sample(&text, "sur", SCAN_AREAL, 1, &no_units);
    text.data[streams + 5] ^= 0x55;
    assert_refused_bytes(text_string(&text), text.length, &no_units, "compressed stream 1 is damaged");
    text.data[streams - 13] = 0x7f; /* 2 GB inflated from a few bytes */
    assert_refused_bytes(text_string(&text), text.length, &no_units, "longer than the file can hold");
    text_free(&text);
    text_free(&heights);
}

static struct text gsf(const char *units)
{
    struct text text = {0};
    text_add(&text, "Gwyddion Simple Field 1.0\nXRes = 3\nYRes = 2\nXReal = 1.5\nYReal = 4\nTitle = x\n%s", units);
    put_field(&text, "", 4 - text.length % 4);
    for (size_t i = 0; i < SAMPLE_POINTS; i++)
        put_f32(&text, i == 4 ? NAN : sample_um[i]);
    return text;
}

TEST_CASE(test_gsf)
{
    struct scan_options um = {.x_unit = "um", .z_unit = "um"};
    struct text text = gsf("XYUnits = \xC2\xB5m\nZUnits = um\n");
    assert_sample(&text, "gsf", SCAN_AREAL, 4, &no_units);
    assert_refused_bytes(text_string(&text), text.length - 4, &no_units, "the header says 3 x 2 points, the file ends");
    text_free(&text);
    text = gsf("");
    assert_sample(&text, "gsf", SCAN_AREAL, 4, &um);
    assert_refused_bytes(text_string(&text), text.length, &no_units, "no unit for x nor for z");
    text_free(&text);
    refuse_text(gsf("XRes = x9\n"), &no_units, "file:7: XRes = 'x9'");
    refuse_text(gsf("XRes = 2.5\n"), &um, "the header says 2.5 x 2 points: nothing measured");
}

static void put_tag(struct text *text, const char *key, const char *value)
{
    put_field(text, key, 20);
    put_field(text, value, 30);
    text_add_bytes(text, "\r\n", 2);
}

static struct text al3d(const char *offset, const char *rows)
{
    struct text text = {0};
    put_field(&text, "AliconaImaging", 15);
    text_add_bytes(&text, "\r\n", 2);
    put_tag(&text, "Version", "1");
    put_tag(&text, "TagCount", "6");
    put_tag(&text, "Cols", "3");
    put_tag(&text, "Rows", rows);
    put_tag(&text, "DepthImageOffset", offset);
    put_tag(&text, "InvalidPixelValue", "3.000000028082e+15");
    put_tag(&text, "PixelSizeYMeter", "2e-06");
    put_tag(&text, "PixelSizeXMeter", "5e-07");
    put_field(&text, "comment", 500 - text.length);
    for (size_t i = 0; i < SAMPLE_POINTS; i++) {
        put_f32(&text, i == 2 ? 3.0000000280e15 : sample_um[i] * 1e-6);
        if (i % 3 == 2)
            put_f32(&text, 99); /* rows are filled up to 8 bytes */
    }
    return text;
}

TEST_CASE(test_al3d)
{
    expect_sample(al3d("500", "2"), "al3d", SCAN_AREAL, 2, &no_units);
    refuse_text(al3d("500", "4000000000"), &no_units, "3 x 4000000000 points");
    refuse_text(al3d("0", "2"), &no_units, "no depth image");
    refuse_text(al3d("500", "x"), &no_units, "the header says 3 x 0 points: nothing measured");
}
