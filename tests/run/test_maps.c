/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Maps through the whole program: their direct solution leads where all surfaces are maps. */
#include "direct_points.h"
#include "run/pipeline.h"
#include <jansson.h>

enum { SIDE = 48 };

/** SIDE rows of `points` heights that do not close, every second one of them by `noise_um` too high. */
static void write_noisy_map(const struct directory *place, const char *name, uint64_t seed, double step_um,
                            size_t points, double noise_um)
{
    enum { WIDE = 6 * SIDE };
    double *height = band_surface(WIDE, (const double[]){12, 48, 3.6}, seed);
    struct text *xyz = support_text();
    text_add(xyz, "x [um],y [um],z [um]\n");
    for (size_t k = 0; k < points * SIDE; k++)
        text_add(xyz, "%.9g,%.9g,%.9g\n", step_um * (double)(k % points), step_um * (double)(k / points),
                 0.3 * height[k / points * WIDE + k % points] + noise_um * (double)((k / points + k % points) % 2));
    directory_write(place, name, text_string(xyz));
}

static void write_long_map(const struct directory *place, const char *name, uint64_t seed, double step_um,
                           size_t points)
{
    write_noisy_map(place, name, seed, step_um, points, 0);
}

static void write_map(const struct directory *place, const char *name, uint64_t seed, double step_um)
{
    write_long_map(place, name, seed, step_um, SIDE);
}

static void run_scene(const struct directory *place, const char *out, const char *text)
{
    pipeline_report(place, "in", out, text);
}

#define MATERIAL                                                                                                       \
    "material: bronze\neffects: [separation, electrical, plasticity]\nload: {from: 1e-5, to: 1e-2, points: 9}\n"
#define MAP(name) "{name: " name ", file: " name ".csv}"

/** How many rows of a table of the report a model has. */
static size_t rows_of(const struct directory *place, const char *path, const char *model)
{
    struct table table = directory_table(place, path);
    size_t rows = 0;
    for (size_t i = 0; i < table.rows; i++)
        rows += strcmp(table_text(&table, i, "model"), model) == 0;
    return rows;
}

/** With maps only, the direct solution leads and has an interval; with `models: [strip]` it does not run; with a line
 * scan among the surfaces another model leads, which also decides on limits. */
TEST_IN_DIRECTORY(what_leads)
{
    write_map(place, "in/a.csv", 1, 1);
    write_map(place, "in/b.csv", 2, 1);
    pipeline_rough(place, "in/line.csv", 400, 1, 1);
    run_scene(place, "maps", MATERIAL "limits: {ecr: {most: 1e-30 ohm m2}}\nsurfaces: [" MAP("a") ", " MAP("b") "]\n");
    expect_in_file(place, "maps/results.json", "\"leading\": \"direct-plastic\"");
    assert_true(rows_of(place, "maps/data/contact.csv", "direct") > 10);
    assert_true(rows_of(place, "maps/data/bands.csv", "direct-plastic") > 10);
    run_scene(place, "strip", MATERIAL "models: [strip]\nsurfaces: [" MAP("a") ", " MAP("b") "]\n");
    expect_in_file(place, "strip/results.json", "\"leading\": \"strip-plastic\"");
    assert_int_equal(rows_of(place, "strip/data/contact.csv", "direct"), 0);
    expect_not_in_file(place, "maps/report.md", "no direct solution");
    expect_not_in_file(place, "strip/report.md", "no direct solution"); /* nobody asks for it */
    run_scene(place, "mixed",
              MATERIAL "limits: {ecr: {most: 1 ohm m2}}\nsurfaces: [" MAP("a") ", {name: c, file: line.csv}]\n");
    expect_in_file(place, "mixed/results.json", "\"leading\": \"strip-plastic\"");
    expect_in_file(place, "mixed/report.md", "scans and profiles of maps");
    assert_true(rows_of(place, "mixed/data/contact.csv", "direct-plastic") > 5);
    /* the limit of the map, too, is that of the strip: its value is in the strip's curve */
    char *json = directory_read(place, "mixed/results.json");
    json_t *results = support_json(json), *limit = json_array_get(json_object_get(results, "limits"), 0);
    double value = json_number_value(json_object_get(limit, "value"));
    assert_string_equal(json_string_value(json_object_get(limit, "surface")), "a");
    struct table contact = directory_table(place, "mixed/data/contact.csv");
    size_t found[2] = {0};
    for (size_t i = 0; i < contact.rows; i++)
        for (int k = 0; k < 2; k++)
            found[k] += strcmp(table_text(&contact, i, "model"), k == 0 ? "strip-plastic" : "direct-plastic") == 0 &&
                        fabs(table_number(&contact, i, "ecr_ohm_m2") / value - 1) < 1e-9;
    assert_true(found[0] == 1 && found[1] == 0);
}

