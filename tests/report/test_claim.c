#include "fake_results.h"

static void test_every_claim_holds_for_numbers_made_for_it(void **state)
{
    (void)state;
    struct fake fake;
    make_fake(&fake);
    for (size_t i = 0; i < claim_count; i++)
        assert_verdict(&fake, claim_rows[i].statement, CLAIM_HOLDS, "");
    assert_true(claim_count >= 15);
}

/* A number of one model of one surface, or of all, set to `value`. */
static void set_model(struct fake *fake, size_t offset, double value, bool everywhere)
{
    for (size_t k = 0; k < SURFACES; k++)
        for (int m = 0; m < MODEL_COUNT; m++)
            if (everywhere || (k == 1 && m == MODEL_GW))
                *(double *)((char *)&fake->summaries[k].models[m] + offset) = value;
}

/* Claims that count curves: one curve against them makes "in part", all make "fails", none there "not tested". */
static void test_claims_that_count_curves(void **state)
{
    (void)state;
    static const struct {
        const char *claim;
        size_t offset;
        double bad;
        const char *one;
    } rows[] = {
        {"linear in the load", offsetof(struct curve_summary, area_slope), 0.8,
         "GW 0.800 to 0.950; JG 0.950. 11 of 12 curves"},
        {"linear in the load", offsetof(struct curve_summary, area_slope), 1.2, "11 of 12 curves"},
        {"the elbow", offsetof(struct curve_summary, elbow_load), 1e-3, "GW 1.00 to 50.0"},
        {"between 4 and 12", offsetof(struct curve_summary, beta), 3.9, "11 of 12 lie in 4…12"},
        {"between 4 and 12", offsetof(struct curve_summary, beta), -1, "1 below 0"},
        {"between 4 and 12", offsetof(struct curve_summary, beta), 12.1, "11 of 12 lie in 4…12"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct fake fake;
        make_fake(&fake);
        set_model(&fake, rows[i].offset, rows[i].bad, false);
        assert_verdict(&fake, rows[i].claim, CLAIM_PARTLY, rows[i].one);
        set_model(&fake, rows[i].offset, rows[i].bad, true);
        assert_verdict(&fake, rows[i].claim, CLAIM_FAILS, "");
        set_model(&fake, rows[i].offset, NAN, true);
        set_model(&fake, offsetof(struct curve_summary, full_load), 2, true); /* beyond the loads */
        assert_verdict(&fake, rows[i].claim, CLAIM_NOT_TESTED, "");
    }
}

/* Only the multiscale models are asked: the others are 0 at full contact by the choice of beta. */
static void test_separation_at_full_contact(void **state)
{
    (void)state;
    struct fake fake;
    make_fake(&fake);
    set_model(&fake, offsetof(struct curve_summary, gap_at_full), 0.3, false); /* GW's */
    assert_verdict(&fake, "No separation is left", CLAIM_HOLDS, "0 by the choice of β");
    fake.summaries[1].models[MODEL_MULTISCALE_PLASTIC].gap_at_full = 0.3;
    assert_verdict(&fake, "No separation is left", CLAIM_PARTLY, "0 to 0.30; below 0.01 in 5 of 6 curves");
    set_model(&fake, offsetof(struct curve_summary, gap_at_full), 0.3, true);
    assert_verdict(&fake, "No separation is left", CLAIM_FAILS, "below 0.01 in 0 of 6 curves");
    set_model(&fake, offsetof(struct curve_summary, gap_at_full), NAN, true);
    assert_verdict(&fake, "No separation is left", CLAIM_NOT_TESTED, "");
}

/* A curve that gets to full contact without an elbow counts against it. */
static void test_a_curve_without_an_elbow(void **state)
{
    (void)state;
    struct fake fake;
    make_fake(&fake);
    fake.summaries[0].models[MODEL_JG].elbow_load = NAN;
    assert_verdict(&fake, "the elbow", CLAIM_PARTLY, "in 11 of 12 curves");
    fake.summaries[0].models[MODEL_JG].full_load = 2;
    assert_verdict(&fake, "the elbow", CLAIM_HOLDS, "in 11 of 11 curves");
}

static void test_convergence(void **state)
{
    (void)state;
    struct fake fake;
    make_fake(&fake);
    assert_verdict(&fake, "not on α", CLAIM_HOLDS,
                   "elastic-plastic: settled for 7 of 7 α, 5 of 5 γ ≥ 1 and 0 of 4 γ < 1");
    fake_sweep(&fake, CONVERGENCE_GAMMA, true, 0, true);
    assert_verdict(&fake, "not on α", CLAIM_PARTLY, "1 of 4 γ < 1");
    for (size_t v = 0; v < convergence_sweeps[CONVERGENCE_ALPHA].count; v++)
        for (int plastic = 0; plastic < 2; plastic++)
            fake_sweep(&fake, CONVERGENCE_ALPHA, plastic, v, false);
    for (size_t v = 0; v < 4; v++)
        fake_sweep(&fake, CONVERGENCE_GAMMA, false, v, true);
    assert_verdict(&fake, "not on α", CLAIM_FAILS, "elastic: settled for 0 of 7 α, 5 of 5 γ ≥ 1 and 4 of 4 γ < 1");
}

/* Models that do not exist for a surface count neither way. */
static void test_models_that_do_not_exist_are_left_out(void **state)
{
    (void)state;
    struct fake fake;
    make_fake(&fake);
    set_model(&fake, offsetof(struct curve_summary, area_slope), 0.5, false);
    fake.summaries[1].models[MODEL_GW].exists = false;
    assert_verdict(&fake, "linear in the load", CLAIM_HOLDS, "11 of 11 curves");
}

static void test_scale_dependence(void **state)
{
    (void)state;
    struct fake fake;
    make_fake(&fake);
    assert_verdict(&fake, "Scale dependence", CLAIM_HOLDS, "GW 0.10 to 1.0 %");
    fake.summaries[2].models[MODEL_JG].sd_most = 0.051;
    assert_verdict(&fake, "Scale dependence", CLAIM_FAILS, "JG 0.10 to 5.1 %");
    set_model(&fake, offsetof(struct curve_summary, sd_least), INFINITY, true);
    set_model(&fake, offsetof(struct curve_summary, sd_most), -INFINITY, true);
    assert_verdict(&fake, "Scale dependence", CLAIM_NOT_TESTED, "");
}

static void test_gamma(void **state)
{
    (void)state;
    struct fake fake;
    make_fake(&fake);
    static const char claim[] = "so the area converges";
    assert_verdict(&fake, claim, CLAIM_HOLDS, "for 3 of 3 surfaces; ");
    assert_verdict(&fake, claim, CLAIM_HOLDS, "nothing of the area");
    fake.summaries[2].power_law.gamma = 0.99;
    fake.summaries[2].power_law.gamma_error = 0.02; /* 1 within its error */
    assert_verdict(&fake, claim, CLAIM_HOLDS, "");
    fake.summaries[2].power_law.gamma_error = 0.005;
    fake.summaries[0].models[MODEL_MULTISCALE_ELASTIC].extension =
        (struct convergence_extension){.area_measured = 0.4, .area_extended = 0.3};
    assert_verdict(&fake, claim, CLAIM_PARTLY, "at most 25 %");
    fake.summaries[1].power_law.knee_m = 1e-5; /* then the slope at short wavelengths counts */
    fake.summaries[1].power_law.gamma_below = 0.5;
    assert_verdict(&fake, claim, CLAIM_FAILS, "for 1 of 3 surfaces (judged on 1 of them by the slope");
    for (size_t k = 0; k < SURFACES; k++) {
        fake.summaries[k].power_law.gamma = NAN;
        fake.summaries[k].power_law.knee_m = NAN;
    }
    assert_verdict(&fake, claim, CLAIM_NOT_TESTED, "");

    make_fake(&fake);
    fake.summaries[1].power_law.gamma = 1.7;
    assert_verdict(&fake, "γ falls", CLAIM_PARTLY, "in 1 of 2 pairs");
    fake.summaries[2].power_law.gamma = 1.8;
    assert_verdict(&fake, "γ falls", CLAIM_FAILS, "in 0 of 2 pairs");
    fake.summaries[1].power_law.gamma = NAN;
    assert_verdict(&fake, "γ falls", CLAIM_NOT_TESTED, "");
}

/* Ranks: `counter` of struct comparison_rank against its pairs. */
static void test_ranks(void **state)
{
    (void)state;
    static const struct {
        const char *claim;
        size_t counter;
    } rows[] = {
        {"have the larger area", offsetof(struct comparison_rank, area)},
        {"have the smaller ECR", offsetof(struct comparison_rank, ecr)},
        {"have the smaller TCR", offsetof(struct comparison_rank, tcr)},
        {"is not ranked by roughness", offsetof(struct comparison_rank, separation)},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct fake fake;
        make_fake(&fake);
        bool negated = i == 3; /* holds when the order is mixed */
        for (size_t count = 0; count <= 100; count += 20) {
            for (int m = 0; m < MODEL_COUNT; m++)
                *(size_t *)((char *)&fake.study.rank[m] + rows[i].counter) = count;
            char share[16];
            snprintf(share, sizeof share, "GW %zu %%", count);
            assert_verdict(&fake, rows[i].claim,
                           negated        ? count % 100 == 0 ? CLAIM_FAILS : CLAIM_HOLDS
                           : count == 100 ? CLAIM_HOLDS
                           : count >= 50  ? CLAIM_PARTLY
                                          : CLAIM_FAILS,
                           share);
        }
        for (int m = 0; m < MODEL_COUNT; m++)
            fake.study.rank[m].pairs = 0;
        assert_verdict(&fake, rows[i].claim, CLAIM_NOT_TESTED, "");
    }
}

static void test_plastic_against_elastic(void **state)
{
    (void)state;
    struct fake fake;
    make_fake(&fake);
    fake.study.plastic[1].above = 20;
    assert_verdict(&fake, "Plastic area is above", CLAIM_PARTLY, "not below at 20 of 100 loads");
    fake.study.plastic[0].above = 20;
    assert_verdict(&fake, "Plastic area is above", CLAIM_FAILS, "multiscale: plastic/elastic area 1.10 to 2.00");
    fake.study.plastic[1].sooner = 1;
    assert_verdict(&fake, "at lower loads", CLAIM_PARTLY, "in 4 of 6 pairs");
    fake.study.plastic[0].sooner = 0;
    assert_verdict(&fake, "at lower loads", CLAIM_FAILS, "in 1 of 6 pairs");
    fake.study.plastic[0] = fake.study.plastic[1] = (struct comparison_plastic){0};
    assert_verdict(&fake, "Plastic area is above", CLAIM_NOT_TESTED, "");
    assert_verdict(&fake, "at lower loads", CLAIM_NOT_TESTED, "");

    make_fake(&fake);
    fake.study.extremes[MODEL_JG][COMPARISON_AREA].most = 0.4;
    assert_verdict(&fake, "narrows the spread", CLAIM_PARTLY,
                   ": multiscale elastic 3.00, plastic 2.00; statistical elastic 3.00, plastic 4.00");
    fake.study.extremes[MODEL_MULTISCALE_PLASTIC][COMPARISON_AREA].count = 2; /* the third is past full contact */
    assert_verdict(&fake, "narrows the spread", CLAIM_FAILS, ": statistical elastic 3.00, plastic 4.00");
    fake.study.extremes[MODEL_GW][COMPARISON_AREA].count = 1;
    assert_verdict(&fake, "narrows the spread", CLAIM_NOT_TESTED, "");
}

static void test_the_baseline_and_proportions(void **state)
{
    (void)state;
    struct fake fake;
    make_fake(&fake);
    assert_verdict(&fake, "agree better in ECR", CLAIM_HOLDS, "surface two, mean distance");
    fake.study.gap[1].ecr = 0.6;
    assert_verdict(&fake, "agree better in ECR", CLAIM_PARTLY, "plastic: ECR 0.60, area 0.50 decades");
    fake.study.gap[0] = (struct comparison_gap){NAN, NAN};
    assert_verdict(&fake, "agree better in ECR", CLAIM_FAILS, "curve: plastic: ECR 0.60");
    fake.study.gap[1] = (struct comparison_gap){NAN, NAN};
    assert_verdict(&fake, "agree better in ECR", CLAIM_NOT_TESTED, "");
    fake.study.proportional_error = 1e-3;
    assert_verdict(&fake, "TCR is ECR", CLAIM_FAILS, "0.0010");
    fake.study.proportional_error = NAN;
    assert_verdict(&fake, "TCR is ECR", CLAIM_NOT_TESTED, "");
}

static size_t rows_of_table(const struct fake *fake)
{
    struct text text = {0};
    size_t rows = 0;
    claim_table(&text, &fake->results, &fake->study);
    for (const char *line = text_string(&text); (line = strstr(line, "| **")); line++)
        rows++;
    text_free(&text);
    return rows;
}

/* Only what can be checked with what ran is in the table. */
static void test_the_table_leaves_out_what_did_not_run(void **state)
{
    (void)state;
    struct fake fake;
    make_fake(&fake);
    struct text text = {0};
    claim_table(&text, &fake.results, &fake.study);
    assert_non_null(strstr(text_string(&text), "| 6.3.4 | TCR is ECR in other units | **holds** | "));
    text_free(&text);
    assert_int_equal(rows_of_table(&fake), claim_count);
    fake.results.usable_count = 1;
    size_t single = 0, plain = 0;
    for (size_t i = 0; i < claim_count; i++) {
        single += !claim_rows[i].several;
        plain += claim_rows[i].effects == 0 && !(claim_rows[i].families & SCENE_MODEL_STATISTICAL);
    }
    assert_int_equal(rows_of_table(&fake), single);
    assert_true(single < claim_count);
    fake.results.usable_count = SURFACES;
    fake.plan.running = 0;
    fake.plan.families = SCENE_MODEL_MULTISCALE;
    assert_int_equal(rows_of_table(&fake), plain);
    assert_true(plain >= 3 && plain < claim_count);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_claim_holds_for_numbers_made_for_it),
        cmocka_unit_test(test_claims_that_count_curves),
        cmocka_unit_test(test_separation_at_full_contact),
        cmocka_unit_test(test_a_curve_without_an_elbow),
        cmocka_unit_test(test_convergence),
        cmocka_unit_test(test_models_that_do_not_exist_are_left_out),
        cmocka_unit_test(test_scale_dependence),
        cmocka_unit_test(test_gamma),
        cmocka_unit_test(test_ranks),
        cmocka_unit_test(test_plastic_against_elastic),
        cmocka_unit_test(test_the_baseline_and_proportions),
        cmocka_unit_test(test_the_table_leaves_out_what_did_not_run),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
