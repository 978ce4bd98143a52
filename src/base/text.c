#include "base/text.h"

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

void text_add_markdown(struct text *text, const char *string)
{
    for (; *string; string++) {
        unsigned char c = (unsigned char)*string;
        if (c < 0x20 || c == 0x7f)
            text_add_bytes(text, "?", 1);
        else if (c == '<' || c == '>' || c == '&' || c == '"')
            text_add(text, "&#%d;", c);
        else {
            if (strchr("\\`*_{}[]()#+-.!|~$^=:", c))
                text_add_bytes(text, "\\", 1);
            text_add_bytes(text, string, 1);
        }
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

enum status_code text_read_file(struct text *text, const char *path, struct status *status)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        return status_fail(status, STATUS_IO, "cannot open '%s': %s", path, strerror(errno));
    struct stat info;
    if (fstat(fileno(file), &info) == 0 && S_ISREG(info.st_mode))
        text_reserve(text, (size_t)info.st_size + 1);
    for (;;) {
        if (!text_reserve(text, 65536)) {
            fclose(file);
            return status_memory(status);
        }
        size_t got = fread(text->data + text->length, 1, text->capacity - text->length - 1, file);
        text->length += got;
        text->data[text->length] = '\0';
        if (got == 0)
            break;
    }
    bool bad = ferror(file) != 0;
    int reason = errno;
    fclose(file);
    if (bad)
        return status_fail(status, STATUS_IO, "cannot read '%s': %s", path, strerror(reason));
    return STATUS_OK;
}

enum status_code text_write_file(const char *path, const char *bytes, size_t length, struct status *status)
{
    FILE *file = fopen(path, "wb");
    if (!file)
        return status_fail(status, STATUS_IO, "cannot write '%s': %s", path, strerror(errno));
    size_t written = fwrite(bytes, 1, length, file);
    int reason = errno;
    if (fclose(file) != 0 || written != length)
        return status_fail(status, STATUS_IO, "cannot write '%s': %s", path,
                           strerror(written != length ? reason : errno));
    return STATUS_OK;
}