/** The time of a map's squares is shared out between area and plasticity, as each took it. */
TEST_IN_DIRECTORY(squares_are_charged_to_their_effect)
{
    struct status status = {0};
    write_map(place, "in/a.csv", 1, 1);
    directory_write(place, "in/scene.yaml", MATERIAL "models: [direct, direct-plastic]\nsurfaces: [" MAP("a") "]\n");
    const struct run_outcome *outcome = pipeline_into(place, "in", "out", (struct run_options){.jobs = 2}, &status);
    double seconds[2], all = outcome->times.tiles;
    for (int kind = 0; kind < 2; kind++) {
        const char *row = strstr(text_string(&outcome->work), kind ? "\nplasticity " : "\narea ");
        assert_int_equal(row ? sscanf(row, "%*s run %*u %lf", &seconds[kind]) : 0, 1);
        assert_true(seconds[kind] > 0.05 * all);
    }
    assert_true(seconds[0] + seconds[1] > 0.99 * all - 1e-4);
}

/** Two maps of one spacing are pressed together directly; with different spacings, or a line scan, their rows are used.
 * The leading model has an interval, in the last two cases from a row's simulated records and quarters. */
TEST_IN_DIRECTORY(two_rough_bodies)
{
    write_map(place, "in/a.csv", 1, 1);
    write_map(place, "in/b.csv", 2, 1);
    write_map(place, "in/c.csv", 2, 1.1);
    pipeline_rough(place, "in/line.csv", 400, 1, 1);
    static const char *const others[] = {"b.csv", "c.csv", "line.csv"};
    for (int k = 0; k < 3; k++) {
        run_scene(place, "pair",
                  filled("material: bronze\nload: {from: 1e-5, to: 1e-2, points: 9}\nsurfaces: [" MAP(
                             "a") "]\ncounterface: {surface: %s}\n",
                         others[k]));
        assert_true((rows_of(place, "pair/data/contact.csv", "direct-plastic") > 5) == (k == 0));
        assert_true((rows_of(place, "pair/data/bands.csv", "direct-plastic") > 5) == (k == 0));
        assert_true((rows_of(place, "pair/data/bands.csv", "strip-plastic") > 5) == (k > 0));
        const double both = pipeline_number(place, "pair", "surfaces/0/sigma_m");
        assert_near(json_number_at(directory_json(place, "pair/view.json"), "rows/0/rq_m"), both, 1e-9);
        assert_true(both > 1.1 * pipeline_number(place, "pair", "surfaces/0/sq_m"));
    }
}

/** A map of which points are missing: a block, nearly all rows, or one in each row and column. */
static void write_holes(const struct directory *place, int kind)
{
    struct text *xyz = support_text();
    double *height = band_surface(SIDE, (const double[]){12, 48, 3.6}, 1);
    text_add(xyz, "x [um],y [um],z [um]\n");
    for (size_t k = 0; k < SIDE * SIDE; k++) {
        const size_t x = k % SIDE, y = k / SIDE;
        const bool missing[] = {x < 12 && y < 12 && y > 0, (y > 0 && y < 20) || (y > 40 && y + 1 < SIDE),
                                x == 7 * y % SIDE};
        text_add(xyz, "%zu,%zu,%.9g\n", x, y, missing[kind] ? NAN : 0.3 * height[k]);
    }
    directory_write(place, "in/h.csv", text_string(xyz));
}

/** Notes say what of a map is solved and what was missing; none is said of a whole one. Its rows' models tell how they
 * depend on the cut-off. */
