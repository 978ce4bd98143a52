/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Decimal numbers from bytes: correctly rounded, independent of the locale, fast. */
#ifndef SCAN_NUMBER_H
#define SCAN_NUMBER_H

#include "scan/string_view.h"

enum { NUMBER_POINT = 1, NUMBER_COMMA = 2 }; /* decimal signs: which are allowed, which was met */

/** Reads one number (sign, digits, decimal sign, digits, exponent with e, E, d or D) from the start of `text`.
 * `allowed` says which decimal signs count; the one met is added to *met (NULL: not asked). A decimal comma has to have
 * digits on both sides. The nearest double goes to *value, an infinity on overflow.
 * Returns the end of the number, or NULL where there is none (NaN and inf are none). */
const char *number_scan(struct string_view text, unsigned allowed, unsigned *met, double *value);

/** The whole of `text`, blanks around it aside, as a finite number with a decimal point. */
bool number_read(struct string_view text, double *value);

/** The same for an integer >= 0, written without sign, decimal sign or exponent. */
bool number_read_size(struct string_view text, size_t *value);

#endif
