/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bodies and loads of each surface, and no material at all, through the whole program. */
#include "results/results.h"
#include "run/pipeline.h"

static void write_scans(const struct directory *place)
{
    pipeline_rough(place, "in/a.csv", 400, 1, 11);
    pipeline_rough(place, "in/b.csv", 400, 1, 12);
    pipeline_rough(place, "in/c.csv", 400, 1, 13);
}

#define LOADS "nominal_area: 1 mm2\nload: {from: 0.1 N, to: 100 N, points: 7}\noperating_load: 12 N\n"

/* Three surfaces with different bodies in one report have the same digits as each in a report of its own. */
TEST_IN_DIRECTORY(each_surface_has_its_own_bodies)
{
    static const char *const own[] = {"material: tin\n", "material: copper\ncounterface: same\n",
                                      "material: gold\ncounterface: tin\nhardness: 90 MPa\n"};
    static const char *const names[] = {"a", "b", "c"};
    write_scans(place);
    directory_write(place, "in/scene.yaml",
                    LOADS "material: tin\nsurfaces:\n  - {name: a, file: a.csv}\n"
                          "  - {name: b, file: b.csv, material: copper, counterface: same}\n"
                          "  - {name: c, file: c.csv, material: gold, counterface: tin, hardness: 90 MPa}\n");
    assert_int_equal(pipeline_run(place, "in", "all", 2), 0);
    expect_in_file(
        place, "all/report.md",
        "\nBodies: tin against a rigid body on *a*;\ncopper against copper on *b*;\ngold against tin on *c*.\n",
        "\n| gold (*c*) |", "\n| tin |", " | 90.0 |\n", " gold: ", " copper: ");
    struct table all = directory_table(place, "all/data/contact.csv");
    size_t compared = 0;
    for (int s = 0; s < 3; s++) {
        pipeline_report(place, "in", "alone",
                        filled(LOADS "%ssurfaces: [{name: %s, file: %s.csv}]\n", own[s], names[s], names[s]));
        struct table alone = directory_table(place, "alone/data/contact.csv");
        size_t row = 0;
        for (size_t r = 0; r < alone.rows; r++, row++, compared++) {
            while (strcmp(table_text(&all, row, "surface"), names[s]) != 0)
                row++;
            for (size_t c = 0; c < alone.columns; c++)
                assert_string_equal(table_text(&all, row, alone.cell[c]), table_text(&alone, r, alone.cell[c]));
        }
    }
    assert_int_equal(compared, all.rows);
}

/* What a surface does not give is taken from the scene. */
TEST_IN_DIRECTORY(bodies_are_completed)
{
    const struct material *tin = material_find("tin"), *copper = material_find("copper");
    struct scene scene;
    write_scans(place);
    directory_write(place, "in/scene.yaml",
                    "material: tin\ncounterface: same\nhardness: 50 MPa\nsurfaces:\n  - {name: a, file: a.csv}\n"
                    "  - {name: b, file: b.csv, material: copper}\n"
                    "  - {name: c, file: c.csv, counterface: rigid, hardness: 90 MPa}\n");
    expect_ok(scene_read, &scene, filled("%s", directory_path(place, "in")),
              &(struct scene_overrides){.material = "silver"}); /* the command line's is the scene's */
    const struct material *silver = material_find("silver");
    const struct material_pair expected[] = {material_pair(silver, MATERIAL_COUNTERFACE_ELASTIC, silver),
                                             material_pair(copper, MATERIAL_COUNTERFACE_ELASTIC, copper),
                                             material_pair(silver, MATERIAL_COUNTERFACE_RIGID, tin)};
    const double hardness_Pa[] = {50e6, 50e6, 90e6};
    for (int s = 0; s < 3; s++) {
        struct material_pair pair = scene_pair(&scene.surfaces[s].bodies);
        assert_near(pair.effective_modulus_Pa, expected[s].effective_modulus_Pa, 0);
        assert_near(pair.resistivity_ohm_m, expected[s].resistivity_ohm_m, 0);
        assert_near(pair.hardness_Pa, hardness_Pa[s], 0);
    }
    scene_free(&scene);
}

