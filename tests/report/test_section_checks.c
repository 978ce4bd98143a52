/* The findings of the thesis's chapter 6 as the report's section checks them, on results made up to order. */
#include "report/section.h"
#include "results/fake_results.h"

enum { CHECKS = 17, LINE = 1000 };

/** The section as Markdown. */
static struct text section_of(const struct fake *fake)
{
    struct text text = {0};
    const struct section_context context = {.results = &fake->results, .comparison = &fake->comparison};
    section_checks.write(&text, &context);
    return text;
}

/** The table's row whose finding has these words; false: it is not in the table. */
static bool find_row(char row[LINE], const struct fake *fake, const char *claim)
{
    struct text text = section_of(fake);
    bool found = false;
    for (const char *line = text_string(&text), *end; (end = strchr(line, '\n')); line = end + 1) {
        const char *words = strstr(line, claim), *verdict = strstr(line, " | **");
        if (!words || words > end || !verdict || verdict > end || words > verdict)
            continue;
        assert_false(found);
        assert_true(end - line < LINE);
        snprintf(row, LINE, "%.*s", (int)(end - line), line);
        found = true;
    }
    text_free(&text);
    return found;
}

static size_t rows_of_table(const struct fake *fake)
{
    struct text text = section_of(fake);
    size_t rows = 0;
    for (const char *line = text_string(&text); (line = strstr(line, " | **")); line++)
        rows++;
    text_free(&text);
    return rows;
}

/** Asserts the verdict ("holds", "in part", "fails", "not tested") and that the evidence says `evidence`. */
static void assert_verdict(const struct fake *fake, const char *claim, const char *verdict, const char *evidence)
{
    char row[LINE], expected[40];
    size_t bars = 0;
    if (!find_row(row, fake, claim))
        fail_msg("no finding '%s'", claim);
    for (const char *c = row; *c; c++)
        bars += *c == '|';
    assert_int_equal(bars, 5); /* four cells, none broken by what is in it */
    snprintf(expected, sizeof expected, " | **%s** | ", verdict);
    const char *cell = strstr(row, expected);
    if (!cell || !strstr(cell + strlen(expected) - 1, evidence))
        fail_msg("'%s' is not %s with '%s'", row, verdict, evidence);
}

static void test_every_finding_holds_for_numbers_made_for_it(void **state)
{
    (void)state;
    struct fake fake;
    make_fake(&fake);
    struct text text = section_of(&fake);
    size_t hold = 0;
    for (const char *line = text_string(&text); (line = strstr(line, "| **holds** | ")); line++)
        hold++;
    text_free(&text);
    assert_int_equal(hold, CHECKS);
    assert_int_equal(rows_of_table(&fake), CHECKS);
}

/* A number of one model of one surface, or of all, set to `value`. */
static void set_model(struct fake *fake, size_t offset, double value, bool everywhere)
{
    for (size_t k = 0; k < SURFACES; k++)
        for (int m = 0; m < FAKE_MODELS; m++)
            if (everywhere || (k == 1 && strcmp(fake_models[m], "gw") == 0))
                *(double *)((char *)fake_curve(fake, k, fake_models[m]) + offset) = value;
}

/* Findings that count curves: one curve against them makes "in part", all make "fails", none there "not tested". */
static void test_findings_that_count_curves(void **state)
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
        assert_verdict(&fake, rows[i].claim, "in part", rows[i].one);
        set_model(&fake, rows[i].offset, rows[i].bad, true);
        assert_verdict(&fake, rows[i].claim, "fails", "");
        set_model(&fake, rows[i].offset, NAN, true);
        set_model(&fake, offsetof(struct curve_summary, full_load), 2, true); /* beyond the loads */
        assert_verdict(&fake, rows[i].claim, "not tested", "");
    }
}

/* Only the multiscale models are asked: the others are 0 at full contact by the choice of beta. */
static void test_separation_at_full_contact(void **state)
{
    (void)state;
    struct fake fake;
    make_fake(&fake);
    set_model(&fake, offsetof(struct curve_summary, gap_at_full), 0.3, false); /* GW's */
    assert_verdict(&fake, "No separation is left", "holds", "0 by the choice of β");
    fake_curve(&fake, 1, "multiscale-plastic")->gap_at_full = 0.3;
    assert_verdict(&fake, "No separation is left", "in part", "0 to 0.30; below 0.01 in 5 of 6 curves");
    set_model(&fake, offsetof(struct curve_summary, gap_at_full), 0.3, true);
    assert_verdict(&fake, "No separation is left", "fails", "below 0.01 in 0 of 6 curves");
    set_model(&fake, offsetof(struct curve_summary, gap_at_full), NAN, true);
    assert_verdict(&fake, "No separation is left", "not tested", "");
}

