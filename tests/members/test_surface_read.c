/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From scans to a surface: averages, members, their laws, the counterface. */
#include "directory.h"
#include "members/ensemble.h"
#include "members/surface_read.h"
#include "profile/synth.h"
#include "spectrum/simulated_record.h"
#include "statistics/interval.h"

enum { POINTS = 64 };

static struct directory place;
static struct scene scene;
static struct surface_record *record;
static struct power_law_scans scans;

static int make(void **state)
{
    (void)state;
    place = directory_make();
    scene = (struct scene){.directory = place.path,
                           .level = LEVEL_NONE,
                           .level_given = true,
                           .max_missing = 0.5,
                           .window = SPECTRUM_WINDOW_NONE,
                           .fit = POWER_LAW_THESIS,
                           .fit_band_m = {0, INFINITY},
                           .models = (UINT64_C(1) << model_count) - 1};
    record = support_room(sizeof *record);
    return 0;
}

static void start_anew(void)
{
    surface_record_free(record);
    power_law_scans_free(&scans);
    *record = (struct surface_record){0};
}

static int end(void **state)
{
    (void)state;
    start_anew();
    directory_remove(&place);
    return 0;
}

/** Writes a scan: heights [m] at a spacing of `spacing_um`. */
static void write_scan(const char *name, const double *height_m, size_t points, double spacing_um)
{
    struct text *csv = support_text();
    text_add(csv, "x [um],z [um]\n");
    for (size_t i = 0; i < points; i++)
        text_add(csv, "%.6f,%.12f\n", spacing_um * (double)i, height_m[i] * 1e6);
    directory_write(&place, name, text_string(csv));
}

/** Harmonics 3 and 7 of POINTS with this amplitude, and a step of `jump_m` between its ends. */
static void sine(double *height_m, size_t points, double amplitude_m, double jump_m)
{
    for (size_t i = 0; i < points; i++) {
        double x = 2 * M_PI * (double)i / POINTS;
        height_m[i] = amplitude_m * (sin(3 * x) + 0.5 * cos(7 * x)) + jump_m * (double)i / ((double)points - 1);
    }
}

static char first_name[] = "first.csv", second_name[] = "second.csv", scan_name[] = "scan.csv", map_name[] = "map.grd";

static void gather(char *name)
{
    struct scene_surface surface = {.name = name, .files = {&name, 1}};
    struct hash hash = hash_start();
    if (strcmp(name, map_name) == 0)
        snprintf(surface.x_unit, sizeof surface.x_unit, "m"), snprintf(surface.z_unit, sizeof surface.z_unit, "m");
    struct copies apart = {0}; /* equal scans are no copies here */
    const struct surface_scans task = {record, &scans, &scene, &apart};
    record->summary.scene = &surface;
    expect_ok(surface_files_read, &task, &hash);
    record->summary.scene = NULL;
    copies_free(&apart);
}

static void add_long_scan(size_t points, double amplitude_m, double jump_m, double spacing_um)
{
    double *height_m = support_room(points * sizeof *height_m);
    sine(height_m, points, amplitude_m, jump_m);
    size_t before = record->ensemble.scan_count;
    char *name = before == 0 ? first_name : before == 1 ? second_name : scan_name;
    write_scan(name, height_m, points, spacing_um);
    gather(name);
}

static void add_scan(double amplitude_m, double jump_m, double spacing_um)
{
    add_long_scan(POINTS, amplitude_m, jump_m, spacing_um);
}

/** All files are there. */
static void conclude(void)
{
    expect_ok(surface_read_members, record, &scans, &scene);
    record->ensemble.sigma_m = sqrt(record->summary.roughness.m0_m2);
    expect_ok(repeats_compare, &record->summary.repeats, &record->ensemble, &record->spectrum);
}

/** A line each; good until the next call. */
static const char *all_notes(void)
{
    static char lines[8192];
    struct text *text = support_text();
    struct words *words = support_words();
    for (size_t n = 0; n < record->summary.notes.count; n++) {
        note_line(text, words, &record->summary.notes.notes[n]);
        text_add(text, "\n");
    }
    snprintf(lines, sizeof lines, "%s", text_string(text));
    return lines;
}

