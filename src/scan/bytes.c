/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/reader.h"

#include <string.h>

struct bytes bytes_begin(const struct scan_file *file, size_t offset)
{
    bool overrun = offset > file->length;
    return (struct bytes){file->bytes + (overrun ? file->length : offset), file->bytes + file->length, overrun};
}

size_t bytes_left(const struct bytes *bytes)
{
    return (size_t)(bytes->end - bytes->at);
}

void bytes_skip(struct bytes *bytes, size_t count)
{
    bytes->overrun = bytes->overrun || count > bytes_left(bytes);
    bytes->at = bytes->overrun ? bytes->end : bytes->at + count;
}

#define TYPES(X)                                                                                                       \
    X(U8, uint8_t)                                                                                                     \
    X(U16, uint16_t) X(U32, uint32_t) X(F32, float) X(I8, int8_t) X(I16, int16_t) X(I32, int32_t) X(F64, double)

size_t bytes_size(enum bytes_type type)
{
#define SIZE(NAME, ctype) [BYTES_##NAME] = sizeof(ctype),
    static const size_t sizes[BYTES_COUNT] = {TYPES(SIZE)};
    return sizes[type];
}

double bytes_number(struct bytes *bytes, enum bytes_type type)
{
    const char *from = bytes->at;
    size_t size = bytes_size(type);
    bytes_skip(bytes, size);
    if (bytes->overrun)
        return 0;
    char turned[sizeof(double)];
    if (__BYTE_ORDER__ == __ORDER_BIG_ENDIAN__) {
        for (size_t i = 0; i < size; i++)
            turned[size - 1 - i] = from[i];
        from = turned;
    }
    switch (type) {
#define NUMBER(NAME, ctype)                                                                                            \
    case BYTES_##NAME: {                                                                                               \
        ctype value;                                                                                                   \
        memcpy(&value, from, sizeof value);                                                                            \
        return (double)value;                                                                                          \
    }
        TYPES(NUMBER)
    default:
        return 0;
    }
}

struct string_view bytes_text(struct bytes *bytes, size_t count)
{
    struct string_view text = {bytes->at, bytes->at};
    bytes_skip(bytes, count);
    if (!bytes->overrun)
        text.end = text.start + strnlen(text.start, count);
    return string_view_trim(text);
}