/* A curve that gets to full contact without an elbow counts against it. */
static void test_a_curve_without_an_elbow(void **state)
{
    (void)state;
    struct fake fake;
    make_fake(&fake);
    fake_curve(&fake, 0, "jg")->elbow_load = NAN;
    assert_verdict(&fake, "the elbow", "in part", "in 11 of 12 curves");
    fake_curve(&fake, 0, "jg")->full_load = 2;
    assert_verdict(&fake, "the elbow", "holds", "in 11 of 11 curves");
}

static void test_convergence(void **state)
{
    (void)state;
    struct fake fake;
    make_fake(&fake);
    assert_verdict(&fake, "not on α", "holds", "elastic-plastic: settled for 7 of 7 α, 5 of 5 γ ≥ 1 and 0 of 4 γ < 1");
    fake_sweep(&fake, CONVERGENCE_GAMMA, "multiscale-plastic", 0, true);
    assert_verdict(&fake, "not on α", "in part", "1 of 4 γ < 1");
    for (size_t v = 0; v < convergence_sweeps[CONVERGENCE_ALPHA].count; v++)
        for (int m = 0; m < 2; m++)
            fake_sweep(&fake, CONVERGENCE_ALPHA, fake_models[m], v, false);
    for (size_t v = 0; v < 4; v++)
        fake_sweep(&fake, CONVERGENCE_GAMMA, "multiscale-elastic", v, true);
    assert_verdict(&fake, "not on α", "fails", "elastic: settled for 0 of 7 α, 5 of 5 γ ≥ 1 and 4 of 4 γ < 1");
}

/* Models that do not exist for a surface count neither way. */
static void test_models_that_do_not_exist_are_left_out(void **state)
{
    (void)state;
    struct fake fake;
    make_fake(&fake);
    set_model(&fake, offsetof(struct curve_summary, area_slope), 0.5, false);
    fake_curve(&fake, 1, "gw")->exists = false;
    assert_verdict(&fake, "linear in the load", "holds", "11 of 11 curves");
}

static void test_scale_dependence(void **state)
{
    (void)state;
    struct fake fake;
    make_fake(&fake);
    assert_verdict(&fake, "Scale dependence", "holds", "GW 0.10 to 1.0 %");
    fake_curve(&fake, 2, "jg")->sd_most = 0.051;
    assert_verdict(&fake, "Scale dependence", "fails", "JG 0.10 to 5.1 %");
    set_model(&fake, offsetof(struct curve_summary, sd_least), INFINITY, true);
    set_model(&fake, offsetof(struct curve_summary, sd_most), -INFINITY, true);
    assert_verdict(&fake, "Scale dependence", "not tested", "");
}

static void test_gamma(void **state)
{
    (void)state;
    struct fake fake;
    make_fake(&fake);
    static const char claim[] = "so the area converges";
    assert_verdict(&fake, claim, "holds", "for 3 of 3 surfaces; ");
    assert_verdict(&fake, claim, "holds", "nothing of the area");
    fake.summaries[2].power_law.gamma = 0.99;
    fake.summaries[2].power_law.gamma_error = 0.02; /* 1 within its error */
    assert_verdict(&fake, claim, "holds", "");
    fake.summaries[2].power_law.gamma_error = 0.005;
    fake_curve(&fake, 0, "multiscale-elastic")->extension =
        (struct convergence_extension){.area_measured = 0.4, .area_extended = 0.3};
    assert_verdict(&fake, claim, "in part", "at most 25 %");
    fake.summaries[1].power_law.knee_m = 1e-5; /* then the slope at short wavelengths counts */
    fake.summaries[1].power_law.gamma_below = 0.5;
    assert_verdict(&fake, claim, "fails", "for 1 of 3 surfaces (judged on 1 of them by the slope");
    for (size_t k = 0; k < SURFACES; k++) {
        fake.summaries[k].power_law.gamma = NAN;
        fake.summaries[k].power_law.knee_m = NAN;
    }
    assert_verdict(&fake, claim, "not tested", "");

    make_fake(&fake);
    fake.summaries[1].power_law.gamma = 1.7;
    assert_verdict(&fake, "γ falls", "in part", "in 1 of 2 pairs");
    fake.summaries[2].power_law.gamma = 1.8;
    assert_verdict(&fake, "γ falls", "fails", "in 0 of 2 pairs");
    fake.summaries[1].power_law.gamma = NAN;
    assert_verdict(&fake, "γ falls", "not tested", "");
}

