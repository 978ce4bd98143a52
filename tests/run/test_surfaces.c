/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surfaces of several scans, maps, and two rough surfaces, through the whole program. */
#include "run/pipeline.h"

/* A Surfer text grid of `nx` by `ny` heights [m], 0.5 um apart. */
static void write_map(const struct directory *place, const char *name, const double *z_m, size_t nx, size_t ny)
{
    struct text grid = {0};
    text_add(&grid, "DSAA\n%zu %zu\n0 %.9g\n0 %.9g\n-1 1\n", nx, ny, 5e-7 * (double)(nx - 1), 5e-7 * (double)(ny - 1));
    for (size_t row = 0; row < ny; row++) {
        for (size_t i = 0; i < nx; i++)
            text_add(&grid, "%.17g ", z_m[row * nx + i]);
        text_add(&grid, "\n");
    }
    directory_write(place, name, text_string(&grid));
    text_free(&grid);
}

static const char units[] = "x_unit: m, z_unit: m";

static void scene(const struct directory *place, const char *in, const char *more, const char *surfaces)
{
    char path[256];
    struct text text = {0};
    text_add(
        &text,
        "material: tin\neffects: [separation, electrical]\nload: {from: 1e-6, to: 1e-2, points: 9}\n%ssurfaces: [%s]\n",
        more, surfaces);
    snprintf(path, sizeof path, "%s/scene.yaml", in);
    directory_write(place, path, text_string(&text));
    text_free(&text);
}

static void expect_same_file(const struct directory *place, const char *a, const char *b)
{
    struct text first = directory_read(place, a), second = directory_read(place, b);
    assert_string_equal(text_string(&first), text_string(&second));
    text_free(&first);
    text_free(&second);
}

/** Columns of a turned map are the rows of the map; rows that are all alike give the profile's own curves, without a
 * spread to speak of. */
TEST_WITH(a_map_is_its_rows, directory_setup, directory_teardown)
{
    enum { NX = 64, NY = 12 };
    const struct directory *place = *state;
    double map[NX * NY], turned[NX * NY];
    for (size_t row = 0; row < NY; row++)
        for (size_t i = 0; i < NX; i++) {
            map[row * NX + i] =
                1e-7 * sin(0.7 * (double)i + (double)row) + 4e-8 * sin(2.1 * (double)i * (double)(row + 1));
            turned[i * NY + row] = map[row * NX + i];
        }
    mkdir(directory_path(place, "in"), 0777);
    write_map(place, "in/map.grd", map, NX, NY);
    write_map(place, "in/turned.grd", turned, NY, NX);
    char surfaces[200];
    snprintf(surfaces, sizeof surfaces, "{name: m, file: map.grd, %s}", units);
    scene(place, "in", "direction: x\n", surfaces);
    assert_int_equal(pipeline_run(place, "in", "rows", 1), 0);
    snprintf(surfaces, sizeof surfaces, "{name: m, file: turned.grd, %s}", units);
    scene(place, "in", "direction: y\n", surfaces);
    assert_int_equal(pipeline_run(place, "in", "columns", 1), 0);
    expect_same_file(place, "rows/data/contact.csv", "columns/data/contact.csv");
    expect_same_file(place, "rows/data/spectrum.csv", "columns/data/spectrum.csv");
    assert_true(directory_has(place, "rows/data/spread.csv") && directory_has(place, "rows/data/bands.csv"));
    struct text report = directory_read(place, "rows/report.md");
    expect_parts(text_string(&report), "its 12 rows were averaged as profiles for spectrum and fit", "| 12 rows");
    text_free(&report);
}

/** One file twice is that file; a surface of one scan has no spread. */
TEST_WITH(averaging_a_scan_with_itself_changes_nothing, directory_setup, directory_teardown)
{
    const struct directory *place = *state;
    mkdir(directory_path(place, "in"), 0777);
    pipeline_rough(place, "in/a.csv", 200, 1, 1);
    scene(place, "in", "", "{name: s, file: a.csv}");
    assert_int_equal(pipeline_run(place, "in", "once", 1), 0);
    scene(place, "in", "", "{name: s, file: [a.csv, a.csv]}");
    assert_int_equal(pipeline_run(place, "in", "twice", 1), 0);
    struct table once = table_read_path(directory_path(place, "once/data/contact.csv"));
    struct table twice = table_read_path(directory_path(place, "twice/data/contact.csv"));
    assert_int_equal(once.rows, twice.rows);
    for (size_t i = 0; i < once.rows; i++) {
        double area = table_number(&once, i, "area_ratio");
        if (!model_rows[model_named(table_text(&once, i, "model"))]->uses_heights)
            assert_near(table_number(&twice, i, "area_ratio"), area, 1e-12);
        else if (area > 30 / 198.) /* below, fewer than 30 of its points touch */
            assert_near(table_number(&twice, i, "area_ratio"), area, 0.01);
    }
    table_free(&once);
    table_free(&twice);
    assert_false(directory_has(place, "once/data/spread.csv"));
    assert_false(directory_has(place, "twice/data/spread.csv")); /* the same twice counts as one */
}

/** Pressed against its own copy: amplitudes times sqrt 2, and half the modulus; the counterface is no surface itself.
 */
TEST_WITH(two_rough_bodies_add_their_squares, directory_setup, directory_teardown)
{
    const struct directory *place = *state;
    mkdir(directory_path(place, "in"), 0777);
    pipeline_rough(place, "in/a.csv", 200, 1, 1);
    directory_write(place, "in/scene.yaml", "material: tin\neffects: [electrical]\n");
    assert_int_equal(pipeline_run(place, "in", "smooth", 1), 0);
    pipeline_rough(place, "in/other.csv", 200, 1, 1);
    directory_write(place, "in/scene.yaml",
                    "material: tin\neffects: [electrical]\ncounterface: {surface: other.csv}\n");
    assert_int_equal(pipeline_run(place, "in", "rough", 1), 0);
    struct table smooth = table_read_path(directory_path(place, "smooth/data/spectrum.csv"));
    struct table rough = table_read_path(directory_path(place, "rough/data/spectrum.csv"));
    assert_int_equal(smooth.rows, rough.rows); /* one surface each */
    for (size_t i = 0; i + 2 < smooth.rows; i++)
        assert_near(table_number(&rough, i, "amplitude_m"), M_SQRT2 * table_number(&smooth, i, "amplitude_m"), 1e-9);
    table_free(&smooth);
    table_free(&rough);
    expect_in_file(place, "rough/report.md", "rough counterface");
    struct run_outcome outcome;
    struct status status = {0};
    char target[4096];
    snprintf(target, sizeof target, "%s", directory_path(place, "none"));
    directory_write(place, "in/other.csv", "no numbers\n");
    struct run_options options = {
        .output = target, .templates = PROJECT_SOURCE "/templates", .no_cost = true, .jobs = 1};
    assert_int_equal(pipeline_try(&outcome, place, "in", options, &status), STATUS_SCENE);
    assert_non_null(strstr(status.message, "the counterface cannot be read: other.csv"));
    run_outcome_free(&outcome);
    assert_false(directory_has(place, "none"));
}
