/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The direct solution where there is little or nothing to solve, from the scene to the report: what has no answer
 * leaves no number anywhere, and says why. */
#include "cli/process.h"

#include <jansson.h>
#include <stdio.h>

#define SCENE "material: tin\neffects: [plasticity, separation, electrical, thermal]\n"

/** Height of point i of n [um]. */
typedef double shape(size_t i, size_t n);

/** Amplitudes falling as 1/n^gamma, phases scattered. */
static double law(size_t i, size_t n, double gamma)
{
    double sum = 0;
    for (size_t m = 1; m <= 60; m++)
        sum += 0.3 * pow((double)m, -gamma) *
               cos(2 * 3.14159265358979 * (double)m * (double)i / (double)n + (double)(m * m) * 1.7);
    return sum;
}

static double rough(size_t i, size_t n)
{
    return law(i, n, 1.3);
}

static double rough_law(size_t i, size_t n)
{
    return law(i, n, 0.5);
}

static double smooth_law(size_t i, size_t n)
{
    return law(i, n, 2);
}

static double spike(size_t i, size_t n)
{
    return law(i, n, 1.3) + (i == n / 3 ? 300 : 0);
}

static double flat(size_t i, size_t n)
{
    (void)i;
    (void)n;
    return 0.25;
}

static void write_surface(const char *place, const char *path, shape *height)
{
    enum { POINTS = 400 };
    char text[POINTS * 40];
    size_t used = (size_t)snprintf(text, sizeof text, "x [um],z [um]\n");
    for (size_t i = 0; i < POINTS; i++)
        used += (size_t)snprintf(text + used, sizeof text - used, "%g,%.9g\n", 0.5 * (double)i, height(i, POINTS));
    workspace_write(place, path, text);
}

/** Reports d into out, in which every number is one. */
static void report(const char *place, int status, const char *direct)
{
    char scene[512];
    snprintf(scene, sizeof scene, SCENE "direct: {%s}\n", direct);
    workspace_write(place, "d/scene.yaml", scene);
    struct process run = expect_exit(place, status, "report", "d", "-o", "out", "--no-cost");
    process_expect_numbers(run.out, "stdout");
    process_expect_numbers(run.err, "stderr");
    process_free(&run);
    assert_true(workspace_expect_numbers(place, "out") > 20);
}

static const char *const numbers[] = {"area_ratio", "area_stderr", "gap_m",          "gap_stderr",
                                      "ecr_ohm_m2", "ecr_stderr",  "tcr_K_m2_per_W", "patches"};
enum { NUMBERS = sizeof numbers / sizeof *numbers };

/** Loads in its chart at which the direct solution has a number: the ends of its error. */
static size_t points_drawn(const char *place)
{
    size_t count = 0;
    if (workspace_has(place, "out/figures/direct.csv")) {
        char *chart = workspace_read(place, "out/figures/direct.csv");
        for (const char *line = chart; *line; line += strcspn(line, "\n"), line += *line != '\0') {
            size_t commas = 0;
            for (const char *at = line; *at && *at != '\n'; at++)
                commas += *at == ',';
            count += *line != '#' && commas == 2;
        }
        free(chart);
    }
    return count;
}

/** No quantity in results.json's direct solutions, nor a model over one. */
static void expect_nulls(const char *place)
{
    json_t *all = workspace_json(place, "out/results.json"),
           *direct = json_array_get(json_object_get(all, "direct"), 0), *curve, *model, *value, *one;
    const char *name, *quantity;
    size_t k, i, seen = 0;
    json_array_foreach(json_object_get(direct, "solutions"), k, curve)
    {
        json_object_foreach(curve, quantity, value)
        {
            bool known = strcmp(quantity, "load_over_AnEp") == 0;
            for (i = 0; i < json_array_size(value); i++, seen++)
                assert_true(known || json_is_null(json_array_get(value, i)));
        }
    }
    json_object_foreach(json_object_get(direct, "model_over_direct"), name, model)
    {
        json_object_foreach(model, quantity, value)
        {
            json_array_foreach(value, i, one)
            {
                assert_true(json_is_null(one));
                seen++;
            }
        }
    }
    assert_true(seen > 60);
    json_decref(all);
}

