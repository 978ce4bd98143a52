/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Power law, window and levelling of periodic records and of records cut out of longer ones. */
#include "run/pipeline.h"

#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <jansson.h>

enum { POINTS = 2048 };
static const double gamma_made = 1.4, alpha_made = 0.05;

/* A law without scatter, Delta_n = alpha lambda^gamma at random phases, tilted: `points` of a record `longer` times as
 * long, which are periodic only if that is 1. */
static void write_law(const struct directory *place, const char *name, size_t points, size_t longer, double tilt,
                      unsigned long seed)
{
    size_t all = points * longer;
    struct synth_def def = synth_def_default();
    def.points = all;
    def.length_m = 5e-7 * (double)all;
    def.alpha = alpha_made;
    def.gamma = gamma_made;
    def.scatter_decades = 0;
    def.seed = seed;
    double *height_m = support_room(all * sizeof *height_m);
    expect_ok(synth_profile, height_m, &def);
    double *part_m = height_m + (longer > 1 ? all / 3 : 0);
    for (size_t i = 0; i < points; i++)
        part_m[i] += tilt * 5e-7 * (double)i;
    pipeline_scan(place, name, part_m, points);
}

/* A value of a surface in place/OUT/results.json; NULL: none. */
static const json_t *said(const struct directory *place, const char *out, const char *name, const char *key)
{
    const json_t *surfaces = json_object_get(directory_json(place, filled("%s/results.json", out)), "surfaces");
    size_t i = 0;
    while (strcmp(json_string_value(json_at(json_array_get(surfaces, i), "surface")), name) != 0)
        i++;
    return json_object_get(json_array_get(surfaces, i), key);
}

static double number(const struct directory *place, const char *out, const char *name, const char *key)
{
    const json_t *value = said(place, out, name, key);
    return json_is_number(value) ? json_number_value(value) : NAN;
}

static void expect_class(const struct directory *place, const char *out, const char *name, const char *expected)
{
    const char *class = json_string_value(json_object_get(said(place, out, name, "fit"), "class"));
    if (strcmp(class, expected) != 0)
        fail_msg("%s: '%s'", name, class);
}

/* gamma is that which was made, within three of its errors. */
static void expect_gamma_made(const struct directory *place, const char *out, const char *name)
{
    assert_within(number(place, out, name, "gamma"), gamma_made, 3 * number(place, out, name, "gamma_stderr"));
}

/* Both a periodic record and a tilted one cut out of a longer surface give the law they were made with, within the
 * stated errors. The line through every harmonic of the cut record without window does not. */
TEST_CASE(test_the_law_made_is_found)
{
    const struct directory *place = *state;
    write_law(place, "law/periodic.csv", POINTS, 1, 0, 3);
    write_law(place, "law/cut.csv", POINTS, 8, 0.01, 4);
    write_law(place, "thesis/cut.csv", POINTS, 8, 0.01, 4);
    pipeline_report(place, "law", "law-out", "material: tin\neffects: [electrical]\n");
    pipeline_report(place, "thesis", "thesis-out",
                    "material: tin\neffects: [electrical]\nfit: thesis\nwindow: none\nlevel: line\n");
    static const char *const names[] = {"periodic", "cut"}, out[] = "law-out";
    for (size_t s = 0; s < 2; s++) {
        const char *name = names[s];
        expect_class(*state, out, name, "law");
        expect_gamma_made(*state, out, name);
        double gamma = number(place, out, name, "gamma"), error = number(place, out, name, "gamma_stderr"),
               wavelength_m = number(place, out, name, "fit_wavelength_m"),
               amplitude_m = number(place, out, name, "fit_amplitude_m");
        assert_true(error > 0.005 && error < 0.06);
        /* cut to 1/8 of the length, harmonics are 8 times fewer and carry the power of 8 */
        double made_m = alpha_made * pow(wavelength_m, gamma_made) * (s == 1 ? sqrt(8) : 1);
        assert_within(log10(amplitude_m / made_m), 0, 3 * number(place, out, name, "fit_amplitude_stderr_decades"));
        assert_near(number(place, out, name, "alpha_SI"), amplitude_m / pow(wavelength_m, gamma), 1e-9);
        assert_near(number(place, out, name, "fit_psd_m3"),
                    amplitude_m * amplitude_m * number(place, out, name, "scan_length_m") / 2, 1e-12);
        assert_near(wavelength_m, sqrt(number(place, out, name, "fit_low_m") * number(place, out, name, "fit_high_m")),
                    1e-9);
        assert_int_equal(number(place, out, name, "scans_periodic"), s == 0);
        assert_int_equal(number(place, out, name, "scans_windowed"), s == 1);
    }
    assert_int_equal(number(place, "thesis-out", "cut", "scans_windowed"), 0);
    assert_true(number(place, "thesis-out", "cut", "gamma") < gamma_made - 0.1);
    expect_in_file(place, "thesis-out/results.json", "\"method\": \"thesis\"");
    expect_in_file(place, "thesis-out/report.md", "the line through all wavelengths", "| rms (decades) |");
    expect_no_parts(directory_read(place, "law-out/report.md"), "the line through all wavelengths", "rms (decades)");
}

