/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the report says of targets and limits, on results whose answers are put in by hand. */
#include "made_up_results.h"
#include "report/report.h"
#include "support.h"

static struct made_up made;
static struct scene_asked targets[1], limits[2];

static const struct scene_asked_row *row_named(const char *name)
{
    const struct scene_asked_row *row = scene_asked_rows;
    while (strcmp(row->name, name) != 0)
        row++;
    return row;
}

static struct answer answer_of(enum answer_kind kind, double load, double low, double high, double spots_per_m2,
                               bool invalid)
{
    return (struct answer){.kind = kind,
                           .load = load,
                           .low = low,
                           .high = high,
                           .spots_per_m2 = spots_per_m2,
                           .invalid = invalid,
                           .counted_by = made_up_model("jg")};
}

static void put(size_t surface, const char *model, struct answer answer)
{
    made_up_surface(&made, surface)->answers[made_up_model(model)] = answer;
}

static void check(size_t surface, size_t limit, double value, double low, double high)
{
    struct limit_check *out = &made_up_surface(&made, surface)->limits[limit];
    *out = (struct limit_check){value, low, high, LIMIT_NO_VALUE};
    out->verdict = answers_judge(out, &limits[limit]);
}

/* E' is 1e11 Pa and A_n 1 mm², so that P/(A_n E') = 1e-6 is 0.1 N. */
static int setup(void **state)
{
    (void)state;
    made_up_make(&made, NULL);
    made.scene.load.unit_text[0] = '\0';
    targets[0] = (struct scene_asked){
        .row = row_named("ecr"), .value = 1e-9, .factor = 1e-9, .text = "1 mo|hm", .unit_text = "mo|hm"};
    limits[0] = (struct scene_asked){.row = row_named("ecr"),
                                     .value = 2e-9,
                                     .factor = 1e-9,
                                     .is_most = true,
                                     .is_upper = true,
                                     .text = "2 mohm",
                                     .unit_text = "mohm"};
    limits[1] = (struct scene_asked){.row = row_named("conductance"),
                                     .value = 1e-4,
                                     .factor = 1e3,
                                     .is_upper = true,
                                     .text = "10 kW/m2/K",
                                     .unit_text = "kW/m2/K"};
    made.scene.targets = targets;
    made.scene.target_count = 1;
    made.scene.limits = limits;
    made.scene.limit_count = 2;
    for (size_t i = 0; i < MADE_UP_SURFACES; i++) {
        struct surface_summary *summary = made_up_surface(&made, i);
        summary->answers = calloc(model_count, sizeof *summary->answers);
        summary->limits = calloc(2, sizeof *summary->limits);
        assert_true(summary->answers && summary->limits);
        for (size_t m = 0; m < model_count; m++)
            summary->answers[m] = answer_of(ANSWER_NONE, NAN, NAN, NAN, NAN, false);
    }
    put(1, "multiscale-plastic", answer_of(ANSWER_LOAD, 1e-6, 0.8e-6, 1.3e-6, 3e7, false));
    put(1, "gw", answer_of(ANSWER_LOAD, 5e-6, NAN, NAN, 6e7, false)); /* at its own load, which is another */
    struct answer hard = answer_of(ANSWER_LOAD, 6e-6, NAN, NAN, NAN, false), full = hard;
    hard.above_hardness = full.full = true;
    put(1, "multiscale-elastic", answer_of(ANSWER_LOAD, 2e-6, NAN, NAN, NAN, false));
    put(1, "jg", answer_of(ANSWER_LOAD, 9e-6, NAN, NAN, 5e6, true));
    put(0, "multiscale-plastic", answer_of(ANSWER_NOT_REACHED, 1e-2, NAN, NAN, NAN, false));
    put(0, "gw", answer_of(ANSWER_NONE, NAN, NAN, NAN, NAN, false));
    put(2, "multiscale-plastic", answer_of(ANSWER_LOAD, 4e-6, NAN, NAN, 7e6, true));
    put(2, "gw", hard);
    put(2, "jg", full);
    check(0, 0, 1.5e-9, 1e-9, 2.5e-9);
    check(1, 0, 1e-9, NAN, NAN);
    check(2, 0, 3e-9, 2.5e-9, 3.5e-9);
    check(0, 1, NAN, NAN, NAN);
    check(1, 1, 0.5e-4, 0.4e-4, 0.8e-4);
    check(2, 1, 2e-4, 1.6e-4, 2.5e-4);
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    made.scene.target_count = made.scene.limit_count = 0;
    made_up_free(&made);
    return 0;
}

