/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cost of accuracy: each model at its tolerances. Times are not tested. */
#include "answers/answers.h"
#include "contact/multiscale.h"
#include "plan/benchmark.h"
#include "profile/synth.h"
#include "support.h"

enum { POINTS = 256, LOADS = 13 };

static struct surface_record *record;
static struct scene scene;
static struct plan plan;
static double loads[LOADS];
static const struct surface_task asked = {.scene = &scene, .plan = &plan, .loads = loads, .load_count = LOADS};
static struct benchmark cost;

static int make(void **state)
{
    (void)state;
    struct synth_def def = synth_def_default();
    double height_m[POINTS];
    def.points = POINTS;
    def.length_m = 5e-7 * POINTS;
    def.seed = 3;
    expect_ok(synth_profile, height_m, &def);
    record = support_room(sizeof *record);
    record->summary.usable = true;
    record->summary.roughness = roughness_of_heights(height_m, POINTS, 5e-7);
    expect_ok(spectrum_compute, &record->spectrum, height_m, POINTS, 5e-7, SPECTRUM_WINDOW_NONE);
    expect_ok(roughness_asperities, &record->summary.asperities, &record->summary.roughness);
    record->summary.has_asperities = true;
    scene = (struct scene){.models = model_defaults(),
                           .effects = (1u << EFFECT_COUNT) - 1,
                           .bodies = {.material = *material_find("tin"),
                                      .counterface_kind = MATERIAL_COUNTERFACE_RIGID,
                                      .counterface = material_unknown("rigid"),
                                      .hardness_Pa = NAN},
                           .tolerance = 1e-7,
                           .closure = SINUSOID_FIT_THESIS};
    record->summary.pair = scene_pair(&scene.bodies);
    record->summary.tail.gamma = NAN;
    record->summary.power_law = (struct power_law){.alpha = 0.2, .gamma = 1.4, .band_m = {3.9e-6, 5e-5}};
    record->summary.power_law.found = POWER_LAW_BAND_LAW;
    plan_make(&plan, &scene, NULL);
    for (int i = 0; i < LOADS; i++)
        loads[i] = pow(10, -6 + i / 4.0);
    expect_ok(surface_answers_find, record, &asked);
    expect_ok(benchmark_measure, &cost, record, &asked);
    return 0;
}

static int end(void **state)
{
    (void)state;
    surface_record_free(record);
    free(record);
    return 0;
}

/** Of 1200 loads every third is timed. */
TEST_CASE(many_loads)
{
    double many[1200], every_third[400];
    struct benchmark costs[2];
    for (int i = 0; i < 1200; i++)
        many[i] = 1e-6 * pow(10, i / 300.0);
    for (int i = 0; i < 400; i++)
        every_third[i] = many[3 * i];
    for (int k = 0; k < 2; k++) {
        struct surface_task task = asked;
        task.loads = k ? every_third : many;
        task.load_count = k ? 400 : 1200;
        expect_ok(benchmark_measure, &costs[k], record, &task);
    }
    for (size_t i = 0; i < costs[0].count; i++)
        assert_int_equal(costs[0].rows[i].evaluations, costs[1].rows[i].evaluations);
}

/* A model's rows are adjacent, from the coarsest tolerance to the finest, with which the others are compared; errors
 * stay within ten times the tolerance. */
TEST_CASE(test_tolerances_hold)
{
    static const double tolerance[BENCHMARK_STEPS] = {1e-2, 1e-6, 1e-10, 1e-13};
    size_t models = 0;
    for (size_t m = 0; m < model_count; m++)
        models += record->curves[m].exists;
    assert_true(models >= 6);
    assert_int_equal(cost.count, BENCHMARK_STEPS * models);
    for (size_t i = 0; i < cost.count; i++) {
        const struct benchmark_row *row = &cost.rows[i];
        assert_int_equal(row->model, cost.rows[i - i % BENCHMARK_STEPS].model);
        assert_true(record->curves[row->model].exists);
        assert_true(row->tolerance == tolerance[i % BENCHMARK_STEPS]);
        assert_true(row->seconds > 0);
        assert_true(row->error <= 10 * row->tolerance);
        assert_true(i % BENCHMARK_STEPS < BENCHMARK_STEPS - 1 || row->error == 0);
    }
    double coarsest = 0;
    for (size_t i = 0; i < cost.count; i += BENCHMARK_STEPS)
        coarsest = fmax(coarsest, cost.rows[i].error);
    assert_true(coarsest > 1e-12);
}

/* Of a very long scan only part of the harmonics is timed. */
TEST_CASE(test_a_long_scan)
{
    enum { WAVES = 150000 };
    uint64_t evaluations[2];
    for (int longer = 0; longer < 2; longer++) {
        struct surface_record *scan = support_room(sizeof *scan);
        *scan = *record;
        scan->curves = calloc(model_count, sizeof *scan->curves);
        scan->spectrum.count = longer ? 4 * WAVES : WAVES;
        scan->spectrum.amplitude_m = malloc(scan->spectrum.count * sizeof *scan->spectrum.amplitude_m);
        assert_true(scan->curves && scan->spectrum.amplitude_m);
        for (size_t i = 0; i < scan->spectrum.count; i++)
            scan->spectrum.amplitude_m[i] = 1e-7 * pow((double)(i + 1), -0.6);
        scan->curves[model_named("multiscale-elastic")].exists = true;
        struct benchmark of_scan;
        expect_ok(benchmark_measure, &of_scan, scan, &asked);
        assert_int_equal(of_scan.count, 4);
        evaluations[longer] = of_scan.rows[0].evaluations;
        spectrum_free(&scan->spectrum);
        free(scan->curves);
    }
    assert_true(evaluations[0] > 10000);
    assert_int_equal(evaluations[0], evaluations[1]);
}

/* Ratio of the area with the law in place of the harmonics of its band, and of no others, to that of the scan. */
TEST_CASE(test_the_law_in_place_of_the_data)
{
    const struct curve_summary *model = record->summary.models[model_named("multiscale-elastic")];
    struct spectrum spectrum = record->spectrum;
    double area[2], amplitude_m[POINTS], at = model->operating.value[QUANTITY_LOAD];
    spectrum.amplitude_m = memcpy(amplitude_m, spectrum.amplitude_m, spectrum.count * sizeof *amplitude_m);
    for (int law = 0; law < 2; law++) {
        struct multiscale stack;
        struct contact_point point;
        for (size_t i = 2; i < 32 && law; i++) /* 4 to 50 um of 128 */
            amplitude_m[i] = 0.2 * pow(1.28e-4 / (double)(i + 1), 1.4);
        expect_ok(multiscale_make, &stack, &spectrum, &record->summary.pair, false, SINUSOID_FIT_THESIS);
        multiscale_solve(&point, &stack, &(struct constriction){0}, QUANTITY_BIT(QUANTITY_AREA), at, &(uint64_t){0});
        area[law] = point.value[QUANTITY_AREA];
        multiscale_free(&stack);
    }
    assert_near(model->law_factor, area[1] / area[0], 1e-9);
    assert_true(fabs(model->law_factor - 1) > 0.05);
}

TEST_GROUP(make, end)
