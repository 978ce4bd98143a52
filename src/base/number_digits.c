/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number_digits.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    DIGITS = 17,
    POWER_LEAST = -292, /* 10^-292 makes 17 digits before the point of the largest double, */
    POWER_MOST = 340    /* 10^340 of the smallest */
};
static const long double most = 1e17L; /* beyond DIGITS digits */

static long double powers[POWER_MOST - POWER_LEAST + 1]; /* of ten, to the nearest */
static pthread_once_t powers_made = PTHREAD_ONCE_INIT;

static void make_powers(void)
{
    char text[16];
    for (int k = POWER_LEAST; k <= POWER_MOST; k++) {
        snprintf(text, sizeof text, "1e%d", k);
        powers[k - POWER_LEAST] = strtold(text, NULL);
    }
}

/** The digits of a value > 0 as an integer of DIGITS digits, and the decimal exponent of the first. False where a long
 * double of 64 bits could be rounded the wrong way: power and product are off by 2^-64 each, and most < 2^56.5. */
static bool decimal(uint64_t *digits, int *exponent, double value)
{
    static const double unsure = 0x1p-6;
    int binary;
    if (LDBL_MANT_DIG < 64)
        return false;
    (void)frexp(value, &binary);
    *exponent = (int)floor((binary - 1) * 0.30102999566398120); /* log10(2): right, or 1 too small */
    long double scaled = value * powers[DIGITS - 1 - *exponent - POWER_LEAST];
    if (scaled >= most)
        scaled = value * powers[DIGITS - 1 - ++*exponent - POWER_LEAST];
    *digits = (uint64_t)scaled;
    double rest = (double)(scaled - (long double)*digits);
    *digits += rest > 0.5;
    return fabs(rest - 0.5) > unsure && (long double)*digits < most;
}

size_t number_digits(char out[NUMBER_DIGITS_SIZE], double value)
{
    uint64_t digits;
    int exponent, count = DIGITS;
    char text[DIGITS], *end = out;
    assert(isfinite(value));
    pthread_once(&powers_made, make_powers);
    if (value == 0 || !decimal(&digits, &exponent, fabs(value)))
        return (size_t)snprintf(out, NUMBER_DIGITS_SIZE, "%.17g", value);
    for (int i = DIGITS - 1; i >= 0; i--, digits /= 10)
        text[i] = (char)('0' + digits % 10);
    while (count > 1 && text[count - 1] == '0')
        count--;
    if (signbit(value))
        *end++ = '-';
    bool plain = exponent >= -4 && exponent < DIGITS;
    int whole = plain ? exponent + 1 : 1; /* digits before the point */
    if (whole <= 0) {
        memcpy(end, "0.000", 5);
        end += 2 - whole;
    }
    for (int i = 0; i < count || i < whole; i++) {
        if (i == whole && i > 0)
            *end++ = '.';
        *end++ = text[i];
    }
    if (!plain) { /* printf would take half of the time */
        int size = abs(exponent);
        *end++ = 'e';
        *end++ = exponent < 0 ? '-' : '+';
        if (size >= 100)
            *end++ = (char)('0' + size / 100);
        *end++ = (char)('0' + size / 10 % 10);
        *end++ = (char)('0' + size % 10);
    }
    *end = '\0';
    return (size_t)(end - out);
}
