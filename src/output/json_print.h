/* SPDX-License-Identifier: GPL-3.0-or-later */
/* JSON as text, as jansson indents it, its real numbers by number_digits_json(): a report has millions of them. */
#ifndef OUTPUT_JSON_PRINT_H
#define OUTPUT_JSON_PRINT_H

#include "base/text.h"
#include <jansson.h>

/** Adds `json` as json_dumps() with JSON_INDENT(1) | JSON_REAL_PRECISION(17) | JSON_ENCODE_ANY prints it; out of memory
 * is text->failed. */
void json_print(struct text *text, const json_t *json);

#endif
