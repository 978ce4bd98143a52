#include "scan/utf16.h"

#include <stdint.h>
#include <string.h>

bool utf16_sniff(const struct scan_bytes *file)
{
    return file->length >= 4 && file->length % 2 == 0 &&
           (memcmp(file->bytes, "\xFF\xFE", 2) == 0 || memcmp(file->bytes, "\xFE\xFF", 2) == 0);
}

static void add_utf8(struct text *out, uint32_t code)
{
    char bytes[4];
    size_t count;
    if (code < 0x80) {
        bytes[0] = (char)code;
        count = 1;
    } else if (code < 0x800) {
        bytes[0] = (char)(0xC0 | code >> 6);
        count = 2;
    } else if (code < 0x10000) {
        bytes[0] = (char)(0xE0 | code >> 12);
        count = 3;
    } else {
        bytes[0] = (char)(0xF0 | code >> 18);
        count = 4;
    }
    for (size_t i = 1; i < count; i++)
        bytes[i] = (char)(0x80 | (code >> 6 * (count - 1 - i) & 0x3F));
    text_add_bytes(out, bytes, count);
}

void utf16_convert(struct text *out, const struct scan_bytes *file)
{
    const unsigned char *bytes = (const unsigned char *)file->bytes;
    size_t low = bytes[0] == 0xFF ? 0 : 1; /* which of two bytes is the lower */
    uint32_t high = 0;                     /* first half of a surrogate pair */
    for (size_t i = 2; i + 1 < file->length; i += 2) {
        uint32_t unit = (uint32_t)(bytes[i + low] | bytes[i + 1 - low] << 8);
        if (high && unit >= 0xDC00 && unit < 0xE000) {
            add_utf8(out, 0x10000 + ((high - 0xD800) << 10 | (unit - 0xDC00)));
            high = 0;
            continue;
        }
        if (high)
            add_utf8(out, '?');
        high = unit >= 0xD800 && unit < 0xDC00 ? unit : 0;
        if (!high)
            add_utf8(out, unit >= 0xDC00 && unit < 0xE000 ? '?' : unit);
    }
    if (high)
        add_utf8(out, '?');
}
