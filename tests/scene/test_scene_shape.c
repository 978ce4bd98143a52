/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The key `shape`: what its files and bolts become, and what is refused of them. */
#include "scene_directory.h"

#define COPPER "material: copper\nnominal_area: 400 mm2\nsurfaces: [{name: a, file: a.csv}]\n"
#define BOLTS  "force: 1.25 kN, head: 8.5 mm, thickness: [5 mm, 8 mm]}\n"

/** The scene of a directory with a scan and the file f.csv. */
static enum status_code read_with(struct scene *scene, const char *text, const char *file, struct status *status)
{
    struct directory directory = directory_make();
    scene_directory_add(&directory, "a.csv");
    directory_write(&directory, "f.csv", file);
    directory_write(&directory, "g.csv", "A [mm2], p [MPa]\n400, 1\n");
    directory_write(&directory, "scene.yaml", text);
    enum status_code code = scene_read(scene, directory.path, NULL, status);
    directory_remove(&directory);
    return code;
}

static const struct scene *good(const char *text, const char *file)
{
    struct scene *scene = test_owns(calloc(1, sizeof *scene), scene_directory_end);
    expect_ok(read_with, scene, text, file);
    return scene;
}

/** Rows in any order, with nodes at the edges or in the middles of cells, of which the operating load comes. */
TEST_CASE(test_grid_of_pressures)
{
    static const char *const files[] = {
        "x [mm], y [mm], p [MPa]\n20, 0, 3\n0, 0, 1\n0, 20, 1\n20, 20, 3\n",
        "x [mm];y [mm];p [bar]\n105;-5;10\n115;-5;30\n105;5;10\n115;5;30\n",
    };
    for (int k = 0; k < 2; k++) {
        const struct scene *scene = good(COPPER "shape: {pressure: f.csv}\n", files[k]);
        const struct shape_field *field = scene->joint.fields;
        assert_int_equal(scene->joint.field_count, 1);
        assert_true(scene->joint.pressed);
        assert_near(field->mean, 2e6, 1e-12);
        assert_near(scene->operating.value, 2e6, 1e-12);
        assert_int_equal(scene->operating.kind, UNIT_PRESSURE);
        assert_near(field->value[0] + field->value[63], 4e6, 1e-12);
        assert_true(field->value[0] < field->value[63]);
        assert_near(field->value[0], field->value[64 * 63], 1e-12);
    }
}

/** Areas with their pressures, by falling pressure; what is left of the nominal area has none. */
TEST_CASE(test_areas_and_pressures)
{
    const struct scene *scene =
        good(COPPER "operating_load: 400 N\nload: {from: 1 N, to: 1 kN}\nshape: {pressure: f.csv}\n",
             "A [mm2], p [MPa]\n100, 1\n50, 4\n200, 0.5\n");
    const struct shape_field *field = scene->joint.fields;
    assert_int_equal(field->nx, 3);
    assert_near(field->mean, 400 / 400e-6, 1e-12);
    static const double pressures_Pa[] = {4e6, 1e6, 0.5e6}, shares[] = {0.125, 0.25, 0.5};
    for (int k = 0; k < 3; k++) {
        assert_near(field->value[k], pressures_Pa[k], 1e-12);
        assert_near(field->share[k], shares[k], 1e-12);
    }
}

/** The load is held where the material is a surface's own, too. */
TEST_CASE(test_material_of_the_surface)
{
    static const char own[] = "nominal_area: 400 mm2\nsurfaces: [{name: a, file: a.csv, material: copper}]\n"
                              "shape: {pressure: g.csv}\n";
    const struct scene *scene = good(own, "");
    assert_near(scene->operating.value, 1e6, 1e-12);
}

/** A map of the part's height becomes a gap: where it is highest there is none. */
TEST_CASE(test_map_of_height)
{
    const struct scene *scene =
        good(COPPER "shape: {height: f.csv}\n",
             "x [mm],y [mm],z [um]\n0,0,1\n10,0,3\n20,0,1\n0,10,3\n10,10,5\n20,10,3\n0,20,1\n10,20,3\n20,20,1\n");
    const struct shape_field *field = scene->joint.fields;
    assert_false(scene->joint.pressed);
    assert_near(field->value[32 * 64 + 32], 4e-6 / 64, 1e-9);
    assert_near(field->value[0], 4e-6 * 63 / 64, 1e-9);
    assert_near(field->mean, 2e-6, 1e-9);
}

