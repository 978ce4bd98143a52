/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What `inspect` finds in the real scans, compared with independently computed figures (reference.json). */
#include "cli/inspection.h"
#include "cli/process.h"
#include "scan/scan_support.h"

/* Units that reference.json assumes for the files that name none. */
static const struct {
    const char *file, *x_unit, *z_unit;
} units[] = {
    {"WAAM Profile.txt", "um", "um"},
    {"dektakxt_opdx-3.txt", "m", "m"},
    {"nanovea_st400_test1.txt", "mm", "um"},
    {"stylus_nounits_xy-4.txt", "mm", "mm"},
};

/* The power laws that the estimator's documentation reports for these scans. */
static const struct {
    const char *file;
    enum power_law_band_class found;
    double gamma, shortest_m, longest_m; /* to the digits printed there */
} laws[] = {
    {"nist_asme_sine.xml", POWER_LAW_BAND_NONE, NAN, NAN, NAN},
    {"alicona_al3d-1.al3d", POWER_LAW_BAND_NONE, NAN, NAN, NAN},
    {"dabam-013.dat", POWER_LAW_BAND_NONE, NAN, NAN, NAN},
    {"stylus_nounits_xy-4.txt", POWER_LAW_BAND_LAW, 1.92, 2e-6, 124e-6},
    {"mitutoyo_sj_2.csv", POWER_LAW_BAND_NARROW, 1.99, 7.96e-6, 39.8e-6},
    {"npl_edm.prf", POWER_LAW_BAND_NARROW, 1.15, 11.2e-6, 56e-6},
    /* printed with enough digits to see the digitiser's 12.9 nm under the tilt, which spoil the shortest waves */
    {"nist_npl_edm.xml", POWER_LAW_BAND_NARROW, 1.08, 14.1e-6, 56e-6},
    {"mahr_gd25_m1.prf", POWER_LAW_BAND_NARROW, 0.55, 2.23e-6, 22.3e-6},
    {"WAAM Profile.txt", POWER_LAW_BAND_NARROW, 0.65, 6.33e-3, 49.4e-3},
    {"dektak_stylus.csv", POWER_LAW_BAND_NARROW, 1.54, 79e-6, 300e-6},
    {"digitalsurf_sur-2.sur", POWER_LAW_BAND_NARROW, 1.10, 7e-6, 24e-6},
};

static void check_law(const char *file, const struct power_law *law)
{
    for (size_t i = 0; i < sizeof laws / sizeof *laws; i++) {
        if (strcmp(file, laws[i].file) != 0)
            continue;
        assert_int_equal(law->found, laws[i].found);
        if (law->found == POWER_LAW_BAND_NONE)
            continue;
        assert_within(law->gamma, laws[i].gamma, 0.01);
        assert_near(law->band_m[0], laws[i].shortest_m, 0.02);
        assert_near(law->band_m[1], laws[i].longest_m, 0.02);
    }
}

static struct inspection find(const char *file, const struct profile_options *options)
{
    const char *path = lasting("%s/%s", REAL_SCANS, file);
    struct scan_options known = no_units;
    for (size_t u = 0; u < sizeof units / sizeof *units; u++)
        if (strcmp(file, units[u].file) == 0)
            known = (struct scan_options){.x_unit = units[u].x_unit, .z_unit = units[u].z_unit};
    struct inspection inspection;
    struct text *text = support_text();
    expect_ok(text_read_file, text, path);
    const struct scan_bytes bytes = {text->data, text->length, path};
    expect_ok(inspection_make, &inspection, &bytes, &known, options);
    return inspection;
}

/* A figure of an inspection and of reference.json, which has it in micrometres: times `to_si`. */
struct figure {
    double found;
    const char *key;
    double to_si, rtol;
};

