/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The view on results made up to order, whose numbers can be worked out by hand, and the report filled from it. */
#include "directory.h"
#include "made_up_results.h"
#include "report/report.h"
#include "support.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** A text of the view by a path such as "rows.1.value.value"; "" where it is not there. */
static const char *view_at(const json_t *view, const char *path)
{
    static char number[40];
    char copy[200];
    snprintf(copy, sizeof copy, "%s", path);
    for (char *part = strtok(copy, "."); part; part = strtok(NULL, "."))
        view = json_is_array(view) ? json_array_get(view, strtoul(part, NULL, 10)) : json_object_get(view, part);
    if (json_is_integer(view)) {
        snprintf(number, sizeof number, "%lld", (long long)json_integer_value(view));
        return number;
    }
    return json_is_true(view) ? "true" : json_is_string(view) ? json_string_value(view) : "";
}

/** The report of what was made up, as Markdown. */
static struct text report_of(struct made_up *made)
{
    struct text out = {0};
    struct status status = {0};
    const struct report_options how = {PROJECT_SOURCE "/templates", NULL, false};
    if (report_markdown(&out, made->view, &how, &status) != STATUS_OK)
        fail_msg("%s", status.message);
    return out;
}

static void assert_says(const struct text *report, const char *words)
{
    if (!strstr(text_string(report), words))
        fail_msg("'%s' is not in\n%s", words, text_string(report));
}

static void assert_silent(const struct text *report, const char *words)
{
    if (strstr(text_string(report), words))
        fail_msg("'%s' is in\n%s", words, text_string(report));
}

/** The first page says `words` and not `unsaid`, and the terminal says them too, without the marks of Markdown. */
static void assert_says_page(struct made_up *made, const char *words, const char *unsaid)
{
    struct text page = report_of(made), table = {0}, plain = {0};
    struct status status = {0};
    char *end = strstr(page.data, "\n---\n");
    assert_non_null(end);
    *end = '\0';
    assert_says(&page, words);
    assert_silent(&page, unsaid);
    assert_int_equal(report_terminal(&table, "terminal", made->view, PROJECT_SOURCE "/templates", false, &status),
                     STATUS_OK);
    for (const char *at = words; *at; at++)
        text_add(&plain, strchr("*`", *at) ? "" : "%c", *at);
    for (char *at = table.data; *at; at++)
        *at = *at == '\n' ? ' ' : *at; /* lines of 80 columns */
    assert_says(&table, text_string(&plain));
    text_free(&plain);
    text_free(&table);
    text_free(&page);
}

/* Multiscale plastic leads. beta has ECR 3e-14/2/load: 1.5e-10 ohm m² at the middle load 1e-4, and 0.15 mohm on 1 mm²;
 * with film and plating 3e12 times that, so these do not run where ECR is asked for. */
enum {
    PLAIN = EFFECT_BIT(EFFECT_PLASTICITY) | EFFECT_BIT(EFFECT_SEPARATION) | EFFECT_BIT(EFFECT_ELECTRICAL) |
            EFFECT_BIT(EFFECT_THERMAL) | EFFECT_BIT(EFFECT_UNCERTAINTY)
};

static const struct {
    const char *path, *expected;
} first_page[] = {
    {"operating_load", "10.0\u00a0N"},
    {"asked.symbol", "contact resistance"},
    {"asked.unit", "µΩ"},
    {"answers.0.surface", "alpha"},
    {"answers.0.value", "50.0\u00a0µΩ"},
    {"answers.1.surface", "beta"},
    {"answers.1.value", "150\u00a0µΩ"},
    {"answers.2.value", "375\u00a0µΩ"},
    {"answers.2.last", "true"},
    {"rows.0.surface", "beta"},
    {"rows.0.rq_um", "0.200"},
    {"rows.0.area_percent", "10"},
    {"rows.1.area_percent", "20"},
    {"rows.2.value.value", "375\u00a0µΩ"},
    {"refused_count", "1"},
    {"ranking.best", "alpha"},
    {"ranking.significant", "true"},
    {"measured.0.ratio", "0.67 times"},
    {"measured.0.carries", "0.67"},
    {"surfaces.rows.0.gamma", "1.400 ± 0.010"},
    {"surfaces.rows.1.scans", "1"},
    {"one_surface.surface", "beta"},
    {"one_surface.rows.0.label", "multiscale elastic"},
    {"one_surface.heads.0.label", "area (%)"},
    {"one_surface.rows.0.cells.0.text", "5.00"},
    {"all_surfaces.rows.0.cells.0.text", "6.00"},
    {"all_surfaces.rows.0.cells.1.text", "7.00"},
    {"inputs.rows.0.hash", "0123456789abcdef"},
    {"inputs.notes.0.body.line", "beta.csv: a note"},
    {"inputs.refused.0.why", "broken.csv: no number in it"},
    {"stability.refused.count", "1"},
    {"accuracy.models.0.label", "multiscale elastic"},
    {"accuracy.models.0.time", "0.0010\u00a0ms"},
    {"length_factor", "1.3"},
    {"spacing_factor", "1.1"},
    {"hardness_factor", "1.1"},
};

TEST_CASE(the_first_page_and_the_tables_hold_the_numbers)
{
    struct made_up made;
    made_up_make_of(&made, made_up_models(), PLAIN, NULL);
    for (size_t i = 0; i < sizeof first_page / sizeof *first_page; i++)
        if (strcmp(view_at(made.view, first_page[i].path), first_page[i].expected) != 0)
            fail_msg("%s: '%s', not '%s'", first_page[i].path, view_at(made.view, first_page[i].path),
                     first_page[i].expected);
    made_up_free(&made);
}