TEST_IN_DIRECTORY(what_is_solved)
{
    static const char *const notes[] = {"up to 5.7 % of a square of the map is missing; where it is solved directly",
                                        "no direct solution of the map: 52 % of a square of it is missing",
                                        "as no row or column is complete"};
    static const char holes[] = "material: bronze\nload: {from: 1e-5, to: 1e-2, points: 9}\nmax_missing: 30 %\n"
                                "surfaces: [" MAP("h") "]\n";
    for (int kind = 0; kind < 3; kind++) {
        write_holes(place, kind);
        run_scene(place, "holes", holes);
        assert_true((rows_of(place, "holes/data/contact.csv", "direct-plastic") > 5) == (kind != 1));
        assert_true(rows_of(place, "holes/data/bands.csv", "strip-plastic") > 5 || kind != 1);
        for (int n = 0; n < 3; n++)
            if (n == kind)
                expect_in_file(place, "holes/report.md", notes[n]);
            else
                expect_not_in_file(place, "holes/report.md", notes[n]);
    }
    write_long_map(place, "in/l.csv", 3, 1, 5 * SIDE);
    write_map(place, "in/w.csv", 3, 1);
    run_scene(place, "long", MATERIAL "surfaces: [" MAP("l") ", " MAP("w") "]\noperating_load: 1e-4\n");
    expect_in_file(place, "long/report.md", "4 squares of 48 x 48 points, 80 % of the map, are solved directly",
                   ", the first of 4 squares that are solved: ");
    expect_not_in_file(place, "long/report.md", "1 square", "is missing", "the first of 1");
    struct table table = directory_table(place, "long/data/sensitivity.csv");
    for (size_t i = 0; i < table.rows; i++)
        if (strcmp(table_text(&table, i, "model"), "corrected-persson") == 0)
            assert_true(fabs(table_number(&table, i, "ecr_factor") - 1) > 1e-3);
}

/** A number of the map's leading model in row `at` of its own of a table. */
static double of_row(const struct directory *place, const char *path, size_t at, const char *column)
{
    struct table table = directory_table(place, path);
    for (size_t i = 0; i < table.rows; i++)
        if (strcmp(table_text(&table, i, "model"), "direct-plastic") == 0 && at-- == 0)
            return table_number(&table, i, column);
    fail_msg("%s: no such row", path);
    return NAN;
}

/** The conductance of a map's joint has an interval, in vacuum that of the spots. The page advises wider loads only
 * where they would give the interval's end. */
TEST_IN_DIRECTORY(joints_of_a_map)
{
    enum { MIDDLE = 4 };
    static const char with[] = "material: bronze\nnominal_area: 1 mm2\nload: {from: %s, to: %s, points: 9}\n"
                               "models: [direct]\ngap: %s\n%s\nsurfaces: [" MAP("a") "]\n";
    static const char *const gaps[] = {"{gas: air}", "{filler: silicone grease}", "{gas: vacuum}"};
    write_map(place, "in/a.csv", 1, 1);
    for (int k = 0; k < 3; k++) {
        run_scene(place, "all", filled(with, "1e-5", "1e-2", gaps[k], ""));
        double low = of_row(place, "all/data/bands.csv", MIDDLE, "joint_W_per_m2K_mean_low_95"),
               high = of_row(place, "all/data/bands.csv", MIDDLE, "joint_W_per_m2K_mean_high_95"),
               own = of_row(place, "all/data/contact.csv", MIDDLE, "joint_W_per_m2K"),
               metal = of_row(place, "all/data/bands.csv", MIDDLE, "tcr_K_m2_per_W_mean_high_95");
        assert_true(low < own && own < high);
        assert_near(sqrt(low * high), own, 1e-9);
        if (k == 2)
            assert_near(low, 1 / metal, 1e-9);
        char asked[100], from[40], to[40];
        double load = of_row(place, "all/data/contact.csv", MIDDLE, "load_over_AnEp");
        snprintf(asked, sizeof asked, "targets: {conductance: %.9g W/m2/K}\n", own);
        run_scene(place, "wide", filled(with, "1e-5", "1e-2", gaps[k], asked));
        expect_not_in_file(place, "wide/report.md", "beyond the loads", "widen");
        struct table answers = directory_table(place, "wide/data/answers.csv");
        for (size_t i = 0; i < answers.rows; i++)
            if (strcmp(table_text(&answers, i, "model"), "direct-plastic") == 0) {
                assert_near(table_number(&answers, i, "load_over_AnEp"), load, 1e-6);
                assert_true(table_number(&answers, i, "high") > load);
            }
        if (k == 1)
            continue; /* its heat hardly hangs on the load */
        snprintf(from, sizeof from, "%.9g", load * 0.95);
        snprintf(to, sizeof to, "%.9g", load * 1.05);
        run_scene(place, "narrow", filled(with, from, to, gaps[k], asked));
        expect_in_file(place, "narrow/report.md",
                       "**Loads too narrow:** the load of *a* or an end of its interval is beyond");
    }
    run_scene(place, "any", /* the lightest load conducts a thousand times that, as no load would */
              filled(with, "1e-6", "1e-4", "{filler: silicone grease}", "targets: {conductance: 1 kW/m2/K}\n"));
    expect_in_file(place, "any/report.md", "needs at most");
    expect_not_in_file(place, "any/report.md", "beyond the loads", "widen");
    run_scene(place, "thick",
              filled(with, "1e-5", "1e-2", "{filler: silicone grease, bond_line: 25 um}",
                     "targets: {conductance: 3.1e4 W/m2/K}"));
    expect_in_file(place, "thick/report.md", "needs at most");
    expect_not_in_file(place, "thick/report.md", "beyond the loads", "widen", "Few metal spots");
    assert_near(of_row(place, "thick/data/contact.csv", MIDDLE, "joint_W_per_m2K"), 3.2e4, 1e-12);
}

