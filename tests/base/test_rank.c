/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The order of numbers against a plain sort. */
#include "base/rank.h"
#include "support.h"

enum { MANY = 20000 };
static double values[MANY];

static int highest_first(const void *left, const void *right)
{
    size_t a = *(const size_t *)left, b = *(const size_t *)right;
    if (values[a] != values[b])
        return values[a] > values[b] ? -1 : 1;
    return (a > b) - (a < b);
}

static int lowest_first(const void *left, const void *right)
{
    size_t a = *(const size_t *)left, b = *(const size_t *)right;
    if (values[a] != values[b])
        return values[a] < values[b] ? -1 : 1;
    return (a > b) - (a < b);
}

static void check(size_t count)
{
    static uint64_t rising[MANY];
    static size_t order[MANY], plain[MANY];
    struct status status = {0};
    for (size_t i = 0; i < count; i++)
        plain[i] = i;
    qsort(plain, count, sizeof *plain, lowest_first);
    rank_ascending(rising, values, count);
    for (size_t i = 0; i < count; i++)
        assert_int_equal(rising[i], plain[i]);
    for (size_t i = 0; i < count; i++)
        plain[i] = i;
    qsort(plain, count, sizeof *plain, highest_first);
    assert_int_equal(rank_descending(order, values, count, &status), STATUS_OK);
    for (size_t i = 0; i < count; i++)
        assert_int_equal(order[i], plain[i]);
}

/** Both signs, all magnitudes, many equal ones, zeros of both signs; few and none. */
TEST_CASE(sorts_as_a_plain_sort)
{
    uint64_t random = 1;
    for (size_t i = 0; i < MANY; i++) {
        random = random * 6364136223846793005u + 1442695040888963407u;
        int exponent = (int)(random >> 40 & 2047) - 1060;
        double magnitude = ldexp((double)(random >> 33 & 7), exponent);
        values[i] = random >> 63 ? -magnitude : magnitude;
    }
    check(MANY);
    for (size_t i = 0; i < MANY; i++)
        values[i] = (double)(i * 7919 % 13) - 6;
    check(MANY);
    values[0] = -0.0;
    values[1] = 0.0;
    values[2] = -1;
    check(3);
    check(1);
    check(0);
}
