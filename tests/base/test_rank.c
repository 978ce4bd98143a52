/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The order of numbers by what an order is. */
#include "base/rank.h"
#include "support.h"

enum { MANY = 20000 };
static double values[MANY];

/* Each index once, in the order of its value, equal ones by index. */
static void expect_order(const uint64_t *order, size_t count)
{
    static bool seen[MANY];
    memset(seen, 0, sizeof seen);
    for (size_t k = 0; k < count; k++) {
        assert_true(order[k] < count && !seen[order[k]]);
        seen[order[k]] = true;
        if (k > 0) {
            double before = values[order[k - 1]], value = values[order[k]];
            assert_true(before < value || (before == value && order[k - 1] < order[k]));
        }
    }
}

static void check(size_t count)
{
    static uint64_t rising[MANY];
    rank_ascending(rising, values, count);
    expect_order(rising, count);
}

/** Both signs, all magnitudes, many equal ones, zeros of both signs; few and none. */
TEST_CASE(all_are_in_order)
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