static void check_figures(const struct figure *figures, size_t count, const json_t *expected)
{
    for (const struct figure *figure = figures; figure < figures + count; figure++) {
        double value = json_number_at(expected, figure->key) * figure->to_si;
        support_near(figure->found, value, figure->rtol, 0, figure->key, __FILE__, __LINE__);
    }
}
#define CHECK_FIGURES(expected, ...)                                                                                   \
    check_figures((const struct figure[]){__VA_ARGS__},                                                                \
                  sizeof((const struct figure[]){__VA_ARGS__}) / sizeof(struct figure), (expected))

static void check_map(const struct inspection *f, const json_t *expected)
{
    assert_int_equal(f->scan.kind, SCAN_AREAL);
    assert_within(f->areal.surface.ssk, json_number_at(expected, "Ssk"), 1e-6);
    CHECK_FIGURES(expected, {(double)f->scan.nx, "nx", 1, 0}, {(double)f->scan.ny, "ny", 1, 0},
                  {(double)f->scan.missing, "nmiss", 1, 0}, {f->scan.dx_m, "dx_um", 1e-6, 1e-12},
                  {f->scan.dy_m, "dy_um", 1e-6, 1e-12}, {f->areal.surface.sq_m, "Sq_um", 1e-6, 1e-9},
                  {f->areal.surface.sa_m, "Sa_um", 1e-6, 1e-9}, {f->areal.surface.sz_m, "Sz_um", 1e-6, 1e-9},
                  {f->areal.surface.sku, "Sku", 1, 1e-6}, {f->roughness.rq_m, "Rq_rows_um", 1e-6, 1e-9},
                  {f->roughness.m2, "M2x_rows", 1, 1e-6}, {f->roughness.m4_per_m2, "M4x_rows_um_2", 1e12, 1e-6});
}

static void check_profile(const struct inspection *f, const json_t *expected)
{
    assert_int_equal(f->scan.kind, SCAN_PROFILE);
    CHECK_FIGURES(expected, {(double)f->scan.nx, "n", 1, 0}, {(double)f->scan.missing, "nmiss", 1, 0},
                  {f->spacing_m, "dx_mean_um", 1e-6, 1e-12}, {f->length_m, "len_um", 1e-6, 1e-12},
                  {f->roughness.rq_m, "Rq_um", 1e-6, 1e-9}, {f->roughness.ra_m, "Ra_um", 1e-6, 1e-9},
                  {f->roughness.pv_m, "PV_um", 1e-6, 1e-9}, {f->roughness.m2, "M2c", 1, 1e-6},
                  {f->roughness.m4_per_m2, "M4_um_2", 1e12, 1e-6});
    if (!f->profile.measured_x_m) /* the parameters are of the uniform profile */
        CHECK_FIGURES(expected, {parameter_named(&f->primary, "sk"), "Sk", 1, 1e-6},
                      {parameter_named(&f->primary, "ku"), "Ku", 1, 1e-9},
                      {pow(parameter_named(&f->primary, "dq"), 2), "M2_7", 1, 2e-6});
}

/* What the instrument itself printed, of the record without its run-up and overtravel; Rq of all points, as read. */
static void check_instrument(const char *file, json_t *entry)
{
    json_t *printed = json_object_get(entry, "instrument"), *uniform = json_object_get(entry, "as_uniform");
    struct profile_options options = profile_defaults;
    options.lambda_s_m = json_number_at(printed, "lambda_s_um") * 1e-6;
    options.lambda_c_m = json_number_at(printed, "lambda_c_um") * 1e-6;
    struct inspection f = find(file, &options);
    assert_near(parameter_named(&f.filtered, "a"), json_number_at(printed, "Ra_um") * 1e-6, 1e-3);
    assert_near(parameter_named(&f.filtered, "q"), json_number_at(printed, "Rq_um") * 1e-6, 3e-3);
    assert_near(parameter_named(&f.filtered, "z"), json_number_at(printed, "Rz_um") * 1e-6, 3e-3);
    assert_int_equal(f.filtered.sampling_lengths, 3);
    assert_int_equal(f.scan.nx, (size_t)json_number_at(uniform, "points"));
    assert_near(f.scan.dx_m, json_number_at(uniform, "dx_um") * 1e-6, 1e-9);
    inspection_free(&f);
    struct scan scan;
    struct profile whole;
    expect_ok(scan_read, &scan, filled("%s/%s", REAL_SCANS, file), &no_units);
    assert_near(scan.margin_m[0], 0.4e-3, 1e-9);
    assert_near(scan.margin_m[1], 0.4e-3, 1e-9);
    memset(scan.margin_m, 0, sizeof scan.margin_m);
    expect_ok(profile_make, &whole, &scan, 0, &profile_defaults);
    assert_near(roughness_of_heights(whole.height_m, whole.points, whole.spacing_m).rq_m,
                json_number_at(uniform, "Rq_um") * 1e-6, 1e-9);
    profile_free(&whole);
    scan_free(&scan);
}

