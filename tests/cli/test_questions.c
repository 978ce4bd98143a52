/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Questions that users ask, each answered on the first page with a value that is also in the data. */
#include "base/program.h"
#include "cli/process.h"

/** The first page of a report. */
static char *first_page(const char *place, const char *out)
{
    char *page = workspace_read(place, filled("%s/report.md", out)), *end = strstr(page, "\n---\n");
    assert_non_null(end);
    *end = '\0';
    return page;
}

/** The README's picture shows what is drawn today: words and lines, each point within a thousandth of its width. */
static void expect_kept_picture(const char *place, const char *path)
{
    char *kept = workspace_read(PROJECT_SOURCE, "surfaces/picture.svg"), *drawn = workspace_read(place, path);
    const char *a = strstr(kept, "<path"), *b = strstr(drawn, "<path");
    size_t numbers = 0;
    for (; *a && *b; numbers++) {
        size_t length = strcspn(a, "-.0123456789");
        double to[2] = {0, 0};
        bool alike = length == strcspn(b, "-.0123456789") && strncmp(a, b, length) == 0;
        char *behind[2] = {(char *)(a += length), (char *)(b += length)};
        if (alike && *a && *b) {
            to[0] = strtod(a, &behind[0]);
            to[1] = strtod(b, &behind[1]);
        }
        if (!alike || fabs(to[0] - to[1]) > 0.8)
            fail_msg(
                "surfaces/picture.svg is not what the connector's report draws today: run surfaces/make.sh, and look "
                "at README.md; it has '%.40s', not '%.40s'",
                a, b);
        a = behind[0] + (behind[0] == a && *a);
        b = behind[1] + (behind[1] == b && *b);
    }
    assert_true(numbers > 200);
    assert_int_equal(*a, *b);
}

/** The connector's numbers are those of docs/sample (test_samples.c); its picture is the README's. */
TEST_IN_WORKSPACE(a_connector)
{
    run_to_exit(place, 0, "report", PROJECT_SOURCE "/surfaces/connector", "-o", "out", "--no-cost");
    expect_kept_picture(place, "out/figures/answer.svg");
}

/** Where a filler keeps the metals apart, several scans say the same: its conductance, and no full contact. */
TEST_IN_WORKSPACE(a_bond_line)
{
    workspace_scan(place, "d/a/a-1.csv", 400, 1);
    workspace_scan(place, "d/a/a-2.csv", 400, 2);
    report_scene(place, "out",
                 "material: copper\ngap: {filler: silicone grease, bond_line: 50 um}\noperating_load: 1 MPa\n"
                 "load: {from: 0.1 MPa, to: 10 MPa, points: 21}\n");
    expect_part(first_page(place, "out"), "the joint conductance is 1.60·10⁴ W/(m²·K) on");
    assert_null(strstr(workspace_read(place, "out/report.md"), "full contact ("));
}

/** The conductance at 1 MPa, of a gap in air and of bare metal. */
TEST_IN_WORKSPACE(a_conductance)
{
    workspace_scan(place, "d/a.csv", 400, 1);
    report_scene(place, "gap",
                 "material: copper\nnominal_area: 1 mm2\ngap: {gas: air}\noperating_load: 1 MPa\n"
                 "load: {from: 0.1 MPa, to: 10 MPa, points: 21}\n");
    char *page = first_page(place, "gap");
    expect_parts(page, "**At 1.00\u00a0MPa the joint conductance is ", "\u00a0W/(m²·K) (95\u00a0%: ");
    json_t *headline = json_object_get(workspace_json(place, "gap/view.json"), "headline");
    expect_parts(page, "The gaps carry ", json_string_value(json_object_get(headline, "markdown")));
    expect_part(expect_exit(place, 0, "compare", "gap", "gap").out, "h_j (W/(m²·K))"); /* no resistance */
    report_scene(place, "bare",
                 "material: copper\neffects: [plasticity, thermal]\noperating_load: 1 MPa\n"
                 "load: {from: 0.1 MPa, to: 10 MPa, points: 21}\n");
    page = first_page(place, "bare");
    expect_part(page, "**At 1.00\u00a0MPa the contact conductance is ");
    const double shown = atof(strstr(page, "conductance is ") + strlen("conductance is "));
    struct table contact = workspace_table(place, "bare/data/contact.csv");
    size_t same = 0;
    for (size_t i = 0; i < contact.rows; i++) { /* 1/TCR of some model at that pressure, but for the power of ten */
        double decades = log10(table_number(&contact, i, "tcr_K_m2_per_W") * shown);
        same +=
            fabs(table_number(&contact, i, "pressure_Pa") / 1e6 - 1) < 1e-9 && fabs(decades - round(decades)) < 0.03;
    }
    assert_true(same >= 1);
}