static bool has_note(const char *words)
{
    return strstr(all_notes(), words) != NULL;
}

#define PLACED(name) TEST_WITH(name, make, end)

/* Powers and moments are averaged; the first scan stands for the rest. */
PLACED(test_the_mean_of_scans)
{
    add_scan(1e-6, 0, 1);
    double m2 = record->summary.roughness.m2;
    add_scan(2e-6, 3e-7, 1);
    add_scan(3e-6, 0, 1);
    struct surface_summary *s = &record->summary;
    assert_int_equal(s->scans, 3);
    assert_int_equal(s->points, POINTS);
    assert_near(s->length_m, POINTS * 1e-6, 1e-9);
    double square = (1 + 4 + 9) / 3.0;
    assert_near(record->spectrum.amplitude_m[2], 1e-6 * sqrt(square), 2e-2); /* the step leaks a little */
    assert_near(s->roughness.m2, m2 * square, 2e-2);
}

/* Every one of the profiles, in their order and with its heights. */
PLACED(test_which_scans_are_kept)
{
    enum { MANY = 53 };
    const struct ensemble *set = &record->ensemble;
    for (size_t i = 0; i < MANY; i++)
        add_scan(1e-8 * (double)(i + 1), 0, 1);
    conclude();
    assert_int_equal(record->summary.scans, MANY);
    assert_int_equal(set->count, MANY);
    assert_int_equal(set->scan_count, MANY);
    for (size_t p = 0; p < set->count; p++) {
        double height = 1e-8 * (double)(p + 1);
        assert_int_equal(set->members[p].scan, p);
        assert_near(set->members[p].spectrum.amplitude_m[2], height, 1e-3);
        assert_near(set->members[p].roughness.rq_m, height * sqrt(0.5 + 0.125), 1e-3);
        assert_null(set->members[p].height_m); /* once concluded */
        assert_near(set->scan_weight[p], 1, 0);
    }
    assert_int_equal(record->summary.repeats.count, MANY);
    assert_int_equal(record->summary.repeats.cut, 0);
    double mean = 0; /* the geometric one of what they have alone */
    for (int i = 1; i <= MANY; i++)
        mean += log(1e-8 * i * sqrt(0.5 + 0.125)) / MANY;
    assert_near(record->summary.repeats.rq_m.mean, mean, 1e-5);
}

/** A map of `rows`, row r with the amplitude r + 1 nanometres. */
static void add_map(size_t rows)
{
    struct text *grid = support_text();
    double height_m[POINTS];
    text_add(grid, "DSAA\n%d %zu\n0 %g\n0 %g\n-1 1\n", POINTS, rows, 1e-6 * (POINTS - 1), 1e-6 * (double)(rows - 1));
    for (size_t row = 0; row < rows; row++) {
        sine(height_m, POINTS, 1e-9 * (double)(row + 1), 0);
        for (int i = 0; i < POINTS; i++)
            text_add(grid, "%.12g ", height_m[i]);
        text_add(grid, "\n");
    }
    directory_write(&place, map_name, text_string(grid));
    gather(map_name);
}

/* Up to 24 rows of a map are all members; of more, 24 evenly spaced ones. Rows have no interval. */
PLACED(test_which_rows_are_kept)
{
    static const size_t rows[] = {5, 24, 25, 47, 200};
    for (int m = 0; m < 5; m++) {
        start_anew();
        add_map(rows[m]);
        conclude();
        size_t kept = rows[m] < STRIPS_PIECES ? rows[m] : STRIPS_PIECES;
        assert_int_equal(record->summary.scans, rows[m]);
        assert_int_equal(record->ensemble.count, kept);
        assert_int_equal(record->ensemble.scan_count, 1);
        for (size_t p = 0; p < kept; p++) { /* row r, from 1 on, next to the middle of its part of the map */
            double row = record->ensemble.members[p].spectrum.amplitude_m[2] / 1e-9;
            double middle = ((double)p + 0.5) * (double)rows[m] / (double)kept + 0.5;
            assert_true(fabs(row - middle) < 1.01 && row > 0.99 && row < (double)rows[m] + 0.01);
        }
        assert_true(isnan(record->summary.repeats.rq_m.s));
        assert_int_equal(has_note("24 of them, evenly spaced, go through the models"), rows[m] > 24);
    }
}