TEST_CASE(the_report_says_them_in_words)
{
    struct made_up made;
    made_up_make_of(&made, made_up_models(), PLAIN, NULL);
    struct text report = report_of(&made);
    assert_says(&report, "**At 10.0\u00a0N the contact resistance is 50.0\u00a0µΩ**");
    assert_says(&report, "*alpha* is significantly better than all others tested");
    assert_says(&report, "On *beta* your contact carries 0.67 of the predicted conductance");
    assert_says(&report, "**1 refused**");
    assert_says(&report, "| beta | 0.200 | 0.500 | 1.400 ± 0.010 |");
    assert_says(&report, "Table 6.2");
    assert_says(&report, "Table 6.3");
    assert_silent(&report, "{{");
    assert_silent(&report, "\n\n\n");
    assert_silent(&report, "Does the area converge");
    assert_silent(&report, "The joint");
    text_free(&report);
    made_up_free(&made);
}

/** A target of the leading model on every surface, met at twice, once and four times the middle load. */
static void set_target(struct made_up *made, struct scene_asked *target, struct answer *answers)
{
    static const double loads[MADE_UP_USABLE] = {2e-4, 1e-4, 4e-4};
    *target = (struct scene_asked){.quantity = QUANTITY_ECR,
                                   .how = quantity_rows[QUANTITY_ECR].asked,
                                   .value = 1e-10,
                                   .factor = 1e-6,
                                   .unit = {.factor = 1e-3}};
    snprintf(target->text, sizeof target->text, "0.1 mohm");
    snprintf(target->unit_text, sizeof target->unit_text, "mohm");
    made->scene.targets = target;
    made->scene.target_count = 1;
    for (size_t i = 0; i < MADE_UP_USABLE; i++)
        for (size_t m = 0; m < model_count; m++)
            answers[i * model_count + m] = (struct answer){
                .kind = ANSWER_LOAD, .load = loads[i], .low = loads[i] / 2, .high = loads[i] * 2, .spots_per_m2 = NAN};
    for (size_t i = 0; i < MADE_UP_USABLE; i++)
        made->surfaces[i].summary.answers = answers + i * model_count;
    made_up_again(made);
}

static void drop_target(struct made_up *made, struct answer *answers)
{
    for (size_t i = 0; i < MADE_UP_USABLE; i++)
        made->surfaces[i].summary.answers = NULL;
    free(answers);
    made_up_free(made);
}

TEST_CASE(a_target_is_answered_in_newtons)
{
    struct made_up made;
    struct scene_asked target;
    struct answer *answers = calloc(MADE_UP_USABLE * model_count, sizeof *answers);
    assert_non_null(answers);
    made_up_make_of(&made, made_up_models(), PLAIN, NULL);
    set_target(&made, &target, answers);
    struct text report = report_of(&made);
    assert_says(&report, "**0.1\u00a0mΩ takes 10.0\u00a0N** (95 % 5.0\u00a0…\u00a020) on *alpha*, 20.0\u00a0N (95 % "
                         "10\u00a0…\u00a040) on "
                         "*beta*, 40.0\u00a0N (95 % 20\u00a0…\u00a080) on *gamma*.");
    assert_says(&report, "| beta | 0.200 | 0.500 | 1.400 ± 0.010 | 20.0");
    text_free(&report);
    answers[made.comparison.leading].kind = ANSWER_NOT_REACHED;
    made_up_again(&made);
    report = report_of(&made);
    assert_says(&report, "more than 20.0\u00a0N (95 %");
    assert_says(&report, "| beta | 0.200 | 0.500 | 1.400 ± 0.010 | > 20.0");
    text_free(&report);
    assert_says_page(&made, "more than 20.0\u00a0N (95 %", "at most");
    struct status status = {0};
    struct text table = {0};
    assert_int_equal(report_terminal(&table, "terminal", made.view, PROJECT_SOURCE "/templates", false, &status),
                     STATUS_OK);
    assert_says(&table, "\nbeta     0.200  0.500  1.40      > 20.0\u00a0N");
    text_free(&table);
    answers[made.comparison.leading].kind = ANSWER_LIGHTEST;
    made_up_again(&made);
    assert_says_page(&made, "at most 20.0\u00a0N (95 %", "more than");
    assert_int_equal(report_terminal(&table, "terminal", made.view, PROJECT_SOURCE "/templates", false, &status),
                     STATUS_OK);
    assert_says(&table, "\nbeta     0.200  0.500  1.40      ≤ 20.0\u00a0N");
    text_free(&table);
    drop_target(&made, answers);
}

/** beta and alpha are alike: not told apart. */
static void make_alike(struct surface_record *record, size_t index)
{
    if (index < MADE_UP_USABLE)
        for (size_t m = 0; m < model_count; m++)
            for (size_t i = 0; record->curves[m].exists && i < MADE_UP_LOADS; i++)
                record->curves[m].points[i].value[QUANTITY_ECR] =
                    (1 + 0.01 * (double)index) * 1e-14 / record->curves[m].points[i].value[QUANTITY_LOAD];
}

TEST_CASE(surfaces_within_their_scatter_do_not_differ_significantly)
{
    struct made_up made;
    made_up_make_of(&made, made_up_models(), PLAIN, make_alike);
    assert_string_equal(view_at(made.view, "ranking.undecided"), "true");
    struct text report = report_of(&made);
    assert_says(&report, "does not differ significantly from");
    text_free(&report);
    made_up_free(&made);
}

