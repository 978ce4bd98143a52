/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A lay, through the whole program: given, measured along it, known of a map, and not known. */
#include "run/pipeline.h"

#include <jansson.h>

enum { POINTS = 240, SCANS = 3 };

/* A scene of one surface, with plasticity; `keys` are the surface's, `more` is the scene's. */
static void run_scene(const struct directory *place, const char *out, const char *files, const char *keys,
                      const char *more)
{
    struct text *text = support_text();
    text_add(text,
             "material: tin\nhardness: 20 GPa\neffects: [plasticity, separation, electrical, uncertainty]\nload: "
             "{from: 1e-5, to: 1e-1, points: 9}\noperating_load: 1e-3\nsurfaces: [{name: s, file: %s%s}]\n%s",
             files, keys, more);
    directory_write(place, "in/scene.yaml", text_string(text));
    assert_int_equal(pipeline_run(place, "in", out, 1), 0);
}

/* Scans `times` as high, `apart` as far apart as others of the same number. */
static void write_scans(const struct directory *place, const char *prefix, double times, double apart)
{
    for (unsigned long seed = 1; seed <= SCANS; seed++) {
        double height_m[POINTS];
        struct text *csv = support_text();
        struct synth_def def = synth_def_default();
        def.points = POINTS;
        def.length_m = 5e-7 * POINTS;
        def.seed = seed;
        expect_ok(synth_profile, height_m, &def);
        text_add(csv, "x [um],z [um]\n");
        for (size_t i = 0; i < POINTS; i++)
            text_add(csv, "%.15g,%.15g\n", 0.5 * apart * (double)i, times * height_m[i] * 1e6);
        directory_write(place, filled("in/%s%lu.csv", prefix, seed), text_string(csv));
    }
}

static double lay_number(const struct directory *place, const char *out, const char *key)
{
    json_t *root = directory_json(place, filled("%s/results.json", out));
    const json_t *surface = json_array_get(json_object_get(root, "surfaces"), 0);
    return json_number_value(json_object_get(json_object_get(surface, "lay"), key));
}

/* All numbers of a table of two runs. */
static void expect_same(const struct directory *place, const char *file, const char *one, const char *other,
                        const char *const columns[4], double tolerance)
{
    char name[2][100];
    snprintf(name[0], sizeof name[0], "%s/data/%s.csv", one, file);
    snprintf(name[1], sizeof name[1], "%s/data/%s.csv", other, file);
    struct table a = directory_table(place, name[0]), b = directory_table(place, name[1]);
    assert_true(a.rows > 3);
    assert_int_equal(a.rows, b.rows);
    for (size_t row = 0; row < a.rows; row++)
        for (size_t c = 0; c < 4 && columns[c]; c++) {
            assert_int_equal(*table_text(&a, row, columns[c]) == '\0', *table_text(&b, row, columns[c]) == '\0');
            if (*table_text(&a, row, columns[c]))
                assert_near(table_number(&a, row, columns[c]), table_number(&b, row, columns[c]), tolerance);
        }
}

/** A surface of lay r is the one whose waves are sqrt(2/(1 + r²)) times as long, in every model; what describes the
 * scans stays as measured. Along scans 0.6 times as high are r = 0.6. */
TEST_IN_DIRECTORY(a_lay_stretches_the_waves)
{
    static const struct {
        const char *files, *stretched;
        double r;
        const char *keys;
    } rows[] = {{"'a*.csv'", "'b*.csv'", 0, ", lay: 0"},
                {"'a*.csv'", "'b*.csv'", 0.6, ", along: ['l*.csv']"},
                {"a1.csv", "b1.csv", 0.6, ", lay: 0.6"}};
    static const char *const curves[4] = {"load_over_AnEp", "area_ratio", "separation_m", "ecr_ohm_m2"},
                             *const spectra[4] = {"wavelength_m", "amplitude_m", "fit_m"},
                             *const bands[4] = {"area_ratio_mean_low_95", "ecr_ohm_m2_mean_high_95"},
                             *const solved[4] = {"area_ratio", "gap_m", "ecr_ohm_m2"};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        /* strips of several scans differ with their order, which is that of their contents */
        const char *direct = k == 2 ? "direct: {grid: 64, seeds: 2, loads: 3}\n"
                                    : "models: [multiscale, statistical, corrected-persson]\n";
        double kappa = sqrt((1 + rows[k].r * rows[k].r) / 2);
        write_scans(place, "a", 1, 1);
        write_scans(place, "l", 0.6, 1);
        write_scans(place, "b", 1, 1 / kappa);
        run_scene(place, "lay", rows[k].files, rows[k].keys, direct);
        run_scene(place, "stretched", rows[k].stretched, ", lay: 1", direct);
        expect_same(place, "contact", "lay", "stretched", curves, 2e-6);
        expect_same(place, "bands", "lay", "stretched", bands, 1e-5);
        if (k == 2)
            expect_same(place, "direct", "lay", "stretched", solved, 1e-3);
        assert_near(lay_number(place, "lay", "r"), rows[k].r, 1e-9);
        assert_near(lay_number(place, "lay", "kappa"), kappa, 1e-9);
        run_scene(place, "isotropic", rows[k].files, "", "");
        expect_same(place, "spectrum", "lay", "isotropic", spectra, 1e-12);
    }
}

/** A map of waves along x and weaker ones along y, on a plane, has the ratio of their slopes; turned, the inverse. */
TEST_IN_DIRECTORY(a_map_knows_its_lay)
{
    enum { NX = 200, NY = 80 };
    for (int turned = 0; turned < 2; turned++) {
        struct text *grid = support_text();
        text_add(grid, "DSAA\n%d %d\n0 %.9g\n0 %.9g\n-1 1\n", NX, NY, 1e-6 * (NX - 1), 2e-6 * (NY - 1));
        for (int row = 0; row < NY; row++)
            for (int i = 0; i < NX; i++) {
                double x = 1e-6 * i, y = 2e-6 * row, k = 2 * M_PI / 40e-6;
                text_add(grid, "%.17g%c",
                         1e-7 * sin(k * (turned ? y : x)) + 0.4e-7 * sin(k * (turned ? x : y)) + 0.02 * x - 0.03 * y,
                         i + 1 < NX ? ' ' : '\n');
            }
        directory_write(place, "in/map.grd", text_string(grid));
        run_scene(place, "map", "map.grd", ", x_unit: m, z_unit: m", "");
        assert_near(lay_number(place, "map", "r"), turned ? 2.5 : 0.4, 0.02);
        char *json = directory_read(place, "map/results.json");
        assert_int_equal(turned, strstr(json, "times as steep along as across its lay") != NULL);
    }
}
