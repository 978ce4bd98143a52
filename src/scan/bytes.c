#include "scan/bytes.h"

#include <string.h>

struct bytes bytes_begin(const struct scan_bytes *file, size_t offset)
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

/* `size` bytes as one unsigned number, whatever the order of this machine. */
static uint64_t take(struct bytes *bytes, size_t size)
{
    const char *from = bytes->at;
    uint64_t value = 0;
    bytes_skip(bytes, size);
    if (!bytes->overrun)
        for (size_t i = size; i-- > 0;)
            value = value << 8 | (unsigned char)from[i];
    return value;
}

uint16_t bytes_u16(struct bytes *bytes)
{
    return (uint16_t)take(bytes, 2);
}

int16_t bytes_i16(struct bytes *bytes)
{
    return (int16_t)take(bytes, 2);
}

uint32_t bytes_u32(struct bytes *bytes)
{
    return (uint32_t)take(bytes, 4);
}

int32_t bytes_i32(struct bytes *bytes)
{
    return (int32_t)take(bytes, 4);
}

float bytes_f32(struct bytes *bytes)
{
    uint32_t bits = bytes_u32(bytes);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

double bytes_f64(struct bytes *bytes)
{
    uint64_t bits = take(bytes, 8);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

double bytes_number(struct bytes *bytes, enum bytes_type type)
{
    switch (type) {
    case BYTES_U8:
        return (double)take(bytes, 1);
    case BYTES_I8:
        return (double)(int8_t)take(bytes, 1);
    case BYTES_U16:
        return bytes_u16(bytes);
    case BYTES_I16:
        return bytes_i16(bytes);
    case BYTES_U32:
        return bytes_u32(bytes);
    case BYTES_I32:
        return bytes_i32(bytes);
    case BYTES_F32:
        return (double)bytes_f32(bytes);
    case BYTES_F64:
    case BYTES_TYPES:
        break;
    }
    return bytes_f64(bytes);
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
    static const size_t sizes[BYTES_TYPES + 1] = {1, 2, 4, 4, 1, 2, 4, 8, 8};
    return sizes[type];
}
