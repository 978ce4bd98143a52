/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The direct solution where there is little or nothing to solve: where there is no answer no number is written, and the
 * report says why. */
#include "cli/process.h"

#define SCENE "material: tin\neffects: [plasticity, separation, electrical, thermal]\n"

/** Writes 400 heights [um] whose amplitudes fall as n^-gamma, with scattered phases; one point is `spike` higher. */
static void write_surface(const char *place, const char *path, double scale, double gamma, double spike)
{
    enum { POINTS = 400 };
    struct text *text = support_text();
    text_add(text, "x [um],z [um]\n");
    for (int i = 0; i < POINTS; i++) {
        double height = i == POINTS / 3 ? spike : 0;
        for (int m = 1; m <= 60; m++)
            height += scale * pow(m, -gamma) * cos(2 * M_PI * m * i / POINTS + m * m * 1.7);
        text_add(text, "%g,%.9g\n", 0.5 * i, height);
    }
    workspace_write(place, path, text_string(text));
}

/** Reports d into out; no NaN or infinity is written. */
static void report(const char *place, int status, const char *direct)
{
    workspace_write(place, "d/scene.yaml", filled(SCENE "direct: {%s}\n", direct));
    struct process run = expect_exit(place, status, "report", "d", "-o", "out", "--no-cost");
    process_expect_numbers(run.out, "stdout");
    process_expect_numbers(run.err, "stderr");
    assert_true(workspace_expect_numbers(place, "out") > 20);
}

static const char *const numbers[] = {"area_ratio", "area_stderr", "gap_m",          "gap_stderr",
                                      "ecr_ohm_m2", "ecr_stderr",  "tcr_K_m2_per_W", "patches"};
enum { NUMBERS = sizeof numbers / sizeof *numbers };

/** How many loads of its chart have a direct solution: rows of a load and both ends of the error. */
static size_t points_drawn(const char *place)
{
    static const char rows[] = "f=out/figures/direct.csv; [ ! -e $f ] || grep -cE '^[^#,]*,[^,]*,[^,]*$' $f || true";
    return strtoul(workspace_shell(place, rows), NULL, 10);
}

/* With fewer than 100 points in contact tables, ratios and charts have no number. Complete contact has area 1, no gap,
 * no resistance, and no ratio of these. Between them there are numbers. */
TEST_IN_WORKSPACE(test_from_none_to_complete)
{
    write_surface(place, "d/a.csv", 0.3, 1.3, 0);
    report(place, 0, "grid: 64, seeds: 2, loads: [1e-9, 3e-2, 10], surfaces: all");
    struct table t = workspace_table(place, "out/data/direct.csv"),
                 r = workspace_table(place, "out/data/direct_ratio.csv");
    size_t rows[3] = {0};
    for (size_t i = 0; i < t.rows; i++) {
        double load = table_number(&t, i, "load_over_AnEp");
        rows[load > 1 ? 2 : load > 1e-2]++;
        for (size_t k = 0; k < NUMBERS; k++)
            if (load < 1e-2 || !strstr(numbers[k], "stderr"))
                assert_true((*table_text(&t, i, numbers[k]) != '\0') == (load > 1e-2));
        if (load > 1) {
            assert_true(table_number(&t, i, "area_ratio") == 1 && table_number(&t, i, "gap_m") == 0);
            assert_true(table_number(&t, i, "ecr_ohm_m2") == 0 && table_number(&t, i, "tcr_K_m2_per_W") == 0);
        }
    }
    assert_true(rows[0] == 2 && rows[1] >= 1 && rows[2] == 1); /* elastic; with a hardness where the load is below it */
    for (size_t i = 0; i < r.rows; i++) {
        double load = table_number(&r, i, "load_over_AnEp");
        if (load < 1e-2)
            assert_string_equal(table_text(&r, i, "area"), "");
        if (load < 1e-2 || load > 1) {
            assert_string_equal(table_text(&r, i, "gap"), "");
            assert_string_equal(table_text(&r, i, "ecr"), "");
        }
    }
    assert_true(points_drawn(place) >= 3); /* of the middle load */
    report(place, 0, "grid: 64, seeds: 2, loads: [1e-9], surfaces: all");
    assert_int_equal(points_drawn(place), 0);
    expect_in_file(place, "out/report.md", "At no load do 100 points of this grid touch, which a number needs.");
    expect_not_in_file(place, "out/report.md", "The direct solution of", "is the nearest elastic one");
}

/* At loads of the hardness or above there is no solution with the hardness. */
TEST_IN_WORKSPACE(test_loads_at_the_hardness)
{
    const double modulus = 41.4e9 / (1 - 0.36 * 0.36);
    write_surface(place, "d/a.csv", 0.3, 1.3, 0);
    report(place, 0, "grid: 64, seeds: 2, loads: [8e-3, 1e-2, 2e-2], hardness: 475 MPa, surfaces: all");
    struct table t = workspace_table(place, "out/data/direct.csv");
    size_t capped = 0, elastic = 0;
    for (size_t i = 0; i < t.rows; i++) {
        double load = table_number(&t, i, "load_over_AnEp");
        if (*table_text(&t, i, "hardness_Pa") == '\0') {
            elastic++;
            continue;
        }
        assert_true(load * modulus < 475e6);
        assert_true(table_number(&t, i, "area_ratio") >= load * modulus / 475e6 * (1 - 1e-12));
        capped++;
    }
    assert_int_equal(elastic, 3);
    assert_int_equal(capped, 1);
}

/* Extreme exponents, a spike, and the coarsest grid: there are numbers where enough points touch. A flat surface is
 * refused and has no row. */
TEST_IN_WORKSPACE(test_strange_surfaces)
{
    write_surface(place, "d/rough.csv", 0.3, 0.5, 0);
    write_surface(place, "d/smooth.csv", 0.3, 2, 0);
    write_surface(place, "d/spike.csv", 0.3, 1.3, 300);
    write_surface(place, "d/flat.csv", 0, 0, 0);
    report(place, 1, "grid: 16, seeds: 2, loads: [1e-4, 1e-2, 0.3, 100], surfaces: all");
    struct table t = workspace_table(place, "out/data/direct.csv");
    static const char *const names[] = {"rough", "smooth", "spike", "flat"};
    size_t rows[4] = {0};
    for (size_t i = 0; i < t.rows; i++) {
        bool given = *table_text(&t, i, "area_ratio") != '\0';
        for (size_t n = 0; n < 4; n++)
            rows[n] += strcmp(table_text(&t, i, "surface"), names[n]) == 0;
        if (given)
            assert_true(table_number(&t, i, "area_ratio") > 90 / 256.0);
        if (table_number(&t, i, "load_over_AnEp") > 50)
            assert_true(given && table_number(&t, i, "area_ratio") == 1);
    }
    assert_true(rows[0] >= 4 && rows[1] >= 4 && rows[2] >= 4 && rows[3] == 0);
}