/* Positions that are rounded: the reference's "as_uniform"; all others, the truly uneven ones too: "actual_x". */
TEST_CASE(test_every_reference_figure)
{
    NEED_REAL_SCANS();
    json_t *all = directory_json(REAL_SCANS, "reference.json"), *entry;
    const char *file;
    assert_true(json_object_size(all) >= 24);
    json_object_foreach (all, file, entry) {
        print_message("%s\n", file);
        if (json_object_get(entry, "instrument")) {
            check_instrument(file, entry);
            continue;
        }
        struct inspection inspection = find(file, &profile_defaults);
        json_t *map = json_object_get(entry, "areal"), *uniform = json_object_get(entry, "as_uniform");
        if (map)
            check_map(&inspection, map);
        else
            check_profile(&inspection,
                          uniform && !inspection.profile.measured_x_m ? uniform : json_object_get(entry, "actual_x"));
        check_law(file, &inspection.power_law);
        inspection_free(&inspection);
    }
}

/* With lambda_c there are R parameters beside those of the profile before. */
TEST_CASE(test_roughness_profile)
{
    NEED_REAL_SCANS();
    struct profile_options options = profile_defaults;
    struct inspection without = find("nist_npl_edm.xml", &options);
    options.lambda_c_m = 8e-4;
    struct inspection with = find("nist_npl_edm.xml", &options);
    assert_false(without.has_filtered);
    assert_true(with.has_filtered);
    assert_int_equal(with.filtered.sampling_lengths, 6); /* and half of one at either end */
    assert_memory_equal(with.primary.value, without.primary.value, sizeof with.primary.value);
    assert_true(parameter_named(&with.filtered, "q") < parameter_named(&with.primary, "q"));
    json_auto_t *object = inspection_json("nist_npl_edm.xml", &with);
    CHECK_FIGURES(object, {8e-4, "parameters.lambda_c_m", 1, 1e-12}, {0.55994e-6, "parameters.Pq", 1, 1e-5},
                  {parameter_named(&with.filtered, "q"), "parameters.Rq", 1, 0});
    assert_true(json_is_null(json_at(object, "parameters.lambda_s_m")));
    assert_string_equal(json_text_at(object, "parameters.slope"), "7-point");
    inspection_free(&without);
    inspection_free(&with);
}

static json_t *inspect_first(struct process process)
{
    json_t *all = support_json(process.out);
    assert_int_equal(json_array_size(all), 1);
    return json_array_get(all, 0);
}

