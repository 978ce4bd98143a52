/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/command_json.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

json_t *command_json_text(const char *hostile)
{
    struct text shown = {0};
    text_add_shown(&shown, hostile);
    json_t *json = json_string(text_string(&shown));
    text_free(&shown);
    return json;
}

json_t *command_json_optional(const char *text)
{
    return text ? command_json_text(text) : json_null();
}

json_t *command_json_number(double value)
{
    return isfinite(value) ? json_real(value) : json_null();
}

json_t *command_json_lines(const char *lines)
{
    json_t *array = json_array();
    while (*lines) {
        size_t length = strcspn(lines, "\n");
        struct text line = {0};
        text_add_bytes(&line, lines, length);
        json_array_append_new(array, command_json_text(text_string(&line)));
        text_free(&line);
        lines += length + (lines[length] == '\n');
    }
    return array;
}

bool command_json_print(json_t *json)
{
    bool printed = json && json_dumpf(json, stdout, JSON_INDENT(1) | JSON_REAL_PRECISION(17)) == 0;
    printf("\n");
    json_decref(json);
    return printed;
}
