/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stacks of scales: extreme power laws, loads over 36 decades, scales that are not there. */
#include "contact/convergence.h"
#include "hard_support.h"

HARD_CASES("Stacks of scales")

enum { EVERYTHING = QUANTITY_BIT(QUANTITY_SEPARATION) | QUANTITY_RESISTANCES };

static struct multiscale make(const struct spectrum *spectrum, const struct material_pair *pair, bool plastic,
                              int closure)
{
    struct multiscale stack = model_support_stack(spectrum, pair, plastic, (enum sinusoid_fit_id)closure);
    assert_true(isfinite(stack.full_load) && stack.full_load >= 0 && stack.closed_load >= stack.full_load);
    return stack;
}

static struct contact_point solve(struct multiscale *stack, const struct constriction *spot, double load)
{
    struct contact_point point;
    uint64_t evaluations = 0;
    multiscale_solve(&point, stack, spot, EVERYTHING, load, &evaluations);
    assert_true(evaluations <= stack->count);
    assert_true(isfinite(point.value[QUANTITY_AREA]) && point.value[QUANTITY_AREA] > 0 &&
                point.value[QUANTITY_AREA] <= 1);
    assert_true(isfinite(point.value[QUANTITY_SEPARATION]) && point.value[QUANTITY_SEPARATION] >= 0);
    for (int q = QUANTITY_ECR; q <= QUANTITY_TCR_SCALE_DEPENDENT; q++) {
        assert_true(isfinite(point.value[q]) && point.value[q] >= 0);
        assert_true((point.value[q] > 0) == (load < stack->full_load));
    }
    assert_true(point.value[QUANTITY_TCR_SCALE_DEPENDENT] >= point.value[QUANTITY_TCR]);
    if (load >= stack->full_load)
        assert_true(point.value[QUANTITY_AREA] == 1);
    if (load >= stack->closed_load * (1 + 1e-12))
        assert_true(point.value[QUANTITY_SEPARATION] == 0);
    return point;
}

/** Every gamma and alpha of the convergence study, 20 000 scales, loads 1e-30 to 1e6. */
TEST_CASE(extreme_power_laws)
{
    struct material_pair pair = model_support_tin();
    struct constriction spot = constriction_make(&pair);
    for (double gamma = 0; gamma <= 2; gamma += 0.25)
        for (double alpha = 1e-3; alpha<2e3; alpha *= HARD_COARSER> 1 ? 1e6 : 100) {
            struct spectrum spectrum = model_support_law(hard_length_m, alpha, gamma, 20000);
            double amplitudes = 0;
            for (size_t i = 0; i < spectrum.count; i++)
                amplitudes += spectrum.amplitude_m[i];
            for (int plastic = 0; plastic < 2; plastic++) {
                struct multiscale stack = make(&spectrum, &pair, plastic, SINUSOID_FIT_THESIS);
                double area = 0, separation = amplitudes * (1 + 1e-12), resistance = INFINITY;
                for (double load = 1e-30; load < 1e7; load *= 1e12) {
                    struct contact_point point = solve(&stack, &spot, load);
                    assert_true(point.value[QUANTITY_AREA] >= area && point.value[QUANTITY_SEPARATION] <= separation);
                    hard_case("20 000 scales, γ = 0 to 2 (γ = 1 too), α = 1e-3 to 1e3, loads of 1e-30 to 1e6",
                              "products of 20 000 areas underflow; sums lose the small ones",
                              "less resistance under more load, always", "rise of resistance",
                              fmax(0, point.value[QUANTITY_ECR] - fmin(resistance, 1e300)), 0);
                    hard_case("the same: area", "no area left after many scales", "never falls, and never 0",
                              "fall of the area", fmax(0, area - point.value[QUANTITY_AREA]), 0);
                    assert_true(point.value[QUANTITY_ECR] <= resistance);
                    area = point.value[QUANTITY_AREA];
                    separation = point.value[QUANTITY_SEPARATION];
                    resistance = point.value[QUANTITY_ECR];
                }
                solve(&stack, &spot, stack.full_load);
                solve(&stack, &spot, stack.full_load * (1 - 1e-12));
            }
        }
}

