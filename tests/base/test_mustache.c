/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mustache: the public specification's cases where they are there, and cases of our own. */
#include "base/mustache.h"
#include "directory.h"
#include "hard_case.h"

HARD_CASES("Templates")

static void escape_html(struct text *out, const char *string)
{
    text_add_html(out, string, strlen(string));
}

static const char *from_object(void *context, const char *name)
{
    return json_string_value(json_object_get(context, name));
}

static void check_case(const char *file, const json_t *test)
{
    struct mustache how = {json_object_get(test, "data"), escape_html, from_object, json_object_get(test, "partials")};
    struct text *out = support_text();
    struct status status = {0};
    const char *source = json_string_value(json_object_get(test, "template"));
    const char *expected = json_string_value(json_object_get(test, "expected"));
    enum status_code rc = mustache_render(out, source, file, &how, &status);
    if (rc != STATUS_OK || strcmp(text_string(out), expected) != 0)
        fail_msg("%s, '%s': '%s' %s", file, json_string_value(json_object_get(test, "name")), text_string(out),
                 status.message);
}

TEST_CASE(the_specification_holds)
{
    static const char *const files[] = {"comments", "delimiters", "interpolation", "inverted", "partials", "sections"};
    for (size_t f = 0; f < sizeof files / sizeof *files; f++) {
        const char *name = filled("../shared/golden/mustache/%s.json", files[f]);
        json_t *test;
        size_t i;
        if (!directory_has(PROJECT_SOURCE, name))
            skip();
        json_array_foreach (json_object_get(directory_json(PROJECT_SOURCE, name), "tests"), i, test)
            check_case(files[f], test);
        assert_true(i > 0);
    }
}

/* Template, data, partial p, what comes out (NULL: an error that holds the words behind it). */
static const struct {
    const char *source, *data, *partial, *expected, *error;
} own_cases[] = {
    {"a {{x}} b", "{\"x\": 1.5}", "", "a 1.5 b", ""},
    {"{{x}} {{{x}}} {{&x}}", "{\"x\": \"<&\"}", "", "&lt;&amp; <& <&", ""},
    {"{{#x}}[{{.}}]{{/x}}", "{\"x\": [1, 2]}", "", "[1][2]", ""},
    {"{{#x}}{{.}}{{#more}}, {{/more}}{{/x}}{{^more}}.{{/more}}", "{\"x\": [\"a\", \"b\"]}", "", "a, b.", ""},
    {"{{#x}}{{#first}}[{{/first}}{{#y}}{{.}}{{^last}}-{{/last}}{{/y}}{{#last}}]{{/last}}{{/x}}",
     "{\"x\": [{\"y\": [1, 2]}, {\"y\": [3]}]}", "", "[1-23]", ""},
    {"{{#x}}{{more}}{{/x}}", "{\"x\": [{}], \"more\": 7}", "", "7", ""},
    {"{{^x}}none{{/x}}", "{\"x\": \"\"}", "", "none", ""},
    {"{{#x}}\n  {{y.z}}\n{{/x}}\nend", "{\"x\": true, \"y\": {\"z\": 3}}", "", "  3\nend", ""},
    {"{{#a}}{{#b}}{{c}}{{/b}}{{/a}}", "{\"a\": {\"c\": \"outer\"}, \"b\": [{}, {\"c\": \"own\"}]}", "", "outerown", ""},
    {"  {{>p}}\nend", "{\"x\": 1}", "one {{x}}\ntwo\n", "  one 1\n  two\nend", ""},
    {"{{=<% %>=}}<%x%> {{x}}", "{\"x\": 7}", "", "7 {{x}}", ""},
    /* closing delimiters that begin with a sign: what stands right behind the opening one is the tag's own */
    {"{{=[ &]=}}[x &][& x &][x&]", "{\"x\": \"<\"}", "", "&lt;<&lt;", ""},
    {"{{=[ #]=}}[# x #]in[/x#][y#]", "{\"x\": [1, 2]}", "", "inin", ""},
    {"{{=[ &]=}}[&]", "{}", "", NULL, "not closed: '[&]'"},
    {"{{=[ !]=}}[!]a[!]b", "{}", "", "b", ""},
    {"one\n{{#x}} two\nthree", "{}", "", NULL, "line 2: section that does not end: 'x'"},
    {"one\ntwo {{/x}}", "{}", "", NULL, "line 2"},
    {"one\ntwo {{/\nx}}", "{}", "", NULL, "line 2"},
    {"one {{x", "{}", "", NULL, "not closed"},
    {"{{#x}}{{/y}}", "{}", "", NULL, "not open"},
    {"{{#x}}{{/y\nz}}", "{}", "", NULL, "not open: 'y'"}, /* messages are one line */
    {"{{=x=}}", "{}", "", NULL, "delimiters"},
    {"{{>p}}", "{}", "{{>p}}", NULL, "without end"},
    /* numbers in their unit: one, two ends, one with its error, as printf has it, none */
    {"{{x|3}} {{x|2 um}} {{x|3 %}}", "{\"x\": 1.234e-5}", "", "1.23·10⁻⁵ 12 0.00123", ""},
    {"{{t|3 degC}} {{n|2}} {{n}}", "{\"t\": 300, \"n\": 12345}", "", "26.9 12000 12345", ""},
    {"{{#x}}{{x|2 mm}}{{/x}}", "{\"x\": {\"least\": 0.001, \"most\": 0.0123}}", "", "1.0 to 12", ""},
    {"{{x|3}}", "{\"x\": {\"value\": 1.5, \"error\": 0.012}}", "", "1.500 ± 0.012", ""},
    {"{{x|3}}", "{\"x\": {\"value\": 1.5, \"error\": null}}", "", "1.50", ""},
    {"{{x|4g kPa}}", "{\"x\": 17272727}", "", "1.727e+04", ""},
    {"[{{x|3}}{{y|3}}{{z|3}}]", "{\"x\": null, \"y\": \"so\"}", "", "[so]", ""},
    {"{{x|um}}", "{\"x\": 1}", "", NULL, "no digits and unit"},
    {"{{x|3 cubits}}", "{\"x\": 1}", "", NULL, "x|3 cubits"},
};

