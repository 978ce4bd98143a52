/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One scale at its limits: complete contact, no pressure, the critical amplitude and the critical pressure. */
#include "contact/constriction.h"
#include "contact/sinusoid.h"
#include "hard_support.h"

static const double frequency = 1e5;
static const double link_step = 5e-4; /* closure thesis, area at p/p* = 0.8: 0.9049 below, 0.9045 from there on */

static void check_cell(const struct sinusoid_cell *cell)
{
    assert_true(isfinite(cell->area_ratio) && cell->area_ratio > 0 && cell->area_ratio <= 1);
    assert_true(isfinite(cell->area_complement) && cell->area_complement >= 0 && cell->area_complement <= 1);
    assert_within(cell->area_ratio + cell->area_complement, 1, 3e-16);
    assert_true(isfinite(cell->gap_ratio) && cell->gap_ratio >= 0 && cell->gap_ratio <= 1);
}

static void elastic(struct sinusoid_cell *cell, int closure, double x)
{
    sinusoid_fits[closure].area(cell, x);
    cell->gap_ratio = sinusoid_fits[closure].gap(x);
    check_cell(cell);
}

/** x -> 0: Hertz, a = pi (3x/8pi)^(2/3), and the gap is the amplitude; down to the smallest number there is. */
TEST_CASE(no_pressure_is_hertz)
{
    static const double xs[] = {5e-324, 1e-310, 1e-300, 1e-100, 1e-30, 1e-24};
    for (int closure = 0; closure < SINUSOID_FIT_COUNT; closure++)
        for (size_t i = 0; i < sizeof xs / sizeof xs[0]; i++) {
            struct sinusoid_cell cell;
            elastic(&cell, closure, xs[i]);
            double hertz = M_PI * exp(2.0 / 3 * (log(xs[i]) + log(3 / (8 * M_PI))));
            assert_near(cell.area_ratio, hertz, 1e-7);
            assert_within(cell.gap_ratio, 1, 1e-12);
        }
}

/** x -> 1 from below: 1 - a is linear in 1 - x with all its digits, the gap falls as (1-x)^2.5 or faster; complete
 * contact from 1 on, however far beyond. */
TEST_CASE(full_contact_from_both_sides)
{
    for (int closure = 0; closure < SINUSOID_FIT_COUNT; closure++) {
        struct sinusoid_cell cell, nearest;
        elastic(&nearest, closure, nextafter(1, 0));
        double slope = nearest.area_complement / (1 - nextafter(1, 0));
        assert_near(slope, 3 / (2 * M_PI), 3e-3);
        for (double rest = 1e-6; rest > 1e-16; rest /= 10) {
            double x = 1 - rest;
            elastic(&cell, closure, x);
            assert_near(cell.area_complement, slope * (1 - x), 1e-6);
            assert_true(cell.gap_ratio > 0 && cell.gap_ratio < pow(1 - x, 2.4));
        }
        static const double beyond[] = {1, 1 + 0x1p-52, 1 + 1e-12, 2, 1e6, 1e300, INFINITY};
        for (size_t i = 0; i < sizeof beyond / sizeof beyond[0]; i++) {
            elastic(&cell, closure, beyond[i]);
            assert_true(cell.area_ratio == 1 && cell.area_complement == 0 && cell.gap_ratio == 0);
        }
    }
}

/** Psi as A_i -> A_{i-1}: the closed form for small complements, down to denormal ones, and through a whole scale. */
TEST_CASE(alleviation_keeps_its_digits)
{
    for (double rest = 1e-9; rest > 1e-200; rest /= 13) /* Psi = (c/2)^(3/2) (1 + 3c/8 ...) */
        assert_near(constriction_alleviation(1 - rest, rest), rest / 2 * sqrt(rest / 2) * (1 + 0.375 * rest), 1e-14);
    assert_true(constriction_alleviation(1, 0) == 0);
    assert_true(constriction_alleviation(0, 1) == 1);
    struct material_pair pair = hard_tin();
    for (int closure = 0; closure < SINUSOID_FIT_COUNT; closure++) {
        struct sinusoid_scale scale = sinusoid_scale(1e-9, frequency, &pair, false);
        double previous = 1;
        for (double rest = 1e-3; rest > 4e-16; rest /= 3) {
            double pressure = scale.full_pressure_Pa * (1 - rest);
            struct sinusoid_cell cell;
            sinusoid_press(&cell, &scale, &sinusoid_fits[closure], pressure, false);
            double psi = constriction_alleviation(cell.area_ratio, cell.area_complement);
            double linear = 3 / (4 * M_PI) * (1 - pressure / scale.full_pressure_Pa);
            assert_near(psi, linear * sqrt(linear), 5e-3);
            assert_true(psi < previous);
            previous = psi;
        }
    }
}