/** Scales of zero or denormal amplitude inside a spectrum change nothing; a spectrum of nothing else is flat. */
TEST_CASE(absent_scales)
{
    static const double nothing[] = {0, 5e-324, 1e-310};
    struct material_pair pair = model_support_tin();
    struct constriction spot = constriction_make(&pair);
    for (int plastic = 0; plastic < 2; plastic++)
        for (double load = 1e-30; load < 1e7; load *= 1e6) {
            struct contact_point first = {0};
            for (int k = 0; k < 3; k++) {
                struct spectrum spectrum = model_support_law(hard_length_m, 0.085, 1.5, 300);
                for (size_t i = 0; i < spectrum.count; i += 2)
                    spectrum.amplitude_m[i] = nothing[k];
                struct multiscale stack = make(&spectrum, &pair, plastic, SINUSOID_FIT_THESIS);
                struct contact_point point = solve(&stack, &spot, load);
                first = k == 0 ? point : first;
                assert_true(point.value[QUANTITY_AREA] == first.value[QUANTITY_AREA] &&
                            point.value[QUANTITY_SEPARATION] == first.value[QUANTITY_SEPARATION]);
                hard_case("every other scale of amplitude 0, 5e-324 or 1e-310 m", "0/0 and denormal pressures",
                          "they change nothing", "resistance, difference",
                          fabs(point.value[QUANTITY_ECR] - first.value[QUANTITY_ECR]), 0);
                for (size_t i = 1; i < spectrum.count; i += 2)
                    spectrum.amplitude_m[i] = nothing[k];
                stack = make(&spectrum, &pair, plastic, SINUSOID_FIT_THESIS);
                point = solve(&stack, &spot, load);
                hard_case("nothing but scales of 0 or denormal amplitude", "a surface that never closes",
                          "flat: area 1, no resistance", "difference",
                          fabs(point.value[QUANTITY_AREA] - 1) + point.value[QUANTITY_ECR], 0);
                assert_true(point.value[QUANTITY_SEPARATION] < 1e-300);
            }
        }
}

/** The worst steps between neighbouring loads of a curve. */
struct steps {
    double fall, rise; /* of the area downwards, of the separation upwards, relative */
    double largest;    /* of ln area upwards */
    int large;         /* how many of them exceed 1e-3 */
};

static struct steps scan(struct multiscale *stack, int points)
{
    struct steps steps = {0};
    struct material_pair pair = model_support_tin();
    struct constriction spot = constriction_make(&pair);
    struct contact_point before = {0};
    for (int i = 0; i <= points; i++) {
        struct contact_point point;
        uint64_t evaluations = 0;
        double load = 2 * stack->closed_load * exp(((double)i / points - 1) * log(1e8));
        multiscale_solve(&point, stack, &spot, QUANTITY_BIT(QUANTITY_SEPARATION), load, &evaluations);
        if (i > 0) {
            double area_step = point.value[QUANTITY_AREA] / before.value[QUANTITY_AREA] - 1;
            steps.fall = fmax(steps.fall, -area_step);
            steps.largest = fmax(steps.largest, area_step);
            steps.large += area_step > 1e-3;
            if (before.value[QUANTITY_SEPARATION] > 0)
                steps.rise = fmax(steps.rise, point.value[QUANTITY_SEPARATION] / before.value[QUANTITY_SEPARATION] - 1);
        }
        before = point;
    }
    return steps;
}

/** Over 10^5 loads no curve jumps but where a scale's closure does: elastic area by -0.05 % (p/p* = 0.8),
 * elastic-plastic area by at most 7.8 % upwards, once a scale that yields, and separation upwards by a hair. */
TEST_CASE(curves_do_not_jump)
{
    static const double alphas[] = {1e-3, 0.085}, gammas[] = {0.5, 1.5};
    enum { POINTS = 100000 / HARD_COARSER, SCALES = 12 };
    struct material_pair pair = model_support_tin();
    for (int law = 0; law < 2; law++)
        for (int closure = 0; closure < SINUSOID_FIT_COUNT; closure++) {
            struct spectrum spectrum = model_support_law(hard_length_m, alphas[law], gammas[law], SCALES);
            struct multiscale stack = make(&spectrum, &pair, false, closure);
            struct steps coarse = scan(&stack, POINTS / 10), fine = scan(&stack, POINTS / 5);
            assert_true(fine.largest < 0.51 * coarse.largest && fine.rise == 0);
            assert_true(fine.fall <= (closure == SINUSOID_FIT_THESIS ? 5e-4 : 1e-15));

            stack = make(&spectrum, &pair, true, closure);
            fine = scan(&stack, POINTS);
            assert_true(fine.fall <= (closure == SINUSOID_FIT_THESIS ? 5e-4 : 1e-15));
            int yielding = 0;
            for (size_t i = 0; i < SCALES; i++)
                yielding += isfinite(stack.scales[i].critical_pressure_Pa);
            hard_case("100 000 loads of 12 scales: area", "jumps between neighbouring loads",
                      "none but the published step of a scale that starts to yield, once each", "largest step up",
                      fine.largest, 0.0785);
            hard_case("100 000 loads: area downwards", "more load, less area", "only the published step at p/p* = 0.8",
                      "largest step down", fine.fall, 5e-4);
            hard_case("100 000 loads: separation", "planes part under more load",
                      "by a hair, where a scale starts to yield", "rise, relative", fine.rise, 5e-3);
            assert_true(fine.large <= yielding * HARD_COARSER);
        }
}

