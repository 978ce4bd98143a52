/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surfaces whose names hold control characters, bidirectional overrides, bytes that are no UTF-8, formulas, and code of
 * shells, gnuplot or HTML: all that is written and printed is checked byte by byte and read back. */
#include "cli/process.h"
#include "hard_case.h"

#include <expat.h>

HARD_CASES("Names and words that mean something elsewhere")

/* A name and how the tables have it. */
static const struct {
    const char *name, *cell;
} names[] = {
    {"]]>", "]]>"},
    {"=1+2", "'=1+2"},
    {"'=1+2", "''=1+2"},
    {"@sum", "'@sum"},
    {"+a", "'+a"},
    {"-b", "'-b"},
    {" =c", "' =c"},
    {"\uFF1Dd", "'\uFF1Dd"},
    {"-1.5", "-1.5"},
    {"+2e3", "+2e3"},
    {"it's", "it's"},
    {"\ttab", "\\x09tab"},
    {"\rreturn", "\\x0dreturn"},
    {"red\x1b[31m", "red\\x1b[31m"},
    {"red\\x1b[31m", "red\\\\x1b[31m"},
    {"red\x1b[32m", "red\\x1b[32m"},
    {"bell\x07", "bell\\x07"},
    {"line\nfeed\f\v", "line\\x0afeed\\x0c\\x0b"},
    {"gnp.\u202Efdp", "gnp.\\u202efdp"},
    {"gnp.\u202Dfdp", "gnp.\\u202dfdp"},
    {"zero\u200Bwidth", "zero\\u200bwidth"},
    {"zerowidth", "zerowidth"},
    {"\uFEFFmark", "\\ufeffmark"},
    {"tag\U000E0041", "tag\\U000e0041"},
    {"\xC2\x9B"
     "2J",
     "\\u009b2J"},
    {"\x7F"
     "delete",
     "\\x7fdelete"},
    {"latin\xFF", "latin\\xff"},
    {"latin\xFE", "latin\\xfe"},
    {"\\\x1b", "\\\\\\x1b"},
    {"double\"quote", "double\"quote"},
    {"back\\slash", "back\\slash"},
    {"$(touch PWNED)", "$(touch PWNED)"},
    {"`touch PWNED`", "`touch PWNED`"},
    {"; touch PWNED #", "; touch PWNED #"},
    {"<script>alert(1)<!--", "<script>alert(1)<!--"},
    {"<:title><:svg><:table>", "<:title><:svg><:table>"},
    {"a|b", "a|b"},
    {"{{body}} {{title}}", "{{body}} {{title}}"},
    {"100%d%s%n", "100%d%s%n"},
    {"@{^a}_{b}~c", "'@{^a}_{b}~c"},
    {"  blanks  ", "  blanks  "},
    {"=cmd,x;y\ttab", "'=cmd,x;y\\x09tab"},
    {"&amp;&lt;b&gt;", "&amp;&lt;b&gt;"},
    {"x](javascript:alert(1)) ![i](http:::a.b:c) <http:::a.b>",
     "x](javascript:alert(1)) ![i](http:::a.b:c) <http:::a.b>"},
    {"# **bold** _it_ ~~no~~ `code` [1]: x", "# **bold** _it_ ~~no~~ `code` [1]: x"},
    {"![a](figures:answer.svg)", "![a](figures:answer.svg)"},
    {"grün µ€ 粗さ", "grün µ€ 粗さ"},
};
enum { NAMES = sizeof names / sizeof *names };

static void XMLCALL count_element(void *user, const XML_Char *name, const XML_Char **attributes)
{
    (void)name, (void)attributes;
    ++*(size_t *)user;
}

static void assert_xml(const char *text, size_t length, const char *where)
{
    size_t elements = 0;
    XML_Parser parser = XML_ParserCreate(NULL);
    assert_non_null(parser);
    XML_SetUserData(parser, &elements);
    XML_SetElementHandler(parser, count_element, NULL);
    if (XML_Parse(parser, text, (int)length, XML_TRUE) != XML_STATUS_OK)
        fail_msg("%s:%lu: %s", where, (unsigned long)XML_GetCurrentLineNumber(parser),
                 XML_ErrorString(XML_GetErrorCode(parser)));
    XML_ParserFree(parser);
    assert_true(elements > 5);
}