/* A folder's files are parts of a template if they are text and lie in it. */
TEST_IN_DIRECTORY(parts_come_from_the_folder)
{
    static const struct {
        const char *name, *part, *error;
    } cases[] = {
        {"plain", "as \u00b5 it is", NULL},
        {"in/deep", "deep", NULL},
        {"in/a..b", "dots", NULL},
        {"nul", NULL, "nul.md: no text in UTF-8"},
        {"latin", NULL, "latin.md: no text in UTF-8"},
        {"../up", NULL, "'../up' is no name"},
        {"in/../../up", NULL, "'in/../../up' is no name"},
        {"none", NULL, "No such file"},
    };
    directory_write(place, "here/plain.md", "as \u00b5 it is");
    directory_write(place, "here/in/deep.md", "deep");
    directory_write(place, "here/in/a..b.md", "dots");
    directory_write(place, "here/latin.md", "\xb5m");
    directory_write(place, "up.md", "secret");
    expect_ok(text_write_file, directory_path(place, "here/nul.md"), "a\0b", 3);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct status status = {0};
        OWNED(mustache_folder_free)
        struct mustache_folder folder = {directory_path(place, "here"), ".md", NULL, &status};
        const char *part = mustache_folder_partial(&folder, cases[i].name);
        if (cases[i].part)
            assert_string_equal(part, cases[i].part);
        else {
            assert_null(part);
            assert_non_null(strstr(status.message, cases[i].error));
        }
    }
}

TEST_CASE(own_cases_hold)
{
    for (size_t i = 0; i < sizeof own_cases / sizeof *own_cases; i++) {
        json_t *data = support_json(own_cases[i].data);
        json_auto_t *partials = json_pack("{s:s}", "p", own_cases[i].partial);
        struct mustache how = {data, escape_html, from_object, partials};
        struct text *out = support_text();
        struct status status = {0};
        enum status_code rc = mustache_render(out, own_cases[i].source, "own", &how, &status);
        if (own_cases[i].expected && strncmp(own_cases[i].source, "{{=", 3) == 0)
            hard_case("a template whose delimiters begin or end with a sign of its own: [ &], [ #], [ !]",
                      "a tag that has swallowed its end is taken for another",
                      "what stands right behind the opening one is the tag's own", "other texts than expected",
                      strcmp(text_string(out), own_cases[i].expected) != 0, 0);
        if (strcmp(own_cases[i].source, "{{>p}}") == 0)
            hard_case("a partial that holds itself", "recursion without end", "an error: without end", "pages",
                      rc == STATUS_OK, 0);
        if (own_cases[i].expected) {
            assert_int_equal(rc, STATUS_OK);
            assert_string_equal(text_string(out), own_cases[i].expected);
        } else {
            assert_int_equal(rc, STATUS_USAGE);
            assert_non_null(strstr(status.message, own_cases[i].error));
        }
    }
}
