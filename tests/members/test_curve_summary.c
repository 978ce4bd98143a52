/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The summary of curves whose values follow from a formula. */
#include "members/curve_summary.h"
#include "support.h"

enum { LOADS = 41, FEW = 8 };

static struct contact_point points[LOADS];
static struct model_curve curve;

static const struct model_row plain = {.name = "plain", .quantities = (1u << QUANTITY_COUNT) - 1, .largest_area = 0.1};

/* Loads 1e-6 ... 1e-2, ten a decade, A/A_n = 10 load^0.9, ECR = 1e-12 load^-slope. */
static void make(double slope)
{
    curve = (struct model_curve){.exists = true,
                                 .points = points,
                                 .count = LOADS,
                                 .full_load = 0.02,
                                 .beta = 5,
                                 .full = {.value[QUANTITY_SEPARATION] = 3e-8, .value[QUANTITY_ADJUSTED] = 2e-8},
                                 .clamped = 6};
    for (int i = 0; i < LOADS; i++) {
        double load = pow(10, -6 + i / 10.0);
        points[i] = (struct contact_point){.value[QUANTITY_LOAD] = load,
                                           .value[QUANTITY_AREA] = 10 * pow(load, 0.9),
                                           .value[QUANTITY_ECR] = 1e-12 * pow(load, -slope),
                                           .value[QUANTITY_TCR] = 1,
                                           .value[QUANTITY_TCR_SCALE_DEPENDENT] = 1.01 + 0.001 * i};
    }
}

static struct curve_summary summary_of(void)
{
    struct curve_summary summary = {.seconds = 3, .sensitivity.area = {0.8}};
    curve_summary_make(&summary, &curve, &plain, 1e-7, NAN);
    return summary;
}

TEST_CASE(test_the_slope_of_the_area)
{
    make(1);
    struct curve_summary s = summary_of();
    assert_near(s.area_slope, 0.9, 1e-9);
    const double held = points[2 * LOADS / 3].value[QUANTITY_AREA];
    for (int i = 2 * LOADS / 3; i < LOADS; i++) /* a bond line holds the area */
        points[i].value[QUANTITY_AREA] = held;
    assert_near(summary_of().area_slope, 0.9, 1e-9);
    make(1);
    for (int i = 0; i < LOADS; i++) /* areas from A/A_n = 0.1 on are not used */
        if (points[i].value[QUANTITY_AREA] >= 0.1)
            points[i].value[QUANTITY_AREA] = 0.1 + 0.1 * points[i].value[QUANTITY_AREA];
    assert_near(summary_of().area_slope, 0.9, 1e-9);
    for (int i = 0; i < LOADS; i++) /* every second one above, the others below by 0.01 decades */
        points[i].value[QUANTITY_AREA] = pow(10, -5 + i / 20.0 + (i % 2 ? 0.01 : -0.01));
    assert_near(summary_of().area_slope, 0.5, 0.01);
    curve.count = 5;
    assert_true(isfinite(summary_of().area_slope));
    curve.count = 4; /* too few */
    assert_true(isnan(summary_of().area_slope));
}

/* The elbow is where |d ln ECR/d ln P| first exceeds 2, or ECR goes to 0. */
TEST_CASE(test_the_elbow)
{
    make(1.99);
    assert_true(isnan(summary_of().elbow_load));
    make(2.01);
    assert_near(summary_of().elbow_load, 1e-6, 1e-9);
    make(1.99);
    for (int i = 20; i < LOADS; i++) /* from the 20th point on it falls more steeply */
        points[i].value[QUANTITY_ECR] = points[19].value[QUANTITY_ECR] *
                                        pow(points[i].value[QUANTITY_LOAD] / points[19].value[QUANTITY_LOAD], -2.01);
    assert_near(summary_of().elbow_load, points[19].value[QUANTITY_LOAD], 1e-9);
    make(1);
    points[30].value[QUANTITY_ECR] = 0;
    assert_near(summary_of().elbow_load, points[29].value[QUANTITY_LOAD], 1e-9);
    for (int i = 0; i < LOADS; i++)
        points[i].value[QUANTITY_ECR] = NAN;
    assert_true(isnan(summary_of().elbow_load));
}

