/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The direct solution where there is little or nothing to solve, from the scene to the report: what has no answer
 * leaves no number anywhere, and says why. */
#include "cli/process.h"

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
    workspace_write(place, "d/scene.yaml", filled(SCENE "direct: {%s}\n", direct));
    struct process run = expect_exit(place, status, "report", "d", "-o", "out", "--no-cost");
    process_expect_numbers(run.out, "stdout");
    process_expect_numbers(run.err, "stderr");
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
    }
    return count;
}

/* Fewer than 100 points in contact: no number in tables, ratios, charts. Complete contact: all of the area, no gap, no
 * resistance, and no ratio to nothing. Between them numbers. */
TEST_IN_WORKSPACE(test_from_none_to_complete)
{
    write_surface(place, "d/a.csv", rough);
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
    assert_true(rows[0] == 2 && rows[1] >= 1 &&
                rows[2] == 1); /* elastic and with a hardness; none of that below the load */
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

/* From the load on that is the hardness there is no capped solution. */
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
}

/* Exponents at both ends, a spike, and the coarsest grid: numbers where enough points touch, and only numbers. A flat
 * surface is refused and leaves no row. */
TEST_IN_WORKSPACE(test_strange_surfaces)
{
    write_surface(place, "d/rough.csv", rough_law);
    write_surface(place, "d/smooth.csv", smooth_law);
    write_surface(place, "d/spike.csv", spike);
    write_surface(place, "d/flat.csv", flat);
    report(place, 1, "grid: 16, seeds: 2, loads: [1e-4, 1e-2, 0.3, 100], surfaces: all");
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
            assert_true(table_number(&t, i, "area_ratio") > 90 / 256.0);
        if (table_number(&t, i, "load_over_AnEp") > 50)
            assert_true(given && table_number(&t, i, "area_ratio") == 1);
    }
    assert_true(rows[0] >= 4 && rows[1] >= 4 && rows[2] >= 4);
}
