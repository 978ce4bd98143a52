/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/words.h"

#include "base/mustache.h"
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum status_code words_read(struct words *out, const char *templates, struct status *status)
{
    OWNED(text_free) struct text path = {0};
    *out = (struct words){.said = json_array(), .status = status};
    text_add(&path, "%s/words.txt", templates);
    return path.failed ? status_memory(status) : text_read_file(&out->file, text_string(&path), status);
}

void words_free(struct words *words)
{
    text_free(&words->file);
    json_decref(words->said);
    *words = (struct words){0};
}

/** Adds the template of a name: the rest of its line. */
static bool find(struct text *out, const struct words *words, const char *name, size_t length)
{
    for (const char *line = text_string(&words->file); *line; line += strcspn(line, "\n"), line += *line == '\n')
        if (strncmp(line, name, length) == 0 && (line[length] == ' ' || line[length] == '\t')) {
            const char *start = line + length + strspn(line + length, " \t");
            text_add_bytes(out, start, strcspn(start, "\r\n"));
            return true;
        }
    return false;
}

bool words_fill(struct text *out, struct words *words, const char *name, const json_t *view,
                void (*escape)(struct text *out, const char *string))
{
    OWNED(text_free) struct text source = {0};
    const struct mustache how = {.view = view, .escape = escape};
    const int length = (int)strcspn(name, "\n");
    bool found = find(&source, words, name, (size_t)length);
    if (!found)
        (void)status_fail(words->status, STATUS_USAGE, "words.txt of the templates has no '%.*s'", length, name);
    found = found && mustache_render(out, text_string(&source), "words.txt", &how, words->status) == STATUS_OK;
    return found;
}

bool words_add(struct text *out, struct words *words, const char *later,
               void (*escape)(struct text *out, const char *string))
{
    json_auto_t *view = json_object();
    for (const char *end = later + strcspn(later, "\n"); *end;) {
        const char *name = end + 1, *text = name + strcspn(name, " \t\n");
        end = *text == '\t' ? strchr(text, '\0') : strchrnul(text, '\n');
        json_t *own = text < end ? json_stringn_nocheck(text + 1, (size_t)(end - text) - 1) : json_true();
        json_t *before = json_object_getn(view, name, (size_t)(text - name));
        if (json_is_array(before))
            json_array_append_new(before, own);
        else
            json_object_setn_new(view, name, (size_t)(text - name), before ? json_pack("[O, o]", before, own) : own);
    }
    return words_fill(out, words, later, view, escape);
}

const char *words_say(struct words *words, const char *format, ...)
{
    OWNED(text_free) struct text filled = {0};
    OWNED(memory_free) char *later = NULL;
    if (!words)
        return "";
    va_list args;
    va_start(args, format);
    later = vasprintf(&later, format, args) < 0 ? NULL : later;
    va_end(args);
    if (!later || (words_add(&filled, words, later, NULL) &&
                   json_array_append_new(words->said, json_string_nocheck(text_string(&filled))) != 0))
        (void)status_memory(words->status);
    const json_t *said = json_array_get(words->said, json_array_size(words->said) - 1);
    return words->status->code == STATUS_OK ? json_string_value(said) : "";
}

void words_cut(struct text *out, const char *string, size_t length, int most)
{
    int width = text_width(string, length), at = -1;
    for (size_t i = 0; i < length; i++) {
        bool begins = ((unsigned char)string[i] & 0xC0) != 0x80;
        at += begins;
        if (begins && width > most && at == most / 2)
            text_add(out, "…");
        if (width <= most || at < most / 2 || at > most / 2 + width - most)
            text_add_bytes(out, string + i, 1);
    }
}
