/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surfaces whose heights are not Gaussian, through the whole program: where contacting slopes runs, what the first page
 * says, and the normal-probability plot. */
#include "run/pipeline.h"

#include <gsl/gsl_cdf.h>
#include <jansson.h>

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

/** Two near-Gaussian surfaces and a plateau in place/in; eleven points more in place/short. */
static int place_setup(void **state)
{
    static struct directory place;
    double height_m[POINTS];
    place = directory_make();
    mkdir(directory_path(&place, "in"), 0777);
    mkdir(directory_path(&place, "short"), 0777);
    heights(height_m, false, 4);
    pipeline_scan(&place, "in/even.csv", height_m, POINTS);
    pipeline_scan(&place, "short/eleven.csv", height_m, 11);
    heights(height_m, false, 7);
    pipeline_scan(&place, "in/fair.csv", height_m, POINTS);
    heights(height_m, true, 4);
    pipeline_scan(&place, "in/plateau.csv", height_m, POINTS);
    *state = &place;
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
TEST_CASE(unasked_only_where_heights_are_not_gaussian)
{
    const struct directory *place = *state;
    write_scene(place, "in", "");
    assert_int_equal(pipeline_run(place, "in", "out", 1), 0);
    assert_int_equal(rows_of(place, "out", "plateau", "contacting-slopes"), 9);
    assert_int_equal(rows_of(place, "out", "even", "contacting-slopes"), 0);
    assert_int_equal(rows_of(place, "out", "fair", "contacting-slopes"), 0);
    assert_int_equal(rows_of(place, "out", "fair", "two-band-elastic"), 9);
    struct text report = report_of(place, "out");
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

/** Beside a plastic model that leads, what contacting slopes says stands only below the hardness. */
TEST_CASE(nothing_elastic_above_the_hardness)
{
    const struct directory *place = *state;
    for (int soft = 0; soft < 2; soft++) {
        write_scene(place, "in", soft ? "" : "hardness: 100 GPa\n");
        struct text scene = directory_read(place, "in/scene.yaml"), plastic = {0};
        const char *effects = strstr(scene.data, "[separation");
        text_add(&plastic, "%.*s[plasticity, %s", (int)(effects - scene.data), scene.data, effects + 1);
        directory_write(place, "in/scene.yaml", text_string(&plastic));
        assert_int_equal(pipeline_run(place, "in", "hard", 1), 0);
        struct text report = report_of(place, "hard");
        assert_non_null(strstr(report.data, "**Heights are not Gaussian**"));
        assert_int_equal(times(&report, "contacting slopes says more"), !soft);
        assert_int_equal(times(&report, "| surface | Rsk | Rku | A/Aₙ (%)"), !soft);
        assert_int_equal(times(&report, "factors of 2 to 30 in area"), !soft);
        assert_int_equal(times(&report, "There the hardness alone sets their area; "), soft);
        assert_int_equal(times(&report, "What contacting slopes says there is elastic and above the hardness."), soft);
        text_free(&scene);
        text_free(&plastic);
        text_free(&report);
    }
    directory_write(place, "in/scene.yaml",
                    "material: tin\nlevel: none\neffects: [plasticity, separation, electrical]\n"
                    "load: {from: 1e-6, to: 1e-2, points: 9}\nsurfaces: [{name: soft, file: plateau.csv}, "
                    "{name: hard, file: plateau.csv, hardness: 100 GPa}]\n");
    assert_int_equal(pipeline_run(place, "in", "hard", 1), 0);
    struct text report = report_of(place, "hard");
    const char *table = strstr(report.data, "| surface | Rsk | Rku | A/Aₙ (%)");
    assert_non_null(table);
    const char *end = strstr(table, "\n\nLeft out: 1 above the hardness.\n");
    assert_true(end && strstr(table, "\n| hard | ") < end && strstr(table, "\n| hard | "));
    const char *soft_row = strstr(table, "\n| soft | ");
    assert_true(!soft_row || soft_row > end);
    text_free(&report);
}

/** From a heading, or "" for the first page, to the next; malloc'ed. */
static char *section_of(const struct text *report, const char *heading)
{
    const char *from = *heading ? strstr(text_string(report), heading) : text_string(report);
    assert_non_null(from);
    const char *to = strstr(from + strlen(heading), "\n## ");
    return to ? strndup(from, (size_t)(to - from)) : strdup(from);
}

/** Rows of the section's tables that begin with `start`, and how many of them have `part`. */
static void count_rows(size_t counts[2], const char *section, const char *start, const char *part)
{
    counts[0] = counts[1] = 0;
    for (const char *line = section; line && *line; line = strchr(line, '\n'), line = line ? line + 1 : NULL) {
        size_t length = strcspn(line, "\n");
        char row[4096];
        assert_true(length < sizeof row);
        snprintf(row, length + 1, "%s", line);
        if (strncmp(row, start, strlen(start)) != 0)
            continue;
        counts[0]++;
        counts[1] += strstr(row, part) != NULL;
    }
}

/** Every cell that names a model has the mark where the model takes heights as Gaussian, and `marked` says that the
 * table's surface gets one; how many of them there are. */
static size_t check_models(const char *section, const char *mark, bool marked)
{
    size_t found = 0;
    for (size_t m = 0; m < model_count; m++) {
        char plain[128], with[128];
        snprintf(plain, sizeof plain, "| %s |", model_rows[m]->label);
        snprintf(with, sizeof with, "| %s\u00a0%s |", model_rows[m]->label, mark);
        bool expected = marked && !model_rows[m]->uses_heights;
        for (const char *at = section; (at = strstr(at, plain)); at++) {
            assert_false(expected);
            found++;
        }
        for (const char *at = section; (at = strstr(at, with)); at++) {
            assert_true(expected);
            found++;
        }
    }
    return found;
}

/** Every table in which there is a mark has its legend before the next one. */
static void check_legends(const char *section, const char *legend)
{
    bool marked = false, inside = false;
    for (const char *line = section; line && *line; line = strchr(line, '\n'), line = line ? line + 1 : NULL) {
        size_t length = strcspn(line, "\n");
        bool row = *line == '|';
        if (row && !inside)
            assert_false(marked);
        inside = row;
        marked = marked || (row && memmem(line, length, "\u00a0‡", strlen("\u00a0‡")));
        marked = marked && strncmp(line, legend, strlen(legend)) != 0;
    }
    assert_false(marked);
}

static const char *const model_sections[] = {"\n## Surface plateau in every model", "\n## Two bands"};
static const char *const surface_sections[] = {"", "\n## All surfaces, model by model",
                                               "\n## Where the models may be trusted"};
static const char legend[] = "‡ heights not Gaussian, as the model takes them";

/** The mark stands beside every model that takes heights as Gaussian and by no other, on that surface alone. */
TEST_CASE(marks_in_every_table)
{
    const struct directory *place = *state;
    size_t rows[2];
    write_scene(place, "in", "baseline: plateau\n");
    assert_int_equal(pipeline_run(place, "in", "out", 1), 0);
    struct text report = report_of(place, "out");
    for (size_t i = 0; i < sizeof model_sections / sizeof *model_sections; i++) {
        char *section = section_of(&report, model_sections[i]);
        assert_true(check_models(section, "‡", true) >= 8);
        check_legends(section, legend);
        free(section);
    }
    for (size_t i = 0; i < sizeof surface_sections / sizeof *surface_sections; i++) {
        char *section = section_of(&report, surface_sections[i]);
        count_rows(rows, section, "| plateau", "| plateau\u00a0‡ |");
        assert_true(rows[1] > 0 && rows[1] + (i == 0) == rows[0]); /* the first page has it once more, in slopes */
        count_rows(rows, section, "| even", "‡");
        assert_true(rows[0] > 0 && rows[1] == 0);
        check_legends(section, legend);
        free(section);
    }
    char *hang = section_of(&report, "\n## What the answers hang on");
    count_rows(rows, hang, "| plateau | ", "\u00a0‡ |");
    assert_true(rows[0] > 0 && rows[1] == rows[0]);
    count_rows(rows, hang, "| fair | ", "‡");
    assert_true(rows[0] > 0 && rows[1] == 0);
    check_legends(hang, legend);
    free(hang);
    text_free(&report);

    write_scene(place, "in", "baseline: fair\n");
    assert_int_equal(pipeline_run(place, "in", "out", 1), 0);
    report = report_of(place, "out");
    char *every = section_of(&report, "\n## Surface fair in every model");
    assert_true(check_models(every, "‡", false) >= 8);
    assert_null(strstr(every, "‡"));
    free(every);
    text_free(&report);
}

/** The sections that are called for by effects alone: intervals, and what lies below the sampling limit. */
TEST_CASE(marks_where_effects_call_for_tables)
{
    const struct directory *place = *state;
    static const char *const sections[] = {"\n## How sure the numbers are", "\n## Does the area converge"};
    size_t rows[2];
    directory_write(place, "in/scene.yaml",
                    "level: none\neffects: [uncertainty, convergence]\n"
                    "load: {from: 1e-6, to: 1e-2, points: 9}\n");
    assert_int_equal(pipeline_run(place, "in", "out", 1), 0);
    struct text report = report_of(place, "out");
    for (size_t i = 0; i < sizeof sections / sizeof *sections; i++) {
        char *section = section_of(&report, sections[i]);
        count_rows(rows, section, "| plateau", "| plateau\u00a0‡ |");
        assert_true(rows[0] == 1 && rows[1] == 1);
        count_rows(rows, section, "| even", "‡");
        assert_true(rows[0] == 1 && rows[1] == 0);
        check_legends(section, legend);
        free(section);
    }
    text_free(&report);
}

/** Captions of charts with such curves name the surface; others do not. */
TEST_CASE(marks_in_captions)
{
    const struct directory *place = *state;
    static const struct {
        const char *file;
        bool of_fair, of_plateau; /* with that baseline */
    } charts[] = {
        {"6-05", false, true},  {"models-ecr", false, true}, {"sensitivity-area", false, true},   {"6-12", true, true},
        {"6-10", false, false}, {"power-law", false, false}, {"normal-probability", false, false}};
    for (int fair = 0; fair < 2; fair++) {
        write_scene(place, "in", fair ? "baseline: fair\n" : "baseline: plateau\n");
        assert_int_equal(pipeline_run(place, "in", "out", 1), 0);
        struct text report = report_of(place, "out");
        for (size_t i = 0; i < sizeof charts / sizeof *charts; i++) {
            char name[64];
            snprintf(name, sizeof name, "](figures/%s.svg)", charts[i].file);
            const char *end = strstr(report.data, name), *from = end;
            if (!end)
                fail_msg("no figure %s", charts[i].file);
            while (from > report.data && from[-1] != '\n')
                from--;
            char *caption = strndup(from, (size_t)(end - from));
            bool expected = fair ? charts[i].of_fair : charts[i].of_plateau;
            assert_true((strstr(caption, " Heights not Gaussian: surface plateau (‡).") != NULL) == expected);
            assert_true((strstr(caption, "‡") != NULL) == expected);
            free(caption);
        }
        text_free(&report);
    }
}

/** The first lines name the surface, and what a direct solution of it would take, as planned. */
TEST_CASE(the_first_lines)
{
    const struct directory *place = *state;
    write_scene(place, "in", "baseline: plateau\n");
    assert_int_equal(pipeline_run(place, "in", "out", 1), 0);
    struct text report = report_of(place, "out");
    const char *line = strstr(report.data, "- **Heights are not Gaussian**, as the models other than contacting slopes "
                                           "take them, on surface plateau (‡). ");
    const char *table = strstr(report.data, "\n|");
    assert_true(line && table && line < table);
    double told, planned;
    const char *takes = strstr(line, "(`roughcontact direct`), which takes about ");
    assert_non_null(takes);
    assert_int_equal(sscanf(takes, "(`roughcontact direct`), which takes about %lf s of one core.", &told), 1);
    const char *reason = strstr(report.data, "it would say how far each model is off: ");
    assert_non_null(reason);
    const char *seconds = strstr(reason, "convolutions, ");
    assert_non_null(seconds);
    assert_int_equal(sscanf(seconds, "convolutions, %lf s of one core", &planned), 1);
    assert_true(told > 0);
    assert_near(told, planned, 0.02);
    text_free(&report);
}

/** Few long waves: the other mark, everywhere; in results.json and on a terminal too. */
TEST_CASE(the_weaker_mark)
{
    const struct directory *place = *state;
    double height_m[POINTS];
    uint32_t seed = 5;
    mkdir(directory_path(place, "long"), 0777);
    memset(height_m, 0, sizeof height_m);
    for (int n = 1; n < 100; n++) {
        seed = seed * UINT32_C(1664525) + UINT32_C(1013904223);
        for (size_t i = 0; i < POINTS; i++)
            height_m[i] += 1e-7 * pow(n, -1.5) * cos(2 * M_PI * (n * (double)i / POINTS + seed / 4294967296.0));
    }
    pipeline_scan(place, "long/few.csv", height_m, POINTS);
    heights(height_m, true, 4);
    pipeline_scan(place, "long/plateau.csv", height_m, POINTS);
    heights(height_m, false, 4);
    pipeline_scan(place, "long/even.csv", height_m, POINTS);
    write_scene(place, "long", "baseline: few\n");
    struct run_outcome outcome;
    struct status status = {0};
    char target[4096];
    snprintf(target, sizeof target, "%s", directory_path(place, "out"));
    struct run_options options = {.output = target, .templates = PROJECT_SOURCE "/templates", .no_cost = true};
    assert_int_equal(pipeline_try(&outcome, place, "long", options, &status), STATUS_OK);
    const char *terminal = text_string(&outcome.table);
    expect_parts(terminal, "\nfew ‡? ", "\nplateau ‡ ", "\neven  ", "\n‡ heights not Gaussian",
                 "\n‡? heights outside the Gaussian range");
    run_outcome_free(&outcome);
    struct text report = report_of(place, "out");
    char *section = section_of(&report, "\n## Surface few in every model");
    assert_true(check_models(section, "‡?", true) >= 8);
    check_legends(section, "‡? heights outside the Gaussian range, as a scan of so few long waves may show by chance");
    free(section);
    assert_non_null(strstr(report.data,
                           " on surface plateau (‡), and perhaps not on surface few (‡?), where scans of so "
                           "few long waves cannot tell. "));
    assert_int_equal(rows_of(place, "out", "few", "contacting-slopes"), 9); /* beyond the limits is beyond the limits */
    text_free(&report);

    json_error_t error;
    json_t *root = json_load_file(directory_path(place, "out/results.json"), 0, &error), *surface;
    static const char *const verdicts[] = {"gaussian", "cannot tell", "not gaussian"};
    static const char *const marks[] = {"", "‡?", "‡"};
    size_t index;
    assert_non_null(root);
    json_array_foreach(json_object_get(root, "surfaces"), index, surface)
    {
        const char *name;
        json_t *model;
        assert_string_equal(json_string_value(json_object_get(surface, "heights")), verdicts[index]);
        assert_int_equal(json_is_null(json_object_get(surface, "rsk_chance")), index == 0);
        json_object_foreach(json_object_get(surface, "models"), name, model)
        {
            const char *mark = json_string_value(json_object_get(model, "heights_mark"));
            assert_string_equal(mark, model_rows[model_named(name)]->uses_heights ? "" : marks[index]);
        }
    }
    assert_int_equal(index, 3);
    json_decref(root);
}

/** Without a surface that is not Gaussian nothing of it is said; asked for, it runs on all. */
TEST_CASE(asked_for_it_runs_everywhere)
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
    assert_null(strstr(report.data, "‡")); /* every model that runs knows the heights */
    assert_non_null(strstr(report.data, "\n## Models beyond the thesis\n"));
    assert_int_equal(times(&report, "(figures/normal-probability.svg)"), 1);
    text_free(&report);
}

/** Too few points: no curve, and no harm. Two rough bodies: none either. */
TEST_CASE(none_where_there_cannot_be_one)
{
    const struct directory *place = *state;
    write_scene(place, "short", "models: [multiscale, contacting-slopes]\n");
    assert_int_equal(pipeline_run(place, "short", "out", 1), 0);
    assert_int_equal(rows_of(place, "out", "eleven", "contacting-slopes"), 0);
    assert_int_equal(rows_of(place, "out", "eleven", "multiscale-elastic"), 9);
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
TEST_CASE(the_probability_plot)
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
    expect_in_file(place, "out/figures/normal-probability.gp", "# curves: s1 fit fitx\n");
    struct text svg = directory_read(place, "out/figures/normal-probability.svg");
    assert_non_null(strstr(svg.data, "plateau, Rq"));
    text_free(&svg);
}

TEST_GROUP(place_setup, directory_teardown)
