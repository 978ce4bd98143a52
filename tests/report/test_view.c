/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The view on results made up to order, whose numbers can be worked out by hand, and the report filled from it. */
#include "base/number_format.h"
#include "directory.h"
#include "made_up_results.h"
#include "report/report.h"

static struct made_up made;
static struct scene_asked target; /* of set_target(), with its answers */
static struct answer *answers;

/* Multiscale plastic leads. beta has ECR 3e-14/2/load: 1.5e-10 ohm m² at the middle load 1e-4, and 0.15 mohm on 1 mm²;
 * with film and plating 3e12 times that, so these do not run where ECR is asked for. */
enum {
    PLAIN = EFFECT_BIT(EFFECT_PLASTICITY) | EFFECT_BIT(EFFECT_SEPARATION) | EFFECT_BIT(EFFECT_ELECTRICAL) |
            EFFECT_BIT(EFFECT_THERMAL) | EFFECT_BIT(EFFECT_UNCERTAINTY)
};

static int free_made(void **state)
{
    (void)state;
    for (size_t i = 0; i < MADE_UP_USABLE; i++) { /* which the tests own */
        made.surfaces[i].summary.answers = NULL;
        made.surfaces[i].summary.limits = NULL;
    }
    answers = NULL;
    made_up_free(&made);
    return 0;
}

static int make_plain(void **state)
{
    (void)state;
    made_up_make_of(&made, made_up_models(), PLAIN, NULL);
    return 0;
}

static int make_whole(void **state)
{
    (void)state;
    made_up_make(&made, NULL);
    return 0;
}

#define TEST_OF_PLAIN(name) TEST_WITH(name, make_plain, free_made)
#define TEST_OF_WHOLE(name) TEST_WITH(name, make_whole, free_made)

/** A text or number of the view by a path such as "rows.1.value.value"; "" where it is not there. */
static const char *view_at(const json_t *view, const char *path)
{
    view = json_at(view, path);
    if (!json_is_number(view))
        return json_is_true(view) ? "true" : json_is_string(view) ? json_string_value(view) : "";
    struct text *words = support_text();
    if (json_is_integer(view))
        text_add(words, "%lld", (long long)json_integer_value(view));
    else
        number_format(words, json_number_value(view), 2);
    return text_string(words);
}

/** The words of the claim of that key; NULL: it is not made. */
static const char *claim_of(const char *key)
{
    static const char *const lists[] = {"claims", "more_claims"};
    size_t i;
    const json_t *claim;
    for (int k = 0; k < 2; k++)
        json_array_foreach (json_object_get(made.view, lists[k]), i, claim) {
            if (strcmp(view_at(claim, "key"), key) == 0)
                return view_at(claim, "text");
        }
    return NULL;
}

/** The report of what is made up by now, as Markdown. */
static char *report_of(void)
{
    struct text *out = support_text();
    made_up_again(&made);
    const struct report_options how = {PROJECT_SOURCE "/templates", NULL, false};
    expect_ok(report_markdown, out, made.view, &how);
    return out->data;
}

/** The first page of it. */
static char *page_of(void)
{
    char *page = report_of(), *end = strstr(page, "\n---\n");
    assert_non_null(end);
    *end = '\0';
    return page;
}

/** The lines of a paragraph, which are sentences, in one. */
static const char *joined_report(void)
{
    char *report = report_of();
    for (char *end = report; (end = strchr(end + 1, '\n'));)
        if (strchr(".;", end[-1]) && end[1] && !strchr("\n|-#!", end[1]))
            *end = ' ';
    return report;
}

#define report_says(...)  expect_parts(joined_report(), __VA_ARGS__)
#define report_lacks(...) expect_no_parts(joined_report(), __VA_ARGS__)

/** What the terminal shows. */
static char *terminal_of(void)
{
    struct text *out = support_text();
    expect_ok(report_terminal, out, "terminal", made.view, PROJECT_SOURCE "/templates", false);
    return out->data;
}

/** The same with lines of 80 columns joined. */
static const char *joined_terminal(void)
{
    char *table = terminal_of();
    for (char *at = table; *at; at++)
        *at = *at == '\n' ? ' ' : *at;
    return table;
}

/** The first page says `words` and not `unsaid`, and the terminal says them too, without the marks of Markdown. */
static void assert_says_page(const char *words, const char *unsaid)
{
    struct text *plain = support_text();
    const char *page = page_of();
    expect_parts(page, words);
    expect_no_parts(page, unsaid);
    for (const char *at = words; *at; at++)
        text_add(plain, strchr("*`", *at) ? "" : "%c", *at);
    expect_parts(joined_terminal(), text_string(plain));
}

