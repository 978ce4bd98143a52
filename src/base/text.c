/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/text.h"
#include "base/limits.h"

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
    size_t need = text->length + extra + 1, capacity = text->capacity ? text->capacity : 256;
    text->failed = text->failed || extra >= SIZE_MAX / 2 - text->length; /* doubling the capacity would overflow */
    if (text->failed || need <= text->capacity)
        return !text->failed;
    while (capacity < need)
        capacity *= 2;
    char *data = realloc(text->data, capacity);
    text->failed = !data;
    text->data = data ? data : text->data;
    text->capacity = data ? capacity : text->capacity;
    return data;
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
    char *line;
    va_list args;
    va_start(args, format);
    int length = vasprintf(&line, format, args);
    va_end(args);
    text->failed = text->failed || length < 0;
    if (length >= 0) {
        text_add_bytes(text, line, (size_t)length);
        free(line);
    }
    status_lost |= text->failed;
}

/* Characters that are invisible or change those around them: controls; soft hyphen; joiners and fillers; bidirectional
 * marks; separators; tags; what is no character. They are Unicode 15's default ignorables, without the variation
 * selectors of visible signs. */
static const struct {
    uint32_t first, last;
} hidden[] = {
    {0x00, 0x1f},     {0x7f, 0x9f},       {0xad, 0xad},       {0x34f, 0x34f},     {0x61c, 0x61c},
    {0x115f, 0x1160}, {0x17b4, 0x17b5},   {0x180b, 0x180f},   {0x200b, 0x200f},   {0x2028, 0x202e},
    {0x2060, 0x206f}, {0x3164, 0x3164},   {0xfdd0, 0xfdef},   {0xfeff, 0xfeff},   {0xffa0, 0xffa0},
    {0xfff0, 0xfffb}, {0x1bca0, 0x1bca3}, {0x1d173, 0x1d17a}, {0xe0000, 0xe0fff},
};

/** Bytes of the UTF-8 character at `s` and its code; 0 when it is none. */
static size_t decode(const char *s, uint32_t *code)
{
    static const uint32_t least[] = {0, 0x80, 0x800, 0x10000};
    unsigned char first = (unsigned char)*s;
    size_t more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : 0;
    *code = more ? first & (0x3fu >> more) : first;
    if (first >= 0xf8 || (!more && first >= 0x80))
        return 0;
    for (size_t i = 1; i <= more; i++) {
        if (((unsigned char)s[i] & 0xc0) != 0x80)
            return 0;
        *code = *code << 6 | ((unsigned char)s[i] & 0x3fu);
    }
    bool surrogate = *code >= 0xd800 && *code <= 0xdfff;
    return *code >= least[more] && *code <= 0x10ffff && !surrogate ? more + 1 : 0;
}

static bool is_hidden(uint32_t code)
{
    bool is = (code & 0xfffe) == 0xfffe;
    for (size_t i = 0; !is && i < sizeof hidden / sizeof *hidden; i++)
        is = code >= hidden[i].first && code <= hidden[i].last;
    return is;
}

size_t text_character(const char *s)
{
    uint32_t code;
    if (*s >= 0x20 && *s < 0x7f)
        return 1;
    size_t bytes = decode(s, &code);
    return is_hidden(code) ? 0 : bytes;
}

size_t text_fit(const char *string, size_t most)
{
    size_t length = strnlen(string, most + 1);
    if (length <= most)
        return length;
    while (most > 0 && ((unsigned char)string[most] & 0xc0) == 0x80)
        most--;
    return most;
}

/** As text_show(), but for backslashes. */
static struct text_shown show_plainly(const char *s)
{
    struct text_shown shown = {.bytes = text_character(s)};
    uint32_t code;
    if (shown.bytes > 0) {
        memcpy(shown.text, s, shown.bytes);
        return shown;
    }
    shown.bytes = decode(s, &code);
    if (shown.bytes < 2) {
        shown.bytes = 1;
        snprintf(shown.text, sizeof shown.text, "\\x%02x", (unsigned)(unsigned char)*s);
    } else
        snprintf(shown.text, sizeof shown.text, code > 0xffff ? "\\U%08x" : "\\u%04x", (unsigned)code);
    return shown;
}

struct text_shown text_show(const char *s)
{
    struct text_shown shown = show_plainly(s);
    if (*s == '\\' && s[1] && (strchr("\\xuU", s[1]) || text_character(s + 1) == 0))
        strcpy(shown.text, "\\\\");
    return shown;
}