static void expect(const struct text *text, const char *part)
{
    if (!strstr(text_string(text), part))
        fail_msg("'%s' is not in\n%s", part, text_string(text));
}

TEST_CASE(the_section)
{
    struct text text = made_up_section(&made, &section_answers), lead = {0};
    section_answers_lead(&lead, &made.context);
    expect(&text, "## Answers\n");
    expect(&lead, "- **ECR ≤ 1 mo\\|hm** takes 0.100 N (0.0800…0.130) on surface alpha, the least, and "
                  "0.400 N on surface gamma, the most (beyond the model's validity); not reached within the loads on "
                  "1 of 3 surfaces (multiscale elastic-plastic; intervals for scans of this length).\n");
    expect(&lead, "- Limit **ECR ≤ 2 mohm**: 1 of 3 surfaces meet it, 1 miss it, of 1 the interval straddles it.\n");
    expect(&lead, "- Limit **h ≥ 10 kW/m2/K**: 1 of 3 surfaces meet it, 1 miss it, 1 have no value.\n");
    expect(&text, "\n| alpha | 0.100 (0.0800…0.130) | 0.200 (multiscale elastic) to 0.500 (GW) | 30 (JG) |  |\n");
    expect(&text, "\n| beta | – | – | – | not reached up to 1e+03 N |\n");
    expect(&text,
           "\n| gamma | 0.400 | – | 7.0 (JG) | beyond the model's validity; too few spots for statistics (7) |\n");
    expect(&text, "\n| beta | ? cannot tell: 1.50 mohm (1.00…2.50) | – no value |\n");
    expect(&text, "\n| alpha | ✓ meets: 1.00 mohm | ✓ meets: 20.0 kW/m2/K (12.5…25.0) |\n");
    expect(&text, "\n| gamma | ✗ **misses**: 3.00 mohm (2.50…3.50) | ✗ **misses**: 5.00 kW/m2/K (4.00…6.25) |\n");
    text_free(&lead);
    text_free(&text);
}

/* Full contact, at which it is met at the latest; and a limit that was met below the load, where numbers end. */
TEST_CASE(what_is_known_without_a_number)
{
    struct answer *leading = &made_up_surface(&made, 2)->answers[made_up_model("multiscale-plastic")], kept = *leading;
    struct limit_check *of_beta = &made_up_surface(&made, 0)->limits[1], limit = *of_beta;
    leading->full = true;
    of_beta->verdict = LIMIT_MET;
    struct text text = made_up_section(&made, &section_answers), lead = {0};
    section_answers_lead(&lead, &made.context);
    expect(&lead, "and at most 0.400 N on surface gamma, the most");
    expect(&text, "\n| gamma | at most 0.400 | – | 7.0 (JG) | at full contact at the latest; beyond");
    expect(&text, " | ✓ meets: from a lighter load on |\n");
    *leading = kept;
    *of_beta = limit;
    text_free(&lead);
    text_free(&text);
}

TEST_CASE(the_lines_of_a_check)
{
    struct text text = {0};
    assert_int_equal(report_missed_limits(&text, &made.results), 2);
    assert_string_equal(
        text_string(&text),
        "surface 'gamma' misses the limit ECR ≤ 2 mohm: 3.00 mohm (2.50…3.50), for scans of this length\n"
        "surface 'gamma' misses the limit h ≥ 10 kW/m2/K: 5.00 kW/m2/K "
        "(4.00…6.25), for scans of this length\n");
    text_free(&text);
}

TEST_GROUP(setup, teardown)
