/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number_digits.h"

#include <assert.h>
#include <math.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

__extension__ typedef unsigned __int128 uint128;

enum {
    DIGITS = 17,
    POWER_LEAST = -293, /* 10^-293 makes 17 digits before the point of the largest double, */
    POWER_MOST = 341,   /* 10^341 of the smallest, with one to spare at either end */
    EXACT_MOST = 55,    /* 5^55 is the last that 128 bits hold */
    LIMBS = 32,         /* of 32 bits: 5^341 takes 25, 2^900 29 */
    FRACTION_BITS = 900 /* of 5^-293, 681 of them zeros before its first digit */
};

/** 10^k = (high 2^64 + low + d) 2^exponent with 0 <= d < 1, d = 0 for 0 <= k <= EXACT_MOST; high >= 2^63. */
struct power {
    uint64_t high, low;
    int exponent;
};

static struct power powers[POWER_MOST - POWER_LEAST + 1];
static pthread_once_t powers_made = PTHREAD_ONCE_INIT;

/** The first 128 bits of an integer, the limb of the lowest value first; returns how many bits follow them. */
static int leading_bits(struct power *power, const uint32_t limb[LIMBS])
{
    int top = LIMBS - 1, lost;
    uint128 bits = 0;
    while (limb[top] == 0)
        top--;
    for (int i = 0; i < 4; i++)
        bits = bits << 32 | (top - i >= 0 ? limb[top - i] : 0);
    lost = 32 * (top - 3);
    for (uint32_t next = top >= 4 ? limb[top - 4] : 0; !(bits >> 127); next <<= 1, lost--)
        bits = bits << 1 | next >> 31;
    power->high = (uint64_t)(bits >> 64);
    power->low = (uint64_t)bits;
    return lost;
}

/** 5^k by multiplication, and 2^FRACTION_BITS/5^k by division, each of whose quotients is the whole part of the true
 * one. */
static void make_powers(void)
{
    uint32_t whole[LIMBS] = {1}, fraction[LIMBS] = {0};
    fraction[FRACTION_BITS / 32] = UINT32_C(1) << FRACTION_BITS % 32;
    for (int k = 0; k <= POWER_MOST; k++) {
        struct power *power = &powers[k - POWER_LEAST];
        uint64_t carry = 0;
        power->exponent = leading_bits(power, whole) + k;
        for (int i = 0; i < LIMBS; i++) {
            carry += UINT64_C(5) * whole[i];
            whole[i] = (uint32_t)carry;
            carry >>= 32;
        }
    }
    for (int k = -1; k >= POWER_LEAST; k--) {
        struct power *power = &powers[k - POWER_LEAST];
        uint64_t rest = 0;
        for (int i = LIMBS - 1; i >= 0; i--) {
            rest = rest << 32 | fraction[i];
            fraction[i] = (uint32_t)(rest / 5);
            rest %= 5;
        }
        power->exponent = leading_bits(power, fraction) - FRACTION_BITS + k;
    }
}

/** mantissa 2^exponent 10^k, mantissa >= 2^63, rounded to an integer below 2^61. False where what the power leaves out
 * could make it another one. */
static bool scale(uint64_t *out, uint64_t mantissa, int exponent, int k)
{
    const struct power *power = &powers[k - POWER_LEAST];
    bool exact = k >= 0 && k <= EXACT_MOST;
    uint128 low = (uint128)mantissa * power->low, high = (uint128)mantissa * power->high + (low >> 64);
    /* (high 2^64 + rest) 2^(exponent + power->exponent), true up to one more of high's last place */
    uint64_t rest = (uint64_t)low;
    int shift = -(exponent + power->exponent) - 64; /* of high, past the point */
    assert(shift > 64 && shift < 128);
    uint128 half = (uint128)1 << (shift - 1), fraction = high & (2 * half - 1);
    *out = (uint64_t)(high >> shift);
    if (!exact && (fraction == half - 1 || (fraction == half && rest == 0)))
        return false;
    if (fraction > half || (fraction == half && (rest > 0 || (*out & 1))))
        ++*out;
    return true;
}

