/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacting slopes as a run calls it: which surfaces have a curve, and what it leaves empty. */
#include "contact/persson.h"
#include "model_support.h"

enum { POINTS = 4096 };
static const double spacing_m = 1e-6;

/** A profile of many waves, phases from a fixed sequence, heights near Gaussian; `skew` lowers what is high: a plateau.
 */
static void profile(double height_m[POINTS], double skew)
{
    uint32_t seed = 1;
    memset(height_m, 0, POINTS * sizeof *height_m);
    for (int n = 16; n < 400; n++) {
        seed = seed * UINT32_C(1664525) + UINT32_C(1013904223);
        for (size_t i = 0; i < POINTS; i++)
            height_m[i] += cos(2 * M_PI * (n * (double)i / POINTS + seed / 4294967296.0)) / n;
    }
    for (size_t i = 0; i < POINTS; i++)
        height_m[i] = 1e-6 * (skew > 0 ? -log1p(exp(-skew * height_m[i])) / skew : height_m[i]);
}

struct case_of {
    struct slope_point point[POINTS];
    struct spectrum spectrum;
    struct material_pair pair;
    double load[MODEL_LOADS];
    struct model_task task;
};

static void make(struct case_of *out, double skew)
{
    double height_m[POINTS], mean_m = 0;
    struct status status = {0};
    profile(height_m, skew);
    for (size_t i = 0; i < POINTS; i++)
        mean_m += height_m[i] / POINTS;
    for (size_t i = 0; i < POINTS; i++)
        height_m[i] -= mean_m;
    size_t count = contacting_slopes_of_profile(out->point, height_m, POINTS, spacing_m);
    assert_int_equal(spectrum_compute(&out->spectrum, height_m, POINTS, spacing_m, SPECTRUM_WINDOW_NONE, &status),
                     STATUS_OK);
    out->pair = model_support_tin();
    model_support_loads(out->load, MODEL_LOADS, 1e-6, 1);
    out->task = (struct model_task){.spectrum = &out->spectrum,
                                    .pair = &out->pair,
                                    .loads = out->load,
                                    .load_count = MODEL_LOADS,
                                    .wanted = MODEL_EVERYTHING,
                                    .tolerance = 1e-8,
                                    .points = out->point,
                                    .point_count = count};
}

/** Area at every load; separation and resistance up to A = 0.15 alone; TCR is ECR/(rho k); marks at both ends. */
TEST_CASE(what_is_given)
{
    static struct case_of of;
    struct contact_point points[MODEL_LOADS + 1];
    make(&of, 3);
    struct model_curve curve = model_support_run(points, "contacting-slopes", &of.task);
    struct contacting_slopes slopes;
    struct persson persson;
    struct status status = {0};
    size_t given = 0, empty = 0, few = 0;
    assert_int_equal(contacting_slopes_make(&slopes, of.point, of.task.point_count, persson_energy_factor, &status),
                     STATUS_OK);
    assert_int_equal(persson_make(&persson, &of.spectrum, persson_energy_factor, &status), STATUS_OK);
    assert_true(curve.exists && curve.count == MODEL_LOADS && isnan(curve.full_load));
    for (size_t i = 0; i < curve.count; i++) {
        const struct contact_point *point = &points[i];
        bool gap = point->value[QUANTITY_AREA] <= 0.15;
        assert_true(point->value[QUANTITY_AREA] > 0 && point->value[QUANTITY_AREA] < 1);
        assert_true(i == 0 || point->value[QUANTITY_AREA] >= points[i - 1].value[QUANTITY_AREA]);
        assert_true(isnan(point->value[QUANTITY_SEPARATION]) == !gap && isnan(point->value[QUANTITY_ECR]) == !gap &&
                    isnan(point->value[QUANTITY_TCR]) == !gap);
        assert_true(isnan(point->value[QUANTITY_TCR_SCALE_DEPENDENT]) && isnan(point->value[QUANTITY_ADJUSTED]));
        bool touching_few = point->value[QUANTITY_AREA] < 30.0 / (POINTS - 2);
        bool all_but_one = point->value[QUANTITY_AREA] >= (POINTS - 3.0) / (POINTS - 2);
        assert_true((point->beyond_fit == 1) == (touching_few || all_but_one));
        struct contacting_slopes_gap fit;
        if (gap) {
            assert_true(contacting_slopes_gap(&fit, &slopes, &persson, point->value[QUANTITY_LOAD],
                                              point->value[QUANTITY_AREA]));
            assert_near(point->value[QUANTITY_SEPARATION], fit.separation_m, 1e-14);
            assert_near(point->value[QUANTITY_ECR], 2 * of.pair.resistivity_ohm_m * fit.constriction_m, 1e-14);
            assert_near(point->value[QUANTITY_ECR] / point->value[QUANTITY_TCR],
                        of.pair.resistivity_ohm_m * of.pair.conductivity_W_per_mK, 1e-12);
        }
        given += gap;
        empty += !gap;
        few += touching_few;
    }
    assert_true(given > 3 && empty > 3 && few > 0);
    contacting_slopes_free(&slopes);
    persson_free(&persson);
    of.task.wanted = QUANTITY_BIT(QUANTITY_AREA);
    struct contact_point area_only[MODEL_LOADS + 1];
    model_support_run(area_only, "contacting-slopes", &of.task);
    assert_near(area_only[3].value[QUANTITY_AREA], points[3].value[QUANTITY_AREA], 0);
    assert_true(isnan(area_only[3].value[QUANTITY_SEPARATION]) && isnan(area_only[3].value[QUANTITY_ECR]));
    spectrum_free(&of.spectrum);
}