TEST_CASE(names_from_outside_mean_nothing)
{
    static char hostile[] = "a*b|<script>`x`[l](http://e)\x1b[2J";
    struct made_up made;
    made_up_make_of(&made, made_up_models(), PLAIN, NULL);
    made.names[0].name = hostile;
    made_up_again(&made);
    struct text report = report_of(&made);
    assert_says(&report, "a\\*b\\|&#60;script&#62;\\`x\\`\\[l\\](http\\://e)\\\\x1b\\[2J");
    assert_silent(&report, "<script>");
    assert_silent(&report, "\x1b");
    text_free(&report);
    made_up_free(&made);
}

/* ---- The findings of chapter 6 ---- */

/** The finding of that name; NULL: it was not looked at. */
static const json_t *finding(const struct made_up *made, const char *name)
{
    size_t i;
    const json_t *item;
    json_array_foreach(json_object_get(made->view, "findings"), i, item)
    {
        if (json_is_true(json_object_get(item, name)))
            return item;
    }
    return NULL;
}

/* What the power laws of made_up_results.h say: all areas are linear, plastic ones twice the elastic, smoother surfaces
 * have more area and less resistance, γ falls with roughness, β is 6 everywhere, TCR is 2e5 ECR (not 1/(ρ k)). */
static const struct {
    const char *name, *verdict, *good, *all;
} expected[] = {
    {"linear", "holds", "9", "9"},
    {"plastic_area", "holds", NULL, NULL},
    {"plastic_ecr", "holds", NULL, NULL},
    {"gamma", "holds", "3", "3"},
    {"convergence_by_gamma", "holds", NULL, NULL},
    {"beta", "holds", "6", "6"},
    {"beta_rank", "not_tested", "0", "0"},
    {"gamma_rank", "holds", "2", "2"},
    {"area_rank", "holds", NULL, NULL},
    {"ecr_rank", "holds", NULL, NULL},
    {"magnitude", "holds", "4", "4"},
    {"scale_dependence", "holds", "12", "12"},
    {"sooner", "holds", NULL, NULL},
    {"statistical_gap", "fails", "0", "6"}, /* β 6: -3 σ */
    {"same_order", "holds", "6", "6"},
    {"high_rank", "holds", "21", "21"},
    {"smoothest", "fails", "0", "2"},
    {"together", "fails", "0", "2"},
};

TEST_CASE(the_findings_of_chapter_6)
{
    struct made_up made;
    made_up_make(&made, NULL);
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        const json_t *item = finding(&made, expected[i].name);
        if (!item || !json_is_true(json_object_get(item, expected[i].verdict)))
            fail_msg("%s: %s is not '%s': %s", expected[i].name, item ? "found" : "not found", expected[i].verdict,
                     item ? json_dumps(item, 0) : "");
        if (expected[i].good) {
            char good[40];
            snprintf(good, sizeof good, "%s", view_at(item, "good"));
            assert_string_equal(good, expected[i].good);
            assert_string_equal(view_at(item, "all"), expected[i].all);
        }
    }
    struct text report = report_of(&made);
    assert_says(&report, "| 6.3.1 | The area is linear in the load | **holds** | 9 of 9");
    text_free(&report);
    made_up_free(&made);
}

/** The rougher the surface, the larger its area. */
static void turn_round(struct surface_record *record, size_t index)
{
    static const double area[MADE_UP_USABLE] = {500, 200, 1000};
    for (size_t m = 0; index < MADE_UP_USABLE && m < model_count; m++)
        for (size_t i = 0; record->curves[m].exists && i < MADE_UP_LOADS; i++) {
            struct contact_point *point = &record->curves[m].points[i];
            point->value[QUANTITY_AREA] = fmin(1, area[index] * point->value[QUANTITY_LOAD]);
        }
}

TEST_CASE(a_finding_that_does_not_hold_fails)
{
    struct made_up made;
    made_up_make(&made, turn_round);
    assert_true(json_is_true(json_object_get(finding(&made, "area_rank"), "fails")));
    assert_true(json_is_true(json_object_get(finding(&made, "plastic_area"), "not_tested")) ||
                json_is_true(json_object_get(finding(&made, "plastic_area"), "fails")));
    made_up_free(&made);
    made_up_make(&made, NULL);
    made_up_sweep(&made, CONVERGENCE_ALPHA, "multiscale-elastic", 0, 0.1);
    made_up_again(&made);
    assert_true(json_is_true(json_object_get(finding(&made, "convergence_by_gamma"), "in_part")));
    made_up_free(&made);
}

/** What the thesis says of stiffness, of a shoulder at 3 times the load, and of its smoothest surface. */
static void as_the_thesis_has_it(struct surface_record *record, size_t index)
{
    for (size_t m = 0; index < MADE_UP_USABLE && m < model_count; m++) {
        struct model_curve *curve = &record->curves[m];
        bool statistical = model_rows[m]->asperity_model;
        curve->beta = statistical ? -1 : NAN; /* 0.5 σ left */
        if (model_rows[m]->stacks_scales && !model_rows[m]->plastic)
            curve->kink.load = 3 * record->curves[made_up_model("multiscale-plastic")].full_load;
        for (size_t i = 0; curve->exists && i < curve->count; i++) {
            double *value = curve->points[i].value;
            value[QUANTITY_STIFFNESS] = statistical ? 1e12 : 4e12;
            if (statistical && index == 1)
                value[QUANTITY_ADJUSTED] += 1e-5;
            if (statistical && index == 0)
                value[QUANTITY_ECR] *= 0.5; /* 1.5 times alpha's */
        }
    }
}