/** Against a body that is a million times smoother all is as against a flat one. */
TEST_IN_DIRECTORY(a_smooth_second_body)
{
    static const char *const counterfaces[] = {"same", "{surface: smooth.csv}"};
    struct text *xyz = support_text();
    struct table table[2];
    size_t compared = 0;
    text_add(xyz, "x [um],y [um],z [um]\n");
    for (size_t k = 0; k < SIDE * SIDE; k++)
        text_add(xyz, "%zu,%zu,%.9g\n", k % SIDE, k / SIDE, 1e-7 * sin(0.7 * (double)(k % SIDE + k / SIDE)));
    directory_write(place, "in/smooth.csv", text_string(xyz));
    write_map(place, "in/a.csv", 1, 1);
    for (int k = 0; k < 2; k++) {
        run_scene(place, filled("out%d", k),
                  filled(MATERIAL "surfaces: [" MAP("a") "]\ncounterface: %s\n", counterfaces[k]));
        table[k] = directory_table(place, filled("out%d/data/contact.csv", k));
    }
    assert_int_equal(table[0].rows, table[1].rows);
    for (size_t r = 0; r < table[0].rows; r++)
        if (strstr("direct direct-plastic corrected-persson strip", table_text(&table[0], r, "model"))) {
            assert_near(table_number(&table[1], r, "area_ratio"), table_number(&table[0], r, "area_ratio"), 0.01);
            assert_near(table_number(&table[1], r, "ecr_ohm_m2"), table_number(&table[0], r, "ecr_ohm_m2"), 0.01);
            compared++;
        }
    assert_true(compared > 20);
}

/** The direct study does not compare the direct solution with itself. */
TEST_IN_DIRECTORY(squares_and_study)
{
    write_long_map(place, "in/a.csv", 3, 1, 5 * SIDE);
    run_scene(place, "out", MATERIAL "models: [direct, gw]\ndirect: {loads: 3}\nsurfaces: [" MAP("a") "]\n");
    assert_int_equal(rows_of(place, "out/data/direct_ratio.csv", "gw"), 3);
    assert_int_equal(rows_of(place, "out/data/direct_ratio.csv", "direct"), 0);
}

/** Waves of 16 and, `noisy`, of 4 points on a slight slope: Sq² = .2² and .02² more. */
static void write_waves(const struct directory *place, const char *name, bool noisy)
{
    struct text *xyz = support_text();
    text_add(xyz, "x [um],y [um],z [um]\n");
    for (size_t k = 0; k < SIDE * SIDE; k++) {
        double x = 2 * M_PI * ((double)(k % SIDE) + 0.5), y = 2 * M_PI * ((double)(k / SIDE) + 0.5);
        text_add(xyz, "%zu,%zu,%.9g\n", k % SIDE, k / SIDE,
                 0.001 * x + 0.4 * cos(x / 16) * cos(y / 16) + noisy * 0.04 * cos(x / 4) * cos(y / 4));
    }
    directory_write(place, name, text_string(xyz));
}

