/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A lay through the whole program: given, measured along it, known from a map, and not known. */
#include "run/pipeline.h"

#include <jansson.h>

enum { POINTS = 240, SCANS = 3 };

/* A scene of one surface, with plasticity; `keys` are the surface's, `more` is the scene's. */
static void run_scene(const struct directory *place, const char *out, const char *files, const char *keys,
                      const char *more)
{
    pipeline_report(place, "in", out,
                    filled("material: tin\nhardness: 20 GPa\n"
                           "effects: [plasticity, separation, electrical, uncertainty]\n"
                           "load: {from: 1e-5, to: 1e-1, points: 9}\noperating_load: 1e-3\n"
                           "surfaces: [{name: s, file: %s%s}]\n%s",
                           files, keys, more));
}

/* Scans with heights and spacing multiplied by these. */
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
    return pipeline_number(place, out, filled("surfaces/0/lay/%s", key));
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

/** For every model a surface of lay r is an isotropic one whose waves are sqrt(2/(1 + r²)) times as long; the numbers
 * that describe the scans stay as measured. Scans along that are 0.6 times as high give r = 0.6. */
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

/** Area and resistance of the leading model at the operating load, and the width of its interval. */
static void answer_of(double out[3], const struct directory *place, const char *run)
{
    struct table contact = directory_table(place, filled("%s/data/contact.csv", run)),
                 bands = directory_table(place, filled("%s/data/bands.csv", run));
    const size_t row = pipeline_row(&contact, NULL, "strip", 1e-3), band = pipeline_row(&bands, NULL, "strip", 1e-3);
    out[0] = table_number(&contact, row, "area_ratio");
    out[1] = table_number(&contact, row, "ecr_ohm_m2");
    out[2] = log(table_number(&bands, band, "ecr_ohm_m2_mean_high_95") /
                 table_number(&bands, band, "ecr_ohm_m2_mean_low_95"));
}

/** Whichever direction the scene calls `along`, the steeper one counts as across: r is at most 1, all numbers are the
 * same, and a note says so. The flatter scans' strips are used too, so that the interval is narrower than with r alone.
 */
TEST_IN_DIRECTORY(the_steeper_direction_is_across)
{
    static const struct {
        const char *steep, *flat;
    } cases[] = {{"'a*.csv'", "'l*.csv'"}, {"'a[12].csv'", "'l[12].csv'"}, {"a1.csv", "l2.csv"}};
    static const char models[] = "models: [strip]\n", note[] = "its scans in 'along' are steeper";
    write_scans(place, "a", 1, 1);
    write_scans(place, "l", 0.6, 1.2);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        double right[3], wrong[3], alone[3], with_r[3];
        run_scene(place, "right", cases[k].steep, filled(", along: %s", cases[k].flat), models);
        run_scene(place, "wrong", cases[k].flat, filled(", along: %s", cases[k].steep), models);
        run_scene(place, "alone", cases[k].steep, "", models);
        const double r = lay_number(place, "wrong", "r");
        run_scene(place, "with_r", cases[k].steep, filled(", lay: %.17g", r), models);
        answer_of(right, place, "right");
        answer_of(wrong, place, "wrong");
        answer_of(alone, place, "alone");
        answer_of(with_r, place, "with_r");
        assert_true(r > 0.3 && r < 0.7);
        assert_near(lay_number(place, "right", "r"), r, 1e-12);
        for (int n = 0; n < 3; n++)
            assert_near(right[n], wrong[n], 1e-12);
        assert_true(fabs(log(right[0] / with_r[0])) > 1e-3); /* the flatter one's have a quarter */
        assert_true(k == 1 || with_r[2] < alone[2]);         /* two scans scatter by a t of one degree */
        assert_true(k < 2 || with_r[2] > 0.95 * alone[2]);   /* of one scan the model's error stays as it is */
        assert_true(right[2] < with_r[2]);
        assert_null(strstr(directory_read(place, "right/results.json"), note));
        assert_non_null(strstr(directory_read(place, "wrong/results.json"), note));
    }
}

/** Refused scans and copies are reported in both directions; the same scans cannot be both. */
TEST_IN_DIRECTORY(scans_along_are_read_as_others)
{
    write_scans(place, "a", 1, 1);
    write_scans(place, "l", 0.6, 1);
    directory_write(place, "in/l9.csv", "x [um],z [um]\n0,1\n");
    run_scene(place, "o", "'l*.csv'", ", along: 'a*.csv'", "models: [strip]\n");
    char *json = directory_read(place, "o/results.json");
    assert_non_null(strstr(json, "1 of 7 files"));
    assert_true(lay_number(place, "o", "r") < 1);
    run_scene(place, "o", "'a*.csv'", ", along: 'l*.csv'", "models: [strip]\n");
    assert_non_null(strstr(directory_read(place, "o/results.json"), "1 of 7 files"));
    expect_in_file(place, "o/report.md", "- s: a1.csv, a2.csv, a3.csv, l1.csv, l2.csv and 2 more; text,");
    directory_write(place, "in/scene.yaml", "material: tin\nsurfaces: [{name: s, file: 'a*.csv', along: 'a*.csv'}]\n");
    struct status status = {0};
    const struct run_outcome *outcome = pipeline_into(place, "in", "same", (struct run_options){0}, &status);
    assert_int_not_equal(status.code, STATUS_OK);
    expect_parts(text_string(&outcome->messages), "along: its scans are those of 'file'");
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