static void assert_validity(const struct model_row *row, size_t first, size_t end)
{
    struct curve_validity valid = curve_summary_validity(&curve, row);
    assert_int_equal(valid.first, first);
    assert_int_equal(valid.end, end);
}

TEST_CASE(test_where_it_is_not_valid)
{
    make(1);
    for (int i = 0; i < LOADS; i++) {
        points[i].value[QUANTITY_AREA] = i < 15 ? 0.1 : 0.1001;
        points[i].beyond_fit = i < 12 ? 0.1 : 0.1001;
        points[i].radius_clamped = i == 20 ? 0.3 : 0;
    }
    points[33].beyond_fit = 0.4;
    struct curve_summary s = summary_of();
    assert_near(s.invalid_load, points[12].value[QUANTITY_LOAD], 1e-12);
    assert_near(s.most_beyond_fit, 0.4, 1e-12);
    assert_near(s.most_radius_clamped, 0.3, 1e-12);
    assert_validity(&plain, 0, 12);
    for (int i = 0; i < LOADS; i++)
        points[i].beyond_fit = 0;
    assert_validity(&plain, 0, 15);
    assert_near(summary_of().invalid_load, points[15].value[QUANTITY_LOAD], 1e-12);
    struct model_row any = plain;
    any.largest_area = 0; /* valid at any area */
    assert_validity(&any, 0, LOADS);
    curve_summary_make(&s, &curve, &any, 1e-7, NAN);
    assert_true(isnan(s.invalid_load));
}

TEST_CASE(test_the_rest)
{
    make(1);
    points[40].value[QUANTITY_TCR] = 0; /* full contact */
    struct curve_summary s = summary_of();
    assert_near(s.sd_most, 0.01 + 0.039, 1e-9);
    assert_near(s.gap_at_full, 0.2, 1e-12); /* the adjusted one, over sigma */
    assert_near(s.full_load, 0.02, 1e-12);
    assert_near(s.beta, 5, 1e-12);
    assert_true(isnan(s.beta_multiscale));
    assert_int_equal(s.clamped, 6);
    assert_near(s.seconds, 3, 1e-12); /* what was known before stays */
    assert_near(s.sensitivity.area[0], 0.8, 1e-12);
    struct model_row stacked = plain;
    stacked.quantities &= ~QUANTITY_BIT(QUANTITY_ADJUSTED);
    curve_summary_make(&s, &curve, &stacked, 1e-7, NAN);
    assert_near(s.gap_at_full, 0.3, 1e-12);
}

/* Which part of a curve is valid: light loads may be outside the range as well as heavy ones. */
static void check(const double beyond_fit[FEW], const double area[FEW], size_t first, size_t end)
{
    curve = (struct model_curve){.exists = true, .points = points, .count = FEW};
    struct curve_summary summary = {0};
    for (size_t i = 0; i < FEW; i++)
        points[i] = (struct contact_point){.value[QUANTITY_LOAD] = 1e-4 * (double)(i + 1),
                                           .value[QUANTITY_AREA] = area[i],
                                           .beyond_fit = beyond_fit[i]};
    assert_validity(&plain, first, end);
    curve_summary_make(&summary, &curve, &plain, 1e-6, NAN);
    if (end < FEW)
        assert_near(summary.invalid_load, points[end].value[QUANTITY_LOAD], 0);
    else
        assert_true(isnan(summary.invalid_load));
}

TEST_CASE(test_inside_and_outside)
{
    static const double none[FEW] = {0}, light[FEW] = {1, 1, 0}, heavy[FEW] = {0, 0, 0, 0, 0, 0.1, 0.11, 0.2},
                        both[FEW] = {1, 0, 0, 0, 0, 0, 0, 1}, all[FEW] = {1, 1, 1, 1, 1, 1, 1, 1};
    static const double small[FEW] = {0.01, 0.01, 0.02, 0.02, 0.03, 0.03, 0.04, 0.05},
                        grows[FEW] = {0.01, 0.02, 0.03, 0.1, 0.2, 0.3, 0.4, 0.5};
    check(none, small, 0, FEW);
    check(light, small, 2, FEW); /* a middle load behind them is inside */
    check(heavy, small, 0, 6);
    check(both, small, 1, 7);
    check(all, small, 0, 0);
    check(none, grows, 0, 4);
    check(light, grows, 2, 4);
}
