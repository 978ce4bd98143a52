/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A new model is one table row: two more, registered here in place of model_table.c, run through a whole report. One
 * stacks scales and computes every quantity, the other only has an area and never reaches full contact. */
#include "contact/multiscale.h"
#include "pipeline.h"
#include "run/all_surfaces.h"

#include <jansson.h>

/** The stack of the multiscale models by the numerical closure, whatever the scene says; its separation closes by
 * itself, so that the adjusted one is the same. */
static enum status_code stack_run(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                                  struct status *status)
{
    struct multiscale stack;
    struct constriction constriction = constriction_make(task->pair);
    (void)row;
    if (multiscale_make(&stack, task->spectrum, task->pair, false, SINUSOID_FIT_NUMERIC, status) != STATUS_OK)
        return status->code;
    for (size_t i = 0; i <= task->load_count; i++) {
        struct contact_point *point = i < task->load_count ? &curve->points[i] : &curve->full;
        multiscale_solve(point, &stack, &constriction, task->wanted,
                         i < task->load_count ? task->loads[i] : stack.full_load, &curve->evaluations);
        point->value[QUANTITY_ADJUSTED] = point->value[QUANTITY_SEPARATION];
    }
    curve->count = task->load_count;
    curve->full_load = stack.full_load;
    curve->beta = 0;
    curve->exists = true;
    multiscale_free(&stack);
    return STATUS_OK;
}

/** Root mean square slope of the spectrum. */
static double slope_of(const struct spectrum *spectrum)
{
    return sqrt(spectrum_moment(spectrum, 1));
}

/** A/A_n = x/(x + 1) with x = 2 P/(A_n E')/slope; sets nothing else. */
static enum status_code area_run(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                                 struct status *status)
{
    (void)row, (void)status;
    for (size_t i = 0; i < task->load_count; i++) {
        double x = 2 * task->loads[i] / slope_of(task->spectrum);
        curve->points[i].value[QUANTITY_LOAD] = task->loads[i];
        curve->points[i].value[QUANTITY_AREA] = x / (x + 1);
    }
    curve->count = task->load_count;
    curve->exists = true;
    curve->evaluations = task->load_count;
    return STATUS_OK;
}

static const struct model_row numeric_stack = {
    .name = "numeric-stack",
    .label = "numeric stack",
    .family = "registered",
    .in_findings = true,
    .counterpart = &model_multiscale_elastic,
    .stacks_scales = true,
    .quantities = QUANTITY_BIT(QUANTITY_MEAN_GAP) - 1, /* which is made of its separation */
    .colour = "#2E8B57",
    .marker = 8,
    .does = "says what it says",
    .equations = "none",
    .source = "source of the numeric stack",
    .assumes = "what the stack assumes",
    .valid = "where the stack is valid",
    .method = "sum by the numerical closure",
    .run = stack_run,
};

static const struct model_row area_alone = {
    .name = "area-alone",
    .label = "area alone",
    .family = "registered",
    .in_findings = true,
    .quantities = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA),
    .colour = "#8B2E57",
    .marker = 9,
    .does = "says what it says",
    .equations = "none",
    .source = "source of the area alone",
    .assumes = "what the area assumes",
    .valid = "where the area is valid",
    .method = "one division a load",
    .run = area_run,
};

extern const struct model_row model_gw, model_jg;

/* In place of model_table.c, which a program that has its own table does not get from the library. */
const struct model_row *const model_rows[] = {
    &model_multiscale_elastic, &model_multiscale_plastic, &model_gw, &model_jg, &numeric_stack, &area_alone,
};
const size_t model_count = sizeof model_rows / sizeof *model_rows;
enum { STACK = 4, ALONE = 5 };

#define LOADS "load: {from: 1e-6, to: 1, points: 13}\nconvergence: {scales: 64}\nnominal_area_m2: 1e-6\n"

/** Three surfaces, the first of three scans, in OUT of `place`. */
static struct run_outcome *report_of(const struct directory *place, const char *scene, bool no_cost)
{
    struct status status = {0};
    for (int i = 0; i < 5; i++)
        pipeline_rough(place, filled("in/%c.csv", 'a' + i), 128, i < 3 ? 2 : 2.0 * i, (unsigned long)i + 1);
    directory_write(place, "in/scene.yaml", scene);
    struct run_options options = {.output = lasting("%s", directory_path(place, "out")),
                                  .templates = PROJECT_SOURCE "/templates",
                                  .terminal_size = "80,24",
                                  .no_cost = no_cost,
                                  .jobs = 2};
    struct run_outcome *outcome = pipeline_try(place, "in", options, &status);
    if (status.code != STATUS_OK || outcome->refused > 0)
        fail_msg("%s\n%s", status.message, text_string(&outcome->messages));
    return outcome;
}