/* A map of 6 x 4 heights, of which the plane leaves (-1)^(x + y) um: its text to the byte, and its JSON. */
TEST_IN_WORKSPACE(test_a_map)
{
    workspace_write(place, "map.txt",
                    "pixel size = 2 um\n1 -1 1 -1 1 -1\n-1 1 -1 1 -1 1\n1 -1 1 -1 1 -1\n-1 1 -1 1 -1 1\n");
    struct process process = expect_exit(place, 0, "inspect", "--z-unit", "um", "map.txt");
    assert_string_equal(process.out, "map.txt\n"
                                     "  format      text, x in um, z in um\n"
                                     "  points      6 x 4, spacing 2 um x 2 um, 0 missing\n"
                                     "  plane out   Sq 1 um, Sa 1 um, Sz 2 um, Ssk 0, Sku 1, Sdq 0; below: rows, each "
                                     "over its line\n"
                                     "  all points  Rq 0.956183 um, Ra 0.914286 um, peak to valley 2.51429 um\n"
                                     "  moments     m2 0.00734694, m4 1 /um2\n"
                                     "  to paste    sigma_asp 1 um, m_asp 0 (of two rough sides the "
                                     "root of the sum of squares)\n"
                                     "  power law   - (no power law found)\n"
                                     "  note        only 6 points in a row; a report needs 11\n");
    json_t *map = inspect_first(expect_exit(place, 0, "inspect", "--json", "--z-unit", "um", "map.txt"));
    assert_string_equal(json_text_at(map, "kind"), "areal");
    CHECK_FIGURES(map, {24, "points", 1, 0}, {6, "nx", 1, 0}, {4, "ny", 1, 0}, {2e-6, "dx_m", 1, 1e-12},
                  {2e-6, "dy_m", 1, 1e-12}, {1e-6, "sq_m", 1, 0.02}, {2e-6, "sz_m", 1, 0.1},
                  {1e12, "m4_per_m2", 1, 1e-9}); /* (4 um/(2 um)²)² */
    assert_null(json_object_get(map, "parameters"));
}

/* Points and length are those that the numbers are of, without ends that were left out. */
TEST_IN_WORKSPACE(test_points_without_the_ends)
{
    struct text *scan = support_text();
    text_add(scan, "spacing 2 um\nunit: um\n");
    for (int i = 0; i < 100; i++)
        text_add(scan, i < 3 || i == 50 ? "NaN\n" : "%d\n", i * i % 7);
    workspace_write(place, "a.txt", text_string(scan));
    expect_output(expect_exit(place, 0, "inspect", "a.txt"),
                  "  points      97, spacing 2 um (uniform), length 0.192 mm");
    json_t *of = inspect_first(expect_exit(place, 0, "inspect", "--json", "a.txt"));
    CHECK_FIGURES(of, {97, "points", 1, 0}, {192e-6, "length_m", 1, 1e-12});
}

/* Waves of 32 and 4 points along both directions: Sq² = .5² + .1², of which the low-pass at 6 leaves the long ones.
 * Long ones alone are left as they are, and nothing is said. */
TEST_IN_WORKSPACE(test_what_a_low_pass_takes)
{
    for (int noisy = 0; noisy < 2; noisy++) {
        struct text *map = support_text();
        text_add(map, "pixel size = 1 um\n");
        for (int k = 0; k < 64 * 64; k++) {
            double x = 2 * M_PI * (k % 64 + 0.5), y = 2 * M_PI * (k / 64 + 0.5);
            double z = cos(x / 32) * cos(y / 32) + noisy * 0.2 * cos(x / 4) * cos(y / 4);
            text_add(map, "%.9f%s", z, k % 64 == 63 ? "\n" : " ");
        }
        workspace_write(place, "map.txt", text_string(map));
        struct process process = expect_exit(place, 0, "inspect", "--z-unit", "um", "map.txt");
        json_t *of = inspect_first(expect_exit(place, 0, "inspect", "--json", "--z-unit", "um", "map.txt"));
        const double slopes = 0.5 * sin(M_PI / 16), fast = 0.1 * noisy; /* each in both directions */
        assert_near(json_number_at(of, "sdq"), hypot(slopes, fast) * M_SQRT2, 0.02);
        assert_near(json_number_at(of, "sq_m"), hypot(0.5, 0.1 * noisy) * 1e-6, 1e-6);
        assert_int_equal(strstr(process.out, "Sq 0.51 → 0.476 um, slope 0.2 → 0.13") != NULL, noisy);
        assert_int_equal(strstr(process.out, "low-pass") != NULL, noisy);
        expect_output(process, noisy ? "sigma_asp 0.476" : "sigma_asp 0.5 um, m_asp 0.079"); /* sqrt(2/pi) Sdq/sqrt 2 */
        assert_near(json_number_at(of, "mean_slope"), (noisy ? 0.13 : 0.1386) / sqrt(M_PI), 0.05); /* what is left */
    }
}