void text_add_shown(struct text *text, const char *string)
{
    while (*string) {
        struct text_shown shown = text_show(string);
        text_add_bytes(text, shown.text, strlen(shown.text));
        string += shown.bytes;
    }
}

/** Has the character a meaning in Markdown? Marks of lists and rules count only at the beginning, or behind digits
 * there; an underscore inside a word is a letter; a colon makes a link only before a slash. */
static bool has_meaning(const char *string, size_t at)
{
    char c = string[at];
    if (strchr("\\`*[]|~$#", c))
        return true;
    if (c == '_')
        return at == 0 || !isalnum((unsigned char)string[at - 1]) || !isalnum((unsigned char)string[at + 1]);
    if (c == ':')
        return string[at + 1] == '/';
    if (c == '.' || c == ')')
        return (string[at + 1] == '\0' || string[at + 1] == ' ') && strspn(string, "0123456789 ") >= at;
    return strchr("+-=", c) && strspn(string, "0123456789+-=.) ") >= at;
}

void text_add_markdown_shown(struct text *text, const char *all)
{
    for (size_t at = 0; all[at]; at++) {
        if (strchr("<>&\"", all[at])) {
            text_add(text, "&#%d;", all[at]);
            continue;
        }
        if (has_meaning(all, at))
            text_add_bytes(text, "\\", 1);
        text_add_bytes(text, all + at, 1);
    }
}

void text_add_unmarked(struct text *text, const char *string)
{
    for (; *string; string++)
        text_add(text, strchr("\\*`#", *string) ? "\\%c" : "%c", *string);
}

void text_strip_marks(struct text *text)
{
    size_t kept = 0;
    for (size_t i = 0; i < text->length; i++)
        if (text->data[i] == '\\' && i + 1 < text->length)
            text->data[kept++] = text->data[++i];
        else if (text->data[i] == '#' && (text->data[i + 1] == '#' || text->data[i + 1] == ' '))
            i += text->data[i + 1] == ' '; /* of a heading */
        else if (!strchr("*`", text->data[i]))
            text->data[kept++] = text->data[i];
    text->length = kept;
    if (text->data)
        text->data[kept] = '\0';
}

void text_add_html(struct text *out, const char *bytes, size_t size)
{
    static const char *const escapes[128] = {
        ['<'] = "&lt;", ['>'] = "&gt;", ['&'] = "&amp;", ['"'] = "&quot;", ['\n'] = "\n", ['\t'] = "\t"};
    for (const char *end = bytes + size; bytes < end;) {
        unsigned char c = (unsigned char)*bytes;
        const char *escape = c < 128 ? escapes[c] : NULL;
        struct text_shown shown = {.bytes = 1};
        if (!escape)
            shown = show_plainly(bytes);
        escape = escape ? escape : shown.text;
        text_add_bytes(out, escape, strlen(escape));
        bytes += shown.bytes;
    }
}

/** Is it a decimal number and nothing else? */
static bool is_number(const char *string)
{
    char *end;
    if (string[strspn(string, "0123456789+-.eE")] != '\0' || !strpbrk(string, "0123456789"))
        return false;
    (void)strtod(string, &end);
    return *end == '\0';
}

/** Would a spreadsheet calculate a cell of this text? It begins, perhaps behind blanks or apostrophes, with = + - @ or
 * their full-width forms, and is no number. */
static bool is_formula(const char *string)
{
    static const char *const marks[] = {"=", "+", "-", "@", "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"};
    const char *start = string + strspn(string, " '");
    for (size_t i = 0; i < sizeof marks / sizeof *marks; i++)
        if (strncmp(start, marks[i], strlen(marks[i])) == 0)
            return !is_number(string);
    return false;
}

void text_add_csv(struct text *text, const char *string)
{
    OWNED(text_free) struct text shown = {0};
    text_add_shown(&shown, string);
    const char *all = text_string(&shown), *before = is_formula(all) ? "'" : "";
    text->failed = text->failed || shown.failed;
    if (!strpbrk(all, ",;\"")) {
        text_add_bytes(text, before, strlen(before));
        text_add_bytes(text, all, strlen(all));
    } else {
        text_add(text, "\"%s", before);
        for (; *all; all++) { /* where semicolons delimit, no quote within a line holds a cell together */
            text_add_bytes(text, all, 1);
            text_add(text, "%s", *all == '"' ? "\"" : *all == ';' && is_formula(all + 1) ? "'" : "");
        }
        text_add_bytes(text, "\"", 1);
    }
}

