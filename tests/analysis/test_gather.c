/* From scans to one surface: averages, scans kept to run alone, the counterface, and what is said of a jump. */
#include "analysis/gather.h"
#include "support.h"

#include <stdio.h>
#include <unistd.h>

enum { POINTS = 64 };

static char place[64];
static struct scene scene;
static struct surface_record *record;

static int make(void **state)
{
    (void)state;
    strcpy(place, "/tmp/roughcontact-test-XXXXXX");
    assert_non_null(mkdtemp(place));
    scene = (struct scene){.directory = place,
                           .level = LEVEL_NONE,
                           .max_missing = 0.5,
                           .fit_band_m = {0, INFINITY},
                           .models = (UINT64_C(1) << model_count) - 1};
    record = calloc(1, sizeof *record);
    assert_non_null(record);
    return 0;
}

static int end(void **state)
{
    char path[128];
    (void)state;
    surface_record_free(record, true);
    free(record);
    snprintf(path, sizeof path, "%s/scan.csv", place);
    remove(path);
    assert_int_equal(rmdir(place), 0);
    return 0;
}

#define gather_test(test) cmocka_unit_test_setup_teardown(test, make, end)

/** Writes scan.csv: heights [m] at a spacing of `spacing_um`. */
static void write_scan(const double *height_m, size_t points, double spacing_um)
{
    char path[128];
    snprintf(path, sizeof path, "%s/scan.csv", place);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs("x [um],z [um]\n", file);
    for (size_t i = 0; i < points; i++)
        fprintf(file, "%.6f,%.12f\n", spacing_um * (double)i, height_m[i] * 1e6);
    assert_int_equal(fclose(file), 0);
}

/** Harmonics 3 and 7 of the record with this amplitude, and a step of `jump_m` between its ends. */
static void sine(double height_m[POINTS], double amplitude_m, double jump_m)
{
    for (int i = 0; i < POINTS; i++)
        height_m[i] = amplitude_m * (sin(2 * M_PI * 3 * i / POINTS) + 0.5 * cos(2 * M_PI * 7 * i / POINTS)) +
                      jump_m * i / (POINTS - 1);
}

static void add_scan(double amplitude_m, double jump_m, double spacing_um)
{
    static char name[] = "scan.csv";
    static char *files[] = {name};
    static struct scene_surface surface = {.name = name, .files = files, .file_count = 1};
    struct hash hash = hash_start();
    struct status status = {0};
    double height_m[POINTS];
    sine(height_m, amplitude_m, jump_m);
    write_scan(height_m, POINTS, spacing_um);
    if (gather_file(record, &scene, &surface, name, &hash, &status) != STATUS_OK)
        fail_msg("%s", status.message);
}

/* ---------------------------------------------------------------- averages */

/* Powers and moments are averaged, a jump as its root mean square; the first scan stands for the rest. */
static void test_the_mean_of_scans(void **state)
{
    (void)state;
    add_scan(1e-6, 0, 1);
    double first_jump_m = record->summary.jump_m, m2 = record->summary.roughness.m2;
    add_scan(2e-6, 3e-7, 1);
    add_scan(3e-6, 0, 1);
    struct surface_summary *s = &record->summary;
    assert_int_equal(s->scans, 3);
    assert_int_equal(s->points, POINTS);
    assert_near(s->length_m, POINTS * 1e-6, 1e-9);
    double square = (1 + 4 + 9) / 3.0;
    assert_near(record->spectrum.amplitude_m[2], 1e-6 * sqrt(square), 2e-2); /* the step leaks a little */
    assert_near(s->roughness.m2, m2 * square, 2e-2);
    double jumps[3]; /* cos(0) - cos(2 pi 7 63/64), and the sine's end */
    for (int k = 0; k < 3; k++) {
        double height_m[POINTS];
        sine(height_m, (k + 1) * 1e-6, k == 1 ? 3e-7 : 0);
        jumps[k] = height_m[POINTS - 1] - height_m[0];
    }
    assert_near(first_jump_m, fabs(jumps[0]), 1e-6);
    assert_near(s->jump_m, sqrt((jumps[0] * jumps[0] + jumps[1] * jumps[1] + jumps[2] * jumps[2]) / 3), 1e-6);
}