TEST_IN_WORKSPACE(test_the_text_of_a_profile)
{
    run_to_exit(place, 0, "synth", "-n", "300", "-o", "p.csv");
    struct process process = expect_exit(place, 0, "inspect", "--lambda-c", "80um", "p.csv");
    assert_string_equal(
        process.out, "p.csv\n"
                     "  format      text, x in um, z in um\n"
                     "  points      300, spacing 1 um (uniform), length 0.299 mm, periodic\n"
                     "  parameters  Pa 0.17826 Pq 0.19496 Pp 0.41121 Pv 0.28598 Pz 0.6972\n"
                     "              Pt 0.6972 Psk 0.22413 Pku 1.6848 Pdq 0.018759 Psm -\n"
                     "              lengths in um, over 0.3 mm, slope 7-point\n"
                     "  parameters  Ra 0.054325 Rq 0.065465 Rp 0.14363 Rv 0.12002 Rz 0.26365\n"
                     "              Rt 0.31709 Rsk 0.34101 Rku 2.3256 Rdq 0.017724 Rsm 37.814\n"
                     "              lengths in um, over 0.24 mm from 0.03 mm on, sampling lengths: 3, slope 7-point\n"
                     "  all points  Rq 0.0633857 um, Ra 0.0510933 um, peak to valley 0.317094 um\n"
                     "  moments     m2 0.000261124, m4 0.000217982 /um2\n"
                     "  to paste    sigma_asp 0.0633857 um, m_asp 0.0128933 (of two rough sides the root of the sum "
                     "of squares)\n"
                     "  power law   gamma 1.628 +- 0.097 from 2.01 to 18.8 um (narrow), misfit 0.03 decades\n"
                     "              rms amplitude 0.001925 um x/: 1.08 at 6.14 um, C 5.56e-22 m3\n"
                     "  note        gaussian high-pass lambda_c = 80 um (ISO 16610-21; its end goes on at its "
                     "beginning)\n");
    json_t *of = inspect_first(expect_exit(place, 0, "inspect", "--json", "--lambda-c", "80um", "p.csv"));
    CHECK_FIGURES(of, {0.0128933, "mean_slope", 1, 1e-5}, {1.628, "gamma", 1, 1e-3}, {0.097, "gamma_stderr", 1, 0.01},
                  {1.925e-9, "fit_amplitude_m", 1, 1e-3}, {2.01e-6, "fit_low_m", 1, 5e-3},
                  {18.8e-6, "fit_high_m", 1, 5e-3}, {0.03, "fit_misfit_decades", 1, 0.05},
                  {5.56e-22, "fit_psd_m3", 1, 1e-2});
    assert_string_equal(json_text_at(of, "fit"), "narrow");
    assert_string_equal(json_text_at(of, "positions"), "uniform");
}

TEST_IN_WORKSPACE(test_options)
{
    workspace_scan(place, "a.csv", 2000, 1);
    json_t *raw = inspect_first(expect_exit(place, 0, "inspect", "--json", "a.csv"));
    json_t *smooth = inspect_first(expect_exit(place, 0, "inspect", "--json", "--lambda-s", "8e-6", "a.csv"));
    assert_true(json_number_at(smooth, "m4_per_m2") < json_number_at(raw, "m4_per_m2"));
    assert_near(json_number_at(smooth, "parameters.lambda_s_m"), 8e-6, 0);
    expect_output(expect_exit(place, 0, "inspect", "a.csv"), "parameters  Pa ");
    struct process metres =
        expect_exit(place, 0, "inspect", "--json", "--lambda-s=8e-6", "--lambda-c", "8e-5", "a.csv");
    static const char *const spelled[][2] = {{"--lambda-s=8um", "80um"}, {"--lambda-s=8 um", "0.08mm"}};
    for (size_t i = 0; i < 2; i++) {
        struct process same =
            expect_exit(place, 0, "inspect", "--json", spelled[i][0], "--lambda-c", spelled[i][1], "a.csv");
        assert_string_equal(same.out, metres.out);
    }
    expect_failure(place, 2, 3, "--lambda-s must be a length such as 0.31mm, not '8 N'", "inspect", "--lambda-s", "8 N",
                   "a.csv");
    expect_failure(place, 2, 3, "--lambda-c is not above --lambda-s", "inspect", "--lambda-s", "8e-6", "--lambda-c",
                   "8e-6", "a.csv");
    expect_failure(place, 4, 1, "a.csv: lambda_c is 1 m, longer than the scan", "inspect", "--lambda-c", "1", "a.csv");
}

