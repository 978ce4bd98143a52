/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What each section says of results made up to order: made_up_results.h gives the numbers, the expected texts are
 * worked out by hand from them. */
#include "analysis/direct_study.h"
#include "made_up_results.h"
#include "report/report.h"
#include "results/limits_of_answer.h"
#include "support.h"

#include <stdio.h>

static struct made_up made;

static int make(void **state)
{
    (void)state;
    made_up_make(&made, NULL);
    return 0;
}

static int end(void **state)
{
    (void)state;
    made_up_free(&made);
    return 0;
}

static void check(const struct section *section, const char *what, bool expected)
{
    struct text text = made_up_section(&made, section);
    bool there = strstr(text_string(&text), what) != NULL;
    if (there != expected)
        fprintf(stderr, "%s\n", text_string(&text)); /* cmocka would cut it */
    text_free(&text);
    if (there != expected)
        fail_msg("%s'%s'", expected ? "no " : "", what);
}

static void expect(const struct section *section, const char *what)
{
    check(section, what, true);
}

static void expect_not(const struct section *section, const char *what)
{
    check(section, what, false);
}

static struct curve_summary *model_of(size_t surface, const char *name)
{
    return made_up_surface(&made, surface)->models[made_up_model(name)];
}

/* ---------------------------------------------------------------- the whole */

static const char *const headings[] = {"# Made up",
                                       "## The surfaces",
                                       "## Material and load",
                                       "## Does the area converge",
                                       "## Surface beta in every model",
                                       "## The joint",
                                       "## All surfaces, model by model",
                                       "## Against a direct solution",
                                       "## Where the models may be trusted",
                                       "## What the answers hang on",
                                       "## How sure the numbers are",
                                       "## Measured contact resistance",
                                       "# Appendices",
                                       "## The findings of chapter 6",
                                       "## What accuracy costs",
                                       "## What was computed",
                                       "## Accuracy and time of every method tried",
                                       "## Models and sources"};
enum { HEADINGS = sizeof headings / sizeof *headings };

#define PLACED(name) TEST_WITH(name, make, end)

PLACED(test_every_section_is_reached_in_order)
{
    struct text text = {0};
    report_markdown(&text, &made.context);
    const char *at = text_string(&text);
    for (int h = 0; h < HEADINGS; h++) {
        const char *next = strstr(at, headings[h]);
        if (!next)
            fail_msg("no '%s' behind '%.30s'", headings[h], at);
        at = next + 1;
    }
    size_t count = 0;
    for (const char *p = text_string(&text); (p = strstr(p, "\n## ")); p++)
        count++;
    assert_int_equal(count, HEADINGS - 2);
    text_free(&text);
}

PLACED(test_sections_without_cause_are_left_out)
{
    static const int absent[] = {3, 5, 7, 9, 10, 11, 14, 16};
    struct text text = {0};
    plan_switch_off(&made.plan, EFFECT_CONVERGENCE);
    for (int e = EFFECT_DIRECT; e < EFFECT_COUNT; e++)
        plan_switch_off(&made.plan, (enum effect)e);
    made.results.convergence = NULL;
    made.results.measured = NULL;
    made.results.benchmark = NULL;
    made_up_surface(&made, 0)->repeats->count = 0;
    for (size_t i = 0; i < MADE_UP_USABLE; i++)
        for (size_t m = 0; m < model_count; m++)
            for (int c = 0; c < SENSITIVITY_CHANGES; c++)
                if (made_up_surface(&made, i)->models[m])
                    made_up_surface(&made, i)->models[m]->sensitivity.area[c] = NAN;
    made_up_again(&made);
    report_markdown(&text, &made.context);
    for (int h = 0, a = 0; h < HEADINGS; h++) {
        bool there = strstr(text_string(&text), headings[h]);
        bool off = a < 8 && h == absent[a];
        if (there == off)
            fail_msg("%s", headings[h]);
        a += off;
    }
    text_free(&text);
}

/* Each figure stands in the report once, and with everything on every row of the figures is among them that
 * the models of the thesis have. */
PLACED(test_every_figure_is_shown_once)
{
    struct text text = {0};
    report_markdown(&text, &made.context);
    size_t images = 0, rows[64] = {0};
    for (const char *p = text_string(&text); (p = strstr(p, "![")); p++)
        images++;
    for (size_t i = 0; i < made.figures.count; i++) {
        const struct figure *figure = &made.figures.figures[i];
        char link[96];
        snprintf(link, sizeof link, "](figures/%s.svg)", figure->number);
        const char *first = strstr(text_string(&text), link);
        if (!first || strstr(first + 1, link))
            fail_msg("%s is shown %s", figure->number, first ? "twice" : "nowhere");
        rows[figure->row - figure_rows]++;
    }
    assert_int_equal(images, made.figures.count);
    for (size_t r = 0; r < figure_row_count; r++) {
        bool others = figure_rows[r].beyond_thesis || figure_rows[r].kind == FIGURE_SENSITIVITY ||
                      figure_rows[r].kind == FIGURE_DIRECT || figure_rows[r].kind == FIGURE_DIRECT_RATIO ||
                      figure_rows[r].kind == FIGURE_PATCHES ||
                      (figure_rows[r].kind == FIGURE_BENCHMARK &&
                       figure_rows[r].chart >= BENCHMARK_DIRECT_AREA); /* of models and curves that are not made up */
        if (others)
            continue;
        if (rows[r] == 0)
            fail_msg("no figure of row %zu, '%s'", r, figure_rows[r].section);
        assert_int_equal(rows[r], figure_rows[r].kind == FIGURE_SURFACES ? 4
                                  : figure_rows[r].kind == FIGURE_SWEEP  ? 2
                                                                         : 1);
    }
    text_free(&text);
}