/** Sq and the other parameters of a map are those of its surface as measured; the effect of a low-pass is stated.
 * Profiles have neither column nor values. */
TEST_IN_DIRECTORY(parameters_of_the_surface)
{
    write_waves(place, "in/w.csv", false);
    write_waves(place, "in/n.csv", true);
    pipeline_rough(place, "in/line.csv", 400, 1, 1);
    run_scene(place, "maps", "models: [multiscale]\nsurfaces: [" MAP("w") ", " MAP("n") ", " MAP("line") "]\n");
    expect_in_file(place, "maps/report.md", "| surface | Rq (µm) | Ra (µm) | Sq (µm) |", "| 0.200 (Sq) |",
                   "\n| w | 0.200 | 0.164 | 0.200 |", "\n| n | 0.165 | 0.135 | 0.201 |", "\n| line | 0.116 | ",
                   "*w*, over its plane (ISO 25178-2): Sq 0.200 µm, Sa 0.1",
                   "low-passed at 6 um (Sq 0.201 → 0.165 um, slope 0.11 → 0.091)");
    expect_not_in_file(place, "maps/report.md", "*line*, over", "w.csv: low-passed");
    struct table table = directory_table(place, "maps/data/surfaces.csv");
    assert_near(table_number(&table, 0, "sq_m"), 2e-7, 1e-6);
    assert_near(table_number(&table, 1, "sq_m"), hypot(0.2, 0.02) * 1e-6, 1e-6);
    assert_near(table_number(&table, 1, "sdq") / table_number(&table, 0, "sdq"),
                hypot(0.2 * sin(M_PI / 8), 0.02) / (0.2 * sin(M_PI / 8)), 0.01);
    assert_string_equal(table_text(&table, 2, "sq_m"), "");
    assert_near(pipeline_number(place, "maps", "surfaces/0/sigma_m"), 2e-7, 1e-6);
    assert_near(pipeline_number(place, "maps", "surfaces/0/mean_slope"),
                pipeline_number(place, "maps", "surfaces/0/sdq") / sqrt(M_PI), 0.03);
    run_scene(place, "two",
              "models: [multiscale]\nsurfaces: [{name: both, file: [w.csv, n.csv], z_unit: um}, {name: v, "
              "file: w.csv, z_unit: um, material: copper}, " MAP("line") "]\n");
    expect_in_file(place, "two/report.md", "profiles | ", "*both*, first map, over its plane");
    expect_not_in_file(place, "two/report.md", "No lay is known");
    run_scene(place, "lines", "models: [multiscale]\nsurfaces: [" MAP("line") "]\n");
    expect_not_in_file(place, "lines/report.md", "Sq (µm)", "over its plane", "after `lambda_c`");
    expect_not_in_file(place, "lines/data/surfaces.csv", "sq_m");
    run_scene(place, "high", "models: [multiscale]\nlambda_c: 50 um\nsurfaces: [" MAP("line") "]\n");
    expect_in_file(place, "high/report.md", "Rq, Ra: of the whole scan after `lambda_c`");
}

/** The picture of a map states its share in contact and its spots; the spots carry the load on the map. Names may
 * contain any characters. Neither --brief nor profiles have such a picture. */
