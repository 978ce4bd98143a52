/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What accuracy costs: each method on a real surface against what it must come to. Times are never tested. */
#include "answers/curves.h"
#include "contact/convergence.h"
#include "contact/multiscale.h"
#include "contact/persson.h"
#include "contact/statistical.h"
#include "plan/benchmark.h"
#include "profile/synth.h"
#include "support.h"

#include <stdio.h>

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
    struct status status = {0};
    double height_m[POINTS];
    def.points = POINTS;
    def.length_m = 5e-7 * POINTS;
    def.seed = 3;
    assert_int_equal(synth_profile(height_m, &def, &status), STATUS_OK);
    record = calloc(1, sizeof *record);
    assert_non_null(record);
    record->summary.usable = true;
    record->summary.roughness = roughness_of_heights(height_m, POINTS, 5e-7);
    assert_int_equal(spectrum_compute(&record->spectrum, height_m, POINTS, 5e-7, SPECTRUM_WINDOW_NONE, &status),
                     STATUS_OK);
    assert_int_equal(roughness_asperities(&record->summary.asperities, &record->summary.roughness, &status), STATUS_OK);
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
    plan_make(&plan, &scene);
    for (int i = 0; i < LOADS; i++)
        loads[i] = pow(10, -6 + i / 4.0);
    assert_int_equal(curves_run(record, &asked, &status), STATUS_OK);
    assert_int_equal(benchmark_measure(&cost, record, &asked, &status), STATUS_OK);
    return 0;
}

static int end(void **state)
{
    (void)state;
    surface_record_free(record);
    free(record);
    return 0;
}

static const struct benchmark_row *find(const char *study, const char *method, double setting)
{
    for (const struct benchmark_row *row = cost.rows; row < cost.rows + cost.count; row++)
        if (strcmp(row->study, study) == 0 && strcmp(row->method, method) == 0 && row->setting == setting)
            return row;
    fail_msg("no %s, %s, %g", study, method, setting);
    return NULL;
}

/* Each method comes to the same integrals, from its own formula of the law: one that did not would be off by as much
 * as its integrand, or the one it is held against. */
TEST_CASE(test_the_integrals_agree)
{
    static const struct {
        const char *study, *method;
        double setting, most;
    } rows[] = {
        {"gw-integrals", "Simpson", 1e4, 3e-4},         {"gw-integrals", "Gauss-Legendre", 1e-10, 1e-9},
        {"jg-integrals", "Simpson", 1e4, 1e-3},         {"jg-integrals", "Gauss-Legendre", 1e-10, 1e-9},
        {"jg-integrals", "Gauss-Legendre", 1e-6, 1e-5}, {"jg-integrals", "Gauss-Legendre", 1e-3, 1e-2},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double error = find(rows[i].study, rows[i].method, rows[i].setting)->error;
        if (!(error <= rows[i].most))
            fail_msg("%s, %s, %g: %g", rows[i].study, rows[i].method, rows[i].setting, error);
    }
}

/* More effort, less error; evaluations as the rule has them. */
TEST_CASE(test_effort_and_error)
{
    static const char *const studies[] = {"gw-integrals", "jg-integrals"};
    static const double intervals[] = {10, 100, 1000, 10000};
    for (int s = 0; s < 2; s++) {
        double before = INFINITY;
        for (int i = 0; i < 4; i++) {
            const struct benchmark_row *row = find(studies[s], "Simpson", intervals[i]);
            assert_int_equal(row->evaluations, 100 * (intervals[i] + 1)); /* for 100 separations */
            assert_true(row->error < before);
            before = row->error;
        }
        assert_true(find(studies[s], "Simpson", 10)->error > 1e-3);
    }
}

/** int_0^inf law(u) phi(u + d) du but for a factor: area, load, radius; by Simpson's rule in u (`squared` false: as the
 * thesis does), or in sqrt(u). */
static double simpson(int quantity, double d, size_t intervals, bool squared)
{
    double last = d > 0 ? 80 / (d + sqrt(d * d + 80)) : sqrt(80) - d; /* the Gaussian has fallen by e^-40 */
    double end_of_range = squared ? sqrt(last) : last, step = end_of_range / (double)intervals, sum = 0;
    for (size_t i = 0; i <= intervals; i++) {
        double t = step * (double)i, u = squared ? t * t : t;
        const double laws[] = {u, u * sqrt(u), sqrt(u)};
        double value = laws[quantity] * exp(-u * u / 2 - u * d) * (squared ? 2 * t : 1);
        sum += value * (i == 0 || i == intervals ? 1 : i % 2 ? 4 : 2);
    }
    return sum * step / 3;
}