/** Presses a scale from 1e-30 p* to 1e6 p*, past every border by a hair; nothing may fall or rise the wrong way. */
static void check_scale(const struct sinusoid_scale *scale, int closure)
{
    double full = scale->full_pressure_Pa, critical = scale->critical_pressure_Pa;
    double closed = sinusoid_closed_pressure(scale);
    struct sinusoid_cell cell, before = {.gap_ratio = 1};
    double pressure = full * 1e-30, seams[] = {0.8 * full, full, critical, closed, full * 1e6};
    while (pressure < full * 1e6) {
        bool plastic = sinusoid_press(&cell, scale, &sinusoid_fits[closure], pressure, true);
        check_cell(&cell);
        double allowed = closure == SINUSOID_FIT_THESIS && !plastic ? link_step : 0;
        assert_true(cell.area_ratio >= before.area_ratio * (1 - allowed) - 2e-16);
        assert_true(cell.gap_ratio <= before.gap_ratio);
        assert_true((cell.gap_ratio == 0) == (pressure >= closed));
        before = cell;
        double next = pressure * (pressure < full * 1e-4 ? 1e3 : 1.07);
        for (int i = 0; i < 5; i++) /* not over a border without looking on both sides of it */
            for (int side = -1; side <= 1; side++) {
                double seam = isfinite(seams[i]) ? seams[i] * (1 + side * 1e-12) : full;
                if (seam > pressure && seam < next)
                    next = seam;
            }
        pressure = next;
    }
    assert_true(cell.area_complement == 0);
}

/** S_y/E' from 1e-7 to 0.05, nu from 0 to 0.5, amplitudes from a hair around the critical one to 1e12 times it. */
TEST_CASE(no_material_breaks_a_scale)
{
    static const double ratios[] = {1e-12, 0.5, 1 - 1e-12, 1, 1 + 1e-12, 1.001, 1.25, 1.5, 2, 5, 30, 1e3, 1e6, 1e12};
    for (int y = 0; y < HARD_YIELD_RATIOS; y++)
        for (int n = 0; n < HARD_NUS; n++) {
            struct material_pair pair = hard_pair(hard_yield_ratios[y], hard_nus[n]);
            double critical = sinusoid_critical_amplitude(frequency, &pair);
            for (size_t r = 0; r < sizeof ratios / sizeof ratios[0]; r++)
                for (int variant = 0; variant < 2 * SINUSOID_FIT_COUNT; variant++) {
                    struct sinusoid_scale scale = sinusoid_scale(ratios[r] * critical, frequency, &pair, variant % 2);
                    check_scale(&scale, variant / 2);
                }
        }
}

/** At Delta_c the scale starts to be able to yield; p_c is near p* there, so nothing changes below it. */
TEST_CASE(critical_amplitude_from_both_sides)
{
    for (int n = 0; n < HARD_NUS; n++) {
        struct material_pair pair = hard_pair(3e-4, hard_nus[n]);
        double critical = sinusoid_critical_amplitude(frequency, &pair);
        struct sinusoid_scale below = sinusoid_scale(critical * (1 - 1e-12), frequency, &pair, true);
        struct sinusoid_scale above = sinusoid_scale(critical * (1 + 1e-12), frequency, &pair, true);
        assert_true(isinf(below.critical_pressure_Pa) && isfinite(above.critical_pressure_Pa));
        assert_within(above.critical_pressure_Pa / above.full_pressure_Pa, 1, 0.07);
        assert_near(above.plastic_full_pressure_Pa, above.full_pressure_Pa, 1e-11);
        for (double x = 1e-12; x < 0.95; x *= 1.5) {
            struct sinusoid_cell first, second;
            const struct sinusoid_fit *thesis = &sinusoid_fits[SINUSOID_FIT_THESIS];
            sinusoid_press(&first, &below, thesis, x * below.full_pressure_Pa, true);
            sinusoid_press(&second, &above, thesis, x * below.full_pressure_Pa, true);
            assert_near(second.area_ratio, first.area_ratio, 1e-11);
            assert_near(second.gap_ratio, first.gap_ratio, 1e-9);
        }
    }
}