/* A single scan has no members. Its heights are kept if records like it are wanted and can be simulated, which 15
 * points do not allow; with `fit: auto` as with `fit: thesis`. */
PLACED(test_one_scan_is_no_repeat)
{
    for (int tried = 0; tried < 8; tried++) {
        bool listed = tried & 1, brief = tried & 2, kept = listed && !brief;
        scene.effects = listed ? EFFECT_BIT(EFFECT_UNCERTAINTY) : 0;
        scene.fit = tried & 4 ? POWER_LAW_AUTO : POWER_LAW_THESIS;
        start_anew();
        add_long_scan(brief ? SIMULATED_RECORD_LEAST_POINTS - 1 : POINTS, 1e-6, 0, 1);
        assert_int_equal(scans.scan_count, scene.fit == POWER_LAW_AUTO);
        conclude();
        assert_int_equal(record->ensemble.count, 0);
        assert_int_equal(record->summary.repeats.count, 0);
        assert_int_equal(record->height_m != NULL, kept);
        assert_int_equal(record->summary.single_points, kept ? POINTS : 0);
    }
}

PLACED(test_scans_that_differ_are_not_one)
{
    scene.fit = POWER_LAW_AUTO;
    add_scan(1e-6, 0, 1);
    add_scan(1e-6, 0, 1);
    add_scan(1e-6 + 1e-10, 0, 1);
    conclude();
    assert_int_equal(record->ensemble.count, 3);
    assert_near(scans.independent, 3, 0);
}

/* Scans of another length are interpolated to the wavelengths of the mean: the shorter record, the lower Nyquist
 * frequency. */
PLACED(test_scans_of_another_length)
{
    add_scan(1e-6, 0, 1);
    add_scan(1e-6, 0, 1.25);
    conclude();
    assert_int_equal(record->ensemble.count, 2);
    assert_int_equal(record->summary.repeats.count, 2);
    assert_int_equal(record->summary.repeats.cut, 2);
    assert_int_equal(record->ensemble.members[1].points, 51); /* 64 um of the 80, in steps of 1.25 */
    assert_near(record->summary.length_m, POINTS * 1e-6, 1e-9);
    for (int p = 0; p < 2; p++) {
        assert_int_equal(record->ensemble.members[p].spectrum.count, record->spectrum.count);
        assert_near(record->ensemble.members[p].spectrum.length_m, record->spectrum.length_m, 1e-9);
    }
    assert_int_equal(record->spectrum.count, 25); /* 0.4/um over 64 um, less the band beyond Nyquist's */
}

/* Longer scans are cut to pieces as long as the shortest, spread from end to end; a scan weighs by its pieces. Pieces
 * of a periodic scan are periodic if they hold whole waves; else they get a window. */