/* The next cell of a CSV row as RFC 4180 has it, unquoted into `cell`; *at moves behind it. Returns what ended it. */
static char next_cell(const char **at, char *cell, size_t size)
{
    size_t used = 0;
    bool quoted = **at == '"';
    const char *s = *at + quoted;
    for (; *s && (quoted || (*s != ',' && *s != '\n')); s++) {
        if (quoted && *s == '"' && s[1] != '"')
            break;
        s += quoted && *s == '"';
        assert_true(quoted || *s != '"');
        assert_true(used + 1 < size);
        cell[used++] = *s;
    }
    s += quoted;
    cell[used] = '\0';
    assert_true(*s == ',' || *s == '\n' || *s == '\0');
    *at = s + (*s != '\0');
    return *s;
}

/* No cell is one that a spreadsheet would calculate; every row has as many as the first. */
static void assert_csv(const char *text, const char *where)
{
    size_t columns = 0, cells = 0, rows = 0;
    char cell[8192];
    while (*text) {
        char end = next_cell(&text, cell, sizeof cell), *rest;
        cells++;
        (void)strtod(cell, &rest);
        if (strchr("=+-@\t\r", cell[0]) && cell[0] && *rest)
            fail_msg("%s: cell '%s' is a formula", where, cell);
        if (end == ',')
            continue;
        columns = rows == 0 ? cells : columns;
        if (cells != columns)
            fail_msg("%s: row %zu has %zu cells, not %zu", where, rows + 1, cells, columns);
        rows++;
        cells = 0;
    }
    assert_true(rows > 0);
}

static bool ends_with(const char *string, const char *end)
{
    size_t length = strlen(string), after = strlen(end);
    return length >= after && strcmp(string + length - after, end) == 0;
}

/** Is `name` of the page's own tags, and none that could do something? */
static bool tag_allowed(const char *name, size_t length)
{
    static const char allowed[] =
        " !doctype html head meta title style body main nav header footer details summary h1 h2 h3 h4 p ul ol li a b i "
        "em "
        "strong code pre br hr div span table thead tbody tr th td figure figcaption sup sub label input script img ";
    return strcasestr(allowed, filled(" %.*s ", (int)length, name));
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
    assert_true(rows > 2);
}

/* Every file below `path`; returns how many SVG there are. */
static size_t assert_files(const char *place, const char *path)
{
    struct dirent *entry;
    size_t drawings = 0;
    DIR *directory = opendir(filled("%s/%s", place, path));
    assert_non_null(directory);
    while ((entry = readdir(directory))) {
        const char *name = lasting("%s/%s", path, entry->d_name);
        struct stat info;
        if (entry->d_name[0] == '.')
            continue;
        assert_int_equal(lstat(filled("%s/%s", place, name), &info), 0);
        if (S_ISDIR(info.st_mode)) {
            drawings += assert_files(place, name);
            continue;
        }
        if (ends_with(name, ".png"))
            continue;
        char *text = workspace_read(place, name);
        size_t length = strlen(text);
        assert_int_equal(length, info.st_size); /* no NUL */
        process_expect_clean(text, length, name, !ends_with(name, ".csv") && !ends_with(name, ".json"));
        if (ends_with(name, ".svg")) {
            assert_xml(text, length, name);
            expect_no_parts(text, "<script");
            drawings++;
        }
        if (ends_with(name, ".csv") && strstr(name, "/data/"))
            assert_csv(text, name);
        if (ends_with(name, ".html"))
            scan_tags(text);
        if (ends_with(name, "report.md"))
            assert_tables_whole(text);
    }
    closedir(directory);
    return drawings;
}

static void write_scans(const char *place)
{
    for (unsigned i = 0; i < NAMES; i++)
        workspace_scan(place, filled("d/%s.csv", names[i].name), 100, i + 1);
}

static void assert_process(struct process process, const char *what)
{
    process_expect_clean(process.out, process.out_length, filled("stdout of %s", what), false);
    process_expect_clean(process.err, strlen(process.err), filled("stderr of %s", what), false);
}