TEST_CASE(findings_as_the_thesis_has_them)
{
    static const struct {
        const char *name, *number;
    } all[] = {{"statistical_gap", "0.50"}, {"stiffer", "4.0"},  {"law", "3.0 to 4.0"},
               {"smoothest", "100"},        {"shoulder", "3.0"}, {"together", "0.18"}};
    struct made_up made;
    made_up_make(&made, as_the_thesis_has_it);
    for (size_t i = 0; i < MADE_UP_USABLE; i++)
        for (size_t m = 0; m < model_count; m++)
            if (made_up_surface(&made, i)->models[m])
                made_up_surface(&made, i)->models[m]->law_factor = i == 0 ? 0.25 : 3;
    made_up_again(&made);
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        const json_t *item = finding(&made, all[i].name);
        assert_true(json_is_true(json_object_get(item, "holds")));
        assert_string_equal(view_at(item, "numbers.0.range"), all[i].number);
    }
    const struct report_options how = {PROJECT_SOURCE "/templates", PROJECT_SOURCE "/surfaces/chapter6/report.md", 0};
    struct status status = {0};
    struct text out = {0};
    assert_int_equal(report_markdown(&out, made.view, &how, &status), STATUS_OK);
    assert_says(&out, "| GW, thesis | 153.7 | 5.2 | 8.8 | 6.8 |\n| GW, here | −1.00 | −1.00 | −1.00 |\n");
    assert_says(&out, "| JG, here | −1.00 | −1.00 | −1.00 |\n");
    text_free(&out);
    made_up_free(&made);
    made_up_make_of(&made, made_up_models(), PLAIN | EFFECT_BIT(EFFECT_CONVERGENCE), NULL);
    assert_null(finding(&made, "stiffer")); /* only where stiffness runs */
    made_up_free(&made);
}

/* ---- Sentences, each beside an input that it is not true of ---- */

/** Nothing is known of how far another scan of the surface would be off. */
static void forget_scatter(struct surface_record *record, size_t index)
{
    struct estimate none[CURVE_ESTIMATES];
    struct status status = {0};
    for (size_t e = 0; e < CURVE_ESTIMATES; e++)
        none[e] = estimate_none;
    for (size_t m = 0; index < MADE_UP_USABLE && m < model_count; m++)
        if (record->summary.models[m])
            assert_int_equal(curve_summary_put_estimates(record->summary.models[m], none, &status), STATUS_OK);
}

TEST_CASE(the_ranking_names_quantity_load_and_who_was_tested)
{
    struct made_up made;
    made_up_make_of(&made, made_up_models(), PLAIN, NULL);
    struct text report = report_of(&made);
    assert_says(&report,
                "\nIn contact resistance at 10.0\u00a0N *alpha* is significantly better than all others tested");
    assert_silent(&report, "Not tested");
    text_free(&report);
    forget_scatter(&made.surfaces[2], 2);
    made_up_again(&made);
    report = report_of(&made);
    assert_says(&report, "\nIn contact resistance at 10.0\u00a0N *alpha* is significantly better than *beta*");
    assert_says(&report, ". Not tested, as no interval is known: *gamma*.\n");
    assert_silent(&report, "all others");
    text_free(&report);
    forget_scatter(&made.surfaces[1], 1);
    made_up_again(&made);
    report = report_of(&made);
    assert_says(&report,
                "\nIn contact resistance at 10.0\u00a0N it is undecided whether surfaces differ significantly:");
    assert_silent(&report, "better than");
    text_free(&report);
    made_up_free(&made);
}

/** At the middle load: load over hardness on every surface, and what differs in resistance. */
static void press_into_hardness(struct surface_record *record, size_t index)
{
    for (size_t m = 0; index < MADE_UP_USABLE && m < model_count; m++)
        for (size_t i = 0; record->curves[m].exists && i < MADE_UP_LOADS; i++) {
            double *value = record->curves[m].points[i].value;
            value[QUANTITY_AREA] = fmin(1, 1e11 * value[QUANTITY_LOAD] / 2.84e8);
        }
}

TEST_CASE(an_area_that_cannot_differ_is_not_ranked_by_something_else)
{
    struct made_up made;
    struct scene_asked target = {0};
    struct answer *answers = calloc(MADE_UP_USABLE * model_count, sizeof *answers);
    assert_non_null(answers);
    made_up_make_of(&made, made_up_models(), PLAIN, press_into_hardness);
    set_target(&made, &target, answers);
    assert_says_page(&made, "In contact resistance at 10.0\u00a0N *alpha* is significantly better", "cannot differ");
    target.quantity = QUANTITY_AREA;
    target.how = quantity_rows[QUANTITY_AREA].asked;
    made_up_again(&made);
    assert_says_page(&made, "Contact area is load over hardness here, so surfaces cannot differ in it.", "better than");
    assert_says_page(&made, "so surfaces cannot differ in it.", " alike"); /* no letters of what was not asked */
    double *area = &made_up_surface(&made, 2)->models[made.comparison.leading]->operating.value[QUANTITY_AREA];
    *area *= 1.0001; /* pressed as far as hardness lets them, which is never quite */
    made_up_again(&made);
    assert_says_page(&made, "Contact area is load over hardness here, so surfaces cannot differ in it.", "better than");
    *area /= 1.0001;
    for (size_t i = 0; i < MADE_UP_USABLE; i++)
        made_up_surface(&made, i)->pair.hardness_Pa *= 2; /* alike by chance */
    made_up_again(&made);
    assert_says_page(&made, "In contact area at 10.0\u00a0N the surfaces are alike.", "load over hardness");
    *area *= 1.1;
    made_up_again(&made);
    assert_says_page(&made, "In contact resistance at 10.0\u00a0N *alpha* is significantly better", "alike.");
    drop_target(&made, answers);
}

