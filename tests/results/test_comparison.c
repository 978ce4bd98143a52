/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fake_results.h"

TEST_CASE(test_ordered_surfaces)
{
    static const double areas[SURFACES][FAKE_MODELS] = {
        {0.04, 0.08, 0.01, 0.02}, {0.02, 0.06, 0.005, 0.015}, {0.01, 0.04, 0.0025, 0.01}};
    struct fake fake;
    make_comparison(&fake, areas);
    for (int m = 0; m < FAKE_MODELS; m++) {
        const struct comparison_model *model = fake_compared(&fake, fake_models[m]);
        for (int q = QUANTITY_AREA; q <= QUANTITY_TCR; q++) { /* a larger area goes with a smaller gap here */
            if (q == QUANTITY_ADJUSTED && !model_rows[model_named(fake_models[m])]->asperity_model)
                continue;
            assert_true(model->rank[q].agreeing >= 8);
            assert_int_equal(model->rank[q].opposed + model->rank[q].ties, 0);
        }
        const struct comparison_extremes *extremes = &model->extremes[QUANTITY_AREA];
        assert_near(extremes->most / extremes->least, areas[0][m] / areas[2][m], 1e-12);
        assert_true(extremes->most_at == 0 && extremes->least_at == 2 && extremes->count == SURFACES);
        assert_int_equal(model->extremes[QUANTITY_ECR].least_at, 0);
    }
    assert_near(fake.comparison.middle_load, 1e-2, 0);
    assert_near(fake_compared(&fake, "multiscale-plastic")->plastic.most, 4, 1e-12);
    assert_near(fake_compared(&fake, "multiscale-plastic")->plastic.least, 2, 1e-12); /* the load at which both are full
                                                                                          says nothing */
    for (int q = QUANTITY_AREA; q <= QUANTITY_ECR; q++) {
        const struct comparison_tally *changes = &fake_compared(&fake, "multiscale-plastic")->plastic.changes[q];
        if (q == QUANTITY_ADJUSTED)
            continue;
        assert_true(changes->agreeing >= 12 && changes->opposed == 0 && changes->ties == 0);
    }
    assert_int_equal(fake_compared(&fake, "jg")->plastic.sooner.agreeing, SURFACES);
    assert_within(fake.comparison.proportional_error, 0, 1e-14);
    for (int m = 2; m < FAKE_MODELS; m++)
        for (size_t k = 0; k < SURFACES; k++) { /* multiscale against statistical: 0.02/0.005, 0.06/0.015, … */
            const struct comparison_gap *gap = &fake_compared(&fake, fake_models[m])->gaps[k];
            assert_near(gap->area, log10(areas[k][m - 2] / areas[k][m]), 1e-9);
            assert_near(gap->ecr, log10(areas[k][m - 2] / areas[k][m]), 1e-9);
            assert_true(gap->adjusted > gap->plain); /* 2/A here, against 1/A */
        }
    for (int m = 0; m < FAKE_MODELS; m++) { /* R goes with 1/A */
        const double *steps = fake_compared(&fake, fake_models[m])->steps;
        assert_near(steps[0], log10(areas[0][m] / areas[1][m]), 1e-9);
        assert_near(steps[1], log10(areas[1][m] / areas[2][m]), 1e-9);
    }
    assert_int_equal(fake.comparison.leading, model_named("multiscale-plastic"));
    assert_near(comparison_middle(&fake.results, fake.comparison.leading, 1).value[QUANTITY_AREA], 0.06,
                1e-12); /* ten to the (3 - 3) times */
    comparison_free(&fake.comparison);
}

TEST_CASE(test_turned_surfaces)
{
    static const double areas[SURFACES][FAKE_MODELS] = {
        {0.01, 0.005, 0.01, 0.005}, {0.02, 0.01, 0.02, 0.01}, {0.04, 0.03, 0.04, 0.03}};
    struct fake fake;
    make_comparison(&fake, areas);
    for (int m = 0; m < FAKE_MODELS; m++) {
        const struct comparison_tally *rank = fake_compared(&fake, fake_models[m])->rank;
        assert_true(rank[QUANTITY_AREA].opposed > 0 && rank[QUANTITY_ECR].opposed > 0);
        assert_int_equal(rank[QUANTITY_AREA].agreeing + rank[QUANTITY_ECR].agreeing, 0);
    }
    const struct comparison_tally *changes =
        &fake_compared(&fake, "multiscale-plastic")->plastic.changes[QUANTITY_AREA];
    assert_true(changes->agreeing == 0 && changes->opposed > 0);
    comparison_free(&fake.comparison);
}

/* Plastic areas that are alike, or all full, have a spread of 1: as narrow as can be. */
TEST_CASE(test_equal_areas_have_a_spread_of_one)
{
    static const double areas[SURFACES][FAKE_MODELS] = {{0.04, 1, 0.01, 1}, {0.02, 1, 0.005, 1}, {0.01, 1, 0.0025, 1}};
    struct fake fake;
    make_comparison(&fake, areas);
    assert_near(fake_compared(&fake, "jg")->extremes[QUANTITY_AREA].least, 1, 0);
    assert_near(fake_compared(&fake, "gw")->extremes[QUANTITY_AREA].most, 0.01, 1e-12);
    comparison_free(&fake.comparison);
}

