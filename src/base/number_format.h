/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers as a reader wants them: rounded, with powers of ten as 1.2·10⁻⁵. */
#ifndef BASE_NUMBER_FORMAT_H
#define BASE_NUMBER_FORMAT_H

#include "base/text.h"

/** `value` with `digits` significant digits: plain from 0.001 to 99999, else as 1.2·10⁻⁵; "–" when not finite. With
 * one digit 4923 is 5000, with two 4900, with more it is whole. */
void number_format(struct text *out, double value, int digits);
/** "0.00600 ± 0.00094": both with the same exponent and decimals, at least two digits of either. */
void number_format_uncertain(struct text *out, double value, double error);
/** "10⁻⁵". */
void number_power_of_ten(struct text *out, int exponent);
/** "least to most" with " to " between, one number when both are the same to the digits shown, "≥ least" or "≤ most"
 * when the other one is not finite. True: it is more than one number. */
bool number_format_range(struct text *out, double least, double most, int digits, const char *between);

/** `value` as "%.*g" prints it with 1 ... 17 digits, in a third of the time, which is most of the time of large tables
 * and charts. */
void number_digits(struct text *out, double value, int digits);

#endif
