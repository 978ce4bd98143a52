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

/* `size` bytes as one number, whatever the order of this machine. */
static inline void take(struct bytes *bytes, void *value, size_t size)
{
    const char *from = bytes->at;
    bytes_skip(bytes, size);
    if (bytes->overrun)
        return;
    if (__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__)
        memcpy(value, from, size);
    else
        for (size_t i = 0; i < size; i++)
            ((char *)value)[size - 1 - i] = from[i];
}

#define BYTES_READ(NAME, name, ctype)                                                                                  \
    ctype bytes_##name(struct bytes *bytes)                                                                            \
    {                                                                                                                  \
        ctype value = 0;                                                                                               \
        take(bytes, &value, sizeof value);                                                                             \
        return value;                                                                                                  \
    }
BYTES_TYPES(BYTES_READ)

double bytes_number(struct bytes *bytes, enum bytes_type type)
{
    switch (type) {
#define BYTES_CASE(NAME, name, ctype)                                                                                  \
    case BYTES_##NAME:                                                                                                 \
        return (double)bytes_##name(bytes);
        BYTES_TYPES(BYTES_CASE)
    default:
        return 0.0;
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

size_t bytes_size(enum bytes_type type)
{
#define BYTES_SIZE(NAME, name, ctype) sizeof(ctype),
    static const size_t sizes[] = {BYTES_TYPES(BYTES_SIZE)};
    return sizes[type];
}
