/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A hardness beside an elastic contact, and the models that have it. */
#include "contact/bearing.h"
#include "contact/corrected_persson.h"
#include "direct/direct_quantities.h"
#include "direct/direct_surface.h"
#include "model_support.h"
#include <gsl/gsl_cdf.h>

static double length_of(double area, double crossings_per_m)
{
    return pow(1 - sqrt(area), 1.5) / (2 * crossings_per_m);
}

/** Three ramps and three triangles: everything by hand. Of the ramps alone, which rise through a height too seldom for
 * a count, the ratio to Gaussian heights at half the surface stays. */
TEST_CASE(counted)
{
    enum { N = 2400, WAVE = N / 3 };
    double height[2 * N];
    for (size_t i = 0; i < N; i++) { /* of 0 ... 1: up and down at once, and up and down */
        size_t k = i % WAVE;
        height[i] = ((double)k + 0.5) / WAVE;
        height[N + i] = k < WAVE / 2 ? ((double)k + 0.25) / (WAVE / 2) : ((double)(WAVE - k) - 0.75) / (WAVE / 2);
    }
    struct strip_rows rows = {height, 2, N, 1e-3, true, NULL, 0};
    const struct bearing *bearing = model_support_bearing(&rows);
    for (double area = 0.1; area < 0.95; area += 0.1) {
        struct bearing_at at = bearing_counted(area, bearing);
        assert_near(at.gap_m, (1 - area) * (1 - area) / 2, 1e-2); /* even heights: d = 1 - A */
        assert_near(at.length_m, length_of(area, 6 / 4.8), 1e-3); /* three times in each of two rows of 2.4 m */
    }
    rows.rows = 1;
    bearing = model_support_bearing(&rows);
    struct bearing_at half = bearing_gaussian(0.5, 1, 1);
    for (double area = 0.1; area < 0.95; area += 0.2) {
        struct bearing_at at = bearing_counted(area, bearing), gaussian = bearing_gaussian(area, 1, 1);
        assert_near(at.gap_m, area < 0.5 ? pow(1 - area, 2) / 2 : gaussian.gap_m / half.gap_m / 8, 1e-2);
        assert_near(at.length_m, gaussian.length_m / half.length_m * length_of(0.5, 1.25), 1e-9);
    }
}

/** Waves rise through a height less than twenty times: what is counted of them does not go by steps. */
TEST_CASE(smooth)
{
    enum { N = 2000 };
    double height[N], before = NAN;
    for (size_t i = 0; i < N; i++) {
        height[i] = 0;
        for (int n = 12; n <= 24; n++)
            height[i] += cos(2 * M_PI * n * ((double)i / N + direct_random(7, (uint64_t)n)));
    }
    struct strip_rows rows = {height, 1, N, 1e-6, true, NULL, 0};
    const struct bearing *bearing = model_support_bearing(&rows);
    assert_true(bearing->end[0] < bearing->nodes / 2 && bearing->end[1] > bearing->nodes / 2);
    for (double x = -4; x < 4; x += 0.02) {
        double length = log(bearing_counted(logistic(x), bearing).length_m);
        assert_true(isnan(before) || (length <= before && length > before - 0.07));
        before = length;
    }
}

enum { SIDE = 64, DIRECT_LOADS = 4 };

static void solve(struct direct_point *out, const double *height_m, const double *load, double hardness)
{
    struct direct_contact contact;
    const struct direct_ladder_def def = {
        .load = load, .loads = DIRECT_LOADS, .hardness = hardness, .tolerance = 1e-6, .resistance = true};
    expect_ok(direct_contact_make, &contact, height_m, &(struct direct_grid){SIDE, SIDE, 1e-6, false, false});
    expect_ok(direct_ladder_run, out, &contact, &def);
    direct_contact_free(&contact);
}