/* Brief: what stands before the rule, and of the figures the one that decides. */
PLACED(test_the_first_page_alone)
{
    struct text whole = {0}, brief = {0};
    report_markdown(&whole, &made.context);
    const char *rule = strstr(text_string(&whole), "\n---\n\n## The surfaces"),
               *chart = strstr(text_string(&whole), "![Figure 6-23. ");
    assert_true(rule && chart && chart < rule);
    expect_parts(rule, "### ECR against load\n\n![Figure 6-24. ", "\n\nFigure 6-23: see the first page.\n");
    figure_list_keep_deciding(&made.figures);
    assert_int_equal(made.figures.count, 1);
    assert_string_equal(made.figures.figures[0].number, "6-23");
    assert_true(made.figures.figures[0].terminal);
    made.context.brief = true;
    report_markdown(&brief, &made.context);
    assert_int_equal(brief.length, rule - whole.data);
    assert_memory_equal(brief.data, whole.data, brief.length);
    text_free(&whole);
    text_free(&brief);
}

/* Rows of a table have as many cells as its head, and nothing that is no number is printed as one. */
PLACED(test_tables_are_whole)
{
    struct text text = {0};
    report_markdown(&text, &made.context);
    size_t expected = 0, tables = 0;
    for (const char *line = text_string(&text); *line;) {
        size_t length = strcspn(line, "\n"), bars = 0;
        for (size_t i = 0; i < length; i++)
            bars += line[i] == '|';
        if (*line != '|')
            expected = 0;
        else if (expected == 0 && ++tables)
            expected = bars;
        else if (bars != expected)
            fail_msg("%zu cells for %zu in '%.*s'", bars, expected, (int)length, line);
        line += length + (line[length] == '\n');
    }
    assert_true(tables >= 15);
    expect_no_parts(text_string(&text), "nan", "inf ", "(null)");
    text_free(&text);
}

/* ---------------------------------------------------------------- sentences */