TEST_IN_DIRECTORY(pictures_and_spots)
{
    write_map(place, "in/a.csv", 1, 1);
    write_map(place, "in/b.csv", 2, 1);
    pipeline_rough(place, "in/line.csv", 400, 1, 1);
    static const char scene[] = MATERIAL
        "operating_load: 1e-3\nsurfaces: [{name: \"a'/]]><\", file: a.csv}, {name: \"a''/]]><\", file: b.csv}]\n";
    run_scene(place, "out", scene);
    expect_in_file(place, "out/report.md", " % of the points in contact, in ",
                   " % of these points have yielded (at the hardness)", "](figures/map-a------.svg)",
                   "](figures/map-a-------.svg)");
    expect_in_file(place, "out/figures/map-a------.svg", "<image", "data:image/png;base64,", "in contact");
    struct table spots = directory_table(place, "out/data/contact_spots.csv");
    const double modulus_Pa = pipeline_number(place, "out", "scene/effective_modulus_Pa");
    double sum_N[2] = {0}, area_m2[2] = {0};
    for (size_t r = 0; r < spots.rows; r++) {
        const int b = strlen(table_text(&spots, r, "surface")) > strlen("a'/]]><");
        sum_N[b] += table_number(&spots, r, "load_N");
        area_m2[b] += table_number(&spots, r, "area_m2");
        assert_in_range(table_number(&spots, r, "x_m") * 1e9, 0, SIDE * 1000);
        assert_in_range(table_number(&spots, r, "y_m") * 1e9, 0, SIDE * 1000);
    }
    for (int b = 0; b < 2; b++) {
        assert_near(sum_N[b], 1e-3 * modulus_Pa * SIDE * SIDE * 1e-12, 1e-3);
        expect_in_file(place, "out/report.md",
                       filled("%.2g %% of the points in contact", 100 * area_m2[b] / (SIDE * SIDE * 1e-12)));
        assert_true(area_m2[b] > 1e-3 * SIDE * SIDE * 1e-12 && area_m2[b] < 0.3 * SIDE * SIDE * 1e-12);
    }
    pipeline_outcome(place, "in", "brief", (struct run_options){.brief = true});
    assert_true(directory_has(place, "brief/data/contact_spots.csv"));
    assert_false(directory_has(place, "brief/figures/map-a------.svg"));
    run_scene(place, "lines", "material: bronze\nsurfaces: [" MAP("line") "]\n");
    expect_not_in_file(place, "lines/report.md", "figures/map", "in contact, in");
    assert_false(directory_has(place, "lines/data/contact_spots.csv"));
}

/** `lambda_s: none` takes a noisy map as measured; without it the map is low-passed, and the report says so. A map
 * without noise is not low-passed. */
TEST_IN_DIRECTORY(as_measured)
{
    static const char *const said[] = {"low-passed at 6 um", "the map is solved after its low-pass; with ",
                                       "% from the map's size, grid and low-pass."};
    char *curves[2];
    for (int noisy = 0; noisy < 2; noisy++) {
        double area[2];
        write_noisy_map(place, "in/a.csv", 1, 1, SIDE, noisy ? 0.2 : 0);
        for (int given = 0; given < 2; given++) {
            const char *text =
                given ? MATERIAL "lambda_s: none\nsurfaces: [" MAP("a") "]\n" : MATERIAL "surfaces: [" MAP("a") "]\n";
            run_scene(place, "out", text);
            curves[given] = directory_read(place, "out/data/contact.csv");
            struct table contact = directory_table(place, "out/data/contact.csv");
            area[given] = table_number(&contact, pipeline_row(&contact, NULL, "direct", NAN), "area_ratio");
            const char *report = directory_read(place, "out/report.md");
            for (size_t k = 0; k < sizeof said / sizeof *said; k++)
                assert_int_equal(strstr(report, said[k]) != NULL, noisy && !given);
            assert_int_equal(times(report, "size and grid."), noisy && !given ? 0 : 1);
        }
        if (noisy)
            assert_true(area[1] < 0.7 * area[0]);
        else
            assert_string_equal(curves[0], curves[1]);
    }
}

/** A direct solution of a map, of a model or beside them, does not use `level` and `lambda_c`; only then does the
 * report say so. */
TEST_IN_DIRECTORY(own_plane)
{
    static const struct {
        const char *keys;
        bool said;
    } cases[] = {{"", false},
                 {"level: line\n", false},
                 {"level: parabola\n", true},
                 {"lambda_c: 40 um\n", true},
                 {"lambda_c: 40 um\nmodels: [strip]\n", false},
                 {"lambda_c: 40 um\nmodels: [multiscale]\ndirect: {loads: [1e-3]}\n", true}};
    write_map(place, "in/a.csv", 1, 1);
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        run_scene(place, "out", filled(MATERIAL "%ssurfaces: [" MAP("a") "]\n", cases[c].keys));
        assert_int_equal(strstr(directory_read(place, "out/report.md"), "takes out its plane alone") != NULL,
                         cases[c].said);
    }
}

/** `lambda_s` filters the map that is solved, not its rows alone, and the report says that it did; one longer than the
 * map is refused. */