/** What a reader has to go through. */
struct size {
    size_t words, tables, figures, columns; /* words outside tables, captions, headings; columns: most of a table */
};

static struct size size_of(const char *text)
{
    struct size out = {0};
    bool caption = false; /* of a table: to the next empty line */
    for (const char *line = text; *line; line += strcspn(line, "\n"), line += *line == '\n') {
        size_t length = strcspn(line, "\n"), columns = 0;
        caption = strncmp(line, "**Table", 7) == 0 || (caption && length > 0);
        out.tables += strncmp(line, "|---", 4) == 0;
        out.figures += strncmp(line, "![", 2) == 0;
        for (size_t i = 0; i < length && *line == '|'; i++)
            columns += line[i] == '|';
        out.columns = columns > out.columns + 1 ? columns - 1 : out.columns;
        for (size_t i = 0; i < length && !strchr("|!#", *line) && !caption; i++)
            out.words += line[i] != ' ' && (i == 0 || line[i - 1] == ' ');
    }
    return out;
}

/** Has the printed report a section of that head? */
static bool is_printed(const struct text *pdf, const char *head)
{
    const char *title = filled("/Title (%s)", head);
    const size_t length = strlen(title);
    for (size_t i = 0; i + length < pdf->length; i++)
        if (memcmp(pdf->data + i, title, length) == 0)
            return true;
    return false;
}

/** Sheets of A4 that a browser prints the report on, with the notes that it sends its reader to. */
static size_t sheets_of(const char *place)
{
    static const char mark[] = "/Type /Page";
    char to[4200], from[4200];
    snprintf(to, sizeof to, "--print-to-pdf=%s/out.pdf", place);
    snprintf(from, sizeof from, "file://%s/out/report.html", place);
    (void)expect_status(run_program(place, "chromium", "--headless", "--no-sandbox", "--disable-gpu",
                                    "--no-pdf-header-footer", "--generate-pdf-document-outline", to, from),
                        0);
    struct text *pdf = support_text();
    expect_ok(text_read_file, pdf, filled("%s/out.pdf", place));
    assert_true(is_printed(pdf, "The surfaces") && is_printed(pdf, "Inputs and notes"));
    assert_false(is_printed(pdf, "Methods and sources") || is_printed(pdf, "Appendices"));
    size_t sheets = 0;
    for (size_t i = 0; i + sizeof mark < pdf->length; i++)
        sheets += memcmp(pdf->data + i, mark, sizeof mark - 1) == 0 && pdf->data[i + sizeof mark - 1] != 's';
    return sheets;
}

/** A report is read in two minutes: its first page, and all of it, also on paper where a browser is there to print. The
 * scenes are those of surfaces/ at fewer loads, with a shorter direct solution and a smaller map. */
TEST_IN_WORKSPACE(no_longer_than_that)
{
    static const char *const runs[] = {"chapter6", "connector", "thermal-interface", "lapped-map"};
    char program[4096];
    bool prints = program_find(program, sizeof program, "chromium");
    for (size_t k = 0; k < sizeof runs / sizeof *runs; k++) {
        workspace_shell(place, filled("rm -rf in; cp -r " PROJECT_SOURCE "/surfaces/%s in; cd in;"
                                      " sed -i 's/points: 61/points: 7/; s/budget: 3 s/budget: 60 ms/' scene.yaml;"
                                      " [ ! -e lapped.sdf ] || " PROGRAM " synth --map --seed 5 -n 64 -l 0.128mm"
                                      " --gamma 1.25 --lambda-s 20um --rq 0.25um -o lapped.sdf",
                                      runs[k]));
        run_to_exit(place, 0, "report", "in", "-o", "out");
        char *whole = workspace_read(place, "out/report.md"), *first = first_page(place, "out");
        const struct size all = size_of(whole), page = size_of(first);
        assert_in_range(all.words, 300, 1000);
        assert_in_range(all.figures, 5, 13);
        assert_in_range(all.tables, 4, 11); /* with that of the equations */
        assert_in_range(page.words, 20, 230);
        assert_in_range(page.columns, 4, 8);
        assert_int_equal(page.tables, 1);
        assert_in_range(page.figures, 1, 2); /* the second: of several surfaces */
        json_t *view = workspace_json(place, "out/view.json");
        assert_in_range(json_array_size(json_object_get(view, "claims")), 3, 8);
        const char *headline = json_string_value(json_object_get(json_object_get(view, "headline"), "text"));
        assert_in_range(size_of(headline).words, 8, 30);
        if (k == 0)
            expect_parts(first, " on *3*", " on *4*");   /* of four surfaces the best and the worst */
        assert_in_range(times(first, "×÷\u00a0"), 1, 4); /* one of them measured */
        if (prints)
            assert_in_range(sheets_of(place), 3, 7);
    }
}