PLACED(test_what_the_sections_say)
{
    static const struct {
        const struct section *section;
        const char *says;
    } expected[] = {
        {&section_summary, "- 3 surfaces, Rq 0.100 to 0.400 µm, of tin, pressed against a rigid flat that conducts "
                           "like it at nominal pressures of 0.100 to 1000 MPa.\n"},
        {&section_summary,
         "**At 10.0 MPa ECR·Aₙ is 5.00·10⁻¹¹ Ω·m² (95 % 4.46·10⁻¹¹…5.61·10⁻¹¹; surface alpha) to "
         "3.75·10⁻¹⁰ Ω·m² (95 % 3.34·10⁻¹⁰…4.21·10⁻¹⁰; surface gamma)**, for scans of this length, by multiscale "
         "elastic-plastic at P/(Aₙ E′) = 1.00·10⁻⁴; on 1 mm² 5.00·10⁻⁵ to 3.75·10⁻⁴ Ω; the real "
         "contact area is 4.00 to 20.0 % of the nominal one; TCR·Aₙ is 1.00·10⁻⁵ to 7.50·10⁻⁵ "
         "K·m²/W.\n\n- 3 surfaces"},
        {&section_summary, "- **Surface alpha has the lowest ECR** there, for scans of this length: lower than surface "
                           "beta, the next (×0.333, "
                           "95 % 0.210…0.530, 1 and "
                           "2 scans), and than surface gamma, the worst (×0.133, 95 % 0.113…0.157, one scan each). It "
                           "comes first in 4 of "
                           "4 models.\n"},
        {&section_summary, "for surface beta at that load, the area is 4.00 (JG) to 10.0 % (multiscale "
                           "elastic-plastic), ECR·Aₙ 1.50·10⁻¹⁰ (multiscale elastic-plastic) to 3.75·10⁻¹⁰ Ω·m² "
                           "(JG); without GW, elastic and above the hardness there.\n"},
        {&section_summary, "multiscale elastic is nearest, off by a factor of 1.33 (root mean square over 3 of 3 "
                           "points) and 1.33 times the measured on average; GW is farthest, off by a factor of 2.67."},
        {&section_summary, "scales below the shortest wavelength known would take up to 25 % more of the area"},
        {&section_summary, "- **1 surface was refused**"},
        {&section_summary,
         "| beta | 0.200 | 10.0 (6.38…15.7) | 1.00 | 0.900 (0.574…1.41) | 1.50·10⁻¹⁰ (9.57·10⁻¹¹…2.35·10⁻¹⁰) | "
         "3.00·10⁻⁵ (1.91·10⁻⁵…4.70·10⁻⁵) | 450 | 450 | 450 | 450 | 3.00 | b | 1.00·10⁻³ |\n"},
        {&section_surfaces, "| beta | 0.200 | 0.160 | 0.200 | 1.00 | 200 | 1.400 ± 0.010 | 2.00…100 | 0.0812 ×÷ 1.26 "
                            "at 14.1 | 0.0812 ×÷ 1.26 | 3.00·10⁻¹⁹ | 0.20 | 0.500 |\n"},
        {&section_surfaces, "| gamma | 0.0100 | 0.00100 | 10.0 | 10000 | 2.00 | 0.360 | 0.0400 |\n"},
        {&section_material, "E′ = 100.0 GPa, C = 1.600"},
        {&section_material, "that is 0.100 to 1000 MPa of nominal pressure"},
        {&section_material, "| yield strength | S_y | 1.4·10⁷ | Pa |\n"},
        {&section_convergence, "- elastic: for 7 of 7 α and for γ from 1 up.\n"},
        {&section_convergence, "| beta | 1.40 | 66.7 | 0.400 | 25 | 0.400 | 25 |\n"},
        {&section_convergence, "5 of 9 curves have settled"},
        {&section_baseline,
         "| 1.00·10⁻⁵ | 1.00 | GW | 0.00250 | 4.00 | 0.998 | 0.998 | 6.00·10⁻⁹ | 0.00120 | 0.00122 | "
         "0.00600 |\n"},
        {&section_baseline, "| GW | 1.00 | 4.00·10⁻³ | 4.00·10⁻³ | 3.16·10⁻³ | 2.0 |\n"},
        {&section_baseline, "yielding multiplies it by 2.00 (multiscale elastic-plastic against multiscale elastic) "
                            "and by 1.60 (JG against GW)."},
        {&section_baseline, "before, they are there −3.00 σ (GW), −3.00 σ (JG)."},
        {&section_baseline, "lies at 32 to 79 % of the load to full contact. Multiscale and statistical curves lie "
                            "0.30 decades apart in ECR and 0.30 in area (elastic); 0.40 and 0.40 (plastic)."},
        {&section_baseline, "TCR is ECR times 1/(ρ k) = 2.000·10⁵ K/(W·Ω)"},
        {&section_baseline, "Scale dependence raises it by at most 2.0 %"},
        {&section_baseline, "A/Aₙ is 0.0250 (GW) to 0.100 (multiscale elastic-plastic).](figures/6-05.svg)"},
        {&section_baseline, "the separation is 0.900 σ (multiscale elastic-plastic) to 0.975 σ (GW).](figures/6-07"},
        {&section_all_surfaces, "| gamma | 5.00·10⁻³ | 2.50·10⁻³ | 1.00·10⁻² | 6.25·10⁻³ |\n"},
        {&section_all_surfaces, "A/Aₙ is 0.0400 (surface gamma) to 0.200 (surface alpha).](figures/6-11.svg)"},
        {&section_all_surfaces, "is 0.920 σ (surface alpha) to 0.984 σ (surface gamma).](figures/6-17.svg)"},
        {&section_all_surfaces, "| beta | 6.00 | 6.00 | 7.00 | 7.00 |\n"},
        {&section_checks, "TCR/ECR is 1/(ρ k) at every load"},
        {&section_checks, "statistical: plastic/elastic area 1.26 to 1.60, 23 of 23 loads"},
        {&section_repeats, "| beta | 2 scans | 0.200 (0.128…0.313) | 1.40 (1.22…1.58) | 0.00100 (2.62·10⁻⁵…0.0382) | "
                           "×÷ 1.57 | ×÷ 2.18 |\n"},
        {&section_repeats, "| alpha | 1 scan"},
        {&section_sensitivity, "| beta | multiscale elastic-plastic | 1.05 | 0.950 | 0.800 | 1.30 | 0.920 | 1.08 |\n"},
        {&section_sensitivity, "Doubling the cut-off leaves within 10 %, in the multiscale elastic-plastic model: area "
                               "on 3 of 3 and ECR on 3 of 3"},
        {&section_sensitivity, "| beta | multiscale elastic | 1.05 | 0.950 | 0.800 | 1.30 | – | – |\n"},
        {&section_sensitivity, "Halving the scan leaves within 10 %, in the multiscale elastic-plastic model: area on "
                               "0 of 3 and ECR on 0 of 3"},
        {&section_measured, "| multiscale elastic-plastic | 3 of 3 | 1.0·10⁻⁵ to 1.0·10⁻⁴ | 0.176 | −0.176 |\n"},
        {&section_measured, "from the measurements on surface beta: "},
        {&section_validity, "| beta | 0.0100 | 10 | 1.00·10⁻³ | 3.16·10⁻⁴ | – | 0 | 0 | 0 of 3 | at 0 of 27 |\n"},
        {&section_cost, "GW's area, load and conductance come from closed forms, within 1.0·10⁻¹³. JG's integrals "
                        "come from Gauss-Legendre panels at tolerance 1e-08, within 1.0·10⁻⁸. With them one more digit "
                        "takes 19 % more time. The thesis's Simpson rule of 1000 sub-intervals is off by 0.0020 and "
                        "takes 27 times as long. "},
        {&section_cost, "Simpson: beyond 300; adaptive: nowhere in the settings tried; Gauss-Legendre: nowhere"},
        {&section_cost, "`thesis` is off by up to 8.0 % in area, `numeric` by 0.10 %, at 3.0 times the time."},
        {&section_cost, "is off by up to: multiscale-elastic 0.0020; gw 0.0030."},
        {&section_cost, "sub-intervals"},
        {&section_cost, "take 0.75 (0.01), 1.5 (1e-10) times what they take at 1e-06, which is 1.0 % of the time"},
        {&section_cost, "ringed: what this report uses.](figures/cost-integrals.svg)"},
        {&section_cost, "Lower left is better.](figures/cost-curves.svg)"},
        {&section_methods, "| closure-area | thesis |  | 20 | 1.00 | 0.080 | used here |\n"},
        {&section_computed, "| thermal | run | reason 3 | in the same pass as the area"},
        {&section_computed, "- beta: beta.csv: a note\n"},
        {&section_computed, "- broken: broken.csv: no number in it\n"},
        {&section_sources, "- **JG** (eq. 4.31-4.38, 4.45-4.46, 4.54). Assumes: "},
    };
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++)
        expect(expected[i].section, expected[i].says);
}

