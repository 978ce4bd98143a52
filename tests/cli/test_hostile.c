/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Names and titles that try to be code: they appear as what they are, and run nowhere. */
#include "cli/process.h"

#include <jansson.h>
#include <stdio.h>
#include <unistd.h>

static const char *const names[] = {
    "it's",
    "double\"quote",
    "back\\slash",
    "$(touch PWNED)",
    "`touch PWNED`",
    "; touch PWNED #",
    "new\nline",
    "<script>alert(1)<!--",
    "</title></svg></table>",
    "a|b",
    "{{body}} {{title}}",
    "100%d%s%n",
    "@{^a}_{b}~c",
    "grün µ€ 粗さ",
    "no \xff\xfe UTF-8 \xc3",
    "escape \x1b[31m\x9b",
    "-dash",
    "  blanks  ",
    "=cmd,x;y\ttab",
    "&amp;&lt;b&gt;",
    "x](javascript:alert(1)) ![i](http://a.b/c) <http://a.b>",
    "# **bold** _it_ ~~no~~ `code` [1]: x",
    "![a](figures/answer.svg)",
};
enum { NAMES = sizeof names / sizeof *names };

/** Is `name` of the page's own tags, and none that could do something? */
static bool tag_allowed(const char *name, size_t length)
{
    static const char *const allowed[] = {
        "!doctype",    "html",    "head",     "meta",    "title",      "style", "body",     "main",
        "nav",         "header",  "footer",   "details", "summary",    "h1",    "h2",       "h3",
        "h4",          "p",       "ul",       "ol",      "li",         "a",     "b",        "i",
        "em",          "strong",  "code",     "pre",     "br",         "hr",    "div",      "span",
        "table",       "thead",   "tbody",    "tr",      "th",         "td",    "figure",   "figcaption",
        "svg",         "g",       "defs",     "path",    "text",       "tspan", "use",      "rect",
        "circle",      "line",    "polyline", "polygon", "ellipse",    "desc",  "clippath", "lineargradient",
        "stop",        "section", "article",  "aside",   "blockquote", "del",   "filter",   "feflood",
        "fecomposite", "symbol",  "pattern",  "sup",     "sub",        "label", "input",    "script",
        "button",      "img",
    };
    for (size_t i = 0; i < sizeof allowed / sizeof *allowed; i++)
        if (strlen(allowed[i]) == length && strncasecmp(name, allowed[i], length) == 0)
            return true;
    return false;
}

/** Goes over the tags: each is known, closed where it must be in the order opened, and has no attribute that runs. */
static void scan_tags(const char *html)
{
    enum { DEPTH = 100, LONGEST = 32 };
    static const char *const empty[] = {"meta", "br", "hr", "input", "!doctype", "img"};
    char open[DEPTH][LONGEST];
    size_t depth = 0, tags = 0;
    for (const char *at = strchr(html, '<'); at; at = strchr(at, '<')) {
        at++;
        if (strncmp(at, "!--", 3) == 0) {
            assert_non_null(at = strstr(at, "-->"));
            continue;
        }
        bool closing = *at == '/';
        at += closing;
        size_t length = strcspn(at, " \t\r\n/>");
        if (length >= LONGEST || !tag_allowed(at, length))
            fail_msg("unexpected tag <%.40s", at);
        if (!closing && strncmp(at, "script", length) == 0) /* the page's own, which its policy names by its hash */
            assert_int_equal(strncmp(at, "script>\n// Tables of several rows", 33), 0);
        if (strncmp(at, "img ", 4) == 0) /* a chart, in the page */
            assert_non_null(strstr(at, "\" src=\"data:image/svg+xml;base64,"));
        const char *end = at;
        for (char quote = 0; *end && (quote || *end != '>'); end++)
            if (*end == '"')
                quote = quote ? 0 : '"';
        assert_int_equal(*end, '>');
        bool value = false; /* between quotes nothing runs: names stand there, escaped */
        for (const char *a = at; a < end; value ^= *a++ == '"')
            if (!value && strncasecmp(a, " on", 3) == 0 && strcspn(a + 1, "= >\"") < 14 &&
                a[1 + strcspn(a + 1, "= >\"")] == '=')
                fail_msg("attribute that runs: %.60s", a);
        bool lone = end[-1] == '/';
        for (size_t i = 0; i < sizeof empty / sizeof *empty; i++)
            lone |= strlen(empty[i]) == length && strncasecmp(at, empty[i], length) == 0;
        if (closing) {
            if (depth == 0 || strlen(open[depth - 1]) != length || strncmp(open[depth - 1], at, length) != 0)
                fail_msg("</%.20s closes <%s>", at, depth ? open[depth - 1] : "");
            depth--;
        } else if (!lone) {
            assert_true(depth < DEPTH);
            snprintf(open[depth++], LONGEST, "%.*s", (int)length, at);
        }
        if (!closing && length == 5 && strncmp(at, "style", 5) == 0)
            assert_non_null(end = strstr(end, "</style>") - 1);
        at = end;
        tags++;
    }
    assert_int_equal(depth, 0);
    assert_true(tags > 100);
}

