/* SPDX-License-Identifier: GPL-3.0-or-later */
/* docs/report.md against a report: every file of data/ and every column, key and section is described. */
#include "cli/process.h"
#include "contact/model.h"

enum { NAME = 128 };

/** Fails unless the document has `name` between `before` and `after`. */
static void expect_described(const char *document, const char *before, const char *name, const char *after)
{
    if (!strstr(document, filled("%s%s%s", before, name, after)))
        fail_msg("docs/report.md does not have %s%s%s", before, name, after);
}

/** `name` as the document has it: `<model>` for a model's name, nothing for the ends of a band. */
static void generic(char out[NAME], const char *name)
{
    static const char *const ends[] = {"_mean_low_95", "_mean_high_95", "_next_scan_low_95", "_next_scan_high_95"};
    snprintf(out, NAME, "%s", name);
    size_t length = strlen(out);
    for (size_t m = 0; m < model_count; m++) {
        size_t model = strlen(model_rows[m]->name);
        if (length > model && out[length - model - 1] == '_' &&
            strcmp(out + length - model, model_rows[m]->name) == 0) {
            snprintf(out + length - model, NAME - (length - model), "<model>");
            return;
        }
    }
    for (size_t e = 0; e < sizeof ends / sizeof *ends; e++)
        if (length > strlen(ends[e]) && strcmp(out + length - strlen(ends[e]), ends[e]) == 0)
            out[length - strlen(ends[e])] = '\0';
}

/** The text below the one heading that names a file of data/. */
static char *read_chapter(const char *document, const char *file)
{
    char *chapter = NULL;
    for (const char *at = document; (at = strstr(at, "\n## ")); at++) {
        size_t heading = strcspn(at + 1, "\n") + 1;
        const char *named = strstr(at, file), *end = strstr(at + heading, "\n## ");
        if (!named || named >= at + heading)
            continue;
        if (chapter)
            fail_msg("docs/report.md has two chapters on data/%s", file);
        chapter = lasting("%.*s", (int)(end ? (size_t)(end - at) - heading : strlen(at + heading)), at + heading);
    }
    if (!chapter)
        fail_msg("docs/report.md has no chapter on data/%s", file);
    return chapter;
}

/** The columns of a table in the chapter of its name. */
static size_t check_columns(const char *document, const char *place, const char *file)
{
    char name[NAME];
    char *table = workspace_read(place, filled("out/data/%s", file)), *rest = table;
    char *chapter = read_chapter(document, file);
    table[strcspn(table, "\n")] = '\0';
    size_t columns = 0;
    for (char *column; (column = strsep(&rest, ","));) {
        generic(name, column);
        const char *quote = strcmp(name, column) == 0 || strchr(name, '<') ? "`" : ""; /* a band's are listed without */
        expect_described(chapter, quote, name, quote);
        columns++;
    }
    return columns;
}

/** Headings of the report, but for names and the title. */
static size_t check_sections(const char *document, const char *place)
{
    char *report = workspace_read(place, "out/report.md");
    size_t sections = 0;
    for (char *at = report; (at = strstr(at, "\n## ")); at++) {
        expect_described(document, "| ", filled("%.*s", (int)strcspn(at + 4, "\n"), at + 4), " |");
        sections++;
    }
    return sections;
}

TEST_IN_WORKSPACE(report_is_described)
{
    static const char *const tables[] = {"surfaces.csv",     "spectrum.csv",    "contact.csv", "convergence.csv",
                                         "cost.csv",         "spread.csv",      "bands.csv",   "direct.csv",
                                         "direct_ratio.csv", "sensitivity.csv", "answers.csv", "limits.csv"};
    char *document = workspace_read(PROJECT_SOURCE, "docs/report.md");
    workspace_scans(place, "in", 5, 300, 1); /* d and e are the counterface's */
    workspace_write(place, "in/broken.csv", "x [um],z [um]\n0,1\n1,two\n");
    workspace_write(place, "in/ecr.txt", "load_N,ecr_mohm\n1,10\n2,6\n4,3\n");
    workspace_write(
        place, "in/scene.yaml",
        "material: tin\neffects: [plasticity, separation, electrical, thermal, scale-dependent, convergence]\n"
        "load: {from: 1e-6, to: 1e-2, points: 7}\nnominal_area_m2: 1e-6\n"
        "convergence: {scales: 64}\ndirect: {grid: 64, seeds: 1, loads: [1e-3, 5e-3]}\ncounterface: "
        "{surface: [d.csv, e.csv], material: copper}\n"
        "measured: {file: ecr.txt, quantity: ecr}\n"
        "targets: [{ecr: 1 mohm}]\nlimits: {ecr: {most: 1 mohm}}\n"
        "surfaces:\n  - {name: one, file: [a.csv, b.csv]}\n  - {name: two, file: c.csv}\n"
        "  - {name: three, file: broken.csv}\n");
    run_to_exit(place, 1, "report", "in", "-o", "out");
    size_t columns = 0;
    for (size_t i = 0; i < sizeof tables / sizeof *tables; i++)
        columns += check_columns(document, place, tables[i]);
    assert_true(columns > 50);
    assert_true(expect_keys_described(document, workspace_json(place, "out/results.json"), true) > 200);
    size_t sections = check_sections(document, place);
    workspace_write(place, "in/scene.yaml", "surfaces: [{name: two, file: c.csv}]\n"); /* a smooth counterface */
    run_to_exit(place, 0, "report", "in", "-o", "out");
    check_sections(document, place);
    assert_int_equal(sections, 12); /* all but the joint's */
}

/** The lines that docs/tutorial.md quotes behind "> " stand in the report that it speaks of. */
TEST_IN_WORKSPACE(tutorial_quotes_the_report)
{
    char *document = workspace_read(PROJECT_SOURCE, "docs/tutorial.md");
    run_to_exit(place, 6, "report", PROJECT_SOURCE "/surfaces/connector", "-o", "out", "--no-cost", "--check");
    size_t quotes = 0;
    for (char *at = strtok(document, "\n"); at; at = strtok(NULL, "\n")) {
        if (strncmp(at, "> ", 2) != 0)
            continue;
        expect_in_file(place, "out/report.md", at + 2);
        quotes++;
    }
    assert_true(quotes >= 5);
    document = workspace_read(PROJECT_SOURCE, "docs/tutorial.md"); /* and the columns that it names are there */
    size_t columns = 0;
    for (const char *at = document; (at = strstr(at, "column `")); columns++) {
        char column[NAME], file[NAME];
        assert_int_equal(sscanf(at, "column `%99[^`]` of `data/%99[^`]`", column, file), 2);
        struct table table = workspace_table(place, filled("out/data/%s", file));
        assert_non_null(table_text(&table, 0, column)); /* fails of itself where there is none */
        at++;
    }
    assert_int_equal(columns, 1);
}
