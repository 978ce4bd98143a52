#include "fake_results.h"
#include "results/directory.h"

enum { LOADS = 6 };

/* A record whose areas, resistances and separations follow from `size` and the load. */
static void put_curves(struct fake *fake, struct surface_store *store, size_t index, const double areas[MODEL_COUNT])
{
    struct surface_record *record = calloc(1, sizeof *record);
    struct status status = {0};
    assert_non_null(record);
    record->summary = fake->summaries[index];
    record->summary.asperities.sigma_m = 1e-6;
    for (int m = 0; m < MODEL_COUNT; m++) {
        struct model_curve *curve = &record->curves[m];
        *curve = (struct model_curve){.exists = true, .count = LOADS, .full_load = model_rows[m].plastic ? 0.1 : 0.2};
        curve->points = calloc(LOADS, sizeof *curve->points);
        assert_non_null(curve->points);
        for (int i = 0; i < LOADS; i++) {
            double area = fmin(1, areas[m] * pow(10, i - 3)), ecr = area < 1 ? 1e-9 / area : 0;
            curve->points[i] = (struct contact_point){.load = pow(10, i - 5),
                                                      .area_ratio = area,
                                                      .ecr_ohm_m2 = ecr,
                                                      .separation_m = 1e-6 / area,
                                                      .adjusted_m = 1e-6 / area,
                                                      .tcr_K_m2_per_W = 2e5 * ecr};
        }
    }
    assert_int_equal(surface_store_put(store, index, record, &status), STATUS_OK);
    surface_record_free(record, false);
    free(record);
}

/* The study of curves made to order: areas in the ratios given, the resistance in inverse proportion. */
static void make_study(struct fake *fake, const double areas[SURFACES][MODEL_COUNT])
{
    struct directory place = directory_make();
    struct status status = {0};
    static const double loads[LOADS] = {1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1};
    make_fake(fake);
    fake->results.loads = loads;
    fake->results.load_count = LOADS;
    fake->plan.pair.resistivity_ohm_m = 1e-7;
    fake->plan.pair.conductivity_W_per_mK = 50; /* 1/(rho k) = 2e5 */
    assert_int_equal(surface_store_open(&fake->store, place.path, SURFACES, &status), STATUS_OK);
    for (size_t k = 0; k < SURFACES; k++)
        put_curves(fake, &fake->store, k, areas[k]);
    assert_int_equal(comparison_make(&fake->study, &fake->results, &status), STATUS_OK);
    surface_store_close(&fake->store);
    directory_remove(&place);
    fake->store = (struct surface_store){.summaries = fake->summaries, .count = SURFACES};
}

static void test_the_study_of_ordered_surfaces(void **state)
{
    (void)state;
    static const double areas[SURFACES][MODEL_COUNT] = {
        {0.04, 0.08, 0.01, 0.02}, {0.02, 0.06, 0.005, 0.015}, {0.01, 0.04, 0.0025, 0.01}};
    struct fake fake;
    make_study(&fake, areas);
    for (int m = 0; m < MODEL_COUNT; m++) {
        const struct comparison_rank *rank = &fake.study.rank[m];
        assert_true(rank->pairs >= 8 && rank->area == rank->pairs && rank->ecr == rank->pairs &&
                    rank->tcr == rank->pairs);
        assert_int_equal(rank->separation, rank->pairs); /* a larger area goes with a smaller gap here */
        const struct comparison_extremes *extremes = &fake.study.extremes[m][COMPARISON_AREA];
        assert_near(extremes->most / extremes->least, areas[0][m] / areas[2][m], 1e-12);
        assert_true(extremes->most_at == 0 && extremes->least_at == 2 && extremes->count == SURFACES);
        assert_int_equal(fake.study.extremes[m][COMPARISON_ECR].least_at, 0);
    }
    assert_near(fake.study.middle_load, 1e-2, 0);
    assert_near(fake.study.plastic[0].most, 4, 1e-12);
    assert_near(fake.study.plastic[0].least, 1, 1e-12); /* both full */
    assert_int_equal(fake.study.plastic[0].above, fake.study.plastic[0].points);
    assert_int_equal(fake.study.plastic[1].sooner, SURFACES);
    assert_within(fake.study.proportional_error, 0, 1e-14);
    for (int law = 0; law < 2; law++) { /* baseline, multiscale against statistical: 0.02/0.005, 0.06/0.015 */
        assert_near(fake.study.gap[law].area, log10(4), 1e-9);
        assert_near(fake.study.gap[law].ecr, log10(4), 1e-9);
    }
    assert_int_equal(fake.study.leading, MODEL_MULTISCALE_PLASTIC);
    assert_near(fake.study.middle[1].area_ratio, 0.06, 1e-12); /* ten to the (3 - 3) times */
    assert_verdict(&fake, "have the larger area", CLAIM_HOLDS, "GW 100 %");
    assert_verdict(&fake, "narrows the spread", CLAIM_HOLDS, "multiscale elastic 4.00, plastic 2.00");
    comparison_free(&fake.study);
}

static void test_the_study_of_turned_surfaces(void **state)
{
    (void)state;
    static const double areas[SURFACES][MODEL_COUNT] = {
        {0.01, 0.005, 0.01, 0.005}, {0.02, 0.01, 0.02, 0.01}, {0.04, 0.03, 0.04, 0.03}};
    struct fake fake;
    make_study(&fake, areas);
    for (int m = 0; m < MODEL_COUNT; m++)
        assert_int_equal(fake.study.rank[m].area + fake.study.rank[m].ecr, 0);
    assert_true(fake.study.plastic[0].above < fake.study.plastic[0].points / 2);
    assert_verdict(&fake, "have the larger area", CLAIM_FAILS, "GW 0 %");
    assert_verdict(&fake, "have the smaller ECR", CLAIM_FAILS, "JG 0 %");
    assert_verdict(&fake, "Plastic area is above", CLAIM_FAILS, "");
    assert_verdict(&fake, "narrows the spread", CLAIM_FAILS, "multiscale elastic 4.00, plastic 6.00");
    comparison_free(&fake.study);
}

/* Plastic areas that are alike, or all full, have a spread of 1: as narrow as can be. */
static void test_equal_areas_have_a_spread_of_one(void **state)
{
    (void)state;
    static const double areas[SURFACES][MODEL_COUNT] = {{0.04, 1, 0.01, 1}, {0.02, 1, 0.005, 1}, {0.01, 1, 0.0025, 1}};
    struct fake fake;
    make_study(&fake, areas);
    assert_near(fake.study.extremes[MODEL_JG][COMPARISON_AREA].least, 1, 0);
    assert_near(fake.study.extremes[MODEL_GW][COMPARISON_AREA].most, 0.01, 1e-12);
    assert_verdict(&fake, "narrows the spread", CLAIM_HOLDS, "statistical elastic 4.00, plastic 1.00");
    comparison_free(&fake.study);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_study_of_ordered_surfaces),
        cmocka_unit_test(test_the_study_of_turned_surfaces),
        cmocka_unit_test(test_equal_areas_have_a_spread_of_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
