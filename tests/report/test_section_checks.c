/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The findings of the thesis's chapter 6 as the report's section checks them, on results made up to order. */
#include "report/section.h"
#include "results/fake_results.h"

enum { CHECKS = 26, LINE = 1000 };

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

TEST_CASE(test_every_finding_holds_for_numbers_made_for_it)
{
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
TEST_CASE(test_findings_that_count_curves)
{
    static const struct {
        const char *claim;
        size_t offset;
        double bad;
        const char *one;
    } rows[] = {
        {"linear in the load", offsetof(struct curve_summary, area_slope), 0.8,
         "GW 0.800 to 0.950; JG 0.950. 11 of 12 curves"},
        {"linear in the load", offsetof(struct curve_summary, area_slope), 1.2, "11 of 12 curves"},
        {"the elbow", offsetof(struct curve_summary, elbow_load), 1.5e-3, "GW 1.50 to 50.0"},
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
TEST_CASE(test_separation_at_full_contact)
{
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
TEST_CASE(test_a_curve_without_an_elbow)
{
    struct fake fake;
    make_fake(&fake);
    fake_curve(&fake, 0, "jg")->elbow_load = NAN;
    assert_verdict(&fake, "the elbow", "in part", "in 11 of 12 curves");
    fake_curve(&fake, 0, "jg")->full_load = 2;
    assert_verdict(&fake, "the elbow", "holds", "in 11 of 11 curves");
    fake_curve(&fake, 1, "jg")->elbow_load = fake_curve(&fake, 1, "jg")->first_load = 1e-3; /* or below: who knows */
    assert_verdict(&fake, "the elbow", "holds", "in 10 of 10 curves");
    for (size_t k = 0; k < SURFACES; k++) /* all in full contact from the first load on: nothing tested */
        for (int m = 0; m < FAKE_MODELS; m++) {
            fake_curve(&fake, k, fake_models[m])->full_load = fake.results.loads[0] / 2;
            fake_curve(&fake, k, fake_models[m])->elbow_load = NAN;
        }
    assert_verdict(&fake, "the elbow", "not tested", "none begins to within the loads");
}

TEST_CASE(test_convergence)
{
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
TEST_CASE(test_models_that_do_not_exist_are_left_out)
{
    struct fake fake;
    make_fake(&fake);
    set_model(&fake, offsetof(struct curve_summary, area_slope), 0.5, false);
    fake_curve(&fake, 1, "gw")->exists = false;
    assert_verdict(&fake, "linear in the load", "holds", "11 of 11 curves");
}

TEST_CASE(test_scale_dependence)
{
    struct fake fake;
    make_fake(&fake);
    assert_verdict(&fake, "Scale dependence", "holds", "GW 0.10 to 1.0 %");
    fake_curve(&fake, 2, "jg")->sd_most = 0.051;
    assert_verdict(&fake, "Scale dependence", "fails", "JG 0.10 to 5.1 %");
    set_model(&fake, offsetof(struct curve_summary, sd_least), INFINITY, true);
    set_model(&fake, offsetof(struct curve_summary, sd_most), -INFINITY, true);
    assert_verdict(&fake, "Scale dependence", "not tested", "");
}

TEST_CASE(test_gamma)
{
    struct fake fake;
    make_fake(&fake);
    static const char claim[] = "so the area converges";
    assert_verdict(&fake, claim, "holds", "for 3 of 3 surfaces; ");
    assert_verdict(&fake, claim, "holds", "nothing of the area");
    fake.surfaces[2].summary.power_law.gamma = 0.99;
    fake.surfaces[2].summary.power_law.gamma_error = 0.02; /* 1 within its error */
    assert_verdict(&fake, claim, "holds", "");
    fake.surfaces[2].summary.power_law.gamma_error = 0.005;
    fake_curve(&fake, 0, "multiscale-elastic")->extension =
        (struct convergence_extension){.area_measured = 0.4, .area_extended = 0.3};
    assert_verdict(&fake, claim, "in part", "at most 25 %");
    fake.surfaces[1].summary.power_law.knee_m = 1e-5; /* then the slope at short wavelengths counts */
    fake.surfaces[1].summary.power_law.gamma_below = 0.5;
    assert_verdict(&fake, claim, "fails", "for 1 of 3 surfaces (judged on 1 of them by the slope");
    fake.surfaces[1].summary.length_m = 1e-4; /* one harmonic known, 100 um: below the knee is rounding, and no slope */
    assert_verdict(&fake, claim, "in part", "for 1 of 2 surfaces; ");
    for (size_t k = 0; k < SURFACES; k++) {
        fake.surfaces[k].summary.power_law.gamma = NAN;
        fake.surfaces[k].summary.power_law.knee_m = NAN;
    }
    assert_verdict(&fake, claim, "not tested", "");

    make_fake(&fake);
    fake.surfaces[1].summary.power_law.gamma = 1.7;
    assert_verdict(&fake, "γ falls", "in part", "in 1 of 2 pairs");
    fake.surfaces[2].summary.power_law.gamma = 1.8;
    assert_verdict(&fake, "γ falls", "fails", "in 0 of 2 pairs");
    fake.surfaces[1].summary.power_law.gamma = NAN;
    assert_verdict(&fake, "γ falls", "not tested", "");
}

/* Ranks: comparison_rank.ranked of the quantity against its pairs. */
TEST_CASE(test_ranks)
{
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
                fake_compared(&fake, fake_models[m])->rank[rows[i].quantity] =
                    (struct comparison_tally){count, 100 - count, 7};
            char share[32];
            snprintf(share, sizeof share, "GW %zu %%", count);
            const char *expected = negated        ? count % 100 == 0 ? "fails" : "holds"
                                   : count == 100 ? "holds"
                                   : count >= 50  ? "in part"
                                                  : "fails";
            assert_verdict(&fake, rows[i].claim, expected, share);
            assert_verdict(&fake, rows[i].claim, expected, "; 28 are alike and speak for neither");
        }
        for (int m = 0; m < FAKE_MODELS; m++) /* all alike */
            fake_compared(&fake, fake_models[m])->rank[rows[i].quantity] = (struct comparison_tally){0, 0, 7};
        assert_verdict(&fake, rows[i].claim, "not tested", "GW alike");
        for (int m = 0; m < FAKE_MODELS; m++) /* all in full contact */
            fake_compared(&fake, fake_models[m])->rank[rows[i].quantity] = (struct comparison_tally){0};
        assert_verdict(&fake, rows[i].claim, "not tested", "none is in partial contact");
    }
}

/* Steps of the spread between the surfaces, at both loads. */
static void set_spread(struct fake *fake, const char *model, enum comparison_spread of, double spread, size_t count)
{
    for (int load = 0; load < 2; load++)
        fake_compared(fake, model)->extents[load][of] = (struct comparison_extent){1, spread, count};
}

TEST_CASE(test_plastic_against_elastic)
{
    struct fake fake;
    make_fake(&fake);
    static const struct {
        const char *claim;
        enum quantity quantity;
    } yields[] = {{"Plastic area is above", QUANTITY_AREA},
                  {"Plasticity lowers the gap", QUANTITY_SEPARATION},
                  {"Plastic ECR is below", QUANTITY_ECR}};
    for (size_t i = 0; i < sizeof yields / sizeof *yields; i++) {
        make_fake(&fake);
        struct comparison_tally *first =
                                    &fake_compared(&fake, "multiscale-plastic")->plastic.changes[yields[i].quantity],
                                *second = &fake_compared(&fake, "jg")->plastic.changes[yields[i].quantity];
        *second = (struct comparison_tally){20, 80, 5};
        assert_verdict(&fake, yields[i].claim, "in part", "20 of 100 loads, alike in 5 more");
        *first = (struct comparison_tally){20, 80, 0};
        assert_verdict(&fake, yields[i].claim, "fails", "multiscale: ");
        *first = *second = (struct comparison_tally){0, 0, 100}; /* ties alone */
        assert_verdict(&fake, yields[i].claim, "not tested", "0 of 0 loads, alike in 100 more");
        *first = *second = (struct comparison_tally){0};
        assert_verdict(&fake, yields[i].claim, "not tested", "no load of partial contact");
    }
    make_fake(&fake);
    assert_verdict(&fake, "Plastic area is above", "holds", "multiscale: plastic/elastic area 1.10 to 2.00");
    fake_compared(&fake, "jg")->plastic.sooner = (struct comparison_tally){1, 2, 0};
    assert_verdict(&fake, "at lower loads", "in part", "in 4 of 6 pairs");
    fake_compared(&fake, "multiscale-plastic")->plastic.sooner = (struct comparison_tally){0, 3, 0};
    assert_verdict(&fake, "at lower loads", "fails", "in 1 of 6 pairs");
    fake_compared(&fake, "multiscale-plastic")->plastic.sooner = fake_compared(&fake, "jg")->plastic.sooner =
        (struct comparison_tally){0, 0, 3};
    assert_verdict(&fake, "at lower loads", "not tested", "alike in 6 more");

    make_fake(&fake);
    set_spread(&fake, "jg", COMPARISON_AREAS, 6, SURFACES);
    assert_verdict(&fake, "narrows the spread", "in part",
                   ": multiscale elastic 3.00, plastic 2.00; statistical elastic 5.00, plastic 6.00");
    set_spread(&fake, "multiscale-plastic", COMPARISON_AREAS, 2, 2); /* the third is past full contact */
    assert_verdict(&fake, "narrows the spread", "fails", ": statistical elastic 5.00, plastic 6.00");
    set_spread(&fake, "jg", COMPARISON_AREAS, 5, SURFACES); /* as wide as GW's */
    assert_verdict(&fake, "narrows the spread", "not tested", "plastic 5.00");
    set_spread(&fake, "gw", COMPARISON_AREAS, 5, 0);
    assert_verdict(&fake, "narrows the spread", "not tested", "there is no such load");
}

/* Surfaces held against each other: orders of magnitude, distances, sensitivity. */
TEST_CASE(test_surfaces_against_each_other)
{
    struct fake fake;
    make_fake(&fake);
    assert_verdict(&fake, "same order of magnitude", "holds", "GW 5.00; JG 4.00");
    set_spread(&fake, "gw", COMPARISON_AREAS, 10.1, SURFACES);
    assert_verdict(&fake, "same order of magnitude", "in part", "GW 10.1");
    for (int m = 0; m < FAKE_MODELS; m++)
        set_spread(&fake, fake_models[m], COMPARISON_AREAS, 1, 0);
    assert_verdict(&fake, "same order of magnitude", "not tested", "no load");

    assert_verdict(&fake, "nearly equal distances", "holds", "multiscale elastic 0.20 to 0.30;");
    fake_compared(&fake, "multiscale-elastic")->steps[1] = 0.41;
    assert_verdict(&fake, "nearly equal distances", "in part", "multiscale elastic 0.20 to 0.41;");
    fake_compared(&fake, "multiscale-plastic")->steps[0] = -0.2; /* the other way */
    assert_verdict(&fake, "nearly equal distances", "fails", "");
    fake_compared(&fake, "multiscale-plastic")->steps[0] = fake_compared(&fake, "multiscale-elastic")->steps[0] = NAN;
    assert_verdict(&fake, "nearly equal distances", "not tested", "");

    assert_verdict(&fake, "more sensitive", "holds", "GW 5.00, multiscale elastic 3.00; JG 4.00");
    set_spread(&fake, "gw", COMPARISON_RESISTANCES, 3, SURFACES); /* a tie */
    assert_verdict(&fake, "more sensitive", "holds", "");
    set_spread(&fake, "jg", COMPARISON_RESISTANCES, 1.5, SURFACES);
    assert_verdict(&fake, "more sensitive", "fails", "JG 1.50, multiscale elastic-plastic 2.00");
    set_spread(&fake, "jg", COMPARISON_RESISTANCES, 1.5, 1);
    assert_verdict(&fake, "more sensitive", "not tested", "");
}

/* Neighbours that differ by less than their standard errors together count neither way. */
TEST_CASE(test_numbers_against_roughness)
{
    struct fake fake;
    make_fake(&fake); /* gamma 1.6, 1.4, 1.2 */
    fake.surfaces[0].summary.power_law.gamma_error = 0.15;
    assert_verdict(&fake, "γ falls", "holds", "in 2 of 2 pairs");
    fake.surfaces[1].summary.power_law.gamma_error = 0.15; /* sqrt(2) 0.15 > 0.2 */
    assert_verdict(&fake, "γ falls", "holds", "in 1 of 1 pairs, 1 more differ");
    fake.surfaces[2].summary.power_law.gamma_error = 0.15;
    assert_verdict(&fake, "γ falls", "not tested", "in 0 of 0 pairs, 2 more differ");

    /* 0.1, 0.2, 0.1 um at 10 um, whatever alpha is: 10, 2, 0.1 */
    make_fake(&fake);
    assert_verdict(&fake, "α) varies independently", "holds",
                   "at λ = 10.0 µm Δ falls from the smoother to the rougher "
                   "neighbour in 1 of 2 pairs");
    fake_law(&fake.surfaces[2].summary.power_law, 3e-7, 1.2);
    assert_verdict(&fake, "α) varies independently", "fails", "in 0 of 2 pairs");
    fake_law(&fake.surfaces[2].summary.power_law, 1e-7, 1.2);
    fake.surfaces[1].summary.power_law.amplitude_error_decades = 0.31; /* a factor of 2.04 */
    assert_verdict(&fake, "α) varies independently", "not tested", "2 more differ");
    fake.surfaces[1].summary.power_law.amplitude_error_decades = 0;
    fake.surfaces[0].summary.power_law.gamma_error = fake.surfaces[2].summary.power_law.gamma_error = 0.7;
    assert_verdict(&fake, "α) varies independently", "holds", "in 1 of 2 pairs"); /* it turns about the middle */
    fake.surfaces[1].summary.power_law.band_m[0] = 9e-5; /* three bands share 90 to 100 um: 0.68 decades off it */
    assert_verdict(&fake, "α) varies independently", "not tested", "at λ = 94.9 µm Δ falls from");
    for (size_t k = 0; k < SURFACES; k++)
        fake.surfaces[k].summary.power_law.found = POWER_LAW_BAND_NARROW;
    assert_verdict(&fake, "α) varies independently", "not tested", "no power law holds");

    assert_verdict(&fake, "β does not follow", "holds",
                   "GW: β falls from the smoother to the rougher neighbour in 1 of 2");
    for (size_t k = 0; k < SURFACES; k++)
        fake_curve(&fake, k, "gw")->beta = 5 + (double)k;
    assert_verdict(&fake, "β does not follow", "in part", "in 0 of 2");
    for (size_t k = 0; k < SURFACES; k++)
        fake_curve(&fake, k, "jg")->beta = 8 - (double)k;
    assert_verdict(&fake, "β does not follow", "in part", "JG: ");
    for (int m = 0; m < FAKE_MODELS; m++)
        fake_curve(&fake, 0, fake_models[m])->beta = NAN;
    assert_verdict(&fake, "β does not follow", "not tested", "two pairs");
}

/* The findings are of the thesis's four models: what others say moves no verdict. */
TEST_CASE(test_other_models_do_not_speak)
{
    struct fake fake;
    make_fake(&fake);
    struct text before = section_of(&fake);
    for (size_t m = 0; m < model_count; m++) {
        if (model_rows[m]->thesis_place > 0)
            continue;
        fake.plan.models |= MODEL_BIT(m);
        for (int q = 0; q < QUANTITY_COUNT; q++) {
            fake.models[m].rank[q] = (struct comparison_tally){0, 100, 0};
            fake.models[m].plastic.changes[q] = (struct comparison_tally){0, 100, 0};
        }
        fake.models[m].plastic.sooner = (struct comparison_tally){0, 9, 0};
        for (size_t k = 0; k < SURFACES; k++) {
            fake.gaps[m][k] = (struct comparison_gap){0.1, 9, 0.1, 9};
            fake.steps[m][k] = k ? 9 : 0.1;
            fake.curves[k][m] = (struct curve_summary){.exists = true,
                                                       .full_load = 0.1,
                                                       .elbow_load = 0.002,
                                                       .beta = 99 - (double)k,
                                                       .area_slope = 5,
                                                       .gap_at_full = 5,
                                                       .sd_least = 1,
                                                       .sd_most = 2};
        }
        for (int load = 0; load < 2; load++)
            for (int of = 0; of < COMPARISON_SPREADS; of++)
                fake.extents[m][load][of] = (struct comparison_extent){1, 1000, SURFACES};
    }
    struct text after = section_of(&fake);
    assert_string_equal(text_string(&before), text_string(&after));
    text_free(&before);
    text_free(&after);
}

TEST_CASE(test_the_families_and_proportions)
{
    struct fake fake;
    make_fake(&fake);
    assert_verdict(&fake, "agree better in ECR", "holds", "so on 6 of 6 surfaces and laws");
    assert_verdict(&fake, "brings the two families closer", "holds", "elastic: adjusted 0.30, as it is 1.0 σ");
    assert_verdict(&fake, "similar on every surface", "holds", "on 6 of 6 surfaces and laws; at most 0.20 decades");
    fake_compared(&fake, "jg")->gaps[2].ecr = 0.6; /* the third surface counts too, not the baseline alone */
    assert_verdict(&fake, "agree better in ECR", "in part", "plastic: ECR 0.20 to 0.60, area 0.50 decades");
    assert_verdict(&fake, "similar on every surface", "in part",
                   "on 5 of 6 surfaces and laws; at most 0.60 decades, on "
                   "surface three");
    fake_compared(&fake, "jg")->gaps[2].ecr = 0.5; /* a tie: five cases are left */
    assert_verdict(&fake, "agree better in ECR", "holds", "so on 5 of 5 surfaces and laws, alike in 1 more");
    fake_compared(&fake, "gw")->gaps[0].adjusted = 1.2;
    assert_verdict(&fake, "brings the two families closer", "in part", "so on 5 of 6");
    for (int m = 0; m < FAKE_MODELS; m++)
        for (size_t k = 0; k < SURFACES; k++)
            fake_compared(&fake, fake_models[m])->gaps[k] = (struct comparison_gap){NAN, NAN, NAN, NAN};
    assert_verdict(&fake, "agree better in ECR", "not tested", "none has both");
    assert_verdict(&fake, "brings the two families closer", "not tested", "none has both");
    assert_verdict(&fake, "similar on every surface", "not tested", "no surface has both");
    fake.comparison.proportional_error = 1e-3;
    assert_verdict(&fake, "TCR is ECR", "fails", "0.0010");
    fake.comparison.proportional_error = NAN;
    assert_verdict(&fake, "TCR is ECR", "not tested", "");
}

/* What each finding needs, by the contract: effects, models, and whether it holds surfaces against each other. */
static const struct {
    const char *claim;
    unsigned effects;
    bool scales, asperities;
    size_t surfaces;
} needs[CHECKS] = {
    {"Whether the area converges", EFFECT_BIT(EFFECT_CONVERGENCE), true, false, 1},
    {"so the area converges", 0, true, false, 1},
    {"The area is linear in the load", 0, false, false, 1},
    {"Plastic area is above elastic area", EFFECT_BIT(EFFECT_PLASTICITY), false, false, 1},
    {"No separation is left at full contact", EFFECT_BIT(EFFECT_SEPARATION), true, false, 1},
    {"Plasticity lowers the gap", EFFECT_BIT(EFFECT_PLASTICITY) | EFFECT_BIT(EFFECT_SEPARATION), false, false, 1},
    {"brings the two families closer", EFFECT_BIT(EFFECT_SEPARATION), true, true, 1},
    {"(the elbow)", EFFECT_BIT(EFFECT_ELECTRICAL), false, false, 1},
    {"Plastic ECR is below", EFFECT_BIT(EFFECT_PLASTICITY) | EFFECT_BIT(EFFECT_ELECTRICAL), false, false, 1},
    {"agree better in ECR than in area", EFFECT_BIT(EFFECT_ELECTRICAL), true, true, 1},
    {"TCR is ECR in other units", EFFECT_BIT(EFFECT_ELECTRICAL) | EFFECT_BIT(EFFECT_THERMAL), false, false, 1},
    {"Scale dependence is negligible", EFFECT_BIT(EFFECT_SCALE_DEPENDENT), false, false, 1},
    {"γ falls as roughness rises", 0, false, false, 2},
    {"α) varies independently", 0, false, false, 3},
    {"Smoother surfaces have the larger area", 0, false, false, 2},
    {"same order of magnitude", 0, false, false, 2},
    {"Plasticity narrows the spread", EFFECT_BIT(EFFECT_PLASTICITY), false, false, 2},
    {"Plastic models reach full contact", EFFECT_BIT(EFFECT_PLASTICITY), false, false, 1},
    {"is not ranked by roughness", EFFECT_BIT(EFFECT_SEPARATION), false, false, 2},
    {"β lies between 4 and 12", EFFECT_BIT(EFFECT_SEPARATION), false, true, 1},
    {"β does not follow", EFFECT_BIT(EFFECT_SEPARATION), false, true, 3},
    {"Smoother surfaces have the smaller ECR", EFFECT_BIT(EFFECT_ELECTRICAL), false, false, 2},
    {"nearly equal distances", EFFECT_BIT(EFFECT_ELECTRICAL), true, false, 3},
    {"Smoother surfaces have the smaller TCR", EFFECT_BIT(EFFECT_THERMAL), false, false, 2},
    {"more sensitive to roughness", EFFECT_BIT(EFFECT_THERMAL), true, true, 2},
    {"similar on every surface", EFFECT_BIT(EFFECT_ELECTRICAL), true, true, 2},
};

/* Only what can be checked with what ran is in the table. */
TEST_CASE(test_the_table_leaves_out_what_did_not_run)
{
    static const char *const families[] = {"multiscale", "statistical", NULL};
    struct fake fake;
    make_fake(&fake);
    const uint64_t all = fake.plan.models;
    for (unsigned running = 0; running < 1u << EFFECT_GAP; running++) /* those of the joint are not of chapter 6 */
        for (size_t f = 0; f < 3; f++)
            for (size_t surfaces = 1; surfaces <= SURFACES; surfaces++) {
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
                                      (asperities || !needs[i].asperities) && surfaces >= needs[i].surfaces;
                    if (find_row(row, &fake, needs[i].claim) != called_for)
                        fail_msg("'%s', effects %x, family %zu, surfaces %zu", needs[i].claim, running, f, surfaces);
                    expected += called_for;
                }
                assert_int_equal(rows_of_table(&fake), expected);
            }
}

/* The table of a comparison of curves, not of made-up figures. */
TEST_CASE(test_findings_on_curves)
{
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
