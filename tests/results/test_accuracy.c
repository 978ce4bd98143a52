/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far models are expected to be off, and at what time. */
#include "results/accuracy.h"

#include "directory.h"
#include "made_up_results.h"
#include "results/work.h"

/* The table of errors is what docs/validation.md prints of other heights, from five scans, elastic models of elastic
 * contact and others of metal that yields; that of strips, on real maps, is no smaller. */
TEST_CASE(errors_are_those_of_the_validation)
{
    const char *table = strstr(directory_read(PROJECT_SOURCE, "docs/validation.md"), "\n| other heights |");
    assert_non_null(table);
    for (size_t i = 0; i < model_error_count; i++) {
        const struct model_error *error = &model_errors[i];
        const char *cell = strstr(table, filled("\n| %s |", error->model->name));
        double printed[3];
        assert_non_null(cell);
        for (int c = error->model->plastic ? 6 : 2; c > 0; c--)
            cell = strchr(cell, '|') + 1;
        assert_int_equal(sscanf(cell, "%lf %lf %lf", &printed[0], &printed[1], &printed[2]), 3);
        for (int q = 0; q < 3; q++)
            assert_true(error->model->uses_strip ? error->ln_sd[q] >= printed[q] : error->ln_sd[q] == printed[q]);
    }
}

/* Every model that is not a direct solution has a row; what the joint makes of a resistance errs as that does. */
TEST_CASE(every_model_has_its_error)
{
    for (size_t m = 0; m < model_count; m++)
        assert_true((model_sd(model_rows[m], QUANTITY_ECR, false) > 0) == !model_rows[m]->uses_map);
    const struct model_row *strip = model_rows[model_named("strip")];
    assert_near(model_sd(strip, QUANTITY_AREA, false), 0.37, 1e-12);
    assert_near(model_sd(strip, QUANTITY_MEAN_GAP, false), 0.48, 1e-12);
    assert_near(model_sd(strip, QUANTITY_JOINT_ECR, false), 0.54, 1e-12);
    assert_near(model_factor(0.54), 2.8816, 1e-4);
    for (size_t m = 0; m < model_count; m++) /* of two directions: strips' alone are another, and never larger */
        for (int q = QUANTITY_AREA; q < QUANTITY_COUNT; q++) {
            const double one = model_sd(model_rows[m], (enum quantity)q, false),
                         two = model_sd(model_rows[m], (enum quantity)q, true);
            assert_true(model_rows[m]->uses_strip ? two <= one : two == one);
        }
    assert_near(model_sd(strip, QUANTITY_AREA, true), 0.28, 1e-12);
    assert_near(model_sd(strip, QUANTITY_MEAN_GAP, true), 0.38, 1e-12);
    assert_near(model_sd(strip, QUANTITY_JOINT_ECR, true), 0.42, 1e-12);
}

/* Times are those of the run, errors the table's with that of the tolerance. */
TEST_CASE(what_accuracy_costs)
{
    struct made_up made;
    made_up_make(&made, NULL);
    const size_t gw = model_named("gw");
    struct accuracy of = accuracy_of(&made.results, gw, QUANTITY_ECR);
    assert_true(of.sd > 0);
    assert_near(of.sd, model_sd(model_rows[gw], QUANTITY_ECR, false), 1e-12);
    assert_near(of.seconds[0], 1e-6 * (double)(gw + 1), 1e-12);
    assert_near(of.total_error[0], hypot(model_factor(of.sd) - 1, 1e-3), 1e-12);
    for (size_t i = 0; i < made.benchmark.count; i++)
        made.benchmark.rows[i].seconds = made.benchmark.rows[i].model == gw ? 1 : 1e-6;
    assert_near(accuracy_of(&made.results, gw, QUANTITY_ECR).seconds[0], 1, 1e-12);
    const size_t map = model_named("direct"); /* its factor is that of its own interval */
    struct estimate all[CURVE_ESTIMATES] = {[QUANTITY_ECR] = estimate_of_error(1e-9, 0.2, 3)};
    const struct estimate *ecr = &all[QUANTITY_ECR];
    struct curve_summary **solved = &made_up_surface(&made, made.results.baseline)->models[map];
    assert_non_null(*solved = calloc(1, sizeof **solved));
    expect_ok(curve_summary_put_estimates, *solved, all);
    made.benchmark.rows[0].model = map;
    assert_true(isnan(accuracy_of(&made.results, map, QUANTITY_AREA).sd)); /* of which there is none */
    assert_near(model_factor(accuracy_of(&made.results, map, QUANTITY_ECR).sd),
                sqrt(estimate_end(ecr, 1) / estimate_end(ecr, 0)), 1e-12);
    struct surface_summary *summary = made_up_surface(&made, made.results.baseline);
    struct work_row before[WORK_ROWS], after[WORK_ROWS];
    work_account(before, &made.results);
    for (int kind = 0; kind < 2; kind++) { /* each of its two models took its own squares */
        summary->times.tiles[kind] = 2 + kind;
        summary->tile_transforms[kind] = 20 + (uint64_t)kind;
        made.benchmark.rows[0].model = model_named(kind ? "direct-plastic" : "direct");
        const struct accuracy own = accuracy_of(&made.results, made.benchmark.rows[0].model, QUANTITY_ECR);
        assert_near(own.seconds[0], 2 + kind + made.benchmark.rows[0].seconds, 1e-12);
    }
    work_account(after, &made.results);
    for (int r = 0; r < WORK_ROWS; r++) {
        const int kind = r == 0 ? 0 : r == 1 + EFFECT_PLASTICITY ? 1 : -2;
        assert_near(after[r].seconds - before[r].seconds, 2 + kind, 1e-12);
        assert_int_equal(after[r].evaluations - before[r].evaluations, kind < 0 ? 0 : 20 + kind);
    }
    made.results.benchmark = NULL;
    assert_near(accuracy_of(&made.results, gw, QUANTITY_ECR).sd, 0, 0);
    made.results.benchmark = &made.benchmark;
    made_up_free(&made);
}
