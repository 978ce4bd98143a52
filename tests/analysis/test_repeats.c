/* What is known of a number from its value of every scan, piece or row. Student's quantiles from tables. */
#include "analysis/repeats.h"
#include "support.h"

enum { MOST = 64 };

/* Parts of the scans given, one value a part. */
static struct repeat_set set_of(struct repeat *parts, const size_t *scan, size_t count, struct repeats_scan *scans,
                                size_t scan_count)
{
    for (size_t p = 0; p < count; p++)
        parts[p] = (struct repeat){.scan = scan[p]};
    return (struct repeat_set){.parts = parts, .count = count, .scans = scans, .scan_count = scan_count};
}

/** Three scans: geometric mean, and t(2) = 4.302653 standard errors; another scan, sqrt(1 + 1/3) deviations. */
static void three_scans(void **state)
{
    (void)state;
    static const size_t scan[] = {0, 1, 2};
    static const double value[] = {1, 4, 16};
    struct repeat parts[3];
    struct repeats_scan scans[3] = {{.weight = 1}, {.weight = 1}, {.weight = 1}};
    struct repeat_set set = set_of(parts, scan, 3, scans, 3);
    struct status status = {0};
    struct estimate estimate;
    assert_int_equal(repeats_estimate(&estimate, value, &set, true, &status), STATUS_OK);
    double sd = log(4), t = 4.302652729911275;
    assert_near(estimate_value(&estimate), 4, 1e-14);
    assert_near(estimate_end(&estimate, 1), 4 * exp(t * sd / sqrt(3)), 1e-9);
    assert_near(estimate_end(&estimate, 0), 4 / exp(t * sd / sqrt(3)), 1e-9);
    assert_near(estimate_next_end(&estimate, 1), 4 * exp(t * sd * sqrt(1 + 1 / 3.0)), 1e-9);
    assert_int_equal(repeats_estimate(&estimate, value, &set, false, &status), STATUS_OK);
    assert_near(estimate_value(&estimate), 7, 1e-14);
    set.no_intervals = true;
    assert_int_equal(repeats_estimate(&estimate, value, &set, true, &status), STATUS_OK);
    assert_near(estimate_value(&estimate), 4, 1e-14);
    assert_true(isnan(estimate_end(&estimate, 0)) && isnan(estimate_next_end(&estimate, 1)));
}

/** Pieces of a scan count together, as much as they are many: ln 2 and the mean of ln 8, ln 32, weights 1 and 2. */
static void pieces(void **state)
{
    (void)state;
    static const size_t scan[] = {0, 1, 1};
    static const double value[] = {2, 8, 32};
    struct repeat parts[3];
    struct repeats_scan scans[2] = {{.weight = 1}, {.weight = 2}};
    struct repeat_set set = set_of(parts, scan, 3, scans, 2);
    struct status status = {0};
    struct estimate estimate;
    assert_int_equal(repeats_estimate(&estimate, value, &set, true, &status), STATUS_OK);
    assert_int_equal(estimate.count, 2);
    assert_near(estimate.mean, (log(2) + 2 * log(16)) / 3, 1e-13);
    assert_near(estimate.effective, 3, 1e-15);
    assert_near(estimate.degrees, 1, 1e-15);
}

/** Rows of a map: 16 blocks of 4; blocks that alternate are independent, blocks that rise are worth the least. */
static void rows(void **state)
{
    (void)state;
    size_t scan[MOST] = {0};
    double value[MOST];
    struct repeat parts[MOST];
    struct repeats_scan scans[1] = {{.weight = 1}};
    struct repeat_set set = set_of(parts, scan, MOST, scans, 1);
    struct status status = {0};
    struct estimate estimate;
    for (int i = 0; i < MOST; i++)
        value[i] = i / 4 % 2 ? 3 : 1;
    assert_int_equal(repeats_estimate(&estimate, value, &set, false, &status), STATUS_OK);
    assert_int_equal(estimate.count, ESTIMATE_BLOCKS);
    assert_near(estimate.mean, 2, 1e-14);
    assert_near(estimate.effective, 16, 1e-14);
    assert_true(isnan(estimate_next_end(&estimate, 0)));
    for (int i = 0; i < MOST; i++)
        value[i] = i;
    assert_int_equal(repeats_estimate(&estimate, value, &set, false, &status), STATUS_OK);
    assert_near(estimate.effective, 2, 1e-14);
    assert_near(estimate.mean, 31.5, 1e-14);
}

/** A value that is missing, or not positive where logarithms count, leaves nothing known; equal ones spread by nothing.
 */
static void nothing_known(void **state)
{
    (void)state;
    static const size_t scan[] = {0, 1};
    static const double missing[] = {1, NAN}, closed[] = {1, 0}, same[] = {0.3, 0.3};
    struct repeat parts[2];
    struct repeats_scan scans[2] = {{.weight = 1}, {.weight = 1}};
    struct repeat_set set = set_of(parts, scan, 2, scans, 2);
    struct status status = {0};
    struct estimate estimate;
    assert_int_equal(repeats_estimate(&estimate, missing, &set, false, &status), STATUS_OK);
    assert_int_equal(estimate.count, 0);
    assert_true(isnan(estimate_value(&estimate)));
    assert_int_equal(repeats_estimate(&estimate, closed, &set, true, &status), STATUS_OK);
    assert_int_equal(estimate.count, 0);
    assert_int_equal(repeats_estimate(&estimate, same, &set, true, &status), STATUS_OK);
    assert_int_equal(estimate.count, 2);
    assert_near(estimate_end(&estimate, 0), estimate_end(&estimate, 1), 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(three_scans),
        cmocka_unit_test(pieces),
        cmocka_unit_test(rows),
        cmocka_unit_test(nothing_known),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