#define SURFACES                                                                                                       \
    "surfaces: [{name: one, file: [a.csv, b.csv, c.csv]}, {name: two, file: d.csv}, {name: three, file: e.csv}]\n"

static struct directory whole; /* of the report with everything in it */
static const struct run_outcome *whole_outcome;

static int make_whole(void **state)
{
    (void)state;
    whole = directory_make();
    directory_write(&whole, "in/ecr.csv", "Load (N);ECR (mOhm);error (%)\n1;20;10\n10;3;10\n100;0.4;10\n");
    whole_outcome = report_of(&whole,
                              "material: tin\n" LOADS SURFACES
                              "effects: [plasticity, separation, electrical, thermal, scale-dependent, convergence]\n"
                              "measured: {file: ecr.csv}\n",
                              false);
    return 0;
}

static int remove_whole(void **state)
{
    (void)state;
    directory_remove(&whole);
    return 0;
}

/** The Markdown from a heading to the next one, `start` for the first; in place, until the next call. */
static const char *section(const char *markdown, const char *heading)
{
    static struct text part;
    const char *from = strstr(markdown, heading);
    if (!from)
        fail_msg("no section '%s'", heading);
    const char *to = strstr(from + 1, "\n## ");
    text_free(&part);
    text_add_bytes(&part, from, to ? (size_t)(to - from) : strlen(from));
    return text_string(&part);
}

/** The table row that starts so has this many cells. */
static void assert_row(const char *markdown, const char *start, size_t cells)
{
    const char *row = strstr(markdown, start);
    if (!row)
        fail_msg("no row '%s' in\n%s", start, markdown);
    size_t bars = 0;
    for (; *row && *row != '\n'; row++)
        bars += *row == '|';
    assert_int_equal(bars, cells + 1);
}

TEST_CASE(test_the_data)
{
    struct table contact = table_read_path(directory_path(&whole, "out/data/contact.csv"));
    size_t rows[2] = {0}, emptied = 0;
    for (size_t r = 0; r < contact.rows; r++) {
        const char *model = table_text(&contact, r, "model");
        double area = table_number(&contact, r, "area_ratio");
        if (strcmp(model, "numeric-stack") == 0) {
            rows[0]++;
            /* of three scans of which some are complete and some are not there is no mean resistance; the separation
             * shown is the geometric mean, the other one the arithmetic */
            bool several = strcmp(table_text(&contact, r, "surface"), "one") == 0;
            double adjusted = table_number(&contact, r, "adjusted_separation_over_sigma"),
                   separation = table_number(&contact, r, "separation_over_sigma");
            if (!several)
                assert_near(adjusted, separation, 1e-12);
            else if (*table_text(&contact, r, "adjusted_separation_over_sigma"))
                assert_true(adjusted <= separation * (1 + 1e-12));
            if (several && *table_text(&contact, r, "ecr_ohm_m2") == '\0') {
                assert_true(area > 0.5);
                emptied++;
                continue;
            }
            assert_true(area < 1 ? table_number(&contact, r, "ecr_ohm_m2") > 0 : true);
            assert_true(table_number(&contact, r, "tcr_sd_K_m2_per_W") >= table_number(&contact, r, "tcr_K_m2_per_W"));
        } else if (strcmp(model, "area-alone") == 0) {
            static const char *const empty[] = {
                "separation_m", "separation_over_sigma", "adjusted_separation_over_sigma",
                "ecr_ohm_m2",   "tcr_K_m2_per_W",        "tcr_sd_K_m2_per_W"};
            rows[1]++;
            assert_true(area > 0 && area < 1);
            for (size_t i = 0; i < sizeof empty / sizeof *empty; i++)
                assert_string_equal(table_text(&contact, r, empty[i]), "");
        }
    }
    assert_int_equal(rows[0], 3 * 13);
    assert_in_range(emptied, 0, 2);
    assert_int_equal(rows[1], 3 * 13);
}

/* Quantities that the second model does not compute are null. */
TEST_CASE(test_the_json)
{
    const json_t *results = directory_json(&whole, "out/results.json");
    size_t nulls = 0;
    for (int s = 0; s < 3; s++)
        for (int q = 0; q < QUANTITY_COUNT; q++) {
            const json_t *values =
                json_at(results, filled("surfaces/%d/models/area-alone/%s", s, quantity_rows[q].name));
            bool set = q == QUANTITY_LOAD || q == QUANTITY_AREA;
            for (size_t i = 0; i < json_array_size(values); i++) {
                assert_int_equal(json_is_null(json_array_get(values, i)), !set);
                nulls += !set;
            }
        }
    assert_int_equal(nulls, 3 * 13 * 6);
}