static const struct {
    const char *path, *expected;
} first_page[] = {
    {"operating_load", "10.0\u00a0N"},
    {"asked.symbol", "contact resistance"},
    {"asked.unit", "µΩ"},
    {"rows.0.surface", "beta"},
    {"rows.0.rq_m", "2.0·10⁻⁷"},
    {"rows.0.letters", "b"},
    {"rows.1.value.value", "50.0"},
    {"rows.2.value.value", "375"},
    {"rows.2.value.interval", "326–431"},
    {"claims.0.key", "refused"},
    {"surfaces.rows.0.gamma", "1.4"},
    {"rows.0.gamma.error", "0.010"},
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
    {"accuracy.models.0.label", "multiscale elastic"},
    {"accuracy.models.0.time", "0.0010\u00a0ms"},
};

TEST_OF_PLAIN(the_first_page_and_the_tables_hold_the_numbers)
{
    for (size_t i = 0; i < sizeof first_page / sizeof *first_page; i++)
        if (strcmp(view_at(made.view, first_page[i].path), first_page[i].expected) != 0)
            fail_msg("%s: '%s', not '%s'", first_page[i].path, view_at(made.view, first_page[i].path),
                     first_page[i].expected);
}

TEST_OF_PLAIN(the_report_says_them_in_words)
{
    report_says(
        "**At 10.0\u00a0N the contact resistance is 50.0\u00a0µΩ (95\u00a0%: 43.5–57.4) on *alpha* and 375\u00a0µΩ",
        "*alpha* has a significantly better contact resistance than the next, *beta*",
        "*beta* conducts 0.667 times what the model says", "**Not used: 1 of 4 files**",
        "| beta | 150 (96–240) | b | 0.200 | 0.500 | 1.400 ± 0.010 |", "Table 6.2", "Table 6.3");
    report_lacks("{{", "\n\n\n", "Does the area converge", "The joint");
}

/** A target of the leading model on every surface, met at twice, once and four times the middle load. */
static void set_target(void)
{
    static const double loads[MADE_UP_USABLE] = {2e-4, 1e-4, 4e-4};
    answers = support_room(MADE_UP_USABLE * model_count * sizeof *answers);
    target = (struct scene_asked){.quantity = QUANTITY_ECR,
                                  .how = quantity_rows[QUANTITY_ECR].asked,
                                  .value = 1e-10,
                                  .factor = 1e-9,
                                  .unit = {.factor = 1e-3}};
    snprintf(target.text, sizeof target.text, "0.1 mohm");
    snprintf(target.unit_text, sizeof target.unit_text, "mohm");
    made.scene.targets = &target;
    made.scene.target_count = 1;
    for (size_t i = 0; i < MADE_UP_USABLE; i++) {
        for (size_t m = 0; m < model_count; m++)
            answers[i * model_count + m] = (struct answer){
                .kind = ANSWER_LOAD, .load = loads[i], .low = loads[i] / 2, .high = loads[i] * 2, .spots_per_m2 = NAN};
        made.surfaces[i].summary.answers = answers + i * model_count;
    }
    made_up_again(&made);
}

TEST_OF_PLAIN(a_target_is_answered_in_newtons)
{
    set_target();
    assert_says_page("**To reach 0.1\u00a0mΩ, *alpha* needs 10\u00a0N (95\u00a0%: 5.0–20) and *gamma* needs "
                     "40\u00a0N (95\u00a0%: 20–80).**",
                     "needs at most");
    report_says("| beta | 20 (10–40) | 0.15 (0.096–0.24) |");
    expect_parts(terminal_of(), "\nbeta          20   10–40                   0.15     0.096–0.24\n");
    answers[plan_leading_model(&made.plan)].kind = ANSWER_NOT_REACHED;
    report_says("and *beta* needs more than 20.0\u00a0N.**", "| beta | &#62;\u00a020.0 |");
    expect_parts(terminal_of(), ">\u00a020.0");
    answers[plan_leading_model(&made.plan)].kind = ANSWER_LIGHTEST;
    report_says("| beta | ≤\u00a020.0 |");
    answers[model_count + plan_leading_model(&made.plan)].kind = ANSWER_LIGHTEST;
    report_says("*alpha* needs at most 10.0\u00a0N");
}

