/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The digits of every kind of double against printf's, byte by byte. */
#include "base/number_digits.h"
#include "support.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t seed = UINT64_C(88172645463325252);

/** Marsaglia's xorshift. */
static uint64_t random_bits(void)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return seed;
}

static double of_bits(uint64_t bits)
{
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static void check(double value)
{
    char ours[NUMBER_DIGITS_SIZE], theirs[64];
    if (!isfinite(value))
        return;
    size_t length = number_digits(ours, value);
    size_t wanted = (size_t)snprintf(theirs, sizeof theirs, "%.17g", value);
    if (length != wanted || memcmp(ours, theirs, wanted + 1) != 0)
        fail_msg("%s instead of %s", ours, theirs);
}

static void check_around(double value)
{
    check(value);
    check(-value);
    for (int side = 0; side < 2; side++) {
        double next = value;
        for (int i = 0; i < 4; i++)
            check(next = nextafter(next, side ? INFINITY : 0));
    }
}

TEST_CASE(powers_of_two)
{
    for (int e = -1074; e < 1024; e++)
        check_around(ldexp(1, e));
    check_around(DBL_MAX);
    check_around(DBL_MIN);
    check_around(0);
}

TEST_CASE(powers_of_ten_and_their_multiples)
{
    for (int e = -324; e <= 308; e++) {
        char text[16];
        snprintf(text, sizeof text, "1e%d", e);
        double power = strtod(text, NULL);
        check_around(power);
        for (int i = 2; i < 100; i++) {
            check(power * i);
            check(power / i);
        }
    }
}

/* Dyadic numbers of 18 digits and more lie half way between two of 17, or next to it. */
TEST_CASE(half_way)
{
    char text[64];
    int ties = 0;
    for (int bits = 1; bits <= 53; bits++)
        for (int places = 1; places <= 80; places++)
            for (int i = 0; i < 20; i++) {
                double value = ldexp((double)(random_bits() >> (64 - bits) | 1), -places);
                snprintf(text, sizeof text, "%.40e", value);
                ties += text[18] == '5' && strspn(text + 19, "0") == 23; /* d.dddddddddddddddd 5 000...e */
                check_around(value);
            }
    assert_true(ties > 100);
}

TEST_CASE(random_numbers)
{
    for (int i = 0; i < 200000; i++) {
        double any = of_bits(random_bits()), subnormal = of_bits(random_bits() >> (12 + i % 52));
        check(any);
        check(subnormal);
        check((double)(int64_t)random_bits());
        check((double)(random_bits() >> (i % 64)));
        check(ldexp((double)(random_bits() >> 11), -53 - i % 40)); /* 1e-12 ... 1: what a report is full of */
    }
}