/* The softer body is the one that yields first; a rigid one never does. */
TEST_CASE(the_softer_body)
{
    const struct scene_bodies hard = {.material = *material_find("copper"), .counterface = *material_find("tin")};
    struct scene_bodies bodies = hard;
    assert_ptr_equal(scene_softer(&bodies), &bodies.material); /* as the counterface is rigid */
    bodies.counterface_kind = MATERIAL_COUNTERFACE_ELASTIC;
    assert_ptr_equal(scene_softer(&bodies), &bodies.counterface);
    bodies.material = hard.counterface;
    bodies.counterface = hard.material;
    assert_ptr_equal(scene_softer(&bodies), &bodies.material);
}

/* The summary stands at the operating load, where every surface has 12 MPa on 1 mm²; charts are over newtons. */
TEST_IN_DIRECTORY(loads_are_shown_as_given)
{
    write_scans(place);
    pipeline_report(place, "in", "out",
                    LOADS "effects: [plasticity, electrical]\nmaterial: tin\nsurfaces:\n  - {name: a, file: a.csv}\n"
                          "  - {name: b, file: b.csv, material: copper}\n");
    struct table contact = directory_table(place, "out/data/contact.csv");
    size_t at_12 = 0;
    for (size_t r = 0; r < contact.rows; r++)
        at_12 += fabs(table_number(&contact, r, "pressure_Pa") / 12e6 - 1) < 1e-12 &&
                 strcmp(table_text(&contact, r, "model"), "multiscale-elastic") == 0;
    assert_int_equal(at_12, 2);
    char *report = directory_read(place, "out/report.md");
    expect_parts(report, "**At 12.0 N the ", " full contact (N) |");
    const char *row = strstr(report, "\n| b "), *end = row ? strchr(row + 1, '\n') : NULL;
    assert_non_null(end); /* compared there, not at the baseline's P/(A_n E') */
    assert_null(memmem(row, (size_t)(end - row), "| – | – ", strlen("| – | – ")));
    expect_in_file(place, "out/results.json", "\"load_unit\": \"N\"");
    expect_in_file(place, "out/figures/area.gp", "set xlabel 'load (N)'");
    char *data = directory_read(place, "out/figures/area.csv");
    for (int k = 0; k < 2; k++) /* each surface's curve starts at 0.1 N, whatever its E' */
        assert_near(strtod(strstr(data, k == 0 ? "# a\n" : "# b\n") + 4, NULL), 0.1, 1e-12);
}

/* An operating load in cN without `load`: charts and their data are over cN. Loads given as P/(A_n E') stay that. */
TEST_IN_DIRECTORY(loads_are_shown_as_the_operating_load_is_given)
{
    static const char scene[] = "effects: [plasticity, separation, electrical]\nmodels: [corrected-persson, cmy]\n"
                                "material: tin\nnominal_area: 1 mm2\noperating_load: 200 cN\n";
    static const char *const charts[] = {"answer", "area", "ecr", "separation-load"};
    pipeline_rough(place, "in/a.csv", 400, 1, 11);
    pipeline_rough(place, "in/b.csv", 400, 1, 12);
    pipeline_report(place, "in", "out", scene);
    expect_in_file(place, "out/report.md", "**At 200\u00a0cN the ");
    expect_in_file(place, "out/results.json", "\"operating_load_unit\": \"cN\"");
    for (size_t i = 0; i < sizeof charts / sizeof *charts; i++)
        expect_in_file(place, filled("out/figures/%s.gp", charts[i]), "load (cN)'");
    struct table contact = directory_table(place, "out/data/contact.csv");
    char *data = directory_read(place, "out/figures/area.csv");
    assert_near(strtod(strchr(data, '\n') + 1, NULL), 1e2 * 1e-6 * table_number(&contact, 0, "pressure_Pa"), 1e-9);
    pipeline_report(place, "in", "out", filled("%sload: {from: 1e-5, to: 1e-2, points: 7}\n", scene));
    expect_in_file(place, "out/figures/area.gp", "load P/(Aₙ E′)'");
}

