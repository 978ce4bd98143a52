/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Results made up to order, without a run. */
#ifndef TEST_FAKE_RESULTS_H
#define TEST_FAKE_RESULTS_H

#include "results/comparison.h"
#include "support.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    SURFACES = 3,
    SCALES = 2,
    LOADS = 6,
    FAKE_MODELS = 4,
    MODELS_MOST = 64 /* rows of the table of models */
};

/* The models that run; the table may have others, which do not. */
static const char *const fake_models[FAKE_MODELS] = {"multiscale-elastic", "multiscale-plastic", "gw", "jg"};

/* Three surfaces made up to order, smoothest first, in these models. Not to be moved: its parts point at each other. */
struct fake {
    struct scene scene;
    struct plan plan;
    struct scene_surface names[SURFACES];
    struct surface_record surfaces[SURFACES];
    struct curve_summary curves[SURFACES][MODELS_MOST];
    struct curve_summary *curve_of[SURFACES][MODELS_MOST];
    size_t order[SURFACES];
    struct results results;
    double sweeps[MODELS_MOST * CONVERGENCE_SWEEP_COUNT * CONVERGENCE_VALUES_MOST * SCALES];
    struct comparison_model models[MODELS_MOST];
    struct comparison_gap gaps[MODELS_MOST][SURFACES];
    double steps[MODELS_MOST][SURFACES];
    struct comparison_extent extents[MODELS_MOST][LOADS][COMPARISON_SPREADS];
    struct comparison comparison;
};

static inline struct curve_summary *fake_curve(struct fake *fake, size_t surface, const char *model)
{
    return &fake->curves[surface][model_named(model)];
}

static inline struct comparison_model *fake_compared(struct fake *fake, const char *model)
{
    return &fake->comparison.models[model_named(model)];
}

/* The areas of one curve of the convergence study: settled, or falling to the last. */
static inline void fake_sweep(struct fake *fake, enum convergence_sweep sweep, const char *model, size_t value,
                              bool settled)
{
    double *area = fake->sweeps + (results_sweep(&fake->results, sweep, model_named(model), value) - fake->sweeps);
    area[0] = 0.5;
    area[1] = settled ? 0.5 : 0.4;
}

/* A law of this amplitude at 10 um. */
static inline void fake_law(struct power_law *law, double amplitude_m, double gamma)
{
    law->gamma = gamma;
    law->amplitude_m = amplitude_m;
    law->alpha = amplitude_m / pow(1e-5, gamma);
}

static inline void make_fake(struct fake *fake)
{
    static const struct comparison_gap none = {NAN, NAN, NAN, NAN};
    static char names[SURFACES][8] = {"one", "two", "three"};
    *fake = (struct fake){.scene = {.convergence = {.load = 1e-3, .scales = SCALES}},
                          .plan = {.running = (1u << EFFECT_COUNT) - 1}};
    fake->plan.wanted = quantity_wanted(fake->plan.running);
    fake->comparison.models = fake->models;
    for (size_t m = 0; m < MODELS_MOST; m++)
        for (size_t k = 0; k < SURFACES; k++) {
            fake->gaps[m][k] = none;
            fake->steps[m][k] = NAN;
        }
    for (int i = 0; i < FAKE_MODELS; i++) {
        fake->plan.models |= MODEL_BIT(model_named(fake_models[i]));
        struct comparison_model *model = fake_compared(fake, fake_models[i]);
        bool plastic = model_rows[model_named(fake_models[i])]->plastic;
        for (int q = 0; q < QUANTITY_COUNT; q++)
            model->rank[q] =
                q == QUANTITY_SEPARATION ? (struct comparison_tally){40, 60, 0} : (struct comparison_tally){100, 0, 0};
        bool statistical = i >= 2;
        for (size_t k = 0; k < SURFACES; k++)
            if (statistical)
                fake->gaps[model_named(fake_models[i])][k] =
                    (struct comparison_gap){.area = 0.5, .ecr = 0.2, .plain = 1, .adjusted = 0.3};
        for (size_t k = 0; k + 1 < SURFACES; k++)
            fake->steps[model_named(fake_models[i])][k] = 0.2 + 0.1 * (double)k;
        for (int load = 0; load < 2; load++)
            for (int of = 0; of < COMPARISON_SPREADS; of++)
                fake->extents[model_named(fake_models[i])][load][of] =
                    (struct comparison_extent){1,
                                               statistical ? plastic ? 4 : 5
                                               : plastic   ? 2
                                                           : 3,
                                               SURFACES};
        model->extremes[QUANTITY_AREA] =
            (struct comparison_extremes){.least = 0.1, .most = plastic ? 0.2 : 0.3, .count = SURFACES};
    }
    for (size_t k = 0; k < SURFACES; k++) {
        fake->names[k].name = names[k];
        fake->order[k] = k;
        struct surface_summary *summary = &fake->surfaces[k].summary;
        summary->scene = &fake->names[k];
        summary->usable = true;
        summary->power_law = (struct power_law){
            .found = POWER_LAW_BAND_LAW, .band_m = {1e-6, 1e-4}, .wavelength_m = 1e-5, .knee_m = NAN};
        fake_law(&summary->power_law, k == 1 ? 2e-7 : 1e-7, 1.6 - 0.2 * (double)k);
        summary->tail.count = 1;
        summary->models = fake->curve_of[k];
        for (size_t m = 0; m < model_count; m++)
            fake->curve_of[k][m] = &fake->curves[k][m];
        for (int i = 0; i < FAKE_MODELS; i++)
            *fake_curve(fake, k, fake_models[i]) = (struct curve_summary){.exists = true,
                                                                          .extended = true,
                                                                          .full_load = 0.1,
                                                                          .elbow_load = 0.05,
                                                                          .beta = k == 1 ? 7 : 6,
                                                                          .area_slope = 0.95,
                                                                          .gap_at_full = 0,
                                                                          .sd_most = 0.01};
    }
    for (size_t m = 0; m < model_count; m++) {
        fake->models[m].gaps = fake->gaps[m];
        fake->models[m].steps = fake->steps[m];
        fake->models[m].extents = fake->extents[m];
    }
    struct comparison_plastic plastic = {.least = 1.1, .most = 2, .sooner = {3, 0, 0}};
    for (int q = QUANTITY_AREA; q < QUANTITY_COUNT; q++)
        plastic.changes[q] = (struct comparison_tally){100, 0, 0};
    fake_compared(fake, "multiscale-plastic")->plastic = fake_compared(fake, "jg")->plastic = plastic;
    fake->comparison.proportional_error = 1e-15;
    fake->comparison.middle_load = 1e-3;
    static const double loads[] = {1e-3, 1};
    fake->results = (struct results){.scene = &fake->scene,
                                     .loads = loads,
                                     .load_count = 2,
                                     .convergence = fake->sweeps,
                                     .plan = &fake->plan,
                                     .surfaces = fake->surfaces,
                                     .surface_count = SURFACES,
                                     .by_roughness = fake->order,
                                     .usable_count = SURFACES,
                                     .baseline = 1};
    for (int s = 0; s < CONVERGENCE_SWEEP_COUNT; s++)
        for (size_t v = 0; v < convergence_sweeps[s].count; v++)
            for (int i = 0; i < 2; i++) /* those that stack scales */
                fake_sweep(fake, (enum convergence_sweep)s, fake_models[i], v,
                           s == CONVERGENCE_ALPHA || convergence_sweeps[s].values[v] >= 1);
}

