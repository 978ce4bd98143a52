/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The corrected Persson theory against tests/data/golden/strip/corrected_persson.csv (an independent program), and in
 * what holds of it whatever the table. */
#include "base/integral.h"
#include "contact/corrected_persson.h"
#include "model_support.h"

/** The spectrum of a column of the golden profiles: harmonics 1-255, no window. */
static struct spectrum golden_spectrum(const char *name)
{
    struct table table = table_read("golden/strip/profiles.csv");
    double *height = support_room(table.rows * sizeof *height);
    for (size_t i = 0; i < table.rows; i++)
        height[i] = table_number(&table, i, name);
    struct spectrum spectrum = model_support_spectrum(height, 1, table.rows, 1e-6);
    spectrum.count = 255;
    spectrum.has_nyquist = false;
    return spectrum;
}

TEST_CASE(matches_reference)
{
    struct table table = table_read("golden/strip/corrected_persson.csv");
    assert_int_equal(table.rows, 18);
    for (size_t i = 0; i < table.rows; i++) {
        struct spectrum spectrum = golden_spectrum(table_text(&table, i, "profile"));
        struct persson persson = model_support_persson(&spectrum);
        double area = table_number(&table, i, "area_ratio"), load = table_number(&table, i, "load_over_AnEp");
        struct corrected_persson_point point = {.area_ratio = area};
        corrected_persson_curve(&point, 1, &persson, true);
        assert_near(corrected_persson_load(area, persson.m2), load, 1e-7);
        assert_near(corrected_persson_area(load, persson.m2), area, 1e-7);
        assert_near(point.constriction_m, table_number(&table, i, "constriction_length_m"), 1e-7);
        assert_near(point.separation_m, table_number(&table, i, "gap_m"), 1e-5);
    }
}

/** The golden gaps fall by load over stiffness: between two of their loads the slope is between the model's at both. */
TEST_CASE(stiffness_is_the_slope_of_the_reference)
{
    struct table table = table_read("golden/strip/corrected_persson.csv");
    const struct material_pair tin = model_support_tin();
    size_t compared = 0;
    for (size_t i = 0; i + 1 < table.rows; i++) {
        const char *profile = table_text(&table, i, "profile");
        if (strcmp(profile, table_text(&table, i + 1, "profile")) != 0)
            continue;
        struct spectrum spectrum = golden_spectrum(profile);
        const double load[] = {table_number(&table, i, "load_over_AnEp"),
                               table_number(&table, i + 1, "load_over_AnEp")};
        struct model_task task = model_support_task(&spectrum, &tin, load, 2);
        task.wanted |= QUANTITY_BIT(QUANTITY_STIFFNESS);
        struct contact_point points[3];
        double fall_m = table_number(&table, i, "gap_m") - table_number(&table, i + 1, "gap_m");
        double slope = (load[1] - load[0]) * tin.effective_modulus_Pa / fall_m;
        assert_int_equal(model_support_run(points, "corrected-persson", &task).count, 2);
        assert_true(points[0].value[QUANTITY_STIFFNESS] < slope && slope < points[1].value[QUANTITY_STIFFNESS]);
        compared++;
    }
    assert_true(compared >= 9);
}

/** The factors are the table at its knots, continuous between, and straight beyond; load and area are each other's
 * inverse. */
TEST_CASE(factors)
{
    static const struct {
        double area_ratio, load, constriction;
    } rows[] = {{0.0012, -0.062, -0.604},
                {0.04, 0.014, -0.201},
                {0.4, 0.014, 0.078},
                {0.965, -0.037, 0.972},
                {1.2e-6, -0.062, -0.604 - 0.115 * 6.908955}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct corrected_persson_factors at = corrected_persson_factors(rows[i].area_ratio);
        assert_within(at.load, rows[i].load, 1e-12);
        assert_within(at.constriction, rows[i].constriction, 1e-6);
    }
    double before = 0;
    for (double load = 1e-12; load < 2; load *= 1.1) {
        double area = corrected_persson_area(load, 0.3);
        assert_near(corrected_persson_load(area, 0.3), load, 1e-11);
        assert_true(area > before);
        before = area;
    }
}

/** Barber's identity: the separation falls by 2 l dp, and it does not depend on what else is asked. */
TEST_CASE(separation_is_the_integral_of_constriction)
{
    enum { AREAS = 200 };
    struct spectrum spectrum = model_support_law(1e-3, 0.01, 1.1, 1000);
    struct persson persson = model_support_persson(&spectrum);
    struct corrected_persson_point all[AREAS];
    for (size_t i = 0; i < AREAS; i++) {
        double odds = exp(-12 + 15.4 * (double)i / (AREAS - 1));
        all[i].area_ratio = odds / (1 + odds);
    }
    corrected_persson_curve(all, AREAS, &persson, true);
    for (size_t i = 0; i < AREAS; i += 7) {
        struct corrected_persson_point alone = {.area_ratio = all[i].area_ratio};
        corrected_persson_curve(&alone, 1, &persson, true);
        assert_near(alone.constriction_m, all[i].constriction_m, 1e-14);
        assert_near(alone.separation_m, all[i].separation_m, 1e-4);
    }
    for (size_t i = 0; i + 2 < AREAS; i++) { /* by trapezia */
        double load[3], product = 0;
        for (size_t k = 0; k < 3; k++)
            load[k] = corrected_persson_load(all[i + k].area_ratio, persson.m2);
        for (size_t k = 0; k < 2; k++)
            product += (all[i + k].constriction_m + all[i + k + 1].constriction_m) * (load[k + 1] - load[k]);
        assert_near(all[i].separation_m - all[i + 2].separation_m, product, 5e-3);
    }
}