TEST_OF_PLAIN(names_from_outside_mean_nothing)
{
    static char hostile[] = "a*b|<script>`x`[l](http://e)\x1b[2J";
    made.names[0].name = hostile;
    report_says("a\\*b\\|&#60;script&#62;\\`x\\`\\[l\\](http\\://e)\\\\x1b\\[2J");
    report_lacks("<script>", "\x1b");
}

TEST_OF_WHOLE(findings_are_told)
{
    report_says("| 6.3.1 | The area is linear in the load | holds | 9 of 9");
}

/* ---- Sentences, each beside an input that it is not true of ---- */

TEST_OF_PLAIN(a_limit_has_a_column_and_a_third_is_a_claim)
{
    static const enum limit_verdict verdicts[][MADE_UP_USABLE] = {{LIMIT_MET, LIMIT_UNDECIDED, LIMIT_MISSED},
                                                                  {LIMIT_MISSED, LIMIT_NO_VALUE, LIMIT_MISSED},
                                                                  {LIMIT_MET, LIMIT_MET, LIMIT_MET}};
    static const char *const cells[][MADE_UP_USABLE] = {
        {"✓ met", "? undecided", "✗ missed"}, {"✗ missed", "–", "✗ missed"}, {"✓ met", "✓ met", "✓ met"}};
    static const char *const says[] = {"ECR ≤ 0.1\u00a0mΩ is missed by gamma, ",
                                       "ECR ≤ 0.1\u00a0mΩ is missed by beta and gamma, without a value for ",
                                       "ECR ≤ 0.1\u00a0mΩ is met by "};
    struct scene_asked limits[3];
    struct limit_check checks[MADE_UP_USABLE][3] = {{{0}}};
    for (int l = 0; l < 3; l++)
        limits[l] =
            (struct scene_asked){.quantity = QUANTITY_ECR, .symbol = "ECR", .text = "0.1 mohm", .is_most = true};
    made.scene.limits = limits;
    made.scene.limit_count = 3;
    for (size_t k = 0; k < sizeof says / sizeof *says; k++) {
        for (size_t i = 0; i < MADE_UP_USABLE; i++) {
            for (int l = 0; l < 3; l++)
                checks[i][l].verdict = verdicts[k][i];
            made.surfaces[i].summary.limits = checks[i];
        }
        made_up_again(&made);
        assert_says_page(says[k], "by 1 s");
        for (size_t i = 0; i < MADE_UP_USABLE; i++)
            report_says(filled("| %s | %s | %s | %s |", made.names[i].name,
                               i == 0   ? "150 (96–240)"
                               : i == 1 ? "50.0 (43.5–57.4)"
                                        : "375 (326–431)",
                               cells[k][i], cells[k][i]));
    }
    snprintf(limits[2].text, sizeof limits[2].text, "2.5e-05 K m2/W");
    assert_says_page(" ≤ 2.5·10⁻⁵\u00a0K·m²/W is met by ", "e-05");
}

/* The roughest is 4 times as rough as the smoothest: of scans of w longest waves that is two standard deviations of
 * chance where 2 sqrt(0.25 (1/w + 1/w)) = ln 4, w = 1.041. */
TEST_WITH(roughness_that_may_be_chance_orders_nothing, NULL, free_made)
{
    static const double waves[] = {1.02, 1.06};
    const size_t strip = model_named("strip-plastic");
    made_up_make_of(&made, made_up_models() | MODEL_BIT(strip), PLAIN, NULL);
    for (size_t i = 0; i < MADE_UP_USABLE; i++) /* one model that does not rise */
        made_up_surface(&made, i)->models[strip]->operating.value[QUANTITY_ECR] = 1e-10;
    for (int k = 0; k < 2; k++) {
        for (size_t i = 0; i < MADE_UP_USABLE; i++)
            made_up_surface(&made, i)->longest_waves = waves[k];
        made_up_again(&made);
        assert_int_equal(claim_of("by-roughness") != NULL, k);
    }
    made_up_surface(&made, 1)->longest_waves = 1.02; /* that of the smoothest counts, and that of the roughest */
    made_up_surface(&made, 2)->longest_waves = 1.04;
    made_up_again(&made);
    assert_null(claim_of("by-roughness"));
    made_up_surface(&made, 2)->independent = 2;
    made_up_again(&made);
    assert_string_equal(claim_of("by-roughness"),
                        "Models differ on roughness: multiscale elastic-plastic predicts that contact resistance rises "
                        "with it (50 to 370\u00a0µΩ), unlike strip transfer with hardness.");
}