/* ---------------------------------------------------------------- scans kept to run alone */

/* Every one up to 24, then every second, every fourth: scan i has i + 1 times the height of the first. */
static void test_which_scans_are_kept(void **state)
{
    (void)state;
    static const struct {
        size_t scans, kept, stride;
    } expected[] = {{1, 1, 1},   {24, 24, 1}, {25, 13, 2}, {26, 13, 2},
                    {27, 14, 2}, {48, 24, 2}, {49, 13, 4}, {53, 14, 4}};
    size_t scans = 0;
    for (size_t e = 0; e < sizeof expected / sizeof *expected; e++) {
        for (; scans < expected[e].scans; scans++)
            add_scan(1e-8 * (double)(scans + 1), 0, 1);
        assert_int_equal(record->repeat_count, expected[e].kept);
        for (size_t p = 0; p < record->repeat_count; p++) {
            double height = 1e-8 * (double)(p * expected[e].stride + 1);
            assert_near(record->repeats[p].spectrum.amplitude_m[2], height, 1e-3);
            assert_near(record->repeats[p].roughness.rq_m, height * sqrt(0.5 + 0.125), 1e-3);
        }
    }
    assert_int_equal(record->summary.scans, 53);
}

static void test_one_scan_is_no_repeat(void **state)
{
    (void)state;
    struct status status = {0};
    add_scan(1e-6, 0, 1);
    assert_int_equal(gather_describe_repeats(record, &scene, &status), STATUS_OK);
    assert_int_equal(record->repeat_count, 0);
    assert_int_equal(record->summary.repeats.count, 0);
}

/* Scans of another length come to the grid of the mean: the shorter record, the lower Nyquist frequency. */
static void test_scans_of_another_length(void **state)
{
    (void)state;
    struct status status = {0};
    add_scan(1e-6, 0, 1);
    add_scan(1e-6, 0, 1.25);
    assert_int_equal(gather_describe_repeats(record, &scene, &status), STATUS_OK);
    assert_int_equal(record->repeat_count, 2);
    assert_int_equal(record->summary.repeats.count, 2);
    assert_near(record->summary.length_m, POINTS * 1e-6, 1e-9);
    for (int p = 0; p < 2; p++) {
        assert_int_equal(record->repeats[p].spectrum.count, record->spectrum.count);
        assert_near(record->repeats[p].spectrum.length_m, record->spectrum.length_m, 1e-9);
    }
    assert_int_equal(record->spectrum.count, 25); /* 0.4/um over 64 um, less the band beyond Nyquist's */
}

/* ---------------------------------------------------------------- counterface */

/* Powers and moments of both bodies add, also of the scans run alone. */
static void test_a_rough_counterface(void **state)
{
    (void)state;
    struct status status = {0};
    add_scan(3e-6, 0, 1);
    add_scan(3e-6, 0, 1);
    double other_m[POINTS / 2] = {0};
    struct surface_record *counterface = calloc(1, sizeof *counterface);
    assert_non_null(counterface);
    counterface->spectrum = (struct spectrum){other_m, POINTS / 2, POINTS * 1e-6, true};
    other_m[2] = 4e-6;
    counterface->summary.roughness = (struct roughness){4e-6, NAN, NAN, 16e-12, 0.5, 1e10};
    struct roughness own = record->summary.roughness;
    assert_int_equal(gather_counterface(record, counterface, &status), STATUS_OK);
    assert_near(record->spectrum.amplitude_m[2], 5e-6, 1e-6);
    assert_near(record->spectrum.amplitude_m[6], 1.5e-6, 1e-6);
    assert_near(record->summary.roughness.m2, own.m2 + 0.5, 1e-9);
    assert_near(record->summary.roughness.rq_m, sqrt(own.m0_m2 + 16e-12), 1e-9);
    for (int p = 0; p < 2; p++) {
        assert_near(record->repeats[p].spectrum.amplitude_m[2], 5e-6, 1e-6);
        assert_near(record->repeats[p].roughness.m2, own.m2 + 0.5, 1e-9);
    }
    assert_non_null(strstr(record->summary.notes, "Rq 2.372 um and 4 um give 4.65 um together"));
    free(counterface);
}