TEST_CASE(too_few_spots_are_told)
{
    struct made_up made;
    struct scene_asked target;
    struct answer *answers = calloc(MADE_UP_USABLE * model_count, sizeof *answers);
    assert_non_null(answers);
    made_up_make_of(&made, made_up_models(), PLAIN, NULL);
    set_target(&made, &target, answers);
    struct answer *leading = answers + made.comparison.leading;
    assert_says_page(&made, "0.1\u00a0mΩ takes", "spots"); /* not counted */
    for (size_t i = 0; i < MADE_UP_USABLE; i++)
        leading[i * model_count].spots_per_m2 = 20e6;
    made_up_again(&made);
    assert_says_page(&made, "0.1\u00a0mΩ takes", "spots"); /* twenty of them */
    leading[2 * model_count].spots_per_m2 = 1.6e6;
    made_up_again(&made);
    assert_says_page(&made, "**Too few spots for statistics**, on *gamma*: 1.6.", "surfaces:");
    leading[1 * model_count].spots_per_m2 = 3e6;
    made_up_again(&made);
    assert_says_page(&made, "**Too few spots for statistics**, on 2 surfaces: 1.6 to 3.0.", "on *gamma*:");
    leading[0].spots_per_m2 = 9e6;
    made_up_again(&made);
    assert_says_page(&made, "**Too few spots for statistics**: 1.6 to 9.0.", "surfaces:");
    drop_target(&made, answers);
    made_up_make(&made, NULL); /* without a target those where the page stands: 150 to 1125 on a square metre */
    assert_says_page(&made, "**Too few spots for statistics**: 1.5·10⁻⁴ to 0.0011.", "surfaces:");
    made_up_free(&made);
}

TEST_CASE(a_limit_names_the_one_surface_and_counts_several)
{
    static const enum limit_verdict verdicts[][MADE_UP_USABLE] = {{LIMIT_MET, LIMIT_CANNOT_TELL, LIMIT_MISSED},
                                                                  {LIMIT_MISSED, LIMIT_NO_VALUE, LIMIT_MISSED},
                                                                  {LIMIT_MET, LIMIT_MET, LIMIT_MET}};
    static const char *const says[] = {
        "ECR ≤ 0.1\u00a0mΩ: met by *beta*, **missed by *gamma***, undecided for *alpha*.",
        "ECR ≤ 0.1\u00a0mΩ: no value for *alpha*, **missed by 2 surfaces**.",
        "ECR ≤ 0.1\u00a0mΩ: all surfaces meet it."};
    struct made_up made;
    struct scene_asked limit = {.quantity = QUANTITY_ECR, .symbol = "ECR", .text = "0.1 mohm", .is_most = true};
    struct limit_check checks[MADE_UP_USABLE] = {{0}};
    made_up_make_of(&made, made_up_models(), PLAIN, NULL);
    made.scene.limits = &limit;
    made.scene.limit_count = 1;
    for (size_t k = 0; k < sizeof says / sizeof *says; k++) {
        for (size_t i = 0; i < MADE_UP_USABLE; i++) {
            checks[i].verdict = verdicts[k][i];
            made.surfaces[i].summary.limits = &checks[i];
        }
        made_up_again(&made);
        assert_says_page(&made, says[k], "by 1 s");
    }
    snprintf(limit.text, sizeof limit.text, "2.5e-05 K m2/W");
    made_up_again(&made);
    assert_says_page(&made, " ≤ 2.5·10⁻⁵\u00a0K·m²/W: all surfaces meet it.", "e-05");
    for (size_t i = 0; i < MADE_UP_USABLE; i++)
        made.surfaces[i].summary.limits = NULL;
    made_up_free(&made);
}

static void halve_area(struct made_up *made)
{
    for (size_t i = 0; i < MADE_UP_USABLE; i++)
        made_up_surface(made, i)->models[made->comparison.leading]->sensitivity.area[SENSITIVITY_SCAN_HALVED] = 0.5;
    made_up_again(made);
}

/* What limits the answer limits what is asked: resistance, area, or a resistance that is the film's. */
TEST_CASE(limits_are_those_of_what_is_asked)
{
    struct made_up made;
    struct scene_asked target = {0};
    struct answer *answers = calloc(MADE_UP_USABLE * model_count, sizeof *answers);
    assert_non_null(answers);
    made_up_make_of(&made, made_up_models(), PLAIN | EFFECT_BIT(EFFECT_FILM), NULL);
    halve_area(&made);
    assert_string_equal(view_at(made.view, "length_factor"), "2.0"); /* a film on half the area */
    assert_says_page(&made, " on *gamma*, film included.", "plating");
    made_up_free(&made);
    made_up_make_of(&made, made_up_models(), PLAIN, NULL);
    halve_area(&made);
    assert_string_equal(view_at(made.view, "length_factor"), "1.3");
    set_target(&made, &target, answers);
    target.quantity = QUANTITY_AREA;
    target.how = quantity_rows[QUANTITY_AREA].asked;
    snprintf(target.text, sizeof target.text, "1 %%");
    made_up_again(&made);
    assert_string_equal(view_at(made.view, "length_factor"), "2.0");
    assert_says_page(&made, "**1\u00a0% contact area takes 10.0\u00a0N**", "included");
    drop_target(&made, answers);
}

TEST_CASE(few_waves_and_a_scans_length_do_not_contradict)
{
    static const struct {
        double waves, factor;
        const char *says, *unsaid;
    } cases[] = {{10, 1.3, "scan length ×÷ 1.3 (a longer one)", "longest waves"},
                 {1.5, 1.3, "only 1.5 of its longest waves", "scan length"},
                 {1.5, 2.5, "scan length ×÷ 2.5 (a longer one)", "×÷ 1.3"}};
    struct made_up made;
    made_up_make_of(&made, made_up_models(), PLAIN, NULL);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        for (size_t i = 0; i < MADE_UP_USABLE; i++) {
            struct surface_summary *summary = made_up_surface(&made, i);
            summary->longest_waves = cases[k].waves;
            summary->models[made.comparison.leading]->sensitivity.ecr[SENSITIVITY_SCAN_HALVED] = cases[k].factor;
        }
        made_up_again(&made);
        assert_says_page(&made, cases[k].says, cases[k].unsaid);
    }
    made_up_free(&made);
}