static bool convergence_says(const char *name)
{
    made_up_again(&made);
    return json_is_true(json_object_get(json_object_get(made.view, "convergence"), name));
}

/* Elastic area is to settle from gamma = 1 on, and only then; plastic area anywhere. */
TEST_OF_WHOLE(the_convergence_study_is_read)
{
    enum { BELOW = 3, AT = 4, COUNT = 9 }; /* gamma 0.75, 1 */
    for (size_t v = 0; v < COUNT; v++) {
        made_up_sweep(&made, CONVERGENCE_GAMMA, "multiscale-elastic", v, v < AT ? 0.1 : 0.5);
        made_up_sweep(&made, CONVERGENCE_GAMMA, "multiscale-plastic", v, 0.5);
    }
    assert_true(convergence_says("as_expected"));
    assert_true(convergence_says("yielding_ends_it"));
    made_up_sweep(&made, CONVERGENCE_GAMMA, "multiscale-plastic", BELOW, 0.1);
    assert_true(convergence_says("as_expected"));
    assert_false(convergence_says("yielding_ends_it"));
    made_up_sweep(&made, CONVERGENCE_GAMMA, "multiscale-plastic", BELOW, 0.5);
    made_up_sweep(&made, CONVERGENCE_GAMMA, "multiscale-elastic", BELOW, 0.5);
    assert_false(convergence_says("as_expected"));
    assert_true(convergence_says("yielding_ends_it"));
    made_up_sweep(&made, CONVERGENCE_GAMMA, "multiscale-elastic", BELOW, 0.1);
    made_up_sweep(&made, CONVERGENCE_GAMMA, "multiscale-elastic", AT, 0.1);
    assert_false(convergence_says("as_expected"));
}

TEST_OF_PLAIN(an_end_beyond_the_loads_leaves_the_other)
{
    set_target();
    struct answer *leading = answers + plan_leading_model(&made.plan);
    leading[0].high = leading[model_count].low = NAN;
    report_says("| beta | 20 (≥\u00a010) |", "| alpha | 10 (≤\u00a020) |");
    made_up_surface(&made, 2)->models[plan_leading_model(&made.plan)]->operating = quantity_nothing();
    made_up_surface(&made, 2)->pair.hardness_Pa = 5e6;
    assert_says_page("**The load exceeds the hardness:** 10.0\u00a0MPa on *gamma*, which yields at 5.00\u00a0MPa.",
                     "1 more");
}

/* Both ends of a known interval beyond the loads: the page says so once, and the terminal has no dash for it. */
TEST_OF_PLAIN(both_ends_beyond_the_loads_are_told)
{
    set_target();
    struct answer *leading = &answers[plan_leading_model(&made.plan)];
    leading->low = leading->high = NAN;
    leading->wider = true;
    assert_says_page(
        "**Loads too narrow:** the load of *beta* or an end of its interval is beyond those of this report", "–…");
    report_says("| beta | 20 |");
    leading->wider = false; /* nothing is known of how far it may be off, or no load would tell */
    made_up_again(&made);
    assert_null(claim_of("loads-short"));
}

/* Of two runs one passes the target of 0.1 mohm, 1e-10 ohm m², at sqrt(10) N; then both do, there. */
TEST_OF_PLAIN(a_target_that_was_measured_is_answered_by_that)
{
    double load[] = {1e-5, 1e-4, 1e-5, 1e-4}, value[] = {2e-10, 0.5e-10, 4e-10, 2e-10}, error[] = {NAN, NAN, NAN, NAN};
    struct measured_run runs[] = {{0, 1, 2}, {2, 3, 4}};
    free(made.answers[0].resistance);
    made.answers[0].resistance = calloc(model_count * 4, sizeof(double));
    assert_non_null(made.answers[0].resistance);
    made.measured[0] = (struct measured){.count = 4,
                                         .run_count = 2,
                                         .given = &made.scene.measured,
                                         .runs = runs,
                                         .load = load,
                                         .resistance = value,
                                         .error = error};
    set_target();
    assert_says_page("the answer above is the model's", "Your test:**");
    made.scene.measured.carry = true;
    assert_says_page("**Your test:** *beta* conducts ", "the answer above is");
    report_says("| beta | 3.16 measured |");
    value[3] = 0.25e-10;
    assert_says_page("**Your test:** *beta* conducts ", "the answer above is");
    made.scene.measured.carry = false;
}

