/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The first page, against the data of the same report. */
#include "run/pipeline.h"

#include <jansson.h>

static int place_setup(void **state)
{
    static struct directory place;
    place = directory_make();
    pipeline_rough(&place, "in/a.csv", 160, 0.1, 1);
    pipeline_rough(&place, "in/b.csv", 160, 0.3, 2);
    directory_write(&place, "in/scene.yaml",
                    "models: [corrected-persson, multiscale]\nmaterial: tin\nload: {from: 1e-6, to: 1e-2, points: 9}\n"
                    "operating_load: 1e-4\n"
                    "effects: [plasticity, electrical, uncertainty]\n");
    *state = &place;
    return 0;
}

static const char leading[] = "corrected-persson-plastic";

/* Without an operating load the page uses the load nearest to the geometric middle of those at which A/A_n is 0.1 to
 * 10 % on the baseline, by the leading model. */
TEST_IN_PLACE(test_where_the_page_stands)
{
    static const char *const scenes[] = {"load: {from: 1e-7, to: 1e-2, points: 41}\n",
                                         "load: {from: 1e-7, to: 1e-2, points: 41}\nbaseline: c\n",
                                         "load: {values: [1e-9, 2e-9, 3e-9]}\n"};
    double stands[3];
    pipeline_rough(place, "three/a.csv", 160, 0.3, 1);
    pipeline_rough(place, "three/b.csv", 160, 0.03, 2);
    pipeline_rough(place, "three/c.csv", 160, 1, 3);
    for (int k = 0; k < 3; k++) {
        pipeline_report(place, "three", "out", filled("models: [corrected-persson]\n%s", scenes[k]));
        stands[k] = pipeline_number(place, "out", "scene/operating_load_over_AnEp");
        struct table contact = directory_table(place, "out/data/contact.csv");
        double first = NAN, last = NAN, nearest = INFINITY;
        for (int pass = 0; pass < 2; pass++)
            for (size_t row = 0; row < contact.rows; row++) {
                double area = table_number(&contact, row, "area_ratio"),
                       load = table_number(&contact, row, "load_over_AnEp");
                if (strcmp(table_text(&contact, row, "surface"), k == 1 ? "c" : "a") != 0)
                    continue;
                if (pass == 0 && area >= 1e-3 && area <= 0.1) {
                    first = isnan(first) ? load : first;
                    last = load;
                }
                double off = fabs(log(load / sqrt(first * last)));
                nearest = pass == 1 && off < fabs(log(nearest / sqrt(first * last))) ? load : nearest;
            }
        assert_near(stands[k], k == 2 ? 3e-9 : nearest, 1e-9); /* no such area: the load with the area nearest to 1 % */
    }
    assert_true(stands[1] > 1.5 * stands[0]);
}

/* Of more than eight surfaces the charts show eight: best, worst and baseline by name, the others as "others". */
TEST_IN_PLACE(test_the_best_and_the_worst_are_shown)
{
    char best[8] = "", worst[8] = "";
    double ecr[2] = {INFINITY, 0};
    for (unsigned long i = 0; i < 11; i++)
        pipeline_rough(place, filled("many/s%lu.csv", i), 120, 0.1 * (double)(1 + i * 7 % 11), i + 1);
    pipeline_report(place, "many", "out",
                    "models: [corrected-persson]\nmaterial: tin\neffects: [plasticity, electrical]\nbaseline: s5\n"
                    "load: {values: [1e-4]}\n");
    struct table contact = directory_table(place, "out/data/contact.csv");
    for (size_t row = 0; row < contact.rows; row++) {
        double own = table_number(&contact, row, "ecr_ohm_m2");
        if (strcmp(table_text(&contact, row, "model"), leading) != 0)
            continue;
        if (own < ecr[0])
            snprintf(best, sizeof best, "%s", table_text(&contact, row, "surface"));
        if (own > ecr[1])
            snprintf(worst, sizeof worst, "%s", table_text(&contact, row, "surface"));
        ecr[0] = fmin(ecr[0], own);
        ecr[1] = fmax(ecr[1], own);
    }
    char *chart = directory_read(place, "out/figures/answer.csv");
    expect_parts(chart, filled("# %s, best\n", best), filled("# %s, worst\n", worst), "# s5, baseline\n");
    assert_int_equal(times(chart, "# others\n"), 5);
}