/* Ranks: comparison_rank.ranked of the quantity against its pairs. */
static void test_ranks(void **state)
{
    (void)state;
    static const struct {
        const char *claim;
        enum quantity quantity;
    } rows[] = {
        {"have the larger area", QUANTITY_AREA},
        {"have the smaller ECR", QUANTITY_ECR},
        {"have the smaller TCR", QUANTITY_TCR},
        {"is not ranked by roughness", QUANTITY_SEPARATION},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct fake fake;
        make_fake(&fake);
        bool negated = i == 3; /* holds when the order is mixed */
        for (size_t count = 0; count <= 100; count += 20) {
            for (int m = 0; m < FAKE_MODELS; m++)
                fake_compared(&fake, fake_models[m])->rank.ranked[rows[i].quantity] = count;
            char share[16];
            snprintf(share, sizeof share, "GW %zu %%", count);
            assert_verdict(&fake, rows[i].claim,
                           negated        ? count % 100 == 0 ? "fails" : "holds"
                           : count == 100 ? "holds"
                           : count >= 50  ? "in part"
                                          : "fails",
                           share);
        }
        for (int m = 0; m < FAKE_MODELS; m++)
            fake_compared(&fake, fake_models[m])->rank.pairs = 0;
        assert_verdict(&fake, rows[i].claim, "not tested", "");
    }
}

static void test_plastic_against_elastic(void **state)
{
    (void)state;
    struct fake fake;
    make_fake(&fake);
    fake_compared(&fake, "jg")->plastic.above = 20;
    assert_verdict(&fake, "Plastic area is above", "in part", "not below at 20 of 100 loads");
    fake_compared(&fake, "multiscale-plastic")->plastic.above = 20;
    assert_verdict(&fake, "Plastic area is above", "fails", "multiscale: plastic/elastic area 1.10 to 2.00");
    fake_compared(&fake, "jg")->plastic.sooner = 1;
    assert_verdict(&fake, "at lower loads", "in part", "in 4 of 6 pairs");
    fake_compared(&fake, "multiscale-plastic")->plastic.sooner = 0;
    assert_verdict(&fake, "at lower loads", "fails", "in 1 of 6 pairs");
    fake_compared(&fake, "multiscale-plastic")->plastic = fake_compared(&fake, "jg")->plastic =
        (struct comparison_plastic){0};
    assert_verdict(&fake, "Plastic area is above", "not tested", "");
    assert_verdict(&fake, "at lower loads", "not tested", "");

    make_fake(&fake);
    fake_compared(&fake, "jg")->extremes[QUANTITY_AREA].most = 0.4;
    assert_verdict(&fake, "narrows the spread", "in part",
                   ": multiscale elastic 3.00, plastic 2.00; statistical elastic 3.00, plastic 4.00");
    fake_compared(&fake, "multiscale-plastic")->extremes[QUANTITY_AREA].count = 2; /* the third is past full contact */
    assert_verdict(&fake, "narrows the spread", "fails", ": statistical elastic 3.00, plastic 4.00");
    fake_compared(&fake, "gw")->extremes[QUANTITY_AREA].count = 1;
    assert_verdict(&fake, "narrows the spread", "not tested", "");
}

static void test_the_baseline_and_proportions(void **state)
{
    (void)state;
    struct fake fake;
    make_fake(&fake);
    assert_verdict(&fake, "agree better in ECR", "holds", "surface two, mean distance");
    fake_compared(&fake, "jg")->gap.ecr = 0.6;
    assert_verdict(&fake, "agree better in ECR", "in part", "plastic: ECR 0.60, area 0.50 decades");
    fake_compared(&fake, "gw")->gap = (struct comparison_gap){NAN, NAN};
    assert_verdict(&fake, "agree better in ECR", "fails", "curve: plastic: ECR 0.60");
    fake_compared(&fake, "jg")->gap = (struct comparison_gap){NAN, NAN};
    assert_verdict(&fake, "agree better in ECR", "not tested", "");
    fake.comparison.proportional_error = 1e-3;
    assert_verdict(&fake, "TCR is ECR", "fails", "0.0010");
    fake.comparison.proportional_error = NAN;
    assert_verdict(&fake, "TCR is ECR", "not tested", "");
}