/** p = p_c (1 +- 1e-12): the area never falls in either closure; the published steps have their published sizes. */
TEST_CASE(critical_pressure_from_both_sides)
{
    static const struct {
        double ratio, area_step, gap_least, gap_most; /* docs/equations.md, known steps */
    } stated[] = {{1.05, 0.010, -0.21, -0.17}, {1.3, 0.023, -0.145, -0.135},  {2, 0.054, -0.157, -0.15},
                  {5, 0.078, -0.065, -0.06},   {30, 0.055, -0.0016, -0.0014}, {1000, 0.012, -1e-6, 0}};
    for (int y = 0; y < HARD_YIELD_RATIOS; y++)
        for (int n = 0; n < HARD_NUS; n++)
            for (size_t i = 0; i < sizeof stated / sizeof stated[0]; i++)
                for (int closure = 0; closure < SINUSOID_FIT_COUNT; closure++) {
                    struct material_pair pair = hard_pair(hard_yield_ratios[y], hard_nus[n]);
                    double amplitude = stated[i].ratio * sinusoid_critical_amplitude(frequency, &pair);
                    struct sinusoid_scale scale = sinusoid_scale(amplitude, frequency, &pair, true);
                    const struct sinusoid_fit *law = &sinusoid_fits[closure];
                    struct sinusoid_cell below, above;
                    assert_false(sinusoid_press(&below, &scale, law, scale.critical_pressure_Pa * (1 - 1e-12), true));
                    assert_true(sinusoid_press(&above, &scale, law, scale.critical_pressure_Pa * (1 + 1e-12), true));
                    double area_step = above.area_ratio / below.area_ratio - 1;
                    double gap_step = above.gap_ratio / below.gap_ratio - 1;
                    assert_true(area_step >= 0 && gap_step <= 0 && gap_step > -0.3);
                    if (closure != SINUSOID_FIT_THESIS)
                        continue;
                    assert_within(area_step, stated[i].area_step, 0.0027);
                    if (hard_nus[n] > 0.2 && hard_nus[n] < 0.4)
                        assert_within(gap_step, (stated[i].gap_least + stated[i].gap_most) / 2,
                                      (stated[i].gap_most - stated[i].gap_least) / 2 + 0.005);
                }
}

/** The published elastic link steps down at 0.8 from 0.9049 to 0.9045; closure numeric has no such step. */
TEST_CASE(link_at_four_fifths)
{
    for (int closure = 0; closure < SINUSOID_FIT_COUNT; closure++) {
        struct sinusoid_cell below, above;
        elastic(&below, closure, 0.8 * (1 - 1e-12));
        elastic(&above, closure, 0.8 * (1 + 1e-12));
        assert_near(above.gap_ratio, below.gap_ratio, 1e-10);
        if (closure == SINUSOID_FIT_THESIS) {
            assert_within(below.area_ratio, 0.9049, 5e-5);
            assert_within(above.area_ratio, 0.9045, 5e-5);
        } else {
            assert_near(above.area_ratio, below.area_ratio, 1e-11);
        }
    }
}

/** A scale of no amplitude is flat; one of denormal amplitude is a scale like any other. */
TEST_CASE(vanishing_amplitudes)
{
    struct material_pair pair = hard_tin();
    static const double pressures[] = {5e-324, 1e-300, 1, 1e300};
    for (int plastic = 0; plastic < 2; plastic++)
        for (int i = 0; i < 4; i++) {
            struct sinusoid_cell cell;
            struct sinusoid_scale flat = sinusoid_scale(0, frequency, &pair, plastic);
            sinusoid_press(&cell, &flat, &sinusoid_fits[i % 2], pressures[i], true);
            check_cell(&cell);
            assert_true(cell.area_ratio == 1 && cell.gap_ratio == 0);
            struct sinusoid_scale tiny = sinusoid_scale(5e-324, 1, &pair, plastic);
            sinusoid_press(&cell, &tiny, &sinusoid_fits[i % 2], pressures[i], true);
            check_cell(&cell);
            assert_true((cell.area_ratio < 1) == (pressures[i] < tiny.full_pressure_Pa));
        }
}
