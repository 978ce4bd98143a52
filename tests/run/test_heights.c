/* Surfaces whose heights are not Gaussian, through the whole program: where contacting slopes runs, what the first page
 * says, and the normal-probability plot. */
#include "run/pipeline.h"

#include <gsl/gsl_cdf.h>

enum { POINTS = 600 };

/** Heights of many waves, phases from a fixed sequence; `plateau`: nothing above the level. */
static void heights(double height_m[POINTS], bool plateau, uint32_t seed)
{
    memset(height_m, 0, POINTS * sizeof *height_m);
    for (int n = 10; n < 100; n++) {
        seed = seed * UINT32_C(1664525) + UINT32_C(1013904223);
        for (size_t i = 0; i < POINTS; i++)
            height_m[i] += 1e-8 * cos(2 * M_PI * (n * (double)i / POINTS + seed / 4294967296.0));
    }
    for (size_t i = 0; plateau && i < POINTS; i++)
        height_m[i] = height_m[i] < 0 ? height_m[i] : 0.05 * height_m[i];
}

static void write_scene(const struct directory *place, const char *in, const char *more)
{
    char path[64];
    struct text text = {0};
    text_add(
        &text,
        "material: tin\nlevel: none\neffects: [separation, electrical]\nload: {from: 1e-6, to: 1e-2, points: 9}\n%s",
        more);
    snprintf(path, sizeof path, "%s/scene.yaml", in);
    directory_write(place, path, text_string(&text));
    text_free(&text);
}

/** Two near-Gaussian surfaces and a plateau in place/in; eight points more in place/short. */
static int place_setup(void **state)
{
    static struct directory place;
    double height_m[POINTS];
    place = directory_make();
    mkdir(directory_path(&place, "in"), 0777);
    mkdir(directory_path(&place, "short"), 0777);
    heights(height_m, false, 4);
    pipeline_scan(&place, "in/even.csv", height_m, POINTS);
    pipeline_scan(&place, "short/eight.csv", height_m, 8);
    heights(height_m, false, 7);
    pipeline_scan(&place, "in/fair.csv", height_m, POINTS);
    heights(height_m, true, 4);
    pipeline_scan(&place, "in/plateau.csv", height_m, POINTS);
    *state = &place;
    return 0;
}

static int place_teardown(void **state)
{
    directory_remove(*state);
    return 0;
}

/** Rows of a surface in a model of OUT/data/contact.csv. */
static size_t rows_of(const struct directory *place, const char *out, const char *surface, const char *model)
{
    char name[64];
    snprintf(name, sizeof name, "%s/data/contact.csv", out);
    struct table table = table_read_path(directory_path(place, name));
    size_t rows = 0;
    for (size_t row = 0; row < table.rows; row++)
        rows += strcmp(table_text(&table, row, "surface"), surface) == 0 &&
                strcmp(table_text(&table, row, "model"), model) == 0;
    table_free(&table);
    return rows;
}

static struct text report_of(const struct directory *place, const char *out)
{
    char name[64];
    snprintf(name, sizeof name, "%s/report.md", out);
    return directory_read(place, name);
}

/** Number of times that `part` stands in `text`. */
static size_t times(const struct text *text, const char *part)
{
    size_t count = 0;
    for (const char *at = text_string(text); (at = strstr(at, part)); at += strlen(part))
        count++;
    return count;
}

