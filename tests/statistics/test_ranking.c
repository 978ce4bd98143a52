/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "statistics/ranking.h"
#include "support.h"

#include <float.h>

static struct interval scans(const double *value, size_t count)
{
    struct interval out;
    expect_ok(interval_scans, &out, value, NULL, count, 0.95);
    return out;
}

/* Reference: plain double loops, Student's distribution to double precision. */
TEST_CASE(test_welch)
{
    const double a[3] = {-20.7, -20.62, -20.81}, b[4] = {-20.51, -20.33, -20.4, -20.47};
    struct interval first = scans(a, 3), second = scans(b, 4);
    struct ranking out = ranking_welch(&first, &second, 0.95);
    assert_near(out.t, -4.16240849806317, 1e-12);
    assert_near(out.degrees, 3.9108908462001004, 1e-12);
    assert_near(out.p, 0.014793070087792636, 1e-12);
    assert_near(out.ratio, exp(first.mean - second.mean), 1e-15);
    assert_near(log(out.high / out.ratio), interval_quantile(0.95, out.degrees) * hypot(first.s, second.s), 1e-12);
    assert_near(out.low * out.high, out.ratio * out.ratio, 1e-12);

    struct ranking swapped = ranking_welch(&second, &first, 0.95);
    assert_near(swapped.p, out.p, 1e-15);
    assert_near(swapped.t, -out.t, 1e-15);
    assert_near(swapped.ratio, 1 / out.ratio, 1e-15);
    assert_near(swapped.low, 1 / out.high, 1e-12);
}

/* Equal spreads and counts: Student's test. The interval holds a ratio of 1 exactly when p exceeds 1 - level. */
TEST_CASE(test_interval_and_p_agree)
{
    const double a[3] = {1, 2, 3};
    for (double shift = -5; shift <= 5; shift += 0.25) {
        const double b[3] = {1 + shift, 2 + shift, 3 + shift};
        struct interval first = scans(a, 3), second = scans(b, 3);
        struct ranking out = ranking_welch(&first, &second, 0.95);
        assert_near(out.degrees, 4, 1e-12);
        assert_true((out.low <= 1 && out.high >= 1) == (out.p >= 0.05));
    }
}

TEST_CASE(test_welch_without_spread)
{
    const double a[3] = {0.1, 0.1, 0.1}, b[2] = {0.3, 0.3}, c[3] = {0.2, 0.3, 0.7};
    struct interval first = scans(a, 3), second = scans(b, 2), third = scans(c, 3);
    struct ranking out = ranking_welch(&first, &second, 0.95);
    assert_true(out.p == 0 && out.t == -DBL_MAX && out.low == out.ratio && out.high == out.ratio);
    out = ranking_welch(&first, &first, 0.95);
    assert_true(out.p == 1 && out.t == 0 && out.ratio == 1);
    out = ranking_welch(&first, &third, 0.95); /* one spreads: its degrees of freedom */
    assert_near(out.degrees, 2, 1e-12);
}

TEST_CASE(test_holm)
{
    double p[6] = {0.012, 0.04, 0.0007, 0.3, 0.02, 0.009}, adjusted[6];
    const double expected[6] = {0.048, 0.08, 0.0042, 0.3, 0.06, 0.045};
    expect_ok(ranking_holm, adjusted, p, 6);
    for (size_t i = 0; i < 6; i++)
        assert_near(adjusted[i], expected[i], 1e-14);
    expect_ok(ranking_holm, p, p, 6); /* in place */
    assert_memory_equal(p, adjusted, sizeof p);
    double one[1] = {0.3}, large[3] = {0.9, 0.8, 1};
    expect_ok(ranking_holm, one, one, 1);
    assert_near(one[0], 0.3, 1e-15);
    expect_ok(ranking_holm, large, large, 3);
    for (size_t i = 0; i < 3; i++)
        assert_near(large[i], 1, 1e-15);
    double close[2] = {0.011, 0.01}; /* an adjusted p is never below that of a smaller p */
    expect_ok(ranking_holm, close, close, 2);
    assert_near(close[0], 0.02, 1e-15);
}

