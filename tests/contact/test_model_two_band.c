/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The two-band models as a run calls them: what they leave empty, what their rows promise, and scans of any length. */
#include "contact/two_band.h"
#include "model_support.h"
#include "random_surface.h"

#include <stdio.h>

struct case_of {
    struct spectrum spectrum;
    struct material_pair pair;
    double load[MODEL_LOADS];
    struct model_task task;
};

/** gamma 1.5 on tin, from light contact to beyond full contact. */
static void make(struct case_of *out)
{
    out->spectrum = model_support_law(3e-4, 0.085, 1.5, 256);
    out->pair = model_support_tin();
    model_support_loads(out->load, MODEL_LOADS, 1e-6, 1);
    out->task = (struct model_task){.spectrum = &out->spectrum,
                                    .pair = &out->pair,
                                    .loads = out->load,
                                    .load_count = MODEL_LOADS,
                                    .wanted = MODEL_EVERYTHING,
                                    .tolerance = 1e-8,
                                    .sinusoid_fit = SINUSOID_FIT_THESIS,
                                    .hardness_Pa = 2.84 * out->pair.yield_strength_Pa};
}

/** Elastic: no separation and no resistance above A = 0.75, both below; TCR is ECR/(rho k). */
TEST_CASE(elastic_leaves_empty_what_is_not_to_be_trusted)
{
    struct case_of of;
    struct contact_point points[MODEL_LOADS + 1];
    make(&of);
    struct model_curve curve = model_support_run(points, "two-band-elastic", &of.task);
    size_t full = 0, empty = 0;
    assert_true(curve.exists && curve.count == MODEL_LOADS);
    for (size_t i = 0; i < curve.count; i++) {
        const struct contact_point *point = &points[i];
        bool trusted = point->value[QUANTITY_AREA] <= 0.75;
        assert_true(isnan(point->value[QUANTITY_SEPARATION]) == !trusted &&
                    isnan(point->value[QUANTITY_ECR]) == !trusted);
        assert_true(isnan(point->value[QUANTITY_TCR]) == !trusted &&
                    isnan(point->value[QUANTITY_TCR_SCALE_DEPENDENT]) == !trusted);
        assert_true(point->value[QUANTITY_AREA] > 0 && isnan(point->value[QUANTITY_ADJUSTED]));
        full += trusted;
        empty += !trusted;
        if (trusted) {
            assert_near(point->value[QUANTITY_ECR] / point->value[QUANTITY_TCR],
                        of.pair.resistivity_ohm_m * of.pair.conductivity_W_per_mK, 1e-12);
            assert_true(point->value[QUANTITY_TCR_SCALE_DEPENDENT] > point->value[QUANTITY_TCR]);
        }
    }
    assert_true(full > 5 && empty > 5);
    assert_true(isnan(curve.closed_load) && isnan(curve.beta) && isnan(curve.full.value[QUANTITY_SEPARATION]));
    assert_near(curve.full.value[QUANTITY_AREA], 1, 0);
    spectrum_free(&of.spectrum);
}

/** Elastic-plastic: the separation ends at P = H_d/4 besides; A = P/H_d while the last band yields; nothing depends on
 * H_d where nothing yields. */
TEST_CASE(plastic_gap_ends_at_a_quarter_of_the_hardness)
{
    struct case_of of;
    struct contact_point points[MODEL_LOADS + 1], soft[MODEL_LOADS + 1];
    make(&of);
    struct model_curve curve = model_support_run(points, "two-band-plastic", &of.task);
    size_t gone = 0, limited = 0;
    assert_int_equal(curve.yielding_scales, 2);
    for (size_t i = 0; i < curve.count; i++) {
        const struct contact_point *point = &points[i];
        double pressure_Pa = point->value[QUANTITY_LOAD] * of.pair.effective_modulus_Pa;
        bool trusted = point->value[QUANTITY_AREA] <= 0.75, gap = trusted && pressure_Pa <= of.task.hardness_Pa / 4;
        assert_true(isnan(point->value[QUANTITY_ECR]) == !trusted && isnan(point->value[QUANTITY_SEPARATION]) == !gap);
        assert_true(pressure_Pa <= of.task.hardness_Pa * point->value[QUANTITY_AREA] * (1 + 1e-12) ||
                    point->value[QUANTITY_AREA] == 1);
        gone += trusted && !gap;
        limited += fabs(pressure_Pa / of.task.hardness_Pa / point->value[QUANTITY_AREA] - 1) < 1e-12;
    }
    assert_true(gone > 0 && limited > 0);
    of.task.hardness_Pa /= 2;
    model_support_run(soft, "two-band-plastic", &of.task);
    for (size_t i = 0; i < curve.count; i++)
        assert_true(soft[i].value[QUANTITY_AREA] >= points[i].value[QUANTITY_AREA]);
    of.pair.yield_strength_Pa *= 1e6; /* nothing yields: the elastic area, whatever the hardness */
    struct contact_point elastic[MODEL_LOADS + 1];
    model_support_run(elastic, "two-band-elastic", &of.task);
    model_support_run(points, "two-band-plastic", &of.task);
    for (size_t i = 0; i < curve.count; i++)
        assert_near(points[i].value[QUANTITY_AREA], elastic[i].value[QUANTITY_AREA], 1e-15);
    spectrum_free(&of.spectrum);
}

/** The same surface (gamma 1 below 300 um, level above, 10 um shortest) in scans of 4, 16 and 64 of its longest waves:
 * area, separation and resistance of the elastic law within 3 %; the elastic-plastic resistance, 3.3 % at 64. */