/** On near-Gaussian heights the area is Persson's to a few tenths at any load where over 30 points touch; on a plateau,
 * whose tops are flat, it is over twice that. */
TEST_CASE(a_plateau_has_more_area_than_its_spectrum_says)
{
    static struct case_of of;
    struct contact_point points[MODEL_LOADS + 1], persson[MODEL_LOADS + 1];
    for (int skewed = 0; skewed < 2; skewed++) {
        double most = 0, least = INFINITY;
        make(&of, skewed ? 6 : 0);
        model_support_run(points, "contacting-slopes", &of.task);
        model_support_run(persson, "persson", &of.task);
        for (size_t i = 0; i < MODEL_LOADS; i++) {
            double ratio = points[i].value[QUANTITY_AREA] / persson[i].value[QUANTITY_AREA];
            if (points[i].value[QUANTITY_AREA] < 0.01 || points[i].value[QUANTITY_AREA] > 0.3)
                continue;
            most = fmax(most, ratio);
            least = fmin(least, ratio);
        }
        assert_true(skewed ? least > 2 : most < 1.3 && least > 0.7);
        spectrum_free(&of.spectrum);
    }
}

/** A map whose rows are one profile: across it there is no slope, so the mean square is half of the rows', and the area
 * of the profile at sqrt2 times the load. */
TEST_CASE(a_map_has_both_slopes)
{
    enum { NX = 600, NY = 12 };
    static struct case_of of;
    static double map[NX * NY], height_m[POINTS];
    static struct slope_point point[NX * NY];
    struct contact_point rows[MODEL_LOADS + 1], both[MODEL_LOADS + 1];
    make(&of, 3);
    profile(height_m, 3);
    for (size_t row = 0; row < NY; row++)
        memcpy(map + row * NX, height_m, NX * sizeof *map);
    of.task.points = point;
    of.task.point_count = 0;
    for (size_t row = 1; row + 1 < NY; row++)
        of.task.point_count += contacting_slopes_of_profile(point + of.task.point_count, map + row * NX, NX, spacing_m);
    model_support_run(rows, "contacting-slopes", &of.task);
    for (size_t i = 0; i < MODEL_LOADS; i++)
        of.load[i] /= M_SQRT2;
    assert_int_equal(contacting_slopes_of_map(point, map, NX, NY, spacing_m, 7e-6), of.task.point_count);
    model_support_run(both, "contacting-slopes", &of.task);
    for (size_t i = 0; i < MODEL_LOADS; i++)
        assert_near(both[i].value[QUANTITY_AREA], rows[i].value[QUANTITY_AREA], 1e-9);
    spectrum_free(&of.spectrum);
}

/** 31 inner points are enough, 30, 8 or none are not; nor is a surface without any slope. */
TEST_CASE(too_few_points_have_no_curve)
{
    static struct case_of of;
    struct contact_point points[MODEL_LOADS + 1];
    make(&of, 0);
    static const size_t counts[] = {31, 30, 8, 1, 0};
    for (size_t c = 0; c < sizeof counts / sizeof *counts; c++) {
        of.task.point_count = counts[c];
        struct model_curve curve = model_support_run(points, "contacting-slopes", &of.task);
        assert_int_equal(curve.exists, counts[c] == 31);
        assert_int_equal(curve.count, curve.exists ? MODEL_LOADS : 0);
    }
    of.task.point_count = 100;
    for (size_t i = 0; i < 100; i++)
        of.point[i].slope_square = 0;
    assert_false(model_support_run(points, "contacting-slopes", &of.task).exists);
    spectrum_free(&of.spectrum);
}
