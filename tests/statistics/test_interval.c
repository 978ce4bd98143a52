/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "statistics/interval.h"
#include "support.h"

/* Numbers separated by spaces. */
static size_t read_list(double *value, const char *list)
{
    size_t count = 0;
    for (char *end; *list; list = end + (*end == ' '))
        value[count++] = strtod(list, &end);
    return count;
}

static struct interval scans(const double *value, const double *weight, size_t count, double level)
{
    struct interval out;
    expect_ok(interval_scans, &out, value, weight, count, level);
    return out;
}

TEST_CASE(test_reference_values)
{
    struct table table = table_read("statistics/interval.csv");
    for (size_t r = 0; r < table.rows; r++) {
        double value[32], weight[32];
        size_t count = read_list(value, table_text(&table, r, "values"));
        bool weighted = table_text(&table, r, "weights")[0] != '-';
        if (weighted)
            assert_int_equal(read_list(weight, table_text(&table, r, "weights")), count);
        struct interval out = scans(value, weighted ? weight : NULL, count, 0.95);
        const double half = interval_next_half_width(&out);
        const struct {
            const char *column;
            double value;
        } numbers[] = {{"mean", out.mean},
                       {"s", out.s},
                       {"t", out.t},
                       {"low", out.low},
                       {"high", out.high},
                       {"degrees", out.degrees},
                       {"sd", out.sd},
                       {"next_low", out.mean - half},
                       {"next_high", out.mean + half}};
        for (size_t n = 0; n < sizeof numbers / sizeof *numbers; n++)
            assert_near(numbers[n].value, table_number(&table, r, numbers[n].column), 1e-12);
    }
}

/* Closed forms at 1, 2 and 4 degrees of freedom, and the normal limit. */
TEST_CASE(test_quantiles)
{
    const double levels[] = {0.5, 0.68, 0.95, 0.99, 0.999};
    for (size_t l = 0; l < 5; l++) {
        double p = (1 + levels[l]) / 2, q = 1 - p;
        assert_near(interval_quantile(levels[l], 1), tan(M_PI * levels[l] / 2), 1e-11);
        assert_near(interval_quantile(levels[l], 2), levels[l] * sqrt(1 / (2 * p * q)), 1e-11);
        double a = 4 * p * q, c = cos(acos(sqrt(a)) / 3) / sqrt(a);
        assert_near(interval_quantile(levels[l], 4), 2 * sqrt(c - 1), 1e-10);
    }
    assert_near(interval_quantile(0.95, 1e7), 1.959964, 1e-6);
}

static void rotate(double *value, size_t count)
{
    double first = value[0];
    memmove(value, value + 1, (count - 1) * sizeof *value);
    value[count - 1] = first;
}

/* To the last bit, also among scans of the same value and different weights. */
TEST_CASE(test_file_order_does_not_matter)
{
    double values[2][4] = {{-20.1, 3.3e-7, 5.5, 1e5}, {0, 0, 0, 1}},
           weights[2][4] = {{1, 2, 3, 1}, {0.1, 0.2, 0.3, 0.05}};
    for (size_t k = 0; k < 2; k++) {
        struct interval first = scans(values[k], weights[k], 4, 0.95);
        for (int turn = 0; turn < 4; turn++) {
            rotate(values[k], 4);
            rotate(weights[k], 4);
            struct interval out = scans(values[k], weights[k], 4, 0.95);
            assert_memory_equal(&out.mean, &first.mean, sizeof out.mean);
            assert_memory_equal(&out.s, &first.s, sizeof out.s);
        }
    }
}

TEST_CASE(test_two_scans)
{
    const double value[2] = {3, 5};
    struct interval out = scans(value, NULL, 2, 0.95);
    assert_near(out.mean, 4, 1e-15);
    assert_near(out.sd, sqrt(2), 1e-15);
    assert_near(out.s, 1, 1e-15);
    assert_near(out.high - 4, tan(M_PI * 0.475), 1e-11); /* Cauchy */
    assert_near(interval_next_half_width(&out), tan(M_PI * 0.475) * sqrt(3), 1e-11);
}

/* A scan of weight 2 is no two scans (its pieces are not counted as degrees of freedom), equal weights are none. */
TEST_CASE(test_weights)
{
    const double value[4] = {1, 2, 4, 8}, equal[4] = {3, 3, 3, 3};
    struct interval plain = scans(value, NULL, 4, 0.95), weighted = scans(value, equal, 4, 0.95);
    assert_near(weighted.mean, plain.mean, 1e-14);
    assert_near(weighted.s, plain.s, 1e-14);
    assert_near(weighted.sd, plain.sd * sqrt(3), 1e-14); /* of a value of weight 1 */
}

TEST_CASE(test_identical_values_have_no_spread)
{
    double value[9];
    for (size_t i = 0; i < 9; i++)
        value[i] = 0.1;
    struct interval out = scans(value, NULL, 9, 0.95);
    assert_true(out.mean == 0.1 && out.sd == 0 && out.s == 0 && out.low == 0.1 && out.high == 0.1);
    assert_true(interval_next_half_width(&out) == 0);
}

TEST_CASE(test_units_do_not_matter)
{
    const double value[6] = {1, 3, 2, 5, 4, 4};
    double scaled[6];
    for (size_t i = 0; i < 6; i++)
        scaled[i] = 7 + 1e-6 * value[i];
    struct interval before = scans(value, NULL, 6, 0.68), after = scans(scaled, NULL, 6, 0.68);
    assert_near(after.mean - 7, 1e-6 * before.mean, 1e-8);
    assert_near(after.s, 1e-6 * before.s, 1e-8);
}

TEST_CASE(test_pieces_reach_from_end_to_end)
{
    for (size_t shortest = 1; shortest < 40; shortest++)
        for (size_t points = shortest; points < 300; points++) {
            size_t pieces = interval_subrecords(points, shortest);
            assert_true(pieces * shortest <= points && (pieces + 1) * shortest > points);
            assert_int_equal(interval_subrecord_first(points, shortest, 0), 0);
            if (pieces > 1)
                assert_int_equal(interval_subrecord_first(points, shortest, pieces - 1), points - shortest);
            for (size_t p = 1; p < pieces; p++) {
                size_t step =
                    interval_subrecord_first(points, shortest, p) - interval_subrecord_first(points, shortest, p - 1);
                assert_true(step >= shortest && step <= (points - shortest) / (pieces - 1) + 1);
            }
        }
}