/* ---------------------------------------------------------------- the jump between the ends */

/** A power-law profile with a jump, described: is there a note, and which? */
static double jump_share(double exponent, double jump_m, enum spectrum_window window, char *note, size_t size)
{
    static char name[] = "scan.csv";
    static char *files[] = {name};
    static struct scene_surface surface = {.name = name, .files = files, .file_count = 1};
    struct status status = {0};
    double height_m[POINTS];
    for (int i = 0; i < POINTS; i++) {
        height_m[i] = jump_m * i / (POINTS - 1);
        for (int n = 1; n < POINTS / 2; n++)
            height_m[i] += 1e-6 * pow(n, -exponent) * cos(2 * M_PI * n * (double)i / POINTS + n * n);
    }
    write_scan(height_m, POINTS, 1);
    surface_record_free(record, true);
    *record = (struct surface_record){0};
    scene.window = window;
    assert_int_equal(surface_describe(record, &scene, &surface, NULL, &status), STATUS_OK);
    assert_true(record->summary.usable);
    const struct power_law *law = &record->summary.power_law;
    assert_near(record->summary.jump_m, fabs(height_m[POINTS - 1] - height_m[0]), 1e-6);
    const char *line = record->summary.notes ? strstr(record->summary.notes, "that jump alone leaks") : NULL;
    snprintf(note, size, "%.40s", line ? line : "");
    /* J/(pi n) at the shortest wavelength of the fit, over the law there */
    double shortest_m = 2e-6, n = POINTS * 1e-6 / shortest_m;
    assert_near(law->band_m[0], shortest_m, 1e-6);
    return record->summary.jump_m / (M_PI * n) / (law->alpha * pow(shortest_m, law->gamma));
}

static void test_the_note_on_a_jump(void **state)
{
    (void)state;
    static const double exponents[] = {1.2, 2.5}; /* shares from 0.1 to 0.8, and from 3 to 0.9 */
    size_t below[2] = {0}, above[2] = {0};
    char note[64];
    for (int e = 0; e < 2; e++)
        for (double jump_m = e ? 1e-7 : 5e-7; jump_m < (e ? 2e-6 : 2e-5); jump_m *= 1.04) {
            double share = jump_share(exponents[e], jump_m, SPECTRUM_WINDOW_NONE, note, sizeof note);
            assert_near(record->summary.jump_share, share, 1e-6);
            const char *expected = share > 1     ? "that jump alone leaks more than the whol"
                                   : share > 0.5 ? "that jump alone leaks over half of the f"
                                                 : "";
            assert_string_equal(note, expected);
            double border = e ? 1 : 0.5; /* it was met from either side */
            below[e] += share > 0.9 * border && share <= border;
            above[e] += share > border && share <= 1.1 * border;
        }
    assert_true(below[0] > 0 && above[0] > 0 && below[1] > 0 && above[1] > 0);
    jump_share(1.2, 1e-5, SPECTRUM_WINDOW_HANN, note, sizeof note);
    assert_near(record->summary.jump_share, 0, 0);
    assert_string_equal(note, "");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        gather_test(test_the_mean_of_scans),     gather_test(test_which_scans_are_kept),
        gather_test(test_one_scan_is_no_repeat), gather_test(test_scans_of_another_length),
        gather_test(test_a_rough_counterface),   gather_test(test_the_note_on_a_jump),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