/* What each finding needs, by the contract: effects, models, and whether it holds surfaces against each other. */
static const struct {
    const char *claim;
    unsigned effects;
    bool scales, asperities, several;
} needs[CHECKS] = {
    {"Whether the area converges", EFFECT_BIT(EFFECT_CONVERGENCE), true, false, false},
    {"so the area converges", 0, true, false, false},
    {"The area is linear in the load", 0, false, false, false},
    {"Plastic area is above elastic area", EFFECT_BIT(EFFECT_PLASTICITY), false, false, false},
    {"No separation is left at full contact", EFFECT_BIT(EFFECT_SEPARATION), true, false, false},
    {"(the elbow)", EFFECT_BIT(EFFECT_ELECTRICAL), false, false, false},
    {"agree better in ECR than in area", EFFECT_BIT(EFFECT_ELECTRICAL), true, true, false},
    {"TCR is ECR in other units", EFFECT_BIT(EFFECT_ELECTRICAL) | EFFECT_BIT(EFFECT_THERMAL), false, false, false},
    {"Scale dependence is negligible", EFFECT_BIT(EFFECT_SCALE_DEPENDENT), false, false, false},
    {"γ falls as roughness rises", 0, false, false, true},
    {"Smoother surfaces have the larger area", 0, false, false, true},
    {"Plasticity narrows the spread", EFFECT_BIT(EFFECT_PLASTICITY), false, false, true},
    {"Plastic models reach full contact", EFFECT_BIT(EFFECT_PLASTICITY), false, false, false},
    {"is not ranked by roughness", EFFECT_BIT(EFFECT_SEPARATION), false, false, true},
    {"β lies between 4 and 12", EFFECT_BIT(EFFECT_SEPARATION), false, true, false},
    {"Smoother surfaces have the smaller ECR", EFFECT_BIT(EFFECT_ELECTRICAL), false, false, true},
    {"Smoother surfaces have the smaller TCR", EFFECT_BIT(EFFECT_THERMAL), false, false, true},
};

/* Only what can be checked with what ran is in the table. */
static void test_the_table_leaves_out_what_did_not_run(void **state)
{
    (void)state;
    static const char *const families[] = {"multiscale", "statistical", NULL};
    struct fake fake;
    make_fake(&fake);
    const uint64_t all = fake.plan.models;
    for (unsigned running = 0; running < 1u << EFFECT_COUNT; running++)
        for (size_t f = 0; f < 3; f++)
            for (size_t surfaces = 1; surfaces <= SURFACES; surfaces += SURFACES - 1) {
                bool scales = f != 1, asperities = f != 0;
                if (!scales && (running & EFFECT_BIT(EFFECT_CONVERGENCE)))
                    continue; /* no plan is so */
                fake.plan.running = running;
                fake.plan.wanted = quantity_wanted(running);
                fake.plan.models = families[f] ? all & model_find(families[f]) : all;
                fake.results.usable_count = surfaces;
                size_t expected = 0;
                for (size_t i = 0; i < CHECKS; i++) {
                    char row[LINE];
                    bool called_for = !(needs[i].effects & ~running) && (scales || !needs[i].scales) &&
                                      (asperities || !needs[i].asperities) && (surfaces > 1 || !needs[i].several);
                    if (find_row(row, &fake, needs[i].claim) != called_for)
                        fail_msg("'%s', effects %x, family %zu, surfaces %zu", needs[i].claim, running, f, surfaces);
                    expected += called_for;
                }
                assert_int_equal(rows_of_table(&fake), expected);
            }
}

/* The table of a comparison of curves, not of made-up figures. */
static void test_findings_on_curves(void **state)
{
    (void)state;
    static const double ordered[SURFACES][FAKE_MODELS] = {
        {0.04, 0.08, 0.01, 0.02}, {0.02, 0.06, 0.005, 0.015}, {0.01, 0.04, 0.0025, 0.01}};
    static const double turned[SURFACES][FAKE_MODELS] = {
        {0.01, 0.005, 0.01, 0.005}, {0.02, 0.01, 0.02, 0.01}, {0.04, 0.03, 0.04, 0.03}};
    static const double full[SURFACES][FAKE_MODELS] = {{0.04, 1, 0.01, 1}, {0.02, 1, 0.005, 1}, {0.01, 1, 0.0025, 1}};
    struct fake fake;
    make_comparison(&fake, ordered);
    assert_verdict(&fake, "have the larger area", "holds", "GW 100 %");
    assert_verdict(&fake, "narrows the spread", "holds", "multiscale elastic 4.00, plastic 2.00");
    comparison_free(&fake.comparison);
    make_comparison(&fake, turned);
    assert_verdict(&fake, "have the larger area", "fails", "GW 0 %");
    assert_verdict(&fake, "have the smaller ECR", "fails", "JG 0 %");
    assert_verdict(&fake, "Plastic area is above", "fails", "");
    assert_verdict(&fake, "narrows the spread", "fails", "multiscale elastic 4.00, plastic 6.00");
    comparison_free(&fake.comparison);
    make_comparison(&fake, full);
    assert_verdict(&fake, "narrows the spread", "holds", "statistical elastic 4.00, plastic 1.00");
    comparison_free(&fake.comparison);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_finding_holds_for_numbers_made_for_it),
        cmocka_unit_test(test_findings_that_count_curves),
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
        cmocka_unit_test(test_findings_on_curves),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