/* Only the mean is removed from a periodic record, so that its amplitudes stay; a line is removed if the scene asks for
 * it. */
TEST_IN_PLACE(test_levelling_of_a_periodic_record)
{
    double height_m[POINTS];
    for (size_t i = 0; i < POINTS; i++) /* a sine: its line has a slope */
        height_m[i] = 1e-6 * sin(2 * M_PI * (double)i / POINTS) + 3e-6;
    pipeline_scan(place, "mean/a.csv", height_m, POINTS);
    pipeline_scan(place, "line/a.csv", height_m, POINTS);
    assert_int_equal(pipeline_run(place, "mean", "mean-out", 1), 0);
    pipeline_report(place, "line", "line-out", "material: tin\nlevel: line\n");
    assert_near(number(place, "mean-out", "a", "rq_m"), 1e-6 / sqrt(2), 1e-9);
    assert_near(number(place, "line-out", "a", "rq_m"), 1e-6 * sqrt(0.5 - 6 / (M_PI * M_PI * 2)),
                1e-2); /* 1/2 - 12 (1/2pi)² */
}

/* The report says which scans had a window. */
TEST_IN_PLACE(test_the_report_names_windows)
{
    write_law(place, "three/a-1.csv", 512, 1, 0, 1);
    write_law(place, "three/a-2.csv", 512, 1, 0, 2);
    write_law(place, "three/a-3.csv", 512, 8, 0.02, 3);
    pipeline_report(place, "three", "three-out",
                    "material: tin\nsurfaces: [{name: a, file: [a-1.csv, a-2.csv, a-3.csv]}]\n");
    expect_in_file(place, "three-out/report.md", "Periodic: 2 of 3 scans.\nThe others have a Hann window.");
    expect_no_parts(directory_read(place, "three-out/report.md"), "Scans along");
    pipeline_report(place, "three", "along-out",
                    "material: tin\nsurfaces: [{name: a, file: [a-1.csv, a-3.csv], along: a-2.csv}]\n");
    expect_in_file(place, "along-out/report.md", "Periodic: 1 of 2 scans.", "Scans along a lay are not counted here.");
    expect_gamma_made(place, "three-out", "a");
    assert_true(number(place, "three-out", "a", "gamma_stderr") < 0.04); /* one alone: 0.044 */
}

/* `window: hann`: amplitudes are scaled so that power is right on average over records, not for this record. */
TEST_IN_PLACE(test_a_window_by_name)
{
    double height_m[POINTS];
    for (size_t i = 0; i < POINTS; i++)
        height_m[i] = 1e-6 * cos(2 * M_PI * 32 * (double)i / POINTS);
    pipeline_scan(place, "hann/a.csv", height_m, POINTS);
    pipeline_report(place, "hann", "hann-out", "material: tin\nwindow: hann\n");
    struct table table = directory_table(place, "hann-out/data/spectrum.csv");
    assert_near(table_number(&table, 31, "amplitude_m"), 1e-6 * sqrt(2.0 / 3), 1e-5);
    assert_near(table_number(&table, 30, "amplitude_m"), 1e-6 * sqrt(1.0 / 6), 1e-5);
}