/** What follows from the elastic solution of a surface with plateaus, against solutions under three hardnesses. */
TEST_CASE(direct_solutions)
{
    static const struct {
        double hardness, gap, length; /* over E'; rms of ln */
    } cases[] = {{0.01, 0.13, 0.2}, {0.1, 0.025, 0.025}, {3, 0.002, 0.002}};
    double height[SIDE * SIDE], given[SIDE * SIDE], load[DIRECT_LOADS] = {0.001, 0.0025, 0.005, 0.0075};
    const struct direct_law law = {0.009, 1.1, 8e-6, SIDE * 1e-6, 4};
    struct direct_spectrum spectrum;
    struct direct_point elastic[DIRECT_LOADS], hard[DIRECT_LOADS];
    for (size_t k = 0; k < SIDE * SIDE; k++) {
        double normal = gsl_cdf_ugaussian_Pinv(((double)k + 0.5) / (SIDE * SIDE));
        given[k] = normal < 0 ? normal : 0.15 * normal;
    }
    expect_ok(direct_spectrum_of_law, &spectrum, &law);
    expect_ok(direct_surface_make, height, SIDE,
              &(struct direct_recipe){direct_spectrum_variance, &spectrum, given, SIDE * SIDE}, 3);
    direct_spectrum_free(&spectrum);
    const struct strip_rows rows = {height, SIDE, SIDE, 1e-6, true, NULL, 0};
    const struct bearing *bearing = model_support_bearing(&rows);
    solve(elastic, height, load, INFINITY);
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        double square[3] = {0};
        solve(hard, height, load, cases[c].hardness);
        for (size_t i = 0; i < DIRECT_LOADS; i++) {
            const struct direct_quantities *own = &elastic[i].quantities, *truth = &hard[i].quantities;
            double ratio = load[i] / cases[c].hardness, area = bearing_area(own->area_ratio, ratio);
            struct bearing_at bears = bearing_counted(area, bearing);
            double gap_m = bearing_gap(own->gap_m, ratio / area, &bears);
            double length_m = bearing_length(elastic[i].constriction_m, ratio / area, &bears);
            square[0] += pow(log(area / truth->area_ratio), 2) / DIRECT_LOADS;
            square[1] += pow(log(gap_m / truth->gap_m), 2) / DIRECT_LOADS;
            square[2] += pow(log(length_m / hard[i].constriction_m), 2) / DIRECT_LOADS;
        }
        assert_true(sqrt(square[0]) < 0.08 && sqrt(square[1]) < cases[c].gap && sqrt(square[2]) < cases[c].length);
    }
}

/** Gaussian heights at half contact, and far up: (d - z)+ is d. */
TEST_CASE(gaussian)
{
    struct bearing_at at = bearing_gaussian(0.5, 4e-12, 0.01);
    assert_near(at.gap_m, 2e-6 / sqrt(2 * M_PI), 1e-12);
    assert_near(at.length_m, length_of(0.5, 0.1 / (2e-6 * 2 * M_PI)), 1e-12);
    at = bearing_gaussian(1.3498980316300945e-3, 4e-12, 0.01); /* 3 sigma */
    assert_near(at.gap_m, 2e-6 * (3 * (1 - 1.3498980316300945e-3) + 4.4318484119380075e-3), 1e-9);
    assert_near(at.length_m, length_of(1.3498980316300945e-3, 0.1 / (2e-6 * 2 * M_PI) * exp(-4.5)), 1e-9);
}

TEST_CASE(limits)
{
    struct bearing_at open = {1, INFINITY}, tight = {1e-9, 1e-9};
    assert_near(bearing_area(0.1, 1e-4), 0.1, 1e-11);
    assert_near(bearing_area(1e-4, 0.1), 0.1, 1e-11);
    assert_near(bearing_area(0.1, 0.1), 0.1 * pow(2, 0.25), 1e-12);
    assert_true(bearing_area(0.5, 2) == 1);
    assert_near(bearing_area(1e-100, 1e-98), 1e-98, 1e-8);
    assert_near(bearing_gap(1e-6, 1, &open), 1e-6, 1e-12);
    assert_near(bearing_length(1e-5, 1, &open), 1e-5, 1e-12);
    assert_near(bearing_gap(1e-6, 1, &tight), 1e-9, 1e-8);
    assert_near(bearing_length(1e-5, 1, &tight), 1e-9 / 0.8, 1e-8);
    assert_near(bearing_gap(1e-6, 1, &(struct bearing_at){1e-6, 1}), 1e-6 * cbrt(0.5), 1e-12);
    assert_near(bearing_length(1e-5, 1, &(struct bearing_at){1, 0.8e-5}), 1e-5 * cbrt(0.5), 1e-12);
    assert_near(bearing_gap(1e-6, 1e-3, &(struct bearing_at){1e-7, 1}), 1e-6 * cbrt(0.5), 1e-12);
}