PLACED(test_scans_are_cut_to_the_shortest)
{
    static const size_t points[] = {2 * POINTS, POINTS, 2 * POINTS + POINTS / 2}, of[] = {0, 0, 1, 2, 2};
    static const size_t first[] = {0, POINTS, 0, 0, POINTS + POINTS / 2};
    const struct ensemble *set = &record->ensemble;
    scene.window = SPECTRUM_WINDOW_AUTO;
    for (int s = 0; s < 3; s++)
        add_long_scan(points[s], 1e-6 * (s + 1), 0, 1);
    conclude();
    assert_int_equal(set->scan_count, 3);
    assert_int_equal(set->count, 5);
    assert_int_equal(record->summary.repeats.cut, 5);
    for (size_t p = 0; p < 5; p++) {
        double height_m[3 * POINTS];
        struct ensemble alone = {.count = 0};
        const struct record_conditioning how = record_conditioning_of(&scene, of[p] < 2);
        sine(height_m, points[of[p]], 1e-6 * (double)(of[p] + 1), 0);
        expect_ok(ensemble_add, &alone, 0, &(struct record_heights){height_m + first[p], POINTS, 1e-6}, &how);
        struct spectrum expected = alone.members[0].spectrum;
        assert_int_equal(set->members[p].scan, of[p]);
        assert_int_equal(set->members[p].points, POINTS);
        assert_near(set->members[p].roughness.rq_m, alone.members[0].roughness.rq_m, 1e-5);
        assert_near(set->members[p].spectrum.amplitude_m[2], expected.amplitude_m[2], 1e-5);
        assert_within(set->members[p].spectrum.amplitude_m[3], expected.amplitude_m[3], 1e-11);
        assert_int_equal(expected.amplitude_m[3] < 1e-9, of[p] < 2); /* a window spreads the third harmonic */
        ensemble_free(&alone);
    }
    assert_near(set->scan_weight[0], 2, 0);
    assert_near(set->scan_weight[1], 1, 0);
    assert_near(set->scan_weight[2], 2, 0);
    double log_rq =
        2 * log(1) + log(2) + 2 * log(3); /* every piece has its scan's, nearly: of half waves a little more */
    assert_near(exp(record->summary.repeats.rq_m.mean), 1e-6 * sqrt(0.5 + 0.125) * exp(log_rq / 5), 1e-2);
    assert_near(record->summary.repeats.rq_m.effective, 5, 1e-12);
    assert_near(record->summary.repeats.rq_m.degrees, 2, 0);
}

enum { LAWS = 3, LAW_POINTS = 1024 };
static const double made_gamma[LAWS] = {1.2, 1.35, 1.5};

/** A law without scatter, at random phases. */
static void make_law(double *height_m, int which, size_t points)
{
    struct synth_def def = synth_def_default();
    def.points = points;
    def.length_m = 1e-6 * (double)points;
    def.gamma = made_gamma[which];
    def.alpha = 1e-7 * pow(1e-5, -def.gamma); /* 0.1 um at 10 um */
    def.scatter_decades = 0;
    def.seed = 11 + (unsigned long)which;
    expect_ok(synth_profile, height_m, &def);
}

/** Describes the surface of the three scans, scan i of points[i], listed in this order. */
static void describe_laws(const size_t points[LAWS], const int order[LAWS])
{
    static char names[LAWS][8] = {"a.csv", "b.csv", "c.csv"};
    char *files[LAWS];
    struct scene_surface surface = {.name = scan_name, .files = {files, LAWS}};
    double height_m[2 * LAW_POINTS];
    for (int i = 0; i < LAWS; i++) {
        make_law(height_m, i, points[i]);
        write_scan(names[i], height_m, points[i], 1);
        files[i] = names[order[i]];
    }
    start_anew();
    expect_ok(surface_read, record, &scene, &surface, NULL);
    assert_true(record->summary.usable);
    record->summary.scene = NULL;
}

/** Weighted mean, and t(2) = 4.302653 standard errors about it. */
static void assert_estimate(const struct estimate *estimate, const double value[LAWS], const double weight[LAWS],
                            double rtol)
{
    double sum = 0, weights = 0, square = 0;
    for (int i = 0; i < LAWS; i++) {
        sum += weight[i] * value[i];
        weights += weight[i];
    }
    double mean = sum / weights;
    for (int i = 0; i < LAWS; i++)
        square += weight[i] * pow(value[i] - mean, 2);
    assert_int_equal(estimate->count, LAWS);
    assert_near(estimate->mean, mean, rtol);
    assert_near(estimate->degrees, LAWS - 1, 0);
    assert_near(estimate->half_width, 4.302652729911275 * sqrt(square / (LAWS - 1) / weights), rtol);
}