/* Spectra that follow no power law have none; the run goes on, and they are not extrapolated. */
TEST_IN_PLACE(test_no_law)
{
    double height_m[POINTS];
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    for (size_t i = 0; i < POINTS; i++)
        height_m[i] = 1e-7 * gsl_ran_gaussian(random, 1);
    pipeline_scan(place, "none/white.csv", height_m, POINTS);
    gsl_rng_free(random);
    for (size_t i = 0; i < POINTS; i++)
        height_m[i] = i == 700 ? 1e-6 : 0;
    pipeline_scan(place, "none/constant.csv", height_m, POINTS); /* a spike: every harmonic alike */
    for (size_t i = 0; i < POINTS; i++)
        height_m[i] = 1e-6 * cos(2 * M_PI * 20 * (double)i / POINTS);
    pipeline_scan(place, "none/one-harmonic.csv", height_m, POINTS);
    pipeline_scan(place, "none/eleven-points.csv",
                  (const double[]){0, 1e-7, 3e-7, 2e-7, 5e-7, 1e-7, 0, 2e-7, 4e-7, 1e-7, 3e-7}, 11);
    for (size_t i = 0; i < POINTS; i++) { /* a comb */
        height_m[i] = 0;
        for (int n = 8; n < POINTS / 2; n *= 2)
            height_m[i] += 1e-6 / n * cos(2 * M_PI * n * (double)i / POINTS + n);
    }
    pipeline_scan(place, "none/all-lines.csv", height_m, POINTS);
    pipeline_report(place, "none", "none-out",
                    "material: tin\neffects: [electrical, convergence]\nconvergence: {scales: 64}\n");
    static const char *const names[] = {"white", "constant", "one-harmonic", "eleven-points", "all-lines"};
    for (size_t s = 0; s < sizeof names / sizeof *names; s++) {
        expect_class(place, "none-out", names[s], "no power law found");
        assert_true(isnan(number(place, "none-out", names[s], "gamma")) &&
                    isnan(number(place, "none-out", names[s], "fit_low_m")));
    }
    expect_in_file(place, "none-out/report.md", "no power law found",
                   "No power law of a decade was found on 5 surfaces.",
                   "On 5 of 5 surfaces the spectrum does not tell γ");
    expect_not_in_file(place, "none-out/report.md", "No surface's γ is below 1", "would lower the area by at most");
    struct table table = directory_table(place, "none-out/data/spectrum.csv");
    assert_string_equal(table_text(&table, 0, "fit_m"), "");
}

/* A law over less than a decade is printed, marked as narrow, and not extrapolated. */
TEST_IN_PLACE(test_a_narrow_law)
{
    write_law(place, "narrow/a.csv", POINTS, 1, 0, 5);
    write_law(place, "narrow/b.csv", POINTS, 1, 0, 5);
    pipeline_report(
        place, "narrow", "narrow-out",
        "material: tin\neffects: [electrical, convergence]\nconvergence: {scales: 64}\nfit_band_m: [5e-6, 4e-5]\n");
    expect_class(place, "narrow-out", "a", "narrow");
    assert_true(number(place, "narrow-out", "a", "fit_low_m") >= 5e-6 &&
                number(place, "narrow-out", "a", "fit_high_m") <= 4e-5);
    expect_gamma_made(place, "narrow-out", "a");
    expect_in_file(place, "narrow-out/report.md", " (narrow) | ", "No power law of a decade was found on 2 surfaces.",
                   "αλᵞ at the middle of each band");
}

/* Heights to the picometre of a law that an instrument has cut off at 8 um, so that shorter waves are rounding only.
 * The spectrum is extrapolated from 8 um if the scene says so; otherwise the filter's flank is not used. */
TEST_IN_PLACE(test_what_lies_below_a_cut_off)
{
    static const char scene[] = "material: tin\nmodels: [multiscale]\neffects: [convergence]\nfit: thesis\n"
                                "convergence: {scales: 64, load: 1e-6}\n";
    enum { HEIGHTS = 1200 };
    struct synth_def def = synth_def_default();
    struct text *csv = support_text();
    double height_m[HEIGHTS];
    def.lambda_s_m = 8e-6;
    def.gamma = 0.7;
    def.alpha *= pow(1e-5, 0.8);
    def.scatter_decades = 0.02;
    expect_ok(synth_profile, height_m, &def);
    text_add(csv, "x [um],z [um]\n");
    for (size_t i = 0; i < HEIGHTS; i++)
        text_add(csv, "%g,%.6f\n", 0.25 * (double)i, height_m[i] * 1e6);
    directory_write(place, "cut/a.csv", text_string(csv));
    pipeline_report(place, "cut", "cut-out", scene);
    char *report = directory_read(place, "cut-out/report.md");
    expect_parts(report, "The spectrum does not tell γ at short wavelengths, nor what lies below.");
    expect_no_parts(report, "would lower the area by at most", "γ is below 1: there the area depends");
    pipeline_report(place, "cut", "cut-out", filled("%sfit_band: [8 um, 1 mm]\n", scene));
    report = directory_read(place, "cut-out/report.md");
    expect_parts(report, "γ is below 1: there the area depends");
    const char *found = strstr(report, "would lower the area by at most ");
    assert_non_null(found);
    assert_true(strtod(found + strlen("would lower the area by at most "), NULL) > 1);
}

