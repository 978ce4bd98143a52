/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surfaces of several scans, maps, and two rough surfaces, through the whole program. */
#include "run/pipeline.h"

/* A Surfer text grid of `nx` by `ny` heights [m], 0.5 um apart. */
static void write_map(const struct directory *place, const char *name, const double *z_m, size_t nx, size_t ny)
{
    struct text *grid = support_text();
    text_add(grid, "DSAA\n%zu %zu\n0 %.9g\n0 %.9g\n-1 1\n", nx, ny, 5e-7 * (double)(nx - 1), 5e-7 * (double)(ny - 1));
    for (size_t row = 0; row < ny; row++) {
        for (size_t i = 0; i < nx; i++)
            text_add(grid, "%.17g ", z_m[row * nx + i]);
        text_add(grid, "\n");
    }
    directory_write(place, name, text_string(grid));
}

/** Columns of a turned map are the rows of the map. They have no interval, as they are not independent. */
TEST_IN_DIRECTORY(a_map_is_its_rows)
{
    enum { NX = 64, NY = 12 };
    double map[NX * NY], turned[NX * NY];
    for (size_t row = 0; row < NY; row++)
        for (size_t i = 0; i < NX; i++) {
            map[row * NX + i] =
                1e-7 * sin(0.7 * (double)i + (double)row) + 4e-8 * sin(2.1 * (double)i * (double)(row + 1));
            turned[i * NY + row] = map[row * NX + i];
        }
    write_map(place, "in/map.grd", map, NX, NY);
    write_map(place, "in/turned.grd", turned, NY, NX);
    static const char scene[] = "material: tin\neffects: [separation, electrical]\ndirection: %s\n"
                                "load: {from: 1e-6, to: 1e-2, points: 9}\n"
                                "surfaces: [{name: m, file: %s.grd, x_unit: m, z_unit: m}]\n";
    pipeline_report(place, "in", "rows", filled(scene, "x", "map"));
    pipeline_report(place, "in", "columns", filled(scene, "y", "turned"));
    directory_expect_same(place, "rows/data/contact.csv", "columns/data/contact.csv");
    directory_expect_same(place, "rows/data/spectrum.csv", "columns/data/spectrum.csv");
    assert_false(directory_has(place, "rows/data/spread.csv") || directory_has(place, "rows/data/bands.csv"));
    expect_in_file(place, "rows/report.md", "its 12 rows were averaged as profiles for spectrum and fit",
                   "| 12 profiles",
                   "m: no direct solution of the map: it takes one map alone of square points, 32 a side at least");
    pipeline_report(place, "in", "arcs",
                    "models: [gw]\nlevel: circle\nsurfaces: [{name: m, file: map.grd, x_unit: m, "
                    "z_unit: m}]\n"); /* each row has its own */
    expect_in_file(place, "arcs/report.md", "m: map.grd, profile 1: an arc of radius");
}

/** Pressed against its own copy: amplitudes times sqrt 2, and half the modulus; the counterface is no surface itself.
 */
TEST_IN_DIRECTORY(two_rough_bodies_add_their_squares)
{
    pipeline_rough(place, "in/a.csv", 200, 1, 1);
    pipeline_report(place, "in", "smooth", "material: tin\neffects: [electrical]\n");
    pipeline_rough(place, "in/other.csv", 200, 1, 1);
    pipeline_report(place, "in", "rough", "material: tin\neffects: [electrical]\ncounterface: {surface: other.csv}\n");
    struct table smooth = directory_table(place, "smooth/data/spectrum.csv");
    struct table rough = directory_table(place, "rough/data/spectrum.csv");
    assert_int_equal(smooth.rows, rough.rows); /* one surface each */
    for (size_t i = 0; i + 2 < smooth.rows; i++)
        assert_near(table_number(&rough, i, "amplitude_m"), M_SQRT2 * table_number(&smooth, i, "amplitude_m"), 1e-9);
    struct table contact = directory_table(place, "rough/data/contact.csv"); /* both heights are known, in pairs */
    size_t strips = 0;
    for (size_t i = 0; i < contact.rows; i++)
        strips += strcmp(table_text(&contact, i, "model"), "strip") == 0;
    assert_true(strips > 50);
    expect_in_file(place, "rough/report.md", "rough counterface");
    struct status status = {0};
    directory_write(place, "in/other.csv", "no numbers\n");
    pipeline_into(place, "in", "none", (struct run_options){0}, &status);
    assert_int_equal(status.code, STATUS_SCENE);
    expect_parts(status.message, "the counterface cannot be read: other.csv");
    assert_false(directory_has(place, "none"));
}

/** A body that is rigid is no flat where the counterface is rough; all scans of that are named. */
TEST_IN_DIRECTORY(a_rough_counterface_may_be_rigid)
{
    for (int i = 0; i < 3; i++)
        pipeline_rough(place, filled("in/%d.csv", i), 200, i + 1, 1);
    pipeline_report(place, "in", "out",
                    "material: tin\nmodels: [gw]\ncounterface: {surface: [1.csv, 2.csv]}\n"
                    "surfaces: [{name: a, file: 0.csv, counterface: rigid}]\n");
    expect_in_file(place, "out/report.md", "pressed against a rough counterface", "tin against a rigid body.");
    expect_in_file(place, "out/results.json", "\"1.csv\",", "\"2.csv\"");
}
