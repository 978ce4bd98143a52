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
    static uint64_t rising[2 * MANY];
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
static void sorts_as_a_plain_sort(void **state)
{
    (void)state;
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

static double random_share(void)
{
    static uint64_t random = 7;
    random = random * 6364136223846793005u + 1442695040888963407u;
    return ldexp((double)(random >> 11), -53);
}

/** Values that crowd where few digits of their range tell them apart, over and over; and the ends of what doubles are.
 */
static void crowded_values(void **state)
{
    (void)state;
    for (size_t i = 0; i < MANY; i++) /* seven heaps, each narrower and with the next within it */
        values[i] = 1 + ldexp(random_share() - 0.3, -(int)(i % 7) * 7);
    check(MANY);
    for (size_t i = 0; i < MANY; i++) /* half within 1e-12 of the range, with ties */
        values[i] = i % 2 ? random_share() : 0.5 + floor(1000 * random_share()) * 1e-15;
    check(MANY);
    for (size_t i = 0; i < MANY; i++) /* from neighbours of 0 to the largest of both signs */
        values[i] = i % 3 == 0 ? 5e-324 * floor(40 * random_share()) : (random_share() - 0.5) * 1.7e308 * 2;
    check(MANY);
    for (size_t i = 0; i < MANY; i++)
        values[i] = 5e-324 * floor(4000 * random_share()) - 1e-320;
    check(MANY);
    for (size_t count = 2; count < 60; count++)
        check(count);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sorts_as_a_plain_sort),
        cmocka_unit_test(crowded_values),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