static size_t count_figures(const struct directory *place, const char *folder)
{
    size_t count = 0;
    DIR *figures = opendir(directory_path(place, folder));
    assert_non_null(figures);
    for (const struct dirent *entry; (entry = readdir(figures));)
        count += strstr(entry->d_name, ".svg") != NULL;
    closedir(figures);
    return count;
}

/** The first page of the report of a scene on two surfaces. */
static char *page_of(const struct directory *place, const char *scene)
{
    pipeline_rough(place, "pressed/a.csv", 160, 3, 1);
    pipeline_rough(place, "pressed/b.csv", 160, 5, 2);
    pipeline_report(place, "pressed", "out", scene);
    char *page = directory_read(place, "out/report.md"), *rest = strstr(page, "\n---\n");
    assert_non_null(rest);
    *rest = '\0';
    return page;
}

/* An area that is P/H, that is load over hardness alone, has no interval, and no surface is better in it. */
TEST_IN_PLACE(test_area_that_is_load_over_hardness)
{
#define AREA_ALONE "effects: [plasticity, uncertainty]\nmodels: [strip]\n"
#define ONE_SCAN   "surfaces: [{name: a, file: a.csv}, {name: b, file: a.csv}]\n"
    static const struct {
        const char *scene;
        bool pressed, alike, interval;
    } rows[] = {
        {"material: tin\nload: {from: 0.3 MPa, to: 30 MPa}\noperating_load: 3 MPa\n" AREA_ALONE, true, true, false},
        {"material: tin\nhardness: 30 GPa\nload: {from: 0.3 MPa, to: 30 MPa}\noperating_load: 3 MPa\n" AREA_ALONE,
         false, false, true},
        {"material: tin\nhardness: 30 GPa\nload: {from: 0.3 MPa, to: 30 MPa}\noperating_load: 3 MPa\n" AREA_ALONE
             ONE_SCAN,
         false, true, true},
        {"load: {from: 1e-5, to: 1e-3}\noperating_load: 1e-4\neffects: [uncertainty]\nmodels: [strip]\n" ONE_SCAN,
         false, true, true},
        {"material: tin\nload: {from: 1 MPa, to: 2 GPa}\noperating_load: 1 GPa\neffects: [plasticity]\nmodels: "
         "[multiscale]\n",
         false, true, false}, /* 100 % */
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const char *text = page_of(place, rows[k].scene), *intervals = rows[k].interval ? "(95\u00a0%: " : "is ";
        expect_parts(text, intervals, "contact area");
        if (rows[k].alike)
            expect_no_parts(text, "significantly better");
        if (rows[k].pressed) {
            struct table spread = directory_table(place, "out/data/spread.csv");
            size_t found = 0;
            for (size_t row = 0; row < spread.rows; row++)
                if (strcmp(table_text(&spread, row, "quantity"), "area_ratio_at_middle_load_strip-plastic") == 0) {
                    assert_string_equal(table_text(&spread, row, "mean_low_95"), ""); /* in no digit */
                    found++;
                }
            assert_int_equal(found, 2);
        }
        if (!rows[k].interval)
            expect_no_parts(text, "(95\u00a0%: ", "differ significantly");
    }
}

/* Without a target the page speaks of the first limit's quantity and ranks by it; of heat by TCR. */
TEST_IN_PLACE(a_limit_says_what_is_asked)
{
    static const struct {
        const char *asked, *head, *quantity;
    } rows[] = {
        {"", "| contact resistance at 10.0\u00a0N (", "ecr_ohm_m2"},
        {"limits: {ecr: {most: 1 mohm}}\n", "| contact resistance at 10.0\u00a0N (", "ecr_ohm_m2"},
        {"limits: {tcr: {most: 20 mm2 K/W}}\n", "| thermal contact resistance at 10.0\u00a0N (mm² K/W, ",
         "tcr_K_m2_per_W"},
        {"limits: {conductance: {least: 1 kW/m2/K}}\n", "| contact conductance at 10.0\u00a0N (kW/", "tcr_K_m2_per_W"},
        {"limits: {area: {most: 5 %}}\n", "| contact area at 10.0\u00a0N (%", "ecr_ohm_m2"},
        {"limits: {tcr: {most: 20 mm2 K/W}}\ntargets: [{ecr: 1 mohm}]\n", "| contact resistance at 10.0\u00a0N (mΩ, ",
         "ecr_ohm_m2"}};
    for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
        expect_parts(page_of(place, filled("material: copper\nnominal_area: 1 mm2\nmodels: [corrected-persson]\n"
                                           "load: {from: 1 N, to: 100 N, points: 9}\noperating_load: 10 N\n%s",
                                           rows[r].asked)),
                     rows[r].head);
        json_t *results = directory_json(place, "out/results.json");
        assert_string_equal(json_string_value(json_object_get(json_object_get(results, "comparison"), "quantity")),
                            rows[r].quantity);
    }
}

