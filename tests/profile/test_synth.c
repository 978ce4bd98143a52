/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "profile/level.h"
#include "profile/profile.h"
#include "profile/synth.h"
#include "scan/scan.h"
#include "spectrum/power_law.h"
#include "support.h"

#include <stdio.h>

static double *make(const struct synth_def *def)
{
    double *height_m = support_room(def->points * sizeof *height_m);
    expect_ok(synth_profile, height_m, def);
    return height_m;
}

static double root_mean_square(const double *height_m, size_t points)
{
    long double sum = 0;
    for (size_t i = 0; i < points; i++)
        sum += (long double)height_m[i] * height_m[i];
    return (double)sqrtl(sum / (long double)points);
}

static struct spectrum spectrum_of(const double *height_m, const struct synth_def *def)
{
    struct spectrum spectrum;
    expect_ok(spectrum_compute, &spectrum, height_m, def->points, def->length_m / (double)def->points,
              SPECTRUM_WINDOW_NONE);
    return spectrum;
}

/* The law, its scatter and Rq come back from the spectrum and the fit in the band; levelling changes nothing. */
static void assert_comes_back(const struct synth_def *def)
{
    double *height_m = make(def), *levelled_m = make(def);
    struct spectrum spectrum = spectrum_of(height_m, def);
    const double band_m[2] = {def->lambda_s_m, INFINITY};
    struct power_law law = power_law_fit(&spectrum, band_m);
    assert_near(law.alpha, def->alpha, 1e-9);
    assert_within(law.gamma, def->gamma, 1e-9);
    /* the misfit's square is a difference of sums: without scatter its root has half the digits */
    assert_within(law.misfit_decades, def->scatter_decades, def->scatter_decades > 0 ? 1e-9 : 1e-7);
    double rq_m = root_mean_square(height_m, def->points);
    if (def->rq_m > 0)
        assert_near(rq_m, def->rq_m, 1e-9);
    struct levelling line;
    expect_ok(level_remove, &line, levelled_m, NULL, def->points, 1, LEVEL_LINE);
    for (size_t i = 0; i < def->points; i++)
        assert_within(levelled_m[i], height_m[i], 1e-12 * rq_m);
    spectrum_free(&spectrum);
}

TEST_CASE(test_the_law_comes_back)
{
    static const struct synth_def defs[] = {
        {.alpha = 0.085, .gamma = 1.5, .length_m = 3e-4, .points = 1200, .scatter_decades = 0.2785, .seed = 1},
        {.alpha = 0.085, .gamma = 1.5, .length_m = 3e-4, .points = 1201, .scatter_decades = 0.2785, .seed = 1},
        {.alpha = 0.085, .gamma = 1.5, .length_m = 3e-4, .points = 1200, .scatter_decades = 0, .seed = 2},
        {.alpha = 1e-4, .gamma = 0.7, .length_m = 1e-3, .points = 999, .scatter_decades = 0.1, .seed = 3},
        {.alpha = 50, .gamma = 2, .length_m = 1e-3, .points = 64, .scatter_decades = 0.5, .seed = 4294967295},
        {.alpha = 0.01, .gamma = 1, .length_m = 1e-3, .points = 16, .scatter_decades = 0.2, .seed = 0},
    };
    for (size_t i = 0; i < sizeof defs / sizeof *defs; i++)
        assert_comes_back(&defs[i]);
}

/* Above the cut-off every harmonic obeys the law; below it, the law times 2^(1 - (lambda_s/lambda)²). */
TEST_CASE(test_the_cut_off)
{
    struct synth_def def = synth_def_default();
    def.scatter_decades = 0;
    def.lambda_s_m = def.length_m / 40;
    double *height_m = make(&def);
    struct spectrum spectrum = spectrum_of(height_m, &def);
    for (size_t n = 1; n <= 80; n++) {
        double law_m = def.alpha * pow(def.length_m / (double)n, def.gamma), ratio = (double)n / 40;
        assert_near(spectrum.amplitude_m[n - 1], n <= 40 ? law_m : law_m * pow(2, 1 - ratio * ratio), 1e-10);
    }
    spectrum_free(&spectrum);
}

/* Scaling to an Rq multiplies all heights by the same factor. */
TEST_CASE(test_scaled_to_rq)
{
    static const double rq_m[] = {1e-12, 4e-7, 5e-6, 0.1};
    struct synth_def def = synth_def_default();
    double *height_m = make(&def);
    double as_made_m = root_mean_square(height_m, def.points);
    def.scaled = true;
    for (size_t i = 0; i < sizeof rq_m / sizeof *rq_m; i++) {
        def.rq_m = rq_m[i];
        double *scaled_m = make(&def);
        assert_near(root_mean_square(scaled_m, def.points), rq_m[i], 1e-12);
        for (size_t k = 0; k < def.points; k++)
            assert_within(scaled_m[k], height_m[k] * (rq_m[i] / as_made_m), 1e-10 * rq_m[i]);
    }
}