/** Unasked: on the plateau alone, which has the mark and a row of its own; the others have neither. */
static void unasked_only_where_heights_are_not_gaussian(void **state)
{
    const struct directory *place = *state;
    write_scene(place, "in", "");
    assert_int_equal(pipeline_run(place, "in", "out", 1), 0);
    assert_int_equal(rows_of(place, "out", "plateau", "contacting-slopes"), 9);
    assert_int_equal(rows_of(place, "out", "even", "contacting-slopes"), 0);
    assert_int_equal(rows_of(place, "out", "fair", "contacting-slopes"), 0);
    assert_int_equal(rows_of(place, "out", "fair", "two-band-elastic"), 9);
    struct text report = report_of(place, "out");
    assert_int_equal(times(&report, "| plateau ‡ |"), 1);
    assert_int_equal(times(&report, " ‡ |"), 1);
    assert_int_equal(times(&report, "‡ Heights are not Gaussian"), 1);
    const char *table = strstr(report.data, "| surface | Rsk | Rku | A/Aₙ (%)");
    assert_non_null(table);
    const char *row = strstr(table, "| plateau | "), *end = strstr(table, "\n\n");
    assert_true(row && row < end);
    double skewness, kurtosis, area;
    assert_int_equal(sscanf(row, "| plateau | −%lf | %lf | %lf |", &skewness, &kurtosis, &area), 3);
    double height_m[POINTS], square = 0, cube = 0, fourth = 0;
    heights(height_m, true, 4);
    for (size_t i = 0; i < POINTS; i++) {
        double z = height_m[i]; /* level: none */
        square += z * z / POINTS;
        cube += z * z * z / POINTS;
        fourth += z * z * z * z / POINTS;
    }
    assert_near(-skewness, cube / pow(square, 1.5), 0.01);
    assert_near(kurtosis, fourth / (square * square), 0.01);
    struct table contact = table_read_path(directory_path(place, "out/data/contact.csv"));
    for (size_t i = 0; i < contact.rows; i++)
        if (strcmp(table_text(&contact, i, "model"), "contacting-slopes") == 0 &&
            fabs(log10(table_number(&contact, i, "load_over_AnEp")) + 4) < 1e-9)
            assert_near(area, 100 * table_number(&contact, i, "area_ratio"), 0.006);
    table_free(&contact);
    text_free(&report);
}

/** Without a surface that is not Gaussian nothing of it is said; asked for, it runs on all. */
static void asked_for_it_runs_everywhere(void **state)
{
    const struct directory *place = *state;
    write_scene(place, "in", "surfaces: [{name: even, file: even.csv}, {name: fair, file: fair.csv}]\n");
    assert_int_equal(pipeline_run(place, "in", "out", 1), 0);
    assert_int_equal(rows_of(place, "out", "even", "contacting-slopes"), 0);
    struct text report = report_of(place, "out");
    assert_null(strstr(report.data, "‡"));
    assert_false(directory_has(place, "out/figures/normal-probability.svg"));
    text_free(&report);
    write_scene(place, "in", "models: [contacting-slopes]\n");
    assert_int_equal(pipeline_run(place, "in", "out", 1), 0);
    static const char *const names[] = {"even", "fair", "plateau"};
    for (size_t i = 0; i < 3; i++)
        assert_int_equal(rows_of(place, "out", names[i], "contacting-slopes"), 9);
    report = report_of(place, "out");
    assert_null(strstr(report.data, " ‡ |")); /* the leading model knows the heights */
    assert_non_null(strstr(report.data, "\n## Models beyond the thesis\n"));
    assert_int_equal(times(&report, "(figures/normal-probability.svg)"), 1);
    text_free(&report);
}

/** Too few points: no curve, and no harm. Two rough bodies: none either. */
static void none_where_there_cannot_be_one(void **state)
{
    const struct directory *place = *state;
    write_scene(place, "short", "models: [multiscale, contacting-slopes]\n");
    assert_int_equal(pipeline_run(place, "short", "out", 1), 0);
    assert_int_equal(rows_of(place, "out", "eight", "contacting-slopes"), 0);
    assert_int_equal(rows_of(place, "out", "eight", "multiscale-elastic"), 9);
    assert_false(directory_has(place, "out/figures/normal-probability.svg"));
    write_scene(place, "in",
                "models: [multiscale, contacting-slopes]\ncounterface: {surface: fair.csv}\n"
                "surfaces: [{name: plateau, file: plateau.csv}]\n");
    assert_int_equal(pipeline_run(place, "in", "out", 1), 0);
    assert_int_equal(rows_of(place, "out", "plateau", "contacting-slopes"), 0);
    assert_int_equal(rows_of(place, "out", "plateau", "multiscale-elastic"), 9);
    struct table table = table_read_path(directory_path(place, "out/data/sensitivity.csv"));
    for (size_t i = 0; i < table.rows; i++)
        assert_string_equal(table_text(&table, i, "area_factor"), "");
    table_free(&table);
}