static const double alike[LAWS] = {1, 1, 1};
static const size_t one_length[LAWS] = {LAW_POINTS, LAW_POINTS, LAW_POINTS};
static const int in_order[LAWS] = {0, 1, 2};

/** The laws of the three scans in the band of their mean, found here from the multitaper spectra. */
static void find_laws(double gamma[LAWS], double log_psd[LAWS], const size_t points[LAWS])
{
    struct power_law_scans own = {0};
    struct power_law_band mean, alone;
    double height_m[2 * LAW_POINTS];
    for (int i = 0; i < LAWS; i++) {
        make_law(height_m, i, points[i]);
        expect_ok(power_law_scans_add, &own, height_m, points[i], 1e-6, 0);
        power_law_scans_end_file(&own, 1, false);
    }
    power_law_scans_fit(&mean, &own, 0, NULL);
    assert_int_equal(mean.law, POWER_LAW_BAND_LAW);
    assert_near(record->summary.power_law.gamma, mean.fit.gamma, 1e-6);
    for (int i = 0; i < LAWS; i++) {
        power_law_scans_fit_alone(&alone, &own, (size_t)i, 0, &mean);
        gamma[i] = alone.fit.gamma;
        log_psd[i] = log(alone.psd_m3);
        assert_within(gamma[i], made_gamma[i], 0.05);
    }
    power_law_scans_free(&own);
}

/* With fit: auto, the law of every scan in the band that their mean has. */
PLACED(test_each_scans_law_in_the_band_found)
{
    double gamma[LAWS], log_psd[LAWS];
    scene.fit = POWER_LAW_AUTO;
    describe_laws(one_length, in_order);
    find_laws(gamma, log_psd, one_length);
    assert_estimate(&record->summary.repeats.gamma, gamma, alike, 1e-5);
    assert_estimate(&record->summary.repeats.psd_m3, log_psd, alike, 1e-5);
    assert_true(record->tapered.count > 0);
    assert_near(record->summary.independent, LAWS, 0);
}

/** Noise ends the band at a knee. The bias that this may give the law widens its interval, however many scans there
 * are.
 */
PLACED(test_a_knee_widens_the_laws_interval)
{
    static char names[LAWS][8] = {"a.csv", "b.csv", "c.csv"};
    char *files[LAWS] = {names[0], names[1], names[2]};
    struct scene_surface surface = {.name = scan_name, .files = {files, LAWS}};
    double height_m[LAW_POINTS];
    uint64_t seed = 1;
    for (int i = 0; i < LAWS; i++) {
        make_law(height_m, i, LAW_POINTS);
        for (size_t k = 0; k < LAW_POINTS; k++)
            height_m[k] += 3e-6 * (2 * support_uniform(&seed) - 1);
        write_scan(names[i], height_m, LAW_POINTS, 1);
    }
    scene.fit = POWER_LAW_AUTO;
    expect_ok(surface_read, record, &scene, &surface, NULL);
    record->summary.scene = NULL;
    const struct estimate *gamma = &record->summary.repeats.gamma, *psd = &record->summary.repeats.psd_m3;
    const struct power_law_band_fit *found = &record->band->fit;
    assert_true(found->gamma_bias_s >= 0.04 && found->log10_amplitude_bias_s >= 0.02);
    assert_near(gamma->model_sd, found->gamma_bias_s, 0);
    assert_near(psd->model_sd, 2 * log(10) * found->log10_amplitude_bias_s, 1e-15);
    assert_true(estimate_end(gamma, 1) - gamma->mean > 1.96 * hypot(gamma->s, gamma->model_sd));
}

/* A scan twice as long has one law and two pieces: it weighs twice. */
PLACED(test_the_law_of_a_longer_scan)
{
    static const size_t points[LAWS] = {LAW_POINTS, 2 * LAW_POINTS, LAW_POINTS};
    static const double weight[LAWS] = {1, 2, 1};
    double gamma[LAWS], log_psd[LAWS];
    scene.fit = POWER_LAW_AUTO;
    describe_laws(points, in_order);
    assert_int_equal(record->ensemble.count, 4);
    find_laws(gamma, log_psd, points);
    assert_estimate(&record->summary.repeats.gamma, gamma, weight, 1e-5);
    assert_estimate(&record->summary.repeats.psd_m3, log_psd, weight, 1e-5);
}