/* Equal curves, or ones that differ by less than the tolerance, speak for neither side. */
TEST_CASE(test_ties_are_counted_apart)
{
    static const double areas[SURFACES][FAKE_MODELS] = {
        {0.02, 0.02, 0.02, 0.02 * (1 + 1e-9)}, {0.02 * (1 + 1e-9), 0.02, 0.02, 0.02}, {0.02, 0.02, 0.02, 0.02}};
    struct fake fake;
    make_fake(&fake);
    comparison_of(&fake, areas, 1e-6);
    for (int m = 0; m < FAKE_MODELS; m++)
        for (int q = QUANTITY_AREA; q <= QUANTITY_TCR; q++) {
            const struct comparison_tally *rank = &fake_compared(&fake, fake_models[m])->rank[q];
            assert_int_equal(rank->agreeing + rank->opposed, 0);
            assert_true(rank->ties > 0 || q == QUANTITY_ADJUSTED);
        }
    const struct comparison_plastic *plastic = &fake_compared(&fake, "multiscale-plastic")->plastic;
    assert_int_equal(plastic->changes[QUANTITY_AREA].agreeing + plastic->changes[QUANTITY_AREA].opposed, 0);
    assert_true(plastic->changes[QUANTITY_AREA].ties > 0);
    comparison_free(&fake.comparison);
    comparison_of(&fake, areas, 1e-12);
    assert_true(fake_compared(&fake, "multiscale-elastic")->rank[QUANTITY_AREA].opposed > 0);
    comparison_free(&fake.comparison);
}

/* The spread counts loads at which every surface is in partial contact: the fourth load is full on the first. */
TEST_CASE(test_spreads)
{
    static const double areas[SURFACES][FAKE_MODELS] = {
        {0.1, 0.4, 0.02, 0.02}, {0.2, 0.5, 0.04, 0.04}, {0.4, 0.8, 0.02, 0.02}};
    static const double full[SURFACES][FAKE_MODELS] = {
        {1e5, 1e5, 1e5, 1e5}, {1e5, 1e5, 1e5, 1e5}, {1e5, 1e5, 1e5, 1e5}};
    struct fake fake;
    make_comparison(&fake, areas);
    const struct comparison_model *elastic = fake_compared(&fake, "multiscale-elastic"),
                                  *plastic = fake_compared(&fake, "multiscale-plastic");
    for (int of = 0; of < COMPARISON_SPREADS; of++) {
        assert_near(comparison_mean_spread(&fake.results, elastic, plastic, (enum comparison_spread)of), log10(4),
                    1e-9);
        assert_near(comparison_mean_spread(&fake.results, plastic, elastic, (enum comparison_spread)of), log10(2),
                    1e-9);
        assert_near(comparison_largest_spread(&fake.results, elastic, (enum comparison_spread)of), 4, 1e-9);
    }
    comparison_free(&fake.comparison);
    make_comparison(&fake, full);
    assert_true(isnan(comparison_largest_spread(&fake.results, &fake.comparison.models[0], COMPARISON_AREAS)));
    for (int m = 0; m < FAKE_MODELS; m++) { /* nothing compared at full contact */
        const struct comparison_model *model = fake_compared(&fake, fake_models[m]);
        assert_int_equal(model->rank[QUANTITY_AREA].agreeing + model->rank[QUANTITY_AREA].ties, 0);
        assert_int_equal(model->plastic.changes[QUANTITY_AREA].ties, 0);
        assert_true(isnan(model->steps[0]));
    }
    comparison_free(&fake.comparison);
}

/* ECR of the leading strip over that of Gaussian heights of the same material law; nothing where one has no ECR or does
 * not run, or where no strip leads. */
TEST_CASE(test_heights_factor)
{
    static const char *const names[] = {"strip", "corrected-persson", "strip-plastic", "corrected-persson-plastic"};
    static const double ecr[] = {6e-9, 2e-9, 5e-9, 4e-9};
    struct fake fake;
    make_fake(&fake);
    assert_true(isnan(comparison_heights_factor(&fake.results, 1))); /* multiscale leads */
    for (int i = 0; i < 4; i++) {
        struct curve_summary *curve = fake_curve(&fake, 1, names[i]);
        curve->exists = true;
        curve->operating = quantity_nothing();
        curve->operating.value[QUANTITY_ECR] = ecr[i];
        fake.plan.models |= i < 2 ? MODEL_BIT(model_named(names[i])) : 0;
    }
    assert_near(comparison_heights_factor(&fake.results, 1), 3, 1e-12);
    assert_true(isnan(comparison_heights_factor(&fake.results, 0))); /* has no strip */
    fake.plan.models |= MODEL_BIT(model_named("strip-plastic"));
    assert_true(isnan(comparison_heights_factor(&fake.results, 1))); /* its counterpart does not run */
    fake.plan.models |= MODEL_BIT(model_named("corrected-persson-plastic"));
    assert_near(comparison_heights_factor(&fake.results, 1), 1.25, 1e-12);
    fake_curve(&fake, 1, "strip-plastic")->exists = false;
    assert_true(isnan(comparison_heights_factor(&fake.results, 1)));
}
