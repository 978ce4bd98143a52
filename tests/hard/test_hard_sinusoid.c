/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One scale at its limits: complete contact, no pressure, the critical amplitude and the critical pressure. */
#include "contact/constriction.h"
#include "contact/sinusoid.h"
#include "hard_support.h"

HARD_CASES("One scale, from no pressure to complete contact")

static const double frequency = 1e5;
static const double link_step = 5e-4; /* closure thesis, area at p/p* = 0.8: 0.9049 below, 0.9045 from there on */

static void check_cell(const struct sinusoid_cell *cell)
{
    assert_true(isfinite(cell->area_ratio) && cell->area_ratio > 0 && cell->area_ratio <= 1);
    assert_true(isfinite(cell->area_complement) && cell->area_complement >= 0 && cell->area_complement <= 1);
    hard_case("20 materials, Δ = 1e-12 to 1e12 Δ_c, p = 1e-30 to 1e6 p*, around every border by 1e-12",
              "two closures that disagree about what is left open", "area and open area always make the whole",
              "A + (1 - A) - 1", fabs(cell->area_ratio + cell->area_complement - 1), 3e-16);
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
            hard_case("no pressure: p/p* = 5e-324 to 1e-24", "powers of a denormal number lose their digits",
                      "the area is that of Hertz, in both closures", "area, relative", off_by(cell.area_ratio, hertz),
                      1e-7);
            hard_case("no pressure: the gap", "an amplitude that is a hair above itself, or a negative penetration",
                      "the gap is the whole amplitude", "gap, of the amplitude", fabs(cell.gap_ratio - 1), 1e-12);
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
            hard_case("contact closes: p/p* = 1 - 1e-6 to 1 - 1e-16", "1 - A cancels, and resistance hangs on it",
                      "1 - A is computed for itself, linear in 1 - p/p* to the last digit", "1 - A, relative",
                      off_by(cell.area_complement, slope * (1 - x)), 1e-6);
            assert_true(cell.gap_ratio > 0 && cell.gap_ratio < pow(1 - x, 2.4));
        }
        static const double beyond[] = {1, 1 + 0x1p-52, 1 + 1e-12, 2, 1e6, 1e300, INFINITY};
        for (size_t i = 0; i < sizeof beyond / sizeof beyond[0]; i++) {
            elastic(&cell, closure, beyond[i]);
            hard_case("beyond complete contact: p/p* = 1 to 1e300 and infinite", "areas above 1, gaps below 0, inf",
                      "area 1, gap 0, exactly", "difference",
                      fabs(cell.area_ratio - 1) + cell.area_complement + cell.gap_ratio, 0);
        }
    }
}

/** Psi as A_i -> A_{i-1}: the closed form for small complements, down to denormal ones, and through a whole scale. */
TEST_CASE(alleviation_keeps_its_digits)
{
    for (double rest = 1e-9; rest > 1e-200; rest /= 13) /* Psi = (c/2)^(3/2) (1 + 3c/8 ...) */
        hard_case("a scale all but closed: 1 - A = 1e-9 to 1e-200", "(1 - √A)^1.5 cancels to 0 from 1e-16 on",
                  "Ψ is made of 1 - A, never of A", "Ψ, relative",
                  off_by(constriction_alleviation(1 - rest, rest), rest / 2 * sqrt(rest / 2) * (1 + 0.375 * rest)),
                  1e-14);
    assert_true(constriction_alleviation(1, 0) == 0);
    assert_true(constriction_alleviation(0, 1) == 1);
    struct material_pair pair = model_support_tin();
    for (int closure = 0; closure < SINUSOID_FIT_COUNT; closure++) {
        struct sinusoid_scale scale = sinusoid_scale(1e-9, frequency, &pair, false);
        double previous = 1;
        for (double rest = 1e-3; rest > 4e-16; rest /= 3) {
            double pressure = scale.full_pressure_Pa * (1 - rest);
            struct sinusoid_cell cell;
            sinusoid_press(&cell, &scale, &sinusoid_fits[closure], pressure, false);
            double psi = constriction_alleviation(cell.area_ratio, cell.area_complement);
            double linear = 3 / (4 * M_PI) * (1 - pressure / scale.full_pressure_Pa);
            hard_case("a scale that closes, 1 - p/p* = 1e-3 to 4e-16", "resistance of the last wavelength is noise",
                      "Ψ falls as (1 - p/p*)^1.5 at every pressure", "Ψ, relative", off_by(psi, linear * sqrt(linear)),
                      5e-3);
            assert_true(psi < previous);
            previous = psi;
        }
    }
}

/** Presses a scale from 1e-30 p* to 1e6 p*, past every border by a hair; nothing may fall or rise the wrong way.
 * Returns the largest rise of the gap. */
