/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/number.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A longer number is refused: no instrument writes it. 767 digits decide the rounding of any double. */
enum { NUMBER_DIGITS = 2000, NUMBER_EXPONENT = 100000 };

static const double number_powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                       1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/* A number as written: digits times 10^exponent. */
struct decimal {
    char digits[NUMBER_DIGITS + 32]; /* without leading zeros */
    size_t count;
    uint64_t mantissa; /* the digits as a number, up to 15 of them */
    long exponent;     /* of the last digit */
};

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* Adds the digits from `at` on; returns their end. */
static const char *scan_digits(struct decimal *decimal, const char *at, const char *end)
{
    for (; at < end && is_digit(*at); at++) {
        if (decimal->count == 0 && *at == '0')
            continue;
        if (decimal->count < NUMBER_DIGITS)
            decimal->digits[decimal->count] = *at;
        decimal->count++;
        decimal->mantissa = decimal->mantissa * 10 + (uint64_t)(*at - '0');
    }
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

/* The nearest double; without the fast way reading text takes twice as long. */
static double decimal_value(struct decimal *decimal)
{
    if (decimal->count == 0)
        return 0;
    if (labs(decimal->exponent) <= 22 && decimal->count <= 15) { /* exact both: one rounding (Clinger 1990) */
        double mantissa = (double)decimal->mantissa, power = number_powers[labs(decimal->exponent)];
        return decimal->exponent < 0 ? mantissa / power : mantissa * power;
    }
    /* written without a decimal sign, which would depend on the locale */
    snprintf(decimal->digits + decimal->count, sizeof decimal->digits - decimal->count, "e%ld", decimal->exponent);
    return strtod(decimal->digits, NULL);
}

const char *number_scan(struct string_view text, unsigned allowed, unsigned *met, double *value)
{
    const char *at = text.start, *end = text.end;
    bool negative = at < end && *at == '-';
    if (at < end && (*at == '-' || *at == '+'))
        at++;
    struct decimal decimal; /* its digits are left as they are */
    decimal.count = decimal.mantissa = 0;
    decimal.exponent = 0;
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
    if (!has_digits || decimal.count > NUMBER_DIGITS)
        return NULL;
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