TEST_IN_DIRECTORY(own_low_pass)
{
    double area[2];
    write_noisy_map(place, "in/a.csv", 1, 1, SIDE, 0.2);
    for (int k = 0; k < 2; k++) {
        run_scene(place, "out",
                  k ? MATERIAL "lambda_s: 24 um\nsurfaces: [" MAP("a") "]\n" : MATERIAL "surfaces: [" MAP("a") "]\n");
        struct table contact = directory_table(place, "out/data/contact.csv");
        area[k] = table_number(&contact, pipeline_row(&contact, NULL, "direct", NAN), "area_ratio");
        const char *report = directory_read(place, "out/report.md");
        assert_int_equal(strstr(report, "low-passed at 24 um (Sq") != NULL, k);
        assert_int_equal(strstr(report, "as more than 2 % of its mean square slope is shorter") != NULL, !k);
    }
    assert_true(area[1] > 1.2 * area[0]);
    directory_write(place, "in/scene.yaml", MATERIAL "lambda_s: 49 um\nsurfaces: [" MAP("a") "]\n");
    struct status status = {0};
    const struct run_outcome *outcome = pipeline_into(place, "in", "none", (struct run_options){0}, &status);
    assert_int_not_equal(status.code, STATUS_OK);
    expect_parts(text_string(&outcome->messages), "lambda_s is 4.9e-05 m, longer than a side of the map of 4.8e-05 m");
}

/** A map beside a profile, where strips lead, has the interval that it has where strips alone run. */
TEST_IN_DIRECTORY(interval_beside_a_profile)
{
    static const char head[] = "material: bronze\nload: {from: 1e-5, to: 1e-2, points: 9}\n";
    double s[2];
    write_long_map(place, "in/a.csv", 1, 1, 2 * SIDE);
    pipeline_rough(place, "in/line.csv", 400, 1, 1);
    for (int k = 0; k < 2; k++) {
        run_scene(place, "out",
                  k ? filled("%ssurfaces: [" MAP("a") ", " MAP("line") "]\n", head)
                    : filled("%smodels: [strip]\nsurfaces: [" MAP("a") "]\n", head));
        struct table spread = directory_table(place, "out/data/spread.csv");
        s[k] = NAN;
        for (size_t r = 0; r < spread.rows; r++)
            if (strcmp(table_text(&spread, r, "surface"), "a") == 0 &&
                strcmp(table_text(&spread, r, "quantity"), "ecr_ohm_m2_at_middle_load_strip-plastic") == 0)
                s[k] = table_number(&spread, r, "standard_deviation");
    }
    assert_near(s[1], s[0], 0.05);
}

/** Where a filler's bond line holds the metals apart there is no picture of a contact, and there are no spots. */
TEST_IN_DIRECTORY(no_picture_beyond_a_bond_line)
{
    write_map(place, "in/a.csv", 1, 1);
    for (int held = 0; held < 2; held++) {
        run_scene(place, "out",
                  filled("material: copper\nnominal_area: 1 mm2\noperating_load: 10 N\ngap: {filler: silicone grease, "
                         "bond_line: %s um}\nsurfaces: [" MAP("a") "]\n",
                         held ? "50" : "0.001"));
        assert_int_equal(directory_has(place, "out/data/contact_spots.csv"), !held);
        assert_int_equal(strstr(directory_read(place, "out/report.md"), "of the points in contact, in") != NULL, !held);
    }
}

/** With `direction: y` the places of spots, and the axes of the picture, still are those of the map. */
TEST_IN_DIRECTORY(spots_of_columns)
{
    double at_m[2][2];
    write_map(place, "in/a.csv", 1, 1);
    for (int turned = 0; turned < 2; turned++) {
        run_scene(place, "out", filled("%sdirection: %s\nsurfaces: [" MAP("a") "]\n", MATERIAL, turned ? "y" : "x"));
        struct table spots = directory_table(place, "out/data/contact_spots.csv");
        size_t most = 0;
        for (size_t r = 0; r < spots.rows; r++)
            most = table_number(&spots, r, "load_N") > table_number(&spots, most, "load_N") ? r : most;
        at_m[turned][0] = table_number(&spots, most, "x_m");
        at_m[turned][1] = table_number(&spots, most, "y_m");
        expect_in_file(place, "out/figures/map-a.gp", turned ? "set xlabel 'y (µm)'" : "set xlabel 'x (µm)'");
    }
    for (int k = 0; k < 2; k++)
        assert_near(at_m[1][k], at_m[0][k], 1e-9);
}