static double check_scale(const struct sinusoid_scale *scale, int closure)
{
    double full = scale->full_pressure_Pa, critical = scale->critical_pressure_Pa;
    double closed = sinusoid_closed_pressure(scale);
    struct sinusoid_cell cell, before = {.gap_ratio = 1};
    double rise = 0;
    double pressure = full * 1e-30, seams[] = {0.8 * full, full, critical, closed, full * 1e6};
    while (pressure < full * 1e6) {
        bool plastic = sinusoid_press(&cell, scale, &sinusoid_fits[closure], pressure, true);
        check_cell(&cell);
        double allowed = closure == SINUSOID_FIT_THESIS && !plastic ? link_step : 0;
        assert_true(cell.area_ratio >= before.area_ratio * (1 - allowed) - 2e-16);
        rise = fmax(rise, cell.gap_ratio - before.gap_ratio);
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
    return rise;
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
                    double rise = check_scale(&scale, variant / 2);
                    if (y == 0)
                        hard_case("H ≪ E: S_y/E' = 1e-7", "a scale closes at 1e-7 of p* and opens again",
                                  "the gap never rises under more load", "rise of the gap", rise, 0);
                    if (hard_nus[n] == 0.5)
                        hard_case("Poisson's ratio 0.5", "a critical amplitude of 0 or below", "closes as any other",
                                  "rise of the gap", rise, 0);
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
            hard_case("critical amplitude Δ_c (1 ± 1e-12)", "the area jumps where a scale starts to be able to yield",
                      "elastic and elastic-plastic scale are one below p_c", "area, relative",
                      off_by(second.area_ratio, first.area_ratio), 1e-11);
            hard_case("critical amplitude: the gap", "the gap of one closure does not meet the other's",
                      "the same gap on both sides", "gap, relative", off_by(second.gap_ratio, first.gap_ratio), 1e-9);
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
                    hard_case("critical pressure p_c (1 ± 1e-12), 20 materials", "more load, less area",
                              "the area never falls where yielding starts", "fall of the area", fmax(0, -area_step), 0);
                    assert_true(area_step >= 0 && gap_step <= 0 && gap_step > -0.3);
                    if (closure != SINUSOID_FIT_THESIS)
                        continue;
                    hard_case("critical pressure: the published step", "a step that nobody knows of is in the curves",
                              "the step of docs/equations.md and no other", "step of the area against the stated",
                              fabs(area_step - stated[i].area_step), 0.0027);
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
            hard_case("p/p* = 0.8, where two published fits meet", "a larger step than the published one",
                      "0.9049 below, 0.9045 above, as published", "area against 0.9045",
                      fabs(above.area_ratio - 0.9045), 5e-5);
        } else {
            hard_case("p/p* = 0.8 in closure `numeric`", "area falls under more load", "no step", "area, relative",
                      off_by(above.area_ratio, below.area_ratio), 1e-11);
        }
    }
}

/** A scale of no amplitude is flat; one of denormal amplitude is a scale like any other. */
TEST_CASE(vanishing_amplitudes)
{
    struct material_pair pair = model_support_tin();
    static const double pressures[] = {5e-324, 1e-300, 1, 1e300};
    for (int plastic = 0; plastic < 2; plastic++)
        for (int i = 0; i < 4; i++) {
            struct sinusoid_cell cell;
            struct sinusoid_scale flat = sinusoid_scale(0, frequency, &pair, plastic);
            sinusoid_press(&cell, &flat, &sinusoid_fits[i % 2], pressures[i], true);
            check_cell(&cell);
            hard_case("a scale of amplitude 0 at 5e-324 to 1e300 Pa", "0/0 in p/p*", "flat: area 1, gap 0",
                      "difference", fabs(cell.area_ratio - 1) + cell.gap_ratio, 0);
            struct sinusoid_scale tiny = sinusoid_scale(5e-324, 1, &pair, plastic);
            sinusoid_press(&cell, &tiny, &sinusoid_fits[i % 2], pressures[i], true);
            check_cell(&cell);
            hard_case("a scale of amplitude 5e-324 m", "p* is 0 or denormal: area by a division by zero",
                      "a scale like any other: open below its p*, closed from there on", "wrong answers",
                      (cell.area_ratio < 1) != (pressures[i] < tiny.full_pressure_Pa), 0);
        }
}

/** S_y of the size of E and beyond (H > E): nothing yields that elasticity has not closed before. */
TEST_CASE(harder_than_elastic)
{
    static const double ratios[] = {1, 1e3, 1e12};
    for (int r = 0; r < 3; r++)
        for (int n = 0; n < HARD_NUS; n++) {
            struct material_pair pair = hard_pair(ratios[r], hard_nus[n]);
            struct sinusoid_scale plastic = sinusoid_scale(0.1 / frequency, frequency, &pair, true);
            struct sinusoid_scale elastic_only = sinusoid_scale(0.1 / frequency, frequency, &pair, false);
            for (double x = 1e-30; x < 1e30; x *= 10) {
                struct sinusoid_cell first, second;
                const struct sinusoid_fit *thesis = &sinusoid_fits[SINUSOID_FIT_THESIS];
                sinusoid_press(&first, &plastic, thesis, x * plastic.full_pressure_Pa, true);
                sinusoid_press(&second, &elastic_only, thesis, x * plastic.full_pressure_Pa, true);
                check_cell(&first);
                hard_case("H > E: S_y/E' = 1, 1e3, 1e12", "yielding is assumed where nothing yields",
                          "the elastic-plastic scale is the elastic one", "area and gap, difference",
                          fabs(first.area_ratio - second.area_ratio) + fabs(first.gap_ratio - second.gap_ratio), 0);
            }
        }
}
