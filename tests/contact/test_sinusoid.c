/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/sinusoid.h"
#include "model_support.h"

static const struct sinusoid_fit *thesis = &sinusoid_fits[SINUSOID_FIT_THESIS];

TEST_CASE(elastic_matches_reference)
{
    struct table table = table_read("golden/sinusoid_elastic.csv");
    for (size_t i = 0; i < table.rows; i++) {
        struct sinusoid_cell cell = {0};
        double x = table_number(&table, i, "p_over_pstar");
        thesis->area(&cell, x);
        assert_near(cell.area_ratio, table_number(&table, i, "area_ratio"), 1e-10);
        assert_near(thesis->gap(x), table_number(&table, i, "gap_over_amplitude"), 1e-10);
    }
}

TEST_CASE(plastic_matches_reference)
{
    struct table table = table_read("golden/sinusoid_plastic.csv");
    struct material_pair pair = model_support_tin();
    for (size_t i = 0; i < table.rows; i++) {
        double amplitude = table_number(&table, i, "amplitude_m"),
               frequency = table_number(&table, i, "frequency_per_m");
        double pressure = table_number(&table, i, "mean_pressure_Pa");
        for (int plastic = 0; plastic < 2; plastic++) {
            struct sinusoid_scale scale = sinusoid_scale(amplitude, frequency, &pair, plastic);
            struct sinusoid_cell cell;
            sinusoid_press(&cell, &scale, thesis, pressure, true);
            assert_near(cell.area_ratio, table_number(&table, i, plastic ? "area_ratio_plastic" : "area_ratio_elastic"),
                        1e-10);
            assert_near(cell.gap_ratio * amplitude,
                        table_number(&table, i, plastic ? "gap_m_plastic" : "gap_m_elastic"), 1e-10);
        }
    }
}

/** Both closures against the direct solution: largest relative difference of the area at any x, and of the gap at x <=
 * 0.55 (beyond, less than 4 % of it is left); the thesis's is no smaller. */
TEST_CASE(closures_keep_their_stated_error)
{
    struct table table = table_read("golden/sinusoid_bem.csv");
    for (int c = 0; c < SINUSOID_FIT_COUNT; c++) {
        const struct sinusoid_fit *closure = &sinusoid_fits[c];
        static const double most[SINUSOID_FIT_COUNT][2] = {{0.12, 0.10}, {0.004, 0.002}};
        double area_error = 0, gap_error = 0;
        for (size_t i = 0; i < table.rows; i++) {
            double x = table_number(&table, i, "p_over_pstar");
            double area = table_number(&table, i, "area_ratio"), gap = table_number(&table, i, "gap_over_amplitude");
            struct sinusoid_cell cell = {0};
            closure->area(&cell, x);
            area_error = fmax(area_error, fabs(cell.area_ratio / area - 1));
            if (x <= 0.55)
                gap_error = fmax(gap_error, fabs(closure->gap(x) / gap - 1));
        }
        assert_true(area_error <= most[c][0]);
        assert_true(gap_error <= most[c][1]);
        if (c == SINUSOID_FIT_THESIS) {
            assert_true(area_error > 0.9 * most[c][0]);
            assert_true(gap_error > 0.9 * most[c][1]);
        }
    }
}

/** 1 - a of a plastic scale keeps its digits as a -> 1: against the sum in long double. */
TEST_CASE(complement_does_not_cancel)
{
    struct sinusoid_cell cell = {0};
    struct material_pair pair = model_support_tin();
    struct sinusoid_scale scale = sinusoid_scale(1e-6, 1e5, &pair, true);
    long double pp = scale.plastic_full_pressure_Pa;
    for (double rest = 1e-2; rest > 1e-10; rest /= 10) {
        double pressure = scale.plastic_full_pressure_Pa * (1 - rest);
        sinusoid_press(&cell, &scale, thesis, pressure, false);
        long double x = pressure / pp;
        long double low =
            expl(scale.plastic_area_log +
                 scale.plastic_area_exponent * logl((long double)pressure / scale.plastic_full_pressure_Pa));
        long double area =
            low * (1 - powl(x, 1.51L)) + (1 - 3 / (2 * 3.14159265358979323846L) * (1 - x)) * powl(x, 1.04L);
        if (area < 1)
            assert_near(cell.area_complement, (double)(1 - area), 1e-6);
        else
            assert_within(cell.area_complement, 0, 0);
    }
}

/** Materials of every Poisson's ratio, and scales from elastic to a thousand times beyond yield: above the pressure
 * that is said to order them, what closes one closes all that are less steep, and not so much below it; the steepest is
 * the last where it is said to be. */
TEST_CASE(steepness_orders_the_scales)
{
    struct material_pair pair = model_support_tin();
    for (double nu = 0.01; nu < 0.5; nu += 0.07) {
        pair.poisson_ratio = nu;
        pair.yield_coefficient = 1.295 * exp(0.736 * nu);
        double most_closed = 0, disorder = 0;
        double ordered = sinusoid_ordered_pressure(&pair);
        for (double ratio = 0.01; ratio < 1e5; ratio *= 1.003) {
            double frequency = 1e5 / ratio, pressure = ratio * pair.yield_strength_Pa;
            double amplitude = pressure / sinusoid_full_pressure(1, frequency, pair.effective_modulus_Pa);
            struct sinusoid_scale scale = sinusoid_scale(amplitude, frequency, &pair, true);
            double closed = sinusoid_closed_pressure(&scale);
            if (most_closed > closed) /* a less steep one stays open longer */
                disorder = fmax(disorder, most_closed);
            most_closed = fmax(most_closed, closed);
            struct sinusoid_cell cell;
            sinusoid_press(&cell, &scale, thesis, closed * (1 + 1e-12), true);
            assert_true(cell.area_complement == 0 && cell.gap_ratio == 0);
            assert_true(closed <= scale.full_pressure_Pa);
        }
        assert_true(disorder <= ordered * (1 + 1e-9) && (nu < 0.4 || disorder > 0.99 * ordered));
    }
}
