/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What people ask, each answered on the first page of a scene that asks it: the value stands there, and is the data's.
 */
#include "cli/process.h"

#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/** The first page of a report. To be freed. */
static char *first_page(const char *place, const char *out)
{
    char path[64];
    snprintf(path, sizeof path, "%s/report.md", out);
    char *page = workspace_read(place, path), *end = strstr(page, "\n---\n");
    assert_non_null(end);
    *end = '\0';
    return page;
}

/** A text of the view, by two names at most. */
static void view_text_of(char *text, size_t size, const char *place, const char *out, const char *name,
                         const char *part)
{
    char path[64];
    snprintf(path, sizeof path, "%s/view.json", out);
    json_t *view = workspace_json(place, path), *value = json_object_get(view, name);
    if (part)
        value = json_object_get(json_is_array(value) ? json_array_get(value, 0) : value, part);
    if (!json_is_string(value))
        fail_msg("no %s %s in the view", name, part ? part : "");
    snprintf(text, size, "%s", json_string_value(value));
    json_decref(view);
}

/** The page says what the view has there. */
static void says(const char *place, const char *out, const char *page, const char *name, const char *part)
{
    char text[200];
    view_text_of(text, sizeof text, place, out, name, part);
    expect_part(page, text);
}

/** Newtons for 1 mohm; does my measurement agree; the textbook; best and significant; longer or finer scan. */
TEST_IN_WORKSPACE(a_connector)
{
    run_to_exit(place, 0, "report", PROJECT_SOURCE "/surfaces/connector", "-o", "out", "--no-cost");
    char *page = first_page(place, "out"), load[80];
    view_text_of(load, sizeof load, place, "out", "answers", "load");
    expect_parts(page, "**1\u00a0mΩ takes ", "\u00a0N** (95 % ", ", film and plating included.", load);
    expect_parts(page, "Your measurement reaches 1\u00a0mΩ at 0.966\u00a0N loading and 0.515\u00a0N unloading",
                 " the measured resistance");
    expect_part(page, "Textbook (");
    says(place, "out", page, "textbook", "value");
    expect_part(page, "They do not differ significantly (p = ");
    expect_part(page, "Least certain: ");
    expect_part(page, "scan length ×÷ "); /* or the spacing, whichever matters */
    free(page);
}

/** The load that the first sentence names is the one of answers.csv. */
TEST_IN_WORKSPACE(the_answer_is_the_datas)
{
    run_to_exit(place, 0, "report", PROJECT_SOURCE "/surfaces/thermal-interface", "-o", "out", "--no-cost");
    char *page = first_page(place, "out"), load[80];
    view_text_of(load, sizeof load, place, "out", "answers", "load");
    expect_part(page, load);
    expect_parts(page, "**20000\u00a0W/(m²·K) takes ", "\u00a0bar**", "Textbook (");
    struct table answers = workspace_table(place, "out/data/answers.csv");
    size_t found = 0;
    for (size_t i = 0; i < answers.rows; i++)
        found +=
            fabs(table_number(&answers, i, "load_over_AnEp") / table_number(&answers, 0, "load_over_AnEp") - 1) < 1;
    assert_true(found > 0);
    table_free(&answers);
    free(page);
}

/** The conductance at 1 MPa, of a gap in air and of bare metal. */
TEST_IN_WORKSPACE(a_conductance)
{
    workspace_scan(place, "d/a.csv", 400, 1);
    workspace_write(place, "d/scene.yaml",
                    "material: copper\ngap: {gas: air}\noperating_load: 1 MPa\n"
                    "load: {from: 0.1 MPa, to: 10 MPa, points: 21}\n");
    run_to_exit(place, 0, "report", "d", "--no-cost", "-o", "gap");
    char *page = first_page(place, "gap");
    expect_parts(page, "**At 1.00\u00a0MPa the joint conductance is ", "\u00a0W/(m²·K)**");
    says(place, "gap", page, "answers", "value");
    free(page);
    workspace_write(place, "d/scene.yaml",
                    "material: copper\neffects: [plasticity, thermal]\noperating_load: 1 MPa\n"
                    "load: {from: 0.1 MPa, to: 10 MPa, points: 21}\n");
    run_to_exit(place, 0, "report", "d", "--no-cost", "-o", "bare");
    page = first_page(place, "bare");
    char value[80];
    view_text_of(value, sizeof value, place, "bare", "answers", "value");
    expect_part(page, "**At 1.00\u00a0MPa the contact conductance is ");
    struct table contact = workspace_table(place, "bare/data/contact.csv");
    size_t same = 0;
    for (size_t i = 0; i < contact.rows; i++) { /* 1/TCR of some model at that pressure, but for the power of ten */
        double decades = log10(table_number(&contact, i, "tcr_K_m2_per_W") * strtod(value, NULL));
        same +=
            fabs(table_number(&contact, i, "pressure_Pa") / 1e6 - 1) < 1e-9 && fabs(decades - round(decades)) < 0.003;
    }
    assert_true(same >= 1);
    table_free(&contact);
    free(page);
}

/** Which model, and how far off: the direct solution's answer, and what the model makes of it. */
TEST_IN_WORKSPACE(how_far_off)
{
    workspace_scan(place, "d/a.csv", 160, 1);
    workspace_write(place, "d/scene.yaml",
                    "material: tin\neffects: [electrical, direct]\nload: {from: 1e-4, to: 2e-2, "
                    "points: 9}\ndirect: {grid: 64, seeds: 2, loads: 7}\noperating_load: 5e-3\n");
    run_to_exit(place, 0, "report", "d", "--no-cost", "-o", "out");
    char *page = first_page(place, "out");
    expect_parts(page, "The direct solution of *a* gives ", ": the model ");
    says(place, "out", page, "direct_answer", "value");
    expect_no_part(page, "let a direct solution run");
    free(page);
}