/** A file of 300 x 300 cells that presses along one edge alone has the force that its cells add up to, as the
 * operating load beside it says, where places are rounded. */
TEST_CASE(test_edge_line_keeps_its_force)
{
    for (int k = 0; k < 3; k++) {
        struct text *file = support_text();
        double step_mm = k == 0   ? 20. / 300
                         : k == 1 ? 20. / 299
                                  : 0.066; /* cells; nodes; cells that are a little shorter */
        text_add(file, "x [mm], y [mm], p [MPa]\n");
        for (int i = 0; i < 300 * 300; i++)
            text_add(file, "%.*f, %.*f, %d\n", k == 2 ? 4 : 2, (i % 300 + (k == 1 ? 0 : 0.5)) * step_mm, k == 2 ? 4 : 2,
                     (i / 300 + (k == 1 ? 0 : 0.5)) * step_mm, i % 300 == 299 ? 30 : 0);
        double force_N = 30 * (k == 1 ? 20 * step_mm / 2 : 300 * step_mm * step_mm);
        const struct scene *scene = good(
            filled(COPPER "operating_load: %.12g N\nload: {from: 1 N, to: 1 kN}\nshape: {pressure: f.csv}\n", force_N),
            text_string(file));
        assert_near(scene->joint.fields->mean * 400e-6, force_N, 1e-9);
    }
}

/** Bolts as near to an edge, and to each other, as their holes go. */
TEST_CASE(test_bolts_that_just_fit)
{
    const struct scene *scene =
        good(COPPER "shape: {bolts: [[2.8 mm, 2.8 mm], [8.4 mm, 2.8 mm], [17.2 mm, 17.2 mm]], " BOLTS, "");
    assert_int_equal(scene->shape.bolts.count, 3);
}

TEST_CASE(test_bolts)
{
    const struct scene *scene = good(COPPER "shape: {bolts: [[10 mm, 10 mm], [5 mm, 6 mm]], " BOLTS, "");
    assert_near(scene->shape.bolts.force_N, 1250, 1e-12);
    assert_near(scene->shape.bolts.reach_m, 4.25e-3 + 5e-3, 1e-12);
    assert_near(scene->shape.bolts.hole_m, 0.65 * 4.25e-3, 1e-12);
    assert_near(scene->operating.value * 400e-6, 2 * 1250, 1e-9);
    assert_near(scene->joint.thickness_m[1], 8e-3, 1e-12);
}