/* One thing changed at a time: JG is the farthest valid model of the same law (2/0.8), and made_up_results.h has the
 * rest. */
PLACED(test_what_limits_the_answer)
{
    expect(
        &section_limits,
        "**What limits this answer**, the most first: factors on ECR·Aₙ, one thing changed at a time, on the surface "
        "that it changes most.\n\n| what | changed | factor | to measure next |\n|---|---|---:|---|\n"
        "| choice of model | the farthest valid one of the same material law | × 2.50 | nothing; let a direct solution "
        "run |\n"
        "| place of the scans | 95 % of the mean, for scans of this length | ×÷ 1.57 (surface beta) | more scans, at "
        "other places |\n"
        "| scan length | halved | × 1.30 | a longer scan |\n"
        "| hardness | raised by 10 % | × 1.08 | the hardness of the part |\n"
        "| bandwidth | cut-off doubled | × 0.950 | at a finer spacing, with a sharper tip |\n"
        "| resistivity | off by 5 % | ×÷ 1.05 | the resistivity of the part |\n");
}

/* A direct solution that has run is not asked for once more: on the surface in question nothing is left, else the
 * others are to be solved. */
PLACED(test_a_direct_solution_that_ran)
{
    struct direct_study *study = calloc(1, sizeof *study);
    assert_non_null(study);
    made.results.direct = study;
    made.results.direct_count = 1;
    struct limit_of_answer doubts[LIMITS_OF_ANSWER_MOST];
    assert_true(limits_of_answer(doubts, &made.results, made.context.comparison) > 0);
    study->surface = doubts[0].surface;
    expect(&section_limits, "same material law | × 2.50 | nothing |\n");
    study->surface = (doubts[0].surface + 1) % MADE_UP_SURFACES;
    expect(&section_limits, "same material law | × 2.50 | nothing; solve all directly (`direct: {surfaces: all}`) |\n");
    made.results.direct = NULL;
    made.results.direct_count = 0;
    free(study);
}

/* A model outside its range of validity is no choice; an elastic leading model is held against elastic ones. */
PLACED(test_models_that_are_no_choice)
{
    static const char row[] = "| choice of model | the farthest valid one of the same material law | × ";
    for (size_t i = 0; i < MADE_UP_USABLE; i++)
        model_of(i, "jg")->invalid_area_load = i == 2 ? NAN : 1e-4;
    expect(&section_limits, "law | × 2.50 |"); /* of gamma alone */
    model_of(2, "jg")->invalid_fit_load = 1e-5;
    expect_not(&section_limits, row);
    expect(&section_limits, "\n| place of the scans");
}

static void make_of(const char *first, const char *second, unsigned effects)
{
    made_up_free(&made);
    made_up_make_of(&made, MODEL_BIT(made_up_model(first)) | MODEL_BIT(made_up_model(second)), effects, NULL);
}

