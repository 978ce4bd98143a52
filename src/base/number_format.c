/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number_format.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char minus[] = "−";

void number_power_of_ten(struct text *out, int exponent)
{
    static const char *const superscripts[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    char digits[16];
    snprintf(digits, sizeof digits, "%d", abs(exponent));
    text_add(out, "10%s", exponent < 0 ? "⁻" : "");
    for (const char *digit = digits; *digit; digit++)
        text_add(out, "%s", superscripts[*digit - '0']);
}

/** Is plain notation easy to read, without showing more digits than asked for? */
static bool reads_plain(int exponent, int digits)
{
    return exponent >= -3 && exponent <= (digits < 5 && digits > 2 ? 3 : 4);
}

/** The decimal exponent of `value` as it will be rounded. */
static int exponent_of(double value, int digits)
{
    char buffer[64];
    snprintf(buffer, sizeof buffer, "%.*e", digits - 1, value);
    return (int)strtol(strchr(buffer, 'e') + 1, NULL, 10);
}

void number_format(struct text *out, double value, int digits)
{
    if (!isfinite(value) || value == 0) {
        text_add(out, value == 0 ? "0" : "–");
        return;
    }
    char buffer[64];
    int exponent = exponent_of(value, digits);
    bool plain = reads_plain(exponent, digits);
    if (plain && digits <= 2 && exponent >= digits) { /* an end of a wide interval: 4900 to 11000, not 4923 */
        const double step = pow(10, exponent - digits + 1);
        value = round(value / step) * step;
    }
    snprintf(buffer, sizeof buffer, plain ? "%.*f" : "%.*e", plain ? (int)fmax(0, digits - 1 - exponent) : digits - 1,
             fabs(value));
    text_add(out, "%s%.*s%s", value < 0 ? minus : "", (int)strcspn(buffer, "e"), buffer, plain ? "" : "·");
    if (!plain)
        number_power_of_ten(out, exponent);
}

void number_format_uncertain(struct text *out, double value, double error)
{
    if (!isfinite(value) || value == 0 || !isfinite(error) || !(error > 0)) {
        number_format(out, value, 3);
        return;
    }
    int exponent = exponent_of(value, 2), power = reads_plain(exponent, 5) ? 0 : exponent;
    int decimals = (int)fmax(0, fmax(1 - exponent_of(error, 2), 1 - exponent) + power);
    double scale = pow(10, power);
    text_add(out, "%s%s%.*f ± %.*f", power ? "(" : "", value < 0 ? minus : "", decimals, fabs(value) / scale, decimals,
             error / scale);
    if (power) {
        text_add(out, ")·");
        number_power_of_ten(out, power);
    }
}

bool number_format_range(struct text *out, double least_value, double most_value, int digits, const char *between)
{
    OWNED(text_free) struct text low = {0}, high = {0};
    const bool first = isfinite(least_value), last = isfinite(most_value);
    number_format(&low, first ? least_value : most_value, digits);
    number_format(&high, last ? most_value : least_value, digits);
    const bool differ = strcmp(text_string(&low), text_string(&high)) != 0;
    text_add(out, "%s%s", first == last ? "" : first ? "≥\u00a0" : "≤\u00a0", text_string(&low));
    text_add(out, "%s%s", differ ? between : "", differ ? text_string(&high) : "");
    return differ || first != last;
}

enum { MOST_DIGITS = 17 };

/** The digits of `size` as an integer, `count` of them, and the decimal exponent of the first; 0 where rounding leaves
 * the last one open. Powers of ten up to 27 are exact in 64 bits; four roundings err by 2^-64 each, together by .022 of
 * a 17th digit. */
static uint64_t digits_of(int *exponent, double size, int count)
{
    enum { EXACT = 27, REACH = 40 };
    static const long double ten_to[EXACT + 1] = {1e0L,  1e1L,  1e2L,  1e3L,  1e4L,  1e5L,  1e6L,  1e7L,  1e8L,  1e9L,
                                                  1e10L, 1e11L, 1e12L, 1e13L, 1e14L, 1e15L, 1e16L, 1e17L, 1e18L, 1e19L,
                                                  1e20L, 1e21L, 1e22L, 1e23L, 1e24L, 1e25L, 1e26L, 1e27L};
    int binary;
    (void)frexp(size, &binary);
    *exponent = (int)floor((binary - 1) * (M_LN2 / M_LN10)); /* it, or one less */
    int scale = count - 1 - *exponent;
    if (LDBL_MANT_DIG < 64 || !(size > 0) || !isfinite(size) || scale > REACH || scale < -EXACT)
        return 0;
    long double scaled = scale > EXACT ? size * ten_to[EXACT] * ten_to[scale - EXACT]
                         : scale >= 0  ? size * ten_to[scale]
                                       : size / ten_to[-scale];
    if (scaled >= ten_to[count]) {
        scaled /= 10;
        ++*exponent;
    }
    uint64_t digits = (uint64_t)scaled;
    long double rest = scaled - (long double)digits;
    if (fabsl(rest - 0.5L) < 3e-19L * ten_to[count] || scaled < ten_to[count - 1] || !(scaled < ten_to[count] - 1))
        return 0;
    return digits + (rest > 0.5L);
}

void number_digits(struct text *out, double value, int digits_wanted)
{
    int exponent, count = digits_wanted;
    uint64_t digits = digits_of(&exponent, fabs(value), count);
    char digit[MOST_DIGITS], line[48], *to = line;
    if (digits == 0) {
        text_add(out, "%.*g", digits_wanted, value);
        return;
    }
    uint32_t high = (uint32_t)(digits / 100000000), low = (uint32_t)(digits % 100000000); /* divided faster than all */
    int k = count;
    for (; k > 0 && k > count - 8; low /= 10)
        digit[--k] = (char)('0' + low % 10);
    for (; k > 0; high /= 10)
        digit[--k] = (char)('0' + high % 10);
    while (digit[count - 1] == '0')
        count--;
    bool plain = exponent >= -4 && exponent < digits_wanted;
    int whole = !plain ? 1 : exponent < 0 ? 0 : exponent + 1; /* digits before the point */
    if (value < 0)
        *to++ = '-';
    memcpy(to, digit, (size_t)whole);
    to += whole;
    if (whole == 0)
        *to++ = '0';
    if (count > whole)
        *to++ = '.';
    for (int zeros = plain ? exponent + 1 : 0; zeros < 0; zeros++)
        *to++ = '0';
    for (k = whole; k < count; k++)
        *to++ = digit[k];
    if (!plain) { /* of two digits: digits_of() goes no further */
        *to++ = 'e';
        *to++ = exponent < 0 ? '-' : '+';
        *to++ = (char)('0' + abs(exponent) / 10);
        *to++ = (char)('0' + abs(exponent) % 10);
    }
    text_add_bytes(out, line, (size_t)(to - line));
}