/** The rows give what their parts give; a ratio of one is the corrected theory; all end at the largest area. */
TEST_CASE(models)
{
    enum { N = 400 };
    struct spectrum spectrum = model_support_law(3e-4, 0.085, 1.5, 256);
    struct material_pair pair = model_support_tin();
    double load[MODEL_LOADS], height[N];
    struct contact_point points[4][MODEL_LOADS + 1];
    static const char *const names[4] = {"corrected-persson", "strip", "corrected-persson-plastic", "strip-plastic"};
    for (size_t i = 0; i < N; i++)
        height[i] = 1e-7 * sin(0.05 * (double)i) + 3e-8 * sin(0.31 * (double)i);
    struct strip_rows rows = {height, 1, N, 1e-6, false, NULL, 0};
    struct strip strip = {.own = {.count = 2, .logit = {-4, 2}, .value = {{-9, 1, 2}, {-4, -2, 0}}}, .surrogates = 1};
    strip.surrogate[0] = strip.own;
    model_support_loads(load, MODEL_LOADS, 1e-5, 10);
    struct model_task task = model_support_task(&spectrum, &pair, load, MODEL_LOADS);
    task.hardness_Pa = 1e30;
    task.strip = &strip;
    struct model_curve curve[4];
    assert_false(model_support_run(points[3], "strip-plastic", &task).exists); /* not in order */
    task.bearing = model_support_bearing(&rows);
    for (int m = 0; m < 4; m++)
        curve[m] = model_support_run(points[m], names[m], &task);
    double m2 = spectrum_moment(&spectrum, 1);
    struct persson persson = model_support_persson(&spectrum);
    struct corrected_persson_point at = {.area_ratio = corrected_persson_area(load[5], m2)};
    corrected_persson_curve(&at, 1, &persson, true);
    double length_m = at.constriction_m;
    for (size_t i = 0; i < curve[0].count; i++) {
        const double *value = points[0][i].value;
        double area = corrected_persson_area(load[i], m2);
        assert_near(value[QUANTITY_AREA], area, 1e-14);
        assert_near(value[QUANTITY_ECR] / pair.resistivity_ohm_m, value[QUANTITY_TCR] * pair.conductivity_W_per_mK,
                    1e-12);
        for (int q = QUANTITY_AREA; q <= QUANTITY_TCR; q++) {
            if (q == QUANTITY_ADJUSTED)
                continue;
            if (i < curve[1].count)
                assert_near(points[1][i].value[q], value[q], 1e-3);
            for (int m = 2; m < 4; m++) /* nothing yields */
                assert_near(points[m][i].value[q], points[m - 2][i].value[q], q == QUANTITY_AREA ? 1e-12 : 1e-9);
        }
    }
    for (int m = 0; m < 4; m++) {
        assert_true(curve[m].exists && curve[m].count > 3 && curve[m].count < MODEL_LOADS);
        assert_true(points[m][curve[m].count - 1].value[QUANTITY_AREA] <= CORRECTED_PERSSON_LARGEST_AREA);
    }
    task.hardness_Pa = 1e-3 * pair.effective_modulus_Pa; /* all yields: A = P/H */
    (void)model_support_run(points[3], names[3], &task);
    assert_near(points[3][0].value[QUANTITY_AREA], load[0] / 1e-3, 0.05);
    assert_near(points[0][5].value[QUANTITY_TCR] * pair.conductivity_W_per_mK, 2 * length_m, 1e-6);
    for (int k = 0; k < 2; k++) { /* at equal area three times the gap and twice the length */
        strip.own.value[k][2] += log(3);
        strip.own.value[k][1] += log(2);
    }
    (void)model_support_run(points[1], names[1], &task);
    assert_near(points[1][5].value[QUANTITY_ECR], 2 * points[0][5].value[QUANTITY_ECR], 1e-3);
    assert_near(points[1][5].value[QUANTITY_SEPARATION], 3 * points[0][5].value[QUANTITY_SEPARATION], 1e-3);
    task.strip = NULL;
    assert_false(model_support_run(points[1], names[1], &task).exists);
}