/* The error of GW by the thesis's rule, from integrals of its own at the same three separations. */
TEST_CASE(test_the_error_itself)
{
    static const size_t intervals[] = {10, 30, 100, 1000};
    const struct asperities *surface = &record->summary.asperities;
    struct status status = {0};
    struct statistical gw;
    uint64_t none = 0;
    assert_int_equal(
        statistical_make(&gw, surface, &record->summary.pair, ASPERITY_HERTZ, 0, 1, INFINITY, &none, &status),
        STATUS_OK);
    for (size_t i = 0; i < sizeof intervals / sizeof *intervals; i++) {
        double error = 0;
        for (int s = 0; s < 100; s += 11) {
            double d = 4 + (gw.full_d - 4) * s / 99.0;
            for (int q = 0; q < 3; q++)
                error = fmax(error, fabs(simpson(q, d, intervals[i], false) / simpson(q, d, 20000, true) - 1));
        }
        assert_near(find("gw-integrals", "Simpson", (double)intervals[i])->error, error, 1e-4);
    }
    statistical_free(&gw);
}

/* The waves that every tolerance is summed over, of a scan so long that fewer show it too. */
TEST_CASE(test_a_long_scan)
{
    enum { WAVES = 150000 };
    uint64_t evaluations[2];
    for (int longer = 0; longer < 2; longer++) {
        struct surface_record *scan = malloc(sizeof *scan);
        struct status status = {0};
        assert_non_null(scan);
        *scan = *record;
        scan->curves = calloc(model_count, sizeof *scan->curves);
        scan->spectrum.count = longer ? 4 * WAVES : WAVES;
        scan->spectrum.amplitude_m = malloc(scan->spectrum.count * sizeof *scan->spectrum.amplitude_m);
        assert_true(scan->curves && scan->spectrum.amplitude_m);
        for (size_t i = 0; i < scan->spectrum.count; i++)
            scan->spectrum.amplitude_m[i] = 1e-7 * pow((double)(i + 1), -0.6);
        scan->curves[model_named("multiscale-elastic")].exists = true;
        struct benchmark of_scan;
        assert_int_equal(benchmark_measure(&of_scan, scan, &asked, &status), STATUS_OK);
        assert_int_equal(of_scan.count, 4);
        evaluations[longer] = of_scan.rows[0].evaluations;
        spectrum_free(&scan->spectrum);
        free(scan->curves);
        free(scan);
    }
    assert_true(evaluations[0] > 10000);
    assert_int_equal(evaluations[0], evaluations[1]);
}

/* The area by the law in place of the harmonics of its band, and of no others, over that by the scan's. */
TEST_CASE(test_the_law_in_place_of_the_data)
{
    const struct curve_summary *model = record->summary.models[model_named("multiscale-elastic")];
    struct spectrum spectrum = record->spectrum;
    double area[2], amplitude_m[POINTS], at = model->operating.value[QUANTITY_LOAD];
    spectrum.amplitude_m = memcpy(amplitude_m, spectrum.amplitude_m, spectrum.count * sizeof *amplitude_m);
    for (int law = 0; law < 2; law++) {
        struct multiscale stack;
        struct contact_point point;
        struct status status = {0};
        for (size_t i = 2; i < 32 && law; i++) /* 4 to 50 um of 128 */
            amplitude_m[i] = 0.2 * pow(1.28e-4 / (double)(i + 1), 1.4);
        assert_int_equal(multiscale_make(&stack, &spectrum, &record->summary.pair, false, SINUSOID_FIT_THESIS, &status),
                         STATUS_OK);
        multiscale_solve(&point, &stack, &(struct constriction){0}, QUANTITY_BIT(QUANTITY_AREA), at, &(uint64_t){0});
        area[law] = point.value[QUANTITY_AREA];
        multiscale_free(&stack);
    }
    assert_near(model->law_factor, area[1] / area[0], 1e-9);
    assert_true(fabs(model->law_factor - 1) > 0.05);
}

TEST_GROUP(make, end)
