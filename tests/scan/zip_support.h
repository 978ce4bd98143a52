/* Zip archives and gzip files made in memory. */
#ifndef TEST_ZIP_SUPPORT_H
#define TEST_ZIP_SUPPORT_H

#include "sample_support.h"

#include <zlib.h>

struct member {
    const char *name;
    const char *bytes;
    size_t length;
};

/* A zip archive of the members up to the first without a name, stored or deflated. */
static inline struct text zip(const struct member *members, bool deflated)
{
    struct text text = {0}, directory = {0};
    size_t count = 0;
    for (; members[count].name; count++) {
        const struct member *member = &members[count];
        Bytef packed[8192];
        z_stream stream = {.next_in = (Bytef *)(uintptr_t)member->bytes,
                           .avail_in = (uInt)member->length,
                           .next_out = packed,
                           .avail_out = sizeof packed};
        assert_int_equal(deflateInit2(&stream, 9, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY), Z_OK);
        assert_int_equal(deflate(&stream, Z_FINISH), Z_STREAM_END);
        size_t size = deflated ? stream.total_out : member->length, offset = text.length;
        deflateEnd(&stream);
        struct text common = {0}; /* what local header and directory share */
        put_bytes(&common, deflated ? 8 : 0, 2);
        put_bytes(&common, 0, 4);
        put_bytes(&common, crc32(0, (const Bytef *)member->bytes, (uInt)member->length), 4);
        put_bytes(&common, size, 4);
        put_bytes(&common, member->length, 4);
        put_bytes(&common, strlen(member->name), 2);
        put_bytes(&common, 0, 2);
        put_bytes(&text, 0x04034b50, 4);
        put_bytes(&text, 20, 2);
        put_bytes(&text, 0, 2);
        put_copy(&text, &common);
        put_field(&text, member->name, strlen(member->name));
        text_add_bytes(&text, deflated ? (const char *)packed : member->bytes, size);
        put_bytes(&directory, 0x02014b50, 4);
        put_bytes(&directory, 20, 2);
        put_bytes(&directory, 20, 2);
        put_bytes(&directory, 0, 2);
        put_copy(&directory, &common);
        put_bytes(&directory, 0, 10);
        put_bytes(&directory, offset, 4);
        put_field(&directory, member->name, strlen(member->name));
        text_free(&common);
    }
    size_t start = text.length;
    put_copy(&text, &directory);
    put_bytes(&text, 0x06054b50, 4);
    put_bytes(&text, 0, 4);
    put_bytes(&text, count, 2);
    put_bytes(&text, count, 2);
    put_bytes(&text, directory.length, 4);
    put_bytes(&text, start, 4);
    put_bytes(&text, 0, 2);
    text_free(&directory);
    return text;
}

/* One gzip member of these bytes. */
static inline struct text gzip(const char *bytes, size_t length)
{
    struct text text = {0};
    uLong room = compressBound(length) + 64;
    Bytef *packed = malloc(room);
    z_stream stream = {
        .next_in = (Bytef *)(uintptr_t)bytes, .avail_in = (uInt)length, .next_out = packed, .avail_out = (uInt)room};
    assert_non_null(packed);
    assert_int_equal(deflateInit2(&stream, 9, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY), Z_OK);
    assert_int_equal(deflate(&stream, Z_FINISH), Z_STREAM_END);
    text_add_bytes(&text, (const char *)packed, stream.total_out);
    deflateEnd(&stream);
    free(packed);
    return text;
}

#endif
