#include "fake_results.h"

static void test_ordered_surfaces(void **state)
{
    (void)state;
    static const double areas[SURFACES][FAKE_MODELS] = {
        {0.04, 0.08, 0.01, 0.02}, {0.02, 0.06, 0.005, 0.015}, {0.01, 0.04, 0.0025, 0.01}};
    struct fake fake;
    make_comparison(&fake, areas);
    for (int m = 0; m < FAKE_MODELS; m++) {
        const struct comparison_model *model = fake_compared(&fake, fake_models[m]);
        assert_true(model->rank.pairs >= 8);
        for (int q = QUANTITY_AREA; q <= QUANTITY_TCR; q++) /* a larger area goes with a smaller gap here */
            assert_int_equal(model->rank.ranked[q], model->rank.pairs);
        const struct comparison_extremes *extremes = &model->extremes[QUANTITY_AREA];
        assert_near(extremes->most / extremes->least, areas[0][m] / areas[2][m], 1e-12);
        assert_true(extremes->most_at == 0 && extremes->least_at == 2 && extremes->count == SURFACES);
        assert_int_equal(model->extremes[QUANTITY_ECR].least_at, 0);
    }
    assert_near(fake.comparison.middle_load, 1e-2, 0);
    assert_near(fake_compared(&fake, "multiscale-plastic")->plastic.most, 4, 1e-12);
    assert_near(fake_compared(&fake, "multiscale-plastic")->plastic.least, 1, 1e-12); /* both full */
    assert_int_equal(fake_compared(&fake, "multiscale-plastic")->plastic.above,
                     fake_compared(&fake, "multiscale-plastic")->plastic.points);
    assert_int_equal(fake_compared(&fake, "jg")->plastic.sooner, SURFACES);
    assert_within(fake.comparison.proportional_error, 0, 1e-14);
    for (int m = 2; m < FAKE_MODELS; m++) { /* baseline, multiscale against statistical: 0.02/0.005, 0.06/0.015 */
        assert_near(fake_compared(&fake, fake_models[m])->gap.area, log10(4), 1e-9);
        assert_near(fake_compared(&fake, fake_models[m])->gap.ecr, log10(4), 1e-9);
    }
    assert_int_equal(fake.comparison.leading, model_named("multiscale-plastic"));
    assert_near(fake.comparison.middle[1].area_ratio, 0.06, 1e-12); /* ten to the (3 - 3) times */
    comparison_free(&fake.comparison);
}

static void test_turned_surfaces(void **state)
{
    (void)state;
    static const double areas[SURFACES][FAKE_MODELS] = {
        {0.01, 0.005, 0.01, 0.005}, {0.02, 0.01, 0.02, 0.01}, {0.04, 0.03, 0.04, 0.03}};
    struct fake fake;
    make_comparison(&fake, areas);
    for (int m = 0; m < FAKE_MODELS; m++) {
        const struct comparison_rank *rank = &fake_compared(&fake, fake_models[m])->rank;
        assert_true(rank->pairs > 0);
        assert_int_equal(rank->ranked[QUANTITY_AREA] + rank->ranked[QUANTITY_ECR], 0);
    }
    assert_true(fake_compared(&fake, "multiscale-plastic")->plastic.above <
                fake_compared(&fake, "multiscale-plastic")->plastic.points / 2);
    comparison_free(&fake.comparison);
}

/* Plastic areas that are alike, or all full, have a spread of 1: as narrow as can be. */
static void test_equal_areas_have_a_spread_of_one(void **state)
{
    (void)state;
    static const double areas[SURFACES][FAKE_MODELS] = {{0.04, 1, 0.01, 1}, {0.02, 1, 0.005, 1}, {0.01, 1, 0.0025, 1}};
    struct fake fake;
    make_comparison(&fake, areas);
    assert_near(fake_compared(&fake, "jg")->extremes[QUANTITY_AREA].least, 1, 0);
    assert_near(fake_compared(&fake, "gw")->extremes[QUANTITY_AREA].most, 0.01, 1e-12);
    comparison_free(&fake.comparison);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ordered_surfaces),
        cmocka_unit_test(test_turned_surfaces),
        cmocka_unit_test(test_equal_areas_have_a_spread_of_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
