/* The report as Markdown: a section is there when what it speaks of ran, and nothing is left where one is not. */
#include "report/section.h"
#include "run/pipeline.h"

#define ALL_EFFECTS "effects: [plasticity, separation, electrical, thermal, scale-dependent, convergence]\n"
#define LOADS       "material: tin\nload: {from: 1e-6, to: 1, points: 9}\nconvergence: {scales: 20}\n"

static int place_setup(void **state)
{
    static struct directory place;
    place = directory_make();
    mkdir(directory_path(&place, "in"), 0777);
    pipeline_rough(&place, "in/a.csv", 120, 0.1, 1);
    pipeline_rough(&place, "in/b.csv", 120, 1, 2);
    *state = &place;
    return 0;
}

static int place_teardown(void **state)
{
    directory_remove(*state);
    return 0;
}

/* The report of a scene. */
static struct text report_of(const struct directory *place, const char *scene)
{
    directory_write(place, "in/scene.yaml", scene);
    assert_int_equal(pipeline_run(place, "in", "out", 1), 0);
    return directory_read(place, "out/report.md");
}

/* The headings, one a line. */
static void assert_headings(const struct text *report, const char *expected)
{
    struct text headings = {0};
    for (const char *line = text_string(report), *end; (end = strchr(line, '\n')); line = end + 1)
        if (line[0] == '#')
            text_add_bytes(&headings, line, (size_t)(end - line) + 1);
    assert_string_equal(text_string(&headings), expected);
    text_free(&headings);
}

/* No gap where something is left out, no empty section, no number that is none, every chart drawn. */
static void assert_tidy(const struct directory *place, const struct text *report)
{
    static const char *const never[] = {"\n\n\n", "(null)", "nan", "inf ", "inf\n", "{{", "}}"};
    for (size_t i = 0; i < sizeof never / sizeof *never; i++)
        if (strstr(report->data, never[i]))
            fail_msg("'%s' in\n%s", never[i], strstr(report->data, never[i]));
    size_t charts = 0;
    for (const char *chart = report->data; (chart = strstr(chart, "](figures/")); charts++) {
        char name[128];
        assert_int_equal(sscanf(chart, "](%100[^)])", name + 4), 1);
        memcpy(name, "out/", 4);
        assert_true(directory_has(place, name));
        chart += 2;
    }
    assert_true(charts > 0);
    for (const char *line = strchr(report->data, '\n'); line; line = strchr(line + 1, '\n')) {
        if (strncmp(line, "\n## ", 4) != 0 && strncmp(line, "\n### ", 5) != 0)
            continue;
        const char *next = strchr(line + 1, '\n');
        assert_non_null(next);
        assert_true(line[-1] == '\n' && next[1] == '\n' && next[2] != '\0'); /* an empty line before and behind */
        bool deeper = line[3] == ' ' && strncmp(next + 2, "### ", 4) == 0;
        assert_true(next[2] != '#' || deeper);
    }
}

static void test_everything(void **state)
{
    struct text report = report_of(*state, LOADS ALL_EFFECTS);
    assert_headings(&report, "# in\n## The surfaces\n## Material and load\n"
                             "## Does the area converge as smaller scales are included?\n"
                             "## Surface b in every model\n### Real contact area\n### Separation\n"
                             "### Electrical contact resistance\n### Thermal contact resistance\n"
                             "## All surfaces, model by model\n### Area against load\n### Separation against load\n"
                             "### Separation against area\n### ECR against load\n### TCR against load\n"
                             "## The findings of chapter 6, checked on these surfaces\n"
                             "## Where the models may be trusted\n## What was computed\n## Models and sources\n");
    assert_tidy(*state, &report);
    text_free(&report);
}

/* One effect and one family: nothing of the others. */
static void test_what_did_not_run_is_not_spoken_of(void **state)
{
    struct text report =
        report_of(*state, LOADS "effects: [electrical]\nmodels: [statistical]\nsurfaces: [{name: x, file: a.csv}]\n");
    assert_headings(&report, "# in\n## The surfaces\n## Material and load\n## Surface x in every model\n"
                             "### Real contact area\n### Electrical contact resistance\n"
                             "## All surfaces, model by model\n### Area against load\n### ECR against load\n"
                             "## The findings of chapter 6, checked on these surfaces\n"
                             "## Where the models may be trusted\n## What was computed\n## Models and sources\n");
    assert_tidy(*state, &report);
    *strstr(report.data, "## What was computed") = '\0'; /* which says what was skipped and why */
    static const char *const others[] = {"TCR", "ultiscale", "JG", "β", "Smoother surfaces"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (strstr(report.data, others[i]))
            fail_msg("'%s' in the report: %.200s", others[i], strstr(report.data, others[i]));
    text_free(&report);
}

/* Every effect alone, in either family. */
static void test_each_effect_alone_leaves_no_gap(void **state)
{
    static const char *const families[] = {"multiscale", "statistical"};
    static const char *const effects[] = {"", "plasticity", "separation", "electrical", "thermal", "convergence"};
    for (size_t f = 0; f < 2; f++)
        for (size_t e = 0; e < sizeof effects / sizeof *effects; e++) {
            char scene[400];
            snprintf(scene, sizeof scene, LOADS "effects: [%s]\nmodels: [%s]\n", effects[e], families[f]);
            struct text report = report_of(*state, scene);
            assert_tidy(*state, &report);
            text_free(&report);
        }
}

/* Repeated scans and a measured resistance have sections of their own. */
static void test_repeats_and_measurements(void **state)
{
    directory_write(*state, "ecr.txt", "1e-5, 1e-9\n1e-4, 1e-10\n");
    struct text report =
        report_of(*state, LOADS "effects: [electrical]\nsurfaces: [{name: both, file: [a.csv, b.csv]}]\n"
                                "measured: {file: ../ecr.txt, quantity: ecr, load_unit: dimensionless, "
                                "resistance_unit: ohm m2}\n");
    assert_headings(&report, "# in\n## The surfaces\n## Material and load\n## Surface both in every model\n"
                             "### Real contact area\n### Electrical contact resistance\n"
                             "## All surfaces, model by model\n### Area against load\n### ECR against load\n"
                             "## The findings of chapter 6, checked on these surfaces\n"
                             "## How far repeated scans lie apart\n## Measured contact resistance\n"
                             "## Where the models may be trusted\n## What was computed\n## Models and sources\n");
    assert_tidy(*state, &report);
    text_free(&report);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_everything),
        cmocka_unit_test(test_what_did_not_run_is_not_spoken_of),
        cmocka_unit_test(test_each_effect_alone_leaves_no_gap),
        cmocka_unit_test(test_repeats_and_measurements),
    };
    return cmocka_run_group_tests(tests, place_setup, place_teardown);
}