int text_width(const char *string, size_t length)
{
    int count = 0;
    for (size_t i = 0; i < length; i++)
        count += ((unsigned char)string[i] & 0xC0) != 0x80;
    return count;
}

int text_characters(const char *string)
{
    return text_width(string, strlen(string));
}

void text_add_wrapped(struct text *text, const char *string, int width, int indent)
{
    size_t line = text->length; /* no memrchr(): sanitizers look at the whole text each time */
    while (line > 0 && text->data[line - 1] != '\n')
        line--;
    int at = text_characters(text_string(text) + line);
    bool begun = false; /* a word stands on this line */
    while (*string) {
        size_t length = strcspn(string, " \n");
        int word = text_width(string, length);
        if (begun && at + 1 + word > width) {
            text_add(text, "\n%*s", indent, "");
            at = indent;
            begun = false;
        }
        text_add(text, begun ? " " : "");
        text_add_bytes(text, string, length);
        at += begun + word;
        begun = true;
        string += length;
        if (*string == '\n') {
            text_add(text, "\n");
            at = 0;
            begun = false;
        }
        string += *string != '\0';
    }
}

void text_squeeze(struct text *text)
{
    size_t kept = 0, run = 2;
    for (size_t i = 0; i < text->length; i++) {
        char c = text->data[i];
        if (c == '\n')
            while (kept > 0 && text->data[kept - 1] == ' ')
                kept--;
        run = c == '\n' ? run + 1 : 0;
        if (run <= 2)
            text->data[kept++] = c;
    }
    if (text->data)
        text->data[kept] = '\0';
    text->length = kept;
}

const char *text_string(const struct text *text)
{
    if (text->failed) /* and whoever takes it does not ask */
        status_lost = true;
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
    size_t most = limit_most(LIMIT_FILE_BYTES);
    bool known = fstat(fileno(file), &info) == 0 && S_ISREG(info.st_mode), large = known && (size_t)info.st_size > most;
    if (known && !large)
        text_reserve(text, (size_t)info.st_size + 1); /* one more: to meet the end */
    while (!large) {
        if (!text_reserve(text, text->length + 1 < text->capacity ? 1 : 65536))
            return status_memory(status);
        size_t got = fread(text->data + text->length, 1, text->capacity - text->length - 1, file);
        text->length += got;
        text->data[text->length] = '\0';
        if (got == 0)
            break;
        large = text->length > most;
    }
    if (large)
        return status_fail(status, STATUS_IO, "'%.440s' is too large%s", name, limit_words(LIMIT_FILE_BYTES).text);
    if (ferror(file))
        return status_fail(status, STATUS_IO, "cannot read '%s': %s", name, strerror(errno));
    return STATUS_OK;
}

enum status_code text_read_file(struct text *text, const char *path, struct status *status)
{
    struct stat info = {0};
    const bool found = stat(path, &info) == 0;
    if (found && !S_ISREG(info.st_mode)) /* a pipe would keep it waiting */
        return status_fail(status, STATUS_IO, "'%.440s' is %s", path,
                           S_ISDIR(info.st_mode) ? "a directory, no file" : "no regular file");
    FILE *file = found ? fopen(path, "rbe") : NULL;
    if (!file)
        return status_fail(status, STATUS_IO, "cannot open '%s': %s", path, strerror(errno));
    setvbuf(file, NULL, _IONBF, 0); /* into `text` at once */
    enum status_code code = text_read_stream(text, file, path, status);
    fclose(file);
    return code;
}

enum status_code text_write_file(const char *path, const char *bytes, size_t length, struct status *status)
{
    FILE *file = fopen(path, "wbe");
    if (!file)
        return status_fail(status, STATUS_IO, "cannot write '%s': %s", path, status_reason(errno));
    size_t written = fwrite(bytes, 1, length, file);
    int reason = errno;
    if (fclose(file) != 0 || written != length)
        return status_fail(status, STATUS_IO, "cannot write '%s': %s", path,
                           strerror(written != length ? reason : errno));
    return STATUS_OK;
}

enum status_code text_save(const struct text *text, struct status *status, const char *format, ...)
{
    char *path;
    va_list args;
    va_start(args, format);
    int length = vasprintf(&path, format, args);
    va_end(args);
    if (length < 0)
        return status_memory(status);
    enum status_code code =
        text->failed ? status_memory(status) : text_write_file(path, text_string(text), text->length, status);
    free(path);
    return code;
}
