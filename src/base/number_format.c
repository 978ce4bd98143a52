/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number_format.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char minus[] = "−";

static void add_power_of_ten(struct text *out, int exponent)
{
    static const char *const superscripts[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    char digits[16];
    snprintf(digits, sizeof digits, "%d", abs(exponent));
    text_add(out, "·10%s", exponent < 0 ? "⁻" : "");
    for (const char *digit = digits; *digit; digit++)
        text_add(out, "%s", superscripts[*digit - '0']);
}

/** Plain notation reads well for these decimal exponents, where it does not show digits that were not asked for. */
static bool reads_plain(int exponent, int digits)
{
    return exponent >= -3 && exponent <= (digits < 5 ? 3 : 4);
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
    snprintf(buffer, sizeof buffer, plain ? "%.*f" : "%.*e", plain ? (int)fmax(0, digits - 1 - exponent) : digits - 1,
             fabs(value));
    text_add(out, "%s%.*s", value < 0 ? minus : "", (int)strcspn(buffer, "e"), buffer);
    if (!plain)
        add_power_of_ten(out, exponent);
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
        text_add(out, ")");
        add_power_of_ten(out, power);
    }
}

void number_format_range(struct text *out, double least_value, double most_value, int digits)
{
    struct text low = {0}, high = {0};
    number_format(&low, least_value, digits);
    number_format(&high, most_value, digits);
    text_add(out, "%s", text_string(&low));
    if (strcmp(text_string(&low), text_string(&high)) != 0)
        text_add(out, " to %s", text_string(&high));
    text_free(&low);
    text_free(&high);
}
