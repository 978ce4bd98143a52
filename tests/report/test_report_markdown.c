/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The report as Markdown: a section is there when what it speaks of ran, and nothing is left where one is not. */
#include "report/section.h"
#include "run/pipeline.h"

#include <dirent.h>

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

/* Every chart that was drawn stands in the report, once. */
static void assert_every_figure_once(const struct directory *place, const struct text *report)
{
    size_t charts = 0;
    DIR *figures = opendir(directory_path(place, "out/figures"));
    assert_non_null(figures);
    for (const struct dirent *entry; (entry = readdir(figures));) {
        char link[400];
        const char *dot = strrchr(entry->d_name, '.');
        if (!dot || strcmp(dot, ".svg") != 0)
            continue;
        snprintf(link, sizeof link, "](figures/%s)", entry->d_name);
        const char *first = strstr(text_string(report), link);
        if (!first || strstr(first + 1, link))
            fail_msg("%s stands %s in the report", entry->d_name, first ? "twice" : "not");
        charts++;
    }
    closedir(figures);
    assert_in_range(charts, 30 + 11, 30 + 12); /* heights that are not Gaussian have one more */
}

/* The value of the baseline in a model at a load in contact.csv; NaN: no row, or an empty cell. */
static double contact_value(const struct table *contact, const char *surface, size_t model, double load,
                            const char *column)
{
    for (size_t row = 0; row < contact->rows; row++)
        if (strcmp(table_text(contact, row, "surface"), surface) == 0 &&
            strcmp(table_text(contact, row, "model"), model_rows[model]->name) == 0 &&
            fabs(table_number(contact, row, "load_over_AnEp") / load - 1) < 1e-9 && *table_text(contact, row, column))
            return table_number(contact, row, column);
    return NAN;
}

/* Which column the table compares: statistical separations are the adjusted ones. */
static double ratio_value(const struct table *contact, size_t model, double load, int quantity)
{
    static const char *const columns[] = {"area_ratio", "separation_over_sigma", "ecr_ohm_m2"};
    bool adjusted = quantity == 1 && model_rows[model]->asperity_model;
    return contact_value(contact, "b", model, load, adjusted ? "adjusted_separation_over_sigma" : columns[quantity]);
}

/* A label may have a mark behind it: heights that are not Gaussian. */
static size_t model_labelled(const char *label, size_t length)
{
    const char *mark = memmem(label, length, "\u00a0‡", strlen("\u00a0‡"));
    length = mark ? (size_t)(mark - label) : length;
    for (size_t m = 0; m < model_count; m++)
        if (strlen(model_rows[m]->label) == length && strncmp(model_rows[m]->label, label, length) == 0)
            return m;
    fail_msg("no model '%.*s'", (int)length, label);
    return model_count;
}

/* A number as reports print it: "3.16·10⁻⁴", "−0.21", "12"; NaN for "–". */
static double printed_number(const char *text)
{
    static const char *const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    bool negative = strncmp(text, "−", strlen("−")) == 0, down = false;
    char *at;
    double number = strtod(negative ? text + strlen("−") : text, &at);
    int exponent = 0;
    if (strncmp(text, "–", strlen("–")) == 0)
        return NAN;
    if (strncmp(at, "·10", strlen("·10")) == 0) {
        at += strlen("·10");
        down = strncmp(at, "⁻", strlen("⁻")) == 0;
        at += down ? strlen("⁻") : 0;
        for (int d = 0; d < 10; d++)
            if (strncmp(at, digits[d], strlen(digits[d])) == 0) {
                exponent = 10 * exponent + d;
                at += strlen(digits[d]);
                d = -1;
            }
    }
    return (negative ? -1 : 1) * number * pow(10, down ? -exponent : exponent);
}