/* A record whose areas, resistances and separations follow from the load and an area a model, as in fake_models. */
static inline void fake_put_curves(struct fake *fake, size_t index, const double areas[FAKE_MODELS])
{
    struct surface_record *record = &fake->surfaces[index];
    record->summary.asperities.sigma_m = 1e-6;
    record->curves = calloc(model_count, sizeof *record->curves);
    record->bands = calloc(model_count, sizeof *record->bands);
    assert_true(record->curves && record->bands);
    for (int m = 0; m < FAKE_MODELS; m++) {
        size_t model = model_named(fake_models[m]);
        struct model_curve *curve = &record->curves[model];
        *curve =
            (struct model_curve){.exists = true, .count = LOADS, .full_load = model_rows[model]->plastic ? 0.1 : 0.2};
        curve->points = calloc(LOADS, sizeof *curve->points);
        assert_non_null(curve->points);
        for (int i = 0; i < LOADS; i++) {
            double area = fmin(1, areas[m] * pow(10, i - 3)), ecr = area < 1 ? 1e-9 / area : 0;
            curve->points[i] = (struct contact_point){.value[QUANTITY_LOAD] = pow(10, i - 5),
                                                      .value[QUANTITY_AREA] = area,
                                                      .value[QUANTITY_ECR] = ecr,
                                                      .value[QUANTITY_SEPARATION] = 1e-6 / area,
                                                      .value[QUANTITY_ADJUSTED] =
                                                          model_rows[model]->asperity_model ? 2e-6 / area : NAN,
                                                      .value[QUANTITY_TCR] = 2e5 * ecr};
        }
        record->summary.models[model]->operating = curve->points[LOADS / 2];
    }
}

/* The comparison of curves made to order: areas in the ratios given, the resistance in inverse proportion. To be ended
 * with comparison_free(). */
static inline void comparison_of(struct fake *fake, const double areas[SURFACES][FAKE_MODELS], double tolerance)
{
    struct status status = {0};
    static const double loads[LOADS] = {1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1};
    make_fake(fake);
    fake->scene.tolerance = tolerance;
    fake->results.loads = loads;
    fake->results.load_count = LOADS;
    for (size_t k = 0; k < SURFACES; k++)
        fake->surfaces[k].summary.pair = (struct material_pair){
            .effective_modulus_Pa = 1e11, .resistivity_ohm_m = 1e-7, .conductivity_W_per_mK = 50}; /* 1/(rho k) = 2e5 */
    for (size_t k = 0; k < SURFACES; k++)
        fake_put_curves(fake, k, areas[k]);
    assert_int_equal(comparison_make(&fake->comparison, &fake->results, &status), STATUS_OK);
    for (size_t k = 0; k < SURFACES; k++) {
        fake->surfaces[k].summary.models = NULL; /* the fake's, not to be freed */
        surface_drop_arrays(&fake->surfaces[k]);
        fake->surfaces[k].summary.models = fake->curve_of[k];
    }
}

static inline void make_comparison(struct fake *fake, const double areas[SURFACES][FAKE_MODELS])
{
    comparison_of(fake, areas, 0);
}

#endif