/* The order in which files are listed changes no bit of the results. */
PLACED(test_the_order_of_the_files)
{
    static const size_t points[LAWS] = {LAW_POINTS, 2 * LAW_POINTS, LAW_POINTS};
    static const int other[LAWS] = {2, 0, 1};
    for (int fit = 0; fit < POWER_LAW_METHOD_COUNT; fit++) {
        scene.fit = (enum power_law_method)fit;
        describe_laws(points, in_order);
        struct surface_summary first = record->summary;
        const struct repeats apart = record->summary.repeats;
        struct spectrum spectrum;
        expect_ok(spectrum_copy, &spectrum, &record->spectrum);
        describe_laws(points, other);
        assert_string_equal(record->summary.hash, first.hash);
        assert_memory_equal(record->spectrum.amplitude_m, spectrum.amplitude_m, spectrum.count * sizeof(double));
        assert_near(record->summary.power_law.gamma, first.power_law.gamma, 0);
        assert_near(record->summary.repeats.rq_m.half_width, apart.rq_m.half_width, 0);
        if (fit == POWER_LAW_AUTO) {
            assert_near(record->summary.repeats.gamma.mean, apart.gamma.mean, 0);
            assert_near(record->summary.repeats.psd_m3.half_width, apart.psd_m3.half_width, 0);
        }
        spectrum_free(&spectrum);
    }
}

/* Powers and moments of both bodies add, also for the members. */
PLACED(test_a_rough_counterface)
{
    for (int p = 0; p < 3; p++)
        add_scan(3e-6, 0, 1);
    double other_m[POINTS / 2] = {0}, alone_m[2][POINTS / 2] = {{0}};
    struct member alone[2] = {{.scan = 0, .roughness.m2 = 0.3}, {.scan = 1, .roughness.m2 = 0.7}};
    struct surface_record *counterface = support_room(sizeof *counterface);
    counterface->spectrum = (struct spectrum){other_m, POINTS / 2, POINTS * 1e-6, true};
    other_m[2] = 4e-6;
    for (int p = 0; p < 2; p++) {
        alone_m[p][2] = p ? 1.25e-6 : 4e-6;
        alone[p].spectrum = (struct spectrum){alone_m[p], POINTS / 2, POINTS * 1e-6, true};
    }
    counterface->ensemble = (struct ensemble){.members = alone, .count = 2, .scan_count = 2};
    counterface->summary.roughness = (struct roughness){4e-6, NAN, NAN, 16e-12, 0.5, 1e10, 0, 0};
    struct roughness own = record->summary.roughness;
    expect_ok(surface_read_counterface, record, &scans, counterface);
    assert_near(record->spectrum.amplitude_m[2], 5e-6, 1e-6);
    assert_near(record->spectrum.amplitude_m[6], 1.5e-6, 1e-6);
    assert_near(record->summary.roughness.m2, own.m2 + 0.5, 1e-9);
    assert_near(record->summary.roughness.rq_m, sqrt(own.m0_m2 + 16e-12), 1e-9);
    assert_int_equal(record->ensemble.count, 2); /* scan with scan; the third has no partner */
    for (int p = 0; p < 2; p++) {
        assert_near(record->ensemble.members[p].spectrum.amplitude_m[2], p ? 3.25e-6 : 5e-6, 1e-9);
        assert_near(record->ensemble.members[p].roughness.m2, own.m2 + (p ? 0.7 : 0.3), 1e-9);
    }
    assert_non_null(strstr(all_notes(), "Rq 2.372 um and 4 um give 4.65 um together"));
    counterface->ensemble.count = 1; /* one scan of the other: the surface is one scan */
    expect_ok(surface_read_counterface, record, &scans, counterface);
    assert_int_equal(record->ensemble.count, 0);
}