/* Runs `inspect` with a file as standard input. */
static struct process inspect_input(const char *place, const char *words)
{
    const char *command = lasting("exec '" PROGRAM "' inspect %s", words);
    return run_program(place, "/bin/sh", "-c", command);
}

/* - is standard input, plain or packed; it says what it says of the file. */
TEST_IN_WORKSPACE(test_standard_input)
{
    workspace_scan(place, "d/a.csv", 400, 1);
    const char *const gzip[] = {"gzip", "-k", "d/a.csv", NULL};
    run_list(place, gzip);
    struct process file = expect_exit(place, 0, "inspect", "--json", "d/a.csv");
    expect_part(file.out, "\"file\": \"d/a.csv\"");
    static const char *const inputs[] = {"--json - <d/a.csv", "--json - <d/a.csv.gz"};
    for (size_t i = 0; i < 2; i++) {
        struct process input = expect_status(inspect_input(place, inputs[i]), 0);
        expect_part(input.out, "\"file\": \"-\"");
        assert_string_equal(strstr(input.out, "\"format\""), strstr(file.out, "\"format\"")); /* all but "file" */
    }
    workspace_write(place, "bad.csv", "hello\n");
    struct process bad = expect_status(inspect_input(place, "--json - <bad.csv"), 4);
    expect_output(bad, "\"error\": \"-: no line of numbers in it: not a scan; where columns");
    workspace_folder(place, "empty");
    expect_failure(place, 4, 1, "no scan in 'empty'", "inspect", "empty");
    expect_failed(inspect_input(place, "- </dev/null"), 4, 1, "-: the file is empty");
    expect_failed(inspect_input(place, "- <d"), 4, 1, "cannot read '-': Is a directory");
    expect_failed(inspect_input(place, "- <&-"), 4, 1, "cannot read '-': ");
}

/* The scans of a directory and of its folders, as `inspect` of each says it. */
TEST_IN_WORKSPACE(test_a_directory)
{
    workspace_scan(place, "d/a.csv", 400, 1);
    workspace_scan(place, "d/s/b.csv", 500, 2);
    workspace_write(place, "d/notes.txt", "nothing\n");
    struct process all = expect_exit(place, 0, "inspect", "d");
    struct process one = expect_exit(place, 0, "inspect", "d/a.csv", "d/s/b.csv");
    assert_string_equal(all.out, one.out);
    expect_part(all.err, "passed over, no scan: 1 x text without a row of numbers (notes.txt)");
    assert_string_equal(one.err, "");
    workspace_write(place, "d/bad.csv", "nothing\n");
    expect_output(expect_exit(place, 1, "inspect", "--json", "d"), "\"file\": \"d/s/b.csv\"",
                  "no line of numbers in it: not a scan");
    /* by its scene: scans along the lay, the counterface, and as many missing points as a report takes */
    workspace_write(place, "d/c.csv", "x [um];z [um]\n0;1\n1;2\n2;1.5\n3;\n4;2\n5;1\n");
    workspace_write(place, "d/scene.yaml",
                    "material: tin\nmax_missing: 20 %\nsurfaces: [{name: s, file: a.csv, along: s/b.csv}]\n"
                    "counterface: {surface: c.csv, material: tin}\n");
    expect_output(expect_exit(place, 0, "inspect", "--json", "d"), "\"file\": \"d/a.csv\"", "\"file\": \"d/s/b.csv\"",
                  "\"file\": \"d/c.csv\"");
}