TEST_CASE(test_refused)
{
    static const struct {
        const char *shape, *file, *says;
    } rows[] = {
        {"shape: {pressure: f.csv}\n", "x [mm], y [mm], p [MPa]\n0, 0, 1\n20, 0, -1\n0, 20, 1\n20, 20, 1\n",
         "scene.yaml:4: 'f.csv', line 3: negative; correct the pressure or area"},
        {"shape: {pressure: f.csv}\n", "x [mm], y [mm], p [MPa]\n0, 0, 1\n20, 0, 1\n0, 20, 1\n20, 21, 1\n",
         "'f.csv' has 4 places, no grid of x and y; give each x with each y"},
        {"shape: {pressure: f.csv}\n", "x [mm], y [mm], p [MPa]\n0, 0, 1\n30, 0, 1\n0, 20, 1\n30, 20, 1\n",
         "'f.csv' is 0.03 m long in x, the nominal area 0.02 m; correct 'size' or the file"},
        {"shape: {pressure: f.csv}\n", "x, y, p\n0, 0, 1\n30, 0, 1\n",
         "'f.csv' is not headed x [mm], y [mm], p [MPa], or A [mm2], p [MPa]; head it so"},
        {"shape: {pressure: f.csv}\n", "x [mm], y [mm], p [K]\n0, 0, 1\n",
         "f.csv:1: 'K' is no unit of pressure; understood: Pa, "},
        {"shape: {pressure: f.csv}\n", "p, x, y\n\"MPa\",\"mm\",\"mm\"\n", "f.csv"}, /* no order is guessed */
        {"shape: {pressure: f.csv}\n", "", "f.csv: no row of x, y and pressure"},
        {"shape: {pressure: f.csv}\n", "A [mm2], p [MPa]\n300, 1\n120, 1\n",
         "the areas of 'f.csv' are 0.00042 m2 together, the nominal one 0.0004 m2"},
        {"shape: {pressure: f.csv}\n", "A [mm2], p [MPa]\n300, 0\n", "'f.csv' presses nowhere"},
        {"shape: {pressure: [f.csv, g.csv]}\n", "A [mm2], p [MPa]\n300, 1\n",
         "the files of 'pressure' must be grids of the same places, each at another load"},
        {"operating_load: 410 N\nload: {from: 1 N, to: 1 kN}\nshape: {pressure: g.csv}\n", "",
         "'shape' carries 400 N, -2.44 % from 'operating_load'; correct either, or add scale: true"},
        {"shape: {height: a.csv}\n", "", "a.csv:1: points: 1; a scan needs at least 3"},
        {"shape: {height: f.csv}\n",
         "x [mm],z [um]\n0,1\n1,3\n2,1\n3,1\n4,1\n5,1\n6,1\n7,1\n8,1\n9,1\n10,2\n11,2\n12,2\n",
         "'f.csv' is a profile; give a map of the part's height"},
        {"shape: {height: [f.csv, g.csv]}\n", "", "'height' is one map, not 2"},
        {"shape: {height: f.csv, scale: true}\n", "",
         "scene.yaml:4: 'scale' needs 'pressure' or 'bolts'; add one, or leave 'scale' out"},
        {"shape: {crown: 2 m, force: 1 N}\n", "", "scene.yaml:4: 'force' needs 'bolts'; add it, or leave 'force' out"},
        {"shape: {bolts: [[10 mm, 10 mm]], force: 1 kN, thickness: [5 mm, 8 mm]}\n", "",
         "scene.yaml:4: 'bolts' needs 'head'; add it, or leave 'bolts' out"},
        {"shape: {bolts: [[10 mm, 10 mm]], force: 1 kN, head: 8.5 mm}\n", "",
         "scene.yaml:4: 'bolts' needs 'thickness'; add it, or leave 'bolts' out"},
        {"shape: {bolts: [[10 mm, 10 mm]], torque: 1 N m, head: 8.5 mm, thickness: [5 mm, 8 mm]}\n", "",
         "unknown key 'torque'"},
        {"shape: {bolts: [[10 mm, 21 mm]], " BOLTS, "",
         "scene.yaml:4: bolt 1 is at 0.021 m in y, where its hole of 0.00553 m leaves the area, 0 to 0.02 m; "
         "coordinates "
         "count from a corner"},
        {"shape: {bolts: [[10 mm, 10 mm], [-10 mm, 5 mm]], " BOLTS, "",
         "scene.yaml:4: bolt 2 is at -0.01 m in x, where its hole of 0.00553 m leaves the area, 0 to 0.02 m; "
         "coordinates count from a corner"},
        {"shape: {bolts: [[10 mm, 2.7 mm]], " BOLTS, "",
         "bolt 1 is at 0.0027 m in y, where its hole of 0.00553 m leaves"},
        {"shape: {bolts: [[17.3 mm, 10 mm]], " BOLTS, "",
         "bolt 1 is at 0.0173 m in x, where its hole of 0.00553 m leaves"},
        {"shape: {bolts: [[10 mm, 10 mm], [5 mm, 4 mm], [10 mm, 10 mm]], " BOLTS, "",
         "scene.yaml:4: the holes of bolts 1 and 3 overlap; correct either, coordinates count from a corner"},
        {"shape: {bolts: [[10 mm, 10 mm], [15.4 mm, 10 mm]], " BOLTS, "", "the holes of bolts 1 and 2 overlap"},
        {"shape: {bolts: [], " BOLTS, "", "'bolts' lists 0 places; give 1 to 1000, as [[10 mm, 10 mm]]"},
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        struct scene scene;
        struct status status = {0};
        enum status_code code = read_with(&scene, filled(COPPER "%s", rows[k].shape), rows[k].file, &status);
        if (code != STATUS_SCENE || !strstr(status.message, rows[k].says))
            fail_msg("row %zu: %d, %s", k, (int)code, status.message);
        scene_free(&scene);
    }
    assert_near(good(COPPER "operating_load: 410 N\nload: {from: 1 N, to: 1 kN}\n"
                            "shape: {pressure: g.csv, scale: true}\n",
                     "")
                    ->operating.value,
                410, 0);
}