TEST_CASE(an_end_beyond_the_loads_leaves_the_other)
{
    struct made_up made;
    struct scene_asked target;
    struct answer *answers = calloc(MADE_UP_USABLE * model_count, sizeof *answers);
    assert_non_null(answers);
    made_up_make_of(&made, made_up_models(), PLAIN, NULL);
    set_target(&made, &target, answers);
    struct answer *leading = answers + made.comparison.leading;
    leading[0].low = leading[model_count].high = NAN;
    made_up_again(&made);
    assert_says_page(&made, "10.0\u00a0N** (95 % ≥\u00a05.0) on *alpha*, 20.0\u00a0N (95 % ≤\u00a040) on *beta*,", "–");
    made_up_surface(&made, 2)->models[made.comparison.leading]->operating.value[QUANTITY_ECR] = NAN;
    made_up_surface(&made, 2)->pair.hardness_Pa = 5e6;
    made_up_again(&made);
    assert_says_page(
        &made,
        "At 10.0\u00a0N the contact resistance is not known (the load exceeds the hardness, 5.00\u00a0MPa) "
        "on *gamma*.",
        "1 more");
    drop_target(&made, answers);
}

/* Both ends of a known interval beyond the loads: the page says so once, and the terminal has no dash for it. */
TEST_CASE(both_ends_beyond_the_loads_are_told)
{
    struct made_up made;
    struct scene_asked target;
    struct answer *answers = calloc(MADE_UP_USABLE * model_count, sizeof *answers);
    assert_non_null(answers);
    made_up_make_of(&made, made_up_models(), PLAIN, NULL);
    set_target(&made, &target, answers);
    struct surface_record *record = (struct surface_record *)(uintptr_t)&made.results.surfaces[0];
    struct ensemble_band **bands = record->bands;
    answers[made.comparison.leading].low = answers[made.comparison.leading].high = NAN;
    made_up_again(&made);
    assert_says_page(&made, "20.0\u00a0N (95 % beyond the loads: widen `load`) on *beta*,", "–…");
    record->bands = NULL; /* nothing is known of how far it may be off */
    made_up_again(&made);
    record->bands = bands;
    assert_says_page(&made, "20.0\u00a0N on *beta*,", "beyond the loads");
    drop_target(&made, answers);
}

TEST_CASE(a_hardness_that_nobody_gives_is_told)
{
    struct made_up made;
    made_up_make_of(&made, made_up_models(), PLAIN, NULL);
    assert_says_page(&made, "At 10.0\u00a0N", "No hardness");
    made_up_surface(&made, 1)->pair.hardness_Pa = NAN;
    made_up_again(&made);
    assert_says_page(&made, "No hardness is given for *alpha*: nothing yields there.", "surfaces: nothing");
    made_up_surface(&made, 2)->pair.hardness_Pa = NAN;
    made_up_again(&made);
    assert_says_page(&made, "No hardness is given for 2 surfaces: nothing yields there.", "for *");
    made_up_surface(&made, 0)->pair.hardness_Pa = NAN;
    made_up_again(&made);
    assert_says_page(&made, "No hardness is given: nothing yields.", "there");
    made_up_free(&made);
}

/* Of two runs one passes the target of 0.1 mohm, 1e-10 ohm m²; then both do. */
TEST_CASE(a_target_that_some_runs_reach_says_how_many)
{
    double load[] = {1e-5, 1e-4, 1e-5, 1e-4}, value[] = {2e-10, 0.5e-10, 4e-10, 2e-10}, error[] = {NAN, NAN, NAN, NAN};
    struct measured_run runs[] = {{0, 1, 2}, {2, 3, 4}};
    struct made_up made;
    struct scene_asked target;
    struct answer *answers = calloc(MADE_UP_USABLE * model_count, sizeof *answers);
    double *resistance = calloc(model_count * 4, sizeof *resistance);
    assert_true(answers && resistance);
    made_up_make_of(&made, made_up_models(), PLAIN, NULL);
    free(made.answers[0].resistance);
    made.answers[0].resistance = resistance;
    made.measured[0] = (struct measured){.count = 4,
                                         .run_count = 2,
                                         .given = &made.scene.measured,
                                         .runs = runs,
                                         .load = load,
                                         .resistance = value,
                                         .error = error};
    set_target(&made, &target, answers);
    assert_says_page(&made, "Your measurement of *beta* reaches 0.1\u00a0mΩ at 3.16\u00a0N in 1 of 2 runs;",
                     "unloading");
    value[3] = 0.25e-10;
    made_up_again(&made);
    assert_says_page(&made, "Your measurement of *beta* reaches 0.1\u00a0mΩ at 3.16\u00a0N;", " runs;");
    drop_target(&made, answers);
}

static void limit_areas(struct made_up *made, size_t count)
{
    for (size_t m = 0; m < model_count; m++)
        if (made_up_surface(made, 0)->models[m])
            made_up_surface(made, 0)->models[m]->clamped = 0;
    made_up_surface(made, 0)->models[made->comparison.leading]->clamped = count;
    made_up_again(made);
}

