/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sensitivity to cut-off, scan length and hardness: the factors are those of reports on changed scans, made apart. */
#include "contact/model.h"
#include "profile/level.h"
#include "profile/profile.h"
#include "run/pipeline.h"

#define METAL(yield_strength_Pa)                                                                                       \
    "material: {E_Pa: 4.1369e10, nu: 0.36, resistivity_ohm_m: 1.15e-7, Sy_Pa: " yield_strength_Pa "}\n"

enum { POINTS = 400, LOADS = 9 };
static const double spacing_m = 5e-7;
static const char *const columns[2][2] = {{"area_factor", "area_ratio"}, {"ecr_factor", "ecr_ohm_m2"}};

/** A scan in all digits. */
static void write_scan(const struct directory *place, const char *name, const double *height_m, size_t points)
{
    struct text *csv = support_text();
    text_add(csv, "x [m],z [m]\n");
    for (size_t i = 0; i < points; i++)
        text_add(csv, "%.17g,%.17g\n", spacing_m * (double)i, height_m[i]);
    directory_write(place, name, text_string(csv));
}

static void run_scene(const struct directory *place, const char *in, const char *more)
{
    pipeline_report(place, in, filled("out-%s", in),
                    filled("models: [multiscale, statistical, corrected-persson, strip, cmy]\n"
                           "effects: [plasticity, electrical]\nlevel: line\nwindow: none\n"
                           "load: {from: 1e-6, to: 1e-2, points: %d}\noperating_load: 1e-4\n%s",
                           LOADS, more));
}

static void level(double *height_m, size_t points)
{
    struct levelling levelling;
    expect_ok(level_remove, &levelling, height_m, NULL, points, spacing_m, LEVEL_LINE);
}

/** Value at the middle load of a model in a report of one surface; NaN: no row or an empty cell. */
static double at_middle(const struct directory *place, const char *out, const char *model, const char *column)
{
    struct table table = directory_table(place, filled("%s/data/contact.csv", out));
    double value = NAN;
    size_t index = 0;
    for (size_t row = 0; row < table.rows; row++) {
        if (strcmp(table_text(&table, row, "model"), model) != 0)
            continue;
        if (index++ == LOADS / 2 && *table_text(&table, row, column))
            value = table_number(&table, row, column);
    }
    return value;
}

static void assert_factor(const struct table *table, size_t row, const char *column, double expected)
{
    const char *cell = table_text(table, row, column);
    assert_int_equal(*cell == '\0', isnan(expected) != 0);
    if (*cell)
        assert_near(table_number(table, row, column), expected, 1e-9);
}

/** Every model and change against reports on the low-passed scan, its halves, and a harder metal. Strips are not
 * compared: they stay those of the unchanged scan. */
TEST_IN_PLACE(factors_are_those_of_separate_reports)
{
    struct synth_def def = synth_def_default();
    double z[POINTS], smooth[POINTS];
    def.points = POINTS;
    def.length_m = spacing_m * POINTS;
    def.gamma = 1.2;
    def.alpha = 1e-2;
    def.seed = 3;
    expect_ok(synth_profile, z, &def);
    for (size_t i = 0; i < POINTS; i++)
        z[i] += 1e-3 * spacing_m * (double)i; /* tilted */
    write_scan(place, "in/a.csv", z, POINTS);
    write_scan(place, "harder/a.csv", z, POINTS);
    level(z, POINTS);
    const struct profile profile = {.height_m = z, .points = POINTS, .spacing_m = spacing_m};
    expect_ok(filter_gaussian, smooth, &profile, 4 * spacing_m);
    write_scan(place, "smooth/a.csv", smooth, POINTS);
    write_scan(place, "first/a.csv", z, POINTS / 2);
    write_scan(place, "second/a.csv", z + POINTS / 2, POINTS / 2);
    static const char *const folders[] = {"in", "smooth", "first", "second", "harder"};
    for (int f = 0; f < 5; f++)
        run_scene(place, folders[f], f < 4 ? METAL("1.4e7") : METAL("1.54e7"));
    struct table table = directory_table(place, "out-in/data/sensitivity.csv");
    assert_int_equal(table.columns, 5);
    size_t compared = 0;
    for (size_t row = 0; row < table.rows; row++) {
        const char *model = table_text(&table, row, "model"), *change = table_text(&table, row, "change");
        for (int c = 0; c < 2; c++) {
            double value[5];
            for (int f = 0; f < 5; f++)
                value[f] = at_middle(place, filled("out-%s", folders[f]), model, columns[c][1]);
            bool cutoff = strcmp(change, "cut-off x2") == 0;
            bool halved = strcmp(change, "scan /2") == 0;
            assert_true(cutoff || halved || strcmp(change, "hardness x1.1") == 0);
            assert_true(cutoff || halved || model_rows[model_named(model)]->plastic);
            if (model_rows[model_named(model)]->uses_strip && (cutoff || halved))
                continue;
            assert_factor(&table, row, columns[c][0],
                          cutoff   ? value[1] / value[0]
                          : halved ? sqrt(value[2] * value[3]) / value[0]
                                   : value[4] / value[0]);
            compared += isnan(value[0]) ? 0 : 1;
        }
    }
    size_t rows = 0;
    for (size_t m = 0; m < model_count; m++)
        rows += model_rows[m]->uses_map ? 0 : model_rows[m]->plastic ? 3 : 2;
    assert_int_equal(table.rows, rows);
    assert_true(compared > 20);
}