TEST_CASE(test_the_other_tables)
{
    static const struct {
        const char *file, *has[4], *lacks;
    } files[] = {
        {"out/data/surfaces.csv", {",beta_numeric-stack"}, "area-alone"},
        {"out/data/convergence.csv", {"alpha,0.001", ",numeric-stack,"}, "area-alone"},
        {"out/data/spread.csv",
         {"full_contact_load_over_AnEp_numeric-stack,3", "beta_numeric-stack,3"},
         "full_contact_load_over_AnEp_area-alone"},
        {"out/data/bands.csv", {"one,numeric-stack,", "one,area-alone,"}, "nan"},
        {"out/results.json", {"\"numeric-stack\": {", "\"area-alone\": {", "\"area-alone\"\n"}, "inf"},
    };
    for (size_t f = 0; f < sizeof files / sizeof *files; f++) {
        directory_expect(&whole, files[f].file, files[f].has, true, __FILE__, __LINE__);
        expect_not_in_file(&whole, files[f].file, files[f].lacks);
    }
}

/** The chart of one surface has all models, each in its colour; of all surfaces the thesis's and the leading one. */
TEST_CASE(test_the_charts)
{
    expect_in_file(&whole, "out/figures/one-surface.gp", "lc rgb '#2E8B57'", "title 'numeric stack'",
                   "lc rgb '#8B2E57'", "title 'area alone'");
    expect_in_file(&whole, "out/figures/convergence.gp", "numeric stack");
    expect_not_in_file(&whole, "out/figures/convergence.gp", "area alone");
    expect_not_in_file(&whole, "out/figures/area.gp", "numeric stack", "area alone");
}

TEST_CASE(test_the_report)
{
    char *text = directory_read(&whole, "out/report.md");
    const char *md = text;
    const char *baseline = section(md, "## One surface, every model");
    expect_parts(baseline, "| [numeric stack](#numeric-stack)");
    assert_row(baseline, "| [area alone](#area-alone) ", 6);
    expect_parts(
        section(md, "## All surfaces"),
        "| β of numeric stack, full contact | β of numeric stack, multiscale elastic |"); /* its beta stands beside the
                                                                                             others' */
    expect_no_parts(section(md, "## All surfaces"), "area alone |");
    expect_parts(section(md, "## The findings"), "numeric stack ");
    const char *measured = section(md, "## Measured");
    expect_parts(measured, "numeric stack ");
    expect_no_parts(measured, "area alone ");
    expect_parts(section(md, "## Methods and sources"), "| **numeric stack** | It says what it says: none | source of",
                 "| **area alone** |");
    expect_no_parts(md, "nan", "inf ");
    expect_in_file(&whole, "out/report.html", "numeric stack", "<strong>area alone</strong><a id=\"area-alone\"></a>");
}

TEST_CASE(test_the_work)
{
    assert_true(whole_outcome->times.models[STACK] > 0 && whole_outcome->times.models[ALONE] > 0);
}

/* A report with an area only has nothing on other quantities. */
TEST_IN_DIRECTORY(test_the_area_alone)
{
    const struct run_outcome *outcome = report_of(place,
                                                  "material: tin\n" LOADS SURFACES "models: [area-alone]\n"
                                                  "effects: [separation, electrical, thermal, scale-dependent]\n",
                                                  true);
    expect_in_file(place, "out/report.md", "by area alone, which says what it says.", "| model | area (%) |\n");
    expect_not_in_file(place, "out/report.md", "significantly better", /* two have one scan */
                       "ECR·Aₙ", "### Separation", "multiscale elastic");
    expect_parts(text_string(&outcome->table), "contact area");
    assert_true(directory_has(place, "out/figures/area.svg") && !directory_has(place, "out/figures/ecr.svg"));
}

/** The table of the plan of the scene in place/in, before any model runs. */
static const char *plan_of(const struct directory *place)
{
    struct scene scene;
    struct all_surfaces prepared;
    struct status status = {0};
    struct run_options options = {.templates = PROJECT_SOURCE "/templates", .jobs = 1};
    struct text *table = support_text();
    if (scene_read(&scene, directory_path(place, "in"), &(struct scene_overrides){0}, &status) != STATUS_OK ||
        all_surfaces_run(&prepared, &scene, &options, true, NULL, &status) != STATUS_OK)
        fail_msg("%s", status.message);
    work_table(table, &prepared.results, true); /* which breaks no lines */
    assert_true(plan_runs_model(&prepared.plan, STACK) && plan_runs_model(&prepared.plan, ALONE));
    all_surfaces_free(&prepared);
    scene_free(&scene);
    return text_string(table);
}

/* A plastic model alone tells what scale dependence adds. */
TEST_IN_DIRECTORY(test_the_plan)
{
    (void)plan_of(&whole);
    pipeline_rough(place, "in/a.csv", 128, 1, 1);
    directory_write(place, "in/scene.yaml", "material: tin\n" LOADS "effects: auto\nmodels: [registered]\n");
    const char *table = plan_of(place);
    expect_parts(table, "scale-dependent  run");
    expect_no_parts(table, " inf");
}

TEST_GROUP(make_whole, remove_whole)
