/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which part of a curve lies inside a model's validity: light loads may be outside as well as heavy ones. */
#include "members/curve_summary.h"
#include "support.h"

enum { LOADS = 8 };

static void check(const double beyond_fit[LOADS], const double area[LOADS], size_t first, size_t end)
{
    static const struct model_row row = {.largest_area = 0.1};
    struct contact_point points[LOADS] = {0};
    struct model_curve curve = {.exists = true, .points = points, .count = LOADS};
    struct curve_summary summary = {0};
    for (size_t i = 0; i < LOADS; i++)
        points[i] = (struct contact_point){.value[QUANTITY_LOAD] = 1e-4 * (double)(i + 1),
                                           .value[QUANTITY_AREA] = area[i],
                                           .beyond_fit = beyond_fit[i]};
    struct curve_validity valid = curve_summary_validity(&curve, &row);
    assert_int_equal(valid.first, first);
    assert_int_equal(valid.end, end);
    curve_summary_make(&summary, &curve, &row, 1e-6, NAN);
    if (end < LOADS)
        assert_near(summary.invalid_load, points[end].value[QUANTITY_LOAD], 0);
    else
        assert_true(isnan(summary.invalid_load));
}

TEST_CASE(inside_and_outside)
{
    static const double none[LOADS] = {0}, light[LOADS] = {1, 1, 0}, heavy[LOADS] = {0, 0, 0, 0, 0, 0.1, 0.11, 0.2},
                        both[LOADS] = {1, 0, 0, 0, 0, 0, 0, 1}, all[LOADS] = {1, 1, 1, 1, 1, 1, 1, 1};
    static const double small[LOADS] = {0.01, 0.01, 0.02, 0.02, 0.03, 0.03, 0.04, 0.05},
                        grows[LOADS] = {0.01, 0.02, 0.03, 0.1, 0.2, 0.3, 0.4, 0.5};
    check(none, small, 0, LOADS);
    check(light, small, 2, LOADS); /* a middle load behind them is inside */
    check(heavy, small, 0, 6);
    check(both, small, 1, 7);
    check(all, small, 0, 0);
    check(none, grows, 0, 4);
    check(light, grows, 2, 4);
}
