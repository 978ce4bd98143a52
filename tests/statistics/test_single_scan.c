/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "statistics/single_scan.h"
#include "support.h"

TEST_CASE(test_spread_of_simulated_records)
{
    const double simulated[4] = {10, 12, 14, 16};
    struct single_scan out;
    struct status status = {0};
    assert_int_equal(single_scan_uncertainty(&out, simulated, 4, NULL, NULL, &status), STATUS_OK);
    assert_near(out.s, sqrt(20.0 / 3), 1e-14);
    assert_near(out.half_width, 2.3 * sqrt(20.0 / 3), 1e-14);
    assert_false(out.heterogeneous);
}

/* Quarters 0 and d, twice each: SD d/sqrt 3. */
TEST_CASE(test_a_scan_that_is_not_the_same_along_its_length)
{
    const double simulated[2] = {1, 1.2}, simulated_quarter[8] = {0, 1, 0, 1, 0, 3, 3, 0};
    for (int k = 0; k < 2; k++) {
        const double step = k ? 3.0001 : 2.9999, quarter[4] = {5, 5 + step, 5, 5 + step};
        struct single_scan out;
        struct status status = {0};
        assert_int_equal(single_scan_uncertainty(&out, simulated, 2, quarter, simulated_quarter, &status), STATUS_OK);
        assert_near(out.quarters_sd, step / sqrt(3), 1e-12);
        assert_near(out.simulated_sd, sqrt(3), 1e-12);
        assert_true(out.heterogeneous == (k == 1));
        assert_near(out.half_width, k ? 3.18 * step / sqrt(3) : 2.3 * sqrt(0.02), 1e-12);
    }
    const double wide[2] = {-100, 100}, quarter[4] = {0, 9, 0, 9};
    struct single_scan out;
    struct status status = {0};
    assert_int_equal(single_scan_uncertainty(&out, wide, 2, quarter, simulated_quarter, &status), STATUS_OK);
    assert_true(out.heterogeneous); /* flagged, though the records spread more than the quarters */
    assert_near(out.half_width, 2.3 * out.s, 1e-14);
}

TEST_CASE(test_identical_records_have_no_spread)
{
    const double simulated[3] = {0.1, 0.1, 0.1}, quarter[4] = {0.1, 0.1, 0.1, 0.1};
    double simulated_quarter[12];
    for (size_t i = 0; i < 12; i++)
        simulated_quarter[i] = 0.1;
    struct single_scan out;
    struct status status = {0};
    assert_int_equal(single_scan_uncertainty(&out, simulated, 3, quarter, simulated_quarter, &status), STATUS_OK);
    assert_true(out.s == 0 && out.half_width == 0 && out.quarters_sd == 0 && !out.heterogeneous);
}

TEST_CASE(test_answers_that_are_no_numbers_are_refused)
{
    const double good[4] = {1, 2, 3, 4}, bad[4] = {1, 2, NAN, 4};
    const double good_quarters[16] = {0};
    double bad_quarters[16] = {0};
    bad_quarters[15] = INFINITY;
    struct single_scan out;
    struct status status = {0};
    assert_int_equal(single_scan_uncertainty(&out, bad, 4, NULL, NULL, &status), STATUS_SCAN);
    assert_non_null(strstr(status.message, "simulated record 3 of 4"));
    status = (struct status){0};
    assert_int_equal(single_scan_uncertainty(&out, good, 4, bad, good_quarters, &status), STATUS_SCAN);
    assert_non_null(strstr(status.message, "quarter 3 of 4"));
    status = (struct status){0};
    assert_int_equal(single_scan_uncertainty(&out, good, 4, good, bad_quarters, &status), STATUS_SCAN);
    assert_non_null(strstr(status.message, "simulated quarter 16 of 16"));
}

TEST_CASE(test_between_loads)
{
    const double ln_load[3] = {-9, -6, -2}, s[3] = {0.1, 0.4, 0.2};
    assert_near(single_scan_s_at(-20, ln_load, s, 3), 0.1, 1e-15);
    assert_near(single_scan_s_at(-9, ln_load, s, 3), 0.1, 1e-15);
    assert_near(single_scan_s_at(-7, ln_load, s, 3), 0.3, 1e-15);
    assert_near(single_scan_s_at(-6, ln_load, s, 3), 0.4, 1e-15);
    assert_near(single_scan_s_at(-3, ln_load, s, 3), 0.25, 1e-15);
    assert_near(single_scan_s_at(0, ln_load, s, 3), 0.2, 1e-15);
    assert_near(single_scan_s_at(0, ln_load, s, 1), 0.1, 1e-15);
}
