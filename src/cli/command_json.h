/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the commands print as JSON (docs/commands.md). */
#ifndef CLI_COMMAND_JSON_H
#define CLI_COMMAND_JSON_H

#include <jansson.h>
#include <stdbool.h>

/** `hostile` as it may be shown: JSON is UTF-8, a file name need not be. */
json_t *command_json_text(const char *hostile);
/** A text that there may not be; NULL: null. */
json_t *command_json_optional(const char *text);
/** A number; null for NaN, and for what is without end. */
json_t *command_json_number(double value);
/** The lines of a text. */
json_t *command_json_lines(const char *lines);
/** Prints it to stdout, numbers with 17 digits; takes it over. False: out of memory. */
bool command_json_print(json_t *json);

#endif