TEST_IN_WORKSPACE(test_report)
{
    write_scans(place);
    workspace_write(
        place, "d/scene.yaml",
        "title: \"a \\u202E b ]]> \\u009b\"\nmaterial: {name: \"=x\\u200b\", E: 40 GPa, nu: 0.3, Sy: 14 MPa}\n"
        "effects: [plasticity, separation, uncertainty]\n");
    assert_process(expect_exit(place, 0, "report", "d", "--show"), "report");
    assert_true(assert_files(place, "out/d") > 5);

    /* every name once in the tables, as written above, and the same in results.json */
    char *csv = workspace_read(place, "out/d/data/surfaces.csv");
    json_t *json = workspace_json(place, "out/d/results.json"), *surfaces = json_object_get(json, "surfaces");
    assert_int_equal(json_array_size(surfaces), NAMES);
    size_t found[NAMES] = {0}, in_json[NAMES] = {0}, rows = 0;
    const char *at = csv;
    char cell[512];
    for (char end = ','; *at; rows++, end = ',') {
        for (size_t column = 0; end == ','; column++) {
            end = next_cell(&at, cell, sizeof cell);
            for (size_t i = 0; i < NAMES && column == 0; i++)
                found[i] += strcmp(cell, names[i].cell) == 0;
        }
    }
    assert_int_equal(rows, NAMES + 1);
    size_t astray = 0;
    for (size_t k = 0; k < NAMES; k++) {
        const char *name = json_text_at(surfaces, filled("%zu.surface", k));
        for (size_t i = 0; i < NAMES; i++) /* without what guards a formula */
            in_json[i] += strcmp(name, names[i].cell + (names[i].cell[0] == '\'')) == 0;
    }
    for (size_t i = 0; i < NAMES; i++)
        if (found[i] != 1 || in_json[i] != 1) {
            print_error("'%s': %zu times in surfaces.csv, %zu in results.json\n", names[i].cell, found[i], in_json[i]);
            astray++;
        }
    hard_case("files named with control characters, bytes that are no UTF-8, characters of no width, formulas (=1+2)",
              "two names that look alike, cells that calculate, a terminal that is rewritten",
              "each name is shown by what it holds, once in every table", "names that are not once there",
              (double)astray, 0);
    hard_case("names that are commands of a shell, of gnuplot or of HTML", "they run",
              "they are text in charts, tables and pages", "files that such a command makes",
              (double)workspace_count(place, "PWNED"), 0);

    expect_in_file(place, "out/d/report.html", "red\\x1b[31m", "gnp.\\u202efdp", "&#60;script&#62;alert(1)&#60;!--",
                   "{{body}} {{title}}", "&#38;amp;&#38;lt;b&#38;gt;");
    expect_in_file(place, "out/d/data/surfaces.csv", "\n\"double\"\"quote\",\"double\"\"quote.csv\",100,",
                   "\n\"'=cmd,x;y\\x09tab\",", "\na|b,a|b.csv,100,");
}

