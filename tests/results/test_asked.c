/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is known of a surface in the user's units, and what surfaces are ranked by. */
#include "made_up_results.h"
#include "results/asked.h"
#include "support.h"

static struct made_up made;

static int end(void **state)
{
    (void)state;
    made_up_free(&made);
    return 0;
}

/* Of a conductance the ends change places, and what a resistance is at most, it is at least. */
TEST_WITH(a_reciprocal, NULL, end)
{
    static const double bounds[][2] = {{0, 0}, {0, 1e-6}, {1, 0}};
    static const enum known_kind kinds[][2] = {
        {KNOWN_VALUE, KNOWN_VALUE}, {KNOWN_AT_MOST, KNOWN_MORE_THAN}, {KNOWN_MORE_THAN, KNOWN_AT_MOST}};
    made_up_make(&made, NULL);
    const size_t leading = plan_leading_model(&made.plan);
    struct estimate *estimate = &made_up_surface(&made, 1)->models[leading]->estimates[QUANTITY_TCR];
    for (size_t b = 0; b < 3; b++)
        for (int reciprocal = 0; reciprocal < 2; reciprocal++) {
            const struct asked asked = {.quantity = QUANTITY_TCR, .reciprocal = reciprocal, .scale = 2};
            memcpy(estimate->bound, bounds[b], sizeof estimate->bound);
            const struct known known = known_shown(&made.results, &asked, NULL, 1);
            const double si = known_value(&made.results, QUANTITY_TCR, 1).value;
            assert_int_equal(known.kind, kinds[b][reciprocal]);
            assert_near(known.value, reciprocal ? 2 / si : 2 * si, 1e-12);
            assert_true(b > 0 || (known.low < known.value && known.value < known.high));
        }
}

TEST_CASE(digits_are_those_that_an_interval_leaves)
{
    static const struct {
        double low, high;
        bool short_loads;
        int digits;
    } cases[] = {
        {1, 1.43, false, 3}, {1, 1.45, false, 2}, {NAN, 2, false, 2}, {NAN, NAN, false, 3}, {NAN, NAN, true, 2}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_int_equal(known_digits(&(struct known){.kind = KNOWN_VALUE,
                                                      .value = 1.2,
                                                      .low = cases[i].low,
                                                      .high = cases[i].high,
                                                      .short_loads = cases[i].short_loads}),
                         cases[i].digits);
    assert_int_equal(known_digits(&(struct known){.kind = KNOWN_AT_MOST, .value = 1, .low = NAN, .high = 2}), 3);
}

/* Less resistance is better, or more area where no current flows; a surface without an answer comes last. */
TEST_WITH(what_is_less_is_better, NULL, end)
{
    made_up_make(&made, NULL);
    assert_near(results_cost(&made.results, 1, results_criterion(&made.results)), 0.5e-10, 1e-12);
    made_up_free(&made);
    made_up_make_of(&made, made_up_models(), EFFECT_BIT(EFFECT_PLASTICITY), NULL);
    assert_near(results_cost(&made.results, 1, results_criterion(&made.results)), -0.2, 1e-12);
    assert_true(isinf(results_cost(&made.results, 3, results_criterion(&made.results))));
}