static void limit_areas(size_t count)
{
    for (size_t m = 0; m < model_count; m++)
        if (made_up_surface(&made, 0)->models[m])
            made_up_surface(&made, 0)->models[m]->clamped = 0;
    made_up_surface(&made, 0)->models[plan_leading_model(&made.plan)]->clamped = count;
    made_up_again(&made);
}

TEST_OF_PLAIN(one_is_not_several)
{
    made.measured[0].count = made.run.end = 1;
    made.run.turn = 0;
    limit_areas(12);
    report_says("12 areas of a scale at a load were limited to what is possible.\n",
                " is nearest to the point measured on *beta*.");
    limit_areas(1);
    report_says("1 area of a scale at a load was limited to what is possible.\n");
    limit_areas(0);
    report_lacks("limited to");
    report_says("No area was limited, and no fit clamped.");
}

/* Of digits that took no time nothing is told. */
TEST_OF_PLAIN(digits_that_cost_nothing)
{
    report_lacks("instead of 1e-2");
    for (size_t i = 0; i < made.benchmark.count; i++)
        made.benchmark.rows[i].seconds *= made.benchmark.rows[i].tolerance < 1e-12 ? 1.01 : 1;
    made_up_again(&made);
    report_says("Solving every curve to 1e-13 instead of 1e-2 takes ");
}

/* A model whose error is not known took its time even so; one that is known is of what made it. */
TEST_OF_PLAIN(the_error_of_a_map)
{
    report_says("![Error versus time of models on beta, ");
    for (size_t i = 0; i < BENCHMARK_STEPS; i++)
        made.benchmark.rows[i].model = model_named("direct");
    report_says("| direct solution of the map | – | 0.0010\u00a0ms |\n",
                "![Error versus time of models whose error is known, on beta, ");
    report_lacks("that of the map's direct solution", "| ×÷  |");
    struct estimate all[CURVE_ESTIMATES] = {[QUANTITY_ECR] = estimate_of_error(1e-9, 0.2, 3)};
    struct curve_summary **solved = &made_up_surface(&made, made.results.baseline)->models[model_named("direct")];
    assert_non_null(*solved = calloc(1, sizeof **solved));
    expect_ok(curve_summary_put_estimates, *solved, all);
    report_says("; that of the map's direct solution is from its size and grid.",
                "Error versus time of models on beta, ");
    made.surfaces[made.results.baseline].tiles.def.cutoff = 6;
    report_says("; that of the map's direct solution is from its size, grid and low-pass.");
}

/* Two of three surfaces lack a law of a decade: one has none, one a narrow band. */
TEST_OF_WHOLE(what_no_spectrum_tells_is_not_said)
{
    report_says("No surface's γ is below 1 by more than its standard error. Extended to ");
    report_lacks("No power law", "does not tell");
    made_up_surface(&made, 0)->power_law.found = POWER_LAW_BAND_NARROW;
    report_says("No power law of a decade was found on *beta*.");
    made_up_surface(&made, 1)->power_law.found = POWER_LAW_BAND_NONE;
    report_says("No power law of a decade was found on 2 surfaces.",
                "Where the spectrum tells it, no surface's γ is below 1",
                " On 2 of 3 surfaces the spectrum does not tell γ");
    made_up_surface(&made, 2)->power_law.found = POWER_LAW_BAND_NONE;
    report_lacks("is below 1 by", "would lower the area");
}

TEST_OF_PLAIN(bodies_are_those_of_the_surfaces)
{
    const char *const one = strstr(report_of(), "Bodies: ");
    assert_non_null(one);
    assert_null(strstr(one, " on *beta* and"));
    for (size_t i = 0; i < MADE_UP_USABLE; i++)
        snprintf(made.names[i].bodies.material.name, sizeof made.names[i].bodies.material.name, "%s",
                 i == 1 ? "silver" : "gold");
    made_up_surface(&made, 1)->pair.hardness_Pa = NAN;
    report_says("Bodies: gold against a rigid body on *beta* and 1 more; silver against a rigid body on *alpha*. ",
                "| 100 | 284 |\n", "| 100 | – |\n");
    report_lacks("hardness  MPa");
}

/* ---- The user's own template, and the terminal ---- */