/* Without a material, area and separation at P/(A_n E') are those with any material. */
TEST_IN_DIRECTORY(without_a_material)
{
    static const char loads[] = "load: {from: 1e-5, to: 1e-2, points: 5}\n";
    pipeline_rough(place, "in/a.csv", 400, 1, 5);
    pipeline_report(place, "in", "none", loads);
    pipeline_report(place, "in", "some", filled("material: copper\neffects: [separation]\n%s", loads));
    struct table none = directory_table(place, "none/data/contact.csv"),
                 some = directory_table(place, "some/data/contact.csv");
    size_t compared = 0;
    for (size_t r = 0; r < none.rows; r++) {
        assert_string_equal(table_text(&none, r, "pressure_Pa"), "");
        for (size_t o = 0; o < some.rows; o++) {
            if (strcmp(table_text(&none, r, "model"), table_text(&some, o, "model")) != 0 ||
                table_number(&none, r, "load_over_AnEp") != table_number(&some, o, "load_over_AnEp"))
                continue;
            assert_near(table_number(&none, r, "area_ratio"), table_number(&some, o, "area_ratio"), 1e-9);
            if (*table_text(&none, r, "separation_m"))
                assert_within(table_number(&none, r, "separation_m"), table_number(&some, o, "separation_m"), 1e-13);
            compared++;
        }
    }
    assert_true(compared >= 15);
    pipeline_report(place, "in", "soft",
                    "material: {E: 100 GPa, nu: 0.3}\nload: {values: [1e-4]}\n"); /* one without yield strength */
    expect_in_file(place, "soft/report.md", " against a rigid body.\n", " | 110 | – |\n");
    expect_not_in_file(place, "soft/report.md", "hardness  MPa", ", hardness");
    expect_in_file(place, "none/report.md", "P/(Aₙ\u00a0E′)");
    expect_not_in_file(place, "none/report.md", "MPa", "nan", "COMSOL");
    expect_in_file(place, "none/results.json", "\"material\": null");
}

/* The thesis's mean free path is that of phonons, and the report says so; the electrons' is far shorter in tin. */
TEST_IN_DIRECTORY(whose_mean_free_path)
{
    static const char *const kinds[] = {"thesis", "electron"};
    static const double expected_nm[] = {44.2376, 3.94994};
    pipeline_rough(place, "in/a.csv", 400, 1, 5);
    for (int k = 0; k < 2; k++) {
        struct scene scene;
        char text[200];
        snprintf(text, sizeof text, "material: tin\neffects: [scale-dependent]\nmean_free_path: %s\n", kinds[k]);
        directory_write(place, "in/scene.yaml", text);
        expect_ok(scene_read, &scene, filled("%s", directory_path(place, "in")), &(struct scene_overrides){0});
        assert_near(scene_pair(&scene.surfaces[0].bodies).mean_free_path_m[0], expected_nm[k] * 1e-9, 1e-5);
        scene_free(&scene);
        assert_int_equal(pipeline_run(place, "in", "out", 1), 0);
        char *report = directory_read(place, "out/report.md");
        assert_int_equal(strstr(report, "`mean_free_path: electron`") != NULL, k == 0);
    }
    pipeline_report(place, "in", "out", /* the material's own is neither */
                    "material: {E: 41 GPa, nu: 0.36, Sy: 14 MPa, conductivity: 67 W/m/K, density: 7310, "
                    "specific_heat: 227, sound_speed: 2730, mean_free_path: 5 nm}\neffects: [scale-dependent]\n");
    expect_not_in_file(place, "out/report.md", "mean free path");
}
