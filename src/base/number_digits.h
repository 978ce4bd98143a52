/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The 17 significant digits that tell every double from every other one, faster than printf and with its bytes. */
#ifndef BASE_NUMBER_DIGITS_H
#define BASE_NUMBER_DIGITS_H

#include <stddef.h>

enum { NUMBER_DIGITS_SIZE = 32 }; /* holds the longest, -2.2250738585072014e-308, and its NUL */

/** Writes `value`, which is finite, as printf's %.17g does: 17 significant digits, rounded to the nearest and to even
 * from half way, zeros at the end left out, an exponent below -4 and from 17 on. Returns the length; any thread. */
size_t number_digits(char out[NUMBER_DIGITS_SIZE], double value);

#endif
