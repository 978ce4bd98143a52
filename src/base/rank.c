/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/rank.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* An item is the index of a value with, above its lowest INDEX_BITS, where the value lies between the least and the
 * most as a whole number: one word to move and to compare. Values it cannot tell apart are compared as they are. */
enum { INDEX_BITS = 31, DIGIT_BITS = 11, DIGITS = 3, VALUES = 1 << DIGIT_BITS, FEW = 24 };
static const uint64_t index_mask = ((uint64_t)1 << INDEX_BITS) - 1;

static unsigned digit(uint64_t item, int place)
{
    return (unsigned)(item >> (INDEX_BITS + DIGIT_BITS * place)) % VALUES;
}

static bool is_before(uint64_t a, uint64_t b, const double *value)
{
    double of_a = value[a & index_mask], of_b = value[b & index_mask];
    if (a >> INDEX_BITS != b >> INDEX_BITS || of_a == of_b)
        return a < b;
    return of_a < of_b;
}

/** Marks each index with the place of its value; false: all values are equal. */
static bool mark(uint64_t *item, size_t count, const double *value)
{
    double least = value[item[0]], most = least;
    for (size_t k = 1; k < count; k++) {
        double v = value[item[k]];
        least = v < least ? v : least;
        most = v > most ? v : most;
    }
    if (!(most > least))
        return false;
    int exponent;
    (void)frexp(fmax(fabs(least), fabs(most)), &exponent);
    double unit = ldexp(1, exponent > -1000 ? -exponent : 1000); /* nothing overflows, nor is lost of what differs */
    double base = least * unit, scale = (ldexp(1, DIGITS * DIGIT_BITS) - 1) / (most * unit - base);
    for (size_t k = 0; k < count; k++)
        item[k] |= (uint64_t)((value[item[k]] * unit - base) * scale) << INDEX_BITS;
    return true;
}

static void sort_few(uint64_t *item, size_t count, const double *value)
{
    for (size_t k = 1; k < count; k++) {
        uint64_t moved = item[k];
        size_t at = k;
        for (; at > 0 && is_before(moved, item[at - 1], value); at--)
            item[at] = item[at - 1];
        item[at] = moved;
    }
}

/** Sorts by the highest digits, the lowest of them first, each pass keeping the order of the last. Two digits, unless
 * values crowd; returns the lowest bit sorted by. */
static int distribute(uint64_t *item, uint64_t *room, size_t count)
{
    uint32_t start[DIGITS][VALUES] = {{0}}, most = 0;
    for (size_t k = 0; k < count; k++) {
        start[1][digit(item[k], 1)]++;
        start[2][digit(item[k], 2)]++;
    }
    for (size_t d = 0; d < VALUES; d++)
        most = start[2][d] > most ? start[2][d] : most;
    int first = most > VALUES ? 0 : 1;
    for (size_t k = 0; k < count && first == 0; k++)
        start[0][digit(item[k], 0)]++;
    uint64_t *from = item, *to = room;
    for (int place = first; place < DIGITS; place++) {
        uint32_t sum = 0;
        for (size_t d = 0; d < VALUES; d++) {
            uint32_t here = start[place][d];
            start[place][d] = sum;
            sum += here;
        }
        for (size_t k = 0; k < count; k++)
            to[start[place][digit(from[k], place)]++] = from[k];
        uint64_t *swap = from;
        from = to;
        to = swap;
    }
    if (from != item)
        memcpy(item, from, count * sizeof *item);
    return INDEX_BITS + DIGIT_BITS * first;
}

/** Indices, ascending, into the order of their values. What two or three digits leave together is ranked anew over its
 * own range, 2^22 times as narrow or more: under a hundred such calls within each other hold all doubles. */
static void sort(uint64_t *item, uint64_t *room, size_t count, const double *value)
{
    if (!mark(item, count, value))
        return;
    int bit = count > FEW ? distribute(item, room, count) : 64;
    if (bit == 64)
        sort_few(item, count, value);
    for (size_t from = 0, end; from < count; from = end) {
        for (end = from + 1; bit < 64 && end < count && item[end] >> bit == item[from] >> bit; end++)
            ;
        if (end - from > 1 && end - from <= FEW)
            sort_few(item + from, end - from, value);
        for (size_t k = from; k < end; k++)
            item[k] &= index_mask;
        if (end - from > FEW)
            sort(item + from, room, end - from, value);
    }
}

void rank_ascending(uint64_t *order, const double *value, size_t count)
{
    assert(count < (uint64_t)1 << INDEX_BITS);
    for (size_t k = 0; k < count; k++)
        order[k] = k;
    if (count > 1)
        sort(order, order + count, count, value);
}

enum status_code rank_descending(size_t *order, const double *value, size_t count, struct status *status)
{
    uint64_t *items = malloc((2 * count + 1) * sizeof *items);
    double *turned = malloc((count + 1) * sizeof *turned);
    if (items && turned) {
        for (size_t k = 0; k < count; k++)
            turned[k] = -value[k];
        rank_ascending(items, turned, count);
        for (size_t k = 0; k < count; k++)
            order[k] = items[k];
    } else {
        (void)status_memory(status);
    }
    free(items);
    free(turned);
    return status->code;
}
