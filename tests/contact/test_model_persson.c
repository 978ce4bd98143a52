/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Persson's theory as a run calls it. */
#include "contact/persson.h"
#include "model_support.h"
#include "random_surface.h"

#include <stdio.h>

/** The row gives what the theory's functions give, resistance as rho (-du/dp) and TCR as (-du/dp)/k. */
TEST_CASE(the_row_is_the_theory)
{
    struct spectrum spectrum = model_support_law(3e-4, 0.085, 1.5, 256);
    struct material_pair pair = model_support_tin();
    double load[MODEL_LOADS];
    struct contact_point points[MODEL_LOADS + 1];
    struct persson persson;
    struct status status = {0};
    model_support_loads(load, MODEL_LOADS, 1e-6, 0.1);
    struct model_task task = {.spectrum = &spectrum,
                              .pair = &pair,
                              .loads = load,
                              .load_count = MODEL_LOADS,
                              .wanted = MODEL_EVERYTHING,
                              .tolerance = 1e-8};
    struct model_curve curve = model_support_run(points, "persson", &task);
    assert_int_equal(persson_make(&persson, &spectrum, persson_energy_factor, &status), STATUS_OK);
    assert_true(curve.exists && curve.count == MODEL_LOADS && isnan(curve.full_load) && isnan(curve.beta));
    for (size_t i = 0; i < curve.count; i++) {
        struct persson_separation at = persson_separation(&persson, load[i]);
        assert_near(points[i].value[QUANTITY_AREA], persson_area(load[i], spectrum_moment(&spectrum, 1), 0.45), 1e-12);
        assert_near(points[i].value[QUANTITY_SEPARATION], at.separation_m, 1e-15);
        assert_near(points[i].value[QUANTITY_ECR], pair.resistivity_ohm_m * at.constriction_m, 1e-15);
        assert_near(points[i].value[QUANTITY_TCR], at.constriction_m / pair.conductivity_W_per_mK, 1e-15);
        assert_true(isnan(points[i].value[QUANTITY_ADJUSTED]) && isnan(points[i].value[QUANTITY_TCR_SCALE_DEPENDENT]));
    }
    persson_free(&persson);
    task.wanted = QUANTITY_BIT(QUANTITY_AREA);
    curve = model_support_run(points, "persson", &task);
    assert_true(isnan(points[0].value[QUANTITY_SEPARATION]) && isnan(points[0].value[QUANTITY_ECR]) &&
                points[0].value[QUANTITY_AREA] > 0);
    spectrum_free(&spectrum);
}

TEST_CASE(hard_spectra)
{
    struct material_pair pair = model_support_tin();
    double load[MODEL_LOADS];
    struct contact_point points[MODEL_LOADS + 1];
    model_support_loads(load, MODEL_LOADS, 1e-6, 10);
    static const struct {
        size_t count;
        double amplitude_m;
    } spectra[] = {{256, 1e-8}, {1, 1e-6}, {4, 1e-7}, {256, 0}};
    for (size_t s = 0; s < sizeof spectra / sizeof *spectra; s++) {
        struct spectrum spectrum = model_support_law(3e-4, spectra[s].amplitude_m, 0, spectra[s].count);
        struct model_task task = {.spectrum = &spectrum,
                                  .pair = &pair,
                                  .loads = load,
                                  .load_count = MODEL_LOADS,
                                  .wanted = MODEL_EVERYTHING,
                                  .tolerance = 1e-8};
        struct model_curve curve = model_support_run(points, "persson", &task);
        assert_int_equal(curve.exists, spectra[s].amplitude_m > 0);
        for (size_t i = 1; i < curve.count; i++)
            assert_true(points[i].value[QUANTITY_AREA] >= points[i - 1].value[QUANTITY_AREA] &&
                        points[i].value[QUANTITY_SEPARATION] <= points[i - 1].value[QUANTITY_SEPARATION] &&
                        points[i].value[QUANTITY_ECR] <= points[i - 1].value[QUANTITY_ECR]);
        spectrum_free(&spectrum);
    }
}

/** "any area ratio: area within a factor LOW to HIGH, separation LOW to HIGH of direct solutions": on all of them from
 * A/A_n = 0.001 on, and no narrower range of one decimal would do. */
TEST_CASE(the_stated_range_holds)
{
    double low[2], high[2], least[2] = {INFINITY, INFINITY}, most[2] = {0, 0};
    assert_int_equal(sscanf(model_rows[model_named("persson")]->valid,
                            "any area ratio: area within a factor %lf to %lf, separation %lf to %lf of direct", &low[0],
                            &high[0], &low[1], &high[1]),
                     4);
    struct table table = table_read("golden/direct/gaussian_elastic.csv");
    struct material_pair pair = {.effective_modulus_Pa = 1, .resistivity_ohm_m = 1, .conductivity_W_per_mK = 1};
    for (size_t i = 0; i < table.rows; i++) {
        struct spectrum spectrum;
        double load = table_number(&table, i, "load_over_Ep"), truth = table_number(&table, i, "area_ratio");
        random_surface(&spectrum, table_number(&table, i, "hurst"), table_number(&table, i, "long_index"),
                       table_number(&table, i, "short_index"), table_number(&table, i, "plateau") > 0);
        struct model_task task = {.spectrum = &spectrum,
                                  .pair = &pair,
                                  .loads = &load,
                                  .load_count = 1,
                                  .wanted = MODEL_EVERYTHING,
                                  .tolerance = 1e-6};
        struct contact_point point[2];
        model_support_run(point, "persson", &task);
        double ratio[2] = {point->value[QUANTITY_AREA] / truth,
                           point->value[QUANTITY_SEPARATION] / table_number(&table, i, "mean_gap_over_L")};
        for (int q = 0; q < 2; q++)
            if (truth >= 1e-3 && (q == 0 || truth < 0.6)) {
                least[q] = fmin(least[q], ratio[q]);
                most[q] = fmax(most[q], ratio[q]);
            }
        spectrum_free(&spectrum);
    }
    for (int q = 0; q < 2; q++) {
        assert_near(floor(least[q] * 10) / 10, low[q], 1e-12);
        assert_near(ceil(most[q] * 10) / 10, high[q], 1e-12);
    }
    table_free(&table);
}
