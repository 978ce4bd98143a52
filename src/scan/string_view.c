/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/string_view.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

struct string_view string_view_trim(struct string_view view)
{
    while (view.start < view.end && string_view_is_blank_char(*view.start))
        view.start++;
    while (view.start < view.end && string_view_is_blank_char(view.end[-1]))
        view.end--;
    return view;
}

bool string_view_starts(struct string_view view, const char *prefix)
{
    size_t length = strlen(prefix);
    return string_view_length(view) >= length && strncasecmp(view.start, prefix, length) == 0;
}

bool string_view_equals(struct string_view view, const char *word)
{
    return string_view_length(view) == strlen(word) && string_view_starts(view, word);
}

bool string_view_is_one_of(struct string_view view, const char *words)
{
    size_t length = string_view_length(view);
    for (const char *end; *words; words = end + (*end == ' ')) {
        end = strchrnul(words, ' ');
        if (length > 0 && (size_t)(end - words) == length && strncasecmp(view.start, words, length) == 0)
            return true;
    }
    return false;
}

struct lines lines_begin(struct string_view text)
{
    bool has_lf = string_view_length(text) > 0 && memchr(text.start, '\n', string_view_length(text));
    return (struct lines){.next = text.start, .end = text.end, .stop = has_lf ? '\n' : '\r'};
}

bool lines_next(struct lines *lines, struct string_view *line)
{
    if (lines->next >= lines->end)
        return false;
    const char *stop = memchr(lines->next, lines->stop, (size_t)(lines->end - lines->next));
    *line = (struct string_view){lines->next, stop ? stop : lines->end};
    lines->next = stop ? stop + 1 : lines->end;
    lines->number++;
    while (line->end > line->start && line->end[-1] == '\r')
        line->end--;
    return true;
}

bool cell_next(struct string_view *rest, char delimiter, struct string_view *cell)
{
    if (delimiter == ' ')
        *rest = string_view_trim(*rest);
    if (rest->start >= rest->end)
        return false;
    const char *stop = rest->start;
    if (delimiter != ' ') {
        const char *open = rest->start + strspn(rest->start, " "), *close = NULL;
        if (open < rest->end && *open == '"') /* what stands in quotes is one cell, delimiters and all */
            close = memchr(open + 1, '"', (size_t)(rest->end - open - 1));
        stop = memchr(close ? close : rest->start, delimiter, (size_t)(rest->end - (close ? close : rest->start)));
        *cell = string_view_trim((struct string_view){rest->start, stop ? stop : rest->end});
        if (close && string_view_length(*cell) > 1 && cell->end - 1 == close)
            *cell = string_view_trim((struct string_view){open + 1, close});
        rest->start = stop ? stop + 1 : rest->end;
        return true;
    }
    for (; stop < rest->end; stop++) {
        if (!string_view_is_blank_char(*stop))
            continue;
        const char *next = stop;
        while (string_view_is_blank_char(*next)) /* `rest` is trimmed: a word follows */
            next++;
        if (*next != '[' && *next != '(')
            break;
        stop = next;
    }
    *cell = (struct string_view){rest->start, stop};
    rest->start = stop;
    return true;
}

/* A longer number is refused: no instrument writes it. 767 digits decide the rounding of any double. */
enum { NUMBER_DIGITS = 2000, NUMBER_EXPONENT = 100000 };

static const double number_powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                       1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
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

/* The digits between `at` and `end` times 10^exponent, to the nearest double. */
static double long_number(const char *at, const char *end, long exponent)
{
    char digits[NUMBER_DIGITS + 32]; /* without a decimal sign, which would depend on the locale */
    size_t count = 0;
    for (; at < end; at++)
        if (is_digit(*at) && (count > 0 || *at != '0'))
            digits[count++] = *at;
    snprintf(digits + count, sizeof digits - count, "e%ld", exponent);
    return strtod(digits, NULL);
}

const char *number_scan(struct string_view text, unsigned allowed, unsigned *met, double *value)
{
    const char *at = text.start, *end = text.end, *sign = NULL; /* the decimal sign */
    bool negative = at < end && *at == '-';
    if (at < end && (*at == '-' || *at == '+'))
        at++;
    const char *first = at;
    size_t count = 0;      /* digits behind leading zeros */
    uint64_t mantissa = 0; /* of up to 15 of them */
    for (; at < end; at++) {
        if (is_digit(*at)) {
            count += count > 0 || *at != '0' ? 1 : 0;
            mantissa = mantissa * 10 + (uint64_t)(*at - '0');
        } else if (!sign && ((*at == '.' && (allowed & NUMBER_POINT)) || (*at == ',' && (allowed & NUMBER_COMMA)))) {
            sign = at;
        } else {
            break;
        }
    }
    size_t behind = sign ? (size_t)(at - sign) - 1 : 0, before = (size_t)(at - first) - behind - (sign ? 1 : 0);
    if (before + behind == 0 || count > NUMBER_DIGITS || (sign && *sign == ',' && (before == 0 || behind == 0)))
        return NULL;
    if (sign && met)
        *met |= *sign == '.' ? NUMBER_POINT : NUMBER_COMMA;
    long exponent = -(long)behind;
    const char *digits_end = at;
    at = scan_exponent(at, end, &exponent);
    double magnitude = (double)mantissa;                  /* without the fast way reading text takes twice as long */
    if (count > 0 && count <= 15 && labs(exponent) <= 22) /* exact both: one rounding (Clinger 1990) */
        magnitude = exponent < 0 ? magnitude / number_powers[-exponent] : magnitude * number_powers[exponent];
    else if (count > 0)
        magnitude = long_number(first, digits_end, exponent);
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