static void assert_refused(const struct synth_def *def, const char *words)
{
    double height_m[2000];
    expect_fails(STATUS_USAGE, words, synth_profile, height_m, def);
}

TEST_CASE(test_what_cannot_be_made_is_refused)
{
    static const struct {
        size_t member;
        double values[4];
        size_t count;
        const char *words;
    } rows[] = {
        {offsetof(struct synth_def, alpha), {0, -1, NAN, INFINITY}, 4, "must be positive"},
        {offsetof(struct synth_def, length_m), {0, -1, NAN, INFINITY}, 4, "must be positive"},
        {offsetof(struct synth_def, rq_m), {-1, NAN}, 2, "not negative"},
        {offsetof(struct synth_def, scatter_decades), {-1, NAN}, 2, "not negative"},
        {offsetof(struct synth_def, lambda_s_m), {-1, NAN}, 2, "not negative"},
        {offsetof(struct synth_def, scatter_decades), {2.01}, 1, "at most 2 decades"},
        {offsetof(struct synth_def, rq_m), {1}, 1, "gives an Rq of 1 m (it can reach"}, /* a metre of roughness */
        {offsetof(struct synth_def, rq_m), {1, 1e-15}, 2, "change --length"},
        {offsetof(struct synth_def, lambda_s_m),
         {3e-4 / 5},
         1,
         "only 5 harmonics, scatter needs 6; give more points, a shorter --lambda-s or --scatter 0"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (size_t k = 0; k < rows[i].count; k++) {
            struct synth_def def = synth_def_default();
            *(double *)((char *)&def + rows[i].member) = rows[i].values[k];
            assert_refused(&def, rows[i].words);
        }
    struct synth_def def = synth_def_default();
    def.scaled = true;
    def.rq_m = 1e31;
    assert_refused(&def, "Rq would be above");
    for (int k = 0; k < 2; k++) {
        def = synth_def_default();
        def.points = k ? 7 : 100000001;
        assert_refused(&def, "--points must be 8 to 100000000");
    }
}

/* Reads a line of surfaces/make.sh; returns the file that it makes. */
static const char *parse_synth_line(char *line, struct synth_def *def)
{
    const struct {
        const char *option;
        double *number;
    } options[] = {{"--lambda-s", &def->lambda_s_m}, {"--rq", &def->rq_m},     {"--length", &def->length_m},
                   {"--alpha", &def->alpha},         {"--gamma", &def->gamma}, {"--scatter", &def->scatter_decades}};
    const char *file = NULL;
    *def = synth_def_default();
    strtok(line, " \n");
    for (const char *option; (option = strtok(NULL, " \n"));) {
        char *value = strtok(NULL, " \n"), *unit;
        assert_non_null(value);
        double number = strtod(value, &unit);
        for (size_t i = 0; i < sizeof options / sizeof *options; i++)
            if (strcmp(option, options[i].option) == 0)
                *options[i].number = number * (*unit ? scan_unit_m(unit) : 1);
        if (strcmp(option, "--seed") == 0)
            def->seed = (unsigned long)number;
        else if (strcmp(option, "--points") == 0)
            def->points = (size_t)number;
        else if (strcmp(option, "-o") == 0)
            file = value;
    }
    assert_non_null(file);
    return file;
}

static void assert_file_holds(const char *file, const struct synth_def *def)
{
    struct scan scan;
    struct scan_options options = {.x_unit = "", .z_unit = ""};
    expect_ok(scan_read, &scan, filled("%s/surfaces/%s", PROJECT_SOURCE, file), &options);
    double *height_m = make(def);
    assert_int_equal(scan.nx, def->points);
    assert_near(scan.dx_m, def->length_m / (double)def->points, 1e-9);
    for (size_t i = 0; i < def->points; i++)
        assert_within(scan.z_m[i], height_m[i], 2e-12);
    scan_free(&scan);
}

/* The sample scans are those of surfaces/make.sh, to the picometre with which they are printed. */
TEST_CASE(test_the_sample_surfaces_are_what_make_sh_makes)
{
    char line[1024];
    size_t files = 0;
    FILE *script = fopen(PROJECT_SOURCE "/surfaces/make.sh", "r");
    assert_non_null(script);
    while (fgets(line, sizeof line, script)) {
        if (strncmp(line, "synth -", 7) != 0 || strstr(line, "--map")) /* of random heights */
            continue;
        struct synth_def def;
        const char *file = parse_synth_line(line, &def);
        assert_file_holds(file, &def);
        assert_comes_back(&def);
        files++;
    }
    fclose(script);
    assert_true(files >= 9);
}