TEST_CASE(one_is_not_several)
{
    struct made_up made;
    made_up_make_of(&made, made_up_models(), PLAIN, NULL);
    made.measured[0].count = made.run.end = 1;
    made.run.turn = 0;
    limit_areas(&made, 12);
    struct text report = report_of(&made);
    assert_says(&report, " 12 areas of a scale at a load were limited to what is possible, most on *beta*. ");
    assert_says(&report, " 1 surface was refused.");
    assert_says(&report, " is nearest to the point measured on *beta*.");
    text_free(&report);
    limit_areas(&made, 1);
    made_up_surface(&made, 0)->refused_scans = 2;
    made_up_again(&made);
    report = report_of(&made);
    assert_says(&report, " 1 area of a scale at a load was limited to what is possible, on *beta*. ");
    assert_says(&report, " 2 scans were left out.");
    text_free(&report);
    limit_areas(&made, 0);
    report = report_of(&made);
    assert_silent(&report, "limited to");
    text_free(&report);
    made_up_free(&made);
}

/* Two of three surfaces lack a law of a decade: one has none, one a narrow band. */
TEST_CASE(what_no_spectrum_tells_is_not_said)
{
    struct made_up made;
    made_up_make(&made, NULL);
    struct text report = report_of(&made);
    assert_says(&report, "No surface's γ is below 1 by more than its standard error. Carried on to ");
    assert_silent(&report, "No power law");
    assert_silent(&report, "does not tell");
    text_free(&report);
    made_up_surface(&made, 0)->power_law.found = POWER_LAW_BAND_NARROW;
    made_up_again(&made);
    report = report_of(&made);
    assert_says(&report, "No power law of a decade was found on *beta*.");
    text_free(&report);
    made_up_surface(&made, 1)->power_law.found = POWER_LAW_BAND_NONE;
    made_up_again(&made);
    report = report_of(&made);
    assert_says(&report, "No power law of a decade was found on 2 surfaces.");
    assert_says(&report, "Where the spectrum tells it, no surface's γ is below 1");
    assert_says(&report, " On 2 of 3 surfaces the spectrum does not tell γ");
    text_free(&report);
    made_up_surface(&made, 2)->power_law.found = POWER_LAW_BAND_NONE;
    made_up_again(&made);
    report = report_of(&made);
    assert_silent(&report, "is below 1 by");
    assert_silent(&report, "would take at most");
    text_free(&report);
    made_up_free(&made);
}

TEST_CASE(bodies_are_those_of_the_surfaces)
{
    struct made_up made;
    made_up_make_of(&made, made_up_models(), PLAIN, NULL);
    struct text report = report_of(&made);
    const char *const one = strstr(text_string(&report), "Bodies: ");
    assert_non_null(one);
    assert_null(strstr(one, " on *beta* and"));
    text_free(&report);
    for (size_t i = 0; i < MADE_UP_USABLE; i++)
        snprintf(made.names[i].bodies.material.name, sizeof made.names[i].bodies.material.name, "%s",
                 i == 1 ? "silver" : "gold");
    made_up_surface(&made, 1)->pair.hardness_Pa = NAN;
    made_up_again(&made);
    report = report_of(&made);
    assert_says(&report,
                "Bodies: gold against a rigid flat on *beta* and 1 more; silver against a rigid flat on *alpha*. ");
    assert_says(&report, "| 100 | 284 |\n");
    assert_says(&report, "| 100 | – |\n");
    assert_silent(&report, "hardness  MPa");
    text_free(&report);
    made_up_free(&made);
}

/* ---- The user's own template, and the terminal ---- */

TEST_CASE(a_template_of_the_user_takes_the_reports_place)
{
    struct made_up made;
    struct status status = {0};
    struct text out = {0};
    struct directory place = directory_make();
    const char source[] = "{{#rows}}{{surface}}: {{value.value}}\n{{/rows}}{{> joint}}";
    directory_write(&place, "my.md", source);
    const struct report_options how = {PROJECT_SOURCE "/templates", directory_path(&place, "my.md"), false};
    made_up_make_of(&made, made_up_models(), PLAIN, NULL);
    assert_int_equal(report_markdown(&out, made.view, &how, &status), STATUS_OK);
    assert_string_equal(text_string(&out), "beta: 150\u00a0µΩ\nalpha: 50.0\u00a0µΩ\ngamma: 375\u00a0µΩ\n\n");
    text_free(&out);
    /* its parts: those that lie beside it, else the program's, and none from elsewhere; itself is no part of it */
    static const struct {
        const char *source, *expected; /* NULL: refused */
    } cases[] = {
        {"{{> joint}}{{> mine}}", "mine: {{x}}, joint\n"},
        {"{{> my}}", NULL},
        {"{{> ../up}}", NULL},
        {"{{> in/../../up}}", NULL},
        {"{{> in/one}}", "one in it"},
        {"\xff", NULL},
        {"{{#rows}}{{#rows}}{{#rows}}{{#rows}}{{#rows}}{{#rows}}{{#rows}}{{#rows}}{{#rows}}{{#rows}}{{#rows}}{{#rows}}"
         "{{#rows}}{{#rows}}{{#rows}}{{#rows}}{{#rows}}{{#rows}}{{#rows}}{{#rows}}{{#rows}}{{#rows}}{{#rows}}{{#rows}}"
         "{{/rows}}{{/rows}}{{/rows}}{{/rows}}{{/rows}}{{/rows}}{{/rows}}{{/rows}}{{/rows}}{{/rows}}{{/rows}}{{/rows}}"
         "{{/rows}}{{/rows}}{{/rows}}{{/rows}}{{/rows}}{{/rows}}{{/rows}}{{/rows}}{{/rows}}{{/rows}}{{/rows}}{{/rows}}",
         NULL},
    };
    directory_write(&place, "t/mine.md", "mine: {{=< >=}}{{x}}<={{ }}=>, {{> joint}}\n");
    directory_write(&place, "t/joint.md", "joint");
    directory_write(&place, "t/in/one.md", "one in it");
    directory_write(&place, "up.md", "secret");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const struct report_options beside = {PROJECT_SOURCE "/templates", directory_path(&place, "t/my.md"), false};
        directory_write(&place, "t/my.md", cases[i].source);
        enum status_code rc = report_markdown(&out, made.view, &beside, &status);
        if (rc != (cases[i].expected ? STATUS_OK : strcmp(cases[i].source, "{{> my}}") == 0 ? STATUS_IO : STATUS_USAGE))
            fail_msg("%s: %s", cases[i].source, status.message);
        if (rc == STATUS_OK)
            assert_says(&out, cases[i].expected);
        status = (struct status){0};
        text_free(&out);
    }
    made_up_free(&made);
    directory_remove(&place);
}