/* Copies of one row in a map add nothing: the errors must not shrink with their number. */
TEST_IN_PLACE(test_rows_of_a_map)
{
    enum { ROWS = 40, ROW = 256 };
    struct synth_def def = synth_def_default();
    def.points = ROW;
    def.length_m = 5e-7 * ROW;
    double height_m[ROW], independent[2], error[2];
    for (int same = 0; same < 2; same++) {
        struct text *xyz = support_text();
        text_add(xyz, "x [um],y [um],z [um]\n");
        for (unsigned long y = 0; y < ROWS; y++) {
            def.seed = same ? 1 : y + 1;
            expect_ok(synth_profile, height_m, &def);
            for (size_t x = 0; x < ROW; x++)
                text_add(xyz, "%g,%g,%.9f\n", 0.5 * (double)x, 0.5 * (double)y, height_m[x] * 1e6);
        }
        directory_write(place, "map/a.csv", text_string(xyz));
        directory_write(place, "map/scene.yaml", "models: [multiscale]\n");
        assert_int_equal(pipeline_run(place, "map", "map-out", 1), 0);
        assert_int_equal(number(place, "map-out", "a", "scans"), ROWS);
        independent[same] = number(place, "map-out", "a", "scans_independent");
        error[same] = number(place, "map-out", "a", "gamma_stderr");
    }
    assert_true(independent[0] > 8 && independent[0] <= 16);
    assert_near(independent[1], 1, 0);
    assert_true(error[1] > 1.5 * error[0]);
}

/* Against a rough counterface the law is that of both together. */
TEST_IN_PLACE(test_the_counterface_is_in_the_law)
{
    double height_m[POINTS];
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    for (size_t i = 0; i < POINTS; i++)
        height_m[i] = 1e-11 * gsl_ran_gaussian(random, 1);
    gsl_rng_free(random);
    pipeline_scan(place, "pair/smooth.csv", height_m, POINTS);
    write_law(place, "pair/rough.csv", POINTS, 1, 0, 3);
    pipeline_report(
        place, "pair", "pair-out",
        "models: [multiscale]\ncounterface: {surface: rough.csv}\nsurfaces: [{name: smooth, file: smooth.csv}]\n");
    expect_class(place, "pair-out", "smooth", "law");
    expect_gamma_made(place, "pair-out", "smooth");
}

/* The thesis's line gives the same law for one scan and for ten. */
TEST_IN_PLACE(test_the_thesis_line_of_ten_scans)
{
    struct synth_def def = synth_def_default();
    def.points = 1000;
    def.length_m = 5e-7 * 1000;
    def.alpha = alpha_made;
    def.gamma = gamma_made;
    for (def.seed = 1; def.seed <= 10; def.seed++)
        pipeline_synth(place, filled("thesis/a-%lu.csv", def.seed), &def);
    for (int ten = 0; ten < 2; ten++) {
        const char *out = ten ? "ten" : "one";
        pipeline_report(
            place, "thesis", out,
            filled(
                "models: [multiscale]\nfit: thesis\nwindow: none\nlevel: mean\nsurfaces: [{name: a, file: \"%s\"}]\n",
                ten ? "a-*.csv" : "a-3.csv"));
        assert_near(number(place, out, "a", "alpha_SI"), alpha_made, 0.002);
        assert_within(number(place, out, "a", "gamma"), gamma_made, 2e-4);
    }
    /* and one scan still scatters about it as the thesis's table has it */
    assert_within(number(place, "one", "a", "fit_misfit_decades"), def.scatter_decades, 1e-3);
}

/* The thesis's four surfaces without a given cut-off: gamma is right within two of its errors, which are small enough
 * to be useful. */
TEST_IN_PLACE(test_scattered_amplitudes_still_have_a_line)
{
    static const double gamma[] = {1.6, 1.5, 1.4, 1.0};
    for (int s = 0; s < 4; s++) {
        struct text *csv = support_text();
        expect_ok(text_read_file, csv, filled(PROJECT_SOURCE "/surfaces/chapter6/surface-%d.csv", s + 1));
        directory_write(place, filled("chapter6/%d.csv", s + 1), text_string(csv));
    }
    pipeline_report(place, "chapter6", "chapter6-out", "models: [multiscale]\n");
    for (int s = 0; s < 4; s++) {
        const char *name = filled("%d", s + 1);
        double error = number(place, "chapter6-out", name, "gamma_stderr");
        assert_true(error <= 0.35);
        assert_within(number(place, "chapter6-out", name, "gamma"), gamma[s], 2 * error);
        expect_class(place, "chapter6-out", name, s < 3 ? "scattered" : "law");
        if (s < 3)
            assert_within(number(place, "chapter6-out", name, "fit_misfit_decades"), 0.37, 0.06);
        if (s < 2) /* the cut-off is found */
            assert_within(number(place, "chapter6-out", name, "fit_low_m"), 8e-6, 1e-6);
    }
    expect_in_file(place, "chapter6-out/report.md", "(scattered: rms 0.33 decades)");
}

TEST_GROUP(directory_setup, directory_teardown)