/* Without resistances surfaces are ranked by area, of which more is better. */
PLACED(test_the_best_by_area)
{
    make_of("multiscale-elastic", "gw", EFFECT_BIT(EFFECT_UNCERTAINTY));
    made.results.measured = NULL;
    expect(&section_summary, "**At 10.0 MPa the real contact area is 2.00 % (95 % 1.78…2.24; surface gamma) to 10.0 % "
                             "(95 % 8.91…11.2; surface alpha)** of the nominal one, for scans of this length, by "
                             "multiscale elastic at P/(Aₙ E′) "
                             "= 1.00·10⁻⁴.\n");
    expect(
        &section_summary,
        "- **Surface alpha has the largest area** there, for scans of this length: larger than surface beta, the next "
        "(×2.00, 95 % 1.26…3.18, 1 and 2 scans), and than surface gamma, the worst (×5.00, 95 % "
        "4.25…5.88, one scan each). It comes first in 2 of 2 models.");
    expect_not(&section_summary, "CR");
    expect(&section_baseline, "| 1.00·10⁻⁴ | 10.0 | GW | 0.0250 | 4.00 |\n");
    expect_not(&section_all_surfaces, "CR");
}

/* By TCR where there is no ECR; two surfaces have no next, and a single model no others to agree with. */
PLACED(test_the_best_by_heat)
{
    static const size_t two[] = {1, 2};
    make_of("multiscale-elastic", "multiscale-elastic", EFFECT_BIT(EFFECT_THERMAL) | EFFECT_BIT(EFFECT_UNCERTAINTY));
    made.results.usable_count = 2;
    memcpy(made.order, two, sizeof two);
    made.surfaces[0].summary.models[made_up_model("multiscale-elastic")]->exists = false;
    made_up_again(&made);
    expect(&section_summary, "- **Surface alpha has the lowest TCR** there, for scans of this length: lower than "
                             "surface gamma (×0.133, 95 % "
                             "0.113…0.157, one scan each).\n");
}

/* ---------------------------------------------------------------- ranking */

/** What is known of the answer that surfaces are ranked by, to be changed. */
static struct estimate *ecr_of(size_t surface)
{
    struct curve_summary *leading = made_up_surface(&made, surface)->models[made.comparison.leading];
    const struct estimate *known = curve_summary_estimate(leading, QUANTITY_ECR);
    assert_ptr_not_equal(known, &estimate_none);
    return &leading->estimates->of[known - leading->estimates->of];
}

/** Gives the answers that surfaces are ranked by a standard deviation of ln ECR; several scans or one. */
static void set_deviation(size_t surface, double s, bool several)
{
    struct estimate *estimate = ecr_of(surface);
    double value = estimate_value(estimate);
    struct status status = {0};
    const double scans[3] = {value * exp(-s), value, value * exp(s)}; /* of which the deviation is s */
    if (several)
        assert_int_equal(estimate_scans(estimate, scans, NULL, 3, true, &status), STATUS_OK);
    else
        *estimate = made_up_single(value, s, true);
}

/* Of ln 3 and ln 7.5 from the next: 2.3 hypot(s1, s2) may be that at most. */
PLACED(test_no_best_where_none_is_told_apart)
{
    set_deviation(0, 0.33, false); /* 2.3 hypot(0.33, 0.33) = 1.073 < ln 3 = 1.099 */
    set_deviation(1, 0.33, false);
    made_up_again(&made);
    expect(&section_summary, "- **Surface alpha has the lowest ECR** there");
    set_deviation(0, 0.34, false); /* 1.106 */
    set_deviation(1, 0.34, false);
    made_up_again(&made);
    expect(&section_summary, "- **No surface stands out by its ECR** there, for scans of this length: surface alpha is "
                             "not told apart from surface "
                             "beta (×0.333, 95 % 0.110…1.01, one scan each); from the other it is.\n");
    expect_not(&section_summary, "has the lowest");
}

/* Two groups of which the middle surface is in both. */
PLACED(test_letters_are_shared_by_those_not_told_apart)
{
    expect(&section_summary, " | 1 | a | 5.00·10⁻⁴ |\n"); /* alpha, beta, gamma, each told apart */
    expect(&section_summary, " | b | 1.00·10⁻³ |\n");
    expect(&section_summary, " | c | 2.50·10⁻³ |\n");
    for (size_t i = 0; i < MADE_UP_USABLE; i++)
        set_deviation(i, 0.4, false); /* 2.3 hypot(0.4, 0.4) = 1.30: beyond ln 3 and ln 2.5, not ln 7.5 = 2.01 */
    made_up_again(&made);
    expect(&section_summary, " | a | 5.00·10⁻⁴ |\n");
    expect(&section_summary, " | ab | 1.00·10⁻³ |\n");
    expect(&section_summary, " | b | 2.50·10⁻³ |\n");
    expect(&section_summary, "Surfaces that share a letter are not told apart by their ECR");
}

/* Welch's test of three scans each, adjusted for three pairs: t = ln 3/(s sqrt(2/3)) of 4 degrees of freedom. */
PLACED(test_ranking_of_several_scans)
{
    for (size_t i = 0; i < MADE_UP_USABLE; i++)
        set_deviation(i, 0.2, true);
    made_up_again(&made);
    expect(&section_summary, "- **Surface alpha has the lowest ECR** there, for scans of this length: lower than "
                             "surface beta, the next (×0.333, 95 % 0.212…0.525 of this pair alone, p = 0.0051 over all "
                             "pairs, 3 and 3 scans)");
    ecr_of(1)->count = 0; /* two are left, and one pair to adjust over */
    made_up_again(&made);
    expect(&section_summary, "(×0.400, 95 % 0.254…0.629, p = 0.005, 3 and 3 scans)");
    for (size_t i = 0; i < MADE_UP_USABLE; i++)
        set_deviation(i, 0.6, true);
    made_up_again(&made);
    expect(&section_summary, "- **No surface stands out by its ECR** there");
    expect_not(&section_summary, "has the lowest");
}