static void assert_clean_text(const char *text, const char *where)
{
    process_expect_clean(text, strlen(text), where, true);
}

/** Every row of a Markdown table has as many cells as its header. */
static void assert_tables_whole(const char *markdown)
{
    size_t expected = 0, rows = 0;
    for (const char *line = markdown; *line;) {
        size_t length = strcspn(line, "\n"), cells = 0;
        if (line[0] == '|') {
            for (size_t i = 0; i < length; i++)
                cells += line[i] == '|' && (i == 0 || line[i - 1] != '\\');
            if (expected && cells != expected)
                fail_msg("%zu borders, not %zu: %.*s", cells, expected, (int)length, line);
            rows++;
        }
        expected = cells;
        line += length + (line[length] == '\n');
    }
    assert_true(rows > 3 * NAMES);
}

static void write_hostile_scene(const char *place, const char *scene)
{
    for (unsigned i = 0; i < NAMES; i++) {
        char path[128];
        /* no '/' in a file name */
        snprintf(path, sizeof path, "d/%s.csv", names[i]);
        for (char *slash = strchr(path + 2, '/'); slash; slash = strchr(slash, '/'))
            *slash = ':';
        workspace_scan(place, path, 100, i + 1);
    }
    char file[256];
    snprintf(file, sizeof file, "d/%0240d.csv", 1);
    workspace_scan(place, file, 100, 99);
    if (scene)
        workspace_write(place, "d/scene.yaml", scene);
}

static void check_report(const char *place, const char *report)
{
    static const char *const files[] = {"report.html", "report.md", "results.json"};
    char path[64];
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        snprintf(path, sizeof path, "%s/%s", report, files[i]);
        char *text = workspace_read(place, path);
        assert_clean_text(text, files[i]);
        if (i == 0)
            scan_tags(text);
        if (i == 1)
            assert_tables_whole(text);
        free(text);
    }
}

TEST_IN_WORKSPACE(test_file_names)
{
    write_hostile_scene(place, NULL);
    struct process process = expect_exit(place, 0, "report", "d", "--show", "-m", "tin", "-e", "plasticity,separation");
    assert_clean_text(process.out, "stdout");
    assert_clean_text(process.err, "stderr");
    process_free(&process);
    check_report(place, "out/d");
    assert_false(workspace_has(place, "PWNED"));
    assert_false(workspace_has(place, "d/PWNED"));
    assert_int_equal(workspace_count(place, "PWNED"), 0);

    expect_in_file(place, "out/d/report.html", "&#60;script&#62;alert(1)&#60;!--", "new\\x0aline",
                   "no \\xff\\xfe UTF-8 \\xc3", "grün µ€ 粗さ", "{{body}} {{title}}", "&#38;amp;&#38;lt;b&#38;gt;");
    expect_in_file(place, "out/d/data/surfaces.csv", "\n\"double\"\"quote\",\"double\"\"quote.csv\",100,",
                   "\nnew\\x0aline,new\\x0aline.csv,100,", "\n\"'=cmd,x;y\\x09tab\",", "\na|b,a|b.csv,100,");

    json_t *json = workspace_json(place, "out/d/results.json");
    assert_int_equal(json_array_size(json_object_get(json, "surfaces")), NAMES + 1);
    json_decref(json);
}

