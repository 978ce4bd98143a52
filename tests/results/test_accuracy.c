/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far models are expected to be off, and at what time. */
#include "results/accuracy.h"

#include "base/text.h"
#include "made_up_results.h"
#include "support.h"

#include <stdio.h>

/* The rows' figures are those that docs/validation.md prints of other heights. */
TEST_CASE(errors_are_those_of_the_validation)
{
    struct text *page = support_text();
    expect_ok(text_read_file, page, PROJECT_SOURCE "/docs/validation.md");
    const char *table = strstr(text_string(page), "\n| other heights |");
    size_t held = 0;
    assert_non_null(table);
    for (size_t m = 0; m < model_count; m++) {
        const struct model_row *row = model_rows[m];
        char head[80];
        snprintf(head, sizeof head, "\n| %s |", row->name);
        const char *line = strstr(table, head);
        for (int known = 0; known < MODEL_KNOWN; known++) {
            static const int column[MODEL_KNOWN] = {0, 1, 4};
            double printed[3] = {0};
            const char *cell = line ? line + strlen(head) : NULL;
            for (int c = 0; cell && c < column[known]; c++)
                cell = strchr(cell, '|') + 1;
            if (cell && sscanf(cell, "%lf %lf %lf", &printed[0], &printed[1], &printed[2]) == 3)
                held++;
            for (int q = 0; q < 3; q++)
                assert_within(row->ln_rms[known][q], printed[q], 1e-12);
        }
    }
    assert_int_equal(held, 5 + 4 + 9 - 1);
}

TEST_CASE(errors_are_of_this_kind_of_data)
{
    const struct model_row *strip = model_rows[model_named("strip")],
                           *plastic = model_rows[model_named("strip-plastic")];
    assert_near(model_rms(strip, QUANTITY_AREA, false, false), 0.22, 1e-12);
    assert_near(model_rms(strip, QUANTITY_MEAN_GAP, true, false), 0.57, 1e-12);
    assert_near(model_rms(strip, QUANTITY_JOINT_ECR, true, false), 0.52, 1e-12);
    assert_near(model_rms(plastic, QUANTITY_ECR, false, true), 0.37, 1e-12);
    assert_near(model_rms(plastic, QUANTITY_ECR, true, true), 0.52, 1e-12); /* of one scan the elastic one's */
    assert_true(model_rms(model_rows[model_named("jg")], QUANTITY_ECR, false, false) == 0);
    assert_true(model_rms(model_rows[model_named("direct")], QUANTITY_ECR, false, false) == 0);
}

/* No other is as cheap and better; times are those of the run. */
TEST_CASE(the_best_at_a_price)
{
    struct made_up made;
    made_up_make(&made, NULL);
    const size_t jg = made_up_model("jg"), gw = made_up_model("gw");
    struct accuracy of = accuracy_of(&made.results, gw, QUANTITY_ECR);
    assert_int_equal(of.source, ACCURACY_MEASURED);
    assert_near(of.error, expm1(model_rms(model_rows[gw], QUANTITY_ECR, of.one_scan, of.hard)), 1e-12);
    assert_near(of.seconds[0], 1e-6 * (double)(gw + 1), 1e-12);
    assert_near(of.total_error[0], hypot(of.error, 1e-3), 1e-12);
    assert_true(accuracy_is_best(&made.results, jg, QUANTITY_ECR)); /* dearer, and better than all */
    for (size_t i = 0; i < made.benchmark.count; i++)
        made.benchmark.rows[i].seconds = made.benchmark.rows[i].model == jg ? 1 : 1e-6;
    assert_near(accuracy_of(&made.results, jg, QUANTITY_ECR).seconds[0], 1, 1e-12);
    size_t best = 0;
    for (size_t m = 0; m < model_count; m++)
        best += accuracy_is_best(&made.results, m, QUANTITY_ECR);
    assert_int_equal(best, 3); /* jg, and two that are as cheap and as far off */
    made.results.benchmark = NULL;
    assert_int_equal(accuracy_of(&made.results, gw, QUANTITY_ECR).source, ACCURACY_NONE);
    assert_false(accuracy_is_best(&made.results, jg, QUANTITY_ECR));
    made.results.benchmark = &made.benchmark;
    made_up_free(&made);
}

TEST_GROUP(NULL, NULL)