/* --brief gives the first page to the byte, its figures only, and the same data. */
TEST_IN_PLACE(test_brief)
{
    assert_int_equal(pipeline_run(place, "in", "out", 1), 0);
    pipeline_outcome(place, "in", "brief", (struct run_options){.brief = true});
    char *whole = directory_read(place, "out/report.md"), *brief = directory_read(place, "brief/report.md");
    const char *rule = strstr(whole, "\n---\n");
    assert_non_null(rule);
    assert_in_range(strlen(brief), (size_t)(rule - whole), (size_t)(rule - whole) + 1);
    assert_memory_equal(brief, whole, strlen(brief));
    assert_non_null(strstr(brief, "](figures/answer.svg)"));
    assert_int_equal(count_figures(place, "brief/figures"), 2);
    assert_true(count_figures(place, "out/figures") > 5);
    static const char *const same[] = {"data/contact.csv", "data/sensitivity.csv", "data/spread.csv", "results.json"};
    for (size_t i = 0; i < sizeof same / sizeof *same; i++)
        directory_expect_same(place, filled("out/%s", same[i]), filled("brief/%s", same[i]));
    char *page = directory_read(place, "brief/report.html");
    assert_non_null(strstr(page, "What to know"));
    assert_null(strstr(page, "<details class=\"folded\">"));
}

TEST_GROUP(place_setup, directory_teardown)

/* Of a metal this hard yielding changes little: it raises the conductance, as it lowers the resistance. */
TEST_IN_DIRECTORY(an_effect_of_little_has_its_sign)
{
    static const char *const asked[][2] = {{"conductance: 1e4 W/m2/K", "conductance changes by 3 %"},
                                           {"tcr: 1e-4 m2 K/W", "resistance changes by −3 %"}};
    pipeline_rough(place, "in/a.csv", 400, 1, 1);
    for (int k = 0; k < 2; k++) {
        directory_write(place, "in/scene.yaml",
                        filled("material: tin\nhardness: 20 GPa\nload: {from: 1e-6, to: 1e-2, points: 9}\n"
                               "operating_load: 1e-4\ntargets: [{%s}]\n",
                               asked[k][0]));
        assert_int_equal(pipeline_run(place, "in", "out", 1), 0);
        expect_in_file(place, "out/report.md", asked[k][1]);
    }
}

/* No model answers where the pressure is the hardness or more, 39.76 MPa of tin; below it they do. */
TEST_IN_DIRECTORY(no_answer_beyond_the_hardness)
{
    static const char scene[] =
        "material: tin\nnominal_area: 1 mm2\noperating_load: %d N\nmodels: [multiscale-plastic%s]\n"
        "load: {from: 0.1 N, to: 1000 N, points: 41}\nlimits: {ecr: {most: 1 ohm}}\ntargets: [{ecr: %s ohm}]\n"
        "export: comsol\neffects: [auto, uncertainty]\nsurfaces: [{name: a, file: a.csv}]\n";
    pipeline_rough(place, "in/a.csv", 400, 1, 1);
    pipeline_report(place, "in", "out", filled(scene, 60, ", gw", "1e-9"));
    expect_in_file(place, "out/report.md", "*a* needs more than 39.8", " ¶ |", "**The load exceeds the hardness:**");
    expect_not_in_file(place, "out/report.md", "Uncertainty", "N, 95 %", "Ω, 95 %");
    expect_in_file(place, "out/data/limits.csv", ",no value\n");
    expect_in_file(place, "out/export/a.comsol.txt", "it holds from 100000 Pa to 31622776.6 Pa\n", "\n31622776.6 ");
    expect_not_in_file(place, "out/export/a.comsol.txt", "\n39810717.1 ");
    pipeline_report(place, "in", "out", filled(scene, 30, "", "1e-9"));
    expect_in_file(place, "out/report.md", "Uncertainty", "Ω, 95 %");
    expect_not_in_file(place, "out/report.md", "exceeds the hardness", "¶");
    expect_in_file(place, "out/data/limits.csv", ",met\n");
}

