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
    {"one_surface.rows.0.area_percent", "5.00"},
    {"all_surfaces.rows.0.cells.0.text", "6.00"},
    {"all_surfaces.rows.0.cells.1.text", "7.00"},
    {"inputs.rows.0.hash", "0123456789abcdef"},
    {"inputs.notes.0.line", "beta.csv: a note"},
    {"inputs.refused.0.why", "broken.csv: no number in it"},
    {"stability.refused", "1"},
    {"accuracy.tolerances.0.tolerance", "1·10⁻¹⁰"},
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
    assert_says(&report, "Your contact carries 0.67 of the predicted conductance");
    assert_says(&report, "**1 refused**");
    assert_says(&report, "| beta | 0.200 |");
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
    extern const struct scene_asked_row scene_asked_rows[];
    *target =
        (struct scene_asked){.row = &scene_asked_rows[0], .value = 1e-10, .factor = 1e-6, .unit = {.factor = 1e-3}};
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
    assert_says(&report, "| beta | 0.200 | 20.0");
    text_free(&report);
    answers[made.comparison.leading].kind = ANSWER_NOT_REACHED;
    made_up_again(&made);
    report = report_of(&made);
    assert_says(&report, "more than 20.0\u00a0N (95 %");
    assert_says(&report, "| beta | 0.200 | > 20.0");
    text_free(&report);
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
    assert_says(&out, "surface  Rq/µm  contact resistance");
    assert_says(&out, "beta     0.200              150\u00a0µΩ");
    assert_says(&out, "At 10.0\u00a0N the contact resistance is 50.0\u00a0µΩ");
    text_free(&out);
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
    static const char *const files[] = {"view.c",          "view_first.c",    "view_surfaces.c", "view_models.c",
                                        "view_accuracy.c", "view_findings.c", "view_export.c",   "report.c"};
    struct status status = {0};
    for (size_t f = 0; f < sizeof files / sizeof *files; f++) {
        char path[300];
        snprintf(path, sizeof path, "%s/src/report/%s", PROJECT_SOURCE, files[f]);
        assert_int_equal(text_read_file(out, path, &status), STATUS_OK);
    }
    assert_int_equal(text_read_file(out, PROJECT_SOURCE "/src/chart/figures.c", &status), STATUS_OK);
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