TEST_CASE(test_pairs_are_numbered_in_order)
{
    for (size_t count = 2; count < 9; count++) {
        size_t next = 0;
        for (size_t i = 0; i < count; i++)
            for (size_t j = i + 1; j < count; j++)
                assert_int_equal(ranking_pair(i, j, count), next++);
        assert_int_equal(next, count * (count - 1) / 2);
    }
}

static bool share(const struct ranking_groups *groups, size_t i, size_t j, size_t except)
{
    for (size_t g = 0; g < groups->groups; g++)
        if (g != except && groups->member[g * groups->surfaces + i] && groups->member[g * groups->surfaces + j])
            return true;
    return false;
}

/* All patterns of pairs among 1 to 5 surfaces, and many among 12: a letter is shared exactly by those not told apart,
 * no letter is superfluous, and letters begin in the order of the surfaces. */
static void assert_groups(const bool *apart, size_t surfaces)
{
    struct ranking_groups groups;
    expect_ok(ranking_groups_make, &groups, apart, surfaces);
    for (size_t i = 0; i < surfaces; i++) {
        assert_true(share(&groups, i, i, SIZE_MAX));
        for (size_t j = i + 1; j < surfaces; j++)
            assert_true(share(&groups, i, j, SIZE_MAX) == !apart[ranking_pair(i, j, surfaces)]);
    }
    size_t first_before = 0;
    for (size_t g = 0; g < groups.groups; g++) {
        bool needed = false;
        size_t first = SIZE_MAX;
        for (size_t i = 0; i < surfaces; i++)
            for (size_t j = i; j < surfaces; j++)
                if (groups.member[g * surfaces + i] && groups.member[g * surfaces + j]) {
                    needed = needed || !share(&groups, i, j, g);
                    first = first == SIZE_MAX ? i : first;
                }
        assert_true(needed && first >= first_before);
        first_before = first;
    }
    ranking_groups_free(&groups);
}

TEST_CASE(test_letters_of_every_pattern)
{
    bool apart[66];
    for (size_t surfaces = 0; surfaces <= 5; surfaces++) {
        size_t pairs = surfaces > 0 ? surfaces * (surfaces - 1) / 2 : 0;
        for (unsigned long pattern = 0; pattern < 1ul << pairs; pattern++) {
            for (size_t k = 0; k < pairs; k++)
                apart[k] = pattern >> k & 1;
            assert_groups(apart, surfaces);
        }
    }
    uint64_t seed = 1;
    for (int trial = 0; trial < 200; trial++) {
        for (size_t k = 0; k < 66; k++) {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            apart[k] = (seed >> 60) > (uint64_t)trial % 16;
        }
        assert_groups(apart, 12);
    }
}

TEST_CASE(test_letters_of_a_ranking)
{
    /* a - b - c: neighbours not told apart, the ends told apart; d from all */
    const bool apart[6] = {false, true, true, false, true, true};
    const char *const expected[4] = {"a", "ab", "b", "c"};
    struct ranking_groups groups;
    expect_ok(ranking_groups_make, &groups, apart, 4);
    for (size_t i = 0; i < 4; i++) {
        char letters[RANKING_LETTERS + 1];
        ranking_groups_letters(letters, &groups, i);
        assert_string_equal(letters, expected[i]);
    }
    ranking_groups_free(&groups);
}

/* The pattern with the most groups: two camps, each told apart within, none across: 8 x 8 pairs. */
TEST_CASE(test_more_groups_than_letters)
{
    bool apart[120];
    for (size_t i = 0; i < 16; i++)
        for (size_t j = i + 1; j < 16; j++)
            apart[ranking_pair(i, j, 16)] = (i < 8) == (j < 8);
    struct ranking_groups groups;
    expect_ok(ranking_groups_make, &groups, apart, 16);
    assert_int_equal(groups.groups, 64);
    char letters[RANKING_LETTERS + 1];
    ranking_groups_letters(letters, &groups, 0);
    assert_string_equal(letters, "abcdefgh");
    ranking_groups_letters(letters, &groups, 7);
    assert_string_equal(letters, "********");
    ranking_groups_free(&groups);
}