/* A scan that is not the same along its length gets no verdict, and what did not run no ranking. */
PLACED(test_no_verdict_without_grounds)
{
    ecr_of(1)->heterogeneous = true;
    made_up_again(&made);
    expect(&section_summary, "Single scans that are not the same along their length get no verdict.\n");
    expect_not(&section_summary, "has the lowest");
    expect(&section_repeats, "; **not the same along the scan** |");
    make_of("multiscale-elastic", "gw", EFFECT_BIT(EFFECT_ELECTRICAL));
    expect(&section_summary, "- **The surfaces are not ranked by ECR**: there is one scan of a surface, and the effect "
                             "`uncertainty`, which tells how far a scan at another place would be off, did not run; as "
                             "scanned, the largest value is 7.50 times the smallest.\n");
    expect_not(&section_summary, "has the lowest");
    expect_not(&section_summary, "share a letter");
    expect_not(&section_summary, "| alike |");
}

/* A surface of whose scatter nothing is known has no letter and no verdict, whatever its value. */
PLACED(test_no_test_no_verdict)
{
    ecr_of(1)->count = 0; /* alpha, of the lowest ECR */
    made_up_again(&made);
    expect(&section_summary, "- **Surface beta has the lowest ECR** there of those tested, for scans of this length: "
                             "lower than surface gamma (");
    expect(&section_summary, ". 1 more was not tested: how far another scan would be off is not known.\n");
    expect(&section_summary, " | – | – | 5.00·10⁻⁴ |\n"); /* alpha */
    expect(&section_summary, " | 1 | a | 1.00·10⁻³ |\n");
    expect(&section_summary, " | b | 2.50·10⁻³ |\n");
    set_deviation(0, 0.9, false);
    set_deviation(2, 0.9, false);
    made_up_again(&made);
    expect(&section_summary, "- **No surface stands out by its ECR** there, for scans of this length: surface beta is "
                             "not told apart from surface "
                             "gamma (×0.400, 95 % 0.0214…7.47, one scan each). 1 more was not tested");
    expect_not(&section_summary, "surface alpha (×");
    ecr_of(2)->half_width = NAN;
    made_up_again(&made);
    expect(&section_summary, "- **The surfaces are not ranked by ECR**: how far another scan would be off is known of "
                             "fewer than two; as scanned, the largest value is 7.50 times the smallest.\n");
    expect_not(&section_summary, "| alike |");
}

/* ---------------------------------------------------------------- thresholds */

static void set_beta(double gw, double jg)
{
    for (size_t i = 0; i < MADE_UP_USABLE; i++) {
        model_of(i, "gw")->beta = gw;
        model_of(i, "jg")->beta = jg;
    }
}

PLACED(test_the_range_of_beta)
{
    set_beta(4, 12);
    expect(&section_all_surfaces, "Every β lies in the expected 4…12.");
    expect(&section_checks, "6 of 6 lie in 4…12");
    set_beta(3.99, 12.01);
    expect(&section_all_surfaces, " 3 between 0 and 4 ");
    expect(&section_all_surfaces, " 3 above 12 ");
    expect(&section_checks, "0 of 6 lie in 4…12");
    set_beta(-0.01, 0);
    expect(&section_all_surfaces, " 3 negative ");
    expect(&section_all_surfaces, " 3 between 0 and 4 ");
    expect(&section_checks, "0 of 6 lie in 4…12, 3 below 0");
}

/* Of separation against area: less than a thousandth of sigma counts as closed. */
PLACED(test_what_is_left_at_full_contact)
{
    static const char closed[] = "Separation against area, multiscale elastic. Less than 0.001 σ is left",
                      open[] = "Separation against area, multiscale elastic. Where A = Aₙ first holds, 0 to 0.0011 σ";
    model_of(1, "multiscale-elastic")->gap_at_full = 0.0009;
    expect(&section_all_surfaces, closed);
    model_of(1, "multiscale-elastic")->gap_at_full = 0.0011;
    expect(&section_all_surfaces, open);
    for (size_t i = 0; i < MADE_UP_USABLE; i++)
        model_of(i, "multiscale-elastic")->gap_at_full = NAN;
    expect(&section_all_surfaces, "multiscale elastic. No surface reaches A = Aₙ within the loads.");
    size_t plastic = made_up_model("multiscale-plastic");
    made.surfaces[made.results.baseline].summary.models[plastic]->gap_at_full = 0.0009;
    expect_not(&section_baseline, "σ are left where the multiscale elastic-plastic area first is complete.");
    made.surfaces[made.results.baseline].summary.models[plastic]->gap_at_full = 0.0011;
    expect(&section_baseline, " 0.0011 σ are left where the multiscale elastic-plastic area first is complete.");
    model_of(0, "multiscale-plastic")->gap_at_full = 0.0099;
    expect(&section_checks, "below 0.01 in 3 of 3 curves");
    model_of(0, "multiscale-plastic")->gap_at_full = 0.0101;
    expect(&section_checks, "below 0.01 in 2 of 3 curves");
}