TEST_IN_WORKSPACE(test_drawings)
{
    write_hostile_scene(place, "baseline: \"</title></svg><:table>\"\n");
    expect_failure(place, 3, 1, "'baseline' is '</title></svg><:table>', no surface's name", "report", "d");
    workspace_write(place, "d/scene.yaml", "material: tin\nbaseline: \"a|b\"\neffects: [plasticity]\n");
    run_to_exit(place, 0, "report", "d");
    static const char *const figures[] = {"answer", "surfaces", "area", "models"};
    for (size_t i = 0; i < sizeof figures / sizeof *figures; i++) {
        char path[64];
        snprintf(path, sizeof path, "out/d/figures/%s.svg", figures[i]);
        char *svg = workspace_read(place, path);
        assert_clean_text(svg, path);
        expect_no_parts(svg, "<script", "</title></svg><");
        free(svg);
    }
}

TEST_IN_WORKSPACE(test_title_and_names_of_the_scene)
{
    workspace_scan(place, "d/a.csv", 100, 1);
    workspace_write(
        place, "d/scene.yaml",
        "title: \"</title><script>alert('t')</script> # **b** {{body}} $(touch PWNED) | [x](javascript:1)\"\n"
        "effects: [plasticity]\n"
        "material: {E_Pa: 1e11, nu: 0.3, Sy_Pa: 1e8}\n"
        "surfaces:\n"
        "  - {name: \"<img src=x onerror=alert(1)> | ' \\\" \\\\\", file: a.csv}\n"
        "  - {name: \"{{title}} %n `x` $(id)\", file: a.csv}\n");
    run_to_exit(place, 0, "report", "d", "--show");
    char *html = workspace_read(place, "out/d/report.html");
    scan_tags(html);
    expect_parts(html, "<title>&lt;/title&gt;&lt;script&gt;alert('t')", "&#60;img src=x onerror=alert(1)&#62;");
    expect_no_part(html, "href=\"javascript");
    free(html);
    assert_int_equal(workspace_count(place, "PWNED"), 0);
    workspace_write(place, "d/scene.yaml", "surfaces:\n  - {name: \"one\\n# two\", file: a.csv}\n");
    expect_failure(place, 3, 1, "d/scene.yaml:2: 'name' has a line end or control character inside; remove it",
                   "report", "d");
    workspace_write(place, "d/scene.yaml", "title: \"two\\nlines\"\n");
    expect_failure(place, 3, 1, "d/scene.yaml:1: 'title' has a line end", "report", "d");
}

/** Refusals quote hostile names and contents; the terminal gets none of their control characters. */
TEST_IN_WORKSPACE(test_refusals)
{
    workspace_scan(place, "d/good.csv", 100, 1);
    workspace_write(place, "d/bad \x1b[31m\n<b>|\xff.csv", "x [um],z [um]\n0,1\n1,2\n2,<script>\x1b]0;\x07\n");
    struct process process = expect_exit(place, 1, "report", "d", "-m", "tin", "-e", "plasticity");
    assert_clean_text(process.err, "stderr");
    expect_part(process.err, "surface 'bad \\x1b[31m\\x0a<b>|\\xff' refused: ");
    process_free(&process);
    char *html = workspace_read(place, "out/d/report.html");
    char *markdown = workspace_read(place, "out/d/report.md");
    scan_tags(html);
    assert_clean_text(html, "report.html");
    assert_clean_text(markdown, "report.md");
    expect_part(html, "bad \\x1b[31m\\x0a&#60;b&#62;|\\xff");
    free(html);
    free(markdown);
    process = expect_exit(place, 4, "inspect", "d/no\x1b[31m", "d/bad \x1b[31m\n<b>|\xff.csv");
    assert_clean_text(process.err, "stderr");
    process_free(&process);
    process = expect_exit(place, 4, "inspect", "--json", "d/bad \x1b[31m\n<b>|\xff.csv");
    assert_clean_text(process.out, "stdout");
    json_t *json = json_loads(process.out, 0, NULL);
    assert_non_null(json);
    json_decref(json);
    process_free(&process);
}
