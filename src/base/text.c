#include "base/text.h"

#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static bool text_reserve(struct text *text, size_t extra)
{
    if (text->failed)
        return false;
    if (extra >= SIZE_MAX / 2 - text->length) { /* doubling the capacity would overflow */
        text->failed = true;
        return false;
    }
    size_t need = text->length + extra + 1;
    if (need <= text->capacity)
        return true;
    size_t capacity = text->capacity ? text->capacity : 256;
    while (capacity < need)
        capacity *= 2;
    char *data = realloc(text->data, capacity);
    if (!data) {
        text->failed = true;
        return false;
    }
    text->data = data;
    text->capacity = capacity;
    return true;
}

void text_add_bytes(struct text *text, const char *bytes, size_t length)
{
    if (!text_reserve(text, length))
        return;
    if (length > 0)
        memcpy(text->data + text->length, bytes, length);
    text->length += length;
    text->data[text->length] = '\0';
}

void text_add(struct text *text, const char *format, ...)
{
    va_list args, again;
    va_start(args, format);
    va_copy(again, args);
    int length = vsnprintf(NULL, 0, format, args);
    va_end(args);
    if (length >= 0 && text_reserve(text, (size_t)length)) {
        vsnprintf(text->data + text->length, (size_t)length + 1, format, again);
        text->length += (size_t)length;
    }
    va_end(again);
}

size_t text_character(const char *s)
{
    static const uint32_t least[] = {0, 0xa0, 0x800, 0x10000}; /* U+0080 to U+009F are control characters */
    unsigned char first = (unsigned char)*s;
    if (first < 0x80)
        return first >= 0x20 && first != 0x7f;
    size_t more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : 0;
    uint32_t code = more ? first & (0x3fu >> more) : 0;
    if (!more || first >= 0xf8)
        return 0;
    for (size_t i = 1; i <= more; i++) {
        if (((unsigned char)s[i] & 0xc0) != 0x80)
            return 0;
        code = code << 6 | ((unsigned char)s[i] & 0x3fu);
    }
    bool surrogate = code >= 0xd800 && code <= 0xdfff;
    bool usable = code >= least[more] && code <= 0x10ffff && !surrogate && (code & 0xfffe) != 0xfffe;
    return usable ? more + 1 : 0;
}

void text_add_shown(struct text *text, const char *string)
{
    for (size_t length; *string; string += length ? length : 1) {
        length = text_character(string);
        text_add_bytes(text, length ? string : "?", length ? length : 1);
    }
}

/** Does Markdown read something into the character there? Marks of lists and rules only count at the beginning, after
 * digits at most; an underscore inside a word is a letter; a colon may make a link only before a slash. */
static bool has_meaning(const char *string, size_t at)
{
    char c = string[at];
    if (strchr("\\`*[]|~$#", c))
        return true;
    if (c == '_')
        return at == 0 || !isalnum((unsigned char)string[at - 1]) || !isalnum((unsigned char)string[at + 1]);
    if (c == ':')
        return string[at + 1] == '/';
    return strchr("+-=.)", c) && strspn(string, "0123456789+-=.) ") >= at;
}

void text_add_markdown(struct text *text, const char *string)
{
    size_t length;
    for (size_t at = 0; string[at]; at += length ? length : 1) {
        length = text_character(string + at);
        if (length == 1 && strchr("<>&\"", string[at])) {
            text_add(text, "&#%d;", string[at]);
            continue;
        }
        if (length == 1 && has_meaning(string, at))
            text_add_bytes(text, "\\", 1);
        text_add_bytes(text, length ? string + at : "?", length ? length : 1);
    }
}

void text_add_html(struct text *out, const char *bytes, size_t size)
{
    static const char *const escapes[128] = {
        ['<'] = "&lt;", ['>'] = "&gt;", ['&'] = "&amp;", ['"'] = "&quot;", ['\n'] = "\n", ['\t'] = "\t"};
    for (const char *end = bytes + size; bytes < end;) {
        unsigned char c = (unsigned char)*bytes;
        const char *escape = c < 128 ? escapes[c] : NULL;
        size_t length = text_character(bytes);
        if (escape)
            text_add(out, "%s", escape);
        else
            text_add_bytes(out, length ? bytes : "?", length ? length : 1);
        bytes += length ? length : 1;
    }
}

void text_add_csv(struct text *text, const char *string)
{
    if (!strpbrk(string, ",\"\r\n")) {
        text_add_bytes(text, string, strlen(string));
        return;
    }
    text_add_bytes(text, "\"", 1);
    for (; *string; string++) {
        if (*string == '"')
            text_add_bytes(text, "\"", 1);
        text_add_bytes(text, string, 1);
    }
    text_add_bytes(text, "\"", 1);
}

const char *text_string(const struct text *text)
{
    return text->data ? text->data : "";
}

void text_free(struct text *text)
{
    free(text->data);
    *text = (struct text){0};
}

enum status_code text_read_stream(struct text *text, FILE *file, const char *name, struct status *status)
{
    struct stat info;
    if (fstat(fileno(file), &info) == 0 && S_ISREG(info.st_mode))
        text_reserve(text, (size_t)info.st_size + 1);
    for (;;) {
        if (!text_reserve(text, 65536))
            return status_memory(status);
        size_t got = fread(text->data + text->length, 1, text->capacity - text->length - 1, file);
        text->length += got;
        text->data[text->length] = '\0';
        if (got == 0)
            break;
    }
    if (ferror(file))
        return status_fail(status, STATUS_IO, "cannot read '%s': %s", name, strerror(errno));
    return STATUS_OK;
}

enum status_code text_read_file(struct text *text, const char *path, struct status *status)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        return status_fail(status, STATUS_IO, "cannot open '%s': %s", path, strerror(errno));
    enum status_code code = text_read_stream(text, file, path, status);
    fclose(file);
    return code;
}

enum status_code text_write_file(const char *path, const char *bytes, size_t length, struct status *status)
{
    FILE *file = fopen(path, "wb");
    if (!file)
        return status_fail(status, STATUS_IO, "cannot write '%s': %s", path, status_reason(errno));
    size_t written = fwrite(bytes, 1, length, file);
    int reason = errno;
    if (fclose(file) != 0 || written != length)
        return status_fail(status, STATUS_IO, "cannot write '%s': %s", path,
                           strerror(written != length ? reason : errno));
    return STATUS_OK;
}