/* A caption says of how many surfaces it speaks. */
PLACED(test_captions_of_some_surfaces)
{
    made.comparison.models[made_up_model("jg")].extremes[QUANTITY_ECR].count = 2;
    expect(&section_all_surfaces, "ECR against load, JG. At P/(Aₙ E′) = 1.00·10⁻⁴, ECR·Aₙ is 1.25·10⁻¹⁰ Ω·m² (surface "
                                  "alpha) to 9.37·10⁻¹⁰ Ω·m² (surface gamma); 2 of 3 surfaces, the others are past "
                                  "full contact or without a solution.]");
    made.comparison.models[made_up_model("jg")].extremes[QUANTITY_ECR].count = 0;
    expect(&section_all_surfaces, "![Figure 6-25. ECR against load, JG.](figures/6-25.svg)");
    made.results.shown_count = 2;
    expect(&section_all_surfaces, "The charts show 2 of the 3 surfaces");
}

/* The last halving of the wavelength changes the area by less, or more, than 0.1 %. */
PLACED(test_what_has_settled)
{
    made_up_sweep(&made, CONVERGENCE_ALPHA, "multiscale-elastic", 2, 0.5 * 0.9991);
    expect(&section_convergence, "- elastic: for 7 of 7 α ");
    made_up_sweep(&made, CONVERGENCE_ALPHA, "multiscale-elastic", 2, 0.5 * 0.9989);
    expect(&section_convergence, "- elastic: for 6 of 7 α ");
    expect(&section_convergence, "- elastic-plastic: for 7 of 7 α ");
    expect(&section_convergence, "α varied, elastic. At P/(Aₙ E′) = 0.001, γ = 1.5. 6 of 7 curves have settled");
    expect(&section_checks, "elastic: settled for 6 of 7 α, 5 of 5 γ ≥ 1 and 0 of 4 γ < 1");
    for (size_t v = 0; v < 4; v++)
        made_up_sweep(&made, CONVERGENCE_GAMMA, "multiscale-plastic", v, 0.5);
    expect(&section_convergence, "- elastic-plastic: for 7 of 7 α and for every γ from 0 up.");
    made_up_sweep(&made, CONVERGENCE_GAMMA, "multiscale-elastic", 8, 0.4);
    expect(&section_convergence, "- elastic: for 6 of 7 α and for no γ.");
}

/* How many surfaces each limit of trust concerns. */
PLACED(test_the_limits)
{
    for (size_t i = 0; i < MADE_UP_USABLE; i++)
        for (size_t m = 0; m < model_count; m++)
            if (made_up_surface(&made, i)->models[m])
                made_up_surface(&made, i)->models[m]->extension.area_extended = 0.4 * (1 - 0.9e-3);
    expect(&section_summary, "- **Limits**: in JG the real contact bears more than the hardness of 284 MPa "
                             "(2.84 S_y, as none is given) on 1 of 3 surfaces (up to 6.2 S_y).\n");
    made_up_surface(&made, 2)->pair.hardness_Pa = 6.26e8; /* of a metal that hardens; it bears 625 MPa */
    expect_not(&section_summary, "Limits");
    made_up_surface(&made, 2)->pair.hardness_Pa = 6.24e8;
    expect_not(&section_baseline, "exceeds the hardness"); /* 250 MPa */
    made_up_surface(&made, 0)->pair.hardness_Pa = 2.49e8;
    expect(&section_baseline, " In JG the mean pressure P/A of the partial contact exceeds the hardness of 249 MPa "
                              "between P/(Aₙ E′) = 1.00·10⁻⁶ and 1.00·10⁻³ (up to 2.5 S_y).");
    made_up_surface(&made, 0)->pair.hardness_Pa = 2.84e8;
    expect(&section_summary, "- **Limits**: in JG");
    for (size_t i = 0; i < MADE_UP_USABLE; i++)
        made_up_surface(&made, i)->pair.hardness_Pa *= 10;
    expect_not(&section_summary, "Limits");
    expect(&section_summary, "2.50 (GW) to 10.0 %"); /* which is below it now */
    model_of(2, "multiscale-plastic")->extension.area_extended = 0.4 * (1 - 1.1e-3);
    expect(&section_summary, "would take up to 0.11 % more of the area.\n");
    made_up_surface(&made, 1)->jump_share = 0.49;
    expect_not(&section_summary, "a jump between the ends");
    made_up_surface(&made, 1)->jump_share = 0.51;
    expect(&section_summary, "a jump between the ends of the record draws γ towards 1 on 1 of 3 surfaces");
    made_up_surface(&made, 0)->power_law.knee_m = 1e-5;
    made_up_surface(&made, 0)->power_law.gamma_below = 1.2; /* it decides there */
    expect(&section_summary, "two slopes fit the spectrum better than one law on 1 of 3 surfaces");
    made_up_surface(&made, 2)->power_law.gamma = 0.99; /* within its error of 0.01 */
    expect_not(&section_summary, "γ is below 1");
    made_up_surface(&made, 2)->power_law.gamma = 0.98;
    expect(&section_summary, "γ is below 1 on 1 of 3 surfaces, so the elastic area depends on the sampling");
    model_of(0, "gw")->invalid_area_load = 1.1e-4; /* the middle load is 1e-4 */
    expect_not(&section_summary, "GW is outside");
    model_of(0, "gw")->invalid_area_load = 1e-4;
    model_of(1, "gw")->invalid_fit_load = 1e-5;
    expect(&section_summary, "GW is outside its range of validity at that load on 2 of 3 surfaces");
    model_of(2, "gw")->invalid_fit_load = 1e-5;
    expect(&section_summary, "GW is outside its range of validity at that load on all 3 surfaces");
}