/* The ratios of the section on two bands are those of contact.csv, at the quarters of the list of loads. */
static void assert_ratios(const struct directory *place, const struct text *report)
{
    struct table contact = table_read_path(directory_path(place, "out/data/contact.csv"));
    const char *section = strstr(text_string(report), "\n## Two bands\n");
    assert_non_null(section);
    const char *line = strstr(section, "\n| P/(Aₙ E′) | model | over | area | separation | ECR |\n|");
    size_t rows = 0, numbers = 0;
    assert_non_null(line);
    line = strchr(strchr(line + 1, '\n') + 1, '\n') + 1; /* behind the rule */
    for (; *line == '|'; line = strchr(line, '\n') + 1, rows++) {
        const char *cell[6], *at = line + 2;
        size_t length[6];
        for (int c = 0; c < 6; c++) {
            cell[c] = at;
            length[c] = (size_t)(strstr(at, " |") - at);
            at += length[c] + 3;
        }
        /* of nine loads from 1e-6 to 1 the third, fifth and seventh */
        double load = pow(10, round(log10(printed_number(cell[0])) / 0.75) * 0.75);
        assert_near(printed_number(cell[0]), load, 0.005);
        size_t model = model_labelled(cell[1], length[1]), by = model_labelled(cell[2], length[2]);
        assert_int_equal(by, model_named(model_rows[model]->plastic ? "corrected-persson-plastic" : "corrected-persson"));
        for (int q = 0; q < 3; q++) {
            double ratio = ratio_value(&contact, model, load, q) / ratio_value(&contact, by, load, q);
            double shown = printed_number(cell[3 + q]);
            assert_true(isfinite(ratio) == isfinite(shown));
            if (isfinite(shown) && fabs(ratio) > 1e-12) {
                assert_near(shown, ratio, 0.0051);
                numbers++;
            }
        }
    }
    assert_true(rows >= 3 * 4 && numbers > 15);
    table_free(&contact);
}

/* A caption of chapter 6 names the models of its chart only. */
static void assert_captions_name_what_is_drawn(const struct text *report)
{
    const char *from = strstr(report->data, "![Figure 6-05."), *end = strstr(report->data, "](figures/6-09.svg)");
    assert_true(from && end && from < end);
    for (const char *chart = from; chart && chart < end; chart = strstr(chart + 1, "![Figure 6-0")) {
        const char *named = strstr(chart, "two-band"), *closed = strstr(chart, "](figures/");
        assert_true(!named || named > closed);
    }
}

TEST_CASE(test_everything)
{
    struct text report = report_of(*state, LOADS ALL_EFFECTS);
    assert_every_figure_once(*state, &report);
    assert_captions_name_what_is_drawn(&report);
    assert_ratios(*state, &report);
    assert_headings(&report, "# in\n## The surfaces\n## Material and load\n"
                             "## Does the area converge as smaller scales are included?\n"
                             "## Surface b in every model\n### Real contact area\n### Separation\n"
                             "### Electrical contact resistance\n### Thermal contact resistance\n## Two bands\n"
                             "## All surfaces, model by model\n### Area against load\n### Separation against load\n"
                             "### Separation against area\n### ECR against load\n### TCR against load\n"
                             "## Where the models may be trusted\n"
                             "## What the answers hang on: cut-off, scan length, hardness\n"
                             "# Appendices\n## The findings of chapter 6, checked on these surfaces\n"
                             "## What was computed\n## Models and sources\n");
    assert_tidy(*state, &report);
    text_free(&report);
}