TEST_CASE(scan_length_does_not_matter)
{
    static const char *const models[] = {"two-band-elastic", "two-band-plastic"};
    struct contact_point first[2][MODEL_LOADS + 1], points[MODEL_LOADS + 1];
    for (int waves = 4; waves <= 64; waves *= 4) {
        struct case_of of;
        make(&of);
        double length_m = waves * 3e-4;
        spectrum_free(&of.spectrum);
        of.spectrum = model_support_law(length_m, 0, 1, (size_t)(waves * 30));
        for (size_t i = 0; i < of.spectrum.count; i++)
            of.spectrum.amplitude_m[i] = 5e-5 * fmin(length_m / (double)(i + 1), 3e-4) / sqrt(length_m);
        model_support_loads(of.load, MODEL_LOADS, 1e-6, 1e-2);
        for (int m = 0; m < 2; m++) {
            struct model_curve curve = model_support_run(points, models[m], &of.task);
            if (waves == 4)
                memcpy(first[m], points, sizeof points);
            size_t compared = 0;
            for (size_t i = 0; i < curve.count; i++) {
                assert_near(points[i].value[QUANTITY_AREA], first[m][i].value[QUANTITY_AREA], 0.03);
                if (isnan(points[i].value[QUANTITY_SEPARATION]) || isnan(first[m][i].value[QUANTITY_SEPARATION]))
                    continue;
                assert_near(points[i].value[QUANTITY_SEPARATION], first[m][i].value[QUANTITY_SEPARATION], 0.03);
                assert_near(points[i].value[QUANTITY_ECR], first[m][i].value[QUANTITY_ECR], m == 0 ? 0.03 : 0.034);
                compared++;
            }
            assert_true(compared > 5);
        }
        spectrum_free(&of.spectrum);
    }
}

/** What the row states holds on every direct solution: "area at A/A_n from X on within a factor LOW to HIGH", and no
 * narrower range of one decimal would. */
TEST_CASE(the_stated_range_holds)
{
    const struct model_row *row = model_rows[model_named("two-band-elastic")];
    double from, low, high, ends, least = INFINITY, most = 0;
    assert_int_equal(sscanf(row->valid,
                            "area at A/A_n from %lf on within a factor %lf to %lf of direct solutions, separation and "
                            "resistance up to A/A_n = %lf",
                            &from, &low, &high, &ends),
                     4);
    assert_near(ends, two_band_trusted_area, 0);
    struct table table = table_read("golden/two-band/truth_elastic.csv");
    struct material_pair pair = {.effective_modulus_Pa = 1,
                                 .resistivity_ohm_m = 1,
                                 .conductivity_W_per_mK = 1,
                                 .yield_strength_Pa = 1,
                                 .mean_free_path_m = {0, 0},
                                 .side_conductivity_W_per_mK = {1, 1}};
    size_t counted = 0;
    for (size_t i = 0; i < table.rows; i++) {
        struct spectrum spectrum;
        double load = table_number(&table, i, "load_over_Ep"), truth = table_number(&table, i, "area_ratio");
        random_surface(&spectrum, table_number(&table, i, "hurst"), table_number(&table, i, "long_index"),
                       table_number(&table, i, "short_index"), table_number(&table, i, "plateau") > 0);
        struct model_task task = {.spectrum = &spectrum,
                                  .pair = &pair,
                                  .loads = &load,
                                  .load_count = 1,
                                  .wanted = QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_SEPARATION),
                                  .tolerance = 1e-6,
                                  .hardness_Pa = INFINITY};
        struct contact_point point[2];
        struct model_curve curve = model_support_run(point, "two-band-elastic", &task);
        assert_true(curve.exists);
        if (truth >= from) {
            least = fmin(least, point->value[QUANTITY_AREA] / truth);
            most = fmax(most, point->value[QUANTITY_AREA] / truth);
            counted++;
        }
        spectrum_free(&spectrum);
    }
    assert_true(counted > 150);
    assert_near(floor(least * 10) / 10, low, 1e-12);
    assert_near(ceil(most * 10) / 10, high, 1e-12);
    table_free(&table);
}

/** A constant spectrum, one harmonic, four of them (8 points), and none with an amplitude. */
TEST_CASE(hard_spectra)
{
    static const char *const models[] = {"two-band-elastic", "two-band-plastic"};
    struct case_of of;
    struct contact_point points[MODEL_LOADS + 1];
    make(&of);
    static const struct {
        size_t count;
        double amplitude_m;
    } spectra[] = {{256, 1e-8}, {1, 1e-6}, {4, 1e-7}, {256, 0}};
    for (size_t s = 0; s < sizeof spectra / sizeof *spectra; s++)
        for (int m = 0; m < 2; m++) {
            of.spectrum.count = spectra[s].count;
            for (size_t i = 0; i < spectra[s].count; i++)
                of.spectrum.amplitude_m[i] = spectra[s].amplitude_m;
            struct model_curve curve = model_support_run(points, models[m], &of.task);
            assert_int_equal(curve.exists, spectra[s].amplitude_m > 0);
            assert_int_equal(curve.count, curve.exists ? MODEL_LOADS : 0);
            assert_false(curve.overflows);
            for (size_t i = 0; i < curve.count; i++) {
                assert_true(points[i].value[QUANTITY_AREA] > 0 && points[i].value[QUANTITY_AREA] <= 1);
                assert_true(i == 0 ||
                            points[i].value[QUANTITY_AREA] >= points[i - 1].value[QUANTITY_AREA] * (1 - 6e-4));
                assert_true(isnan(points[i].value[QUANTITY_SEPARATION]) || points[i].value[QUANTITY_SEPARATION] >= 0);
            }
            if (curve.exists)
                assert_true(points[MODEL_LOADS - 1].value[QUANTITY_AREA] == 1);
        }
    spectrum_free(&of.spectrum);
}