/** Heights and scene of one report; the value at the middle load of every model. */
static void make_report(const struct directory *place, const char *in, const char *how, const double *height_m,
                        size_t points)
{
    write_scan(place, filled("%s/a.csv", in), height_m, points);
    pipeline_report(
        place, in, filled("out-%s", in),
        filled("models: [multiscale, corrected-persson, cmy]\neffects: [plasticity, electrical]\n%s\n"
               "moments: difference\nload: {from: 1e-6, to: 1e-2, points: %d}\noperating_load: 1e-4\n" METAL("1.4e7"),
               how, LOADS));
}

/** With a doubled cut-off a periodic scan keeps its window and levelling, and is smoothed around its ends (here by a
 * sum over the circle). Its halves are not periodic, and are compared with the whole scan windowed as they are. */
TEST_IN_PLACE(a_scan_that_closes_stays_closed)
{
    struct synth_def def = synth_def_default();
    double z[POINTS], smooth[POINTS];
    def.points = POINTS;
    def.length_m = spacing_m * POINTS;
    def.gamma = 1.5;
    def.alpha = 1e-1;
    def.lambda_s_m = 20 * spacing_m;
    def.seed = 1;
    expect_ok(synth_profile, z, &def);
    for (int i = 0; i < POINTS; i++) {
        double sum = 0, weights = 0;
        for (int k = -POINTS / 2; k < POINTS / 2; k++) {
            double weight = exp(-M_PI * M_PI / M_LN2 * k * k / 16); /* cut-off of 4 spacings */
            sum += weight * z[(i + k + POINTS) % POINTS];
            weights += weight;
        }
        smooth[i] = sum / weights;
    }
    make_report(place, "in", "", z, POINTS);
    make_report(place, "smooth", "level: mean\nwindow: none", smooth, POINTS);
    make_report(place, "whole", "level: line\nwindow: hann", z, POINTS);
    make_report(place, "first", "level: line\nwindow: hann", z, POINTS / 2);
    make_report(place, "second", "level: line\nwindow: hann", z + POINTS / 2, POINTS / 2);
    struct table table = directory_table(place, "out-in/data/sensitivity.csv");
    size_t compared = 0;
    for (size_t row = 0; row < table.rows; row++) {
        const char *model = table_text(&table, row, "model"), *change = table_text(&table, row, "change");
        for (int c = 0; c < 2; c++) {
            double is = at_middle(place, "out-in", model, columns[c][1]),
                   smoothed = at_middle(place, "out-smooth", model, columns[c][1]),
                   whole = at_middle(place, "out-whole", model, columns[c][1]),
                   first = at_middle(place, "out-first", model, columns[c][1]),
                   second = at_middle(place, "out-second", model, columns[c][1]);
            if (strcmp(change, "cut-off x2") == 0) {
                assert_factor(&table, row, columns[c][0], smoothed / is);
                assert_near(smoothed / is, 1, 0.02); /* nothing is as short */
                compared++;
            } else if (strcmp(change, "scan /2") == 0) {
                assert_factor(&table, row, columns[c][0], sqrt(first * second) / whole);
                compared++;
            }
        }
    }
    assert_int_equal(compared, 20);
}

/** With waves far longer than the cut-off, doubling it changes nothing. With two equal halves, halving changes nothing
 * if the answer does not depend on length (the corrected Persson theory's area). */
TEST_IN_PLACE(smooth_waves_do_not_change)
{
    double z[POINTS];
    for (size_t i = 0; i < POINTS; i++) /* full periods in each half, even about its middle: level as they are */
        z[i] = 1e-7 * cos(2 * M_PI * 4 * ((double)i + 0.5) / POINTS) +
               2e-8 * cos(2 * M_PI * 10 * ((double)i + 0.5) / POINTS);
    write_scan(place, "wave/a.csv", z, POINTS);
    run_scene(place, "wave", "material: tin\n");
    struct table table = directory_table(place, "out-wave/data/sensitivity.csv");
    size_t seen = 0;
    for (size_t row = 0; row < table.rows; row++) {
        const char *model = table_text(&table, row, "model");
        bool cutoff = strcmp(table_text(&table, row, "change"), "cut-off x2") == 0;
        bool corrected = strncmp(model, "corrected-persson", 17) == 0;
        if (!*table_text(&table, row, "area_factor") || strstr(table_text(&table, row, "change"), "hardness"))
            continue;
        if (cutoff || corrected) {
            assert_near(table_number(&table, row, "area_factor"), 1, 0.01);
            seen++;
        }
    }
    assert_true(seen > 6);
}

/** Fewer than 16 points are not halved: cells are empty, and there is no section. */
TEST_IN_PLACE(a_short_scan_says_nothing)
{
    double z[15];
    for (size_t i = 0; i < 15; i++)
        z[i] = 1e-7 * sin(2.4 * (double)i) + 3e-8 * cos(5.1 * (double)i);
    write_scan(place, "wave/a.csv", z, 15);
    run_scene(place, "wave", "material: tin\n");
    struct table table = directory_table(place, "out-wave/data/sensitivity.csv");
    assert_true(table.rows > 0);
    for (size_t row = 0; row < table.rows; row++)
        assert_string_equal(table_text(&table, row, "area_factor"), "");
    char *view = directory_read(place, "out-wave/view.json");
    assert_null(strstr(view, "length_factor"));
}

TEST_GROUP(directory_setup, directory_teardown)
