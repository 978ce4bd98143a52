/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/number.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* 767 significant digits decide the rounding of any double; one more stands for "and something behind". */
enum { NUMBER_DIGITS = 768, NUMBER_EXPONENT = 100000 };

/* A number as written: digits[0..digit_count-1] (up to 19 of them in `mantissa` too) times 10^exponent. */
struct decimal {
    const char *first, *end; /* first significant digit, end of the digits and the decimal sign */
    uint64_t mantissa;       /* the first 19 significant digits */
    size_t digits;           /* significant digits, leading zeros aside */
    long exponent;           /* of the last digit */
};

static const double number_powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                       1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static const char *scan_digits(struct decimal *decimal, const char *at, const char *end)
{
    while (decimal->digits == 0 && at < end && *at == '0')
        at++;
    const char *first = at;
    uint64_t mantissa = decimal->mantissa;
    for (size_t digits = decimal->digits; at < end && is_digit(*at); at++)
        if (++digits <= 19)
            mantissa = mantissa * 10 + (uint64_t)(*at - '0');
    if (decimal->digits == 0)
        decimal->first = first;
    decimal->mantissa = mantissa;
    decimal->digits += (size_t)(at - first);
    return at;
}

static const char *scan_exponent(const char *at, const char *end, long *exponent)
{
    if (at >= end || !strchr("eEdD", *at))
        return at;
    const char *digit = at + 1;
    bool negative = digit < end && *digit == '-';
    if (digit < end && (*digit == '-' || *digit == '+'))
        digit++;
    if (digit >= end || !is_digit(*digit))
        return at;
    long value = 0;
    for (; digit < end && is_digit(*digit); digit++)
        value = value < NUMBER_EXPONENT ? value * 10 + (*digit - '0') : value;
    *exponent += negative ? -value : value;
    return digit;
}

/* Everything the fast ways cannot decide: strtod on "digits e exponent", where no decimal sign depends on the locale.
 */
static double slow_value(const struct decimal *decimal)
{
    char text[NUMBER_DIGITS + 32];
    size_t kept = 0, met = 0;
    bool more = false;
    for (const char *at = decimal->first; at < decimal->end && met < decimal->digits; at++) {
        if (!is_digit(*at))
            continue;
        met++;
        if (kept < NUMBER_DIGITS)
            text[kept++] = *at;
        else
            more = more || *at != '0';
    }
    if (more)
        text[kept - 1] = text[kept - 1] == '0' ? '1' : text[kept - 1];
    snprintf(text + kept, sizeof text - kept, "e%ld", decimal->exponent + (long)(decimal->digits - kept));
    return strtod(text, NULL);
}

/* 16 to 19 digits with 64-bit long doubles (x86): mantissa and 10^|e| are exact, so the quotient is rounded once, to 64
 * bits; rounding that to 53 is right unless it lies exactly half-way between two doubles. */
static bool long_value(const struct decimal *decimal, double *value)
{
#if LDBL_MANT_DIG == 64
    if (decimal->digits > 19 || decimal->exponent < -22 || decimal->exponent > 22)
        return false;
    long double power = (long double)number_powers[labs(decimal->exponent)];
    long double exact = (long double)decimal->mantissa;
    exact = decimal->exponent < 0 ? exact / power : exact * power;
    uint64_t bits;
    memcpy(&bits, &exact, sizeof bits);
    *value = (double)exact;
    return (bits & 0x7ff) != 0x400;
#else
    (void)decimal, (void)value;
    return false;
#endif
}

static double decimal_value(const struct decimal *decimal)
{
    if (decimal->digits == 0)
        return 0.0;
    /* Clinger's fast path: both factors are exact doubles, one rounding. */
    if (decimal->digits <= 15 && decimal->exponent >= -22 && decimal->exponent <= 22) {
        double mantissa = (double)decimal->mantissa;
        return decimal->exponent < 0 ? mantissa / number_powers[-decimal->exponent]
                                     : mantissa * number_powers[decimal->exponent];
    }
    double value;
    if (long_value(decimal, &value))
        return value;
    return slow_value(decimal);
}

const char *number_scan(struct string_view text, unsigned allowed, unsigned *met, double *value)
{
    const char *at = text.start, *end = text.end;
    bool negative = at < end && *at == '-';
    if (at < end && (*at == '-' || *at == '+'))
        at++;
    struct decimal decimal = {0};
    const char *whole = at;
    at = scan_digits(&decimal, at, end);
    bool has_digits = at > whole;
    if (at < end && ((*at == '.' && (allowed & NUMBER_POINT)) || (*at == ',' && (allowed & NUMBER_COMMA)))) {
        unsigned sign = *at == '.' ? NUMBER_POINT : NUMBER_COMMA;
        const char *fraction = at + 1;
        const char *stop = scan_digits(&decimal, fraction, end);
        if (sign == NUMBER_COMMA && (!has_digits || stop == fraction))
            return NULL;
        has_digits = has_digits || stop > fraction;
        decimal.exponent = -(long)(stop - fraction);
        if (met)
            *met |= sign;
        at = stop;
    }
    if (!has_digits)
        return NULL;
    decimal.end = at;
    at = scan_exponent(at, end, &decimal.exponent);
    double magnitude = decimal_value(&decimal);
    *value = negative ? -magnitude : magnitude;
    return at;
}

bool number_read(struct string_view text, double *value)
{
    text = string_view_trim(text);
    return number_scan(text, NUMBER_POINT, NULL, value) == text.end && isfinite(*value);
}

bool number_read_size(struct string_view text, size_t *value)
{
    text = string_view_trim(text);
    size_t result = 0;
    for (const char *at = text.start; at < text.end; at++) {
        if (!is_digit(*at) || result > (SIZE_MAX - 9) / 10)
            return false;
        result = result * 10 + (size_t)(*at - '0');
    }
    *value = result;
    return text.start < text.end;
}