/* Fewer than 100 points in contact: no number in tables, ratios, charts, JSON or text. */
TEST_IN_WORKSPACE(test_below_resolution)
{
    write_surface(place, "d/a.csv", rough);
    report(place, 0, "grid: 64, seeds: 2, loads: [1e-9, 1e-8], surfaces: all");
    struct table t = workspace_table(place, "out/data/direct.csv"),
                 r = workspace_table(place, "out/data/direct_ratio.csv");
    assert_int_equal(t.rows, 4); /* two loads, elastic and with a hardness */
    for (size_t i = 0; i < t.rows; i++)
        for (size_t k = 0; k < NUMBERS; k++)
            assert_string_equal(table_text(&t, i, numbers[k]), "");
    assert_true(r.rows > 4);
    for (size_t i = 0; i < r.rows; i++) {
        assert_string_equal(table_text(&r, i, "area"), "");
        assert_string_equal(table_text(&r, i, "gap"), "");
        assert_string_equal(table_text(&r, i, "ecr"), "");
    }
    table_free(&t);
    table_free(&r);
    assert_int_equal(points_drawn(place), 0);
    expect_nulls(place);
    expect_in_file(place, "out/report.md", "Nowhere do the 100 points of this grid touch that a number takes.");
    expect_not_in_file(place, "out/report.md", "The direct solution of", "is the nearest elastic one");
}

/* Where some loads are resolved, those have numbers. */
TEST_IN_WORKSPACE(test_partly_below_resolution)
{
    write_surface(place, "d/a.csv", rough);
    report(place, 0, "grid: 64, seeds: 2, loads: [1e-9, 3e-2], surfaces: all");
    struct table t = workspace_table(place, "out/data/direct.csv");
    size_t with = 0, without = 0;
    for (size_t i = 0; i < t.rows; i++) {
        bool resolved = table_number(&t, i, "load_over_AnEp") > 1e-2;
        for (size_t k = 0; k < NUMBERS; k++)
            if (!strstr(numbers[k], "stderr"))
                assert_true((*table_text(&t, i, numbers[k]) != '\0') == resolved);
        with += resolved;
        without += !resolved;
    }
    assert_true(with >= 1 && without >= 2);
    table_free(&t);
    assert_true(points_drawn(place) >= 3); /* the check above sees them */
}

/* From the load on that is the hardness there is no capped solution; with all loads beyond, none at all. */
TEST_IN_WORKSPACE(test_loads_at_the_hardness)
{
    const double modulus = 41.4e9 / (1 - 0.36 * 0.36);
    write_surface(place, "d/a.csv", rough);
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
    table_free(&t);
    report(place, 0, "grid: 64, seeds: 2, loads: [8e-3, 2e-2], hardness: 1 MPa, surfaces: all");
    t = workspace_table(place, "out/data/direct.csv");
    for (size_t i = 0; i < t.rows; i++)
        assert_string_equal(table_text(&t, i, "hardness_Pa"), "");
    table_free(&t);
    expect_not_in_file(place, "out/report.md", "direct, with the hardness");
}

