/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "statistics/estimate.h"
#include "support.h"

/* s² = s_r² + s_Q²/2. */
TEST_CASE(test_records_and_quarters_add)
{
    const double record[4] = {10, 12, 14, 16}, same[4] = {3, 3, 3, 3}, quarter[4] = {5, 7, 5, 7};
    assert_near(single_scan_s(record, 4, same, 4), sqrt(20.0 / 3), 1e-14);
    assert_near(single_scan_s(record, 4, quarter, 4), sqrt(20.0 / 3 + 4.0 / 3 / 2), 1e-14);
    assert_near(single_scan_s(same, 4, quarter, 4), sqrt(4.0 / 3 / 2), 1e-14);
    assert_true(single_scan_s(same, 4, same, 4) == 0);
}

/* What has no answer is left out, down to half of the records; of the quarters three have to have one, or half a unit
 * of ln stands for what they would say. */
TEST_CASE(test_answers_that_are_not_there)
{
    const double record[4] = {10, NAN, -INFINITY, 16}, few[4] = {10, NAN, NAN, NAN}, same[4] = {3, 3, 3, 3};
    const double three[4] = {5, NAN, 7, 9}, two[4] = {NAN, 5, 50, NAN};
    assert_near(single_scan_s(record, 4, same, 4), sqrt(18), 1e-14);
    assert_true(isnan(single_scan_s(few, 4, same, 4)));
    assert_near(single_scan_s(same, 4, three, 4), sqrt(4.0 / 2), 1e-14);
    assert_near(single_scan_s(same, 4, two, 4), 0.5 / sqrt(2), 1e-14);
    assert_near(single_scan_s(same, 4, NULL, 0), 0.5 / sqrt(2), 1e-14);
}

TEST_CASE(test_between_loads)
{
    const double ln_load[3] = {-9, -6, -2}, s[3] = {0.1, 0.4, 0.2};
    static const double expected[][2] = {{-20, 0.1}, {-9, 0.1}, {-7, 0.3}, {-6, 0.4}, {-3, 0.25}, {0, 0.2}};
    for (size_t i = 0; i < 6; i++)
        assert_near(single_scan_s_at(expected[i][0], ln_load, s, 3), expected[i][1], 1e-15);
    assert_near(single_scan_s_at(0, ln_load, s, 1), 0.1, 1e-15);
    const double known[3] = {NAN, 0.4, NAN}; /* constant about the one that is known */
    for (double at = -20; at < 1; at++)
        assert_near(single_scan_s_at(at, ln_load, known, 3), 0.4, 1e-15);
    assert_true(isnan(single_scan_s_at(-6, ln_load, known, 1)));
}