PLACED(test_thresholds_of_the_checks)
{
    model_of(0, "gw")->area_slope = 1.0999;
    model_of(1, "gw")->area_slope = 0.9001;
    expect(&section_checks, "9 of 9 curves lie within 0.1 of 1");
    model_of(0, "gw")->area_slope = 1.1001;
    model_of(1, "gw")->area_slope = 0.8999;
    expect(&section_checks, "| The area is linear in the load | **in part** |");
    expect(&section_checks, "7 of 9 curves lie within 0.1 of 1");
    model_of(0, "jg")->elbow_load = 0.1001 * model_of(0, "jg")->full_load;
    expect(&section_checks, "in the last decade before it in 12 of 12 curves");
    model_of(0, "jg")->elbow_load = 0.0999 * model_of(0, "jg")->full_load;
    expect(&section_checks, "in the last decade before it in 11 of 12 curves");
    model_of(0, "jg")->sd_most = 0.0499;
    expect(&section_checks, "Scale dependence is negligible (below 5 %) | **holds**");
    model_of(0, "jg")->sd_most = 0.0501;
    expect(&section_checks, "Scale dependence is negligible (below 5 %) | **fails**");
    made.comparison.proportional_error = 0.9e-6;
    expect(&section_checks, "TCR is ECR in other units | **holds**");
    made.comparison.proportional_error = 1.1e-6;
    expect(&section_checks, "TCR is ECR in other units | **fails**");
}

PLACED(test_shares_of_the_load)
{
    model_of(0, "jg")->most_beyond_fit = 0.9e-4;
    model_of(0, "jg")->most_radius_clamped = 0.25;
    model_of(0, "jg")->invalid_fit_load = 2e-4;
    model_of(0, "multiscale-plastic")->yielding_scales = 2;
    model_of(0, "multiscale-plastic")->clamped = 17;
    made_up_surface(&made, 0)->jump_share = 0.6;
    expect(&section_validity,
           "| beta | 0.0100 | 60 | 1.00·10⁻³ | 3.16·10⁻⁴ | 2.00·10⁻⁴ | 0 | 25.0 | 2 of 3 | at 17 of 27 |\n");
    model_of(0, "jg")->most_beyond_fit = 1.1e-4;
    expect(&section_validity, "| 2.00·10⁻⁴ | 0.0110 | 25.0 |");
}

/* A row is the knee when the next digit more than doubles the time, but not one that is still off by a per cent. */
PLACED(test_the_knee)
{
    struct benchmark_row *rows = made.benchmark.rows; /* jg, Simpson: 4 and 5 */
    rows[4].error = 0.0101;
    expect(&section_cost, "Simpson: nowhere in the settings tried");
    rows[4].error = 0.0099;
    rows[5].error = 0.00099;
    rows[5].seconds = 1.99e-5;
    expect(&section_cost, "Simpson: nowhere in the settings tried");
    rows[5].seconds = 2.01e-5;
    expect(&section_cost, "Simpson: beyond 300");
}

PLACED(test_two_bodies)
{
    for (size_t i = 0; i < MADE_UP_SURFACES; i++) {
        made.bodies[i].counterface_kind = MATERIAL_COUNTERFACE_ELASTIC;
        made.bodies[i].counterface = *material_find("copper");
    }
    expect(&section_summary, "pressed against a smooth flat of copper");
    expect(&section_material, "| property | symbol | tin | copper | unit |\n|---|---|---:|---:|---|\n");
    for (size_t i = 0; i < MADE_UP_SURFACES; i++)
        made.bodies[i].counterface = made.bodies[i].material;
    expect(&section_material, "| property | symbol | tin, both bodies | unit |\n");
    plan_switch_off(&made.plan, EFFECT_PLASTICITY);
    expect_not(&section_material, "| S_y |");
    expect(&section_material, "| electrical resistivity |");
}
