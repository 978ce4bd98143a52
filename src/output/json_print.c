/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/json_print.h"

#include "base/number_digits.h"
#include <stdlib.h>
#include <string.h>

static void put(struct text *text, const char *string)
{
    text_add_bytes(text, string, strlen(string));
}

static void put_line(struct text *text, int depth)
{
    static const char spaces[] = "                ";
    text_add_bytes(text, "\n", 1);
    for (; depth >= (int)sizeof spaces; depth -= (int)sizeof spaces - 1)
        put(text, spaces);
    text_add_bytes(text, spaces, (size_t)depth);
}

/** What is escaped, and numbers but reals, jansson knows. */
static void put_by_jansson(struct text *text, const json_t *json)
{
    char *printed = json ? json_dumps(json, JSON_ENCODE_ANY) : NULL;
    if (printed)
        put(text, printed);
    else
        text->failed = true;
    free(printed);
}

/** A string of UTF-8, as every one of jansson's is. */
static void put_string(struct text *text, const char *string, size_t length)
{
    bool plain = true;
    for (size_t i = 0; i < length; i++)
        plain = plain && (unsigned char)string[i] >= ' ' && string[i] != '"' && string[i] != '\\';
    if (!plain) {
        json_t *json = json_stringn(string, length);
        put_by_jansson(text, json);
        json_decref(json);
        return;
    }
    text_add_bytes(text, "\"", 1);
    text_add_bytes(text, string, length);
    text_add_bytes(text, "\"", 1);
}

static void print(struct text *text, const json_t *json, int depth);

static void print_array(struct text *text, const json_t *array, int depth)
{
    size_t count = json_array_size(array);
    text_add_bytes(text, "[", 1);
    for (size_t i = 0; i < count; i++) {
        if (i > 0)
            text_add_bytes(text, ",", 1);
        put_line(text, depth + 1);
        print(text, json_array_get(array, i), depth + 1);
    }
    if (count > 0)
        put_line(text, depth);
    text_add_bytes(text, "]", 1);
}

static void print_object(struct text *text, const json_t *object, int depth)
{
    bool first = true;
    json_t *members = (json_t *)object; /* jansson's iterators take no const, and change nothing */
    text_add_bytes(text, "{", 1);
    for (void *member = json_object_iter(members); member; member = json_object_iter_next(members, member)) {
        const char *key = json_object_iter_key(member);
        if (!first)
            text_add_bytes(text, ",", 1);
        first = false;
        put_line(text, depth + 1);
        put_string(text, key, strlen(key));
        text_add_bytes(text, ": ", 2);
        print(text, json_object_iter_value(member), depth + 1);
    }
    if (!first)
        put_line(text, depth);
    text_add_bytes(text, "}", 1);
}

static void print(struct text *text, const json_t *json, int depth)
{
    char number[NUMBER_DIGITS_SIZE];
    if (json_is_object(json))
        print_object(text, json, depth);
    else if (json_is_array(json))
        print_array(text, json, depth);
    else if (json_is_string(json))
        put_string(text, json_string_value(json), json_string_length(json));
    else if (json_is_real(json))
        text_add_bytes(text, number, number_digits_json(number, json_real_value(json)));
    else
        put_by_jansson(text, json);
}

void json_print(struct text *text, const json_t *json)
{
    print(text, json, 0);
}