/* One effect and one family: nothing of the others. */
TEST_CASE(test_what_did_not_run_is_not_spoken_of)
{
    struct text report =
        report_of(*state, LOADS "effects: [electrical]\nmodels: [statistical]\nsurfaces: [{name: x, file: a.csv}]\n");
    assert_headings(&report, "# in\n## The surfaces\n## Material and load\n## Surface x in every model\n"
                             "### Real contact area\n### Electrical contact resistance\n"
                             "## All surfaces, model by model\n### Area against load\n### ECR against load\n"
                             "## Where the models may be trusted\n"
                             "## What the answers hang on: cut-off, scan length, hardness\n"
                             "# Appendices\n## The findings of chapter 6, checked on these surfaces\n"
                             "## What was computed\n## Models and sources\n");
    assert_tidy(*state, &report);
    *strstr(report.data, "## What was computed") = '\0'; /* which says what was skipped and why */
    static const char *const others[] = {"TCR", "ultiscale", "JG", "β", "Smoother surfaces"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (strstr(report.data, others[i]))
            fail_msg("'%s' in the report: %.200s", others[i], strstr(report.data, others[i]));
    text_free(&report);
}

/* Every effect alone, in either family. */
TEST_CASE(test_each_effect_alone_leaves_no_gap)
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
TEST_CASE(test_repeats_and_measurements)
{
    directory_write(*state, "ecr.txt", "1e-5, 1e-9\n1e-4, 1e-10\n");
    struct text report =
        report_of(*state, LOADS "effects: [electrical]\nmodels: [multiscale, statistical]\n"
                                "surfaces: [{name: both, file: [a.csv, b.csv]}]\n"
                                "measured: {file: ../ecr.txt, quantity: ecr, load_unit: dimensionless, "
                                "resistance_unit: ohm m2}\n");
    assert_headings(&report, "# in\n## The surfaces\n## Material and load\n## Surface both in every model\n"
                             "### Real contact area\n### Electrical contact resistance\n"
                             "## All surfaces, model by model\n### Area against load\n### ECR against load\n"
                             "## Where the models may be trusted\n"
                             "## What the answers hang on: cut-off, scan length, hardness\n"
                             "## How sure the numbers are\n## Measured contact resistance\n"
                             "# Appendices\n## The findings of chapter 6, checked on these surfaces\n"
                             "## What was computed\n## Models and sources\n");
    assert_tidy(*state, &report);
    text_free(&report);
}

/* A long wave that closes at sqrt(2) pi D/l (4.4, 4.6), far below the short one on it: there the curve has its kink,
 * and its caption says so. One wave alone has none. */
TEST_CASE(test_kinks_are_where_scales_close)
{
    static const double amplitude_m = 1e-7, wavelength_m = 1e-4, short_m[] = {1e-7, 0};
    const double load = sqrt(2) * M_PI * amplitude_m / wavelength_m;
    const struct directory *place = *state;
    mkdir(directory_path(place, "waves"), 0777);
    for (int k = 0; k < 2; k++) {
        double height_m[200];
        for (int i = 0; i < 200; i++)
            height_m[i] =
                amplitude_m * cos(2 * M_PI * i / 200) + short_m[k] * cos(2 * M_PI * i / 20 + 1) + 1e-12 * ((i * 7) % 5);
        pipeline_scan(place, "waves/w.csv", height_m, 200);
        directory_write(place, "waves/scene.yaml",
                        "material: tin\neffects: [electrical]\nmodels: [multiscale-elastic]\n"
                        "load: {from: 1e-4, to: 0.1, points: 91}\n");
        assert_int_equal(pipeline_run(place, "waves", "out-waves", 1), 0);
        struct text report = directory_read(place, "out-waves/report.md");
        const char *kink = strstr(report.data, "its resistance is gone: multiscale elastic at ");
        assert_int_equal(kink != NULL, k == 0);
        if (kink) {
            double digits, micrometres;
            int power;
            kink = strstr(kink, " at ");
            assert_int_equal(sscanf(kink, " at %lf·10⁻%n", &digits, &power), 1);
            assert_int_equal(strncmp(kink + power, "³ (wavelength ", strlen("³ (wavelength ")), 0);
            assert_near(digits * 1e-3, load, 0.02);
            assert_int_equal(sscanf(strchr(kink, 'w'), "wavelength %lf µm)", &micrometres), 1);
            assert_near(micrometres, 100, 1e-3);
        }
        text_free(&report);
    }
}

/* Where a chart cuts the statistical models' own separation, its caption says how far they go down. */
TEST_CASE(test_a_cut_is_told_with_what_is_cut)
{
    struct text report =
        report_of(*state, "material: tin\nload: {from: 1e-6, to: 1, points: 60}\nmodels: [gw, corrected-persson]\n"
                          "effects: [separation]\nsurfaces: [{name: b, file: b.csv}]\n");
    struct text contact = directory_read(*state, "out/data/contact.csv");
    double lowest = INFINITY, told;
    for (const char *line = contact.data; (line = strchr(line, '\n')) && *++line;) {
        double separation;
        if (sscanf(line, "b,gw,%*[^,],%*[^,],%*[^,],%*[^,],%lf", &separation) == 1)
            lowest = fmin(lowest, separation);
    }
    assert_true(lowest < -0.5);
    static const char *const charts[] = {"![Figure 6-06.", "![Figure 6-07.", "![Separation against load, every model"};
    for (size_t i = 0; i < 3; i++) {
        const char *chart = strstr(report.data, charts[i]);
        assert_non_null(chart);
        const char *cut = strstr(chart, " Cut at −0.5 σ: unadjusted, GW goes down to −");
        assert_true(cut && cut < strstr(chart, "](figures/"));
        assert_int_equal(sscanf(strstr(cut, " to −") + strlen(" to −"), "%lf", &told), 1);
        assert_near(-told, lowest, 0.05);
    }
    text_free(&contact);
    text_free(&report);
}

TEST_GROUP(place_setup, directory_teardown)