/* Complete contact: all of the area, no gap, no resistance, and no ratio to nothing. */
TEST_IN_WORKSPACE(test_complete_contact)
{
    write_surface(place, "d/a.csv", rough);
    report(place, 0, "grid: 64, seeds: 2, loads: [10], surfaces: all");
    struct table t = workspace_table(place, "out/data/direct.csv"),
                 r = workspace_table(place, "out/data/direct_ratio.csv");
    assert_int_equal(t.rows, 1);
    for (size_t i = 0; i < t.rows; i++) {
        assert_true(table_number(&t, i, "area_ratio") == 1 && table_number(&t, i, "gap_m") == 0);
        assert_true(table_number(&t, i, "ecr_ohm_m2") == 0 && table_number(&t, i, "tcr_K_m2_per_W") == 0);
    }
    for (size_t i = 0; i < r.rows; i++) {
        assert_string_equal(table_text(&r, i, "gap"), "");
        assert_string_equal(table_text(&r, i, "ecr"), "");
    }
    table_free(&t);
    table_free(&r);
}

/* Exponents at both ends, a spike, and the coarsest grid: numbers where enough points touch, and only numbers. A flat
 * surface is refused and leaves no row. */
TEST_IN_WORKSPACE(test_strange_surfaces)
{
    write_surface(place, "d/rough.csv", rough_law);
    write_surface(place, "d/smooth.csv", smooth_law);
    write_surface(place, "d/spike.csv", spike);
    write_surface(place, "d/flat.csv", flat);
    for (size_t grid = 16; grid <= 64; grid *= 4) {
        char direct[128];
        snprintf(direct, sizeof direct, "grid: %zu, seeds: 2, loads: [1e-4, 1e-2, 0.3, 100], surfaces: all", grid);
        report(place, 1, direct);
        struct table t = workspace_table(place, "out/data/direct.csv");
        size_t rows[3] = {0};
        for (size_t i = 0; i < t.rows; i++) {
            const char *name = table_text(&t, i, "surface");
            bool given = *table_text(&t, i, "area_ratio") != '\0';
            rows[0] += strcmp(name, "rough") == 0;
            rows[1] += strcmp(name, "smooth") == 0;
            rows[2] += strcmp(name, "spike") == 0;
            assert_string_not_equal(name, "flat");
            if (given)
                assert_true(table_number(&t, i, "area_ratio") > (grid == 16 ? 90 / 256.0 : 80 / 4096.0));
            if (table_number(&t, i, "load_over_AnEp") > 50)
                assert_true(given && table_number(&t, i, "area_ratio") == 1);
        }
        assert_true(rows[0] >= 4 && rows[1] >= 4 && rows[2] >= 4);
        table_free(&t);
    }
}

/* A map below its resolution, as a profile: no number. */
TEST_IN_WORKSPACE(test_map_below_resolution)
{
    enum { N = 32 };
    char text[N * N * 20];
    size_t used = (size_t)snprintf(text, sizeof text, "DSAA\n%d %d\n0 31e-6\n0 31e-6\n-1e-6 1e-6\n", N, N);
    for (int k = 0; k < N * N; k++)
        used += (size_t)snprintf(text + used, sizeof text - used, "%.9e\n",
                                 4e-7 * sin(0.7 * (k % N) + 0.002 * k) * cos(0.9 * (k / N)) + 1e-7 * sin(0.1 * k * k));
    workspace_write(place, "d/m.grd", text);
    workspace_write(place, "d/scene.yaml",
                    SCENE "surfaces: [{name: m, file: m.grd, x_unit: m, z_unit: m}]\ndirect: {loads: [1e-9, 0.05]}\n");
    run_to_exit(place, 0, "report", "d", "-o", "out", "--no-cost");
    assert_true(workspace_expect_numbers(place, "out") > 20);
    struct table t = workspace_table(place, "out/data/direct.csv");
    size_t with = 0;
    for (size_t i = 0; i < t.rows; i++) {
        bool resolved = table_number(&t, i, "load_over_AnEp") > 1e-2;
        assert_string_equal(table_text(&t, i, "source"), "map");
        for (size_t k = 0; k < NUMBERS; k++)
            if (!strstr(numbers[k], "stderr"))
                assert_true((*table_text(&t, i, numbers[k]) != '\0') == resolved);
        with += resolved;
    }
    assert_true(with >= 1 && with < t.rows);
    table_free(&t);
}