TEST_IN_WORKSPACE(test_commands)
{
    write_scans(place);
    workspace_write(place, "d/notes \x1b\u202E.md", "text\n");
    workspace_write(place, "bad \x1b\xFF\u202E.csv", "x [um],z [um]\n0,1\n1,2\n2,\xC2\x9B\u202E\x07\n");
    workspace_write(place, "unit.csv", "x [\u202E],z [\x1b]\n0,1\n1,2\n2,3\n3,1\n");
    assert_process(expect_exit(place, 0, "plan", "d"), "plan");
    assert_process(expect_exit(place, 0, "inspect", "d", "--chart"), "inspect --chart");
    assert_process(expect_exit(place, 0, "inspect", "d", "--json"), "inspect --json");
    assert_process(expect_exit(place, 4, "inspect", "bad \x1b\xFF\u202E.csv", "unit.csv", "no \x9B\u202E"), "inspect");
    assert_process(expect_exit(place, 4, "inspect", "--json", "bad \x1b\xFF\u202E.csv", "unit.csv"), "inspect --json");
    static const char *const scenes[] = {"\"\\u202E\\u009b\": 1\n",
                                         "material: \"\\u202E\\u009b\"\n",
                                         "effects: [\"\\u202E\\u009b\"]\n",
                                         "surfaces: [{file: \"\\u202E\\u009b\"}]\n",
                                         "\xC2\x9B: [\n",
                                         "a: \xFF\n"};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        workspace_write(place, "d/scene.yaml", scenes[i]);
        assert_process(expect_exit(place, 3, "plan", "d"), scenes[i]);
    }
    workspace_write(place, "d/scene.yaml", "title: x\n");
    assert_process(expect_exit(place, 2, "plan", "d", "-e", "\x1b\u202E\xFF"), "plan -e");
    assert_process(expect_exit(place, 2, "plan", "d", "-m", "\x1b\u202E\xFF"), "plan -m");
    static const char *const options[] = {"-\x1b", "--\x1b]0;x\a", "--load=\x1b\u202E\xFF", "--no-cost=\n", "-o\x1b"};
    for (size_t i = 0; i < sizeof options / sizeof *options; i++)
        assert_process(expect_exit(place, 2, "report", "d", options[i]), options[i]);
    assert_process(expect_exit(place, 4, "inspect", "--", "-\x1b"), "inspect --");
    workspace_scan(place, "-o", 100, 1);
    struct process dashed = process_run(place, "inspect", "--", "-o");
    hard_case("a scan named -o", "it is taken for an option", "read as a file behind --", "exit status", dashed.status,
              0);
    assert_process(dashed, "inspect -- -o");
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
    assert_true(assert_files(place, "out/d") > 4);
    expect_in_file(place, "out/d/report.html", "<title>&lt;/title&gt;&lt;script&gt;alert('t')",
                   "&#60;img src=x onerror=alert(1)&#62;");
    expect_not_in_file(place, "out/d/report.html", "href=\"javascript");
    assert_int_equal(workspace_count(place, "PWNED"), 0);
    char *page = workspace_read(place, "out/d/report.html");
    hard_case("a title that closes its tag, opens a script and quotes a template's {{body}}", "a page that runs it",
              "text, as it was written", "scripts of it in the page", strstr(page, "<script>alert") != NULL, 0);
    workspace_write(place, "d/scene.yaml", "surfaces:\n  - {name: \"one\\n# two\", file: a.csv}\n");
    expect_failure(place, 3, 1, "d/scene.yaml:2: 'name' has a line end or control character inside; remove it",
                   "report", "d");
    workspace_write(place, "d/scene.yaml", "title: \"two\\nlines\"\n");
    expect_failure(place, 3, 1, "d/scene.yaml:1: 'title' has a line end", "report", "d");
}

/** Refusals quote hostile names and contents; of two surfaces every legend names both. */
TEST_IN_WORKSPACE(test_refusals)
{
    workspace_scan(place, "d/]]>.csv", 100, 1);
    workspace_scan(place, "d/=]]>\x1b\u202E&<.csv", 100, 2);
    workspace_write(place, "d/bad \x1b[31m\n<b>|\xff.csv", "x [um],z [um]\n0,1\n1,2\n2,<script>\x1b]0;\x07\n");
    struct process process = expect_exit(place, 1, "report", "d", "--no-cost", "-m", "tin", "-e", "plasticity");
    expect_part(process.err, "surface 'bad \\x1b[31m\\x0a<b>|\\xff' refused: ");
    assert_process(process, "report");
    assert_true(assert_files(place, "out/d") > 4);
    expect_in_file(place, "out/d/report.html", "bad \\x1b[31m\\x0a&#60;b&#62;|\\xff");
    expect_in_file(place, "out/d/figures/surfaces.svg", "]]\u203A", "\\x1b\\u202e&amp;&lt;");
}

/* A surface whose material says too little is named where an effect is left out. */
TEST_IN_WORKSPACE(test_reasons)
{
    workspace_scans(place, "d", 2, 100, 1);
    workspace_write(place, "d/scene.yaml",
                    "material: tin\n"
                    "surfaces:\n"
                    "  - {name: \"lack|<b>\\u202E\", file: a.csv, material: {E: 40 GPa, nu: 0.3}}\n"
                    "  - {name: two, file: b.csv}\n");
    struct process process = expect_exit(place, 0, "plan", "d");
    expect_part(process.out, "of surface 'lack|<b>\\u202e' has no");
    assert_process(process, "plan");
    assert_process(expect_exit(place, 0, "report", "d", "--no-cost"), "report");
    (void)assert_files(place, "out/d");
    expect_in_file(place, "out/d/report.md", "of surface 'lack\\|&#60;b&#62;\\\\u202e' has no");
    expect_in_file(place, "out/d/results.json", "of surface 'lack|<b>\\\\u202e' has no");
}