/* An elastic model that leads has the mark of a contact above the hardness beside its answer. */
TEST_IN_DIRECTORY(an_elastic_answer_above_the_hardness_is_marked)
{
    static const char *const kinds[] = {"hardness: 40 MPa", "hardness: 1 GPa"};
    pipeline_rough(place, "in/a.csv", 400, 1, 1);
    for (int k = 0; k < 2; k++) {
        pipeline_report(place, "in", "out",
                        filled("material: tin\n%s\nmodels: [multiscale-elastic]\noperating_load: 1 MPa\n", kinds[k]));
        char *report = directory_read(place, "out/report.md"), *page = strstr(report, "\n---\n");
        assert_non_null(page);
        *page = '\0';
        assert_int_equal(strstr(report, " ¶ |") != NULL, k == 0);
        assert_int_equal(strstr(report, "\n¶ elastic, though") != NULL, k == 0);
        assert_int_equal(strstr(report, ", 95 %)") != NULL, k == 1);
    }
}

/* Table 6.3 has a column by the multiscale model where that runs; "No lay is known" is of all surfaces. */
TEST_IN_DIRECTORY(what_is_not_there_is_not_told)
{
    static const char *const scenes[] = {"models: [gw]\nsurfaces: [{name: a, file: a.csv}, {name: b, file: b.csv}]\n",
                                         "models: [gw, multiscale-elastic]\nbaseline: a\n"
                                         "surfaces: [{name: a, file: a.csv}, {name: b, file: b.csv, lay: 0.1}]\n"};
    pipeline_rough(place, "in/a.csv", 400, 1, 1);
    pipeline_rough(place, "in/b.csv", 400, 2, 2);
    for (int k = 0; k < 2; k++) {
        pipeline_report(place, "in", "out", scenes[k]);
        char *report = directory_read(place, "out/report.md");
        assert_non_null(strstr(report, "| β of GW, full contact |"));
        assert_int_equal(strstr(report, "| β of GW, multiscale elastic |") != NULL, k == 1);
        assert_int_equal(strstr(report, "nearest to the multiscale") != NULL, k == 1);
        assert_int_equal(strstr(report, "No lay is known") != NULL, k == 0);
    }
}

/* A measured number has three digits, in headline and table alike, also where its test scatters. */
TEST_IN_DIRECTORY(the_headline_has_the_digits_of_the_table)
{
    pipeline_rough(place, "in/a.csv", 400, 1, 1);
    directory_write(place, "in/m.txt", "Load (N), R (uohm)\n1,20\n2,15\n5,8\n");
    pipeline_report(place, "in", "out",
                    "material: tin\nnominal_area: 1 mm2\noperating_load: 1.5 N\n"
                    "surfaces: [{name: a, file: a.csv, measured: {file: m.txt}}]\n");
    expect_in_file(place, "out/report.md", "is 16.9\u00a0µΩ (measured)", "| 16.9 measured |");
}

/* Of an elastic model above the hardness no answer has an interval, also where lighter loads have bands. */
TEST_IN_DIRECTORY(an_elastic_target_above_the_hardness_has_no_interval)
{
    size_t above = 0, below = 0;
    pipeline_rough(place, "in/a.csv", 400, 1, 1);
    pipeline_report(place, "in", "out",
                    "material: tin\nhardness: 188 MPa\nmodels: [multiscale-elastic]\neffects: [auto, uncertainty]\n"
                    "load: {from: 1e-6, to: 1e-2, points: 21}\n"
                    "targets: [{ecr: 1e-9 ohm m2}, {ecr: 1e-10 ohm m2}, {ecr: 1e-11 ohm m2}, {ecr: 3e-12 ohm m2}]\n");
    char *rows = directory_read(place, "out/data/answers.csv");
    for (char *row = strtok(rows, "\n"); (row = strtok(NULL, "\n"));) {
        bool is = strstr(row, "above the hardness"), none = strstr(row, ",,,");
        if (is && !none)
            fail_msg("%s", row);
        above += is;
        below += !is && !none;
    }
    assert_true(above > 0 && below > 0);
}