TEST_CASE(the_terminal_shows_the_first_pages_table)
{
    struct made_up made;
    struct status status = {0};
    struct text out = {0};
    made_up_make_of(&made, made_up_models(), PLAIN, NULL);
    assert_int_equal(report_terminal(&out, "terminal", made.view, PROJECT_SOURCE "/templates", false, &status),
                     STATUS_OK);
    assert_says(&out, "surface  Rq/µm      α     γ  contact resistance");
    assert_says(&out, "beta     0.200  0.500  1.40              150\u00a0µΩ");
    assert_says(&out, "At 10.0\u00a0N the contact resistance is 50.0\u00a0µΩ");
    text_free(&out);
    made_up_free(&made);
}

/** Every sentence of the first page, whatever the names. */
TEST_CASE(the_terminal_says_what_the_page_says)
{
    static char hostile[] = "a*b`c*";
    struct made_up made;
    struct status status = {0};
    struct text table = {0};
    size_t sentences = 0;
    made_up_make_of(&made, made_up_models(), PLAIN, NULL);
    made.names[1].name = hostile;
    made_up_again(&made);
    struct text page = report_of(&made);
    assert_int_equal(report_terminal(&table, "terminal", made.view, PROJECT_SOURCE "/templates", false, &status),
                     STATUS_OK);
    for (char *at = table.data; *at; at++)
        *at = *at == '\n' ? ' ' : *at;
    *strstr(page.data, "\n|") = '\0';
    strtok(page.data, "\n"); /* the title */
    for (char *line; (line = strtok(NULL, "\n")); sentences++) {
        struct text plain = {0};
        for (const char *at = line; *at; at++) {
            bool kept = *at == '\\', less = strncmp(at, "&#60;", 5) == 0;
            at += kept ? 1 : less ? 4 : 0;
            text_add(&plain, kept || !strchr("*`", *at) ? "%c" : "", less ? '<' : *at);
        }
        assert_says(&table, text_string(&plain));
        text_free(&plain);
    }
    assert_true(sentences >= 5);
    assert_says(&table, "significantly better");
    assert_says(&table, "on a*b`c*, ");
    text_free(&table);
    text_free(&page);
    made_up_free(&made);
}

/* ---- docs/templates.md lists the view's names ---- */

static void check_names(const json_t *view, const char *document)
{
    const char *key;
    json_t *member;
    size_t i;
    if (json_is_array(view)) {
        json_array_foreach(view, i, member) check_names(member, document);
    } else if (json_is_object(view)) {
        json_object_foreach((json_t *)(uintptr_t)view, key, member)
        {
            char quoted[80];
            snprintf(quoted, sizeof quoted, "`%s`", key);
            if (!strstr(document, quoted))
                fail_msg("docs/templates.md does not name %s", quoted);
            check_names(member, document);
        }
    }
}

/** Adds all that src/report says. */
static void add_sources(struct text *out)
{
    static const char *const files[] = {"view.c",        "view_first.c",    "view_surfaces.c",
                                        "view_models.c", "view_accuracy.c", "view_findings.c",
                                        "view_export.c", "report.c",        "export.c"};
    struct status status = {0};
    for (size_t f = 0; f < sizeof files / sizeof *files; f++) {
        char path[300];
        snprintf(path, sizeof path, "%s/src/report/%s", PROJECT_SOURCE, files[f]);
        assert_int_equal(text_read_file(out, path, &status), STATUS_OK);
    }
    assert_int_equal(text_read_file(out, PROJECT_SOURCE "/src/chart/figures.c", &status), STATUS_OK);
    assert_int_equal(text_read_file(out, PROJECT_SOURCE "/src/contact/quantity.c", &status), STATUS_OK);
}

TEST_CASE(the_list_of_names_is_the_views)
{
    struct made_up made;
    struct status status = {0};
    struct text document = {0}, sources = {0};
    assert_int_equal(text_read_file(&document, PROJECT_SOURCE "/docs/templates.md", &status), STATUS_OK);
    made_up_make(&made, NULL);
    check_names(made.view, text_string(&document));
    made_up_free(&made);
    add_sources(&sources);
    for (const char *tick = strstr(text_string(&document), "## Names"); (tick = strchr(tick, '`'));) {
        size_t length = strcspn(tick + 1, "`");
        char name[80];
        snprintf(name, sizeof name, "\"%.*s\"", (int)length, tick + 1);
        bool factor = strstr(name, "_factor\"") != NULL; /* "%s_factor" */
        if (length > 1 && !factor && !strstr(text_string(&sources), name))
            fail_msg("docs/templates.md names %s, which the view has not", name);
        tick += length + 2;
    }
    text_free(&document);
    text_free(&sources);
}