static int compare_falling(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x < y) - (x > y);
}

/** The chart's heights are those of the scan at their normal scores, and the line is the least-squares one through the
 * highest 2AM of them. */
static void the_probability_plot(void **state)
{
    const struct directory *place = *state;
    write_scene(place, "in", "models: [contacting-slopes]\nsurfaces: [{name: plateau, file: plateau.csv}]\n");
    assert_int_equal(pipeline_run(place, "in", "out", 1), 0);
    enum { M = POINTS - 2 };
    double z[POINTS], area = NAN;
    heights(z, true, 4);
    qsort(z + 1, M, sizeof *z, compare_falling);
    struct table contact = table_read_path(directory_path(place, "out/data/contact.csv"));
    area = table_number(&contact, contact.rows / 2, "area_ratio");
    table_free(&contact);
    assert_true(area > 0.002 && area < 0.15);
    size_t fitted = (size_t)fmax(30, floor(2 * area * M));
    double mean_y = 0, mean_z = 0, square = 0, product = 0;
    for (size_t i = 0; i < fitted; i++) {
        mean_y += gsl_cdf_ugaussian_Qinv(((double)i + 0.5) / M) / (double)fitted;
        mean_z += z[i + 1] / (double)fitted;
    }
    for (size_t i = 0; i < fitted; i++) {
        double y = gsl_cdf_ugaussian_Qinv(((double)i + 0.5) / M) - mean_y;
        square += y * y;
        product += y * (z[i + 1] - mean_z);
    }
    double slope = product / square, offset = mean_z - slope * mean_y;

    struct text data = directory_read(place, "out/figures/normal-probability.csv");
    char *rest, *line = strtok_r(data.data, "\n", &rest);
    size_t block = 0, rows[3] = {0}, last = 0;
    for (; line; line = strtok_r(NULL, "\n", &rest)) {
        double score, height_um;
        if (*line == '"') {
            block++;
            continue;
        }
        assert_true(block >= 1 && block <= 3);
        assert_int_equal(sscanf(line, "%lf,%lf", &score, &height_um), 2);
        rows[block - 1]++;
        if (block == 1) {
            size_t i = (size_t)round(gsl_cdf_ugaussian_Q(score) * M - 0.5);
            assert_true(i < M && (rows[0] == 1 ? i == 0 : i > last));
            assert_within(height_um, z[i + 1] * 1e6, 2e-9); /* as the scan was written */
            last = i;
        } else {
            assert_within(height_um, (offset + slope * score) * 1e6, 1e-7);
        }
    }
    assert_true(rows[0] > 100 && rows[0] <= 301 && last == M - 1 && rows[1] == 2 && rows[2] == 2);
    text_free(&data);
    struct text script = directory_read(place, "out/figures/normal-probability.gp");
    assert_non_null(strstr(script.data, "'s1 fit fitx'"));
    text_free(&script);
    struct text svg = directory_read(place, "out/figures/normal-probability.svg");
    assert_non_null(strstr(svg.data, "plateau, Rq"));
    text_free(&svg);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(unasked_only_where_heights_are_not_gaussian),
        cmocka_unit_test(asked_for_it_runs_everywhere),
        cmocka_unit_test(none_where_there_cannot_be_one),
        cmocka_unit_test(the_probability_plot),
    };
    return cmocka_run_group_tests(tests, place_setup, place_teardown);
}