/** The digits of |value| > 0 as an integer of DIGITS digits, and the decimal exponent of the first. */
static bool decimal(uint64_t *digits, int *exponent, double value)
{
    static const uint64_t least = UINT64_C(10000000000000000), most = UINT64_C(100000000000000000);
    uint64_t mantissa;
    memcpy(&mantissa, &value, sizeof mantissa);
    int biased = (int)(mantissa >> 52 & 0x7ff);
    mantissa &= (UINT64_C(1) << 52) - 1;
    if (biased > 0)
        mantissa |= UINT64_C(1) << 52;
    int zeros = __builtin_clzll(mantissa), binary = (biased > 0 ? biased : 1) - 1075 - zeros;
    mantissa <<= zeros;
    *exponent =
        (int)((binary + 63) * INT64_C(1292913986) >> 32); /* floor(log10(2) (binary + 63)): right, or 1 too small */
    if (!scale(digits, mantissa, binary, DIGITS - 1 - *exponent))
        return false;
    if (*digits >= most) {
        ++*exponent;
        if (!scale(digits, mantissa, binary, DIGITS - 1 - *exponent))
            return false;
    }
    if (*digits < least) { /* it was rounded up to a power of ten */
        assert(*digits == least / 10);
        *digits = least;
    }
    return true;
}

/** Eight digits, two at a time, whose quotients do not wait for one another. */
static void put_eight(char *out, uint32_t eight)
{
    static const char pairs[] = "0001020304050607080910111213141516171819"
                                "2021222324252627282930313233343536373839"
                                "4041424344454647484950515253545556575859"
                                "6061626364656667686970717273747576777879"
                                "8081828384858687888990919293949596979899";
    uint32_t high = eight / 10000, low = eight % 10000;
    memcpy(out, pairs + 2 * (high / 100), 2);
    memcpy(out + 2, pairs + 2 * (high % 100), 2);
    memcpy(out + 4, pairs + 2 * (low / 100), 2);
    memcpy(out + 6, pairs + 2 * (low % 100), 2);
}

static char *put_exponent(char *out, int exponent)
{
    int size = exponent < 0 ? -exponent : exponent;
    *out++ = 'e';
    *out++ = exponent < 0 ? '-' : '+';
    if (size >= 100)
        *out++ = (char)('0' + size / 100);
    *out++ = (char)('0' + size / 10 % 10);
    *out++ = (char)('0' + size % 10);
    return out;
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
    text[0] = (char)('0' + digits / UINT64_C(10000000000000000));
    put_eight(text + 1, (uint32_t)(digits / 100000000 % 100000000));
    put_eight(text + 9, (uint32_t)(digits % 100000000));
    while (count > 1 && text[count - 1] == '0')
        count--;
    if (signbit(value))
        *end++ = '-';
    if (exponent < -4 || exponent >= DIGITS) {
        *end++ = text[0];
        if (count > 1)
            *end++ = '.';
        memcpy(end, text + 1, DIGITS - 1); /* all: that many at once is quicker */
        end = put_exponent(end + count - 1, exponent);
    } else if (exponent < 0) {
        memcpy(end, "0.0000", 6);
        end += 1 - exponent;
        memcpy(end, text, DIGITS);
        end += count;
    } else {
        int whole = exponent + 1;
        memcpy(end, text, (size_t)whole);
        end += whole;
        if (count > whole) {
            *end++ = '.';
            memcpy(end, text + whole, (size_t)(count - whole));
            end += count - whole;
        }
    }
    *end = '\0';
    return (size_t)(end - out);
}

size_t number_digits_json(char out[NUMBER_DIGITS_SIZE], double value)
{
    size_t length = number_digits(out, value);
    char *e = memchr(out, 'e', length);
    if (e) {
        char *to = e + 1, *from = to + 1;
        if (*to == '-')
            to++;
        while (*from == '0')
            from++;
        memmove(to, from, length - (size_t)(from - out) + 1);
        return length - (size_t)(from - to);
    }
    if (memchr(out, '.', length))
        return length;
    memcpy(out + length, ".0", 3);
    return length + 2;
}
