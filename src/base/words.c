/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/words.h"

#include "base/mustache.h"
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum status_code words_read(struct words *out, const char *templates, struct status *status)
{
    struct text path = {0};
    *out = (struct words){.said = json_array(), .status = status};
    text_add(&path, "%s/words.txt", templates);
    enum status_code rc = path.failed ? status_memory(status) : text_read_file(&out->file, text_string(&path), status);
    text_free(&path);
    return rc;
}

void words_free(struct words *words)
{
    text_free(&words->file);
    json_decref(words->said);
    *words = (struct words){0};
}

/** Adds the template of a name: the rest of its line. */
static bool find(struct text *out, const struct words *words, const char *name)
{
    size_t length = strlen(name);
    for (const char *line = text_string(&words->file); *line; line += strcspn(line, "\n"), line += *line == '\n')
        if (strncmp(line, name, length) == 0 && (line[length] == ' ' || line[length] == '\t')) {
            const char *start = line + length + strspn(line + length, " \t");
            text_add_bytes(out, start, strcspn(start, "\r\n"));
            return true;
        }
    return false;
}

const char *words_say(struct words *words, const char *name, ...)
{
    struct text source = {0}, filled = {0};
    if (!words)
        return name;
    json_t *view = json_object();
    const struct mustache how = {.view = view};
    va_list pairs;
    va_start(pairs, name);
    for (const char *key; (key = va_arg(pairs, const char *));)
        json_object_set_new(view, key, json_string_nocheck(va_arg(pairs, const char *)));
    va_end(pairs);
    if (!find(&source, words, name))
        (void)status_fail(words->status, STATUS_USAGE, "words.txt of the templates has no '%s'", name);
    else if (mustache_render(&filled, text_string(&source), "words.txt", &how, words->status) == STATUS_OK &&
             (filled.failed || json_array_append_new(words->said, json_string_nocheck(text_string(&filled))) != 0))
        (void)status_memory(words->status);
    json_decref(view);
    text_free(&source);
    text_free(&filled);
    const json_t *said = json_array_get(words->said, json_array_size(words->said) - 1);
    return words->status->code == STATUS_OK ? json_string_value(said) : "";
}

struct words_number words_number(const char *format, ...)
{
    struct words_number out;
    va_list number;
    va_start(number, format);
    vsnprintf(out.text, sizeof out.text, format, number);
    va_end(number);
    return out;
}

int words_width(const char *string, size_t length)
{
    int count = 0;
    for (size_t i = 0; i < length; i++)
        count += ((unsigned char)string[i] & 0xC0) != 0x80;
    return count;
}

void words_cut(struct text *out, const char *string, size_t length, int most)
{
    int width = words_width(string, length), at = -1;
    for (size_t i = 0; i < length; i++) {
        bool begins = ((unsigned char)string[i] & 0xC0) != 0x80;
        at += begins;
        if (begins && width > most && at == most / 2)
            text_add(out, "…");
        if (width <= most || at < most / 2 || at > most / 2 + width - most)
            text_add_bytes(out, string + i, 1);
    }
}