/** Every cut at area 1, and every raise to the elastic area, is counted. */
TEST_CASE(limits_are_counted)
{
    struct material_pair pair = model_support_tin();
    struct constriction spot = constriction_make(&pair);
    int cut = 0, raised = 0;
    for (double ratio = 0.5; ratio < 1000; ratio *= 1.05)
        for (int closure = 0; closure < SINUSOID_FIT_COUNT; closure++) {
            double amplitude = ratio * sinusoid_critical_amplitude(1 / hard_length_m, &pair);
            struct spectrum spectrum = {&amplitude, 1, hard_length_m, false};
            struct multiscale stack = make(&spectrum, &pair, true, closure);
            const struct sinusoid_scale first = stack.scales[0];
            double modulus = pair.effective_modulus_Pa, critical_load = first.critical_pressure_Pa / modulus;
            const double loads[] = {stack.full_load * 0.9, (stack.full_load + stack.closed_load) / 2, stack.closed_load,
                                    1e6, isfinite(critical_load) ? critical_load * (1 + 1e-9) : 1};
            for (int i = 0; i < 5; i++) {
                struct contact_point point;
                uint64_t evaluations = 0;
                size_t limited = multiscale_solve(&point, &stack, &spot, 0, loads[i], &evaluations);
                struct sinusoid_cell elastic;
                bool yields = loads[i] * modulus > first.critical_pressure_Pa;
                double x = fmin(1, loads[i] * modulus / first.full_pressure_Pa);
                sinusoid_fits[closure].area(&elastic, x);
                bool full = yields && point.value[QUANTITY_AREA] == 1 && loads[i] < stack.closed_load;
                bool floor = yields && closure == SINUSOID_FIT_NUMERIC &&
                             point.value[QUANTITY_AREA] == elastic.area_ratio && point.value[QUANTITY_AREA] < 1;
                hard_case("areas cut at 1 or raised to the elastic one", "numbers are limited and nobody hears of it",
                          "every one is counted for the report", "not counted", limited != (size_t)(full || floor), 0);
                cut += full;
                raised += floor;
            }
        }
    assert_true(cut > 50 && raised > 5);
}

/** The convergence study over its own parameters: areas in (0, 1], never rising from scale to scale. */
TEST_CASE(convergence_study)
{
    enum { SCALES = 2000 };
    static double areas[SCALES];
    struct material_pair pair = model_support_tin();
    const struct convergence_sweep_row *alpha = &convergence_sweeps[CONVERGENCE_ALPHA];
    const struct convergence_sweep_row *gamma = &convergence_sweeps[CONVERGENCE_GAMMA];
    for (size_t a = 0; a < alpha->count; a++)
        for (size_t g = 0; g < gamma->count; g++)
            for (int plastic = 0; plastic < 2; plastic++) {
                struct convergence_law law = {alpha->values[a], gamma->values[g], hard_length_m, 1e-30, SCALES};
                uint64_t evaluations = 0;
                convergence_areas(areas, &law, &pair, plastic, &evaluations);
                for (size_t i = 0; i < SCALES; i++)
                    hard_case("the convergence study, 2000 scales, γ = 1 too",
                              "areas rise from scale to scale, or vanish", "fall to their limit and stay above 0",
                              "wrong areas", !(areas[i] > 0 && areas[i] <= (i > 0 ? areas[i - 1] : 1)), 0);
                double amplitudes_m[10];
                struct spectrum spectrum = {.amplitude_m = amplitudes_m, .count = 10, .length_m = 1e-6};
                for (int n = 1; n <= 10; n++)
                    amplitudes_m[n - 1] = law.alpha * pow(1e-6 / n, law.gamma);
                struct convergence_tail tail = convergence_tail(&spectrum, 10);
                for (double load = 1e-30; load < 1e7; load *= 1e12) {
                    struct convergence_extension out = convergence_extend(&spectrum, &tail, &pair, plastic, load);
                    hard_case(
                        "λ ≪ spacing: the law carried on below the sampling limit", "the sum over scales has no end",
                        "ends at atomic size, or where the area does no longer change; never above the measured one",
                        "rise of the area", fmax(0, out.area_extended - out.area_measured), 0);
                    assert_true(out.area_extended > 0);
                    assert_true(out.area_measured <= 1 && out.scales > 0);
                }
            }
}