TEST_OF_PLAIN(a_template_of_the_user_takes_the_reports_place)
{
    struct status status = {0};
    struct text *whole = support_text();
    struct directory place = directory_make();
    const char source[] = "{{#rows}}{{surface}}: {{value.value}}\n{{/rows}}{{> joint}}";
    directory_write(&place, "my.md", source);
    const struct report_options how = {PROJECT_SOURCE "/templates", directory_path(&place, "my.md"), false};
    expect_ok(report_markdown, whole, made.view, &how);
    assert_string_equal(text_string(whole), "beta: 150\nalpha: 50.0\ngamma: 375\n\n");
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
        struct text *out = support_text();
        enum status_code rc = report_markdown(out, made.view, &beside, &status);
        if (rc != (cases[i].expected ? STATUS_OK : strcmp(cases[i].source, "{{> my}}") == 0 ? STATUS_IO : STATUS_USAGE))
            fail_msg("%s: %s", cases[i].source, status.message);
        if (rc == STATUS_OK)
            expect_parts(text_string(out), cases[i].expected);
        status = (struct status){0};
    }
    directory_remove(&place);
}

TEST_OF_PLAIN(the_terminal_shows_the_first_pages_table)
{
    expect_parts(terminal_of(), "\nsurface  contact resistance/µΩ       95 %\n");
    expect_parts(terminal_of(), "\nbeta                       150     96–240\n");
    expect_parts(terminal_of(), "At 10.0\u00a0N the contact resistance is 50.0\u00a0µΩ");
}

/** Every sentence of the first page, whatever the names. */
TEST_OF_PLAIN(the_terminal_says_what_the_page_says)
{
    static char hostile[] = "a*b`c*";
    size_t sentences = 0;
    made.names[1].name = hostile;
    made_up_again(&made);
    char *page = page_of();
    const char *table = joined_terminal();
    strtok(page, "\n"); /* the title */
    for (char *line; (line = strtok(NULL, "\n"));) {
        if (strncmp(line, "- ", 2) != 0 && strncmp(line, "**", 2) != 0)
            continue; /* the table and the figures */
        sentences++;
        struct text *plain = support_text();
        for (const char *at = line; *at; at++) {
            bool kept = *at == '\\', less = strncmp(at, "&#60;", 5) == 0;
            at += kept ? 1 : less ? 4 : 0;
            text_add(plain, kept || !strchr("*`", *at) ? "%c" : "", less ? '<' : *at);
        }
        expect_parts(table, text_string(plain));
    }
    assert_true(sentences >= 5);
    expect_parts(table, "significantly better");
    expect_parts(table, "on a*b`c* and ");
}

/* ---- docs/templates.md lists the view's names ---- */

/* Names of results.json, which docs/results.schema.json has, are meant by "as results.json". */
static void check_names(const json_t *view, const char *document, const char *schema)
{
    const char *key;
    json_t *member;
    size_t i;
    if (json_is_array(view)) {
        json_array_foreach (view, i, member)
            check_names(member, document, schema);
    } else if (json_is_object(view)) {
        json_object_foreach ((json_t *)(uintptr_t)view, key, member) {
            if (!strstr(document, filled("`%s`", key)) && !strstr(schema, filled("\"%s\"", key)))
                fail_msg("docs/templates.md does not name %s", key);
            if (strcmp(key, "numbers") != 0 || !json_is_object(member)) /* a claim's, which its words name */
                check_names(member, document, schema);
        }
    }
}

/** All that src/report says. */
static const char *sources(void)
{
    struct text *out = support_text();
    static const char *const files[] = {"report/view.c",        "report/view_page.c",     "report/view_surfaces.c",
                                        "report/view_models.c", "report/view_accuracy.c", "report/view_findings.c",
                                        "report/view_export.c", "report/report.c",        "report/export.c",
                                        "output/json.c",        "output/tables.c",        "claims/claims.c",
                                        "chart/figures.c",      "contact/quantity.c",     "material/material.c"};
    for (size_t f = 0; f < sizeof files / sizeof *files; f++)
        expect_ok(text_read_file, out, filled("%s/src/%s", PROJECT_SOURCE, files[f]));
    return text_string(out);
}

TEST_OF_WHOLE(the_list_of_names_is_the_views)
{
    const char *document = directory_read(PROJECT_SOURCE, "docs/templates.md"), *said = sources();
    check_names(made.view, document, directory_read(PROJECT_SOURCE, "docs/results.schema.json"));
    for (const char *tick = strstr(document, "## Names"); (tick = strchr(tick, '`'));) {
        size_t length = strcspn(tick + 1, "`");
        char name[80];
        snprintf(name, sizeof name, "\"%.*s\"", (int)length, tick + 1);
        bool factor = strstr(name, "_factor\"") != NULL; /* "%s_factor" */
        if (length > 1 && !factor && !strstr(said, name))
            fail_msg("docs/templates.md names %s, which the view has not", name);
        tick += length + 2;
    }
}
