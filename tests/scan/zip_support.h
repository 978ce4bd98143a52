/* SPDX-License-Identifier: GPL-3.0-or-later */
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

/* A member as it lies in an archive: what its headers say need not be true. */
struct packed {
    const char *name;
    struct text bytes;
    unsigned method, flags; /* 0 stored, 8 deflated */
    uint32_t crc;
    size_t size; /* unpacked */
    size_t at;   /* of its local header; SIZE_MAX: its own, which is written */
    bool zip64;  /* the directory has its sizes and place in the extra field */
};

/* `length` bytes, deflated; `window` as zlib has it: -15 raw, 31 gzip. */
static inline struct text deflated_bytes(const char *bytes, size_t length, int window)
{
    uLong room = compressBound(length) + 64;
    struct text text = {.data = malloc(room), .capacity = room};
    z_stream stream = {.next_in = (Bytef *)(uintptr_t)bytes,
                       .avail_in = (uInt)length,
                       .next_out = (Bytef *)text.data,
                       .avail_out = (uInt)room};
    assert_non_null(text.data);
    assert_int_equal(deflateInit2(&stream, 9, Z_DEFLATED, window, 8, Z_DEFAULT_STRATEGY), Z_OK);
    assert_int_equal(deflate(&stream, Z_FINISH), Z_STREAM_END);
    text.length = stream.total_out;
    deflateEnd(&stream);
    return text;
}

/* One gzip member of these bytes. */
static inline struct text gzip(const char *bytes, size_t length)
{
    return deflated_bytes(bytes, length, 16 + MAX_WBITS);
}

/* The member of an archive that holds these bytes; its `bytes` are to be freed. */
static inline struct packed pack(const char *name, const char *bytes, size_t length, bool deflated)
{
    struct packed packed = {.name = name, .size = length, .at = SIZE_MAX, .method = deflated ? 8 : 0};
    packed.crc = (uint32_t)crc32(0, (const Bytef *)bytes, (uInt)length);
    if (deflated)
        packed.bytes = deflated_bytes(bytes, length, -MAX_WBITS);
    else
        text_add_bytes(&packed.bytes, bytes, length);
    return packed;
}

/* What local header and directory share, from the flags to the length of the name. */
static inline void put_common(struct text *text, const struct packed *member, bool zip64)
{
    PUT(text, {member->flags, 2}, {member->method, 2}, {0, 4}, {member->crc, 4},
        {zip64 ? UINT32_MAX : member->bytes.length, 4}, {zip64 ? UINT32_MAX : member->size, 4},
        {strlen(member->name), 2});
}

/* An archive of these members. */
static inline struct text zip_of(const struct packed *members, size_t count)
{
    struct text text = {0}, directory = {0};
    for (size_t i = 0; i < count; i++) {
        const struct packed *member = &members[i];
        size_t at = member->at == SIZE_MAX ? text.length : member->at;
        if (member->at == SIZE_MAX) {
            PUT(&text, {0x04034b50, 4}, {20, 2});
            put_common(&text, member, false);
            put_bytes(&text, 0, 2);
            put_field(&text, member->name, strlen(member->name));
            put_copy(&text, &member->bytes);
        }
        PUT(&directory, {0x02014b50, 4}, {20, 2}, {20, 2});
        put_common(&directory, member, member->zip64);
        PUT(&directory, {member->zip64 ? 28 : 0, 2}, {0, 10}, {member->zip64 ? UINT32_MAX : at, 4});
        put_field(&directory, member->name, strlen(member->name));
        if (member->zip64) {
            PUT(&directory, {1, 2}, {24, 2}, {member->size, 8}, {member->bytes.length, 8}, {at, 8});
        }
    }
    size_t start = text.length;
    put_copy(&text, &directory);
    PUT(&text, {0x06054b50, 4}, {0, 4}, {count, 2}, {count, 2}, {directory.length, 4}, {start, 4}, {0, 2});
    text_free(&directory);
    return text;
}

/* A zip archive of the members up to the first without a name, stored or deflated. */
static inline struct text zip(const struct member *members, bool deflated)
{
    size_t count = 0;
    while (members[count].name)
        count++;
    struct packed *packed = support_room((count + 1) * sizeof *packed);
    for (size_t i = 0; i < count; i++)
        packed[i] = pack(members[i].name, members[i].bytes, members[i].length, deflated);
    struct text text = zip_of(packed, count);
    for (size_t i = 0; i < count; i++)
        text_free(&packed[i].bytes);
    return text;
}

#endif
